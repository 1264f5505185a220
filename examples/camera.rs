//! Uses two layers alone, the camera and a shape: the place on the floor that each pixel shows.
//!
//! ```sh
//! cargo run --release --example camera
//! ```

use std::error::Error;

use glam::DVec3;
use heliodon::camera::View;
use heliodon::geometry::{Plane, Shape};
use heliodon::math::Span;

/// The picture's size in pixels.
const SIZE: [u32; 2] = [5, 4];

fn main() -> Result<(), Box<dyn Error + Send + Sync>> {
    let view = View::LookAt {
        viewpoint: DVec3::new(0.0, 3.0, 4.0),
        target: DVec3::ZERO,
        up: DVec3::Y,
        field_of_view: 60.0,
    };
    let [width, height] = SIZE;
    let camera = view.camera(width, height).map_err(|error| error.reason)?;
    let floor = Plane::new(DVec3::ZERO, DVec3::Y).map_err(|error| error.reason)?;
    let floor = Shape::from(floor);
    println!("row column      x      z  distance");
    for row in 0..height {
        for column in 0..width {
            // A camera counts from the lower left, a picture from the upper left.
            let [x, y] = [column, height - 1 - row].map(f64::from);
            let ray = camera.ray(x, y);
            match floor.intersect(&ray, Span::AHEAD) {
                Some(hit) => {
                    let place = hit.point.world();
                    println!(
                        "{row:3} {column:6} {:6.2} {:6.2} {:9.2}",
                        place.x, place.z, hit.t
                    );
                }
                None => println!("{row:3} {column:6}      -      -         -"),
            }
        }
    }
    Ok(())
}
