//! Answers about scenes and pictures.

mod change;
mod check;
mod clock;
mod coincident;
mod explain;
mod light_row;
mod light_tests;
mod price_list;
mod prices;
mod transcript;
mod without;

pub use change::Change;
pub use check::check;
pub use clock::Timing;
pub use explain::{EffectRow, Explanation, SurfaceRow, TextureRow, Thing, Work, explain};
pub use light_row::{LightRow, NoShadow};
pub use light_tests::LightTests;
pub use prices::{Effort, Price, Prices, prices};
pub use transcript::{PixelStory, Step, transcript};
pub use without::{round_trip, without};
