//! What exact arithmetic says: the decisions that production has to take.
//!
//! The stored doubles are the definition: unit normal, border lines, centre and axes, and the
//! ray's anchor, offset and direction. The formulas are others than the production's: the point where
//! a ray crosses a plane is computed, the point of a line nearest to a centre, and roots are told
//! apart by intervals.

use std::cmp::Ordering;

use dashu_ratio::RBig;
use glam::DVec3;
use heliodon::math::{Flat, Line, Point, Ray};
use heliodon::surface::Surface;

use crate::rational::{Vector, number, rounded, sign};

/// How far along a ray something is.
#[derive(Debug, Clone)]
pub enum Distance {
    /// Of a plane.
    Quotient(RBig),
    /// Of a round surface.
    Root(Parabola),
}

/// `a t² − 2 b t + c`: how far outside of a round surface a ray is at `t`.
#[derive(Debug, Clone)]
pub struct Parabola {
    a: RBig,
    b: RBig,
    c: RBig,
}

/// Where a ray first meets a surface, if it does.
pub fn meets(surface: &dyn Surface, ray: &Ray) -> Option<Distance> {
    if let Some([center, axes]) = surface.shape().round() {
        return enters(center, axes, ray).map(Distance::Root);
    }
    let flat = surface
        .shape()
        .carrier()
        .expect("a flat surface or a round one");
    let t = crosses(flat, ray).filter(|t| sign(t) > 0)?;
    passes_inside(
        flat,
        surface.shape().planar().map_or(&[], |it| it.borders()),
        ray,
    )
    .then_some(Distance::Quotient(t))
}

/// Where the line of a ray crosses a plane, behind its origin too.
pub fn crosses(flat: &Flat, ray: &Ray) -> Option<RBig> {
    let [base, normal] = flat.decisive().map(Vector::of);
    let slope = normal.dot(&Vector::of(ray.dir));
    let way = base.minus(&Vector::to(&ray.origin));
    (sign(&slope) != 0).then(|| normal.dot(&way) / slope)
}

/// The sign of the height of a point above a plane, on the plane's own front side.
pub fn side(flat: &Flat, point: &Point) -> i8 {
    let [base, _] = flat.decisive().map(Vector::of);
    sign(&Vector::of(flat.decisive_normal()).dot(&Vector::to(point).minus(&base)))
}

/// Whether the line of a ray passes all borders on their inner sides, or through those that are
/// owned.
pub fn passes_inside(flat: &Flat, borders: &[Line], ray: &Ray) -> bool {
    let dir = Vector::of(ray.dir);
    let rise = Vector::of(flat.decisive_normal()).dot(&dir);
    // Nearly along the plane, and decided where the ray crosses it.
    let grazes = flat.decisive_normal().dot(ray.dir).abs() < 2f64.powi(-26);
    borders.iter().all(|border| {
        // The line at the place where the ray crosses the plane through the border's own point.
        let (from, normal) = (Vector::of(border.point), Vector::of(flat.decisive_normal()));
        let origin = Vector::to(&ray.origin);
        let t = normal.dot(&from.minus(&origin)) / &rise;
        let place = origin.plus(&dir.times(&t));
        let along = Vector::of(border.dir).plus(&Vector::of(border.dir_rest));
        if grazes {
            let t = crosses(flat, ray).expect("the ray is not parallel");
            let way = origin.plus(&dir.times(&t)).minus(&from);
            let inward = sign(&(way.dot(&along.cross(&normal)) + number(border.across)));
            return inward > 0 || inward == 0 && border.owned;
        }
        let inward = place.minus(&from).dot(&along.cross(&dir)) + number(border.across) * &rise;
        let inward = sign(&inward) * sign(&rise);
        inward > 0 || inward == 0 && border.owned
    })
}

/// Whether and where a ray enters a round surface from outside.
fn enters(center: DVec3, axes: DVec3, ray: &Ray) -> Option<Parabola> {
    let origin = Vector::to(&ray.origin)
        .minus(&Vector::of(center))
        .over(axes);
    let dir = Vector::of(ray.dir).over(axes);
    let parabola = Parabola {
        a: dir.dot(&dir),
        b: -origin.dot(&dir),
        c: origin.dot(&origin) - RBig::ONE,
    };
    let nearest = origin.plus(&dir.times(&parabola.middle()));
    let outside = sign(&parabola.c) > 0;
    let ahead = sign(&parabola.middle()) > 0;
    (outside && ahead && nearest.dot(&nearest) < RBig::ONE).then_some(parabola)
}

