//! The light of a lamp: how much arrives where, and from which of its points.

use std::f64::consts::PI;

use glam::{DVec2, DVec3};

use super::lamp_form::LampForm;
use super::{FinitePlane, Lamp, Sphere, Surface};
use crate::math::{Frame, Point, Side, direction, form_factor};

impl Lamp {
    /// Those of a rectangle of width and height 1, in order around it.
    const CORNERS: [DVec2; 4] = [DVec2::ZERO, DVec2::X, DVec2::ONE, DVec2::Y];

    /// How much light arrives at a place with this unit normal if nothing stands in the way, as a
    /// share of what a sky as bright would give: from 0 to 1.
    #[must_use]
    pub fn form_factor(&self, place: &Point, normal: DVec3) -> f64 {
        // 2¹⁷. Beyond as many times its own size, a lamp is taken for a speck of light, which is off
        // by one in 2¹⁷ of what a lamp there can give at most; nearer, the sums of angles are off by
        // one in 2³⁶, since that is what is left of them when they cancel.
        const FAR: f64 = 131_072.0;
        if self.side(place) != Side::Front {
            return 0.0;
        }
        let center = self.center().way_from(place);
        let is_far = center.length() > FAR * self.reach();
        match &self.form {
            LampForm::Pane(pane) => {
                let rectangle = pane.rectangle();
                if is_far {
                    let slant = -rectangle.flat.normal.dot(direction(center));
                    let area = rectangle.size.x * rectangle.size.y;
                    return form_factor::of_speck(center, area * slant.max(0.0), normal);
                }
                let corners = Self::CORNERS.map(|corner| self.on_pane(pane, corner));
                form_factor::of_polygon(&corners.map(|corner| corner.way_from(place)), normal)
            }
            LampForm::Globe(_) if is_far => {
                form_factor::of_speck(center, PI * self.reach() * self.reach(), normal)
            }
            LampForm::Globe(_) => form_factor::of_ball(center, self.reach(), normal),
        }
    }

    fn on_pane(&self, pane: &FinitePlane, at: DVec2) -> Point {
        let rectangle = pane.rectangle();
        rectangle.point(at * rectangle.size)
    }

    /// Its middle.
    #[must_use]
    pub fn center(&self) -> Point {
        match &self.form {
            LampForm::Pane(pane) => self.on_pane(pane, DVec2::splat(0.5)),
            LampForm::Globe(globe) => Point::exact(globe.center()),
        }
    }

    /// How far it reaches from its middle.
    #[must_use]
    pub fn reach(&self) -> f64 {
        match &self.form {
            LampForm::Pane(pane) => pane.rectangle().size.length() / 2.0,
            LampForm::Globe(globe) => globe.radius(),
        }
    }

    /// One of its points that a place in front of it sees, and what that point counts for, which is
    /// not negative; `at` chooses it, from 0 to 1 along two axes.
    ///
    /// The places of a rectangle are chosen evenly over its area, and those of a ball evenly over the
    /// disc that is seen of it from afar. Each counts for the light that the piece of lamp around it
    /// gives, so that the sum of what is seen by the sum of all is the share of the *light* that
    /// arrives.
    #[must_use]
    pub fn sample(&self, place: &Point, normal: DVec3, at: DVec2) -> (Point, f64) {
        let (point, front, stretch) = match &self.form {
            LampForm::Pane(pane) => (self.on_pane(pane, at), pane.rectangle().flat.normal, 1.0),
            LampForm::Globe(globe) => on_globe(globe, place, at),
        };
        let way = point.way_from(place);
        let distance = way.length();
        let dir = way / distance;
        let weight = normal.dot(dir).max(0.0) * (-front.dot(dir)).max(0.0);
        // A place on the lamp itself is not in front of it.
        let weight = weight / distance / distance / stretch;
        (point, if weight.is_finite() { weight } else { 0.0 })
    }

    /// The point of it that is highest along a direction.
    #[must_use]
    pub fn highest(&self, normal: DVec3) -> Point {
        match &self.form {
            LampForm::Pane(pane) => {
                let frame = pane.rectangle().frame;
                let end = |axis: DVec3| if axis.dot(normal) > 0.0 { 1.0 } else { 0.0 };
                self.on_pane(pane, DVec2::new(end(frame.x), end(frame.y)))
            }
            LampForm::Globe(globe) => Point {
                anchor: globe.center(),
                offset: normal * globe.radius(),
            },
        }
    }
}

/// The point of a ball that `at` chooses evenly over the disc which a place sees of it; its unit normal;
/// and the cosine between ball and disc there, which areas of the disc are smaller by.
#[inline]
fn on_globe(globe: &Sphere, place: &Point, at: DVec2) -> (Point, DVec3, f64) {
    let way = place.from(globe.center());
    let (distance, radius) = (way.length(), globe.radius());
    let axis = direction(way);
    let frame = Frame::any(axis);
    let seen = (distance - radius).max(0.0) * (distance + radius) / distance / distance;
    let (sine, cosine) = ((at.x * seen).sqrt(), (1.0 - at.x * seen).sqrt());
    let turn = 2.0 * PI * at.y;
    let across = frame.x * libm::cos(turn) + frame.y * libm::sin(turn);
    // So that a scene turned by half a turn about an axis is asked at the same places.
    let is_turned = axis.x < 0.0 || axis.x == 0.0 && axis.y * axis.z < 0.0;
    let across = if is_turned { -across } else { across };
    let front = axis * cosine + across * sine;
    let point = Point {
        anchor: globe.center(),
        offset: front * radius,
    };
    (point, front, cosine)
}
