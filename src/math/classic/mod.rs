//! Numbers and vectors of the classic numerics, in 64 or 32 bits.

mod scalar;
mod vector;

pub use scalar::Scalar;
pub use vector::Vector;
