//! Scenes as the program is given them: with the common header, and moved, scaled or cut.

use dashu::rational::RBig;
use heliodon::language::{Node, Value};

use super::cases::folder;
use super::numbers::{exact, meant, nearest, triple};

/// The nodes of the header that a scene replaces by its own.
const OWN: [&str; 3] = ["image", "camera", "lighting"];

/// A scene with the header, as one pixel that is seen from the eye straight at a point.
pub(crate) fn looking(text: &str, eye: &str, point: &str, up: &str) -> String {
    let replaced = ["image", "camera"];
    let kept = text
        .lines()
        .filter(|line| !replaced.contains(&first_word(line)));
    let kept = kept.collect::<Vec<_>>().join("\n");
    let camera = format!("camera {{ viewpoint {eye}; look-at {point}; up {up} }}");
    whole(&format!("{kept}\nimage 1 1\n{camera}"))
}

/// A scene with the header after it.
pub(crate) fn whole(text: &str) -> String {
    let header = std::fs::read_to_string(folder().join("header.kdl")).unwrap();
    let own = text
        .lines()
        .map(first_word)
        .filter(|word| OWN.contains(word));
    let own: Vec<_> = own.collect();
    let kept = header
        .lines()
        .filter(|line| !own.contains(&first_word(line)));
    // The scene comes first, so that its lines keep their numbers.
    format!("{text}\n{}\n", kept.collect::<Vec<_>>().join("\n"))
}

fn first_word(line: &str) -> &str {
    line.split_whitespace().next().unwrap_or_default()
}

/// A scene from nodes.
pub(crate) fn text(nodes: &[Node]) -> String {
    nodes.iter().map(|node| format!("{node}\n")).collect()
}

/// Every place and length times a power of two.
pub(crate) fn scaled(nodes: &[Node], exponent: i32) -> Vec<Node> {
    let factor = 2f64.powi(exponent);
    lengths(nodes, &|value| match value {
        Value::Number(number) => Value::Number(number * factor),
        Value::Pair(pair) => Value::Pair(pair.map(|number| number * factor)),
        Value::Triple(triple) => Value::Triple(triple.map(|number| number * factor)),
        // Two numbers in quotes.
        Value::Text(pair) => {
            let numbers: Option<Vec<f64>> = pair.split(' ').map(|word| word.parse().ok()).collect();
            match numbers.as_deref() {
                Some([x, y]) => Value::Text(Value::Pair([x * factor, y * factor]).to_string()),
                _ => Value::Text(pair),
            }
        }
        other => other,
    })
}

/// Every place moved.
pub(crate) fn moved(nodes: &[Node], by: &str) -> Vec<Node> {
    let by = triple(by);
    lengths(nodes, &|value| match value {
        Value::Triple(at) => Value::Triple([0, 1, 2].map(|axis| at[axis] + by[axis])),
        other => other,
    })
}

/// Every zero with a minus before it.
pub(crate) fn with_negative_zeros(nodes: &[Node]) -> Vec<Node> {
    let negative = |number: f64| if number == 0.0 { -0.0 } else { number };
    let mut nodes = nodes.to_vec();
    for entry in nodes.iter_mut().flat_map(|node| &mut node.attributes) {
        if let Some(Value::Triple(triple)) = &mut entry.value {
            *triple = triple.map(negative);
        }
    }
    nodes
}

/// The rectangle with this name cut into columns and rows of equal size, at exact decimals.
pub(crate) fn split(nodes: &[Node], name: &str, columns: u32, rows: u32) -> Vec<Node> {
    let (mut cut, mut rest): (Vec<_>, Vec<_>) = nodes
        .iter()
        .cloned()
        .partition(|node| node.name.as_deref() == Some(name));
    let whole = cut.pop().unwrap_or_else(|| panic!("there is no {name}"));
    let (normal, xdir) = (whole.triple("normal"), whole.triple("xdir"));
    let along = [xdir, normal.cross(xdir)].map(|axis| axis.to_array().map(meant));
    for axis in &along {
        let length = axis.iter().fold(RBig::ZERO, |sum, part| sum + part * part);
        assert!(length == RBig::ONE, "{name} has axes that are not unit");
    }
    let size = whole.pair("dimensions").to_array().map(meant);
    let tile = [
        &size[0] / exact(&columns.to_string()),
        &size[1] / exact(&rows.to_string()),
    ];
    let corner = whole.triple("point").to_array().map(meant);
    for index in 0..columns * rows {
        let steps = [index % columns, index / columns].map(|step| exact(&step.to_string()));
        let point = [0, 1, 2].map(|axis| {
            let offset = [0, 1].map(|i| &along[i][axis] * &tile[i] * &steps[i]);
            nearest(&(&corner[axis] + &offset[0] + &offset[1]))
        });
        let mut part = whole.clone();
        part.name = Some(format!("{name} {index}"));
        for entry in &mut part.attributes {
            match entry.attribute.word {
                "point" => entry.value = Some(Value::Triple(point)),
                "dimensions" => {
                    entry.value = Some(Value::Pair([nearest(&tile[0]), nearest(&tile[1])]));
                }
                _ => {}
            }
        }
        rest.push(part);
    }
    rest
}

fn lengths(nodes: &[Node], change: &dyn Fn(Value) -> Value) -> Vec<Node> {
    let mut nodes = nodes.to_vec();
    for entry in nodes.iter_mut().flat_map(|node| &mut node.attributes) {
        for entry in std::iter::once(&mut entry.value)
            .zip([entry.attribute])
            .chain(
                entry
                    .properties
                    .iter_mut()
                    .map(|own| (&mut own.value, own.attribute)),
            )
        {
            let (value, attribute) = entry;
            if attribute.unit == "world units" {
                *value = value.take().map(change);
            }
        }
    }
    nodes
}
