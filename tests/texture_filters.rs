//! Texture filters: what each shows, the exact one against very many samples, and the pictures in
//! `docs/texture-filters.md`, which `HELIODON_UPDATE=1` rewrites.

mod golden;

use std::path::Path;

use glam::DVec2;
use golden::{compare, repository};
use heliodon::film::Film;
use heliodon::plan::Scope;
use heliodon::read::{Options, read_bytes};
use heliodon::render::{Counts, observed};
use heliodon::scene::{Scene, Setting};
use heliodon::texture::Filter;
use image::{Rgb, RgbImage};

/// The pixel of an image in a column and a row from the top.
type Painter = fn(u32, u32) -> [u8; 3];

/// A folder with a texture `image.png` of this size.
fn folder(sides: [u32; 2], painter: Painter) -> tempfile::TempDir {
    let folder = tempfile::tempdir().expect("a folder");
    let image = RgbImage::from_fn(sides[0], sides[1], |x, y| Rgb(painter(x, y)));
    let saved = image.save(folder.path().join("image.png"));
    saved.expect("the texture can be written");
    folder
}

fn checker(x: u32, y: u32) -> [u8; 3] {
    if (x + y) % 2 == 0 { [255; 3] } else { [0; 3] }
}

fn noise(x: u32, y: u32) -> [u8; 3] {
    let mixed = |salt: u32| {
        let mixed = (x * 73 + y * 179 + salt).wrapping_mul(0x9e37_79b9);
        u8::try_from(mixed >> 24).expect("eight bits")
    };
    [mixed(0), mixed(1), mixed(2)]
}

/// A scene whose textures lie in a folder.
fn scene(text: &str, folder: &Path, filter: Filter, samples: u32) -> Scene {
    let setting = |word, value: &str| Setting::new(word, value).expect("a setting");
    let options = Options {
        settings: vec![
            setting("texture-filter", filter.word()),
            setting("samples", &samples.to_string()),
        ],
        ..Options::default()
    };

    let reading = read_bytes("scene", text.into(), folder.into(), &options);
    let reading = reading.unwrap_or_else(|no| panic!("{:?}", no.problems));
    reading.scene
}

fn drawn(scene: &Scene) -> (Film, Counts) {
    observed(scene, Scope::CalledFor, &|_| ()).expect("a picture")
}

/// A floor of texels of this size to the horizon, seen from this high.
fn floor(size: [u32; 2], camera: &str, texel: f64) -> String {
    let [width, height] = size;
    format!(
        "image {width} {height}
        {camera}
        lighting {{ view-falloff none }}
        texture \"image\" \"image.png\"
        material \"paint\" {{ ambient 1 }}
        texture-plane {{
            material \"paint\"
            point -100000 0 100000; normal 0 1 0; xdir 1 0 0; dimensions 200000 200000
            texture \"image\" mode=\"repeat\" texel=\"{texel} {texel}\"
        }}"
    )
}

const LEVEL: &str = "camera { viewpoint 0.3 1 0.2; look-at 0.3 1 -1; field-of-view 40 }";
const TURNED: &str = "camera { viewpoint 0.3 1 0.2; look-at 1.1 0.7 -1; up 0.2 1 0.1; field-of-view 50 }";

/// The largest difference in a channel, in code values, and the pixel.
fn largest_difference(one: &Film, other: &Film, skip: impl Fn(usize) -> bool) -> (f64, usize) {
    let pairs = one.pixels().iter().zip(other.pixels()).enumerate();
    let differences = pairs.filter(|(index, _)| !skip(*index)).map(|(index, (one, other))| {
        let channels = one.channels().into_iter().zip(other.channels());
        let off = channels.map(|(one, other)| (one - other).abs() * 255.0).fold(0.0, f64::max);
        (off, index)
    });
    differences.fold((0.0, 0), |most, next| if next.0 > most.0 { next } else { most })
}

#[test]
fn scratch() {
    for (name, camera) in [("level", LEVEL), ("turned", TURNED)] {
        for (kind, sides, painter) in [("checker", [2, 2], checker as Painter), ("noise", [13, 7], noise as Painter), ("blocks", [64,64], (|x,y| checker(x/32,y/32)) as Painter)] {
            let folder = folder(sides, painter);
            let texel = if kind == "blocks" {1.0/32.0} else {1.0};
            let text = floor([24, 16], camera, texel);
            let reference = drawn(&scene(&text, folder.path(), Filter::Nearest, 65_536)).0;
            for filter in Filter::ALL {
                let clock = std::time::Instant::now();
                let (film, counts) = drawn(&scene(&text, folder.path(), filter, 1));
                let took = clock.elapsed();
                let (off, index) = largest_difference(&film, &reference, |index| reference.pixels()[index].channels() == [0.0; 3] || (name=="level" && index / 24 == 7));
                println!("{name} {kind} {}: {off:.2} at {} {} fetches {} {:?}", filter.word(), index % 24, index / 24, counts.texel_fetches, took);
            }
        }
    }
}
