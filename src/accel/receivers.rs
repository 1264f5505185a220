//! On which sides of a plane there is something to be put into shadow.

use glam::DVec3;

use super::Entry;
use crate::math::exact::ExactVector;
use crate::math::{Flat, Side, Support};

/// Where a surface that can be in shadow is.
#[derive(Debug)]
pub(super) struct Receiver {
    support: Option<Support>,
    flat: Option<Flat>,
    /// Points around it, exact and rounded; `None` if it has no end.
    hull: Option<Vec<(ExactVector, DVec3)>>,
}

impl Receiver {
    /// The receivers of a list of surfaces.
    pub(super) fn all(entries: &[Entry<'_>]) -> Vec<Self> {
        let receive = |entry: &&Entry<'_>| entry.surface.common().shadows.receive;
        let receivers = entries.iter().filter(receive).map(|entry| {
            let hull = entry.surface.hull();
            let with_rounded = |point: ExactVector| {
                let rounded = point.rounded();
                (point, rounded)
            };
            Self {
                support: entry.support,
                flat: entry.surface.flat(),
                hull: hull.map(|hull| hull.into_iter().map(with_rounded).collect()),
            }
        });
        receivers.collect()
    }

    /// Whether some of it can lie strictly on this side of a plane.
    fn reaches(&self, flat: &Flat, side: Side) -> bool {
        match (&self.hull, &self.flat) {
            (Some(hull), _) => hull
                .iter()
                .any(|(exact, rounded)| flat.side_of(exact, *rounded) == side),
            (None, Some(own)) => !own.is_parallel(flat) || own.lies_on(flat, side),
            (None, None) => true,
        }
    }
}

/// Whether a surface in a plane on this sheet can put anything into shadow that lies strictly on
/// this side of the plane.
pub(super) fn anything_on(
    side: Side,
    flat: &Flat,
    support: Option<Support>,
    receivers: &[Receiver],
) -> bool {
    let mut others = receivers
        .iter()
        .filter(|receiver| support.is_none() || receiver.support != support);
    others.any(|receiver| receiver.reaches(flat, side))
}
