//! What is odd about a scene that can be rendered.

use glam::DVec3;

use crate::accel::{LampView, SurfaceList};
use crate::camera::{Camera, View};
use crate::language::{Diagnostic, Location, Node, Value};
use crate::math::{Flat, Point, Side, unit};
use crate::scene::Scene;
use crate::surface::Surface;

use super::coincident::coincident;

/// How far an `xdir` may point out of its plane before it is remarked on, in degrees.
///
/// Smaller, and rounded decimals are remarked on; larger, and a real mistake is not.
const XDIR_TOLERANCE: f64 = 0.1;

/// Warnings about geometry that is allowed but probably not meant.
#[must_use]
pub fn check(scene: &Scene) -> Vec<Diagnostic> {
    let surfaces = || scene.surfaces.iter().map(AsRef::as_ref);
    let nodes = surfaces().map(|surface| {
        let common = surface.common();
        (common.describe(surface.describe()), common.location)
    });
    let lights = scene
        .lights
        .iter()
        .map(|light| (light.describe(), light.place));
    let mut warnings: Vec<_> = nodes
        .chain(lights)
        .filter_map(|(node, at)| tilted_xdir(&node, at))
        .collect();
    warnings.extend(useless_lights(scene));
    warnings.extend(useless_lamps(scene));
    if let Ok(camera) = scene
        .view
        .camera(scene.settings.width, scene.settings.height)
    {
        warnings.extend(surfaces().filter_map(|surface| around_camera(surface, &camera)));
        let hidden = surfaces().filter(|surface| !in_front(*surface, &camera, &scene.view));
        warnings.extend(hidden.filter_map(|surface| never_in_front(surface, &scene.view)));
    }
    warnings.extend(coincident(scene));
    warnings
}

/// What a message calls a surface or a light: its kind and name.
pub(super) fn title(node: &Node, name: Option<&str>) -> String {
    let word = node.schema.word;
    match name {
        Some(name) => format!("the {word} {name:?}"),
        None if word.starts_with(['a', 'e', 'i', 'o', 'u']) => format!("an {word}"),
        None => format!("a {word}"),
    }
}

pub(super) fn warning(surface: &dyn Surface, what: &str, label: &str) -> Option<Diagnostic> {
    let common = surface.common();
    let title = title(&surface.describe(), common.name.as_deref());
    let at = common.location.unwrap_or(Location {
        source: 0,
        start: 0,
        length: 0,
    });
    Some(Diagnostic::warning(at, format!("{title} {what}"), label))
}

/// An `xdir` that does not lie in the plane; it is projected, and the user should know.
fn tilted_xdir(node: &Node, at: Option<Location>) -> Option<Diagnostic> {
    let known = |word| node.entry(word).is_some();
    if !(known("xdir") && known("normal")) {
        return None;
    }
    let (normal, xdir) = (unit(node.triple("normal"))?, unit(node.triple("xdir"))?);
    let sine = normal.dot(xdir).clamp(-1.0, 1.0);
    let angle = libm::asin(sine).to_degrees().abs();
    if angle <= XDIR_TOLERANCE {
        return None;
    }
    let title = title(node, node.name.as_deref());
    let message = format!("{title} has an xdir that points {angle:.1}° out of its plane");
    let problem = Diagnostic::warning(at?, message, "projected into the plane");
    Some(problem.help("give an xdir at right angles to the normal, if this is not meant"))
}

/// Lights that have every surface's back, so that they light nothing.
fn useless_lights(scene: &Scene) -> impl Iterator<Item = Diagnostic> {
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
        Some(Diagnostic::warning(light.place?, message, "lights nothing").help(help))
    })
}

/// Lamps that shine on no surface's front.
fn useless_lamps(scene: &Scene) -> Vec<Diagnostic> {
    let surfaces = SurfaceList::new(&scene.surfaces);
    let lit = || {
        let entries = surfaces.entries().iter();
        entries.filter(|entry| entry.surface.lamp().is_none())
    };
    let views = LampView::all(&surfaces, &scene.surfaces, true);
    let useless = views
        .iter()
        .filter(|view| lit().next().is_some() && !lit().any(|entry| view.lights(entry)));
    let problems = useless.filter_map(|view| {
        let what = "shines on the front of no surface";
        let problem = warning(view.lamp, what, "lights nothing, but is seen")?;
        Some(problem.help("turn its normal or that of a surface around, or move it"))
    });
    problems.collect()
}

fn around_camera(surface: &dyn Surface, camera: &Camera) -> Option<Diagnostic> {
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
        View::Screen { at, .. } => point.z <= at.z,
        View::LookAt {
            viewpoint, target, ..
        } => (*point - eye).dot(*target - *viewpoint) > 0.0,
    };
    match (surface.bounds(), surface.flat()) {
        (Some(bounds), _) => bounds.corners().iter().any(behind_screen),
        (None, Some(flat)) => can_be_met(flat, camera, view),
        (None, None) => true,
    }
}

/// Whether some ray through the window meets a plane, behind the screen if there is one.
fn can_be_met(flat: &Flat, camera: &Camera, view: &View) -> bool {
    // The eye's height above the plane, and how fast the rays through the corners fall towards it.
    let height = flat.normal.dot(camera.viewpoint() - flat.point);
    let falls = camera
        .corners()
        .map(|corner| -flat.normal.dot(corner) * height.signum());
    let steepest = falls.into_iter().fold(f64::MIN, f64::max);
    let flattest = falls.into_iter().fold(f64::MAX, f64::min);
    // Rays reach the screen when they have come as far as the window's corners.
    let behind_screen = match view {
        View::Screen { .. } => flattest <= height.abs(),
        View::LookAt { .. } => true,
    };
    height != 0.0 && steepest > 0.0 && behind_screen
}

fn never_in_front(surface: &dyn Surface, view: &View) -> Option<Diagnostic> {
    let what = "is never in front of the camera";
    match view {
        View::Screen { at, .. } => {
            let problem = warning(surface, what, "wholly on the viewer's side of the screen")?;
            let z = Value::Number(at.z);
            let help = format!("what is before the screen, at z > {z}, is not drawn at all");
            Some(problem.help(help))
        }
        View::LookAt { .. } => {
            let problem = warning(surface, what, "not seen directly")?;
            Some(problem.help("it can still be seen in mirrors and cast shadows"))
        }
    }
}