/// Outside, on or inside of a round surface: 1, 0 or −1.
pub fn side_of_round(center: DVec3, axes: DVec3, point: &Point) -> i8 {
    let way = Vector::to(point).minus(&Vector::of(center)).over(axes);
    sign(&(way.dot(&way) - RBig::ONE))
}

impl Distance {
    /// The order of two distances.
    pub fn compare(&self, other: &Self) -> Ordering {
        match (self, other) {
            (Self::Quotient(ours), Self::Quotient(theirs)) => ours.cmp(theirs),
            (Self::Root(ours), Self::Quotient(theirs)) => ours.compare_root(theirs),
            (Self::Quotient(ours), Self::Root(theirs)) => theirs.compare_root(ours).reverse(),
            (Self::Root(ours), Self::Root(theirs)) => ours.compare_roots(theirs),
        }
    }

    /// How far a computed distance is off, in units of the error that it admits.
    pub fn share_of_error(&self, t: f64, error: f64) -> f64 {
        if !error.is_finite() {
            return 0.0;
        }
        let apart = self.near(t, error) - number(t);
        rounded(&(apart / number(error))).abs()
    }

    /// The exact distance, if it is near a computed one, but for a thousandth of the error that this admits.
    ///
    /// If it is further away than twice the error, that is seen as well.
    pub fn near(&self, t: f64, error: f64) -> RBig {
        let parabola = match self {
            Self::Quotient(exact) => return exact.clone(),
            Self::Root(parabola) => parabola,
        };
        let (t, fine) = (number(t), number(error) / RBig::from(1000));
        let around = number(error) * RBig::from(2);
        let (mut low, mut high) = (&t - &around, parabola.middle().min(&t + &around));
        while &high - &low > fine {
            let middle = (&low + &high) / RBig::from(2);
            match parabola.compare_root(&middle) {
                Ordering::Less => high = middle,
                Ordering::Equal | Ordering::Greater => low = middle,
            }
        }
        low
    }

    /// The nearest double, or nearly.
    pub fn approximate(&self) -> f64 {
        match self {
            Self::Quotient(t) => rounded(t),
            Self::Root(parabola) => rounded(&parabola.middle()),
        }
    }
}

impl Parabola {
    /// Where it is lowest.
    fn middle(&self) -> RBig {
        &self.b / &self.a
    }

    fn at(&self, t: &RBig) -> RBig {
        (&self.a * t - RBig::from(2) * &self.b) * t + &self.c
    }

    /// The order of the smaller root and a number.
    fn compare_root(&self, t: &RBig) -> Ordering {
        if t >= &self.middle() {
            return Ordering::Less;
        }
        self.at(t).cmp(&RBig::ZERO)
    }

    /// The order of the smaller roots of two parabolas.
    fn compare_roots(&self, other: &Self) -> Ordering {
        if self.shares_root(other) {
            return Ordering::Equal;
        }
        let (mut low, mut high) = (RBig::ZERO, self.middle());
        loop {
            let middle = (&low + &high) / RBig::from(2);
            let (ours, theirs) = (self.compare_root(&middle), other.compare_root(&middle));
            if ours != theirs {
                return ours.cmp(&theirs);
            }
            if ours == Ordering::Less {
                high = middle;
            } else {
                low = middle;
            }
        }
    }

    /// Whether both have the same smaller root.
    fn shares_root(&self, other: &Self) -> bool {
        // What is left of both when the squares cancel is a line; its zero is the only candidate.
        let slope = RBig::from(2) * (&self.a * &other.b - &other.a * &self.b);
        let height = &self.a * &other.c - &other.a * &self.c;
        if sign(&slope) == 0 {
            return sign(&height) == 0;
        }
        let candidate = height / slope;
        [self, other]
            .iter()
            .all(|one| one.compare_root(&candidate) == Ordering::Equal)
    }
}
