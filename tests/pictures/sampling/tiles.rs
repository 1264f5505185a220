//! A picture is the same bytes in one piece and in tiles of any size, on any number of threads,
//! whatever its dials say.

use std::path::Path;

use heliodon::film::{EncodedImage, Format, Region};
use heliodon::language::Takes;
use heliodon::read::{Options, read_bytes};
use heliodon::render::{Counts, Render};
use heliodon::scene::{RenderSettings, Scene, Setting};
use rayon::{ThreadPool, ThreadPoolBuilder};

/// Something of everything: an image to the horizon, mirrors, a bent view, soft and coloured shadows.
const SCENE: &str = r#"
    image 33 27
    camera { viewpoint 0.3 1.2 6; look-at 0 0.8 0; field-of-view 50 }
    texture "oak" "../textures/oak-128.png"
    material "oak" { ambient 0.2; diffuse 0.6; specular 0.2 }
    material "gold" { ambient 0.2 0.2 0; diffuse 0.4 0.4 0; specular 0.4; shininess 20 }
    material "glass" { ambient 0; transparency 0.9; specular 0.1; ior 1.5 }
    light "sun" { location 3 6 4; emissivity 5 }
    lamp "panel" { point -1 4 -1; normal 0 -1 0; xdir 1 0 0; dimensions 2 2; emissivity 3; samples 4 }
    texture-plane "floor" {
        material "oak"
        point -400 0 50; normal 0 1 0; xdir 1 0 0; dimensions 800 800
        texture "oak" mode="repeat" texel="0.02 0.02"
    }
    sphere "ball" { material "gold"; center -1 0.8 0; radius 0.8; texture "oak" }
    sphere "drop" { material "glass"; center 1 0.7 1; radius 0.6 }
    finite-plane "mirror" { material "gold"; point -2 0 -2; normal 0 0 1; xdir 1 0 0; dimensions 4 2.5 }
"#;

fn scene(settings: &[(&str, String)]) -> Scene {
    let settings = settings.iter().map(|(word, text)| Setting::new(word, text));
    let options = Options {
        settings: settings.collect::<Result<_, _>>().expect("settings"),
        ..Options::default()
    };
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("scenes");
    let read = read_bytes("scene", SCENE.into(), folder, &options);
    let read = read.unwrap_or_else(|no| panic!("{:?}", no.diagnostics));
    read.scene
}

/// Every dial with each of its values, and what it needs of others to mean something; numbers stand
/// here, words in the scene language.
fn turned() -> Vec<Vec<(&'static str, String)>> {
    let several = |word| match word {
        "pattern" => Some(("samples", "3".to_owned())),
        "quantize" => Some(("samples", "2".to_owned())),
        _ => None,
    };
    let mut all = Vec::new();
    for dial in RenderSettings::SCHEMA.properties {
        let values: Vec<String> = match dial.takes {
            Takes::Word(words) => words.iter().map(|word| (*word).to_owned()).collect(),
            _ => {
                let numbers = NUMBERS.iter().find(|(word, _)| *word == dial.word);
                let (_, numbers) = numbers.unwrap_or_else(|| panic!("no values of {}", dial.word));
                numbers.iter().map(|number| (*number).to_owned()).collect()
            }
        };
        for value in values {
            // `center` is for one ray.
            let needs = several(dial.word).filter(|_| value != "center");
            all.push(
                [Some((dial.word, value)), needs]
                    .into_iter()
                    .flatten()
                    .collect(),
            );
        }
    }
    // Dials that have to do with one another.
    for filter in ["mipmap", "exact"] {
        for (word, value) in [
            ("max-error", "8/255"),
            ("samples", "5"),
            ("numerics", "classic"),
        ] {
            all.push(vec![
                (word, value.to_owned()),
                ("texture-filter", filter.to_owned()),
            ]);
        }
    }
    all
}

const NUMBERS: [(&str, &[&str]); 3] = [
    ("samples", &["1", "2", "7", "16"]),
    ("max-error", &["0", "2/255", "20/255"]),
    ("cut-off", &["0", "0.01", "0.3"]),
];

/// The bits of a part's pixels, and the bytes that a file of it holds.
fn drawn(scene: &Scene, part: Region, threads: &ThreadPool) -> (Vec<[u64; 3]>, Vec<u8>) {
    threads.install(|| {
        let film = Render::new(scene).part(part).film::<Counts>();
        let (film, _) = film.expect("a possible camera");
        let mut formats = Format::ALL.into_iter();
        let format = formats.find(|format| format.depth() == scene.settings.depth);
        let format = format.expect("a format for each depth");
        let print = Render::new(scene).part(part).encoded::<Counts>(format);
        let (print, _): (EncodedImage, _) = print.expect("a possible camera");
        let pixels = film.pixels().iter();
        let bits = pixels.map(|pixel| pixel.channels().map(f64::to_bits));
        (bits.collect(), print.bytes().to_vec())
    })
}

#[test]
fn every_dial_gives_the_same_bytes_in_tiles_of_any_size_on_any_number_of_threads() {
    let dials = turned();
    assert!(dials.len() > 25, "only {} settings", dials.len());
    let pools = [1, 2, 3].map(|threads| {
        let pool = ThreadPoolBuilder::new().num_threads(threads).build();
        pool.expect("threads")
    });
    for settings in dials {
        let scene = scene(&settings);
        let (width, height) = (
            scene.settings.width as usize,
            scene.settings.height as usize,
        );
        let whole = Region::whole([scene.settings.width, scene.settings.height]);
        let (bits, bytes) = drawn(&scene, whole, &pools[0]);
        assert!(bits.iter().any(|pixel| *pixel != bits[0]), "{settings:?}");
        // Square tiles, rows, columns, more than a picture, and again the whole.
        for (columns, rows, threads) in
            [(8, 8, 1), (33, 1, 3), (11, 27, 2), (64, 5, 1), (33, 27, 3)]
        {
            for (top, left) in (0..height)
                .step_by(rows)
                .flat_map(|top| (0..width).step_by(columns).map(move |left| (top, left)))
            {
                let tile = Region {
                    left,
                    top,
                    width: columns.min(width - left),
                    height: rows.min(height - top),
                };
                let (found, printed) = drawn(&scene, tile, &pools[threads - 1]);
                let size = bytes.len() / bits.len();
                for (number, [column, row]) in tile.pixels().enumerate() {
                    let place = row * width + column;
                    let same = found[number] == bits[place]
                        && printed[size * number..][..size] == bytes[size * place..][..size];
                    assert!(
                        same,
                        "{settings:?} {tile:?} {threads} threads: {column},{row}"
                    );
                }
            }
        }
    }
}
