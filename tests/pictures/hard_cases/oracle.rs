//! What a ray meets by exact arithmetic, slowly.
//!
//! The numbers of the scene are the doubles as they stand there, the ray is what the program under test was
//! given. A rectangle's far borders lie at the doubles nearest to corner plus size if it lies along
//! the axes, and so do the lines of a grid; frames at an angle are compared by squares, so that no
//! root is needed.

use dashu::integer::IBig;
use dashu::rational::RBig;
use glam::DVec3;
use heliodon::language::Node;
use heliodon::math::Ray;

use super::numbers::{meant, nearest, of};
use super::subject::Subject;

type Vector = [RBig; 3];

/// The surfaces of a scene in exact numbers, in file order.
#[derive(Debug)]
pub(crate) struct Oracle {
    surfaces: Vec<(String, Shape)>,
}

#[derive(Debug)]
enum Shape {
    Flat(Box<Flat>),
    /// Centre and half axes.
    Round(Box<[Vector; 2]>),
    /// What the oracle does not know; asking about it is a mistake in the case.
    Unknown,
}

#[derive(Debug)]
struct Flat {
    point: Vector,
    normal: Vector,
    size: Option<Size>,
}

#[derive(Debug)]
struct Size {
    /// Along the plane's own x and y, of any length.
    axes: [Vector; 2],
    size: [f64; 2],
    texel: Option<[f64; 2]>,
}

fn vector(vector: DVec3) -> Vector {
    vector.to_array().map(of)
}

fn dot(a: &Vector, b: &Vector) -> RBig {
    &a[0] * &b[0] + &a[1] * &b[1] + &a[2] * &b[2]
}

fn cross(a: &Vector, b: &Vector) -> Vector {
    let minor = |i: usize, j: usize| &a[i] * &b[j] - &a[j] * &b[i];
    [minor(1, 2), minor(2, 0), minor(0, 1)]
}

fn minus(a: &Vector, b: &Vector) -> Vector {
    [0, 1, 2].map(|axis| &a[axis] - &b[axis])
}

impl Oracle {
    /// The oracle for a scene.
    pub(crate) fn new(subject: &Subject) -> Self {
        let surfaces = subject.surfaces();
        let named = surfaces.iter().map(|node| {
            let name = node.name.clone().unwrap_or_else(|| "(unnamed)".to_owned());
            (name, Shape::of(node))
        });
        Self {
            surfaces: named.collect(),
        }
    }

    /// The name of the surface that a ray meets first, or `nothing`; of equally near ones the first
    /// in the scene.
    pub(crate) fn first(&self, ray: &Ray<'static>) -> &str {
        let origin = minus(&vector(ray.origin.anchor), &vector(-ray.origin.offset));
        let direction = vector(ray.dir);
        let mut best: Option<(RBig, &str)> = None;
        for (name, shape) in &self.surfaces {
            let Some(t) = shape.meets(&origin, &direction) else {
                continue;
            };
            if best.as_ref().is_none_or(|(nearest, _)| t < *nearest) {
                best = Some((t, name));
            }
        }
        best.map_or("nothing", |(_, name)| name)
    }

    /// Column and row of the texel at which a ray meets a surface with a 4 × 4 texture.
    pub(crate) fn texel(&self, name: &str, ray: &Ray<'static>) -> [f64; 2] {
        let origin = minus(&vector(ray.origin.anchor), &vector(-ray.origin.offset));
        let found = self.surfaces.iter().find(|(known, _)| known == name);
        let Some((_, Shape::Flat(flat))) = found else {
            panic!("{name} has no texels");
        };
        let Some(Size { axes, size, texel }) = &flat.size else {
            panic!("{name} has no size");
        };
        let (_, place) = flat.crossing(&origin, &vector(ray.dir)).unwrap();
        let index = |axis: usize| {
            let along = dot(&place, &axes[axis]);
            assert!(
                dot(&axes[axis], &axes[axis]) == RBig::ONE,
                "{name} is at an angle"
            );
            let number = match texel {
                Some(pitch) => on_grid(&along, pitch[axis]),
                None => on_grid(&along, size[axis] / 4.0).clamp(IBig::ZERO, IBig::from(3)),
            };
            let four = IBig::from(4);
            let rest = ((number % &four) + &four) % four;
            f64::try_from(rest).unwrap()
        };
        [index(0), 3.0 - index(1)]
    }
}

