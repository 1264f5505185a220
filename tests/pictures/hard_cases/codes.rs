//! Questions about code values.

use dashu::rational::RBig;

use super::cases::Node;
use super::numbers::{double, exact, of, stepped};
use super::rays::Answer;
use super::subject::{Encoding, Rounding, Transfer, code};

/// How the question wants code values: `transfer=` (none), `quantize=` (round), `bits=` (8).
fn asked(node: &Node) -> (Encoding, u16) {
    let encoding = Encoding {
        transfer: Transfer::from_word(node.get("transfer").unwrap_or("none")).expect("a curve"),
        rounding: Rounding::from_word(node.get("quantize").unwrap_or("round")).expect("a rounding"),
    };
    let largest = match node.get("bits") {
        Some("16") => 65_535,
        _ => 255,
    };
    (encoding, largest)
}

/// A value from which on there is another code value.
struct Threshold {
    /// The power of an intensity that is compared.
    power: isize,
    /// What it is compared with.
    limit: RBig,
    /// About the smallest intensity that reaches it.
    intensity: f64,
}

impl Threshold {
    /// The threshold below a code value.
    fn below(code: u16, encoding: Encoding, largest: u16) -> Self {
        let halves = match encoding.rounding {
            Rounding::Nearest => 2 * u32::from(code) - 1,
            Rounding::Truncate => 2 * u32::from(code),
        };
        let value = exact(&format!("{halves}/{}", 2 * u32::from(largest)));
        let straight = |limit: RBig| Self {
            power: 1,
            intensity: limit.to_f64().value(),
            limit,
        };
        match encoding.transfer {
            Transfer::None => straight(value),
            // IEC 61966-2-1, from values to intensities.
            Transfer::Srgb if value <= exact("0.04045") => straight(value / exact("12.92")),
            Transfer::Srgb => {
                let base = (value + exact("0.055")) / exact("1.055");
                Self {
                    power: 5,
                    intensity: base.to_f64().value().powf(2.4),
                    limit: base.pow(12),
                }
            }
        }
    }

    /// The smallest intensity that reaches it.
    fn first(&self) -> f64 {
        let is_reached = |intensity: f64| of(intensity).pow(self.power) >= self.limit;
        let mut first = self.intensity;
        while is_reached(first.next_down()) {
            first = first.next_down();
        }
        while !is_reached(first) {
            first = first.next_up();
        }
        first
    }
}

/// `thresholds nudges=…`: around each threshold every intensity gets the code on its side.
pub(crate) fn thresholds(node: &Node) -> Answer {
    let most: i32 = node.number("nudges").unwrap_or(1);
    let (encoding, largest) = asked(node);
    for above in 1..=largest {
        let first = Threshold::below(above, encoding, largest).first();
        for steps in -most..=most {
            let intensity = stepped(first, steps);
            let truth = if steps < 0 { above - 1 } else { above };
            let found = code(intensity, encoding, largest);
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
    let (encoding, largest) = asked(node);
    let found = code(double(intensity), encoding, largest);
    if Some(found) == expected {
        return Ok(());
    }
    Err(format!("{intensity} becomes {found}"))
}
