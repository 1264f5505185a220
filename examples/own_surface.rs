//! Adds a surface of its own to a scene: a plane with rings around a point.
//!
//! ```sh
//! cargo run --release --example own_surface -- rings.png
//! ```

use std::error::Error;

use glam::DVec3;
use heliodon::film::{Format, Notes, save};
use heliodon::geometry::{Hit, Plane, Shape};
use heliodon::language::Node;
use heliodon::math::Rgb;
use heliodon::read::{Options, read_bytes};
use heliodon::render::render;
use heliodon::surface::{Common, Plain, Surface, share};

const SCENE: &str = r#"
image 160 120
camera { viewpoint 0 2 6; look-at 0 0.5 0 }
lighting { view-falloff "none" }
material "chalk" { ambient 0.9 0.8 0.7 }
sphere "ball" { material "chalk"; center 0 1 0; radius 1 }
"#;

/// A cover: the shape answers where rays hit, this says which colour they see.
#[derive(Debug)]
struct Rings {
    shape: Shape,
    common: Common,
}

impl Surface for Rings {
    fn shape(&self) -> &Shape {
        &self.shape
    }

    fn shape_mut(&mut self) -> &mut Shape {
        &mut self.shape
    }

    fn common(&self) -> &Common {
        &self.common
    }

    /// The scene language has no word for rings, so `describe` tells of a plane without them.
    fn describe(&self) -> Node {
        self.shape.describe_into(Node::new(&Plain::PLANE, None))
    }

    /// The material's ambient colour, darker in every second ring.
    fn getamb(&self, hit: &Hit) -> Rgb {
        let radius = hit.point.from(self.shape.anchor()).length();
        let is_dark = radius.floor() % 2.0 == 1.0;
        self.common.material.ambient * if is_dark { 0.4 } else { 1.0 }
    }
}

fn main() -> Result<(), Box<dyn Error + Send + Sync>> {
    let picture = std::env::args_os()
        .nth(1)
        .ok_or("usage: own_surface PICTURE.png")?;
    let read = read_bytes("rings", SCENE.into(), "".into(), &Options::default());
    let mut scene = read.expect("a scene without mistakes").scene;
    let plane = Plane::new(DVec3::ZERO, DVec3::Y).map_err(|error| error.reason)?;
    scene.surfaces.push(Box::new(Rings {
        shape: plane.into(),
        common: Common::new(scene.materials[0].clone()),
    }));
    // Planes and borders that coincide are decided by the same numbers.
    scene.shared = share(&mut scene.surfaces);
    let (film, _) = render(&scene, &|_| ()).map_err(|error| error.reason)?;
    let encoding = scene.settings.encoding();
    save(picture.as_ref(), |out| {
        film.write(out, Format::Png8, encoding, &Notes::default())
    })?;
    Ok(())
}
