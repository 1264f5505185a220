//! Whether the beam of a light certainly passes by a surface.

use glam::DVec3;

use crate::light::Cone;
use crate::math::{Bounds, Rectangle, UNIT};

/// How far a surface has to be outside of a beam, as an angle in radians: 2⁻²⁰.
///
/// Far more than rounding can move what a beam lights, and nothing to speak of in a scene. Smaller,
/// and rounding could take light away; larger, and more rays are sent in vain.
const MARGIN: f64 = 1.0 / 1_048_576.0;

/// Whether a cone of light certainly lights nothing of what is in a box.
pub(super) fn cone_passes_by(location: DVec3, cone: &Cone, bounds: &Bounds) -> bool {
    let center = bounds.min.midpoint(bounds.max);
    let (way, radius) = (center - location, (bounds.max - center).length());
    let distance = way.length();
    // Next to the box the angle changes fast, and rounding counts for more.
    if !(radius < 0.9 * distance && is_clear(location, center, distance)) {
        return false;
    }
    let cosine = (cone.axis().dot(way) / distance).clamp(-1.0, 1.0);
    libm::acos(cosine) - libm::asin(radius / distance) > cone.angle() + MARGIN
}

/// Whether light through a slide certainly lights nothing of what is in a box.
pub(super) fn slide_passes_by(location: DVec3, slide: &Rectangle, bounds: &Bounds) -> bool {
    let corners = slide.corners();
    let next = corners.iter().cycle().skip(1);
    let inner = corners.iter().cycle().skip(2);
    let mut borders = corners.iter().zip(next).zip(inner);
    borders.any(|((from, to), inner)| {
        // Through the light and a border of the slide.
        let normal = (*from - location).cross(*to - location);
        let inside = normal.dot(*inner - location);
        let size = normal.length() * (*inner - location).length();
        let is_wide = inside.abs() > MARGIN * size;
        is_wide
            && bounds.corners().iter().all(|corner| {
                let way = *corner - location;
                let height = normal.dot(way) * inside.signum();
                let size = normal.length() * way.length();
                height < -MARGIN * size && is_clear(location, *corner, way.length())
            })
    })
}

/// Whether two places are so far apart that the way between them is not mostly rounding.
fn is_clear(a: DVec3, b: DVec3, distance: f64) -> bool {
    64.0 * UNIT * (a.length() + b.length()) < MARGIN / 16.0 * distance
}