/// The number of the cell that a place lies in, with lines at the doubles nearest to the multiples
/// of the pitch.
fn on_grid(place: &RBig, pitch: f64) -> IBig {
    let pitch = meant(pitch);
    let line = |index: &IBig| of(nearest(&(&pitch * RBig::from(index.clone()))));
    let mut index = (place / &pitch).floor();
    while line(&(&index + IBig::ONE)) <= *place {
        index += IBig::ONE;
    }
    while line(&index) > *place {
        index -= IBig::ONE;
    }
    index
}

impl Shape {
    fn of(node: &Node) -> Self {
        match node.schema.word {
            "plane" | "tiled-plane" | "procedural-plane" => Self::Flat(Box::new(Flat {
                point: vector(node.triple("point")),
                normal: vector(node.triple("normal")),
                size: None,
            })),
            "finite-plane" | "texture-plane" => {
                let normal = vector(node.triple("normal"));
                let xdir = vector(node.triple("xdir"));
                // The part of xdir in the plane, times the normal's length squared.
                let y = cross(&normal, &xdir);
                let x = cross(&y, &normal);
                let texel = node
                    .entry("texture")
                    .and_then(|entry| entry.property("texel"));
                Self::Flat(Box::new(Flat {
                    point: vector(node.triple("point")),
                    size: Some(Size {
                        axes: [shortened(x), shortened(y)],
                        size: node.pair("dimensions").to_array(),
                        texel: texel.map(|texel| texel.pair().to_array()),
                    }),
                    normal,
                }))
            }
            "sphere" => {
                let radius = of(node.number("radius"));
                let axes = [(); 3].map(|()| radius.clone());
                Self::Round(Box::new([vector(node.triple("center")), axes]))
            }
            "ellipsoid" => {
                let radius = of(node.number("radius"));
                let axes = vector(node.triple("scale")).map(|scale| scale * &radius);
                Self::Round(Box::new([vector(node.triple("center")), axes]))
            }
            _ => Self::Unknown,
        }
    }

    fn meets(&self, origin: &Vector, direction: &Vector) -> Option<RBig> {
        match self {
            Self::Flat(flat) => flat.meets(origin, direction),
            Self::Round(round) => enters(origin, direction, &round[0], &round[1]),
            Self::Unknown => panic!("there is no exact arithmetic for this kind of surface"),
        }
    }
}

/// A vector along one axis made unit, any other as it is.
fn shortened(vector: Vector) -> Vector {
    let others = vector.iter().filter(|part| **part != RBig::ZERO).count();
    if others != 1 {
        return vector;
    }
    vector.map(|part| part.signum())
}

/// The distance at which a ray enters an ellipsoid from outside; the root is rounded, the decision is not.
fn enters(origin: &Vector, direction: &Vector, center: &Vector, axes: &Vector) -> Option<RBig> {
    let c = minus(origin, center);
    let c: Vector = [0, 1, 2].map(|axis| &c[axis] / &axes[axis]);
    let d: Vector = [0, 1, 2].map(|axis| &direction[axis] / &axes[axis]);
    let (cc, cd, dd) = (dot(&c, &c), dot(&c, &d), dot(&d, &d));
    let inside = &cc - RBig::ONE;
    // Half the discriminant of |c + t d|² = 1, squared.
    let root = &cd * &cd - &dd * &inside;
    if inside <= RBig::ZERO || cd >= RBig::ZERO || root <= RBig::ZERO {
        return None;
    }
    let root = of(nearest(&root).sqrt());
    Some((-cd - root) / dd)
}

impl Flat {
    /// The distance of the plane, and the place in it from the plane's point.
    fn crossing(&self, origin: &Vector, direction: &Vector) -> Option<(RBig, Vector)> {
        let c = minus(origin, &self.point);
        let slope = dot(&self.normal, direction);
        if slope == RBig::ZERO {
            return None;
        }
        let t = -dot(&self.normal, &c) / slope;
        if t <= RBig::ZERO {
            return None;
        }
        let place = [0, 1, 2].map(|axis| &c[axis] + &direction[axis] * &t);
        Some((t, place))
    }

    fn meets(&self, origin: &Vector, direction: &Vector) -> Option<RBig> {
        let (t, place) = self.crossing(origin, direction)?;
        let Some(Size { axes, size, .. }) = &self.size else {
            return Some(t);
        };
        let inside = [0, 1].into_iter().all(|axis| {
            let along = dot(&place, &axes[axis]);
            let length = dot(&axes[axis], &axes[axis]);
            if along < RBig::ZERO {
                return false;
            }
            if length == RBig::ONE {
                let corner = dot(&self.point, &axes[axis]);
                let border = of(nearest(&(&corner + meant(size[axis]))));
                return along <= border - corner;
            }
            let size = of(size[axis]);
            &along * &along <= &size * &size * length
        });
        inside.then_some(t)
    }
}
