//! A scene in another unit of length, as long as it is a power of two times the old one.
//!
//! Scaling by a power of two changes no digit of a number, so no rounding either. All lengths are
//! scaled, and what fades with them: with the light's fading by 1/dᵖ and the eye's by 1/Tᵠ, a pixel is
//! a sum of ambient / Tᵠ, diffuse · emissivity / (dᵖ Tᵠ) and specular · emissivity / Tᵠ. Ambient and
//! emissivity times the scale's qth power and diffuse times its pth leave each of them as it was.

use super::exceptions::{EXCEPTIONS, Relation};
use super::rooms::rooms;
use super::subject::{Subject, difference, fail_on};

/// The exponents of the light's and the eye's fading, p and q.
fn powers(subject: &Subject) -> [i32; 2] {
    let mut nodes = subject.nodes.iter();
    let lighting = nodes.find(|node| node.schema.word == "lighting").unwrap();
    ["falloff", "view-falloff"].map(|word| match lighting.text(word).as_str() {
        "none" => 0,
        "inverse" => 1,
        "inverse-square" => 2,
        other => panic!("{}: no rule for {word} {other:?}", subject.name),
    })
}

/// The same scene, scaled by 2 to this power.
pub(super) fn scaled(subject: &Subject, exponent: i32) -> Subject {
    let [light, view] = powers(subject);
    subject.changed(|place, numbers| {
        let power = match (place.node.word, place.attribute.word) {
            _ if place.is_length() => 1,
            ("material", "ambient") | (_, "emissivity") => view,
            ("material", "diffuse") => light,
            _ => 0,
        };
        let factor = 2f64.powi(power * exponent);
        numbers.iter_mut().for_each(|number| *number *= factor);
    })
}

/// The exponents to scale a scene by: both ends and a few between; all between with
/// `HELIODON_ALL_SCALES=1` in the environment.
///
/// A material that is scaled by the square of the scale reaches the largest number sooner.
fn exponents(subject: &Subject) -> Vec<i32> {
    let end = if powers(subject).contains(&2) {
        100
    } else {
        200
    };
    if std::env::var_os("HELIODON_ALL_SCALES").is_some_and(|value| value == "1") {
        return (-end..=end).collect();
    }
    vec![-end, -1, 67, end]
}

fn complaints(subject: &Subject) -> Vec<String> {
    let expected = subject.film();
    let scales = exponents(subject).into_iter().filter_map(|exponent| {
        let title = format!("{} times 2^{exponent}", subject.name);
        difference(&title, &expected, &scaled(subject, exponent).film())
    });
    scales.collect()
}

#[test]
fn every_scene_can_be_scaled() {
    let mut exempt = 0;
    let subjects = Subject::all().into_iter().filter(|subject| {
        let excepted = EXCEPTIONS
            .iter()
            .any(|exception| exception.breaks(Relation::Scaled, subject));
        exempt += usize::from(excepted);
        !excepted
    });
    let found: Vec<_> = subjects.flat_map(|subject| complaints(&subject)).collect();
    fail_on(found);
    assert_eq!(
        exempt, 12,
        "stripes, and textures with texels of a given size"
    );
}

/// Textures that are stretched, as others do not scale: near and far, and in a mirror.
const FLOOR: &str = r#"
    camera { viewpoint 0.3 1 4; look-at 0 0.6 0; field-of-view 50 }
    texture "bricks" "../textures/brick-384.png"
    material "wall" { ambient 3 4 5; diffuse 2; specular 0.2 }
    material "mirror" { ambient 0.5; specular 0.8 }
    light { location 2 5 3; emissivity 6 }
    texture-plane { material "wall"; point -400 0 5; normal 0 1 0; xdir 1 0 0; dimensions 800 900; texture "bricks" }
    texture-plane { material "wall"; point -3 0 -3; normal 0 0 1; xdir 1 0.2 0; dimensions 2 3; texture "bricks" }
    finite-plane { material "mirror"; point 0 0 -3; normal -0.3 0 1; xdir 1 0 0.3; dimensions 4 3 }
"#;

#[test]
fn every_dial_can_be_scaled() {
    let dials = [
        "texture-filter=\"bilinear\"",
        "texture-filter=\"mipmap\"",
        "texture-filter=\"anisotropic\"",
        "texture-filter=\"exact\"",
        "samples=4 pattern=\"sobol\"",
        "max-error=0.01",
        "max-error=0.01 transfer=\"srgb\"",
        // So much that mirrored rays are left out that bring something.
        "cut-off=0.7",
    ];
    let subjects = dials.map(|dial| Subject::new(dial, &format!("image 64 48 {dial}\n{FLOOR}")));
    fail_on(subjects.iter().flat_map(complaints));
}

#[test]
fn every_room_can_be_scaled() {
    fail_on(rooms().flat_map(|room| complaints(&room.subject)));
}
