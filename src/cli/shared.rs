//! Output of `check` about the planes and border lines that surfaces share.

use std::fmt::Write;

use serde_json::{Value, json};

use super::explanation::counted;
use crate::geometry::{Shared, SharedKind};
use crate::plan::Cause;
use crate::scene::Scene;

/// The shared planes and lines as JSON values.
pub(super) fn as_json(scene: &Scene) -> Vec<Value> {
    let one = |shared: &Shared| {
        json!({
            "what": word(shared),
            "surfaces": names(scene, shared),
            "apart": shared.distance,
        })
    };
    scene.shared.iter().map(one).collect()
}

/// The number of shared planes and lines, and each that was moved to be shared, or all of them.
pub(super) fn as_text(scene: &Scene, all: bool) -> String {
    if scene.shared.is_empty() {
        return String::new();
    }
    let count = |what| scene.shared.iter().filter(|it| it.what == what).count();
    let planes = counted(count(SharedKind::Plane), "plane");
    let lines = counted(count(SharedKind::Line), "border line");
    let mut text = format!("  surfaces share {planes} and {lines}\n");
    let is_shown = |shared: &&Shared| all || shared.distance != 0.0;
    for shared in scene.shared.iter().filter(is_shown) {
        let apart = match shared.distance {
            0.0 => String::new(),
            apart => format!(" ({apart:.1e} apart in the file)"),
        };
        let (word, names) = (word(shared), names(scene, shared).join(", "));
        // Writing to a String cannot fail.
        let _ = writeln!(text, "  shared {word}{apart}: {names}");
    }
    text
}

fn word(shared: &Shared) -> &'static str {
    match shared.what {
        SharedKind::Plane => "plane",
        SharedKind::Line => "line",
    }
}

/// The surfaces by kind and name, or else by kind and number in the file.
fn names(scene: &Scene, shared: &Shared) -> Vec<String> {
    let name = |index: &usize| {
        let surface = &*scene.surfaces[*index];
        let title = Cause::of_surface(surface).title;
        match surface.common().name {
            Some(_) => title,
            None => format!("{title} number {}", index + 1),
        }
    };
    shared.surfaces.iter().map(name).collect()
}
