//! Warnings about scenes that can be rendered but are probably not meant.

use glam::DVec3;

use super::coincident::{Coincidence, coincidences};
use crate::camera::{Camera, View};
use crate::language::{Diagnostic, Location, Node, Value};
use crate::light::Light;
use crate::math::{Flat, Point, Side, unit};
use crate::scene::Scene;
use crate::surface::Surface;
use crate::visibility::{Emitter, Silhouettes, SurfaceList};

/// Angle in degrees up to which an `xdir` may leave its plane without a warning.
///
/// Smaller, and rounded decimals are reported; larger, and a real mistake is not.
const XDIR_TOLERANCE: f64 = 0.1;

/// Warnings about geometry that is allowed but probably not meant.
#[must_use]
pub fn check(scene: &Scene) -> Vec<Diagnostic> {
    let surfaces = || scene.surfaces.iter().map(AsRef::as_ref);
    let lights = scene.lights.iter();
    let subjects = surfaces().map(surface_subject);
    let subjects = subjects.chain(lights.clone().map(light_subject));
    let mut warnings: Vec<_> = subjects.filter_map(|it| tilted_xdir(&it)).collect();
    warnings.extend(lights.filter_map(|light| useless_light(light, scene)));
    warnings.extend(useless_lamps(scene));
    let [width, height] = [scene.settings.width, scene.settings.height];
    if let Ok(camera) = scene.view.camera(width, height) {
        warnings.extend(surfaces().filter_map(|surface| around_camera(surface, &camera)));
        warnings.extend(surfaces().filter_map(|it| never_in_front(it, &camera, &scene.view)));
    }
    warnings.extend(
        coincidences(scene)
            .into_iter()
            .map(|it| coincides(it, scene)),
    );
    warnings
}

/// A surface or light that a warning is about, and its place in the file.
type Subject = (Node, Option<Location>);

fn surface_subject(surface: &dyn Surface) -> Subject {
    let common = surface.common();
    (common.describe(surface.describe()), common.location)
}

fn light_subject(light: &Light) -> Subject {
    (light.describe(), light.place)
}

/// Kind and name with an article.
fn title((node, _): &Subject) -> String {
    let word = node.schema.word;
    match &node.name {
        Some(name) => format!("the {word} {name:?}"),
        None if word.starts_with(['a', 'e', 'i', 'o', 'u']) => format!("an {word}"),
        None => format!("a {word}"),
    }
}

fn warning(subject: &Subject, what: &str, [label, help]: [&str; 2]) -> Diagnostic {
    let start = Location {
        source: 0,
        start: 0,
        length: 0,
    };
    let message = format!("{} {what}", title(subject));
    Diagnostic::warning(subject.1.unwrap_or(start), message, label).help(help)
}

/// Reports an `xdir` that does not lie in the plane; it is projected into it.
fn tilted_xdir(subject: &Subject) -> Option<Diagnostic> {
    let node = &subject.0;
    let known = |word| node.entry(word).is_some();
    if !(known("xdir") && known("normal")) {
        return None;
    }
    let (normal, xdir) = (unit(node.triple("normal"))?, unit(node.triple("xdir"))?);
    let sine = normal.dot(xdir).clamp(-1.0, 1.0);
    let angle = libm::asin(sine).to_degrees().abs();
    let what = format!("has an xdir that points {angle:.1}° out of its plane");
    let advice = [
        "projected into the plane",
        "use an xdir perpendicular to the normal",
    ];
    (angle > XDIR_TOLERANCE).then(|| warning(subject, &what, advice))
}

/// Reports a light on the front of no surface.
fn useless_light(light: &Light, scene: &Scene) -> Option<Diagnostic> {
    let location = Point::exact(light.location);
    let mut surfaces = scene.surfaces.iter();
    if surfaces.len() == 0 || surfaces.any(|it| it.shape().side(&location) == Side::Front) {
        return None;
    }
    let help = "surfaces are lit on the side that their normal points to; \
                turn a normal around or move the light";
    let advice = ["lights nothing", help];
    Some(warning(
        &light_subject(light),
        "lies behind every surface",
        advice,
    ))
}

