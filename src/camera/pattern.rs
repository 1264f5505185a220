//! Sample patterns.

use crate::language::words;

/// The distribution of the rays of a pixel.
///
/// On a border that crosses a pixel, the error of `N` rays falls as `N^-0.5` for random rays, and as
/// `N^-0.75` for stratified ones (Mitchell 1996, "Consequences of stratified sampling in
/// graphics").
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Pattern {
    /// One ray through the centre.
    Center,
    /// A ray through the centre of each cell of a grid.
    Grid,
    /// A ray through a random position in each cell of a grid.
    #[default]
    Stratified,
    /// A Sobol sequence with Owen scrambling for each pixel (Owen 1995).
    ///
    /// A power of two of its positions has one in each cell of every grid of as many equal cells.
    Sobol,
    /// Rays through random positions, for comparison.
    Random,
}

words!(Pattern {
    Center: "center",
    Grid: "grid",
    Stratified: "stratified",
    Sobol: "sobol",
    Random: "random",
});
