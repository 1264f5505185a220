//! Texture filters.

use crate::language::words;

/// The filter from the texels in a pixel's footprint to one colour.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Hash)]
pub enum Filter {
    /// The texel at the hit point, as in the chapter.
    #[default]
    Nearest,
    /// Interpolation between the four nearest texel centres.
    Bilinear,
    /// Trilinear interpolation in a mip pyramid.
    ///
    /// Source: Williams 1983, "Pyramidal Parametrics".
    Mipmap,
    /// The mean of mipmap lookups along the longer axis of the footprint.
    Anisotropic,
    /// The mean over the area of the footprint.
    Exact,
}

words!(Filter {
    Nearest: "nearest",
    Bilinear: "bilinear",
    Mipmap: "mipmap",
    Anisotropic: "anisotropic",
    Exact: "exact",
});
