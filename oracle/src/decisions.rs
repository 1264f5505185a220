//! The checks that compare production's decisions with exact ones, one case at a time.

use std::cmp::Ordering;
use std::sync::Arc;

use glam::{DVec2, DVec3};
use heliodon::geometry::{Hit, Plane};
use heliodon::math::{Point, Ray, RayOrigin, Rgb, Segment, Side, Span};
use heliodon::surface::Surface;
use heliodon::visibility::{Accelerator, Emitter, LightView, Occlusion, Silhouettes, SurfaceList};

use crate::cases::{self, Boxed};
use crate::rational::{Vector, number, rounded, sign};
use crate::tally::Tally;
use crate::truth::{self, Distance};
use support::random::Random;

/// Beyond this, a distance is no longer a finite double for certain.
const FARTHEST: f64 = 1e300;

/// The tallies of random and of aimed rays.
#[derive(Debug, Clone, Default)]
pub struct Tallies {
    /// Of rays in any direction.
    pub random: Tally,
    /// Of rays at edges, corners and rims.
    pub aimed: Tally,
}

impl Tallies {
    fn of(&mut self, aimed: bool) -> &mut Tally {
        if aimed {
            &mut self.aimed
        } else {
            &mut self.random
        }
    }
}

/// How far a hit's distance is off, as a share of its error bound.
pub type Shares<'a> = &'a mut dyn FnMut(&dyn Surface, f64);

/// Whether a ray meets a surface, and how far from the exact place.
pub fn meeting(random: &mut Random, tallies: &mut Tallies, shares: Shares) {
    let (style, scale) = (random.style(), cases::scale(random));
    let surface = cases::surface(random, style, scale);
    let (ray, aimed) = cases::ray(random, &*surface, style, scale);
    check_meeting(&*surface, &ray, tallies.of(aimed), shares);
    check_tree(&[surface], &ray, tallies.of(aimed));
}

/// A tree of boxes never leaves out what is met: it finds what a list does.
fn check_tree(surfaces: &[Boxed], ray: &Ray, tally: &mut Tally) {
    let found = [Accelerator::List, Accelerator::Tree].map(|accelerator| {
        let list = SurfaceList::with(surfaces, accelerator);
        let found = list.nearest(ray, Span::AHEAD, &mut 0);
        found.map(|(entry, hit)| (entry.index, hit))
    });
    if found[0] != found[1] {
        tally.wrong(|| format!("the tree loses {ray:?} and {surfaces:?}"));
    }
}

/// Compares one ray and one surface.
pub fn check_meeting(surface: &dyn Surface, ray: &Ray, tally: &mut Tally, shares: Shares) {
    let exact = truth::meets(surface, ray);
    if exact.as_ref().is_some_and(|at| at.approximate() > FARTHEST) {
        return;
    }
    let hit = tally.observe(|| surface.hits(ray, Span::AHEAD));
    tally.compare(&hit.is_some(), &exact.is_some(), exact.is_some(), || {
        format!("{ray:?} and {surface:?}")
    });
    if let (Some(hit), Some(exact)) = (hit, exact) {
        let share = exact.share_of_error(hit.t, hit.error);
        shares(surface, share);
        if share > 1.0 {
            tally.wrong(|| {
                format!(
                    "t = {} is off by {share} times {}: {ray:?} and {surface:?}",
                    hit.t, hit.error
                )
            });
        }
    }
}

/// On which side of a surface a point is; half of the points are on it, but for rounding.
pub fn side(random: &mut Random, tallies: &mut Tallies) {
    let (style, scale) = (random.style(), cases::scale(random));
    let surface = cases::surface(random, style, scale);
    let (ray, aimed) = cases::ray(random, &*surface, style, scale);
    let mut point = ray.origin;
    if aimed && let Some(exact) = truth::meets(&*surface, &ray) {
        let way = Vector::of(ray.dir * exact.approximate().min(FARTHEST));
        point.offset = random.nudged(way.plus(&Vector::of(point.offset)).rounded(), 3);
    }
    let exact = match surface.shape().round() {
        Some([center, axes]) => truth::side_of_round(center, axes, &point),
        None => truth::side(surface.shape().carrier().expect("a flat surface"), &point),
    };
    let tally = tallies.of(aimed);
    let decided = tally.observe(|| surface.shape().side(&point));
    let exact = [Side::Back, Side::On, Side::Front][usize::from((exact + 1).unsigned_abs())];
    tally.compare(&decided, &exact, exact == Side::On, || {
        format!("{point:?} and {surface:?}")
    });
}

