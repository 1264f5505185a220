//! What is odd about a scene that can be rendered.

use glam::DVec3;

use crate::accel::supports;
use crate::camera::{Camera, View};
use crate::language::{Location, Node, Problem};
use crate::math::{Crossing, Flat, Point, Side, unit};
use crate::scene::Scene;
use crate::surface::Surface;

/// How far an `xdir` may point out of its plane before it is remarked on, in degrees.
///
/// Smaller, and rounded decimals are remarked on; larger, and a real mistake is not.
const XDIR_TOLERANCE: f64 = 0.1;

/// How much of its own width a surface may share with a neighbour in its plane unremarked.
///
/// Smaller, and tiles at rounded decimals are remarked on; larger, and a real overlap is not.
const SHARED_TOLERANCE: f64 = 1e-9;

/// Warnings about geometry that is allowed but probably not meant, in file order of their cause.
#[must_use]
pub fn check(scene: &Scene) -> Vec<Problem> {
    let mut warnings: Vec<_> = scene
        .surfaces
        .iter()
        .filter_map(|one| tilted_xdir(&**one))
        .collect();
    warnings.extend(useless_lights(scene));
    if let Ok(camera) = scene.view.camera(scene.picture.width, scene.picture.height) {
        let camera_warnings = scene
            .surfaces
            .iter()
            .filter_map(|one| around_camera(&**one, &camera));
        warnings.extend(camera_warnings);
        let behind = scene
            .surfaces
            .iter()
            .filter(|one| !in_front(&***one, &camera, &scene.view));
        warnings.extend(behind.filter_map(|one| never_in_front(&**one)));
    }
    warnings.extend(coincident(scene));
    warnings
}

/// What a message calls a surface or a light: its kind and name.
fn title(node: &Node, name: Option<&str>) -> String {
    let word = node.schema.word;
    match name {
        Some(name) => format!("the {word} {name:?}"),
        None if word.starts_with(['a', 'e', 'i', 'o', 'u']) => format!("an {word}"),
        None => format!("a {word}"),
    }
}

fn warning(surface: &dyn Surface, what: &str, label: &str) -> Option<Problem> {
    let common = surface.common();
    let title = title(&surface.describe(), common.name.as_deref());
    let at = common.location.unwrap_or(Location {
        source: 0,
        start: 0,
        length: 0,
    });
    Some(Problem::warning(at, format!("{title} {what}"), label))
}

/// An `xdir` that does not lie in the plane; it is projected, and the user should know.
fn tilted_xdir(surface: &dyn Surface) -> Option<Problem> {
    let node = surface.describe();
    if !node
        .schema
        .all_attributes()
        .any(|attribute| attribute.word == "xdir")
    {
        return None;
    }
    let (normal, xdir) = (surface.flat()?.normal, unit(node.triple("xdir"))?);
    let angle = libm::asin(normal.dot(xdir).clamp(-1.0, 1.0))
        .to_degrees()
        .abs();
    if angle <= XDIR_TOLERANCE {
        return None;
    }
    let what = format!("has an xdir that points {angle:.1}° out of its plane");
    let problem = warning(surface, &what, "projected into the plane")?;
    Some(problem.help("give an xdir at right angles to the normal, if this is not meant"))
}

/// Lights that have every surface's back, so that they light nothing.
fn useless_lights(scene: &Scene) -> impl Iterator<Item = Problem> {
    let lights = scene.lights.iter().filter(|light| {
        let location = Point::exact(light.location);
        !scene.surfaces.is_empty()
            && scene
                .surfaces
                .iter()
                .all(|surface| surface.side(&location) != Side::Front)
    });
    lights.filter_map(|light| {
        let title = title(&light.describe(), light.name.as_deref());
        let message = format!("{title} lies behind every surface");
        let help = "surfaces are lit on the side that their normal points to; \
                    turn a normal around or move the light";
        Some(Problem::warning(light.place?, message, "lights nothing").help(help))
    })
}

