//! What the tests are written with: scenes from text, pixels as numbers, pictures as text.

use std::path::{Path, PathBuf};

use heliodon::film::Film;
use heliodon::math::{Numerics, Point, Ray, Rgb, Span, unit};
use heliodon::read::{Options, Reading, SceneError, read_bytes};
use heliodon::render::{Counts, render};
use heliodon::scene::Scene;
use heliodon::surface::{Hit, Surface};
use tempfile::TempDir;

/// A scene's text with the images that it names.
pub(super) struct Stage {
    text: String,
    options: Options,
    folder: Option<TempDir>,
}

impl Stage {
    /// A whole scene.
    pub(super) fn new(text: &str) -> Self {
        let paints = r##"
            material "black" { ambient 0 }
            material "red" { ambient 1 0 0 }
            material "green" { ambient 0 1 0 }
            material "blue" { ambient 0 0 1 }
            material "yellow" { ambient 1 1 0 }
            material "white" { ambient 1 }
            material "matte" { diffuse 1 }
        "##;
        Self {
            text: format!("{paints}\n{text}"),
            options: Options::default(),
            folder: None,
        }
    }

    /// One pixel, seen from (0, 0, 4) straight along −z, through the chapter's screen.
    pub(super) fn eye(text: &str) -> Self {
        Self::new(&format!(
            "image 1 1\n camera {{ viewpoint 0 0 4; screen 1 1 }}\n {text}"
        ))
    }

