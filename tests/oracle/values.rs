//! Bounds of values: never exceeded, and not so wide that they would hide anything.

use glam::{DVec2, DVec3};
use heliodon::math::{
    Crossing, Decisions, Departure, Flat, Frame, Point, Ray, Rectangle, Span, unit,
};

use heliodon::surface::{Common, Sphere, Surface};

use super::cases;
use super::equality::{SEED, cases as count};
use super::random::{Random, Style};
use super::rational::{Vector, number, rounded};
use super::tally::Tally;
use super::truth::{self, Distance};

/// Half of the distance from 1 to the next double.
const UNIT: f64 = f64::EPSILON / 2.0;

/// A bound that is never used to more than this share would be too wide.
const LEAST_USE: f64 = 0.3;

/// The same for hit points, whose bound is that of two distances and more: one for each of the two
/// quotients of moments that a rectangle computes, which never are both off the farthest.
const LEAST_USE_OF_POINTS: f64 = 0.2;

/// The same for balls, whose bound is one for ellipsoids, too: these have twice as many roundings.
const LEAST_USE_OF_BALLS: f64 = 0.05;

/// A plane and a ray, as numbers that can be changed a little.
#[derive(Debug, Clone, Copy)]
struct Place {
    point: DVec3,
    normal: DVec3,
    /// The normal of a neighbour in the same plane, which decides, less this one's.
    tilt: DVec3,
    anchor: DVec3,
    offset: DVec3,
    dir: DVec3,
}

impl Place {
    fn any(random: &mut Random) -> Self {
        let direction = |random: &mut Random| unit(random.cube()).unwrap_or(DVec3::X);
        let normal = direction(random);
        let dir = if random.once_in(2) {
            direction(random)
        } else {
            unit(normal + random.cube() * random.power(-20, -2)).unwrap_or(normal)
        };
        // The rounding of a difference is largest where both terms are there and add up.
        let anchor = if random.once_in(4) {
            -dir
        } else {
            random.cube()
        };
        Self {
            point: anchor * -random.share(),
            normal,
            tilt: random.cube() * (2.0 * UNIT),
            anchor,
            offset: random.cube() * random.power(-30, 0),
            dir,
        }
    }

    /// The same but for one number.
    fn changed(mut self, random: &mut Random) -> Self {
        let axis = random.below(3) as usize;
        // Of the order of a rounding, so that others stay as they are, or of any.
        let most = random.pick(&[-48, -48, 0]);
        let step = random.signed() * random.power(-56, most);
        match random.below(6) {
            0 => self.point[axis] += step,
            1 => self.normal[axis] += step,
            2 => self.anchor[axis] += step,
            3 => self.offset[axis] += step,
            4 => self.tilt[axis] = random.signed() * 2.0 * UNIT,
            _ => self.dir[axis] += step,
        }
        if most == 0 {
            self.normal = unit(self.normal).unwrap_or(DVec3::X);
            self.dir = unit(self.dir).unwrap_or(DVec3::X);
        }
        self
    }

    /// Whether both directions are as long as unit vectors come out.
    fn is_unit(&self) -> bool {
        let is_unit = |vector: DVec3| (vector.length_squared() - 1.0).abs() <= 6.0 * UNIT;
        is_unit(self.normal) && is_unit(self.dir)
    }

    fn flat(&self) -> Flat {
        let neighbor = Flat::with_unit_normal(self.point, self.normal + self.tilt);
        Flat::with_unit_normal(self.point, self.normal).welded(&neighbor)
    }

    fn ray(&self) -> Ray<'static> {
        let Self { anchor, offset, .. } = *self;
        Ray::new(Point { anchor, offset }, self.dir)
    }
}

/// Looks for the largest share of a bound: the best of some places, changed as long as it gets
/// larger.
fn largest(seed: u64, share: impl Fn(&Place) -> Option<f64>) -> f64 {
    const STARTS: u64 = 400;
    const STEPS: u64 = 30_000;
    let mut random = Random::of(SEED, seed);
    let mut best = (0.0, Place::any(&mut random));
    for step in 0..STARTS + STEPS {
        let place = if step < STARTS {
            Place::any(&mut random)
        } else {
            best.1.changed(&mut random)
        };
        if !place.is_unit() {
            continue;
        }
        let Some(share) = share(&place) else {
            continue;
        };
        assert!(share <= 1.0, "{share} times the bound: {place:?}");
        if share > best.0 {
            best = (share, place);
        }
    }
    best.0
}

