//! Surfaces, and rays that are aimed at them.

use std::sync::Arc;

use glam::{DVec2, DVec3};
use heliodon::geometry::{Ellipsoid, Plane, Rectangle, Shape, Sphere, Triangle};
use heliodon::material::Material;
use heliodon::math::{Frame, Point, Ray, Rgb, unit};
use heliodon::surface::{Common, Plain, Surface, share};

use crate::rational::{Vector, number};
use support::random::{Random, Style};

/// A surface of any kind.
pub type Boxed = Box<dyn Surface>;

/// What surfaces of the cases have in common: nothing of interest.
pub fn common() -> Common {
    letting_through(0.5)
}

/// What every surface has, of a material that lets this share of light through.
pub fn letting_through(transparency: f64) -> Common {
    let material = Material {
        name: "gray".to_owned(),
        ambient: Rgb::WHITE,
        diffuse: Rgb::WHITE,
        specular: Rgb::WHITE,
        shininess: 0.0,
        transparency,
        ior: None,
    };
    Common::new(Arc::new(material))
}

/// A shape with the material of all cases.
pub fn boxed(shape: impl Into<Shape>) -> Boxed {
    Box::new(Plain::new(common(), shape))
}

/// An unbounded plane.
pub fn plane(random: &mut Random, style: Style, scale: f64) -> Boxed {
    let (point, normal) = (random.vector(style) * scale, random.way(style));
    boxed(Plane::new(point, normal).expect("a normal that is not zero"))
}

/// A rectangle with sides along whole numbers, or in any direction.
pub fn rectangle(random: &mut Random, style: Style, scale: f64) -> Boxed {
    loop {
        let [corner, normal, xdir] = [0; 3].map(|_| random.way(style));
        let size = random.vector(style).truncate().abs() + DVec2::splat(random.power(-3, 1));
        let made = Rectangle::new(corner * scale, normal, xdir, size * scale);
        if let Ok(made) = made {
            return boxed(made);
        }
    }
}

/// A triangle; slivers too.
pub fn triangle(random: &mut Random, style: Style, scale: f64) -> Boxed {
    loop {
        let mut vertices = [0; 3].map(|_| random.vector(style) * scale);
        if random.once_in(8) {
            let middle = (vertices[0] + vertices[1]) / 2.0;
            vertices[2] = random.nudged(middle, 3);
        }
        if let Ok(made) = Triangle::new(vertices) {
            return boxed(made);
        }
    }
}

/// A sphere or an ellipsoid with axes up to 2²⁰ times as long as others.
pub fn round(random: &mut Random, style: Style, scale: f64) -> Boxed {
    let center = random.vector(style) * scale;
    let radius = (random.number(style).abs() + random.power(-3, 1)) * scale;
    if random.once_in(2) {
        return boxed(Sphere::new(center, radius).expect("a radius above zero"));
    }
    let factors = [0; 3].map(|_| random.power(-10, 10) * (1.0 + random.pick(&[0.0, 0.1, 0.7])));
    let made = Ellipsoid::new(center, radius, factors.into());
    boxed(made.expect("axes above zero"))
}

/// A surface of any kind.
pub fn surface(random: &mut Random, style: Style, scale: f64) -> Boxed {
    let make = random.pick(&[plane, rectangle, triangle, round]);
    make(random, style, scale)
}

/// Mostly 1; now and then at the ends of the range that scenes may have.
pub fn scale(random: &mut Random) -> f64 {
    if random.once_in(4) {
        random.power(-150, 150)
    } else {
        1.0
    }
}

