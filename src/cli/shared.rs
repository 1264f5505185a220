//! What `check` tells of the planes and lines that surfaces share.

use std::fmt::Write;

use serde_json::{Value, json};

use super::explanation::counted;
use crate::geometry::{Shared, SharedKind};
use crate::scene::Scene;

/// The shared planes and lines as JSON values.
pub(super) fn as_json(scene: &Scene) -> Vec<Value> {
    let one = |weld: &Shared| {
        json!({
            "what": word(weld),
            "surfaces": names(scene, weld),
            "apart": weld.distance,
        })
    };
    scene.shared.iter().map(one).collect()
}

/// How many planes and lines are shared, and which of them were moved to be so; all of them if
/// asked for.
pub(super) fn as_text(scene: &Scene, all: bool) -> String {
    let mut text = String::new();
    let count = |what| scene.shared.iter().filter(|weld| weld.what == what).count();
    let (planes, lines) = (count(SharedKind::Plane), count(SharedKind::Line));
    if planes + lines == 0 {
        return text;
    }
    // Writing to a String cannot fail.
    let _ = writeln!(
        text,
        "  surfaces share {} and {}",
        counted(planes, "plane"),
        counted(lines, "border line")
    );
    for weld in &scene.shared {
        if !all && weld.distance == 0.0 {
            continue;
        }
        let (word, names) = (word(weld), names(scene, weld).join(", "));
        let _ = match weld.distance {
            0.0 => writeln!(text, "  one {word}: {names}"),
            apart => writeln!(text, "  one {word}, though {apart:.1e} apart: {names}"),
        };
    }
    text
}

fn word(weld: &Shared) -> &'static str {
    match weld.what {
        SharedKind::Plane => "plane",
        SharedKind::Line => "line",
    }
}

/// The surfaces by name, or else by kind and place in the file.
fn names(scene: &Scene, weld: &Shared) -> Vec<String> {
    let name = |index: &usize| {
        let surface = &scene.surfaces[*index];
        let kind = surface.describe().word;
        match &surface.common().name {
            Some(name) => format!("{kind} {name:?}"),
            None => format!("{kind} number {}", index + 1),
        }
    };
    weld.surfaces.iter().map(name).collect()
}
