//! The implicit settings of the courses' programs, as explicit nodes.

use super::block::Block;
use crate::camera::View;
use crate::language::Node;
use crate::scene::{Lighting, RenderSettings};

/// The nodes of the picture, the camera and the lighting.
///
/// They are invalid if the camera is missing or has errors.
pub(super) fn head(camera: Option<&Block>) -> [Node; 3] {
    /// The longest path from the eye to a ray's origin.
    const REACH: f64 = 20.0;
    let given = |means| camera.and_then(|camera| camera.find(means));
    let mut picture = Node::new(&RenderSettings::SCHEMA, None)
        .with_property("quantize", "truncate")
        .with_property("cut-off", 0.0);
    picture.value = given("size").and_then(|size| size.value.clone());
    let mut view = Node::new(&View::SCHEMA, None);
    for given in ["viewpoint", "screen"].into_iter().filter_map(given) {
        if let Some(value) = &given.value {
            view = view.with(given.word.means, value.clone()).last_at(given.at);
        }
    }
    for node in [&mut picture, &mut view] {
        node.word = "camera";
        node.location = camera.map(|camera| camera.head);
        node.valid = camera.is_some_and(|camera| camera.valid);
    }
    [
        picture,
        view,
        Node::new(&Lighting::SCHEMA, None).with("reach", REACH),
    ]
}

/// A texture, whose channels are divided by 256.
pub(super) fn texture(node: Node) -> Node {
    const DIVISOR: f64 = 256.0;
    node.with_property("divisor", DIVISOR)
}
