//! How a texture lies on a rectangle.

use std::sync::Arc;

use dashu_ratio::RBig;
use glam::DVec2;

use super::anisotropic::anisotropic;
use super::area;
use super::bilinear::bilinear;
use super::pyramid::longer_step;
use super::{Filter, Texture, Wrap};
use crate::math::exact::decimal;
use crate::math::{Footprint, Grid, Rgb, Spread};

/// A texture laid over a rectangle, upright, with its lower-left corner at the rectangle's.
#[derive(Debug, Clone)]
pub struct TextureMap {
    /// The image.
    pub texture: Arc<Texture>,
    /// CLAMP or REPEAT.
    pub wrap: Wrap,
    /// The world size of what is mapped: the whole image for CLAMP, one texel for REPEAT.
    pub size: DVec2,
    /// The borders of the texels along x and y.
    grids: [Grid; 2],
}

impl TextureMap {
    /// The chapter's CLAMP: the image is stretched to fill a rectangle of this world size.
    #[must_use]
    pub fn clamp(texture: Arc<Texture>, size: DVec2) -> Self {
        let (width, height) = (texture.texels.width, texture.texels.height);
        let pitch = |size: f64, count: usize| Grid::new(&(decimal(size) / RBig::from(count)));
        Self {
            grids: [pitch(size.x, width), pitch(size.y, height)],
            texture,
            wrap: Wrap::Clamp,
            size,
        }
    }

    /// The chapter's REPEAT: texels of this world size, the image tiled over the rectangle.
    #[must_use]
    pub fn repeat(texture: Arc<Texture>, texel: DVec2) -> Self {
        Self {
            texture,
            wrap: Wrap::Repeat,
            size: texel,
            grids: texel.to_array().map(|pitch| Grid::new(&decimal(pitch))),
        }
    }

    /// The chapter's `texture_map`: the colour at an offset from the lower-left corner.
    #[must_use]
    pub fn at(&self, offset: DVec2) -> Rgb {
        let [x, y] = &self.grids;
        self.texel([x.cell(offset.x), y.cell(offset.y)])
    }

    /// The colour at an offset that may be off by as much as `doubt`, if that leaves no doubt.
    #[must_use]
    #[inline(always)]
    pub fn certain_texel(&self, offset: DVec2, doubt: f64) -> Option<Rgb> {
        let [x, y] = &self.grids;
        let column = x.certain_cell(offset.x, doubt)?;
        let row = y.certain_cell(offset.y, doubt)?;
        Some(self.texel([column, row]))
    }

    /// An offset that is off by at most `doubt`, moved as little as possible into the texel that the
    /// `exact` one is in.
    #[must_use]
    pub fn settled(
        &self,
        offset: DVec2,
        doubt: f64,
        exact: impl Fn() -> Option<[RBig; 2]>,
    ) -> DVec2 {
        let [x, y] = &self.grids;
        let along = |axis: usize| exact().map_or(RBig::ZERO, |[x, y]| [x, y][axis].clone());
        DVec2::new(
            x.settled(offset.x, doubt, || along(0)),
            y.settled(offset.y, doubt, || along(1)),
        )
    }

    /// The colour of what a pixel covers of a rectangle of this size that wears the texture, by any
    /// filter; `nearest` is the texel in its middle.
    #[must_use]
    pub fn over(
        &self,
        filter: Filter,
        nearest: Rgb,
        (footprint, size): (&Footprint, DVec2),
    ) -> Rgb {
        let texel = self.texel_size();
        if filter == Filter::Exact {
            let footprint = footprint.over(texel);
            return self.mean_over(nearest, &footprint, size / texel);
        }
        let spread = self.in_texels(footprint.spread());
        self.around(filter, nearest, &spread, [self.wrap; 2])
    }

    /// The mean over what a pixel covers of a rectangle, in texels. Of one texel that is its colour, and if
    /// nothing is covered, the texel in the middle.
    fn mean_over(&self, nearest: Rgb, footprint: &Footprint, size: DVec2) -> Rgb {
        // Out there no double says which texels are covered.
        if size.max_element() >= Grid::MOST_CELLS / 1024.0 {
            let spread = footprint.spread();
            return self.around(Filter::Anisotropic, nearest, &spread, [self.wrap; 2]);
        }
        let sums = self.texture.sums();
        area::mean(sums, footprint, size).unwrap_or(nearest)
    }

    /// The colour around a place in texels by a filter that looks at a footprint's middle and its
    /// steps; where the whole footprint would have to be known, along its longer axis.
    #[must_use]
    pub fn around(&self, filter: Filter, nearest: Rgb, spread: &Spread, wraps: [Wrap; 2]) -> Rgb {
        let texture = &*self.texture;
        // Out there no double says where a texel's middle is.
        let place = spread.place;
        let reaches = |it: f64| it.abs() < Grid::MOST_CELLS / 4.0;
        let is_within = reaches(place.x) && reaches(place.y);
        if filter != Filter::Nearest && !is_within {
            return texture.mean();
        }
        match filter {
            Filter::Nearest => nearest,
            Filter::Bilinear => {
                let sides = [texture.texels.width, texture.texels.height];
                bilinear(place, sides, wraps, |column, row| {
                    texture.texel_upwards(column, row)
                })
            }
            Filter::Mipmap => {
                let size = longer_step(spread);
                texture.pyramid().at(texture, place, size, wraps)
            }
            Filter::Anisotropic | Filter::Exact => {
                anisotropic(texture.pyramid(), texture, spread, wraps)
            }
        }
    }

