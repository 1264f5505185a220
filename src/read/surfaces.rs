//! Nodes to surfaces: one arm for each kind.

use std::sync::Arc;

use super::parts::{Parts, accepted};
use super::textures;
use crate::language::{Diagnostic, Node, Value, ValueError};
use crate::surface::{
    Common, Ellipsoid, FinitePlane, Lamp, Plane, ProceduralPlane, Shader, Shadows, Sphere, Surface,
    TexturePlane, TileStart, TiledPlane, Triangle,
};
use crate::texture::Texture;

/// The surface that a node describes; `None` if it cannot exist, which is then a problem.
pub(super) fn surface(
    node: &Node,
    parts: &Parts,
    problems: &mut Vec<Diagnostic>,
) -> Option<Box<dyn Surface>> {
    let made = if node.schema == &Lamp::SCHEMA {
        // The one surface without a material.
        boxed(Lamp::from_node(
            node,
            Common::black(node.name.clone(), node.location),
        ))
    } else {
        with_material(node, parts, problems)?
    };
    accepted(node, made, problems)
}

/// The surface, or why it cannot exist; `None` if that is a problem already.
fn with_material(
    node: &Node,
    parts: &Parts,
    problems: &mut Vec<Diagnostic>,
) -> Option<Result<Box<dyn Surface>, ValueError>> {
    let material = parts.materials.find(node, "material");
    let shadow = |word| {
        let entry = node.entry("shadows");
        entry
            .and_then(|entry| entry.property(word))
            .is_none_or(|value| value == Value::Flag(true))
    };
    let shadows = Shadows {
        receive: shadow("receive"),
        cast: shadow("cast"),
    };
    let common = |material| Common {
        name: node.name.clone(),
        material,
        shadows,
        location: node.location,
    };
    let (point, normal) = (|| node.triple("point"), || node.triple("normal"));

    Some(match node.schema.word {
        "plane" => {
            let plane = Plane::new(common(material?), point(), normal());
            boxed(plane.and_then(|plane| plane.near(parts.eye)))
        }
        "finite-plane" => boxed(finite_plane(node, common(material?))),
        "tiled-plane" => {
            let alternate = parts.materials.find(node, "alternate");
            let plane = Plane::new(common(material?), point(), normal());
            let start = TileStart::from_word(&node.text("start")).unwrap_or_default();
            let (xdir, tile, alternate) =
                (node.triple("xdir"), node.pair("dimensions"), alternate?);
            boxed(plane.and_then(|plane| TiledPlane::new(plane, xdir, tile, start, alternate)))
        }
        "texture-plane" => {
            let image = textures::map(node, parts, problems);
            let plane = finite_plane(node, common(material?));
            let (image, texel_given) = image?;
            boxed(plane.map(|plane| TexturePlane::new(plane, image, texel_given)))
        }
        "procedural-plane" => {
            let shader = Shader::from_word(&node.text("shader"))?;
            let plane = Plane::new(common(material?), point(), normal());
            boxed(plane.map(|plane| ProceduralPlane::new(plane, shader)))
        }
        "sphere" => {
            let texture = wrapped(node, parts)?;
            let (center, radius) = (node.triple("center"), node.number("radius"));
            boxed(Sphere::new(common(material?), center, radius, texture))
        }
        "ellipsoid" => {
            let texture = wrapped(node, parts)?;
            let (center, radius) = (node.triple("center"), node.number("radius"));
            let scale = node.triple("scale");
            boxed(Ellipsoid::new(
                common(material?),
                center,
                radius,
                scale,
                texture,
            ))
        }
        "triangle" => {
            let vertices = ["vertex1", "vertex2", "vertex3"].map(|word| node.triple(word));
            boxed(Triangle::new(common(material?), vertices))
        }
        other => unreachable!("the surface list has {other:?}, this match has no arm for it"),
    })
}

fn boxed<S: Surface + 'static>(
    made: Result<S, ValueError>,
) -> Result<Box<dyn Surface>, ValueError> {
    made.map(|surface| Box::new(surface) as Box<dyn Surface>)
}

fn finite_plane(node: &Node, common: Common) -> Result<FinitePlane, ValueError> {
    let (point, normal) = (node.triple("point"), node.triple("normal"));
    FinitePlane::new(
        common,
        point,
        normal,
        node.triple("xdir"),
        node.pair("dimensions"),
    )
}

/// The texture of a round thing, which may have none; the outer `None` if it cannot be had.
fn wrapped(node: &Node, parts: &Parts) -> Option<Option<Arc<Texture>>> {
    if node.entry("texture").is_none() {
        return Some(None);
    }
    parts.textures.find(node, "texture").map(Some)
}
