//! Draws one brush stroke with the traces of its bristles.

use crate::canvas::{Canvas, as_float};
use crate::colour::Colour;
use crate::noise::{cell, plane};
use crate::shape::{Point, length, smooth};

/// A stroke that is about to be drawn.
pub(crate) struct Stroke {
    /// The point in its middle.
    pub(crate) middle: Point,
    /// The direction of the brush, of length 1.
    pub(crate) along: Point,
    /// The paint on the brush.
    pub(crate) colour: Colour,
    /// Half its length in pixels.
    pub(crate) reach: f64,
    /// Half its width in pixels.
    pub(crate) radius: f64,
    /// Its place in the order of drawing; also tells its bristles from those of others.
    pub(crate) key: f64,
}

/// Draws one stroke with the traces of its bristles.
pub(crate) fn draw(canvas: &mut Canvas, stroke: &Stroke) {
    let extent = stroke.reach + stroke.radius + 1.0;
    let range = |middle: f64, size: usize| {
        let from = usize::try_from(cell(middle - extent)).unwrap_or(0);
        let to = usize::try_from(cell(middle + extent) + 1).unwrap_or(0);
        from..to.min(size)
    };
    for row in range(stroke.middle.1, canvas.height()) {
        for column in range(stroke.middle.0, canvas.width()) {
            let dx = as_float(column) + 0.5 - stroke.middle.0;
            let dy = as_float(row) + 0.5 - stroke.middle.1;
            let u = dx * stroke.along.0 + dy * stroke.along.1;
            let v = dy * stroke.along.0 - dx * stroke.along.1;
            // A slight bend is livelier than a straight rod.
            let v = v + 0.12 * stroke.radius * (u / stroke.reach) * (u / stroke.reach);
            let over = (u.abs() - (stroke.reach - stroke.radius).max(0.0)).max(0.0);
            let distance = length(over, v) - stroke.radius;
            if distance > 0.5 {
                continue;
            }
            let hair = plane(v * 1.1 + 3200.0 * stroke.key, u * 0.06, 17, [0, 0]) - 0.5;
            let ragged = smooth(0.5, -0.8, distance + 0.5 * stroke.radius * hair.max(0.0));
            let cover = ragged * (0.80 + 0.4 * hair).min(1.0);
            // Thick paint stands up at the stroke's rim and catches the light.
            let ridge = 1.0 + 0.08 * hair + 0.025 * smooth(-2.0, -0.2, distance) * -v.signum();
            let under = canvas.get(column, row);
            canvas.set(column, row, under.mix(stroke.colour * ridge, cover));
        }
    }
}
