//! What rays that are not followed could still have brought.

use crate::light::Light;
use crate::math::{Point, Side};
use crate::scene::{Lighting, Scene};
use crate::surface::Surface;

/// The greatest value that a ray from anywhere can bring back, before it fades with its way to the
/// eye.
///
/// Of what comes back from a surface, `a` is its own and `k` times the greatest value comes from
/// behind or before it, so no ray brings more than the largest `a / (1 − k)` of all surfaces: by
/// induction over the number of bounces, `V ≥ a + k V` for each of them.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Tail {
    brightest: f64,
}

impl Tail {
    /// The tail bound of a scene; infinite if two surfaces could send light to and fro undimmed.
    #[must_use]
    pub fn new(scene: &Scene) -> Self {
        let all = || scene.surfaces.iter().map(AsRef::as_ref);
        // No lamp gives more than a sky as bright.
        let lamps = all().filter_map(|surface| surface.lamp());
        let lamplight = lamps.map(|lamp| lamp.emissivity().largest()).sum();
        let brightest = all().map(|surface| brightest(surface, scene, lamplight));
        Self {
            brightest: brightest.fold(0.0, f64::max),
        }
    }

    /// How much at most a ray of this weight adds to its pixel, if it starts after a way from the
    /// eye that light is divided by `divisor` for.
    #[must_use]
    pub fn of(self, weight: f64, divisor: f64) -> f64 {
        if weight == 0.0 || self.brightest == 0.0 {
            return 0.0;
        }
        let most = weight * self.brightest / divisor;
        // What no number can bound is not bounded.
        if most.is_nan() { f64::INFINITY } else { most }
    }
}

/// The greatest value that can come back from a surface, all its mirror images included.
fn brightest(surface: &dyn Surface, scene: &Scene, lamplight: f64) -> f64 {
    let material = &surface.common().material;
    let [ambient, diffuse] = surface.brightest();
    let glints = if material.shininess > 0.0 {
        material.specular.largest()
    } else {
        0.0
    };
    let lit = scene
        .lights
        .iter()
        .map(|light| strength(surface, light, scene.lighting))
        .map(|[direct, glint]| direct * diffuse + glint * glints);
    let shown = surface
        .lamp()
        .map_or(0.0, |lamp| lamp.emissivity().largest());
    let own =
        (ambient + shown + lamplight * diffuse + lit.sum::<f64>()) * (1.0 - material.transparency);
    let through = material.transparency * material.tint().largest();
    // With an index of refraction the share R is mirrored and the rest shared out as if nothing
    // were: (1 − R)(a + k V) + R V is no more than V where a + k V is not.
    let mirrored = match material.ior {
        None => material.specular.largest(),
        Some(_) => 0.0,
    };
    let kept = through + mirrored;
    if own == 0.0 && kept <= 1.0 {
        return 0.0;
    }
    if kept < 1.0 {
        own / (1.0 - kept)
    } else {
        f64::INFINITY
    }
}

/// How much light of a light can arrive at a surface: as its own colour answers it, with the angle
/// and the distance, and as its glints do, without.
fn strength(surface: &dyn Surface, light: &Light, lighting: Lighting) -> [f64; 2] {
    let emissivity = light.emissivity.largest();
    let fades = |distance: f64| 1.0 / lighting.falloff.divisor(distance);
    if let Some(flat) = surface.flat() {
        if surface.side(&Point::exact(light.location)) != Side::Front {
            return [0.0, 0.0];
        }
        // At height h, light from a distance d comes in with the cosine h/d: both are at their
        // best at the foot of the perpendicular.
        let height = flat.normal.dot(light.location - flat.point);
        return [emissivity * fades(height), emissivity];
    }
    let nearest = surface.round().map_or(0.0, |[center, axes]| {
        // Made a ball of radius 1, no way becomes longer than by the shortest half axis.
        let outside = ((light.location - center) / axes).length() - 1.0;
        outside.max(0.0) * axes.min_element()
    });
    [emissivity * fades(nearest), emissivity]
}