    /// 32 by 16 pixels, seen from so far away that pixel (x, y), counted from the lower left,
    /// sees what lies at (x, y) at any depth; nothing fades.
    pub(super) fn grid(text: &str) -> Self {
        Self::new(&format!(
            "image 32 16\n camera {{ viewpoint 15.5 7.5 1000000; screen 31 15 }}
            lighting {{ falloff \"none\"; view-falloff \"none\" }}\n {text}"
        ))
    }

    /// Adds an image `name.ppm` of letters, one string for each row.
    pub(super) fn image(self, name: &str, rows: &[&str]) -> Self {
        let texels = rows.iter().flat_map(|row| row.chars()).flat_map(bytes);
        let mut file = format!("P6 {} {} 255\n", rows[0].len(), rows.len()).into_bytes();
        file.extend(texels);
        self.file(&format!("{name}.ppm"), &file)
    }

    /// Adds a file beside the scene.
    pub(super) fn file(mut self, name: &str, bytes: &[u8]) -> Self {
        let folder = self.folder.get_or_insert_with(|| TempDir::new().unwrap());
        std::fs::write(folder.path().join(name), bytes).unwrap();
        self
    }

    /// The same scene as a picture of another size.
    pub(super) fn sized(mut self, width: u32, height: u32) -> Self {
        self.options.size = Some([width, height]);
        self
    }

    fn read(&self) -> Result<Reading, SceneError> {
        // Without images of its own, a scene finds those of the project.
        let folder = self.folder.as_ref().map_or_else(
            || Path::new(env!("CARGO_MANIFEST_DIR")).join("scenes"),
            |folder| PathBuf::from(folder.path()),
        );
        read_bytes(
            "stage",
            self.text.clone().into_bytes(),
            folder,
            &self.options,
        )
    }

    #[track_caller]
    pub(super) fn scene(&self) -> Scene {
        match self.read() {
            Ok(reading) => reading.scene,
            Err(scene_error) => panic!("{:#?}", scene_error.diagnostics),
        }
    }

    /// What the reader says against the scene, one message after the other.
    #[track_caller]
    pub(super) fn error(&self) -> String {
        let Err(scene_error) = self.read() else {
            panic!("the scene was not refused");
        };
        let messages = scene_error.diagnostics.iter().map(ToString::to_string);
        messages.collect::<Vec<_>>().join("\n")
    }

    #[track_caller]
    pub(super) fn film(&self) -> Film {
        film(&self.scene())
    }

    /// The one pixel of a picture with one.
    #[track_caller]
    pub(super) fn pixel(&self) -> Rgb {
        let film = self.film();
        assert_eq!(film.pixels().len(), 1, "the picture has one pixel");
        film.pixel(0, 0)
    }

    #[track_caller]
    pub(super) fn counts(&self) -> Counts {
        render(&self.scene(), &|_| ()).unwrap().1
    }
}

/// The three bytes of a letter's colour.
fn bytes(letter: char) -> [u8; 3] {
    let channel = |letters: &str| if letters.contains(letter) { 255 } else { 0 };
    [channel("RYMW"), channel("GYCW"), channel("BMCW")]
}

pub(super) fn film(scene: &Scene) -> Film {
    render(scene, &|_| ()).unwrap().0
}

/// A ray from a point of the scene in a direction of any length.
pub(super) fn ray(origin: [f64; 3], direction: [f64; 3]) -> Ray<'static> {
    Ray::new(Point::exact(origin.into()), unit(direction.into()).unwrap())
}

/// The first hit of a ray on a surface.
pub(super) fn hit(surface: &dyn Surface, origin: [f64; 3], direction: [f64; 3]) -> Option<Hit> {
    let ray = ray(origin, direction);
    let hit = surface.hits(&ray, Span::AHEAD)?;
    Some(hit.resolved(surface.resolve(&hit, &ray, Numerics::Robust)))
}

/// Compares with a colour computed on paper; a few roundings are allowed.
#[track_caller]
pub(super) fn assert_color(color: Rgb, expected: [f64; 3]) {
    const ROUNDINGS: f64 = 64.0;
    let channels = color.channels();
    let close = |(a, b): (&f64, &f64)| (a - b).abs() <= ROUNDINGS * f64::EPSILON * b.abs().max(1.0);
    assert!(
        channels.iter().zip(&expected).all(close),
        "{channels:?} is not {expected:?}"
    );
}

/// A picture as letters between bars: R, G, B, Y, C, M, W by the channels that are at least half
/// as bright as the brightest, small if that is below one half, `.` for black.
pub(super) fn letters(film: &Film) -> String {
    framed(film, |pixel| {
        let brightest = pixel.max_channel();
        let [r, g, b] = pixel.channels().map(|channel| channel >= brightest / 2.0);
        let letter = match (r, g, b) {
            _ if brightest <= 0.0 => '.',
            (true, true, true) => 'W',
            (true, true, false) => 'Y',
            (true, false, true) => 'M',
            (false, true, true) => 'C',
            (true, false, false) => 'R',
            (false, true, false) => 'G',
            _ => 'B',
        };
        if brightest < 0.5 {
            letter.to_ascii_lowercase()
        } else {
            letter
        }
    })
}

/// A picture as shades between bars: ten steps of its brightest channel, from black to 1 and more.
pub(super) fn shades(film: &Film) -> String {
    const RAMP: [char; 10] = [' ', '.', ':', '-', '=', '+', '*', '#', '%', '@'];
    framed(film, |pixel| {
        let reached = |step: &usize| pixel.max_channel() >= *step as f64 / 10.0;
        RAMP[(1..RAMP.len()).rev().find(reached).unwrap_or(0)]
    })
}

fn framed(film: &Film, letter: impl Fn(Rgb) -> char) -> String {
    let rows = film.pixels().chunks(film.width());
    let lines = rows.map(|row| {
        let drawn: String = row.iter().map(|pixel| letter(*pixel)).collect();
        format!("|{drawn}|")
    });
    lines.collect::<Vec<_>>().join("\n")
}

/// Compares a drawn picture with the expected one, and marks unlike characters with `!`.
#[track_caller]
pub(super) fn assert_drawn(drawn: &str, expected: &str) {
    let expected: Vec<_> = expected.trim().lines().map(str::trim).collect();
    let drawn: Vec<_> = drawn.lines().collect();
    if drawn == expected {
        return;
    }
    let line = |index: usize| {
        let [want, got] = [&expected, &drawn].map(|rows| rows.get(index).copied().unwrap_or(""));
        let both = want.chars().zip(got.chars());
        let marks: String = both.map(|(a, b)| if a == b { ' ' } else { '!' }).collect();
        format!("{got}  {want}  {marks}")
    };
    let count = drawn.len().max(expected.len());
    let lines: Vec<_> = (0..count).map(line).collect();
    panic!("drawn, expected, unlike:\n{}\n", lines.join("\n"));
}
