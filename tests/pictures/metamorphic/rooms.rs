//! Rooms that are made up from seeds: closed boxes with things, mirrors and lights in them.

use support::random::Random;
use support::scenes::{Writer, triple};

use super::subject::{SIZE, Subject};

/// How many rooms the tests visit.
pub(super) const COUNT: u64 = 50;

/// A closed room. Nothing outside of it can be seen or can cast a shadow into it.
#[derive(Debug)]
pub(super) struct Room {
    /// The room as a scene.
    pub(super) subject: Subject,
    /// The corner with the smallest coordinates.
    pub(super) low: [f64; 3],
    /// The corner with the largest coordinates.
    pub(super) high: [f64; 3],
    /// The centre and the radius of an opaque ball in it.
    pub(super) ball: ([f64; 3], f64),
}

/// All rooms, the same on every run.
pub(super) fn rooms() -> impl Iterator<Item = Room> {
    (1..=COUNT).map(Room::new)
}

/// Random numbers that depend on the seed alone, as people write them.
#[derive(Debug, Clone)]
pub(super) struct Dice(Random);

impl Dice {
    pub(super) fn new(seed: u64) -> Self {
        Self(Random::of_case(seed))
    }

    /// A whole number from 0 up to but not including `count`.
    pub(super) fn below(&mut self, count: usize) -> usize {
        self.0.remainder(count)
    }

    fn pick<'a>(&mut self, words: &[&'a str]) -> &'a str {
        words[self.below(words.len())]
    }

    /// A decimal of one to six places between two numbers, or one of them.
    fn decimal(&mut self, low: f64, high: f64) -> f64 {
        let share = self.0.share();
        let places = 1 + self.below(6);
        let text = format!("{:.places$}", low + (high - low) * share);
        text.parse().unwrap()
    }

    fn triple(&mut self, low: [f64; 3], high: [f64; 3]) -> [f64; 3] {
        [0, 1, 2].map(|axis| self.decimal(low[axis], high[axis]))
    }

    /// A direction of any length but a short one, often along an axis.
    fn direction(&mut self) -> [f64; 3] {
        if self.below(3) == 0 {
            let axes = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
            return axes[self.below(3)];
        }
        let way = self.triple([-1.0; 3], [1.0; 3]);
        let length = way.iter().map(|x| x * x).sum::<f64>();
        if length < 0.1 { self.direction() } else { way }
    }
}

impl Room {
    fn new(seed: u64) -> Self {
        let mut dice = Dice::new(seed);
        let low = dice.triple([-6.0, -3.0, -9.0], [-2.0, 0.0, -6.0]);
        let high = dice.triple([2.0, 3.0, 5.0], [6.0, 5.0, 8.0]);
        let center = dice.triple([-1.0, 0.5, -4.5], [1.0, 2.0, -3.5]);
        let ball = (center, dice.decimal(0.4, 0.9));
        let mut text = Writer::default();
        picture(&mut dice, low, high, &mut text);
        paints(&mut dice, &mut text);
        for _ in 0..1 + dice.below(3) {
            light(&mut dice, low, high, &mut text);
        }
        walls(&mut dice, low, high, &mut text);
        let paint = dice.pick(&["a", "b", "shiny"]);
        text.line(format!(
            "sphere \"ball\" {{ material \"{paint}\"; center {}; radius {} }}",
            triple(ball.0),
            ball.1
        ));
        for _ in 0..2 + dice.below(4) {
            thing(&mut dice, low, high, &mut text);
        }
        Self {
            subject: Subject::new(&format!("room {seed}"), &text.text()),
            low,
            high,
            ball,
        }
    }
}

fn picture(dice: &mut Dice, low: [f64; 3], high: [f64; 3], text: &mut Writer) {
    let [width, height] = SIZE;
    let samples = 1 + usize::from(dice.below(4) == 0);
    text.line(format!("image {width} {height} samples={samples}"));
    let fading = ["inverse", "inverse", "none", "inverse-square"];
    let (light, view) = (dice.pick(&fading), dice.pick(&fading));
    text.line(format!(
        "lighting {{ falloff {light}; view-falloff {view} }}"
    ));
    let screen = dice.decimal(-0.5, 1.0);
    let eye = dice.triple(
        [low[0] / 2.0, 0.5, screen + 1.5],
        [high[0] / 2.0, 2.5, high[2] - 0.3],
    );
    let eye = triple(eye);
    if dice.below(2) == 0 {
        let (width, height) = (dice.decimal(3.0, 4.0), dice.decimal(2.0, 3.0));
        let (origin, [x, y]) = match dice.below(2) {
            0 => ("corner", [-2.0, 0.0]),
            _ => ("center", [0.0, 1.3]),
        };
        let at = triple([
            x + dice.decimal(-0.5, 0.5),
            y + dice.decimal(-0.5, 0.5),
            screen,
        ]);
        let window = format!("screen {width} {height} origin={origin}; screen-at {at}");
        text.line(format!("camera {{ viewpoint {eye}; {window} }}"));
    } else {
        let target = triple(dice.triple([-1.0, 0.5, -5.0], [1.0, 2.0, -3.0]));
        let angle = dice.decimal(30.0, 70.0);
        let aim = format!("look-at {target}; field-of-view {angle}");
        text.line(format!("camera {{ viewpoint {eye}; {aim} }}"));
    }
}

