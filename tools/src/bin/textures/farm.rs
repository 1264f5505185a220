//! Draws the farm on the slide: a white house with a red roof, and an apple tree.

use crate::colour::Colour;
use crate::noise::fractal;
use crate::shape::{
    Point, circles, ellipse, fraction, length, polygon, rectangle, segment, smooth,
};

/// The crown of the tree as circles: place and radius.
const CROWN: [(f64, f64, f64); 6] = [
    (62.0, 128.0, 20.0),
    (44.0, 140.0, 16.0),
    (80.0, 140.0, 17.0),
    (52.0, 152.0, 15.0),
    (72.0, 152.0, 16.0),
    (62.0, 142.0, 18.0),
];

/// A white house with a red roof.
pub(crate) fn house(p: Point, under: Colour) -> Colour {
    let wall = rectangle(p, (216.0, 172.0), (31.0, 20.0), 0.0);
    let side = Colour::hex(0xff_f2_d6).mix(Colour::hex(0xdc_c4_a0), smooth(228.0, 230.0, p.0));
    let mut picture = under.cover(side, wall);
    let chimney = rectangle(p, (234.0, 132.0), (4.5, 12.0), 0.0);
    picture = picture.cover(Colour::hex(0xa4_4a_34), chimney);
    let roof = polygon(
        p,
        &[
            (178.0, 154.0),
            (196.0, 126.0),
            (238.0, 126.0),
            (254.0, 154.0),
        ],
    );
    let tiles = fraction(p.1 / 5.6);
    let red = Colour::hex(0xe6_3c_2c).mix(Colour::hex(0xb8_26_24), smooth(0.55, 0.95, tiles));
    picture = picture.cover(red, roof);
    picture = picture.cover(
        Colour::hex(0x2a_5c_b4),
        rectangle(p, (212.0, 181.0), (6.0, 12.0), 1.0),
    );
    picture = picture.cover(
        Colour::hex(0xff_d8_4a),
        length(p.0 - 215.5, p.1 - 181.0) - 1.1,
    );
    for x in [195.0, 238.0] {
        picture = picture.cover(
            Colour::hex(0xff_ff_ff),
            rectangle(p, (x, 171.0), (6.5, 7.0), 0.5),
        );
        let pane = rectangle(p, (x, 171.0), (5.0, 5.5), 0.0);
        let bars = (p.0 - x).abs().min((p.1 - 171.0).abs()) - 0.7;
        picture = picture.cover(Colour::hex(0x4a_a8_e6), pane.max(-bars));
    }
    picture
}

/// A round tree on the left with its shadow.
pub(crate) fn tree(p: Point, under: Colour) -> Colour {
    let shadow = ellipse(p, (82.0, 203.0), (34.0, 5.0));
    let mut picture = under.mix(Colour::hex(0x1c_66_2c), 0.55 * smooth(3.0, -3.0, shadow));
    let trunk =
        segment(p, (62.0, 150.0), (62.0, 202.0)) - 4.5 - 0.0016 * (p.1 - 160.0) * (p.1 - 160.0);
    let bark = Colour::hex(0x96_5c_2c).mix(Colour::hex(0x5e_36_1a), smooth(59.0, 67.0, p.0));
    picture = picture.cover(bark, trunk.max(p.1 - 204.0));
    let leaf = 4.0 * (fractal(p.0 * 0.22, p.1 * 0.22, 3, 12, [0, 0]) - 0.5);
    let lit = circles((p.0 + 6.0, p.1 + 8.0), &CROWN) + leaf;
    let green = Colour::hex(0x1e_7a_36).mix(Colour::hex(0x4e_c4_3a), smooth(2.0, -9.0, lit));
    picture = picture.cover(green, circles(p, &CROWN) + leaf);
    // Apples.
    for (x, y) in [
        (48.0, 136.0),
        (70.0, 128.0),
        (82.0, 144.0),
        (60.0, 150.0),
        (44.0, 151.0),
    ] {
        picture = picture.cover(Colour::hex(0xf0_32_2e), length(p.0 - x, p.1 - y) - 2.6);
        picture = picture.cover(
            Colour::hex(0xff_a0_90),
            length(p.0 - x + 0.9, p.1 - y + 0.9) - 0.8,
        );
    }
    picture
}
