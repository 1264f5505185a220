//! What `render --stats` prints.

use crate::render::Counts;

/// How much work a picture took.
pub(super) fn table(counts: &Counts) -> String {
    format!("work\n{}", lines(counts))
}

/// A line for each kind of work.
pub(super) fn lines(counts: &Counts) -> String {
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
        ("texels looked up by filters", counts.texel_fetches),
        ("signs taken exactly", counts.decisions.exactly),
        ("ties by rule", counts.decisions.by_rule),
    ];
    let lines = lines.map(|(what, count)| format!("  {what:<28}{count:>14}\n"));
    lines.concat()
}
