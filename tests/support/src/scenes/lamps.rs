//! Random scenes of a few surfaces around a lamp or two.

use crate::random::Random;
use crate::scenes::{Writer, triple};

/// The text of a scene: a function of its number alone.
///
/// Positions are often whole numbers, so that things touch and lie in one plane.
#[must_use]
pub fn scene(seed: u64) -> String {
    let mut random = Random::of(0x1a3b5, seed);
    let camera = random.pick(&[
        "viewpoint 1 3 9; look-at 0 0 0",
        "viewpoint 0 2 12; screen 5 4",
    ]);
    let mut text = Writer::new(&format!(
        r#"image 24 18
        camera {{ {camera} }}
        material "chalk" {{ diffuse 1 0.9 0.8 }}
        material "glass" {{ diffuse 0.2 1 0.4; transparency 0.5 }}
        material "mirror" {{ diffuse 0.5; specular 0.5 }}
        "#
    ));
    for _ in 0..1 + random.below(2) {
        lamp(&mut random, &mut text);
    }
    for _ in 0..2 + random.below(7) {
        surface(&mut random, &mut text);
    }
    text.text()
}

fn lamp(random: &mut Random, text: &mut Writer) {
    let (place, axes) = (place(random, 3.0), axes(random));
    if random.once_in(2) {
        text.rectangle("lamp", "emissivity 3; samples 8", place, axes, [2.0, 1.0]);
    } else {
        text.line(format!(
            "lamp {{ center {place}; radius 0.5; emissivity 3; samples 8 }}"
        ));
    }
}

fn surface(random: &mut Random, text: &mut Writer) {
    let (at, axes) = (place(random, 3.0), axes(random));
    let material = random.pick(&["chalk", "chalk", "glass", "mirror"]);
    let material = format!("material \"{material}\"");
    match random.below(6) {
        0 => text.plane(&material, at, axes[0]),
        1 => text.sphere(&material, at, 1.0),
        2 => text.ellipsoid(&material, at, 1.0, "1 0.5 2"),
        3 => {
            let other = loop {
                let other = place(random, 4.0);
                if other != at {
                    break other;
                }
            };
            text.triangle(&material, [at, other, corner(random)]);
        }
        _ => text.rectangle("finite-plane", &material, at, axes, [3.0, 2.0]),
    }
}

/// Three numbers: whole in six of ten places, else multiples of 1/64.
fn place(random: &mut Random, reach: f64) -> String {
    let steps = if random.share() < 0.6 { 1.0 } else { 64.0 };
    triple([0; 3].map(|_| (random.signed() * reach * steps).round() / steps))
}

/// A place that makes no line with two of the above.
fn corner(random: &mut Random) -> String {
    triple([0; 3].map(|_| 5.0 * random.share() + 0.03))
}

/// A normal and an x direction.
fn axes(random: &mut Random) -> [&'static str; 2] {
    random.pick(&[
        ["0 1 0", "1 0 0"],
        ["0 -1 0", "1 0 0"],
        ["1 0 0", "0 0 -1"],
        ["-1 0 0", "0 1 0"],
        ["0 0 1", "1 0 0"],
        ["1 2 0.5", "1 0 0"],
        ["-1 -1 -1", "0 1 0"],
    ])
}
