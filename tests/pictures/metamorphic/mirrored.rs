//! A scene mirrored at x = 0, with its camera, gives the picture mirrored.
//!
//! What holds to the last bit, and what does not:
//!
//! - Surfaces and lights are symmetric: no product or sum rounds −x in another way than x.
//! - Cameras are so only if they look at right angles to x and the columns' places are exact: columns
//!   are counted from the left, and 1 − 0.3 is not 0.7. Here a window of 64 steps of 1/16 for 65 pixels,
//!   and an angle of view whose half has the tangent 1/2, for pictures as wide as high or twice that.
//! - Rectangles have a corner, and a mirrored one has it on the other side if it is to face the same
//!   way, so its hits round in another way. Here they are turned around instead and have no lights.
//! - Samples are not placed symmetrically; so there is one for each pixel.

use heliodon::film::Film;

use super::subject::{Subject, difference, fail_on};

/// The scene with x turned around, everything facing as it did but rectangles and tiles.
fn mirrored(subject: &Subject) -> Subject {
    let mut other = subject.changed(|place, numbers| {
        let turns_around = place.attribute.word == "normal"
            && place
                .node
                .all_attributes()
                .any(|found| found.word == "xdir");
        if turns_around {
            // Its own y is normal × xdir, and has to stay.
            numbers.iter_mut().for_each(|number| *number = -*number);
        }
        if place.is_point() || place.is_direction() {
            numbers[0] = -numbers[0];
        }
    });
    for node in &mut other.nodes {
        if node.schema.word == "triangle" {
            // The vertices run the other way round now.
            let [second, third] = ["vertex2", "vertex3"].map(|word| {
                let mut entries = node.attributes.iter();
                entries
                    .position(|entry| entry.attribute.word == word)
                    .unwrap()
            });
            let value = node.attributes[second].value.take();
            node.attributes[second].value = node.attributes[third].value.take();
            node.attributes[third].value = value;
        }
    }
    other
}

/// The picture with left and right exchanged.
fn flipped(film: &Film) -> Film {
    let mut other = film.clone();
    for row in other.pixels_mut().chunks_mut(film.width()) {
        row.reverse();
    }
    other
}

const CAMERAS: [&str; 3] = [
    "image 65 49\n camera { viewpoint 0.1 1.3 6; screen 4 3 origin=\"center\"; screen-at 0 1.5 0 }",
    "image 64 32\n camera { viewpoint 0.3 1.1 5; look-at 0.3 1.1 -9; field-of-view FIELD }",
    "image 64 64\n camera { viewpoint -0.7 2.1 5; look-at -0.7 0.9 -4; field-of-view FIELD }",
];

fn complaints(title: &str, things: &str) -> Vec<String> {
    // Twice the angle whose tangent is one half.
    let field = (2.0 * libm::atan(0.5)).to_degrees();
    assert_eq!(
        libm::tan(field.to_radians() / 2.0).to_bits(),
        0.5f64.to_bits()
    );
    let complaints = CAMERAS.iter().filter_map(|camera| {
        let camera = camera.replace("FIELD", &field.to_string());
        let subject = Subject::new(title, &format!("{camera}\n{things}"));
        let film = subject.film();
        assert!(film != flipped(&film), "{title} is symmetric");
        let title = format!("{title} with {camera}");
        difference(&title, &flipped(&film), &mirrored(&subject).film())
    });
    complaints.collect()
}

#[test]
fn lit_things_without_corners_are_mirrored_exactly() {
    fail_on(complaints(
        "a lit room",
        r#"
        material "wall" { ambient 1 0.9 0.8; diffuse 2.3 }
        material "mirror" { ambient 0.1; diffuse 0.7; specular 0.7 0.8 0.9; shininess 31 }
        material "glass" { diffuse 1 4 2; transparency 0.6 }
        light { location 1.7 3.1 -0.3; emissivity 7 6 5 }
        spotlight { location -2.1 2.9 -1.1; emissivity 9; point 0.4 0 -4.3; theta 33 }
        plane { material "mirror"; point 0.3 -0.1 0; normal 0.01 1 -0.02 }
        plane { material "wall"; point 0 0 -7.1; normal 0.2 0.1 1 }
        plane { material "mirror"; point -3.3 0 0; normal 3 0.2 0.1 }
        sphere { material "mirror"; center 0.7 0.9 -3.3; radius 0.9 }
        sphere { material "glass"; center -0.9 1.3 -2.2; radius 0.4 }
        ellipsoid { material "wall"; center -1.7 0.7 -4.1; radius 0.9; scale 1.1 0.6 0.3 }
        triangle { material "wall"; vertex1 1.9 0.1 -4; vertex2 2.7 0.3 -3.1; vertex3 2.2 2.3 -3.7 }
        triangle { material "mirror"; vertex1 -0.3 2 -5; vertex2 0.9 2.1 -4.9; vertex3 0.2 2.9 -4.8 }
        "#,
    ));
}

#[test]
fn unlit_rectangles_are_mirrored_exactly() {
    fail_on(complaints(
        "a room of rectangles",
        r#"
        texture "arrow" "../textures/arrow-8x8.png"
        material "wall" { ambient 1 0.9 0.8 }
        material "dark" { ambient 0.1 0.2 0.3 }
        material "mirror" { ambient 0.1; specular 0.7 0.8 0.9 }
        tiled-plane {
            material "wall"; alternate "dark"; point 0.3 -0.1 0; normal 0 1 0; xdir 1 0 0.3
            dimensions 0.7 0.3 }
        texture-plane {
            material "wall"; point -3.1 0.1 -5.3; normal 0.1 0.2 1; xdir 1 0.3 0; dimensions 5.9 4.1
            texture "arrow" mode="repeat" texel="0.07 0.11" }
        texture-plane {
            material "wall"; point 0.1 0.3 -3.7; normal -0.1 0.2 1; xdir 1 0.2 0; dimensions 1.1 1.3
            texture "arrow" }
        finite-plane {
            material "mirror"; point -1.9 0.1 -3.1; normal 1 0.1 1; xdir 1 0 -1; dimensions 1.7 2.3 }
        sphere { material "mirror"; center 1.3 0.5 -2.3; radius 0.6 }
        "#,
    ));
}