/// A place of interest on a surface: on an edge, in a corner, at the rim as seen from `eye`.
fn feature(random: &mut Random, surface: &dyn Surface, eye: DVec3) -> DVec3 {
    if let Some([center, axes]) = surface.shape().round() {
        return rim(random, center, axes, eye);
    }
    let corners = surface.shape().outline();
    let Some(first) = corners.first() else {
        let flat = surface.shape().carrier().expect("a flat surface");
        let way = random.cube();
        return flat.point + (way - flat.normal * flat.normal.dot(way));
    };
    // From one corner towards the next, and from there into the inside.
    let index = random.below(u32::try_from(corners.len()).unwrap_or(1)) as usize;
    let (from, to) = (corners[index], corners[(index + 1) % corners.len()]);
    let along = match random.below(4) {
        0 => 0.0,
        1 => 0.5,
        _ => random.share(),
    };
    let inward = if random.once_in(2) {
        0.0
    } else {
        random.share()
    };
    let (from, to) = (Vector::of(from), Vector::of(to));
    let place = from.plus(&to.minus(&from).times(&number(along)));
    place
        .plus(&Vector::of(*first).minus(&place).times(&number(inward)))
        .rounded()
}

/// A place where a line from `eye` touches a round surface.
pub fn rim(random: &mut Random, center: DVec3, axes: DVec3, eye: DVec3) -> DVec3 {
    let from = (eye - center) / axes;
    let far = from.length();
    let around = from.cross(random.cube());
    let (Some(towards), Some(around)) = (unit(from), unit(around)) else {
        return center + axes * random.cube();
    };
    // The touching points form a circle whose plane is 1/far from the centre.
    let near = (1.0 / far).min(1.0);
    let place = towards * near + around * (1.0 - near * near).sqrt();
    center + axes * place
}

/// A ray: of any kind, at a feature of a surface, or a few roundings beside one.
///
/// Half of those at a feature start just so far before it that their line passes through a
/// corner or the centre without any rounding.
pub fn ray(
    random: &mut Random,
    surface: &dyn Surface,
    style: Style,
    scale: f64,
) -> (Ray<'static>, bool) {
    let start = random.point(style);
    let mut origin = Point {
        anchor: start.anchor * scale,
        offset: start.offset * scale,
    };
    let mut dir = random.direction(style);
    if random.once_in(4) {
        return (Ray::new(origin, dir), false);
    }
    if let Some(flat) = surface.shape().carrier()
        && random.once_in(3)
    {
        // Along the plane, but for rounding; the longer the step, the more it is.
        let along = dir - flat.normal * flat.normal.dot(dir);
        let tilt = flat.normal * (random.signed() * random.power(-60, -1));
        dir = unit(along + tilt).unwrap_or(dir);
    }
    if random.once_in(3) {
        // Exactly through a corner, or exactly from the plane.
        let corner = surface.shape().outline().first().copied();
        let from = surface.shape().carrier().map(|flat| flat.point);
        let anchor = corner.or(from).unwrap_or(origin.anchor);
        let back = dir * (scale * random.power(-4, 12));
        origin = Point {
            anchor,
            offset: if random.once_in(4) {
                DVec3::ZERO
            } else {
                -back
            },
        };
    } else {
        let place = feature(random, surface, origin.world());
        let way = Vector::of(place).minus(&Vector::to(&origin)).rounded();
        dir = unit(way).unwrap_or(dir);
    }
    dir = random.nudged(dir, 3);
    if random.once_in(4) {
        origin.anchor = random.nudged(origin.anchor, 3);
    }
    (Ray::new(origin, dir), true)
}

