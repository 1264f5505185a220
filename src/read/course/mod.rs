//! The course's old block grammar.

mod entities;
mod entity;
mod images;
mod mistakes;
mod names;
mod nodes;
mod preset;
mod recognize;
mod tokens;
mod values;
mod words;

use super::Files;
use crate::camera::View;
use crate::language::{Location, Node, Problem};
use entity::Block;
use images::Images;
use tokens::Tokens;

pub(super) use recognize::looks_like;

/// Reads a scene's nodes.
pub(super) fn read(source: usize, files: &Files, problems: &mut Vec<Problem>) -> Vec<Node> {
    let text = files.get(source).text.clone();
    let mut tokens = Tokens::new(source, &text);
    let mut blocks = Vec::new();
    while tokens.peek(0).is_some() {
        blocks.extend(entity::read(&mut tokens, problems));
    }
    let (cameras, mut blocks): (Vec<_>, Vec<_>) = blocks
        .into_iter()
        .partition(|block| block.entity.schema == &View::SCHEMA);
    one_camera(source, &cameras, problems);
    names::make_unique(&mut blocks, problems);
    let mut images = Images::new(&blocks, files);
    let mut nodes = preset::head(cameras.first()).to_vec();
    nodes.extend(
        blocks
            .iter()
            .map(|block| nodes::node(block, &mut images, problems)),
    );
    nodes.extend(images.into_nodes());
    nodes
}

fn one_camera(source: usize, cameras: &[Block], problems: &mut Vec<Problem>) {
    let Some((first, others)) = cameras.split_first() else {
        let at = Location {
            source,
            start: 0,
            length: 0,
        };
        let help = "add, for example, \
            `camera cam1 { pixeldim 800 600 worlddim 8 6 viewpoint 4 3 8 }`";
        let problem = Problem::error(at, "the scene has no `camera`", "expected one");
        problems.push(problem.help(help));
        return;
    };
    problems.extend(others.iter().map(|other| {
        let label = format!("the first is in line {}", first.line);
        Problem::error(other.head, "the scene has two cameras", label).help("keep one of them")
    }));
}
