//! The decision about each effect, with its reason.

use super::{Cause, Decision, Effect, Plan};
use crate::camera::Pattern;
use crate::film::Transfer;
use crate::light::{Beam, Light};
use crate::scene::RenderSettings;
use crate::surface::Surface;
use crate::texture::Filter;

/// The decisions about all effects.
pub(super) fn all(plan: &Plan<'_>) -> Vec<Decision> {
    Effect::ALL.map(|effect| decide(plan, effect)).into()
}

fn decide(plan: &Plan<'_>, effect: Effect) -> Decision {
    match effect {
        Effect::Shadows => shadows(plan),
        Effect::SoftShadows => soft_shadows(plan),
        Effect::Mirrors => of_surfaces(
            plan,
            effect,
            |surface| surface.common().material.mirrors(),
            ["mirrors what is before it", "mirror what is before them"],
            "`specular` or `ior`",
        ),
        Effect::Transparency => of_surfaces(
            plan,
            effect,
            |surface| surface.common().material.transparency > 0.0,
            ["lets light through", "let light through"],
            "`transparency`",
        ),
        Effect::Refraction => of_surfaces(
            plan,
            effect,
            |surface| surface.common().material.is_entered(),
            ["bends light", "bend light"],
            "both `ior` and `transparency`",
        ),
        Effect::Glints => glints(plan),
        Effect::SpotCones => of_lights(plan, effect, |light| matches!(light.beam, Beam::Cone(_))),
        Effect::Projectors => of_lights(plan, effect, |light| matches!(light.beam, Beam::Slide(_))),
        Effect::Textures => of_surfaces(
            plan,
            effect,
            |surface| surface.texture().is_some(),
            ["wears an image", "wear an image"],
            "`texture`",
        ),
        Effect::TextureFilter => texture_filter(plan),
        Effect::Antialiasing => antialiasing(plan),
        Effect::TransferCurve => transfer_curve(plan),
    }
}

fn shadows(plan: &Plan<'_>) -> Decision {
    let lights = plan.scene.lights.iter().zip(&plan.lights);
    let all = lights.clone().count();
    let hidden = lights.filter(|(_, planned)| {
        let mut receivers = surfaces(plan, shows_shadows);
        receivers.any(|(index, _)| !planned.view.occluders_of(index).is_empty())
    });
    let causes: Vec<_> = hidden.map(|(light, _)| Cause::of_light(light)).collect();
    let why = match (all, causes.len()) {
        (0, _) if plan.lamps.is_empty() => "there is no light".to_owned(),
        (0, _) => "there is no light but that of lamps".to_owned(),
        (_, 0) => "nothing can stand between a light and what it lights".to_owned(),
        (1, _) => "something can stand before the light".to_owned(),
        (all, some) => format!("something can stand before {some} of {all} lights"),
    };
    Decision::new(Effect::Shadows, why, causes)
}

fn soft_shadows(plan: &Plan<'_>) -> Decision {
    let hidden = plan.lamps.iter().filter(|planned| {
        let mut receivers = surfaces(plan, shows_shadows);
        receivers.any(|(index, _)| !planned.view.occluders_of(index).is_empty())
    });
    let lamps = hidden.filter_map(|planned| planned.view.lamp());
    let causes: Vec<_> = lamps.map(|lamp| Cause::of_surface(lamp)).collect();
    let why = match (plan.lamps.len(), causes.len()) {
        (0, _) => "the scene has no lamps".to_owned(),
        (_, 0) => "nothing can stand between a lamp and what it lights".to_owned(),
        (1, _) => "something can stand before the lamp".to_owned(),
        (all, some) => format!("something can stand before {some} of {all} lamps"),
    };
    Decision::new(Effect::SoftShadows, why, causes)
}

/// Returns whether a shadow on a surface would be visible.
fn shows_shadows(surface: &dyn Surface) -> bool {
    let ([_, diffuse], common) = (surface.brightest(), surface.common());
    common.shadows.receive && (diffuse > 0.0 || common.material.has_highlights())
}

fn glints(plan: &Plan<'_>) -> Decision {
    let is_lit = |index: usize| plan.lights.iter().any(|it| it.unlit[index].is_none());
    let shiny: Vec<_> =
        surfaces(plan, |surface| surface.common().material.has_highlights()).collect();
    let lit: Vec<_> = shiny.iter().filter(|(index, _)| is_lit(*index)).collect();
    let why = match (shiny.len(), lit.len()) {
        (0, _) => "no material has both `shininess` and `specular`".to_owned(),
        (_, 0) => "no light lights what is shiny".to_owned(),
        (_, 1) => "1 surface is shiny and lit".to_owned(),
        (_, some) => format!("{some} surfaces are shiny and lit"),
    };
    let causes = lit
        .into_iter()
        .map(|(_, surface)| Cause::of_surface(*surface));
    Decision::new(Effect::Glints, why, causes.collect())
}

