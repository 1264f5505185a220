//! Places for labels that cover neither dots nor each other.

/// Width of a letter and height of a label.
const LETTER: [f64; 2] = [7.3, 12.0];

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

/// A rectangle: lower and upper ends along both axes.
#[derive(Debug, Clone, Copy)]
struct Area([[f64; 2]; 2]);

impl Labels {
    /// Labels within a rectangle with these corners.
    pub(super) fn within(low: [f64; 2], high: [f64; 2]) -> Self {
        Self {
            bounds: Area([[low[0], high[0]], [low[1], high[1]]]),
            taken: Vec::new(),
        }
    }

    /// Keeps labels off a rectangle around a place, with these half sides.
    pub(super) fn avoid(&mut self, place: [f64; 2], reach: [f64; 2]) {
        self.taken.push(Area::around(place, reach));
    }

    /// Middle of the base line of a label close to a dot; `None` if there is no room.
    pub(super) fn beside(&mut self, [x, y]: [f64; 2], text: &str) -> Option<[f64; 2]> {
        #[expect(clippy::cast_precision_loss, reason = "a few letters")]
        let half = [
            LETTER[0] * text.chars().count() as f64 / 2.0,
            LETTER[1] / 2.0,
        ];
        let [across, up] = [half[0] + GAP, half[1] + GAP - 2.0];
        let around = [
            [0.0, -up],
            [across, 0.0],
            [-across, 0.0],
            [0.0, up],
            [half[0], -up],
            [-half[0], -up],
            [half[0], up],
            [-half[0], up],
        ];
        let mut areas = around.map(|[dx, dy]| [x + dx, y + dy]).into_iter();
        let middle = areas.find(|middle| {
            let area = Area::around(*middle, half);
            area.is_in(self.bounds) && !self.taken.iter().any(|other| area.overlaps(*other))
        })?;
        let apart = [half[0] + SPACE, half[1]];
        self.taken.push(Area::around(middle, apart));
        Some([middle[0], middle[1] + 4.0])
    }
}

impl Area {
    fn around([x, y]: [f64; 2], [across, up]: [f64; 2]) -> Self {
        Self([[x - across, x + across], [y - up, y + up]])
    }

    fn overlaps(self, other: Self) -> bool {
        let mut axes = self.0.into_iter().zip(other.0);
        axes.all(|([low, high], [other_low, other_high])| low < other_high && other_low < high)
    }

    fn is_in(self, other: Self) -> bool {
        let mut axes = self.0.into_iter().zip(other.0);
        axes.all(|([low, high], [other_low, other_high])| low >= other_low && high <= other_high)
    }
}

/// Moves places on an axis until they are `apart` from each other, as little as possible, and within
/// a range if they fit.
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
