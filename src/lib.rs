//! A batch ray tracer for planes, textured planes and a few round things.
//!
//! Heliodon turns a scene file into a picture:
//!
//! ```
//! use heliodon::{read, render};
//!
//! let text = r#"
//!     image 80 60
//!     camera { viewpoint 0 1 4; look-at 0 1 0 }
//!     material "chalk" { ambient 1; diffuse 3 }
//!     light { location 2 4 3; emissivity 8 }
//!     plane "floor" { material "chalk"; point 0 0 0; normal 0 1 0 }
//!     sphere "ball" { material "chalk"; center 0 1 0; radius 1 }
//! "#;
//! let reading = read::read_bytes("demo", text.into(), "".into(), &read::Options::default())
//!     .expect("a scene without mistakes");
//! let (film, counts) = render::render(&reading.scene, &|_| ()).expect("a possible camera");
//! assert!(film.pixel(40, 30).r > 0.0);
//! assert_eq!(counts.camera_rays, 80 * 60);
//! ```
//!
//! # Where to start reading
//!
//! [`surface::Surface`] is the heart: what the tracer asks of the boxed objects. Then
//! [`surface::FinitePlane`], the chapter's finite plane, and [`render::Tracer`], the colour along
//! one ray. [`scene::Scene`] is what is drawn, [`read`] makes it from text.
//!
//! # The house
//!
//! Modules import only from lower floors; a test keeps it so.
//!
//! ```text
//! 9  cli        arguments, messages, exit codes: one file per command
//! 8  measure    answers about scenes and pictures
//! 7  render     Plan -> Film: the colour along one ray
//! 6  plan       what of a scene is simulated, and why
//!    read       text -> Scene (KDL, the course's block grammar)
//! 5  scene      picture, view, lights, Vec<Box<dyn Surface>>
//! 4  light      what illuminates          accel   which surface is nearest
//! 3  surface    what a ray can hit: one file each
//! 2  material   how a surface answers light
//! 1  texture    images over surfaces      film    pixels on disk      camera
//! 0  math       rays, points, frames      language  the scene language as data
//! ```

pub mod camera;
pub mod cli;
#[doc(hidden)]
pub mod doctest;
pub mod film;
pub mod geometry;
pub mod language;
pub mod light;
pub mod material;
pub mod math;
pub mod measure;
pub mod plan;
pub mod read;
pub mod render;
pub mod scene;
pub mod surface;
pub mod texture;
pub mod visibility;
