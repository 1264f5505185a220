//! Nodes to scene: names resolved, everything made, all refusals collected.

use std::collections::HashSet;
use std::sync::Arc;

use super::limits::refuse_too_large;
use super::{
    Files, Options, names::Names, names::refuse_duplicates, names::refuse_unknown, surfaces,
    textures,
};
use crate::camera::View;
use crate::geometry::Rectangle;
use crate::language::{Location, Node, Problem, Reference, Schema, Sources, Takes, ValueError};
use crate::light::{Beam, Cone, Light, Slide};
use crate::material::Material;
use crate::math::Rgb;
use crate::scene::{Lighting, RenderSettings, Scene};
use crate::surface::{SCHEMAS, Surface, share};
use crate::texture::Texture;

/// What surfaces and projectors refer to while a scene is built.
#[derive(Debug)]
pub(super) struct Parts {
    pub(super) textures: Names<Texture>,
    pub(super) materials: Names<Material>,
    /// The world size of a pixel of the chapter's screen, if the camera has one.
    pub(super) pixel_size: Option<glam::DVec2>,
    /// Where the camera is.
    pub(super) eye: glam::DVec3,
}

/// Builds a scene from its nodes.
///
/// Problems are added to the list; a scene that has any errors is not to be rendered. That
/// something is missing is a problem only if the nodes are complete.
///
/// # Errors
/// Gives back the sources if there is no camera or picture to build a scene around.
pub(super) fn scene(
    nodes: &[Node],
    complete: bool,
    options: &Options,
    files: Files,
    problems: &mut Vec<Problem>,
) -> Result<Scene, Sources> {
    let position = |at: Location| files.sources().position(at);
    refuse_duplicates(of(nodes, &Texture::SCHEMA), problems, position);
    refuse_duplicates(of(nodes, &Material::SCHEMA), problems, position);
    for is_kind in [is_light, is_surface] {
        let kind = nodes.iter().filter(|node| is_kind(node));
        refuse_duplicates(kind, problems, position);
    }
    refuse_too_large(nodes, problems);
    if complete {
        refuse_missing(nodes, problems);
    }
    let picture = sound(nodes, &RenderSettings::SCHEMA, &files, problems)
        .and_then(|node| accepted(node, RenderSettings::from_node(node), problems));
    let view = sound(nodes, &View::SCHEMA, &files, problems)
        .and_then(|node| accepted(node, View::from_node(node), problems));
    let lighting = sound(nodes, &Lighting::SCHEMA, &files, problems);
    let picture = picture.map(|picture| {
        let set = with_options(picture, options);
        // What only the options made senseless is no mistake of the scene.
        if let (Err(no), Err(_), Some(node)) = (
            picture.check(),
            set.check(),
            of(nodes, &RenderSettings::SCHEMA).next(),
        ) {
            refused(node, no, problems);
        }
        set
    });

    let mut materials = Vec::new();
    let mut parts = Parts {
        textures: Names::new(Reference::Texture.word()),
        materials: Names::new(Reference::Material.word()),
        pixel_size: None,
        eye: view.as_ref().map_or(glam::DVec3::ZERO, View::viewpoint),
    };
    if let (Some(view), Some(picture)) = (&view, picture) {
        parts.pixel_size = view.pixel_size(picture.width, picture.height);
    }
    for node in of(nodes, &Material::SCHEMA) {
        let name = node.name.as_deref().unwrap_or_default();
        let material = node.sound.then(|| Arc::new(material(name, node)));
        parts.materials.insert(name, material.clone());
        materials.extend(material);
    }
    let used = used_textures(nodes);
    let textures = textures::load(of(nodes, &Texture::SCHEMA), &used, &files, problems);
    for (name, texture) in &textures {
        parts.textures.insert(name, texture.clone());
    }

    if complete {
        refuse_unknown(nodes, &parts.textures, &parts.materials, problems);
    }

    let lights = nodes.iter().filter(|node| node.sound && is_light(node));
    let lights: Vec<_> = lights
        .filter_map(|node| light(node, &parts, problems))
        .collect();
    let surfaces = nodes.iter().filter(|node| node.sound && is_surface(node));
    let mut surfaces: Vec<Box<dyn Surface>> = surfaces
        .filter_map(|node| surfaces::surface(node, &parts, problems))
        .collect();
    let shared = share(&mut surfaces);

    let sources = files.into_sources();
    match (picture, view) {
        (Some(picture), Some(view)) => Ok(Scene {
            settings: picture,
            view,
            lighting: lighting.map_or_else(Lighting::default, Lighting::from_node),
            textures: textures
                .into_iter()
                .filter_map(|(_, texture)| texture)
                .collect(),
            materials,
            lights,
            surfaces,
            shared,
            sources,
        }),
        _ => Err(sources),
    }
}

fn of<'a>(nodes: &'a [Node], schema: &'static Schema) -> impl Iterator<Item = &'a Node> {
    nodes.iter().filter(move |node| node.schema == schema)
}

fn is_light(node: &Node) -> bool {
    [&Light::SCHEMA, &Cone::SCHEMA, &Slide::SCHEMA].contains(&node.schema)
}