/// Reports lamps that shine on the front of no surface.
fn useless_lamps(scene: &Scene) -> Vec<Diagnostic> {
    let surfaces = SurfaceList::new(&scene.surfaces);
    let silhouettes = Silhouettes::new(scene.surfaces.len());
    let receivers = surfaces.primitives().iter();
    let receivers = receivers.filter(|it| it.surface.lamp().is_none());
    let help = "turn its normal or the normal of a surface around, or move it";
    let problems = Emitter::lamps(&surfaces).filter_map(|emitter| {
        let lamp = emitter.silhouette();
        let mut lit = receivers
            .clone()
            .map(|it| lamp.can_light(silhouettes.of(it)));
        let is_useless = receivers.clone().next().is_some() && !lit.any(|it| it);
        let subject = surface_subject(emitter.lamp().filter(|_| is_useless)?);
        let advice = ["visible, but lights nothing", help];
        Some(warning(
            &subject,
            "shines on the front of no surface",
            advice,
        ))
    });
    problems.collect()
}

/// Reports a closed surface around the camera.
fn around_camera(surface: &dyn Surface, camera: &Camera) -> Option<Diagnostic> {
    let is_closed = surface.shape().carrier().is_none();
    let is_inside = surface.shape().side(&Point::exact(camera.viewpoint())) == Side::Back;
    let advice = ["not visible from inside", "move the viewpoint out of it"];
    let report = || warning(&surface_subject(surface), "has the camera inside", advice);
    (is_closed && is_inside).then(report)
}

/// Reports a surface no part of which can be seen directly.
fn never_in_front(surface: &dyn Surface, camera: &Camera, view: &View) -> Option<Diagnostic> {
    if in_front(surface, camera, view) {
        return None;
    }
    let screen_help;
    let advice = match view {
        View::Screen { at, .. } => {
            let z = Value::Number(at.z);
            screen_help = format!("only what lies behind the screen, at z ≤ {z}, is drawn");
            ["wholly on the viewer's side of the screen", &screen_help]
        }
        View::LookAt { .. } => [
            "not visible directly",
            "it can still be visible in mirrors and cast shadows",
        ],
    };
    Some(warning(
        &surface_subject(surface),
        "is never in front of the camera",
        advice,
    ))
}

/// True if some part of a surface can be seen directly.
fn in_front(surface: &dyn Surface, camera: &Camera, view: &View) -> bool {
    let eye = camera.viewpoint();
    let behind_screen = |point: &DVec3| match view {
        View::Screen { at, .. } => point.z <= at.z,
        View::LookAt {
            viewpoint, target, ..
        } => (*point - eye).dot(*target - *viewpoint) > 0.0,
    };
    match (surface.shape().bounds(), surface.shape().carrier()) {
        (Some(bounds), _) => bounds.corners().iter().any(behind_screen),
        (None, Some(flat)) => can_be_hit(flat, camera, view),
        (None, None) => true,
    }
}

/// True if some ray through the window hits a plane, behind the screen if there is one.
fn can_be_hit(flat: &Flat, camera: &Camera, view: &View) -> bool {
    // The eye's height above the plane, and how fast the corner rays approach the plane.
    let height = flat.normal.dot(camera.viewpoint() - flat.point);
    let falls = camera
        .corners()
        .map(|corner| -flat.normal.dot(corner) * height.signum());
    let steepest = falls.into_iter().fold(f64::MIN, f64::max);
    let flattest = falls.into_iter().fold(f64::MAX, f64::min);
    // Corner rays reach the screen at parameter 1.
    let behind_screen = match view {
        View::Screen { .. } => flattest <= height.abs(),
        View::LookAt { .. } => true,
    };
    height != 0.0 && steepest > 0.0 && behind_screen
}

/// Reports two surfaces that share an area.
fn coincides(pair: Coincidence, scene: &Scene) -> Diagnostic {
    let [earlier, later] = [pair.earlier, pair.later].map(|it| &*scene.surfaces[it]);
    let verb = match later.shape().carrier() {
        Some(_) => "lies in the same plane as",
        None => "coincides with",
    };
    let label = if pair.is_exact {
        "where they overlap, the first in the file is visible"
    } else {
        "where they overlap, rounding decides which is visible"
    };
    let help = "move one of them slightly if both should be visible";
    let what = format!("{verb} {}", title(&surface_subject(earlier)));
    warning(&surface_subject(later), &what, [label, help])
}
