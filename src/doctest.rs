//! The check of the scene examples in this crate's documentation.

use std::path::PathBuf;

use crate::math::{Point, Ray, Span, unit};
use crate::read::{Options, read_bytes};

/// Reads a scene with one surface and traces a ray to it.
///
/// The scene has the materials "gray" and "white" and the texture "arrow".
///
/// # Panics
/// Panics if the scene has mistakes, or if the ray hits the surface at another distance.
pub fn surface(text: &str, origin: [f64; 3], direction: [f64; 3], expected: Option<f64>) {
    let scene = format!(
        r#"image 8 6
        camera {{ viewpoint 0 1 0; look-at 0 1 -1 }}
        texture "arrow" "textures/arrow-8x8.png"
        material "gray" {{ ambient 0.5 }}
        material "white" {{ ambient 1 }}
        {text}"#
    );
    let read = read_bytes(
        "example",
        scene.into_bytes(),
        PathBuf::new(),
        &Options::default(),
    );
    let reading = read.unwrap_or_else(|no| panic!("{:?}", no.diagnostics));
    let ray = Ray::new(
        Point::exact(origin.into()),
        unit(direction.into()).unwrap_or_else(|| panic!("the direction is zero")),
    );
    let surface = &reading.scene.surfaces[0];
    assert_eq!(surface.hits(&ray, Span::AHEAD).map(|hit| hit.t), expected);
}
