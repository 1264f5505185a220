//! Scenes from nodes: names are resolved, parts are made, errors are collected.

use std::collections::HashSet;
use std::sync::Arc;

use glam::DVec3;

use super::files::Files;
use super::kdl::Nodes;
use super::lights::{is_light, light};
use super::names::{Names, check_references, check_unique};
use super::options::Options;
use super::parts::{Parts, accepted, diagnostic};
use super::rules::{check_magnitudes, check_required, of, single};
use super::{surfaces, textures};
use crate::camera::View;
use crate::language::{Diagnostic, Location, Node, Reference, Sources, Takes};
use crate::material::Material;
use crate::scene::{Lighting, RenderSettings, Scene};
use crate::surface::{SCHEMAS, share};
use crate::texture::Texture;

/// Builds a scene from its nodes, and adds errors to the diagnostics.
///
/// If a text could not be read completely, missing nodes are not reported.
///
/// # Errors
/// Returns the sources if the scene has no valid camera or picture.
pub(super) fn scene(
    nodes: &Nodes,
    options: &Options,
    files: Files,
    diagnostics: &mut Vec<Diagnostic>,
) -> Result<Scene, Sources> {
    let Nodes { nodes, complete } = nodes;
    check_names(nodes, files.sources(), diagnostics);
    check_magnitudes(nodes, diagnostics);
    if *complete {
        check_required(nodes, diagnostics);
    }
    let settings = settings(nodes, options, files.sources(), diagnostics);
    let view = single(nodes, &View::SCHEMA, files.sources(), diagnostics)
        .and_then(|node| accepted(node, View::from_node(node), diagnostics));
    let lighting = single(nodes, &Lighting::SCHEMA, files.sources(), diagnostics);
    let lighting = lighting.map_or_else(Lighting::default, Lighting::from_node);

    let mut parts = Parts {
        textures: Names::new(Reference::Texture.word()),
        materials: Names::new(Reference::Material.word()),
        pixel_size: None,
        eye: view.as_ref().map_or(DVec3::ZERO, View::viewpoint),
    };
    if let (Some(view), Some(settings)) = (&view, settings) {
        parts.pixel_size = view.pixel_size(settings.width, settings.height);
    }
    let mut materials = Vec::new();
    for node in of(nodes, &Material::SCHEMA) {
        let name = node.name.as_deref().unwrap_or_default();
        let material = node.valid.then(|| Arc::new(material(name, node)));
        parts.materials.insert(name, material.clone());
        materials.extend(material);
    }
    let used = used_textures(nodes);
    let loaded = textures::load(of(nodes, &Texture::SCHEMA), &used, &files, diagnostics);
    for (name, texture) in &loaded {
        parts.textures.insert(name, texture.clone());
    }
    if *complete {
        check_references(nodes, &parts.textures, &parts.materials, diagnostics);
    }

    let valid = || nodes.iter().filter(|node| node.valid);
    let lights = valid().filter(|node| is_light(node));
    let lights = lights.filter_map(|node| light(node, &parts, diagnostics));
    let lights = lights.collect();
    let surfaces = valid().filter(|node| is_surface(node));
    let surfaces = surfaces.filter_map(|node| surfaces::surface(node, &parts, diagnostics));
    let mut surfaces: Vec<_> = surfaces.collect();
    let shared = share(&mut surfaces);

    let sources = files.into_sources();
    let (Some(settings), Some(view)) = (settings, view) else {
        return Err(sources);
    };
    Ok(Scene {
        settings,
        view,
        lighting,
        textures: loaded
            .into_iter()
            .filter_map(|(_, texture)| texture)
            .collect(),
        materials,
        lights,
        surfaces,
        shared,
        sources,
    })
}

fn is_surface(node: &Node) -> bool {
    SCHEMAS.contains(&node.schema)
}

/// Reports equal names of textures, materials, lights or surfaces.
fn check_names(nodes: &[Node], sources: &Sources, diagnostics: &mut Vec<Diagnostic>) {
    let position = |at: Location| sources.position(at);
    check_unique(of(nodes, &Texture::SCHEMA), diagnostics, position);
    check_unique(of(nodes, &Material::SCHEMA), diagnostics, position);
    for is_kind in [is_light, is_surface] {
        let kind = nodes.iter().filter(|node| is_kind(node));
        check_unique(kind, diagnostics, position);
    }
}

/// The settings of the scene, replaced by those of the options.
fn settings(
    nodes: &[Node],
    options: &Options,
    sources: &Sources,
    diagnostics: &mut Vec<Diagnostic>,
) -> Option<RenderSettings> {
    let node = single(nodes, &RenderSettings::SCHEMA, sources, diagnostics)?;
    let given = accepted(node, RenderSettings::from_node(node), diagnostics)?;
    let [width, height] = options.size.unwrap_or([given.width, given.height]);
    let sized = RenderSettings {
        width,
        height,
        ..given
    };
    let replaced = options.settings.iter().fold(sized, RenderSettings::with);
    // A contradiction that only the options cause is no error of the scene.
    if let (Err(error), Err(_)) = (given.check(), replaced.check()) {
        diagnostics.extend(diagnostic(node, error));
    }
    Some(replaced)
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

/// The names of the textures that nodes refer to.
fn used_textures(nodes: &[Node]) -> HashSet<String> {
    let entries = nodes.iter().flat_map(|node| &node.attributes);
    let textures = entries.filter(|entry| entry.attribute.takes == Takes::Name(Reference::Texture));
    textures
        .filter_map(|entry| Some(entry.value.as_ref()?.text().to_owned()))
        .collect()
}
