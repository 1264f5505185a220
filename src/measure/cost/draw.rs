//! Pictures of a scene with other settings than its own.

use crate::film::Film;
use crate::language::ValueError;
use crate::math::Rgb;
use crate::render::{Counts, Render};
use crate::scene::{RenderSettings, Scene};

/// Renders a scene with other settings, and restores its own.
pub(super) fn draw(
    scene: &mut Scene,
    settings: RenderSettings,
) -> Result<(Film, Counts), ValueError> {
    let own = std::mem::replace(&mut scene.settings, settings);
    let drawn = Render::new(scene).film();
    scene.settings = own;
    drawn
}

/// A picture as it is shown once it is written in code values.
pub(super) fn written(film: &Film, settings: RenderSettings) -> Film {
    let mut written = film.clone();
    for pixel in written.pixels_mut() {
        let channels = pixel.channels();
        let [r, g, b] = channels.map(|it| settings.depth.displayed(it, settings.encoding()));
        *pixel = Rgb::new(r, g, b);
    }
    written
}
