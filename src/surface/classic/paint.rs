//! What is seen on a shape, computed in the classic way.

use std::f64::consts::PI;

use glam::{DVec2, DVec3};

use super::Scalar;
use super::lookup::{gettexel, texture_map};
use super::vector::Vector;
use crate::material::Material;
use crate::math::Rgb;
use crate::surface::{Cover, Hit, Shape, TileStart};
use crate::texture::{Texture, TextureMap};

/// A cover in the numbers of the shape below it.
#[derive(Debug)]
pub(super) enum Paint<'a, T> {
    Plain,
    Image(&'a TextureMap),
    Globe(Globe<'a, T>),
    Tiles(Tiles<'a, T>),
    /// What only the surface itself knows, from the offset to this point.
    Own(DVec3),
}

impl<'a, T: Scalar> Paint<'a, T> {
    pub(super) fn of(cover: &Cover<'a>, shape: &Shape) -> Self {
        match (*cover, *shape) {
            (Cover::Plain, _) => Self::Plain,
            (Cover::Image(image), _) => Self::Image(image),
            (Cover::Globe(image), Shape::Ellipsoid { center, axes }) => {
                Self::Globe(Globe::of(&image.texture, center, axes))
            }
            (Cover::Globe(image), Shape::Sphere { center, radius }) => {
                Self::Globe(Globe::of(&image.texture, center, DVec3::splat(radius)))
            }
            (
                Cover::Tiles {
                    axes,
                    tile,
                    start,
                    alternate,
                },
                _,
            ) => Self::Tiles(Tiles {
                point: Vector::of(shape.anchor()),
                axes: axes.map(Vector::of),
                tile: [T::of(tile.x), T::of(tile.y)],
                start,
                alternate,
            }),
            (Cover::Globe(_) | Cover::Own, _) => Self::Own(shape.anchor()),
        }
    }

    /// The texture's colour at a hit; white where there is none.
    pub(super) fn texel(&self, hit: &Hit) -> Rgb {
        match self {
            Self::Image(image) => texture_map(image, of_pair::<T>(hit.uv)),
            Self::Globe(globe) => globe.texel(Vector::of(hit.point.world())),
            Self::Plain | Self::Tiles(_) | Self::Own(_) => Rgb::WHITE,
        }
    }
}

fn of_pair<T: Scalar>(pair: DVec2) -> [T; 2] {
    pair.to_array().map(T::of)
}

/// An image around a round thing.
#[derive(Debug)]
pub(super) struct Globe<'a, T> {
    texture: &'a Texture,
    center: Vector<T>,
    axes: Vector<T>,
}

impl<'a, T: Scalar> Globe<'a, T> {
    fn of(texture: &'a Texture, center: DVec3, axes: DVec3) -> Self {
        Self {
            texture,
            center: Vector::of(center),
            axes: Vector::of(axes),
        }
    }

    /// Longitude and latitude as relative places in the image.
    fn texel(&self, point: Vector<T>) -> Rgb {
        let direction = (point - self.center).over(self.axes).unit();
        let longitude = T::angle(direction.x, direction.z);
        let latitude = T::angle_of_sine(direction.y.max(-T::one()).min(T::one()));
        let half = T::of(0.5);
        let (half_turn, turn) = (T::of(PI), T::of(2.0 * PI));
        let (xrel, yrel) = (half + longitude / turn, half + latitude / half_turn);
        gettexel(self.texture, xrel, yrel)
    }
}

/// A checkerboard of two materials.
#[derive(Debug)]
pub(super) struct Tiles<'a, T> {
    point: Vector<T>,
    axes: [Vector<T>; 2],
    tile: [T; 2],
    start: TileStart,
    alternate: &'a Material,
}

impl<'a, T: Scalar> Tiles<'a, T> {
    /// The material at a hit, of this one and the alternate one.
    pub(super) fn material_at(&self, hit: &Hit, main: &'a Material) -> &'a Material {
        let point = Vector::of(hit.point.world());
        let along = |place: Vector<T>| self.axes.map(|axis| axis.dot(place));
        let [x, y] = match self.start {
            TileStart::Point => {
                let [x, y] = along(point - self.point);
                [x / self.tile[0], y / self.tile[1]].map(T::floor)
            }
            TileStart::Course => {
                let big = T::of(TileStart::BIG);
                let [x, y] = along(point);
                [(x + big) / self.tile[0], (y + big) / self.tile[1]]
            }
        };
        let odd = x.int().wrapping_add(y.int()) % 2 != 0;
        if odd == (self.start == TileStart::Course) {
            main
        } else {
            self.alternate
        }
    }
}
