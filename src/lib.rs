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
//! | module or item | meaning |
//! |---|---|
//! | [`surface::Surface`] | the trait of all objects of a scene: a shape, a material and a cover |
//! | [`geometry::Shape`] | the five shapes, with the exact tests of a ray against each |
//! | [`render::Tracer`] | the colour along one ray: hit, shadow, reflection, refraction |
//! | [`scene::Scene`] | the settings, the camera, the lights and the surfaces of a picture |
//! | [`read`] | the way from text to a scene |
//!
//! # The house
//!
//! The modules stand on ten floors. A module imports only from lower floors, and a test checks that.
//!
//! ```text
//! 9  cli          arguments, messages and exit codes: one file per command
//! 8  measure      measurements of scenes and pictures: cost, deviation, explanations
//! 7  render       Plan -> Film: the colour along one ray, for every pixel
//! 6  plan         the simulated part of a scene, and the reasons for the rest
//!    read         text -> Scene: KDL, and the block grammar of the course
//! 5  scene        settings, camera, lights, Vec<Box<dyn Surface>>
//! 4  visibility   nearest hits, occluders and transmittance
//!    light        point lights, their cones and slides
//! 3  surface      a shape, a material and a cover: one file per cover
//! 2  geometry     shapes, and their tests against rays: one file per shape
//!    material     reflectivity, shininess, transparency
//! 1  texture      images on surfaces, and their filters
//!    film         framebuffers and image files
//!    camera       rays through pixels
//! 0  math         rays, points, planes, exact numbers and error bounds
//!    language     the words of scene files, as data
//! ```

pub mod camera;
pub mod cli;
#[doc(hidden)]
pub mod doctest;
pub mod film;
pub mod geometry;
pub mod image_file;
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
