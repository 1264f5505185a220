//! Questions about single rays: what they meet first, how often, and where mirrors send them.

use heliodon::math::Ray;

use super::cases::Node;
use super::numbers::{double, exact, is_close, nearest, of, stepped, triple, words};
use super::oracle::Oracle;
use super::subject::{Met, Stage, Subject, ray};

/// A complaint, or nothing.
pub(crate) type Answer = Result<(), String>;

/// `ray "origin" "direction" …`: what a ray meets, and its neighbours.
pub(crate) fn single(node: &Node, subject: &Subject) -> Answer {
    let [origin, direction] = node.values.as_slice() else {
        panic!("`ray` takes an origin and a direction");
    };
    let stage = subject.stage();
    let oracle = Oracle::new(subject);
    let [origin, direction] = [origin, direction].map(|text| triple(text));
    for index in 0..node.number("repeat").unwrap_or(1u32) {
        let origin = moved(origin, node.get("step"), index);
        let at = move |what: String| {
            if index == 0 {
                what
            } else {
                format!("ray {index}: {what}")
            }
        };
        ask(node, &stage, &oracle, &ray(origin, direction), index).map_err(at)?;
        let Some(most) = node.number::<i32>("nudges") else {
            continue;
        };
        for component in 0..6 {
            for steps in (-most..=most).filter(|steps| *steps != 0) {
                let nudged = nudged((origin, direction), component, steps);
                let answer = neighbour(node, &stage, &oracle, &ray(nudged.0, nudged.1));
                let axis = ["o.x", "o.y", "o.z", "d.x", "d.y", "d.z"][component];
                answer.map_err(|what| at(format!("{axis} moved by {steps} ulp: {what}")))?;
            }
        }
    }
    Ok(())
}

/// The place `index` steps further: the exact sum, rounded once.
fn moved(origin: [f64; 3], step: Option<&str>, index: u32) -> [f64; 3] {
    let Some(step) = step.filter(|_| index > 0) else {
        return origin;
    };
    let step = words::<3>(step).map(exact);
    let axes = [0, 1, 2];
    axes.map(|axis| nearest(&(of(origin[axis]) + &step[axis] * exact(&index.to_string()))))
}

/// A ray with one of its six components moved by some ulp.
pub(crate) fn nudged(
    (mut origin, mut direction): ([f64; 3], [f64; 3]),
    component: usize,
    steps: i32,
) -> ([f64; 3], [f64; 3]) {
    let part = if component < 3 {
        &mut origin
    } else {
        &mut direction
    };
    part[component % 3] = stepped(part[component % 3], steps);
    (origin, direction)
}

/// What a moved ray is asked: the count as it is given, and the first surface by exact arithmetic.
fn neighbour(node: &Node, stage: &Stage, oracle: &Oracle, ray: &Ray<'static>) -> Answer {
    if node.get("count").is_some() {
        count(node, stage, ray)
    } else {
        first("exact", stage.first(ray).as_ref(), ray, oracle).map(|_| ())
    }
}

fn ask(node: &Node, stage: &Stage, oracle: &Oracle, ray: &Ray<'static>, index: u32) -> Answer {
    count(node, stage, ray)?;
    let Some(expected) = node.get("first") else {
        return Ok(());
    };
    let met = stage.first(ray);
    let Some(met) = first(expected, met.as_ref(), ray, oracle)? else {
        return Ok(());
    };
    let within = node.get("within").unwrap_or("8 ulp");
    if let Some(t) = node.get("t")
        && !is_close(met.t(), &exact(t), within)
    {
        return Err(format!(
            "met at t = {:?}, expected {t} within {within}",
            met.t()
        ));
    }
    if let Some(normal) = node.get("normal") {
        let pairs = words::<3>(normal).into_iter().zip(met.normal());
        for (expected, found) in pairs {
            if !is_close(found, &exact(expected), within) {
                return Err(format!(
                    "the normal is {:?}, expected {normal}",
                    met.normal()
                ));
            }
        }
    }
    if let Some(color) = node.get("color") {
        let pairs = words::<3>(color).into_iter().zip(met.color());
        for (expected, found) in pairs {
            if !is_close(found, &exact(expected), within) {
                return Err(format!("the colour is {:?}, expected {color}", met.color()));
            }
        }
    }
    texel(node, met, index)
}

