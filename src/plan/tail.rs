//! The tail bound: the largest light that a ray can add.

use crate::light::Light;
use crate::math::{Point, Side};
use crate::scene::{Lighting, Scene};
use crate::surface::Surface;

/// A bound of the colour along any ray, before falloff with the path length.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Tail {
    // Let a surface add at most `a` of its own and `k` times the colour along a scattered ray. Then
    // V = max a / (1 − k) over all surfaces bounds every ray, by induction over the number of
    // bounces: V ≥ a + k V for each surface.
    brightest: f64,
}

impl Tail {
    /// The tail bound of a scene; infinite if reflections may lose no light.
    #[must_use]
    pub fn new(scene: &Scene) -> Self {
        let all = || scene.surfaces.iter().map(AsRef::as_ref);
        // A lamp lights a surface at most as much as a sky of its emissivity.
        let lamps = all().filter_map(|surface| surface.lamp());
        let lamplight = lamps.map(|lamp| lamp.emissivity().largest()).sum();
        let brightest = all().map(|surface| brightest(surface, scene, lamplight));
        Self {
            brightest: brightest.fold(0.0, f64::max),
        }
    }

    /// The largest light that a ray of this weight adds to its pixel.
    ///
    /// `divisor` is the falloff for the path length from the eye to the ray's origin.
    #[must_use]
    pub fn of(self, weight: f64, divisor: f64) -> f64 {
        if weight == 0.0 || self.brightest == 0.0 {
            return 0.0;
        }
        let most = weight * self.brightest / divisor;
        // Zero times infinity has no bound.
        if most.is_nan() { f64::INFINITY } else { most }
    }
}

/// The bound `a / (1 − k)` of the colour along a ray that hits a surface.
fn brightest(surface: &dyn Surface, scene: &Scene, lamplight: f64) -> f64 {
    let material = &surface.common().material;
    let [ambient, diffuse] = surface.brightest();
    let highlights = if material.shininess > 0.0 {
        material.specular.largest()
    } else {
        0.0
    };
    let lit = scene
        .lights
        .iter()
        .map(|light| strength(surface, light, scene.lighting))
        .map(|[direct, specular]| direct * diffuse + specular * highlights);
    let shown = surface
        .lamp()
        .map_or(0.0, |lamp| lamp.emissivity().largest());
    let own =
        (ambient + shown + lamplight * diffuse + lit.sum::<f64>()) * (1.0 - material.transparency);
    let through = material.transparency * material.tint().largest();
    // With an index of refraction, the share R is reflected, and 1 − R is treated as without one:
    // (1 − R)(a + k V) + R V ≤ V if a + k V ≤ V.
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

/// The largest light of a point light at a surface: diffuse and specular.
///
/// The diffuse one includes the cosine and the falloff, the specular one includes neither.
fn strength(surface: &dyn Surface, light: &Light, lighting: Lighting) -> [f64; 2] {
    let emissivity = light.emissivity.largest();
    let attenuation = |distance: f64| 1.0 / lighting.falloff.divisor(distance);
    if let Some(flat) = surface.shape().carrier() {
        if surface.shape().side(&Point::exact(light.location)) != Side::Front {
            return [0.0, 0.0];
        }
        // At height h, light from a distance d has the cosine h/d. Cosine and falloff are largest
        // at the foot of the perpendicular.
        let height = flat.normal.dot(light.location - flat.point);
        return [emissivity * attenuation(height), emissivity];
    }
    let nearest = surface.shape().round().map_or(0.0, |[center, axes]| {
        // Scaled to a ball of radius 1, lengths grow at most by one over the shortest half axis.
        let outside = ((light.location - center) / axes).length() - 1.0;
        outside.max(0.0) * axes.min_element()
    });
    [emissivity * attenuation(nearest), emissivity]
}
