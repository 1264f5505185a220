//! Renders a scene file and saves the picture.
//!
//! ```sh
//! cargo run --release --example render -- scenes/room.kdl room.png
//! ```

use std::error::Error;
use std::path::PathBuf;

use heliodon::film::{Format, Notes, save};
use heliodon::language::render_diagnostics;
use heliodon::read::{Options, read_file};
use heliodon::render::render;

fn main() -> Result<(), Box<dyn Error + Send + Sync>> {
    let mut arguments = std::env::args_os().skip(1).map(PathBuf::from);
    let (Some(file), Some(picture)) = (arguments.next(), arguments.next()) else {
        return Err("usage: render SCENE PICTURE.png".into());
    };

    // The options override what the scene says of its picture, here the size.
    let options = Options {
        size: Some([200, 150]),
        ..Options::default()
    };
    let scene = match read_file(&file, &options)? {
        Ok(reading) => reading.scene,
        // All mistakes at once, each with its line, what was expected and advice.
        Err(refused) => {
            let messages = render_diagnostics(&refused.diagnostics, &refused.sources, false, 100);
            return Err(messages.into());
        }
    };

    // The closure gets the number of each finished row.
    let (film, counts) = render(&scene, &|_row| ()).map_err(|error| error.reason)?;

    // `save` writes beside the file and renames, so that no half picture is ever left.
    save(&picture, |out| {
        let encoding = scene.settings.encoding();
        film.write(out, Format::Png8, encoding, &Notes::default())
    })?;
    println!(
        "{}x{} pixels, {} rays",
        film.width(),
        film.height(),
        counts.rays()
    );
    Ok(())
}
