//! Questions about reading a scene.

use super::cases::{Case, Node};
use super::pictures::subject;
use super::rays::Answer;
use super::scenes::whole;
use super::subject::{BackEnd, Subject};

/// `refused "scene" …`: the scene is an error, at a place, and the message names what is wrong.
pub(crate) fn refused(node: &Node, back_end: BackEnd) -> Answer {
    let scene = node.value();
    let Err(refused) = Subject::read(back_end, &whole(scene)) else {
        return Err(format!("accepted: {scene}"));
    };
    if !refused.has_place {
        return Err(format!(
            "no place is given for the error in: {scene}\n{}",
            refused.said
        ));
    }
    said(&refused.said, node)
}

/// `accepted "scene"`: the scene is read, and its picture has no pixel that is not a number.
pub(crate) fn accepted(node: &Node, back_end: BackEnd) -> Answer {
    let read = Subject::read(back_end, &whole(node.value()));
    let subject = read.map_err(|refused| format!("refused:\n{}", refused.said))?;
    let (film, _) = subject.picture()?;
    match film.non_finite().next() {
        None => Ok(()),
        Some((column, row)) => Err(format!("pixel ({column}, {row}) is not finite")),
    }
}

/// `warned names="…"`: something is remarked on.
pub(crate) fn warned(node: &Node, case: &Case, back_end: BackEnd) -> Answer {
    let warnings = subject(node, case, back_end)?.warnings();
    said(&warnings, node)
}

fn said(text: &str, node: &Node) -> Answer {
    match node.get("names") {
        Some(word) if !text.contains(word) => Err(format!("{word:?} is not named in:\n{text}")),
        _ => Ok(()),
    }
}
