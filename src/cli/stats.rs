//! Output of `render --stats`, and the work in `explain`.

use crate::measure::LightTests;
use crate::render::Counts;

/// The most lights that have a line of their own.
const MOST_LIGHTS: usize = 12;

/// The work of a picture, under a heading.
pub(super) fn table(counts: &Counts, by_light: &[LightTests]) -> String {
    format!("work\n{}", lines(counts, by_light))
}

/// A line for each kind of work, and for each light if there are several.
pub(super) fn lines(counts: &Counts, by_light: &[LightTests]) -> String {
    let rays = [
        ("camera rays", counts.camera_rays),
        ("shadow rays to lights", counts.shadow_rays),
        ("shadow rays to lamps", counts.lamp_rays),
        ("mirrored rays", counts.mirror_rays),
        ("transmitted rays", counts.transmitted_rays),
        ("rays dropped as too faint", counts.faint_rays),
        ("rays dropped by the limit", counts.capped_rays),
        ("hit tests", counts.hit_tests),
        ("shadow tests", counts.occlusion_tests),
    ];
    let decisions = [
        ("texel fetches", counts.texel_fetches),
        ("signs computed exactly", counts.decisions.exactly),
        ("signs decided by rule", counts.decisions.by_rule),
    ];
    let line = |(what, count): (&str, u64)| line(what, count);
    let mut text = rays.map(line).concat();
    if by_light.len() > 1 {
        text.extend(shares(by_light));
    }
    text += &decisions.map(line).concat();
    text + "  (test: one ray against one surface; limit: 1000 rays per camera ray)\n"
}

/// The shadow tests of each light; of very many lights, the last ones together.
fn shares(by_light: &[LightTests]) -> impl Iterator<Item = String> {
    let alone = if by_light.len() > MOST_LIGHTS + 1 {
        MOST_LIGHTS
    } else {
        by_light.len()
    };
    let (alone, others) = by_light.split_at(alone);
    let rest = (!others.is_empty()).then(|| {
        let sum = others.iter().map(|it| it.occlusion_tests).sum();
        line(&format!("  for {} more", others.len()), sum)
    });
    let share = |it: &LightTests| line(&format!("  for {}", it.light.title), it.occlusion_tests);
    alone.iter().map(share).chain(rest)
}

fn line(what: &str, count: u64) -> String {
    format!("  {what:<28}{count:>14}\n")
}