/// Fails if the bound is exceeded, or if the share of it that is found is not this large.
fn is_used(what: &str, least: f64, share: impl Fn(&Place) -> Option<f64>) {
    let found = (0..4).map(|seed| largest(seed, &share)).fold(0.0, f64::max);
    println!("largest share of the error of {what}: {found}");
    assert!(
        found > least,
        "{what}: only {found} of the bound is ever used"
    );
}

#[test]
fn distances_are_within_their_bound_which_is_used() {
    is_used("t", LEAST_USE, |place| {
        let (flat, ray) = (place.flat(), place.ray());
        let (t, error) = flat.hits(&ray, Span::AHEAD)?;
        let exact = truth::crosses(&flat, &ray)?;
        Some(Distance::Quotient(exact).share_of_error(t, error))
    });
}

#[test]
fn heights_are_within_their_bound_which_is_used() {
    is_used("N", LEAST_USE, |place| {
        let (flat, ray) = (place.flat(), place.ray());
        let crossing = flat.crossing(&ray)?;
        let way = Vector::to(&ray.origin).minus(&Vector::of(flat.point));
        let apart = number(crossing.height) + Vector::of(flat.decisive_normal()).dot(&way);
        Some(rounded(&apart).abs() / crossing.doubt)
    });
}

#[test]
fn slopes_are_within_their_bound_which_is_used() {
    let bound = slope_bound();
    is_used("D", LEAST_USE, |place| {
        let flat = place.flat();
        let crossing = flat.crossing(&place.ray())?;
        let exact = Vector::of(flat.decisive_normal()).dot(&Vector::of(place.dir));
        Some(rounded(&(number(crossing.slope) - exact)).abs() / bound)
    });
}

#[test]
fn moments_are_within_their_bound_which_is_used() {
    let bound = moment_bound();
    is_used("v·(d × c)", LEAST_USE, |place| {
        let (c, size) = place.ray().origin.seen_from(place.point);
        let moment = place.normal.dot(place.dir.cross(c));
        let way = Vector::to(&place.ray().origin).minus(&Vector::of(place.point));
        let exact = Vector::of(place.normal).dot(&Vector::of(place.dir).cross(&way));
        Some(rounded(&(number(moment) - exact)).abs() / (bound * size))
    });
}

/// Those of rectangles, which are quotients of moments, have the most roundings. The formula is that
/// of `Rectangle`, whose axes would be rounded anew for each change.
#[test]
fn points_are_within_their_bound_which_is_used() {
    is_used("hit points of rectangles", LEAST_USE_OF_POINTS, |place| {
        let (flat, ray) = (place.flat(), place.ray());
        let crossing = flat.crossing(&ray)?;
        let x = unit(place.normal.any_orthonormal_vector())?;
        let y = unit(place.normal.cross(x))?;
        let moment = ray.dir.cross(crossing.origin) / crossing.slope;
        let point = Point {
            anchor: flat.point,
            offset: x * y.dot(moment) - y * x.dot(moment),
        };
        let error = crossing.error(crossing.distance());
        Some(share_of_rounding(&flat, &ray, point, error))
    });
    is_used("hit points of planes", LEAST_USE_OF_POINTS, |place| {
        let (flat, ray) = (place.flat(), place.ray());
        let (t, error) = flat.hits(&ray, Span::AHEAD)?;
        Some(share_of_rounding(&flat, &ray, flat.foot(&ray, t), error))
    });
}

/// And as they are met, of every kind of flat surface.
#[test]
fn points_of_rectangles_and_triangles_are_within_their_bound() {
    let (mut worst, mut met) = (0f64, 0);
    for case in 0..count() {
        let mut random = Random::of(SEED, case);
        let surface = cases::surface(&mut random, Style::Uniform, 1.0);
        let Some(flat) = surface.flat() else { continue };
        for _ in 0..8 {
            let dir = unit(random.cube()).unwrap_or(DVec3::X);
            let ray = Ray::new(Point::exact(random.cube() * 2.0), dir);
            let Some(hit) = surface.hits(&ray, Span::AHEAD) else {
                continue;
            };
            met += 1;
            let share = share_of_rounding(flat, &ray, hit.point, hit.error);
            assert!(share <= 1.0, "{share} times the bound: {surface:?} {ray:?}");
            worst = worst.max(share);
        }
    }
    println!("largest share of the error of {met} hit points of all kinds: {worst}");
    assert!(met > count() / 10, "{met}");
}

