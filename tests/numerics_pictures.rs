//! The pictures in `docs/numerics.md` are what the three kinds of numerics draw.
//!
//! Each is a sheet of pictures of one scene; `HELIODON_UPDATE=1` rewrites them.

mod golden;

use golden::{compare, repository};
use heliodon::language::{Node, Takes, Value};
use heliodon::math::Numerics::{self, Classic, ClassicF32, Robust};
use heliodon::read::{Options, read_bytes, read_file};
use heliodon::render::render;
use heliodon::scene::Setting;
use image::{Rgb, RgbImage, imageops};

const FOLDER: &str = "docs/numerics";
const ROOM: &str = "docs/numerics/room.kdl";

/// Pixels between two pictures of a sheet.
const GAP: u32 = 4;

/// The room as it is, in two other units of length, and in another place; in all numerics.
#[test]
fn the_room_in_other_units_and_places() {
    let room = nodes(ROOM);
    let variants = [
        text(&room),
        scaled(&room, 6),
        scaled(&room, -6),
        moved(&room, 1e9),
    ];
    let columns = [ClassicF32, Classic, Robust];
    let rows = variants.map(|text| columns.map(|numerics| picture(&text, numerics, None)));
    let [here, rows @ ..] = &rows;
    let names = ["times 1e6", "times 1e-6", "moved by 1e9"];
    for (row, name) in rows.iter().zip(names) {
        assert!(row[2] == here[2], "robust draws another room {name}");
    }
    let rows = [here].into_iter().chain(rows);
    let rows: Vec<_> = rows.map(|row| row.to_vec()).collect();
    check("room", &sheet(&rows));
}

/// A wall of tiles at an angle; the middle of every eighth pixel lies on a joint.
#[test]
fn a_wall_of_tiles() {
    let wall = wall();
    let pictures = [Classic, Robust].map(|numerics| picture(&wall, numerics, None));
    let cracks = pictures.each_ref().map(|picture| {
        // All glazes are dark.
        picture.pixels().filter(|pixel| pixel.0[0] > 128).count()
    });
    assert_eq!(
        cracks,
        [57, 0],
        "pixels that show the light behind the wall"
    );
    let row = pictures.map(|picture| enlarged(&picture, 4));
    check("cracks", &sheet(&[row.to_vec()]));
}

/// The room in thousandths of its unit, such as millimetres.
#[test]
fn a_room_in_millimetres() {
    let room = scaled(&nodes(ROOM), 3);
    let large = Some([300, 225]);
    let row = [ClassicF32, Robust].map(|numerics| picture(&room, numerics, large));
    let as_it_is = picture(&text(&nodes(ROOM)), Robust, large);
    assert!(row[1] == as_it_is, "robust draws another room");
    check("acne", &sheet(&[row.to_vec()]));
}

/// A scene's nodes, every default spelled out.
fn nodes(path: &str) -> Vec<Node> {
    let reading = read_file(&repository(path), &Options::default()).expect("a file");
    reading.expect("a scene").scene.describe()
}

fn text(nodes: &[Node]) -> String {
    nodes.iter().map(Node::to_string).collect()
}

/// The scene with all lengths times a power of ten, as decimals.
///
/// The light of the scene must not fade.
fn scaled(nodes: &[Node], power: i32) -> String {
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
fn moved(nodes: &[Node], far: f64) -> String {
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
fn wall() -> String {
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

fn picture(text: &str, numerics: Numerics, size: Option<[u32; 2]>) -> RgbImage {
    let options = Options {
        settings: vec![Setting::new("numerics", numerics.word()).expect("a setting")],
        size,
        ..Options::default()
    };
    let reading = read_bytes("scene.kdl", text.into(), "".into(), &options);
    let scene = reading
        .unwrap_or_else(|no| panic!("{:?}", no.problems))
        .scene;
    let (film, _) = render(&scene, &|_| ()).expect("a picture");
    let bytes = film.bytes(scene.picture.encoding());
    RgbImage::from_raw(scene.picture.width, scene.picture.height, bytes).expect("all pixels")
}

/// Every pixel as a square.
fn enlarged(picture: &RgbImage, side: u32) -> RgbImage {
    let (width, height) = picture.dimensions();
    imageops::resize(
        picture,
        side * width,
        side * height,
        imageops::FilterType::Nearest,
    )
}

/// Pictures of one size in rows and columns on white.
fn sheet(rows: &[Vec<RgbImage>]) -> RgbImage {
    let (width, height) = rows[0][0].dimensions();
    let across = u32::try_from(rows[0].len()).expect("few columns");
    let down = u32::try_from(rows.len()).expect("few rows");
    let mut sheet = RgbImage::from_pixel(
        across * (width + GAP) - GAP,
        down * (height + GAP) - GAP,
        Rgb([255; 3]),
    );
    for (row, y) in rows.iter().zip((0..).step_by((height + GAP) as usize)) {
        for (picture, x) in row.iter().zip((0..).step_by((width + GAP) as usize)) {
            imageops::replace(&mut sheet, picture, x, y);
        }
    }
    sheet
}

fn check(name: &str, sheet: &RgbImage) {
    let file = format!("{name}.png");
    let kept = repository(FOLDER).join(&file);
    let comparison = repository("target/numerics").join(&file);
    compare(&kept, sheet, &comparison).unwrap_or_else(|complaint| panic!("{complaint}"));
    let size = std::fs::metadata(&kept).expect("the picture").len();
    assert!(size < 60_000, "{file} has {size} bytes");
}
