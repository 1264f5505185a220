//! The light of a lamp: the irradiance it gives, and the sample points on it.

use std::f64::consts::PI;

use glam::{DVec2, DVec3};

use super::{Lamp, Surface};
use crate::geometry::{Rectangle, Shape, Sphere};
use crate::math::{Frame, Point, Side, direction, form_factor};

/// The shapes of lamps.
enum Form<'a> {
    Rectangle(&'a Rectangle),
    Ball(&'a Sphere),
}

/// A point on a lamp, with the geometry that its light depends on.
struct LampPoint {
    point: Point,
    /// The unit normal there.
    normal: DVec3,
    /// The area of a sphere's visible disc over that of its surface there.
    ///
    /// It is the cosine of the angle between them, and 1 on a rectangle.
    cosine: f64,
}

impl Lamp {
    /// The corners of a rectangle of width and height 1, in order around it.
    const CORNERS: [DVec2; 4] = [DVec2::ZERO, DVec2::X, DVec2::ONE, DVec2::Y];

    fn form(&self) -> Form<'_> {
        match self.shape() {
            Shape::Rectangle(rectangle) => Form::Rectangle(rectangle),
            Shape::Sphere(sphere) => Form::Ball(sphere),
            other => unreachable!("a lamp is a rectangle or a ball, not {other:?}"),
        }
    }

    /// The share of a full sky's light that the lamp gives to a point, from 0 to 1.
    ///
    /// The point has this unit normal. Occluders do not count.
    #[must_use]
    pub fn form_factor(&self, place: &Point, normal: DVec3) -> f64 {
        // Beyond 2¹⁷ times its own size, a lamp counts as a point light, with an error of 2⁻¹⁷ of
        // the most that it can give there. Nearer, the sums of angles cancel to an error of 2⁻³⁶.
        const FAR: f64 = 131_072.0;
        if self.shape().side(place) != Side::Front {
            return 0.0;
        }
        let center = self.center().way_from(place);
        let is_far = center.length() > FAR * self.radius();
        match self.form() {
            Form::Rectangle(rectangle) if is_far => {
                let slant = -rectangle.flat.normal.dot(direction(center));
                let area = rectangle.size.x * rectangle.size.y;
                form_factor::of_speck(center, area * slant.max(0.0), normal)
            }
            Form::Rectangle(rectangle) => {
                let corners = Self::CORNERS.map(|corner| rectangle.point(corner * rectangle.size));
                form_factor::of_polygon(&corners.map(|corner| corner.way_from(place)), normal)
            }
            Form::Ball(_) if is_far => {
                form_factor::of_speck(center, PI * self.radius() * self.radius(), normal)
            }
            Form::Ball(_) => form_factor::of_ball(center, self.radius(), normal),
        }
    }

    /// The centre of the lamp.
    #[must_use]
    pub fn center(&self) -> Point {
        match self.form() {
            Form::Rectangle(rectangle) => rectangle.point(DVec2::splat(0.5) * rectangle.size),
            Form::Ball(ball) => Point::exact(ball.center()),
        }
    }

    /// The radius of the bounding sphere around the centre.
    #[must_use]
    pub fn radius(&self) -> f64 {
        match self.form() {
            Form::Rectangle(rectangle) => rectangle.size.length() / 2.0,
            Form::Ball(ball) => ball.radius(),
        }
    }

    /// A point of the lamp visible from a point in front of it, and its light's weight.
    ///
    /// `at` chooses it, from 0 to 1 along two axes: evenly over the area of a rectangle, or over
    /// the disc of a sphere that is visible from afar. The weight is not negative. It stands for
    /// the light of the piece of lamp around the point. Visible weight over total weight is
    /// therefore the share of the *light* that arrives.
    #[must_use]
    pub fn sample(&self, place: &Point, normal: DVec3, at: DVec2) -> (Point, f64) {
        let sampled = match self.form() {
            Form::Rectangle(rectangle) => LampPoint {
                point: rectangle.point(at * rectangle.size),
                normal: rectangle.flat.normal,
                cosine: 1.0,
            },
            Form::Ball(ball) => on_ball(ball, place, at),
        };
        let way = sampled.point.way_from(place);
        let distance = way.length();
        let dir = way / distance;
        let weight = normal.dot(dir).max(0.0) * (-sampled.normal.dot(dir)).max(0.0);
        // A point on the lamp itself is not in front of it.
        let weight = weight / distance / distance / sampled.cosine;
        (sampled.point, if weight.is_finite() { weight } else { 0.0 })
    }

    /// The point of the lamp that is highest along a direction.
    #[must_use]
    pub fn highest(&self, normal: DVec3) -> Point {
        match self.form() {
            Form::Rectangle(rectangle) => {
                let end = |axis: DVec3| if axis.dot(normal) > 0.0 { 1.0 } else { 0.0 };
                let corner = DVec2::new(end(rectangle.frame.x), end(rectangle.frame.y));
                rectangle.point(corner * rectangle.size)
            }
            Form::Ball(ball) => Point {
                anchor: ball.center(),
                offset: normal * ball.radius(),
            },
        }
    }
}

/// The point of a sphere that `at` chooses, evenly over the disc that is visible.
#[inline]
fn on_ball(ball: &Sphere, place: &Point, at: DVec2) -> LampPoint {
    let way = place.from(ball.center());
    let (distance, radius) = (way.length(), ball.radius());
    let axis = direction(way);
    let frame = Frame::any(axis);
    let seen = (distance - radius).max(0.0) * (distance + radius) / distance / distance;
    let (sine, cosine) = ((at.x * seen).sqrt(), (1.0 - at.x * seen).sqrt());
    let turn = 2.0 * PI * at.y;
    let across = frame.x * libm::cos(turn) + frame.y * libm::sin(turn);
    // A scene rotated by 180° about an axis is sampled at the same points.
    let is_turned = axis.x < 0.0 || axis.x == 0.0 && axis.y * axis.z < 0.0;
    let across = if is_turned { -across } else { across };
    let normal = axis * cosine + across * sine;
    let point = Point {
        anchor: ball.center(),
        offset: normal * radius,
    };
    LampPoint {
        point,
        normal,
        cosine,
    }
}
