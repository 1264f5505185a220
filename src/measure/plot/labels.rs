//! `Places` for labels that cover neither dots nor each other.

use glam::DVec2;

use super::svg::Place;

/// Width of a letter and height of a label.
const LETTER: DVec2 = DVec2::new(7.3, 12.0);

/// Distance of a label from the middle of its dot.
const GAP: f64 = 8.0;

/// Room between labels side by side, so that they are not read as one.
const SPACE: f64 = 5.0;

/// Areas of a drawing that are taken.
#[derive(Debug)]
pub(super) struct Labels {
    bounds: Area,
    taken: Vec<Area>,
}

/// A rectangle: its middle and half of its sides.
#[derive(Debug, Clone, Copy)]
struct Area {
    middle: DVec2,
    half: DVec2,
}

impl Area {
    fn overlaps(self, other: Self) -> bool {
        let apart = (self.middle - other.middle).abs();
        apart.cmplt(self.half + other.half).all()
    }

    fn is_in(self, other: Self) -> bool {
        let apart = (self.middle - other.middle).abs();
        (apart + self.half).cmple(other.half).all()
    }
}

impl Labels {
    /// Labels within a rectangle with these corners.
    pub(super) fn within(low: Place, high: Place) -> Self {
        let [low, high] = [low, high].map(DVec2::from);
        Self {
            bounds: Area {
                middle: (low + high) / 2.0,
                half: (high - low) / 2.0,
            },
            taken: Vec::new(),
        }
    }

    /// Keeps labels off a rectangle around a place, with these half sides.
    pub(super) fn avoid(&mut self, place: Place, half: Place) {
        let [middle, half] = [place, half].map(DVec2::from);
        self.taken.push(Area { middle, half });
    }

    /// Middle of the base line of a label close to a dot; `None` if there is no room.
    pub(super) fn beside(&mut self, dot: Place, text: &str) -> Option<Place> {
        #[expect(clippy::cast_precision_loss, reason = "a few letters")]
        let half = LETTER * DVec2::new(text.chars().count() as f64, 1.0) / 2.0;
        let next = half + GAP - DVec2::new(0.0, 2.0);
        // Above, right, left, below, and the four corners.
        let around = [
            [0.0, -next.y],
            [next.x, 0.0],
            [-next.x, 0.0],
            [0.0, next.y],
            [half.x, -next.y],
            [-half.x, -next.y],
            [half.x, next.y],
            [-half.x, next.y],
        ];
        let mut middles = around
            .into_iter()
            .map(|way| DVec2::from(dot) + DVec2::from(way));
        let middle = middles.find(|middle| {
            let area = Area {
                middle: *middle,
                half,
            };
            area.is_in(self.bounds) && !self.taken.iter().any(|other| area.overlaps(*other))
        })?;
        self.avoid(middle.into(), [half.x + SPACE, half.y]);
        Some([middle.x, middle.y + 4.0])
    }
}

/// Moves places on an axis until they are `apart` from each other, as little as possible.
///
/// They stay within a range if they fit.
pub(super) fn spread(places: &mut [f64], apart: f64, [low, high]: [f64; 2]) {
    let mut order: Vec<_> = (0..places.len()).collect();
    order.sort_by(|one, other| places[*one].total_cmp(&places[*other]));
    // Neighbours push each other off by half of what they lack; a few rounds settle that.
    for _ in 0..200 {
        for pair in order.windows(2) {
            let lack = apart - (places[pair[1]] - places[pair[0]]);
            if lack > 0.0 {
                places[pair[0]] -= lack / 2.0;
                places[pair[1]] += lack / 2.0;
            }
        }
        for place in &mut *places {
            *place = place.clamp(low, high);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn labels_go_where_there_is_room() {
        let mut labels = Labels::within([0.0, 0.0], [200.0, 100.0]);
        let dots = [[100.0, 50.0], [100.0, 36.0]];
        for dot in dots {
            labels.avoid(dot, [6.0, 6.0]);
        }
        let first = labels.beside(dots[0], "lower").expect("room");
        assert!(first[0] > 100.0, "the upper dot is above: {first:?}");
        let second = labels.beside(dots[1], "upper").expect("room");
        assert!(second[1] < 36.0, "{second:?}");
        assert_eq!(
            labels.beside([190.0, 95.0], "a name that is much too long for it"),
            None
        );
    }

    #[test]
    fn labels_side_by_side_are_not_read_as_one() {
        let mut labels = Labels::within([0.0, 0.0], [200.0, 200.0]);
        // The labels of both would touch above their dots.
        let [nine, other] = [([100.0, 100.0], "9"), ([118.3, 100.0], "0.08")];
        assert_eq!(labels.beside(nine.0, nine.1), Some([100.0, 92.0]));
        let place = labels.beside(other.0, other.1).expect("room");
        assert!((place[0] - 140.9).abs() < 1e-9, "to the right: {place:?}");
    }

    #[test]
    fn places_are_spread_in_their_order() {
        let mut places = [50.0, 52.0, 10.0, 51.0];
        spread(&mut places, 15.0, [0.0, 60.0]);
        assert!(
            (places[1] - 60.0).abs() < 0.1 && (places[2] - 10.0).abs() < 0.1,
            "{places:?}"
        );
        assert!(places[0] < places[3] && places[3] < places[1], "{places:?}");
        assert!(places[3] - places[0] > 14.9, "{places:?}");
    }
}
