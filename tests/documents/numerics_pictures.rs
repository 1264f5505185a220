//! The pictures in `docs/numerics.md` are what the three kinds of numerics draw.
//!
//! Each is a sheet of pictures of one scene; `SNAPSHOTS=overwrite` rewrites them.

use heliodon::math::Numerics::{self, Classic, ClassicF32, Robust};
use heliodon::read::{Options, read_bytes};
use heliodon::render::render;
use heliodon::scene::Setting;
use heliodon_tools::laws::variants::{moved, nodes, scaled, text, wall};
use image::{Rgb, RgbImage, imageops};
use support::files::repository;
use support::golden::compare;

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

fn picture(text: &str, numerics: Numerics, size: Option<[u32; 2]>) -> RgbImage {
    let options = Options {
        settings: vec![Setting::new("numerics", numerics.word()).expect("a setting")],
        size,
        ..Options::default()
    };
    let reading = read_bytes("scene.kdl", text.into(), "".into(), &options);
    let scene = reading
        .unwrap_or_else(|no| panic!("{:?}", no.diagnostics))
        .scene;
    let (film, _) = render(&scene, &|_| ()).expect("a picture");
    let bytes = film.bytes(scene.settings.encoding());
    RgbImage::from_raw(scene.settings.width, scene.settings.height, bytes).expect("all pixels")
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