/// Which of a few surfaces a ray meets first. Aimed ones pass through one place of the ray, or
/// nearly, at any angle.
pub fn nearest(random: &mut Random, tallies: &mut Tallies) {
    let (style, scale) = (random.style(), cases::scale(random));
    let first = cases::surface(random, style, scale);
    let (ray, _) = cases::ray(random, &*first, style, scale);
    let aimed = random.once_in(2);
    let place = first.hits(&ray, Span::AHEAD).map(|hit| hit.point.world());
    let mut surfaces = vec![first];
    for _ in 0..random.between(1, 3) {
        surfaces.push(match place.filter(|_| aimed) {
            Some(place) => through(random, place, &ray),
            None => cases::surface(random, style, scale),
        });
    }
    let last = surfaces.len() - 1;
    surfaces.swap(0, random.below(2) as usize * last);
    check_nearest(&surfaces, &ray, tallies.of(aimed));
}

/// A plane through a place on a ray that it meets at any angle.
fn through(random: &mut Random, place: DVec3, ray: &Ray) -> Boxed {
    let across = random.cube();
    let across = across - ray.dir * ray.dir.dot(across);
    let normal = across + ray.dir * random.power(-30, 0);
    let place = random.nudged(place, 3);
    cases::boxed(Plane::new(place, normal).expect("a normal that is not zero"))
}

fn check_nearest(surfaces: &[Boxed], ray: &Ray, tally: &mut Tally) {
    let mut exact: Option<(usize, Distance)> = None;
    for (index, surface) in surfaces.iter().enumerate() {
        let Some(distance) = truth::meets(&**surface, ray) else {
            continue;
        };
        if distance.approximate() > FARTHEST {
            return;
        }
        let nearer = exact
            .as_ref()
            .is_none_or(|(_, best)| distance.compare(best) == Ordering::Less);
        if nearer {
            exact = Some((index, distance));
        }
    }
    check_tree(surfaces, ray, tally);
    let list = SurfaceList::new(surfaces);
    let decided = tally.observe(|| {
        list.nearest(ray, Span::AHEAD, &mut 0)
            .map(|(entry, _)| entry.index)
    });
    let exact = exact.map(|(index, _)| index);
    tally.compare(&decided, &exact, exact.is_some(), || {
        format!("{ray:?} and {surfaces:?}")
    });
}

/// Whether a surface stands between two points.
///
/// A start that is within rounding of a plane has no side of its own, so such cases are left to
/// the closed rooms.
pub fn occlusion(random: &mut Random, tallies: &mut Tallies) {
    let (style, scale) = (random.style(), cases::scale(random));
    let surface = cases::surface(random, style, scale);
    let (ray, aimed) = cases::ray(random, &*surface, style, scale);
    let reach = truth::meets(&*surface, &ray).map_or(scale, |at| at.approximate());
    let factor = random.pick(&[0.5, 0.99, 1.0, 1.01, 2.0, 1000.0]);
    if reach * factor >= 1e100 {
        return;
    }
    let end = match (surface.shape().carrier(), surface.shape().round()) {
        // Nearly along the plane, from one side of it to the other.
        (Some(flat), _) if random.once_in(4) => {
            let height = flat.normal.dot(ray.origin.from(flat.point));
            let along = ray.dir - flat.normal * flat.normal.dot(ray.dir);
            let far = height.abs() * random.power(10, 70);
            ray.origin.world() + along * far - flat.normal * (2.0 * height)
        }
        // Where the surface ends for the eye.
        (_, Some([center, axes])) if random.once_in(4) => {
            cases::rim(random, center, axes, ray.origin.world())
        }
        _ => ray.at(reach * factor).world(),
    };
    let end = random.nudged(end, 3);
    let arriving = Ray::new(Point::exact(ray.origin.world()), DVec3::Z);
    let ray_origin = RayOrigin::new((None, None), &arriving, ray.origin, 0.0);
    let Some(segment) = Segment::new(&ray_origin, end) else {
        return;
    };
    let Some(exact) = hides(&*surface, &segment, ray_origin.rounding()) else {
        return;
    };
    let tally = tallies.of(aimed);
    let side = surface.shape().side(&Point::exact(end));
    let decided = tally.observe(|| surface.shape().occludes(&segment, side));
    tally.compare(&decided, &exact, exact, || {
        format!("{segment:?} and {surface:?}")
    });
    let surfaces = [surface];
    // Of the hit nothing counts where all casters are asked.
    let hit = Hit {
        t: 1.0,
        error: 0.0,
        point: ray.origin,
        normal: DVec3::Z,
        uv: DVec2::ZERO,
        texel: Rgb::WHITE,
    };
    let passed = [Accelerator::List, Accelerator::Tree].map(|accelerator| {
        let list = SurfaceList::with(&surfaces, accelerator);
        let silhouettes = Arc::new(Silhouettes::new(surfaces.len()));
        let light = Emitter::Point(end);
        let view = LightView::new(&list, &silhouettes, light, true, |_| true);
        let receiver = view.receiver(&list.primitives()[0]);
        let occlusion = receiver.map(|it| it.occlusion(&hit, &segment.ray));
        match occlusion {
            None | Some(Occlusion::None) => Rgb::WHITE,
            Some(Occlusion::Full) => Rgb::BLACK,
            Some(Occlusion::Partial(occluders)) => occluders.transmittance(&segment, &mut 0),
        }
    });
    if passed[0] != passed[1] {
        tally.wrong(|| format!("the tree loses the shadow of {segment:?} and {surfaces:?}"));
    }
}