/// How far a hit point lies from where it ought to, in units of what is said of that.
fn share_of_rounding(flat: &Flat, ray: &Ray, point: Point, error: f64) -> f64 {
    let exact = truth::crosses(flat, ray).expect("it was met");
    let met = Vector::to(&ray.origin).plus(&Vector::of(ray.dir).times(&exact));
    let apart = Vector::to(&point).minus(&met).rounded().length();
    apart / Departure::new((None, None), ray, point, error).rounding()
}

#[test]
fn distances_of_balls_are_within_their_bound_which_is_used() {
    is_used("t of balls", LEAST_USE_OF_BALLS, |place| {
        let radius = place.normal.x.abs() * (place.point - place.anchor).length();
        let ball = Sphere::new(Common::black(None, None), place.point, radius, None).ok()?;
        let ray = place.ray();
        let hit = ball.hits(&ray, Span::AHEAD)?;
        let exact = truth::meets(&ball, &ray)?;
        Some(exact.share_of_error(hit.t, hit.error))
    });
}

/// Each bound is at least what the longest path of its expression can round, in the worst case of
/// all roundings at once, which no search finds.
#[test]
fn no_bound_is_smaller_than_its_proof() {
    let crossing = |slope: f64| Crossing {
        origin: DVec3::ZERO,
        height: 0.0,
        slope,
        rises: true,
        doubt: 0.0,
        at_start: None,
        grazing: None,
    };
    let quotient = crossing(2f64.powi(100)).error(1.0);
    let flat = Flat::with_unit_normal(DVec3::ZERO, DVec3::Z);
    let down = |point: DVec3| Ray::new(Point::exact(point), DVec3::NEG_Z);
    let height = flat.crossing(&down(DVec3::Z)).expect("a plane below").doubt;
    let foot = Departure::new(
        (None, None),
        &down(DVec3::Z),
        Point::exact(DVec3::ZERO),
        0.0,
    )
    .rounding();
    let least = [
        (
            "D: a product, two sums, and the neighbour's normal",
            slope_bound(),
            5.0,
        ),
        (
            "N: two roundings of c, a product, two sums, and that normal",
            height,
            7.0,
        ),
        (
            "v·(d × c): two more products and a difference",
            moment_bound(),
            7.0,
        ),
        (
            "w D − x: a product, a difference and those of D",
            extent_bound(),
            5.0,
        ),
        ("t: more than the quotient's", quotient, 1.0),
        ("the foot of a hit: see Flat::foot", foot, 6.0),
    ];
    for (what, bound, roundings) in least {
        let bound = bound / UNIT;
        assert!(
            bound > roundings,
            "{what}: {roundings} u, and the bound is {bound} u"
        );
    }
}

/// The bound of a moment's error in units of `size`.
fn moment_bound() -> f64 {
    first_certain(2f64.powi(-20), 1.0)
}

/// What the size of a rectangle adds to that, in units of its size.
fn extent_bound() -> f64 {
    first_certain(1.0, 2f64.powi(-40))
}

/// Where the filter of a square begins to be certain of a ray that comes down from a height beside
/// its lower left corner.
fn first_certain(side: f64, height: f64) -> f64 {
    let square = Rectangle::new(DVec3::ZERO, DVec3::Z, DVec3::X, DVec2::splat(side));
    let square = square.expect("a square");
    let is_certain = |place: f64| {
        let from = DVec3::new(place, place, height);
        let before = Decisions::of_this_thread();
        let hit = square.hits(&Ray::new(Point::exact(from), DVec3::NEG_Z), Span::AHEAD);
        assert!(hit.is_some(), "{place}");
        Decisions::of_this_thread() == before
    };
    let (mut low, mut high) = (0.0, side * 2f64.powi(-20));
    assert!(
        is_certain(high) && !is_certain(low),
        "all or none is certain"
    );
    while high - low > 0.01 * UNIT {
        let middle = 0.5 * (low + high);
        if is_certain(middle) {
            high = middle;
        } else {
            low = middle;
        }
    }
    high
}

