//! Nodes to surfaces: one arm for each kind.

use std::sync::Arc;

use super::parts::{Parts, accepted};
use super::textures;
use crate::geometry::{Ellipsoid, Plane, Rectangle, Shape, Sphere, Triangle};
use crate::language::{Diagnostic, Node, Value, ValueError};
use crate::material::Material;
use crate::surface::{
    Common, Lamp, Plain, ProceduralPlane, Shader, Shadows, Surface, Textured, TileStart, TiledPlane,
};

/// The surface that a node describes; `None` if it cannot exist, which is then a problem.
pub(super) fn surface(
    node: &Node,
    parts: &Parts,
    diagnostics: &mut Vec<Diagnostic>,
) -> Option<Box<dyn Surface>> {
    let made = if node.schema == &Lamp::SCHEMA {
        // The one surface without a material.
        boxed(Lamp::from_node(
            node,
            Common::black(node.name.clone(), node.location),
        ))
    } else {
        with_material(node, parts, diagnostics)?
    };
    accepted(node, made, diagnostics)
}

/// The surface, or why it cannot exist; `None` if that is a problem already.
fn with_material(
    node: &Node,
    parts: &Parts,
    diagnostics: &mut Vec<Diagnostic>,
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
    Some(match node.schema.word {
        "plane" => {
            let plane = Plane::from_node(node).and_then(|plane| plane.near(parts.eye));
            plain(common(material?), plane)
        }
        "finite-plane" => plain(common(material?), Rectangle::from_node(node)),
        "triangle" => plain(common(material?), Triangle::from_node(node)),
        "sphere" => globe(node, parts, common, material, Sphere::from_node)?,
        "ellipsoid" => globe(node, parts, common, material, Ellipsoid::from_node)?,
        "tiled-plane" => {
            let alternate = parts.materials.find(node, "alternate");
            let start = TileStart::from_word(&node.text("start")).unwrap_or_default();
            let (xdir, tile) = (node.triple("xdir"), node.pair("dimensions"));
            let (common, alternate) = (common(material?), alternate?);
            let plane = Plane::from_node(node);
            boxed(plane.and_then(|it| TiledPlane::new(common, it, xdir, tile, start, alternate)))
        }
        "texture-plane" => {
            let image = textures::map(node, parts, diagnostics);
            let common = common(material?);
            let rectangle = Rectangle::from_node(node);
            let (image, texel_given) = image?;
            boxed(rectangle.map(|it| Textured::plane(common, it, image, texel_given)))
        }
        "procedural-plane" => {
            let shader = Shader::from_word(&node.text("shader"))?;
            let common = common(material?);
            boxed(Plane::from_node(node).map(|it| ProceduralPlane::new(common, it, shader)))
        }
        other => unreachable!("the surface list has {other:?}, this match has no arm for it"),
    })
}

fn boxed<S: Surface + 'static>(
    made: Result<S, ValueError>,
) -> Result<Box<dyn Surface>, ValueError> {
    made.map(|surface| Box::new(surface) as Box<dyn Surface>)
}

fn plain(
    common: Common,
    shape: Result<impl Into<Shape>, ValueError>,
) -> Result<Box<dyn Surface>, ValueError> {
    boxed(shape.map(|shape| Plain::new(common, shape)))
}

/// A round surface, with a texture around it if the node names one.
fn globe<S: Into<Shape>>(
    node: &Node,
    parts: &Parts,
    common: impl FnOnce(Arc<Material>) -> Common,
    material: Option<Arc<Material>>,
    shape: fn(&Node) -> Result<S, ValueError>,
) -> Option<Result<Box<dyn Surface>, ValueError>> {
    if node.entry("texture").is_none() {
        return Some(plain(common(material?), shape(node)));
    }
    let texture = parts.textures.find(node, "texture")?;
    let common = common(material?);
    Some(boxed(
        shape(node).map(|shape| Textured::globe(common, shape, texture)),
    ))
}