/// The truth about texels: `texel="column row"`, `*` for any, and `texel-step` for each repetition
/// modulo `texel-size`.
pub(crate) fn texel(node: &Node, met: &Met, index: u32) -> Answer {
    let Some(texel) = node.get("texel") else {
        return Ok(());
    };
    let found = met.texel().map(f64::round);
    let steps = words::<2>(node.get("texel-step").unwrap_or("0 0")).map(double);
    let size = words::<2>(node.get("texel-size").unwrap_or("4 4")).map(double);
    for (axis, start) in words::<2>(texel).into_iter().enumerate() {
        if start == "*" {
            continue;
        }
        let moved = double(start) + f64::from(index) * steps[axis];
        let expected = if index == 0 {
            moved
        } else {
            moved.rem_euclid(size[axis])
        };
        #[expect(clippy::float_cmp, reason = "both are whole")]
        if found[axis] != expected {
            let what = ["column", "row"][axis];
            return Err(format!("texel {what} {}, expected {expected}", found[axis]));
        }
    }
    Ok(())
}

/// Whether as many surfaces are met as `count` says.
pub(crate) fn count(node: &Node, stage: &Stage, ray: &Ray<'static>) -> Answer {
    let Some(expected) = node.number::<usize>("count") else {
        return Ok(());
    };
    let met = stage.every(ray);
    if met.len() == expected {
        return Ok(());
    }
    let found = if met.is_empty() {
        "none".to_owned()
    } else {
        met.join(" and ")
    };
    Err(format!("meets {found}, expected exactly {expected}"))
}

/// Whether the first surface is the expected one: a name, `nothing`, `NAME or nothing`, `something`,
/// or `exact` for the answer of exact arithmetic. What is met is given back.
pub(crate) fn first<'a>(
    expected: &str,
    met: Option<&'a Met>,
    ray: &Ray<'static>,
    oracle: &Oracle,
) -> Result<Option<&'a Met>, String> {
    let found = met.map_or("nothing", Met::name);
    let truth = match expected {
        "exact" => oracle.first(ray),
        other => other,
    };
    let is_true = truth == found
        || truth == "something" && met.is_some()
        || truth
            .strip_suffix(" or nothing")
            .is_some_and(|name| name == found || met.is_none());
    if is_true {
        return Ok(met);
    }
    Err(format!("meets {found}, expected {truth}"))
}

/// `path "origin" "direction" …`: a ray followed from mirror to mirror.
pub(crate) fn path(node: &Node, subject: &Subject) -> Answer {
    let [origin, direction] = node.values.as_slice() else {
        panic!("`path` takes an origin and a direction");
    };
    let stage = subject.stage();
    let mut ray = ray(triple(origin), triple(direction));
    let most: u32 = node.number("most").unwrap_or(1000);
    let mut bounces = 0;
    while bounces < most
        && let Some(met) = stage.first(&ray)
    {
        bounces += 1;
        ray = met.mirrored(&ray);
    }
    if let Some(expected) = node.number::<u32>("bounces")
        && bounces != expected
    {
        return Err(format!("{bounces} bounces, expected {expected}"));
    }
    let within = node.get("within").unwrap_or("8 ulp");
    let length = ray
        .dir
        .to_array()
        .map(of)
        .iter()
        .fold(exact("0"), |sum, part| sum + part * part);
    // The square is off by twice as much as the length.
    if node.get("unit").is_some() && !is_close(nearest(&length), &exact("1"), within) {
        return Err(format!(
            "the direction's length squared is {}",
            nearest(&length)
        ));
    }
    if let Some(direction) = node.get("direction") {
        let expected = super::subject::ray([0.0; 3], triple(direction)).dir;
        let off = (ray.dir - expected).abs().max_element();
        if off > nearest(&super::numbers::allowed(within, &exact("1"))) {
            return Err(format!("goes to {}, expected {direction}", ray.dir));
        }
    }
    Ok(())
}
