//! Placement of a texture on a rectangle.

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

/// A texture on a rectangle, upright from the rectangle's lower-left corner.
#[derive(Debug, Clone)]
pub struct TextureMap {
    /// The texture.
    pub texture: Arc<Texture>,
    /// CLAMP or REPEAT.
    pub wrap: Wrap,
    /// The world size of the whole image for CLAMP, of one texel for REPEAT.
    pub size: DVec2,
    /// The borders of the texels along x and y.
    grids: [Grid; 2],
}

impl TextureMap {
    /// The chapter's CLAMP: the image fills a rectangle of a world size.
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

    /// The chapter's REPEAT: texels have a world size, and the image repeats.
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

    /// The colour at an offset with an error bound; `None` if the texel is uncertain.
    #[must_use]
    #[inline(always)]
    pub fn certain_texel(&self, offset: DVec2, error: f64) -> Option<Rgb> {
        let [x, y] = &self.grids;
        let column = x.certain_cell(offset.x, error)?;
        let row = y.certain_cell(offset.y, error)?;
        Some(self.texel([column, row]))
    }

    /// The nearest offset in the texel of the exact offset.
    #[must_use]
    pub fn snapped(
        &self,
        offset: DVec2,
        error: f64,
        exact: impl Fn() -> Option<[RBig; 2]>,
    ) -> DVec2 {
        let [x, y] = &self.grids;
        let along = |axis: usize| exact().map_or(RBig::ZERO, |[x, y]| [x, y][axis].clone());
        DVec2::new(
            x.settled(offset.x, error, || along(0)),
            y.settled(offset.y, error, || along(1)),
        )
    }

    /// The filtered colour of a footprint on a rectangle of a world size.
    ///
    /// `nearest` is the colour of the texel at the hit point.
    #[must_use]
    pub fn filtered(
        &self,
        filter: Filter,
        nearest: Rgb,
        footprint: &Footprint,
        size: DVec2,
    ) -> Rgb {
        let texel = self.texel_size();
        let size = size / texel;
        // Beyond this size a double does not identify the texels of the footprint.
        let is_exact = size.max_element() < Grid::MOST_CELLS / 1024.0;
        match filter {
            Filter::Exact if is_exact => {
                let mean = area::mean(self.texture.sums(), &footprint.over(texel), size);
                mean.unwrap_or(nearest)
            }
            Filter::Exact => {
                let linear = footprint.over(texel).spread();
                self.filtered_linearly(filter, nearest, &linear, [self.wrap; 2])
            }
            _ => {
                let linear = self.in_texels(footprint.spread());
                self.filtered_linearly(filter, nearest, &linear, [self.wrap; 2])
            }
        }
    }

    /// The filtered colour of a linear footprint in texels.
    ///
    /// [`Filter::Exact`] needs a projective footprint and falls back to the anisotropic filter.
    #[must_use]
    pub fn filtered_linearly(
        &self,
        filter: Filter,
        nearest: Rgb,
        footprint: &Spread,
        wraps: [Wrap; 2],
    ) -> Rgb {
        let texture = &*self.texture;
        let position = footprint.place;
        // Farther out a double does not identify the centre of a texel.
        let is_near = |coordinate: f64| coordinate.abs() < Grid::MOST_CELLS / 4.0;
        if filter != Filter::Nearest && !(is_near(position.x) && is_near(position.y)) {
            return texture.mean();
        }
        match filter {
            Filter::Nearest => nearest,
            Filter::Bilinear => bilinear(texture, position, wraps),
            Filter::Mipmap => {
                let size = longer_step(footprint);
                texture.pyramid().at(texture, position, size, wraps)
            }
            Filter::Anisotropic | Filter::Exact => {
                let color = anisotropic(texture.pyramid(), texture, footprint, wraps);
                color.unwrap_or_else(|| texture.mean())
            }
        }
    }

    /// A footprint in texels, from one in world units.
    #[must_use]
    pub fn in_texels(&self, footprint: Spread) -> Spread {
        footprint.over(self.texel_size())
    }

    /// The world size of a texel.
    fn texel_size(&self) -> DVec2 {
        let [x, y] = &self.grids;
        DVec2::new(x.pitch(), y.pitch())
    }

    /// The colour of a texel counted from the lower-left one.
    ///
    /// Beyond 2⁵³ texels a double does not identify the texel, and the mean colour is returned.
    #[inline(always)]
    fn texel(&self, [column, row]: [f64; 2]) -> Rgb {
        let (width, height) = (self.texture.texels.width, self.texture.texels.height);
        let is_unknown = |texel: f64| texel.abs() >= Grid::MOST_CELLS;
        if self.wrap == Wrap::Repeat && (is_unknown(column) || is_unknown(row)) {
            return self.texture.mean();
        }
        let column = self.wrap.index(column, width);
        // Texels are stored from the top, offsets count from the bottom.
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

    /// Between curved mirrors a footprint can become infinite.
    #[test]
    fn a_footprint_that_is_not_finite_has_a_colour() {
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
                    map.filtered_linearly(filter, Rgb::BLACK, &spread, wraps),
                    map.filtered(filter, Rgb::BLACK, &footprint, size),
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
