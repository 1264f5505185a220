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

use super::{Anatomy, Common, Cover, Hit, Plane, Surface};
use crate::language::{
    Attribute, Default, Naming, Node, Range, Reference, Schema, Takes, ValueError, words,
};
use crate::material::Material;
use crate::math::error_bounds::FOOT;
use crate::math::exact::{Distance, decimal};
use crate::math::{ExactGeometry, Flat, Frame, Grid, Line, Point, Ray, Rgb, Segment, Side, Span};

/// An unbounded plane of tiles in two materials, in a checkerboard.
///
/// Ambient and diffuse alternate; mirror, glint and transparency are the main material's.
#[derive(Debug, Clone)]
pub struct TiledPlane {
    plane: Plane,
    frame: Frame,
    given_xdir: DVec3,
    tile: DVec2,
    /// The borders of the tiles along x and y.
    grids: [Grid; 2],
    start: TileStart,
    alternate: Arc<Material>,
}

/// Where the tiles are counted from, and which material comes first.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum TileStart {
    /// The plane's point is the lower-left corner of a tile of the main material.
    #[default]
    Point,
    /// As in the course's programs: from the world's origin, 100,000 added before dividing, the
    /// main material where the tile numbers add up to an odd number.
    Course,
}

words!(TileStart {
    Point: "point",
    Course: "course",
});

impl TileStart {
    /// What the course's programs add to a coordinate before they divide it, so that it is not
    /// below zero, where truncation would make a tile twice as wide.
    pub(super) const BIG: f64 = 100_000.0;
}

impl TiledPlane {
    /// The `tiled-plane` node of the scene language.
    pub const SCHEMA: Schema = Schema {
        word: "tiled-plane",
        about: "An unbounded plane of tiles in two materials, in a checkerboard.",
        naming: Naming::Optional,
        value: None,
        properties: &[],
        attributes: &[
            Common::ATTRIBUTES,
            &[Attribute::new(
                "alternate",
                Takes::Name(Reference::Material),
                "the material of every other tile; its ambient and diffuse count",
            )],
            Plane::ATTRIBUTES,
            &[
                Attribute::new("xdir", Takes::Triple, "where a row of tiles runs"),
                Attribute::new("dimensions", Takes::Pair(Range::Positive), "size of a tile")
                    .unit("world units"),
                Attribute::new(
                    "start",
                    Takes::Word(&TileStart::WORDS),
                    "count tiles from `point`, or as the course's programs did",
                )
                .or(Default::Word(TileStart::Point.word())),
            ],
        ],
    };

    /// A plane of tiles of this size along `xdir`.
    ///
    /// # Errors
    /// Refuses an `xdir` that is zero or parallel to the normal, and a size not above zero.
    pub fn new(
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
            plane,
            frame,
            given_xdir: xdir,
            tile,
            grids: tile.to_array().map(|pitch| Grid::new(&decimal(pitch))),
            start,
            alternate,
        })
    }

    /// The colour of one of the two materials, whichever lies at a hit; beyond 2⁵³ tiles no double
    /// says which, and their mean is seen.
    fn color_at(&self, hit: &Hit, color: impl Fn(&Material) -> Rgb) -> Rgb {
        let (tile, main_parity) = match self.start {
            TileStart::Point => {
                let [x, y] = &self.grids;
                (DVec2::new(x.cell(hit.uv.x), y.cell(hit.uv.y)), 0.0)
            }
            TileStart::Course => {
                let world = hit.point.world();
                let along = DVec2::new(self.frame.x.dot(world), self.frame.y.dot(world));
                (
                    ((along + DVec2::splat(TileStart::BIG)) / self.tile).floor(),
                    1.0,
                )
            }
        };
        let (main, alternate) = (color(&self.plane.common().material), color(&self.alternate));
        if tile.abs().max_element() >= Grid::MOST_CELLS {
            return (main + alternate) / 2.0;
        }
        let parity = (tile.x.rem_euclid(2.0) + tile.y.rem_euclid(2.0)).rem_euclid(2.0);
        if parity == main_parity {
            main
        } else {
            alternate
        }
    }
}

impl Surface for TiledPlane {
    fn hits(&self, ray: &Ray, span: Span) -> Option<Hit> {
        let hit = self.plane.hits(ray, span)?;
        let offset = hit.point.offset;
        let uv = DVec2::new(self.frame.x.dot(offset), self.frame.y.dot(offset));
        Some(Hit { uv, ..hit })
    }

    fn common(&self) -> &Common {
        self.plane.common()
    }

    fn anatomy(&self) -> Option<Anatomy<'_>> {
        Some(self.plane.anatomy()?.covered(Cover::Tiles {
            axes: [self.frame.x, self.frame.y],
            tile: self.tile,
            start: self.start,
            alternate: &self.alternate,
        }))
    }

    fn describe(&self) -> Node {
        let alternate = self.alternate.name.as_str();
        let node = Node::new(&Self::SCHEMA, None).with("alternate", alternate);
        self.plane
            .describe_into(node)
            .with("xdir", self.given_xdir)
            .with("dimensions", self.tile)
            .with("start", self.start.word())
    }

    fn flat(&self) -> Option<&Flat> {
        self.plane.flat()
    }

    fn exact_geometry(&self) -> Option<ExactGeometry> {
        self.plane.exact_geometry()
    }

    fn weld(&mut self, plane: &Flat, borders: &[Option<Line>]) {
        self.plane.weld(plane, borders);
    }

    fn exact_distance(&self, ray: &Ray) -> Option<Distance> {
        self.plane.exact_distance(ray)
    }

    fn occludes(&self, segment: &Segment, end: Side) -> bool {
        self.plane.occludes(segment, end)
    }

    fn settle(&self, hit: &mut Hit, ray: &Ray) {
        if self.start == TileStart::Course {
            return;
        }
        let Some(flat) = self.plane.flat() else {
            return;
        };
        let [x, y] = &self.grids;
        let exact = |axis: usize| {
            let offset = self.frame.exact_offset(flat, ray);
            offset.map_or(RBig::ZERO, |offset| offset[axis].clone())
        };
        let reach = ray.size() + Point::exact(flat.point).size() + hit.t;
        let doubt = 3.0 * hit.error + FOOT * reach;
        hit.uv = DVec2::new(
            x.settled(hit.uv.x, doubt, || exact(0)),
            y.settled(hit.uv.y, doubt, || exact(1)),
        );
    }

    fn getamb(&self, hit: &Hit) -> Rgb {
        self.color_at(hit, |material| material.ambient)
    }

    fn getdiff(&self, hit: &Hit) -> Rgb {
        self.color_at(hit, |material| material.diffuse)
    }

    fn brightest(&self) -> [f64; 2] {
        let both = [&self.plane.common().material, &self.alternate];
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
