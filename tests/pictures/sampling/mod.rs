//! Where rays go through pixels, how many, and through which pixels.

mod adaptive;
mod crop;
mod patterns;
mod tiles;

use std::path::Path;

use heliodon::read::{Options, read_file};
use heliodon::scene::{Scene, Setting};

/// A scene of the gallery in this size and with these settings.
fn scene(name: &str, size: [u32; 2], settings: &[(&str, &str)]) -> Scene {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join(format!("scenes/{name}.kdl"));
    let settings = settings.iter().map(|(word, text)| Setting::new(word, text));
    let options = Options {
        size: Some(size),
        settings: settings.collect::<Result<_, _>>().expect("settings"),
        ..Options::default()
    };
    let read = read_file(&path, &options).expect("a file");
    read.expect("a scene without mistakes").scene
}
