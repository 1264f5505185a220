//! The tiled plane.
//!
//! ```
//! # heliodon::doctest::surface(r#"
//! tiled-plane "floor" {
//!     material "gray"
//!     alternate "white"
//!     point 0 0 0
//!     normal 0 1 0
//!     xdir 1 0 0
//!     dimensions 1 1
//! }
//! # "#, [0.0, 1.0, 0.0], [0.0, -1.0, 0.0], Some(1.0));
//! ```

use std::sync::Arc;

use dashu_ratio::RBig;
use glam::{DVec2, DVec3};

use super::{Common, Hit, Resolved, Surface};
use crate::geometry::{Plane, Shape};
use crate::language::{
    Attribute, Default, Naming, Node, Range, Reference, Schema, Takes, ValueError, words,
};
use crate::material::Material;
use crate::math::classic::{Scalar, Vector};
use crate::math::error_bounds::FOOT;
use crate::math::exact::decimal;
use crate::math::{Frame, Grid, Numerics, Point, Ray, Rgb};

/// An unbounded plane of tiles in two materials, in a checkerboard.
///
/// Ambient and diffuse alternate. Reflection, specular highlight and transparency are those of the
/// main material.
#[derive(Debug, Clone)]
pub struct TiledPlane {
    common: Common,
    shape: Shape,
    frame: Frame,
    given_xdir: DVec3,
    tile: DVec2,
    /// The borders of the tiles along x and y.
    grids: [Grid; 2],
    start: TileStart,
    alternate: Arc<Material>,
}

/// The first tile, and the material that it has.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum TileStart {
    /// The plane's point is the lower-left corner of a tile of the main material.
    #[default]
    Point,
    /// Tiles as in the course's programs, from the world's origin.
    ///
    /// The programs add 100,000 before they divide. The tiles whose numbers have an odd sum are of
    /// the main material.
    Course,
}

words!(TileStart {
    Point: "point",
    Course: "course",
});

impl TileStart {
    /// The number that the course's programs add to a coordinate before they divide it.
    ///
    /// Below zero, truncation would make a tile twice as wide.
    pub(super) const BIG: f64 = 100_000.0;
}

impl TiledPlane {
    /// The `tiled-plane` node of the scene language.
    pub const SCHEMA: Schema = Schema {
        word: "tiled-plane",
        about: "An unbounded checkerboard of tiles in two materials.",
        naming: Naming::Optional,
        value: None,
        properties: &[],
        attributes: &[
            Common::ATTRIBUTES,
            &[Attribute::new(
                "alternate",
                Takes::Name(Reference::Material),
                "the material of every other tile; only its `ambient` and `diffuse` are used",
            )],
            Plane::ATTRIBUTES,
            &[
                Attribute::new("xdir", Takes::Triple, "direction of a row of tiles"),
                Attribute::new("dimensions", Takes::Pair(Range::Positive), "size of a tile")
                    .unit("world units"),
                Attribute::new(
                    "start",
                    Takes::Word(&TileStart::WORDS),
                    "origin of the tiles: `point`, or the world's origin as in the course's \
                     programs",
                )
                .or(Default::Word(TileStart::Point.word())),
            ],
        ],
    };

    /// A plane of tiles of this size along `xdir`.
    ///
    /// # Errors
    /// Returns an error for an `xdir` that is zero or parallel to the normal, and for a size that
    /// is not above zero.
    pub fn new(
        common: Common,
        plane: Plane,
        xdir: DVec3,
        tile: DVec2,
        start: TileStart,
        alternate: Arc<Material>,
    ) -> Result<Self, ValueError> {
        let frame = Frame::new(plane.given_normal(), xdir)?;
        if !(tile.is_finite() && tile.min_element() > 0.0) {
            return Err(ValueError::new(
                "dimensions",
                "width and height of a tile must be above zero",
                "give the size of one tile in world units",
            ));
        }
        Ok(Self {
            common,
            shape: plane.into(),
            frame,
            given_xdir: xdir,
            tile,
            grids: tile.to_array().map(|pitch| Grid::new(&decimal(pitch))),
            start,
            alternate,
        })
    }

    /// The exact numbers of the tile at a hit; rounded as in the course's programs.
    fn tile_at(&self, hit: &Hit, ray: &Ray) -> DVec2 {
        let along = |vector: DVec3| DVec2::new(self.frame.x.dot(vector), self.frame.y.dot(vector));
        let Some(flat) = self.shape.carrier() else {
            return DVec2::ZERO;
        };
        if self.start == TileStart::Course {
            let big = DVec2::splat(TileStart::BIG);
            return ((along(hit.point.world()) + big) / self.tile).floor();
        }
        let exact = |axis: usize| {
            let offset = self.frame.exact_offset(flat, ray);
            offset.map_or(RBig::ZERO, |offset| offset[axis].clone())
        };
        let size = ray.size() + Point::exact(flat.point).size() + hit.t;
        let bound = 3.0 * hit.error + FOOT * size;
        let uv = along(hit.point.offset);
        let [x, y] = &self.grids;
        DVec2::new(
            x.cell(x.settled(uv.x, bound, || exact(0))),
            y.cell(y.settled(uv.y, bound, || exact(1))),
        )
    }

