//! Answers about scenes and pictures.

mod aliases;
mod appearance;
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
mod scene_item;
mod similarity;
mod text;
mod transcript;
mod without;

pub use appearance::Appearance;
pub use check::check;
pub use clock::Timing;
pub use cost::{
    Best, Breakdown, Cost, CostOptions, Feature, FeatureShare, Law, Limit, Measurement, OwnError,
    Reference, Step, SurfaceShare, Sweep, Trade, Uncertainty, Variation, cost, exponent,
};
pub use deviation::{Change, Deviation};
pub use explain::effects_of;
pub(crate) use explain::{EffectRow, Explanation, explain};
pub(crate) use light_row::{LightRow, NoShadow};
pub(crate) use light_tests::LightTests;
pub use plot::{Curve, Figure, Panel, Scale};
pub use prices::{Effort, Price, Prices, prices};
pub(crate) use scene_item::SceneItem;
pub use similarity::similarity;
pub(crate) use transcript::{HitReport, LightReport, PixelReport, RayReport, transcript};
pub use without::{round_trip, without};
