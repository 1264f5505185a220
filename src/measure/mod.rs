//! Answers about scenes and pictures.

mod check;
mod coincident;
mod explain;
mod transcript;

pub use check::check;
pub use explain::{
    EffectRow, Explanation, LightRow, NoShadow, SurfaceRow, TextureRow, Thing, Work, explain,
};
pub use transcript::{PixelStory, Step, transcript};
