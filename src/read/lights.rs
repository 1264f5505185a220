//! Lights from nodes.

use super::parts::{Parts, accepted};
use super::textures;
use crate::geometry::Rectangle;
use crate::language::{Diagnostic, Node};
use crate::light::{Beam, Cone, Light, Slide};
use crate::math::Rgb;

/// True for the nodes of lights.
pub(super) fn is_light(node: &Node) -> bool {
    [&Light::SCHEMA, &Cone::SCHEMA, &Slide::SCHEMA].contains(&node.schema)
}

/// The light that a node describes; errors become diagnostics.
pub(super) fn light(
    node: &Node,
    parts: &Parts,
    diagnostics: &mut Vec<Diagnostic>,
) -> Option<Light> {
    let location = node.triple("location");
    let beam = if node.schema == &Cone::SCHEMA {
        let cone = Cone::new(location, node.triple("point"), node.number("theta"));
        Beam::Cone(accepted(node, cone, diagnostics)?)
    } else if node.schema == &Slide::SCHEMA {
        Beam::Slide(Box::new(slide(node, parts, diagnostics)?))
    } else {
        Beam::Everywhere
    };
    Some(Light {
        name: node.name.clone(),
        location,
        emissivity: Rgb::from(node.triple("emissivity")),
        beam,
        place: node.location,
    })
}

fn slide(node: &Node, parts: &Parts, diagnostics: &mut Vec<Diagnostic>) -> Option<Slide> {
    // Both calls run, so that both report their errors.
    let rectangle = accepted(node, Rectangle::from_node(node), diagnostics);
    let (image, texel_given) = textures::map(node, parts, diagnostics)?;
    Some(Slide {
        rectangle: rectangle?,
        image,
        texel_given,
    })
}
