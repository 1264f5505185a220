//! Textured floors to the horizon.

use std::path::Path;

use heliodon::read::{Options, read_bytes};
use heliodon::scene::{Scene, Setting};
use image::{Rgb, RgbImage};

/// The pixel of an image in a column and a row from the top.
pub type Painter = fn(u32, u32) -> [u8; 3];

/// Black and yellow, on blue: in blue every pixel shows how much of it is floor.
pub fn checker(x: u32, y: u32) -> [u8; 3] {
    let bright = if (x + y).is_multiple_of(2) { 255 } else { 0 };
    [bright, bright, 255]
}

/// Squares of 32 texels.
pub fn squares(x: u32, y: u32) -> [u8; 3] {
    checker(x / 32, y / 32)
}

/// Every texel its own colour, on blue as well.
pub fn noise(x: u32, y: u32) -> [u8; 3] {
    let mixed = |salt: u32| {
        (x * 73 + y * 179 + salt)
            .wrapping_mul(0x9e37_79b9)
            .to_be_bytes()[0]
    };
    [mixed(0), mixed(1), 255]
}

/// A folder with a texture `image.png` of this size.
pub fn folder(sides: [u32; 2], painter: Painter) -> tempfile::TempDir {
    let folder = tempfile::tempdir().expect("a folder");
    let image = RgbImage::from_fn(sides[0], sides[1], |x, y| Rgb(painter(x, y)));
    let saved = image.save(folder.path().join("image.png"));
    saved.expect("the texture can be written");
    folder
}

/// Looks straight at the horizon.
pub const LEVEL: &str = "viewpoint 0.3 1 0.2; look-at 0.3 1 -1; field-of-view 40";
/// Looks down a little, and askew.
pub const TURNED: &str = "viewpoint 0.3 1 0.2; look-at 1.1 0.7 -1; up 0.2 1 0.1; field-of-view 50";

/// The head of a scene, and what its things are made of.
pub fn head([width, height]: [u32; 2], camera: &str) -> String {
    format!(
        "image {width} {height}
        camera {{ {camera} }}
        lighting {{ view-falloff none }}
        texture \"image\" \"image.png\"
        material \"paint\" {{ ambient 1 }}
        material \"mirror\" {{ specular 1 }}\n"
    )
}

/// Where a floor ends that goes to the horizon.
pub const HORIZON: f64 = -100_000.0;

/// A floor of texels of this size, which ends at this z before the eye and nowhere else.
pub fn floor(texel: f64, end: f64) -> String {
    format!(
        "texture-plane {{
            material \"paint\"
            point -100000 0 {}; normal 0 1 0; xdir 1 0 0; dimensions 200000 200000
            texture \"image\" mode=\"repeat\" texel=\"{texel} {texel}\"
        }}\n",
        end + 200_000.0
    )
}

/// A scene whose texture lies in a folder.
pub fn scene(text: &str, folder: &Path, settings: &[(&str, &str)]) -> Scene {
    let settings = settings.iter().map(|(word, text)| Setting::new(word, text));
    let options = Options {
        settings: settings.collect::<Result<_, _>>().expect("settings"),
        ..Options::default()
    };
    let reading = read_bytes("floor", text.into(), folder.into(), &options);
    let reading = reading.unwrap_or_else(|no| panic!("{:?}", no.diagnostics));
    reading.scene
}
