//! Numbers without rounding, for loading and for close decisions.

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
