//! Numbers without rounding: for the few decisions that doubles cannot take, and for loading.

mod decimal;
mod distance;
mod number;
mod rational;
mod vector;

pub use decimal::decimal;
pub use distance::Distance;
pub use number::{Exact, Sign};
pub use rational::RationalVector;
pub use vector::ExactVector;
