//! What `render --stats` prints.

use crate::measure::LightTests;
use crate::render::Counts;

/// The most lights that have a line of their own.
const MOST_LIGHTS: usize = 12;

/// How much work a picture took.
pub(super) fn table(counts: &Counts, by_light: &[LightTests]) -> String {
    format!("work\n{}", lines(counts, by_light))
}

/// A line for each kind of work, and for each light if there are several.
pub(super) fn lines(counts: &Counts, by_light: &[LightTests]) -> String {
    let lines = [
        ("rays from the eye", counts.camera_rays),
        ("rays to lights", counts.shadow_rays),
        ("rays to lamps", counts.lamp_rays),
        ("rays from mirrors", counts.mirror_rays),
        ("rays through surfaces", counts.transmitted_rays),
        ("rays cut off as too faint", counts.faint_rays),
        ("rays cut off by the cap", counts.capped_rays),
        ("surfaces asked for a hit", counts.hit_tests),
        ("surfaces asked for a shadow", counts.occlusion_tests),
    ];
    let mut text: String = lines.map(|(what, count)| line(what, count)).concat();
    if by_light.len() > 1 {
        text.extend(shares(by_light));
    }
    let lines = [
        ("texels fetched", counts.texel_fetches),
        ("signs taken exactly", counts.decisions.exactly),
        ("ties by rule", counts.decisions.by_rule),
    ];
    text + &lines.map(|(what, count)| line(what, count)).concat()
}

/// What of the shadows' work each light takes; of very many, the last ones together.
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