fn is_surface(node: &Node) -> bool {
    SCHEMAS.contains(&node.schema)
}

/// Reports that there is no picture or no camera.
fn refuse_missing(nodes: &[Node], problems: &mut Vec<Problem>) {
    let start = Location {
        source: 0,
        start: 0,
        length: 0,
    };
    if nodes.is_empty() && problems.is_empty() {
        let problem = Problem::error(start, "the scene is empty", "expected a scene");
        let help = "a scene begins with, for example,\n\
                    image 800 600\n\
                    camera { viewpoint 4 3 8; screen 8 6 }";
        problems.push(problem.help(help));
        return;
    }
    for (schema, example) in [
        (&RenderSettings::SCHEMA, "image 800 600"),
        (&View::SCHEMA, "camera { viewpoint 4 3 8; screen 8 6 }"),
    ] {
        let word = schema.word;
        if of(nodes, schema).next().is_none() {
            let message = format!("the scene has no `{word}`");
            let label = format!("expected a node `{word}` in this file");
            let problem = Problem::error(start, message, label);
            problems.push(problem.help(format!("add, for example, `{example}`")));
        }
    }
}

/// The picture with what is asked for instead of what the scene says.
fn with_options(picture: RenderSettings, options: &Options) -> RenderSettings {
    let [width, height] = options.size.unwrap_or([picture.width, picture.height]);
    let sized = RenderSettings {
        width,
        height,
        ..picture
    };
    options.settings.iter().fold(sized, RenderSettings::with)
}

/// The node of a kind that a scene may have once, if it is there and makes sense.
fn sound<'a>(
    nodes: &'a [Node],
    schema: &'static Schema,
    files: &Files,
    problems: &mut Vec<Problem>,
) -> Option<&'a Node> {
    let mut all = of(nodes, schema);
    let first = all.next()?;
    for other in all {
        if let (Some(at), Some(earlier)) = (other.location, first.location) {
            let message = format!("the scene has more than one `{}`", schema.word);
            let label = format!("the first is at {}", files.sources().position(earlier));
            problems.push(Problem::error(at, message, label).help("keep one of them"));
        }
    }
    Some(first).filter(|node| node.sound)
}

fn material(name: &str, node: &Node) -> Material {
    Material {
        name: name.to_owned(),
        ambient: node.triple("ambient").into(),
        diffuse: node.triple("diffuse").into(),
        specular: node.triple("specular").into(),
        shininess: node.number("shininess"),
        transparency: node.number("transparency"),
        ior: node.number_if_any("ior"),
    }
}

/// The names that appear where a texture is meant.
fn used_textures(nodes: &[Node]) -> HashSet<String> {
    let entries = nodes.iter().flat_map(|node| &node.attributes);
    let textures = entries.filter(|entry| entry.attribute.takes == Takes::Name(Reference::Texture));
    textures
        .filter_map(|entry| Some(entry.value.as_ref()?.text().to_owned()))
        .collect()
}

fn light(node: &Node, parts: &Parts, problems: &mut Vec<Problem>) -> Option<Light> {
    let location = node.triple("location");
    let beam = if node.schema == &Cone::SCHEMA {
        let cone = Cone::new(location, node.triple("point"), node.number("theta"));
        accepted(node, cone, problems).map(Beam::Cone)
    } else if node.schema == &Slide::SCHEMA {
        slide(node, parts, problems).map(|slide| Beam::Slide(Box::new(slide)))
    } else {
        Some(Beam::Everywhere)
    };
    let emissivity = Rgb::from(node.triple("emissivity"));
    Some(Light {
        name: node.name.clone(),
        location,
        emissivity,
        beam: beam?,
        place: node.location,
    })
}

fn slide(node: &Node, parts: &Parts, problems: &mut Vec<Problem>) -> Option<Slide> {
    let rectangle = accepted(node, Rectangle::from_node(node), problems);
    let image = textures::map(node, parts, problems);
    let (image, texel_given) = image?;
    Some(Slide {
        rectangle: rectangle?,
        image,
        texel_given,
    })
}

/// What was made of a node; `None` if it was refused, which is a problem then.
pub(super) fn accepted<T>(
    node: &Node,
    made: Result<T, ValueError>,
    problems: &mut Vec<Problem>,
) -> Option<T> {
    made.map_err(|error| refused(node, error, problems)).ok()
}

/// Turns a refusal into an error at the attribute that it blames.
fn refused(node: &Node, error: ValueError, problems: &mut Vec<Problem>) {
    let mut attributes = node.schema.all_attributes();
    let blamed = attributes.find(|attribute| attribute.word == error.word);
    let label = match (blamed, error.expected) {
        (Some(attribute), _)
            if node.entry(error.word).is_none() && attribute.default.value().is_some() =>
        {
            format!("expected another `{}` than the default", attribute.word)
        }
        (_, Some(expected)) => expected,
        (Some(attribute), None) => format!("expected {}", attribute.takes.words()),
        (None, None) => format!("expected another `{}`", node.word),
    };
    if let Some(at) = node.place(error.word) {
        problems.push(Problem::error(at, error.reason, label).help(error.advice));
    }
}