/// The materials; `shiny` is a mirror as well, `glass` is seen through.
fn paints(dice: &mut Dice, text: &mut Writer) {
    text.line("texture \"arrow\" \"../textures/arrow-8x8.png\"");
    for name in ["a", "b", "shiny", "glass"] {
        let ambient = triple(dice.triple([0.0; 3], [3.0; 3]));
        let diffuse = triple(dice.triple([0.1; 3], [6.0; 3]));
        let extra = match name {
            "shiny" => format!("; specular {}; shininess 20", dice.decimal(0.2, 0.9)),
            "glass" => format!("; transparency {}", dice.decimal(0.3, 0.9)),
            _ => String::new(),
        };
        let paint = format!("ambient {ambient}; diffuse {diffuse}{extra}");
        text.line(format!("material \"{name}\" {{ {paint} }}"));
    }
}

fn light(dice: &mut Dice, low: [f64; 3], high: [f64; 3], text: &mut Writer) {
    let inside = |end: [f64; 3], by: f64| end.map(|x| x + by);
    let location = triple(dice.triple(inside(low, 0.3), inside(high, -0.3)));
    let emissivity = triple(dice.triple([3.0; 3], [14.0; 3]));
    let shines = format!("location {location}; emissivity {emissivity}");
    if dice.below(4) == 0 {
        let aim = triple(dice.triple([-1.0, 0.0, -5.0], [1.0, 1.0, -3.0]));
        let theta = dice.decimal(10.0, 50.0);
        text.line(format!(
            "spotlight {{ {shines}; point {aim}; theta {theta} }}"
        ));
    } else {
        text.line(format!("light {{ {shines} }}"));
    }
}

/// Floor, ceiling and four walls that face inward, each of some flat kind without an end.
fn walls(dice: &mut Dice, low: [f64; 3], high: [f64; 3], text: &mut Writer) {
    let along = ["0 0 1", "1 0 0", "1 0 0"];
    for axis in 0..3 {
        for (end, sign) in [(low, 1.0), (high, -1.0)] {
            let mut normal = [0.0; 3];
            normal[axis] = sign;
            // Anywhere in the wall's plane, so that its point is not always a corner.
            let mut point = dice.triple(low, high);
            point[axis] = end[axis];
            let (point, normal) = (triple(point), triple(normal));
            let paint = format!("material \"{}\"", dice.pick(&["a", "b", "shiny"]));
            if dice.below(3) == 0 {
                let (across, up) = (dice.decimal(0.3, 2.0), dice.decimal(0.3, 2.0));
                let paint = format!("{paint}; alternate \"b\"");
                let axes = [normal.as_str(), along[axis]];
                text.rectangle("tiled-plane", &paint, point, axes, [across, up]);
            } else {
                text.plane(&paint, point, normal);
            }
        }
    }
}

/// Something in the back of the room.
fn thing(dice: &mut Dice, low: [f64; 3], high: [f64; 3], text: &mut Writer) {
    let place = dice.triple(
        [low[0] + 1.5, 0.2, low[2] + 1.5],
        [high[0] - 1.5, 2.0, -1.5],
    );
    let paint = format!("material \"{}\"", dice.pick(&["a", "b", "shiny", "glass"]));
    let size = dice.decimal(0.3, 1.2);
    let kind = dice.below(5);
    match kind {
        0 => text.sphere(&paint, triple(place), size),
        1 => {
            let scale = triple(dice.triple([0.3; 3], [1.5; 3]));
            text.ellipsoid(&paint, triple(place), size, scale);
        }
        2 => {
            let mut corner = || {
                let way = dice.triple([-1.0; 3], [1.0; 3]);
                triple([0, 1, 2].map(|axis| place[axis] + way[axis]))
            };
            text.triangle(&paint, [corner(), corner(), corner()]);
        }
        _ => {
            let (normal, mut xdir) = (dice.direction(), dice.direction());
            let same = (0..3).all(|axis| (normal[axis] == 0.0) == (xdir[axis] == 0.0));
            if same {
                // Not parallel to a normal that may be along the same axis.
                xdir = [normal[1] + 0.5, normal[2] + 0.25, normal[0]];
            }
            let sides = [size, dice.decimal(0.3, 1.5)];
            let (word, image) = match (kind, dice.below(2)) {
                (3, _) => ("finite-plane", paint),
                (_, 0) => ("texture-plane", format!("{paint}; texture \"arrow\"")),
                (_, _) => {
                    let texel = dice.decimal(0.05, 0.3);
                    let image = format!("{paint}; texture \"arrow\" mode=repeat texel={texel}");
                    ("texture-plane", image)
                }
            };
            text.rectangle(
                word,
                &image,
                triple(place),
                [normal, xdir].map(triple),
                sides,
            );
        }
    }
}
