//! What `check` tells of the planes and lines that surfaces share.

use std::fmt::Write;

use serde_json::{Value, json};

use super::explanation::counted;
use crate::scene::Scene;
use crate::surface::{Weld, Welded};

/// The shared planes and lines as JSON values.
pub(super) fn as_json(scene: &Scene) -> Vec<Value> {
    let one = |weld: &Weld| {
        json!({
            "what": word(weld),
            "surfaces": names(scene, weld),
            "apart": weld.distance,
        })
    };
    scene.welds.iter().map(one).collect()
}

/// How many planes and lines are shared, and which of them were moved to be so; all of them if
/// asked for.
pub(super) fn as_text(scene: &Scene, all: bool) -> String {
    let mut text = String::new();
    let count = |what| scene.welds.iter().filter(|weld| weld.what == what).count();
    let (planes, lines) = (count(Welded::Plane), count(Welded::Line));
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
    for weld in &scene.welds {
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

fn word(weld: &Weld) -> &'static str {
    match weld.what {
        Welded::Plane => "plane",
        Welded::Line => "line",
    }
}

/// The surfaces by name, or else by kind and place in the file.
fn names(scene: &Scene, weld: &Weld) -> Vec<String> {
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
