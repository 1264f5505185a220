//! Questions about very many surfaces in one place.

use std::sync::Arc;

use glam::{DVec2, DVec3};
use heliodon::geometry::Rectangle;
use heliodon::material::Material;
use heliodon::math::{Numerics, Rgb, Span};
use heliodon::surface::{Common, Plain, Surface};
use heliodon::visibility::SurfaceList;

use super::cases::Node;
use super::numbers::triple;
use super::rays::Answer;
use super::subject::{BackEnd, ray};

/// `pile "origin" "direction" count=…`: a ray meets the first of so many unit W's in one place.
pub(crate) fn pile(node: &Node, back_end: BackEnd) -> Answer {
    let [origin, direction] = node.values.as_slice() else {
        panic!("`pile` takes an origin and a direction");
    };
    let count = node.number("count").unwrap_or(1u32);
    let material = Arc::new(Material {
        name: "gray".to_owned(),
        ambient: Rgb::WHITE,
        diffuse: Rgb::WHITE,
        specular: Rgb::BLACK,
        shininess: 0.0,
        transparency: 0.0,
        ior: None,
    });
    let made = (0..count).map(|_| {
        let common = Common::new(material.clone());
        Rectangle::new(DVec3::ZERO, DVec3::Z, DVec3::X, DVec2::ONE)
            .map(|plane| Box::new(Plain::new(common, plane)) as Box<dyn Surface>)
            .map_err(|error| error.reason.to_string())
    });
    let surfaces = made.collect::<Result<Vec<_>, _>>()?;
    let list = match back_end.numerics() {
        Numerics::Robust => SurfaceList::new(&surfaces),
        numerics => SurfaceList::classic(&surfaces, numerics),
    };
    let [origin, direction] = [origin, direction].map(|text| triple(text));
    let found = list.nearest(&ray(origin, direction), Span::AHEAD, &mut 0);
    match found.map(|(entry, _)| entry.index) {
        Some(0) => Ok(()),
        other => Err(format!("met {other:?}, expected the first")),
    }
}
