//! Answers about scenes and pictures.

mod appearance;
mod change;
mod check;
mod clock;
mod coincident;
mod cost;
mod deviation;
mod explain;
mod kernel;
mod lab;
mod light_row;
mod light_tests;
mod plot;
mod price_list;
mod prices;
mod similarity;
mod transcript;
mod without;

pub use appearance::Appearance;
pub use change::Change;
pub use check::check;
pub use clock::Timing;
pub use cost::{
    Best, Blame, Cost, DIALS, Dial, Doubt, Ladder, Law, Limit, Measured, Metric, Pictures,
    Reference, Rung, Spot, SpotShare, SurfaceShare, Trade, Variation, cost, effects_of, exponent,
};
pub use deviation::Deviation;
pub use explain::{EffectRow, Explanation, SurfaceRow, TextureRow, Thing, Work, explain};
pub use light_row::{LightRow, NoShadow};
pub use light_tests::LightTests;
pub use plot::{Curve, Figure, Panel, Scale};
pub use prices::{Effort, Price, Prices, prices};
pub use similarity::similarity;
pub use transcript::{LightStep, Met, PixelStory, Step, transcript};
pub use without::{round_trip, without};