    /// The numbers of the tile at a hit, by the classic numerics.
    fn classic_tile_at<T: Scalar>(&self, hit: &Hit) -> DVec2 {
        let axes = [self.frame.x, self.frame.y].map(Vector::of);
        let tile = self.tile.to_array().map(T::of);
        let point = Vector::of(hit.point.world());
        let along = |vector: Vector<T>| axes.map(|axis| axis.dot(vector));
        let [x, y] = match self.start {
            TileStart::Point => {
                let [x, y] = along(point - Vector::of(self.shape.anchor()));
                [x / tile[0], y / tile[1]].map(T::floor)
            }
            TileStart::Course => {
                let big = T::of(TileStart::BIG);
                let [x, y] = along(point);
                [(x + big) / tile[0], (y + big) / tile[1]]
            }
        };
        DVec2::new(x.int().into(), y.int().into())
    }

    /// The colour of the material at a resolved hit.
    ///
    /// Beyond 2⁵³ tiles a double cannot hold the number, and the colour is the mean of both.
    fn color_at(&self, hit: &Hit, color: impl Fn(&Material) -> Rgb) -> Rgb {
        let (main, alternate) = (color(&self.common.material), color(&self.alternate));
        let tile = hit.uv;
        if tile.abs().max_element() >= Grid::MOST_CELLS {
            return (main + alternate) / 2.0;
        }
        let parity = (tile.x.rem_euclid(2.0) + tile.y.rem_euclid(2.0)).rem_euclid(2.0);
        let is_odd = parity == 1.0;
        if is_odd == (self.start == TileStart::Course) {
            main
        } else {
            alternate
        }
    }
}

impl Surface for TiledPlane {
    fn shape(&self) -> &Shape {
        &self.shape
    }

    fn shape_mut(&mut self) -> &mut Shape {
        &mut self.shape
    }

    fn common(&self) -> &Common {
        &self.common
    }

    fn describe(&self) -> Node {
        let alternate = self.alternate.name.as_str();
        let node = Node::new(&Self::SCHEMA, None).with("alternate", alternate);
        self.shape
            .describe_into(node)
            .with("xdir", self.given_xdir)
            .with("dimensions", self.tile)
            .with("start", self.start.word())
    }

    fn resolve(&self, hit: &Hit, ray: &Ray, numerics: Numerics) -> Resolved {
        let uv = match numerics {
            Numerics::Robust => self.tile_at(hit, ray),
            Numerics::Classic => self.classic_tile_at::<f64>(hit),
            Numerics::ClassicF32 => self.classic_tile_at::<f32>(hit),
        };
        let texel = Rgb::WHITE;
        Resolved { uv, texel }
    }

    fn getamb(&self, hit: &Hit) -> Rgb {
        self.color_at(hit, |material| material.ambient)
    }

    fn getdiff(&self, hit: &Hit) -> Rgb {
        self.color_at(hit, |material| material.diffuse)
    }

    fn brightest(&self) -> [f64; 2] {
        let both = [&self.common.material, &self.alternate];
        let largest = |color: fn(&Material) -> Rgb| {
            let channels = both.map(|material| color(material).largest());
            channels[0].max(channels[1])
        };
        [
            largest(|material| material.ambient),
            largest(|material| material.diffuse),
        ]
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::classic;
    use crate::math::{Span, unit};

    fn material(name: &str, ambient: f64) -> Arc<Material> {
        Arc::new(Material {
            name: name.to_owned(),
            ambient: Rgb::new(ambient, ambient, ambient),
            ..(*Common::black(None, None).material).clone()
        })
    }

    /// Numbers from −1 to 1 without rhyme, the same on every run (Weyl 1916).
    fn scatter(index: u32) -> [f64; 2] {
        [2f64.sqrt(), 3f64.sqrt()].map(|root| (f64::from(index) * root).fract() * 2.0 - 1.0)
    }

    #[test]
    fn classic_tiles_alternate_as_the_robust_ones_do() {
        for start in [TileStart::Point, TileStart::Course] {
            let plane = Plane::new(DVec3::new(0.3, 0.0, 0.1), DVec3::Y).expect("a plane");
            let (common, tile) = (Common::new(material("main", 2.0)), DVec2::new(1.5, 0.5));
            let other = material("other", 3.0);
            let tiled = TiledPlane::new(common, plane, DVec3::X, tile, start, other);
            let tiled = tiled.expect("tiles");
            for index in 0..1000 {
                let [x, z] = scatter(index).map(|place| place * 20.0);
                let down = unit(DVec3::NEG_Y).expect("a direction");
                let down = Ray::new(Point::exact(DVec3::new(x, 1.0, z)), down);
                let ambient = |hit: Option<Hit>, numerics| {
                    let hit = hit.expect("a hit");
                    tiled.getamb(&hit.resolved(tiled.resolve(&hit, &down, numerics)))
                };
                let classic = classic::intersect::<f64>(tiled.shape(), &down, Span::AHEAD);
                assert_eq!(
                    ambient(tiled.hits(&down, Span::AHEAD), Numerics::Robust),
                    ambient(classic, Numerics::Classic),
                    "{start:?}"
                );
            }
        }
    }
}
