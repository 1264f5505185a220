//! The chapter's way from a place on a surface to a texel.

use super::Scalar;
use crate::math::Rgb;
use crate::texture::{Texture, TextureMap, Wrap};

/// The chapter's `texture_map`: the colour at an offset from the lower-left corner.
///
/// CLAMP divides the offset by the size of the whole image. REPEAT divides it by the size of a
/// texel, drops the fraction and takes the remainder by the size of the image; `gettexel` then gets
/// whole texels, for which `(1 − y) ydim` is one row above the one that is meant.
pub(super) fn texture_map<T: Scalar>(map: &TextureMap, lasthit: [T; 2]) -> Rgb {
    let [x, y] = [
        lasthit[0] / T::of(map.size.x),
        lasthit[1] / T::of(map.size.y),
    ];
    match map.wrap {
        Wrap::Clamp => gettexel(&map.texture, x, y),
        Wrap::Repeat => {
            let relative = |place: T, count: i32| {
                T::of(f64::from(place.int() % count)) / T::of(f64::from(count))
            };
            let [xdim, ydim] = dimensions(&map.texture);
            gettexel(&map.texture, relative(x, xdim), relative(y, ydim))
        }
    }
}

/// The chapter's `gettexel`: the colour at a relative place, rows from the top.
///
/// As in the chapter only the row below the last one is pulled back. A column to the right of the
/// last one is what a C program finds there: the first texel of the next row. Where it would find
/// nothing of the image, before its first texel or behind its last, this is the first or the last.
pub(super) fn gettexel<T: Scalar>(texture: &Texture, xrel: T, yrel: T) -> Rgb {
    let [xdim, ydim] = dimensions(texture);
    let xloc = (xrel * T::of(f64::from(xdim))).int();
    let mut yloc = ((T::one() - yrel) * T::of(f64::from(ydim))).int();
    if yloc == ydim {
        yloc = ydim - 1;
    }
    let place = i64::from(xdim) * i64::from(yloc) + i64::from(xloc);
    let place = usize::try_from(place).unwrap_or(0);
    let place = place.min(texture.texels.channels.len() - 1);
    let width = texture.texels.width;
    texture.texel(place % width, place / width)
}

/// The chapter's `getdim`; images are far smaller than an `int` can count.
fn dimensions(texture: &Texture) -> [i32; 2] {
    [texture.texels.width, texture.texels.height].map(|side| i32::try_from(side).unwrap_or(i32::MAX))
}