/// The bound of the slope's error, read off the error of a distance where nothing else counts.
fn slope_bound() -> f64 {
    let slope = 2f64.powi(-100);
    let crossing = Crossing {
        origin: DVec3::ZERO,
        height: 0.0,
        slope,
        rises: true,
        doubt: 0.0,
        at_start: None,
        grazing: None,
    };
    crossing.error(1.0) * slope
}

#[test]
fn unit_vectors_are_unit() {
    let mut worst = [0f64; 2];
    let far = |random: &mut Random| {
        let exponent = f64::from(random.between(-300, 300));
        let decimal: f64 = format!("{:e}", 10f64.powf(exponent))
            .parse()
            .expect("a number");
        random.cube() * decimal
    };
    for case in 0..count() / 10 {
        let mut random = Random::of(SEED, case);
        let given = [far(&mut random), far(&mut random)];
        let Ok(frame) = Frame::new(given[0], given[1]) else {
            continue;
        };
        let flat = Flat::new(DVec3::ZERO, given[0]).expect("a normal that is not zero");
        let axes = [flat.normal, frame.x, frame.y];
        let dot = |a: DVec3, b: DVec3| Vector::of(a).dot(&Vector::of(b));
        for (index, axis) in axes.into_iter().enumerate() {
            let next = axes[(index + 1) % 3];
            let length = rounded(&(dot(axis, axis) - number(1.0))).abs() / UNIT;
            let right = rounded(&dot(axis, next)).abs() / UNIT;
            worst = [worst[0].max(length), worst[1].max(right)];
        }
        let any = unit(given[0]).expect("a vector that is not zero");
        let length = rounded(&(dot(any, any) - number(1.0))).abs() / UNIT;
        worst[0] = worst[0].max(length);
    }
    println!(
        "|n|² − 1 is up to {} u, the axes' products up to {} u",
        worst[0], worst[1]
    );
    assert!(worst[0] <= 8.0, "a length is off by more than 4 u");
    assert!(worst[1] <= 2.0, "axes are not at right angles");
}

#[test]
fn random_rays_need_no_exact_arithmetic() {
    let mut tally = Tally::default();
    let mut rays = 0u64;
    for scene in 0..count().div_ceil(10) {
        let mut random = Random::of(SEED, scene);
        let surface = cases::surface(&mut random, Style::Uniform, 1.0);
        tally.observe_within(|_| {
            for _ in 0..1000 {
                let dir = unit(random.cube()).unwrap_or(DVec3::X);
                let ray = Ray::new(Point::exact(random.cube() * 4.0), dir);
                rays += u64::from(
                    surface
                        .hits(&ray, Span::AHEAD)
                        .is_none_or(|hit| hit.t > 0.0),
                );
            }
        });
    }
    println!(
        "{} of {rays} random rays were decided exactly",
        tally.exactly + tally.by_rule
    );
    assert_eq!(tally.exactly + tally.by_rule, 0, "of {rays} random rays");
}

/// One random ray in 10⁸ runs nearly along a given plane. It is decided by rounded values too,
/// unless it passes within rounding of a border.
#[test]
fn random_rays_nearly_along_a_plane_need_hardly_any_exact_arithmetic() {
    let (mut tally, mut rays) = (Tally::default(), 0);
    for scene in 0..count() / 10 {
        let mut random = Random::of(SEED, scene);
        let surface = cases::surface(&mut random, Style::Uniform, 1.0);
        let Some(flat) = surface.flat().copied() else {
            continue;
        };
        tally.observe_within(|_| {
            for _ in 0..20 {
                let way = random.cube();
                let along = unit(way - flat.normal * flat.normal.dot(way));
                let tilt = flat.normal * (random.signed() * random.power(-30, -27));
                let dir = unit(along.unwrap_or(DVec3::X) + tilt).unwrap_or(DVec3::X);
                let ray = Ray::new(Point::exact(random.cube() * 4.0), dir);
                surface.hits(&ray, Span::AHEAD);
                rays += 1;
            }
        });
    }
    let exactly = tally.exactly + tally.by_rule;
    println!("{exactly} of {rays} random rays nearly along a plane were decided exactly");
    assert!(exactly * 1000 < rays, "{exactly} of {rays}");
}
