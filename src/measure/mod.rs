//! Answers about scenes and pictures.

mod change;
mod check;
mod clock;
mod price_list;
mod prices;
mod without;

pub use change::Change;
pub use check::check;
pub use clock::Timing;
pub use prices::{Price, Prices, Work, prices};
pub use without::{round_trip, without};