/// A sphere or an ellipsoid as far away as 10¹⁰ of its radii and with axes up to 10⁶ times as long
/// as others, and a ray that nearly touches it, or is exactly so far beside that only rounding
/// tells.
pub fn far_and_round(random: &mut Random) -> (Boxed, Ray<'static>) {
    let center = random.cube() * random.power(-10, 10);
    let far = random.power(0, 33) * (1.0 + 0.16 * random.share());
    let radius = random.power(-20, 20);
    let factors = if random.once_in(2) {
        DVec3::ONE
    } else {
        [0; 3]
            .map(|_| random.power(-9, 9) * (1.0 + random.share()))
            .into()
    };
    let made = Ellipsoid::new(center, radius, factors).expect("axes above zero");
    let surface: Boxed = if factors == DVec3::ONE {
        boxed(Sphere::new(center, radius).expect("a radius"))
    } else {
        boxed(made)
    };
    let axes = factors * radius;
    let from = unit(random.cube()).unwrap_or(DVec3::X) * axes.max_element() * (1.0 + far);
    let origin = if random.once_in(2) {
        Point {
            anchor: center,
            offset: from,
        }
    } else {
        Point::exact(center + from)
    };
    let touched = rim(random, center, axes, center + from);
    let beside = axes * random.cube() * random.power(-54, 0);
    let way = Vector::of(touched + beside)
        .minus(&Vector::to(&origin))
        .rounded();
    let dir = random.nudged(unit(way).unwrap_or(DVec3::X), 3);
    (surface, Ray::new(origin, dir))
}

/// A rectangle far away from its neighbour in the plane and up to seven last places of its own
/// coordinates above or below it; the ray starts about as close to the plane at the neighbour's.
pub fn welded_rectangle(random: &mut Random) -> (Boxed, Ray<'static>) {
    loop {
        let (normal, xdir) = (random.cube(), random.cube());
        let Ok(frame) = Frame::new(normal, xdir) else {
            continue;
        };
        let make = |corner: DVec3| -> Boxed {
            let made = Rectangle::new(corner, normal, xdir, DVec2::ONE);
            boxed(made.expect("a rectangle"))
        };
        let normal = make(DVec3::ZERO)
            .shape()
            .carrier()
            .expect("a flat surface")
            .normal;
        let far = random.power(2, 30);
        let place = frame.x * far;
        let last_place = place.abs().max_element() * f64::EPSILON / 2.0;
        let lift = normal * (last_place * 7.0 * random.signed());
        let mut surfaces = vec![make(DVec3::ZERO), make(place + lift)];
        share(&mut surfaces);
        let start = frame.x * random.signed() + frame.y * random.signed();
        let height = last_place * 16.0 * random.signed();
        let way = place + (frame.x + frame.y) * 0.5 - start - normal * height;
        let dir = if random.once_in(2) {
            way
        } else {
            random.cube()
        };
        let ray = Ray::new(
            Point::exact(start + normal * height),
            unit(dir).unwrap_or(normal),
        );
        return (surfaces.swap_remove(1), ray);
    }
}

/// A triangle whose longest edge is welded to that of another which is up to 2e-15 beside; the ray
/// comes down close to that edge.
pub fn welded_triangle(random: &mut Random) -> (Boxed, Ray<'static>) {
    let beside = f64::from(random.between(-2, 2)) * 1e-15;
    let make = |vertices: [[f64; 2]; 3]| -> Boxed {
        let vertices = vertices.map(|[x, y]| DVec3::new(x, y, 0.0));
        boxed(Triangle::new(vertices).expect("a triangle"))
    };
    let first = make([[0.0, 0.0], [1.0, 1.0], [0.0, 1.0]]);
    let second = make([
        [3.0, 3.0 + beside],
        [2.0, 2.0 + beside],
        [3.0, 2.0 + beside],
    ]);
    let mut surfaces = vec![first, second];
    share(&mut surfaces);
    let along = 2.0 + random.share();
    let across = 4e-15 * random.signed();
    let place = DVec3::new(along, along + across, 0.0);
    let from = place + random.cube() * random.power(-20, -5);
    let dir = unit(place - from).unwrap_or(DVec3::NEG_Z);
    // Anchored at the triangle, so that little else is in doubt.
    let anchor = DVec3::new(2.0, 2.0 + beside, 0.0);
    let origin = Point {
        anchor,
        offset: from - anchor,
    };
    (surfaces.swap_remove(1), Ray::new(origin, dir))
}