fn texture_filter(plan: &Plan<'_>) -> Decision {
    let filter = plan.scene.settings.texture_filter;
    if filter == Filter::Nearest {
        let why = "each pixel shows the texel in its middle".to_owned();
        return Decision::new(Effect::TextureFilter, why, Vec::new());
    }
    let textures = decide(plan, Effect::Textures);
    let why = if textures.on {
        format!("`texture-filter` asks for {:?}", filter.word())
    } else {
        textures.why
    };
    Decision::new(Effect::TextureFilter, why, textures.causes)
}

fn antialiasing(plan: &Plan<'_>) -> Decision {
    let RenderSettings {
        samples,
        pattern,
        max_error,
        ..
    } = plan.scene.settings;
    let on = samples > 1 || max_error > 0.0;
    let why = match (on, pattern == Pattern::default()) {
        _ if max_error > 0.0 => format!(
            "`max-error` asks for as many rays, {} or more through each pixel, as its error takes to \
             be about {max_error:.5} at most",
            plan.scene.settings.first_rays(),
        ),
        (false, _) => "one ray goes through the centre of each pixel".to_owned(),
        (true, true) => format!("`samples` asks for {samples} rays through each pixel"),
        (true, false) => format!(
            "`samples` asks for {samples} rays through each pixel, in the pattern {:?}",
            pattern.word()
        ),
    };
    Decision::new(Effect::Antialiasing, why, of_settings(plan, on))
}

fn transfer_curve(plan: &Plan<'_>) -> Decision {
    let (on, why) = match plan.scene.settings.transfer {
        Transfer::None => (false, "code values are shares of intensity 1"),
        Transfer::Srgb => (true, "`transfer` asks for that of sRGB"),
    };
    let causes = of_settings(plan, on);
    Decision::new(Effect::TransferCurve, why.to_owned(), causes)
}

/// The picture as the only cause, if it is one.
fn of_settings(plan: &Plan<'_>, causes_effect: bool) -> Vec<Cause> {
    let settings = &plan.scene.settings;
    causes_effect
        .then(|| Cause::of_picture(settings))
        .into_iter()
        .collect()
}

/// The decision about an effect of surfaces that rays can hit.
fn of_surfaces(
    plan: &Plan<'_>,
    effect: Effect,
    causes_effect: impl Fn(&dyn Surface) -> bool,
    [one_does, some_do]: [&str; 2],
    attribute: &str,
) -> Decision {
    let having: Vec<_> = surfaces(plan, causes_effect).collect();
    let seen: Vec<_> = having
        .iter()
        .filter(|(index, _)| plan.reachability[*index].is_reached())
        .collect();
    let why = match (having.len(), seen.len()) {
        (0, _) => format!("no surface has {attribute}"),
        (_, 0) => format!("no surface that can be seen has {attribute}"),
        (_, 1) => format!("1 surface {one_does}"),
        (_, some) => format!("{some} surfaces {some_do}"),
    };
    let causes = seen
        .into_iter()
        .map(|(_, surface)| Cause::of_surface(*surface));
    Decision::new(effect, why, causes.collect())
}

/// The decision about an effect of lights that light some surface.
fn of_lights(plan: &Plan<'_>, effect: Effect, causes_effect: impl Fn(&Light) -> bool) -> Decision {
    let lights = plan.scene.lights.iter().zip(&plan.lights);
    let having: Vec<_> = lights.filter(|(light, _)| causes_effect(light)).collect();
    let useful = having
        .iter()
        .filter(|(_, it)| it.unlit.iter().any(Option::is_none));
    let causes: Vec<_> = useful.map(|(light, _)| Cause::of_light(light)).collect();
    let title = effect.title();
    let why = match (having.len(), causes.len()) {
        (0, _) => format!("the scene has no {title}"),
        (_, 0) => format!("what is in the {title} cannot be lit or seen"),
        (all, some) => format!("{some} of {all} {title} light something"),
    };
    Decision::new(effect, why, causes)
}

fn surfaces<'p>(
    plan: &'p Plan<'_>,
    causes_effect: impl Fn(&dyn Surface) -> bool + 'p,
) -> impl Iterator<Item = (usize, &'p dyn Surface)> {
    let all = plan.scene.surfaces.iter().map(AsRef::as_ref).enumerate();
    all.filter(move |(_, surface)| causes_effect(*surface))
}

impl Decision {
    /// The decision to simulate an effect if it has causes.
    fn new(effect: Effect, why: String, causes: Vec<Cause>) -> Self {
        Self {
            effect,
            on: !causes.is_empty(),
            why,
            causes,
        }
    }
}
