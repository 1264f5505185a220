//! How the texels that a pixel covers become one colour.

use crate::language::words;

/// What is seen of a texture in a pixel.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Hash)]
pub enum Filter {
    /// The texel that the ray meets: the chapter's.
    #[default]
    Nearest,
    /// Between the four texels whose middles are nearest.
    Bilinear,
    /// As large as what the pixel covers, from a pyramid of smaller images (Williams 1983, "Pyramidal
    /// Parametrics").
    Mipmap,
    /// Several such colours along the longer axis of what the pixel covers.
    Anisotropic,
    /// The mean over the area that the pixel covers.
    Exact,
}

words!(Filter {
    Nearest: "nearest",
    Bilinear: "bilinear",
    Mipmap: "mipmap",
    Anisotropic: "anisotropic",
    Exact: "exact",
});
