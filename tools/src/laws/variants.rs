//! Hard scenes: the same ones in other units and places, and a wall of tiles.

use heliodon::language::{Node, Takes, Value};
use heliodon::read::{Options, read_bytes};

/// The nodes of a scene in a file, every default spelled out.
pub fn nodes(path: &str) -> Vec<Node> {
    nodes_of(&std::fs::read_to_string(path).expect("a file"))
}

/// The nodes of a scene.
pub fn nodes_of(text: &str) -> Vec<Node> {
    let reading = read_bytes("scene", text.into(), "".into(), &Options::default());
    reading.expect("a scene").scene.describe()
}

/// The scene of these nodes.
pub fn text(nodes: &[Node]) -> String {
    nodes.iter().map(Node::to_string).collect()
}

/// The scene with all lengths times a power of ten, as decimals.
///
/// The light of the scene must not fade.
pub fn scaled(nodes: &[Node], power: i32) -> String {
    let times = |number: &mut f64| {
        let written = format!("{number:e}");
        let (digits, exponent) = written.split_once('e').expect("an exponent");
        let exponent: i32 = exponent.parse().expect("a whole number");
        let scaled = format!("{digits}e{}", exponent + power);
        *number = scaled.parse().expect("a number");
    };
    changed(nodes, |value| match value {
        Value::Number(number) => times(number),
        Value::Pair(numbers) => numbers.iter_mut().for_each(times),
        Value::Triple(numbers) => numbers.iter_mut().for_each(times),
        Value::Text(_) | Value::Flag(_) => {}
    })
}

/// The scene with all points moved as far along each axis.
pub fn moved(nodes: &[Node], far: f64) -> String {
    changed(nodes, |value| {
        if let Value::Triple(numbers) = value {
            numbers.iter_mut().for_each(|number| *number += far);
        }
    })
}

/// The scene with all values changed that are lengths or made of lengths.
fn changed(nodes: &[Node], change: impl Fn(&mut Value)) -> String {
    let mut nodes = nodes.to_vec();
    let entries = nodes.iter_mut().flat_map(|node| &mut node.attributes);
    for entry in entries.filter(|entry| entry.attribute.unit == "world units") {
        assert!(
            !matches!(entry.attribute.takes, Takes::NumberOrPair(_)),
            "no lengths in quotes"
        );
        entry.value.iter_mut().for_each(&change);
    }
    text(&nodes)
}

/// A mosaic in the frame (2, 1, 2)/3, (-2, 2, 1)/3, its tiles 0.3 wide, before a bright wall.
///
/// The eye is in front of a joint, and a pixel is as wide as an eighth of a tile.
pub fn wall() -> String {
    const GLAZES: [&str; 4] = [
        "0.02 0.14 0.24",
        "0.03 0.2 0.3",
        "0.05 0.27 0.36",
        "0.02 0.1 0.2",
    ];
    let mut text = String::from(
        "image 75 57
        camera { viewpoint -0.35625 -0.7125 0.7125; look-at 0 0 0; up -2 2 1; field-of-view 90 }
        material \"light\" { ambient 1 0.86 0.4 }
        lighting { view-falloff none }
        plane { material \"light\"; point 1 2 -2; normal -1 -2 2 }\n",
    );
    for (index, glaze) in GLAZES.iter().enumerate() {
        text += &format!("material \"glaze {index}\" {{ ambient {glaze} }}\n");
    }
    for (row, column) in (-5..5).flat_map(|row| (-6..6).map(move |column| (row, column))) {
        let [x, y, z] =
            [2 * column - 2 * row, column + 2 * row, 2 * column + row].map(|tenths: i32| {
                let sign = if tenths < 0 { "-" } else { "" };
                format!("{sign}{}.{}", tenths.abs() / 10, tenths.abs() % 10)
            });
        // Neighbours differ.
        let glaze = (column + 2 * row).rem_euclid(4);
        text += &format!(
            "finite-plane {{ material \"glaze {glaze}\"; point {x} {y} {z}; normal -1 -2 2; \
             xdir 2 1 2; dimensions 0.3 0.3 }}\n"
        );
    }
    text
}