/// A surface that is decided by the plane and the line of a neighbour, which lie as far away as
/// those that are welded may; asked from close to that neighbour.
pub fn welded(random: &mut Random, tallies: &mut Tallies) {
    let (surface, ray) = if random.once_in(2) {
        cases::welded_rectangle(random)
    } else {
        cases::welded_triangle(random)
    };
    let flat = surface.shape().carrier().expect("a flat surface");
    let exact = truth::side(flat, &ray.origin);
    let tally = &mut tallies.aimed;
    let decided = tally.observe(|| surface.shape().side(&ray.origin));
    let exact = [Side::Back, Side::On, Side::Front][usize::from((exact + 1).unsigned_abs())];
    tally.compare(&decided, &exact, exact == Side::On, || {
        format!("{:?} and {surface:?}", ray.origin)
    });
    check_meeting(&*surface, &ray, tally, &mut |_, _| ());
    check_tree(&[surface], &ray, tally);
}

/// Whether the surface hides the ends of a segment from each other; `None` where the start is too
/// close to tell.
fn hides(surface: &dyn Surface, segment: &Segment, rounding: f64) -> Option<bool> {
    let (start, end) = (segment.ray.origin, segment.end);
    let Some(flat) = surface.shape().carrier() else {
        return hides_behind_round(surface, segment, rounding);
    };
    let [base, normal] = flat.decisive().map(Vector::of);
    let height = rounded(&normal.dot(&Vector::to(&start).minus(&base))).abs();
    let size = start.size() + flat.point.abs().element_sum();
    if height <= 2.0 * rounding + 1e-13 * size + f64::MIN_POSITIVE {
        return None;
    }
    let sides = truth::side(flat, &start) * truth::side(flat, &end);
    if sides >= 0 {
        return Some(false);
    }
    // The direction of a segment so flat that rounding turns it the other way says nothing.
    let rises = truth::side(flat, &end);
    let rise = Vector::of(flat.decisive_normal()).dot(&Vector::of(segment.ray.dir));
    (sign(&rise) == rises).then(|| {
        truth::passes_inside(
            flat,
            surface.shape().planar().map_or(&[], |it| it.borders()),
            &segment.ray,
        )
    })
}

fn hides_behind_round(surface: &dyn Surface, segment: &Segment, rounding: f64) -> Option<bool> {
    let [center, axes] = surface.shape().round()?;
    let Some(entry) = truth::meets(surface, &segment.ray) else {
        return Some(false).filter(|_| truth::side_of_round(center, axes, &segment.ray.origin) > 0);
    };
    let Distance::Root(_) = entry else {
        return None;
    };
    let size = segment.ray.origin.size() + center.abs().element_sum() + axes.element_sum();
    let near = entry.compare(&Distance::Quotient(number(2.0 * rounding + 1e-6 * size)));
    if near != Ordering::Greater {
        return None;
    }
    let end = Vector::to(&segment.end)
        .minus(&Vector::of(center))
        .over(axes);
    let inside = truth::side_of_round(center, axes, &segment.end) < 0;
    let beyond = sign(&end.dot(&Vector::of(segment.ray.dir).over(axes))) > 0;
    Some(inside || beyond)
}
