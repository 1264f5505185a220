//! Questions about reading a scene, and about code values.

use crate::cases::{Case, Node};
use crate::numbers::{exact, nearest, of, stepped};
use crate::pictures::subject;
use crate::rays::Answer;
use crate::scenes::whole;
use crate::subject::{BackEnd, Subject, code};

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

/// `thresholds nudges=…`: around each (k + ½)/255, every intensity x gets the code ⌊255 x + ½⌋.
pub(crate) fn thresholds(node: &Node) -> Answer {
    let most: i32 = node.number("nudges").unwrap_or(1);
    for k in 0..255 {
        let threshold = exact(&format!("{}/510", 2 * k + 1));
        for steps in -most..=most {
            let intensity = stepped(nearest(&threshold), steps);
            let truth = if of(intensity) >= threshold { k + 1 } else { k };
            let found = code(intensity);
            if found != truth {
                return Err(format!("{intensity:?} becomes {found}, expected {truth}"));
            }
        }
    }
    Ok(())
}

/// `code "intensity" is=…`: the code value that an intensity becomes.
pub(crate) fn one_code(node: &Node) -> Answer {
    let (intensity, expected) = (node.value(), node.number::<u16>("is"));
    let found = code(nearest(&exact(intensity)));
    if Some(found) == expected {
        return Ok(());
    }
    Err(format!("{intensity} becomes {found}"))
}
