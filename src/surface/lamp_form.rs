//! The forms that a lamp can have.

use super::{Common, FinitePlane, Sphere, Surface};
use crate::language::{Node, ValueError};

/// The form of a lamp.
#[derive(Debug, Clone)]
pub(super) enum LampForm {
    /// It shines on its front only; its back is black.
    Pane(Box<FinitePlane>),
    /// It shines outward.
    Globe(Sphere),
}

impl LampForm {
    const PANE: [&'static str; 4] = ["point", "normal", "xdir", "dimensions"];
    const GLOBE: [&'static str; 2] = ["center", "radius"];
    const PANE_HAS: &'static str = "a rectangle has `point`, `normal`, `xdir` and `dimensions`";
    const GLOBE_HAS: &'static str = "a ball has `center` and `radius`";

    /// What a `lamp` node says of it.
    ///
    /// # Errors
    /// As [`Lamp::from_node`](super::Lamp::from_node).
    pub(super) fn from_node(node: &Node, common: Common) -> Result<Self, ValueError> {
        if is_pane(node)? {
            let [point, normal, xdir] = ["point", "normal", "xdir"].map(|word| node.triple(word));
            let size = node.pair("dimensions");
            let pane = FinitePlane::new(common, point, normal, xdir, size)?;
            Ok(Self::Pane(Box::new(pane)))
        } else {
            let (center, radius) = (node.triple("center"), node.number("radius"));
            Ok(Self::Globe(Sphere::new(common, center, radius, None)?))
        }
    }

    /// The surface that it has.
    pub(super) fn surface(&self) -> &dyn Surface {
        match self {
            Self::Pane(pane) => &**pane,
            Self::Globe(globe) => globe,
        }
    }

    /// The same, to be changed.
    pub(super) fn surface_mut(&mut self) -> &mut dyn Surface {
        match self {
            Self::Pane(pane) => &mut **pane,
            Self::Globe(globe) => globe,
        }
    }
}

/// Whether a lamp is a rectangle and not a ball.
fn is_pane(node: &Node) -> Result<bool, ValueError> {
    let given = |words: &[&'static str]| {
        let mut words = words.iter();
        words.find(|word| node.entry(word).is_some()).copied()
    };
    let (words, they) = match (given(&LampForm::PANE), given(&LampForm::GLOBE)) {
        (Some(_), None) => (&LampForm::PANE[..], LampForm::PANE_HAS),
        (None, Some(_)) => (&LampForm::GLOBE[..], LampForm::GLOBE_HAS),
        (None, None) => {
            let advice = format!("{}, {}", LampForm::PANE_HAS, LampForm::GLOBE_HAS);
            return Err(ValueError::new("lamp", "the lamp has no shape", advice)
                .expected("expected a rectangle or a ball between its braces"));
        }
        (Some(pane), Some(globe)) => {
            let reason = format!("the lamp has both `{pane}` and `{globe}`");
            let advice = format!("{}, {}; keep one", LampForm::PANE_HAS, LampForm::GLOBE_HAS);
            return Err(ValueError::new(globe, reason, advice).expected("expected only one shape"));
        }
    };
    if let Some(lacks) = words.iter().find(|word| node.entry(word).is_none()) {
        let reason = format!("the lamp has no `{lacks}`");
        let expected = format!("expected `{lacks}` between its braces");
        return Err(ValueError::new(lacks, reason, they).expected(expected));
    }
    Ok(words.len() == LampForm::PANE.len())
}
