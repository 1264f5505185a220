//! The patterns in which rays go through pixels.

use crate::language::words;

/// How the rays through a pixel are spread over it.
///
/// Where the border of a thing crosses a pixel, the error of `N` rays falls as `N^-0.5` if they are
/// drawn at random, and as `N^-0.75` if they are spread evenly (Mitchell 1996, "Consequences of
/// stratified sampling in graphics").
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Pattern {
    /// One ray, through the centre.
    Center,
    /// Through the centre of each of as many cells as there are rays.
    Grid,
    /// Through a place drawn in each of the cells.
    #[default]
    Stratified,
    /// A Sobol sequence, scrambled for each pixel (Owen 1995): of any power of two of its places
    /// one lies in each cell, however the pixel is cut into as many equal ones.
    Sobol,
    /// Anywhere; for comparison.
    Random,
}

words!(Pattern {
    Center: "center",
    Grid: "grid",
    Stratified: "stratified",
    Sobol: "sobol",
    Random: "random",
});
