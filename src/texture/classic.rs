//! The chapter's way from a place on a surface to a texel.

use super::{Texels, Texture, TextureMap, Wrap};
use crate::math::Rgb;
use crate::math::classic::Scalar;

/// The chapter's `texture_map`: the colour at an offset from the lower-left corner.
///
/// CLAMP divides the offset by the size of the whole image and leaves the rest to `gettexel`.
/// REPEAT divides it by the size of a texel, drops the fraction, and takes the remainder by the
/// number of texels with C's `%`, which keeps the sign.
///
/// From there the chapter goes back to relative places and through `gettexel`, for which a whole
/// number of texels is one row higher than the one that is meant, and the lowest row appears twice.
/// That would be another picture rather than a less accurate one, and the chapter's own pictures do
/// not show it; so the remainder is the texel's number.
#[must_use]
pub fn texture_map<T: Scalar>(map: &TextureMap, lasthit: [T; 2]) -> Rgb {
    let x = lasthit[0] / T::of(map.size.x);
    let y = lasthit[1] / T::of(map.size.y);
    match map.wrap {
        Wrap::Clamp => gettexel(&map.texture, x, y),
        Wrap::Repeat => {
            let [xdim, ydim] = dimensions(&map.texture);
            let (xloc, yloc) = (x.int() % xdim, y.int() % ydim);
            in_memory(&map.texture, xloc, ydim - 1 - yloc)
        }
    }
}

/// The chapter's `gettexel`: the colour at a relative place.
///
/// As in the chapter, only the row below the lowest one is pulled back into the image.
#[must_use]
pub fn gettexel<T: Scalar>(texture: &Texture, xrel: T, yrel: T) -> Rgb {
    let [xdim, ydim] = dimensions(texture);
    let xloc = (xrel * T::of(f64::from(xdim))).int();
    let mut yloc = ((T::one() - yrel) * T::of(f64::from(ydim))).int();
    if yloc == ydim {
        yloc = ydim - 1;
    }
    in_memory(texture, xloc, yloc)
}

/// What a C program finds at `imagebuf + xdim * yloc + xloc`.
///
/// A column too far to the right is the first texel of the next row, one too far to the left the
/// last texel of the row above. Where there is nothing of the image in memory, before its first
/// texel or behind its last, this is the first or the last.
fn in_memory(texture: &Texture, xloc: i32, yloc: i32) -> Rgb {
    let [xdim, _] = dimensions(texture);
    let place = i64::from(xdim) * i64::from(yloc) + i64::from(xloc);
    let last = texture.texels.channels.len() - 1;
    let place = usize::try_from(place).unwrap_or(0).min(last);
    let width = texture.texels.width;
    texture.texel(place % width, place / width)
}

/// The chapter's `getdim`; images are far smaller than an `int` can count.
fn dimensions(texture: &Texture) -> [i32; 2] {
    let Texels { width, height, .. } = texture.texels;
    [width, height].map(|side| i32::try_from(side).unwrap_or(i32::MAX))
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use glam::DVec2;

    use super::*;

    /// Red numbers the columns from the left, green the rows from the top.
    fn numbered(width: usize, height: usize) -> Arc<Texture> {
        let number = |index: usize| u16::try_from(index).expect("small");
        let channels = (0..width * height)
            .map(|index| [number(index % width), number(index / width), 0])
            .collect();
        let texels = Texels {
            width,
            height,
            channels,
            deep: true,
        };
        let path = "n.png".into();
        Arc::new(Texture::new("numbered", "n.png", path, texels, 255.0))
    }

    fn numbers(color: Rgb) -> (f64, f64) {
        let color = color * 65_535.0;
        (color.r.round(), color.g.round())
    }

    fn relative(side: usize, xrel: f64, yrel: f64) -> (f64, f64) {
        numbers(gettexel(&numbered(side, side), xrel, yrel))
    }

    fn repeated(side: usize, texel: f64, x: f64, y: f64) -> (f64, f64) {
        let map = TextureMap::repeat(numbered(side, side), DVec2::splat(texel));
        numbers(texture_map(&map, [x, y]))
    }

    #[test]
    fn an_image_stands_upright() {
        assert_eq!(relative(4, 0.1, 0.1), (0.0, 3.0));
        assert_eq!(relative(4, 0.9, 0.6), (3.0, 1.0));
        assert_eq!(repeated(4, 0.5, 0.1, 0.6), (0.0, 2.0));
        assert_eq!(repeated(4, 0.5, 4.1, 2.6), (0.0, 2.0));
    }

    /// D1 and B1: the right border is the first texel of the next row; behind the last row there is
    /// nothing, and the last texel is taken.
    #[test]
    fn the_right_border_is_the_next_row() {
        assert_eq!(relative(4, 1.0, 0.9), (0.0, 1.0));
        assert_eq!(relative(4, 1.0, 0.1), (3.0, 3.0));
        let map = TextureMap::clamp(numbered(4, 4), DVec2::ONE);
        assert_eq!(numbers(map.at(DVec2::new(1.0, 0.9))), (3.0, 0.0));
    }

    /// D2: the lower border is pulled back.
    #[test]
    fn the_lower_border_is_the_lowest_row() {
        assert_eq!(relative(4, 0.5, 0.0), (2.0, 3.0));
    }

    /// D3: 0.3 / 0.1 is less than 3.
    #[test]
    fn a_whole_texel_may_be_rounded_down() {
        assert_eq!(repeated(10, 0.1, 0.3, 0.0), (2.0, 9.0));
    }

    /// D4: (1 − 0.9) · 10 is less than 1.
    #[test]
    fn a_row_may_be_rounded_up_the_image() {
        assert_eq!(relative(10, 0.0, 0.9), (0.0, 0.0));
    }

    /// D5 and D6: to the left of zero the first texel is twice as wide, and then comes what lies
    /// before the row in memory.
    #[test]
    fn below_zero_the_remainder_is_negative() {
        assert_eq!(repeated(4, 1.0, -0.3, 1.5), (0.0, 2.0));
        assert_eq!(repeated(4, 1.0, -5.0, 1.5), (3.0, 1.0));
        assert_eq!(repeated(4, 1.0, -5.0, 3.5), (0.0, 0.0));
    }

    /// D8: beyond what an `int` can count there is one texel only.
    #[test]
    fn far_away_there_is_one_texel() {
        assert_eq!(repeated(4, 0.01, 1e15, 0.0), (3.0, 3.0));
        assert_eq!(repeated(4, 0.01, 2e15, 0.0), (3.0, 3.0));
        assert_eq!(repeated(4, 0.01, f64::NAN, 0.0), (0.0, 3.0));
    }

    /// In 32 bits a texture 10⁵ units away from its corner has some 100 places to a unit.
    #[test]
    fn narrow_numbers_run_out_of_places() {
        let map = TextureMap::repeat(numbered(10, 10), DVec2::splat(0.001));
        let at = |x: f64| numbers(texture_map(&map, [f32::of(x), 0.0]));
        assert_eq!(at(100_000.0), at(100_000.003));
    }
}