    /// A footprint in world units, in texels.
    #[must_use]
    pub fn in_texels(&self, spread: Spread) -> Spread {
        spread.over(self.texel_size())
    }

    /// The world size of a texel.
    fn texel_size(&self) -> DVec2 {
        let [x, y] = &self.grids;
        DVec2::new(x.pitch(), y.pitch())
    }

    /// The colour of a texel counted from the lower-left one.
    ///
    /// Beyond 2⁵³ texels no double says which one it is, and the mean colour of all is seen.
    #[inline(always)]
    fn texel(&self, [column, row]: [f64; 2]) -> Rgb {
        let (width, height) = (self.texture.texels.width, self.texture.texels.height);
        let is_lost = |place: f64| place.abs() >= Grid::MOST_CELLS;
        if self.wrap == Wrap::Repeat && (is_lost(column) || is_lost(row)) {
            return self.texture.mean();
        }
        let column = self.wrap.index(column, width);
        // Images are stored from the top, offsets are counted from the bottom.
        let row = height - 1 - self.wrap.index(row, height);
        self.texture.texel(column, row)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::texture::Texels;
    use glam::DVec3;

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
        Arc::new(Texture::new(
            "numbered",
            "n.png",
            "n.png".into(),
            texels,
            255.0,
        ))
    }

    fn column_and_row(map: &TextureMap, x: f64, y: f64) -> (f64, f64) {
        let color = map.at(DVec2::new(x, y)) * 65_535.0;
        (color.r.round(), color.g.round())
    }

    #[test]
    fn clamp_draws_the_image_upright_and_keeps_its_borders() {
        let map = TextureMap::clamp(numbered(4, 4), DVec2::new(8.0, 2.0));
        assert_eq!(column_and_row(&map, 0.0, 0.0), (0.0, 3.0));
        assert_eq!(column_and_row(&map, 8.0, 2.0), (3.0, 0.0));
        assert_eq!(column_and_row(&map, 3.9, 1.1), (1.0, 1.0));
    }

    /// Between curved mirrors beams spread beyond all numbers.
    #[test]
    fn a_footprint_of_no_numbers_has_a_colour() {
        let size = DVec2::new(8.0, 2.0);
        let map = TextureMap::clamp(numbered(4, 4), size);
        let odd = [0.0, 1.0, 1e160, 1e300, f64::INFINITY, f64::NAN];
        let wraps = [Wrap::Repeat, Wrap::Clamp];
        for (right, up) in odd.iter().flat_map(|right| odd.map(|up| (*right, up))) {
            for (x, filter) in odd
                .iter()
                .flat_map(|x| Filter::ALL.map(|filter| (*x, filter)))
            {
                let spread = Spread {
                    place: DVec2::new(x, 0.5),
                    steps: [DVec2::new(right, up), DVec2::new(up, -right)],
                };
                let footprint = Footprint {
                    center: DVec3::new(x, 1.0, 1.0),
                    steps: [DVec3::new(right, up, 0.0), DVec3::new(up, 0.0, right)],
                };
                for color in [
                    map.around(filter, Rgb::BLACK, &spread, wraps),
                    map.over(filter, Rgb::BLACK, (&footprint, size)),
                ] {
                    let is_color = |it: f64| (0.0..=1.0).contains(&it);
                    assert!(
                        color.channels().into_iter().all(is_color),
                        "{filter:?} {spread:?}: {color:?}"
                    );
                }
            }
        }
    }

    #[test]
    fn every_row_and_column_is_used_equally_in_both_modes() {
        for side in [3, 7, 100, 128, 200, 300, 384] {
            for map in [
                TextureMap::clamp(numbered(side, side), DVec2::splat(10.0)),
                TextureMap::repeat(numbered(side, side), DVec2::splat(10.0 / side as f64)),
            ] {
                for texel in 0..side {
                    let middle = (texel as f64 + 0.5) / side as f64 * 10.0;
                    let expected = (texel as f64, (side - 1 - texel) as f64);
                    assert_eq!(column_and_row(&map, middle, middle), expected);
                }
            }
        }
    }

    #[test]
    fn whole_pixel_offsets_take_each_row_once() {
        // The chapter's own formula reads rows 128, 127, 126 … 1 here: the first twice, 0 never.
        let map = TextureMap::repeat(numbered(128, 128), DVec2::ONE);
        let rows: Vec<_> = (0..128)
            .map(|y| column_and_row(&map, 0.0, f64::from(y)).1)
            .collect();
        let expected: Vec<_> = (0..128).rev().map(f64::from).collect();
        assert_eq!(rows, expected);
    }

    #[test]
    fn a_whole_texel_is_not_rounded_down() {
        // In doubles, 1 / 49 × 49 is less than 1.
        let map = TextureMap::clamp(numbered(49, 49), DVec2::splat(49.0));
        for offset in 0..49u8 {
            let offset = f64::from(offset);
            assert_eq!(
                column_and_row(&map, offset, offset),
                (offset, 48.0 - offset)
            );
        }
    }

    #[test]
    fn repeat_continues_the_image_without_a_seam() {
        let map = TextureMap::repeat(numbered(5, 5), DVec2::new(0.5, 0.25));
        assert_eq!(
            column_and_row(&map, 2.6, 1.3),
            column_and_row(&map, 0.1, 0.05)
        );
    }
}
