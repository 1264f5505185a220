//! The parsed model, printed: the chapter's `dump_obj`.

use super::tools::{Stage, film};

/// A scene with one of everything.
const EVERYTHING: &str = r#"
    image 40 30 samples=2 quantize="truncate"
    camera { viewpoint 4 3 8; screen 8 6 }
    lighting { falloff "inverse"; view-falloff "none"; reach 50 }
    texture "letter" "letter.ppm" divisor=256
    material "steel" { ambient 1 0.5 0.25; diffuse 2; specular 0.25; shininess 9 }
    material "glass" { diffuse 0 1 0; transparency 0.5 }
    light "lamp" { location 4 6 2; emissivity 3 }
    spotlight { location 1 5 1; emissivity 3 2 1; point 4 0 -4; theta 25 }
    projector {
        location 7 5 2; emissivity 9; texture "letter" mode="repeat" texel="0.25 0.5"
        point 5 2 0; normal 1 0 1; xdir 1 0 0; dimensions 3 3
    }
    plane { material "steel"; point 0 0 0; normal 0 1 0; shadows receive=#false }
    finite-plane "door" {
        material "white"; point 1 0.1 -7; normal 0 0 1; xdir 1 0.1 0; dimensions 1 2
    }
    tiled-plane {
        material "steel"; alternate "blue"; point 0 0 -9; normal 0 0 1; xdir 1 1 0
        dimensions 0.7 0.9; start "course"
    }
    texture-plane {
        material "matte"; point 3 0 -8; normal 0 0 1; xdir 1 0 0; dimensions 2 2
        texture "letter" mode="clamp"; shadows cast=#false
    }
    texture-plane {
        material "matte"; point 5 0 -8; normal 0 0 1; xdir 1 0 0; dimensions 2 2
        texture "letter" mode="repeat"
    }
    procedural-plane { material "white"; point 0 9 0; normal 0 -1 0; shader "color-wheel" }
    sphere { material "glass"; center 2 2 -4; radius 0.5; texture "letter" }
    ellipsoid { material "steel"; center 6 3 -5; radius 1; scale 1 0.3 1 }
    triangle { material "red"; vertex1 3 3 -6; vertex2 5 3 -6; vertex3 4 4 -5 }"#;

fn stage(text: &str) -> Stage {
    Stage::new(text).image("letter", &["RG", "BW", "YC"])
}

/// R6, R45: what a scene prints, read again, is the same scene and gives the same picture.
#[test]
fn what_is_printed_is_the_scene() {
    let scene = stage(EVERYTHING).scene();
    let printed: String = scene.describe().iter().map(ToString::to_string).collect();
    // The stage brings its own paints along, which the print has too.
    let paints: Vec<_> = ["black", "red", "green", "blue", "yellow", "white", "matte"].into();
    let own = |line: &&str| {
        !paints
            .iter()
            .any(|name| line.contains(&format!("material \"{name}\" {{")))
    };
    let mut text = String::new();
    let mut skipping = false;
    for line in printed.lines() {
        skipping |= !own(&line);
        if !skipping {
            text += line;
            text += "\n";
        }
        skipping &= line != "}";
    }
    let again = stage(&text).scene();
    assert_eq!(again.describe(), scene.describe());
    assert_eq!(film(&again), film(&scene));
    assert_eq!(again.hash(), scene.hash());
}

/// R6, R45: every surface prints all that was given, with the defaults that were not.
#[test]
fn a_surface_prints_its_data() {
    let scene = stage(EVERYTHING).scene();
    let nodes = scene
        .surfaces
        .iter()
        .map(|surface| surface.common().describe(surface.describe()));
    let printed: Vec<_> = nodes.map(|node| node.to_string()).collect();
    let tokens: Vec<_> = printed[1].split_whitespace().collect();
    assert_eq!(
        tokens.join(" "),
        "finite-plane \"door\" { material \"white\" point 1 0.1 -7 normal 0 0 1 xdir 1 0.1 0 \
         dimensions 1 2 shadows receive=#true cast=#true }"
    );
}
