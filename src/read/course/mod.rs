//! The course's block grammar.

mod block;
mod entities;
mod errors;
mod names;
mod nodes;
mod parser;
mod preset;
mod recognize;
mod tokens;
mod values;
mod words;

use super::files::Files;
use crate::camera::View;
use crate::language::{Diagnostic, Location, Node};
use block::Block;
use parser::Parser;
use tokens::Tokens;

pub(super) use recognize::looks_like;

/// Reads the nodes of a scene.
pub(super) fn read(source: usize, files: &Files, diagnostics: &mut Vec<Diagnostic>) -> Vec<Node> {
    let text = files.get(source).text.clone();
    let blocks = Parser {
        tokens: Tokens::new(source, &text),
        diagnostics,
    }
    .blocks();
    let (cameras, mut blocks): (Vec<_>, Vec<_>) = blocks
        .into_iter()
        .partition(|block| block.entity.schema == &View::SCHEMA);
    check_camera(source, &cameras, diagnostics);
    names::make_unique(&mut blocks, diagnostics);
    let mut nodes = preset::head(cameras.first()).to_vec();
    nodes.extend(nodes::nodes(&blocks, files, diagnostics));
    nodes
}

/// Checks that the scene has one camera.
fn check_camera(source: usize, cameras: &[Block], diagnostics: &mut Vec<Diagnostic>) {
    let Some((first, others)) = cameras.split_first() else {
        let at = Location {
            source,
            start: 0,
            length: 0,
        };
        let help = "add, for example, \
            `camera cam1 { pixeldim 800 600 worlddim 8 6 viewpoint 4 3 8 }`";
        let error = Diagnostic::error(at, "the scene has no `camera`", "expected one");
        diagnostics.push(error.help(help));
        return;
    };
    diagnostics.extend(others.iter().map(|other| {
        let label = format!("the first is in line {}", first.line);
        Diagnostic::error(other.head, "the scene has two cameras", label).help("keep one of them")
    }));
}