fn around_camera(surface: &dyn Surface, camera: &Camera) -> Option<Problem> {
    let closed = surface.flat().is_none();
    if !closed || surface.side(&Point::exact(camera.viewpoint())) != Side::Back {
        return None;
    }
    let problem = warning(surface, "has the camera inside", "not seen from inside")?;
    Some(problem.help("move the viewpoint out of it"))
}

/// Whether some part of a surface can be seen directly.
fn in_front(surface: &dyn Surface, camera: &Camera, view: &View) -> bool {
    let eye = camera.viewpoint();
    let behind_screen = |point: &DVec3| match view {
        View::Screen { .. } => point.z <= 0.0,
        View::LookAt {
            viewpoint, target, ..
        } => (*point - eye).dot(*target - *viewpoint) > 0.0,
    };
    match (surface.bounds(), surface.flat()) {
        (Some(bounds), _) => bounds.corners().iter().any(behind_screen),
        (None, Some(flat)) => camera
            .corners()
            .iter()
            .any(|corner| meets(&flat, eye, *corner)),
        (None, None) => true,
    }
}

/// Whether a plane lies ahead in a direction.
fn meets(flat: &Flat, eye: DVec3, direction: DVec3) -> bool {
    let origin = eye - flat.point;
    let (height, slope) = (-flat.normal.dot(origin), flat.normal.dot(direction));
    Crossing {
        origin,
        height,
        slope,
    }
    .is_ahead()
}

fn never_in_front(surface: &dyn Surface) -> Option<Problem> {
    let problem = warning(
        surface,
        "is never in front of the camera",
        "not seen directly",
    )?;
    Some(problem.help("it can still be seen in mirrors and cast shadows"))
}

/// Surfaces in one plane that share an area; the first in the file is seen.
fn coincident(scene: &Scene) -> Vec<Problem> {
    let supports = supports(&scene.surfaces);
    let mut problems = Vec::new();
    for (index, later) in scene.surfaces.iter().enumerate() {
        let earlier = (0..index).find(|earlier| {
            supports[*earlier] == supports[index] && overlap(&*scene.surfaces[*earlier], &**later)
        });
        let Some(earlier) = earlier.map(|index| &scene.surfaces[index]) else {
            continue;
        };
        let name = earlier.common().name.as_deref();
        let other = title(&earlier.describe(), name);
        let problem = warning(
            &**later,
            &format!("lies in the same plane as {other}"),
            "where they overlap, the first in the file is seen",
        );
        let help = "move one of them a little if both are to be seen";
        problems.extend(problem.map(|problem| problem.help(help)));
    }
    problems
}

/// Whether two surfaces in one plane share an area.
///
/// Two convex outlines are apart if one of their edges has one of them on either side (the
/// separating axis theorem).
fn overlap(a: &dyn Surface, b: &dyn Surface) -> bool {
    let Some(normal) = a.flat().map(|flat| flat.normal) else {
        return false;
    };
    let (a, b) = (a.outline(), b.outline());
    if a.is_empty() || b.is_empty() {
        // One of them has no end.
        return true;
    }
    let edges = |corners: &[DVec3]| {
        let next = corners.iter().cycle().skip(1);
        let edges = corners.iter().zip(next).map(|(from, to)| *to - *from);
        edges.collect::<Vec<_>>()
    };
    let all_edges = edges(&a).into_iter().chain(edges(&b));
    !all_edges
        .into_iter()
        .any(|edge| apart(&a, &b, normal.cross(edge)))
}

/// Whether the shadows of two outlines on an axis share no more than rounding.
fn apart(a: &[DVec3], b: &[DVec3], axis: DVec3) -> bool {
    let span = |corners: &[DVec3]| {
        let places = corners.iter().map(|corner| axis.dot(*corner));
        places.fold((f64::MAX, f64::MIN), |(low, high), place| {
            (low.min(place), high.max(place))
        })
    };
    let ((a_low, a_high), (b_low, b_high)) = (span(a), span(b));
    let shared = a_high.min(b_high) - a_low.max(b_low);
    shared <= SHARED_TOLERANCE * (a_high - a_low).min(b_high - b_low)
}
