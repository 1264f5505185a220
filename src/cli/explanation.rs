//! What `explain` prints.

use std::fmt::Write;

use super::stats;
use crate::measure::{EffectRow, Explanation, LightRow, NoShadow, SceneItem};
use crate::plan::{Effect, Reachability, Unlit};
use crate::visibility::{Accelerator, MOST_LISTS};

/// The widest line that a list of things may fill, in columns.
const WIDTH: usize = 100;

/// The most surfaces that a line names.
const MOST_NAMES: usize = 12;

/// The effects that send rays on.
const SEND_ON: [Effect; 2] = [Effect::Mirrors, Effect::Transparency];

/// An explanation for people.
pub(super) fn text(explanation: &Explanation, title: &str) -> String {
    let mut text = String::new();
    // Writing to a String cannot fail.
    let _ = write_text(&mut text, explanation, title);
    text
}

fn write_text(out: &mut String, explanation: &Explanation, title: &str) -> std::fmt::Result {
    let [width, height] = explanation.size;
    let lamps = explanation.lights.iter().filter(|row| row.is_lamp).count();
    write!(
        out,
        "{title}: {width}x{height} pixels, {}, {}",
        counted(explanation.surfaces.len(), "surface"),
        counted(explanation.lights.len() - lamps, "light"),
    )?;
    if lamps > 0 {
        write!(out, ", {}", counted(lamps, "lamp"))?;
    }
    writeln!(out)?;
    writeln!(out, "\neffects")?;
    for row in &explanation.effects {
        effect(out, row, title, explanation.work.is_exact())?;
    }
    if !explanation.lights.is_empty() {
        writeln!(out, "\nlights")?;
    }
    for row in &explanation.lights {
        light(out, row, explanation, title)?;
    }
    surfaces(out, explanation)?;
    paths(out, explanation)?;
    textures(out, explanation)?;
    work(out, explanation)
}

fn effect(out: &mut String, row: &EffectRow, title: &str, is_exact: bool) -> std::fmt::Result {
    let switch = if row.on { "on" } else { "off" };
    let cost = match row.rays {
        Some(rays) if row.on && is_exact => format!(": {rays} rays"),
        Some(rays) if row.on => format!(": about {rays} rays"),
        _ => String::new(),
    };
    let effect = row.effect.title();
    writeln!(out, "  {effect:<15}{switch:<5}{}{cost}", row.why)?;
    let things = row.because_of.iter().map(|thing| placed(thing, title));
    list(out, "because of ", things.collect(), 22)
}

fn light(
    out: &mut String,
    row: &LightRow,
    explanation: &Explanation,
    title: &str,
) -> std::fmt::Result {
    writeln!(
        out,
        "  {} lights {} of {}",
        placed(&row.light, title),
        row.lights,
        counted(explanation.surfaces.len(), "surface"),
    )?;
    casters(out, row, explanation)?;
    unlit(out, row, explanation)
}

/// Which surfaces cast a shadow in a light, and which do not.
fn casters(out: &mut String, row: &LightRow, explanation: &Explanation) -> std::fmt::Result {
    let name = |index: &usize| explanation.surfaces[*index].surface.title.clone();
    if row.casters.is_none() && row.lights > 0 {
        writeln!(
            out,
            "    which surface can shadow which is worked out for {MOST_LISTS} surfaces at most; of more, all are searched"
        )?;
    }
    for (caster, onto) in row.casters.iter().flatten() {
        let lead = format!("{} can cast a shadow on ", name(caster));
        list(out, &lead, onto.iter().map(name).collect(), 4)?;
    }
    let casting_nothing = row.casts_nothing.iter().flatten();
    for (why, words) in [
        (
            NoShadow::NothingBehind,
            "casts nothing, for all that this light lights is on its own side of it: ",
        ),
        (
            NoShadow::FallsBeside,
            "casts nothing, for its shadow falls beside all that this light lights: ",
        ),
        (NoShadow::Told, "casts nothing, for the scene says so: "),
    ] {
        let some = casting_nothing.clone().filter(|(_, reason)| *reason == why);
        list(out, words, some.map(|(index, _)| name(index)).collect(), 4)?;
    }
    Ok(())
}

/// Which surfaces a light does not light.
fn unlit(out: &mut String, row: &LightRow, explanation: &Explanation) -> std::fmt::Result {
    let name = |index: &usize| explanation.surfaces[*index].surface.title.clone();
    for (why, words) in [
        (Unlit::Behind, "is behind or in the plane of "),
        (Unlit::Dark, "has no emissivity, so it does not light "),
        (
            Unlit::Colorless,
            if row.is_lamp {
                "finds no diffuse colour on "
            } else {
                "finds neither diffuse colour nor glints on "
            },
        ),
        (Unlit::Clear, "need not light what lets all light through: "),
        (Unlit::OutsideBeam, "shines past "),
        (Unlit::Unseen, "need not light what nobody sees: "),
    ] {
        let some = row.unlit.iter().filter(|(_, reason)| *reason == why);
        list(out, words, some.map(|(index, _)| name(index)).collect(), 4)?;
    }
    Ok(())
}

fn surfaces(out: &mut String, explanation: &Explanation) -> std::fmt::Result {
    let all = explanation.surfaces.len();
    let those = |seen: Reachability| {
        let rows = explanation.surfaces.iter();
        let rows = rows.filter(move |row| row.seen == seen);
        rows.map(|row| row.surface.title.clone())
            .collect::<Vec<_>>()
    };
    let (sent_on, unseen) = (those(Reachability::SentOn), those(Reachability::Never));
    writeln!(out, "\nsurfaces")?;
    writeln!(out, "  {} of {all} can be met by a ray", all - unseen.len())?;
    list(
        out,
        "out of sight, but in mirrors or behind glass: ",
        sent_on,
        2,
    )?;
    let is_classic =
        explanation.accelerator == Accelerator::List.word() && all >= Accelerator::FEWEST;
    let beside = if is_classic {
        format!("numerics {:?} have no tree", explanation.numerics)
    } else {
        format!("a tree pays from {} surfaces on", Accelerator::FEWEST)
    };
    let accelerator = explanation.accelerator;
    writeln!(out, "  they are found by a {accelerator}; {beside}")?;
    let nothing_sends = explanation
        .effects
        .iter()
        .all(|row| !row.on || !SEND_ON.contains(&row.effect));
    let why = if nothing_sends {
        "nobody sees, for it is out of sight and nothing sends rays on: "
    } else {
        "nobody sees, for it is out of sight and no mirror or pane sends rays there: "
    };
    list(out, why, unseen, 2)
}

/// When rays end, if there are any that could go on.
fn paths(out: &mut String, explanation: &Explanation) -> std::fmt::Result {
    let goes_on = |row: &EffectRow| row.on && SEND_ON.contains(&row.effect);
    if !explanation.effects.iter().any(goes_on) {
        return Ok(());
    }
    writeln!(out, "\npaths")?;
    if explanation.cut_off == 0.0 {
        return writeln!(
            out,
            "  rays are followed as long as they could add anything"
        );
    }
    writeln!(
        out,
        "  rays are followed until all that a pixel could still lack is below {} (`cut-off`)",
        explanation.cut_off,
    )
}

fn textures(out: &mut String, explanation: &Explanation) -> std::fmt::Result {
    if explanation.textures.is_empty() {
        return Ok(());
    }
    writeln!(out, "\ntextures")?;
    for texture in &explanation.textures {
        let [width, height] = texture.size;
        let kibibytes = texture.bytes.div_ceil(1024);
        let name = format!("{:?}", texture.name);
        writeln!(out, "  {name:<16}{width}x{height} texels, {kibibytes} KiB")?;
    }
    Ok(())
}

fn work(out: &mut String, explanation: &Explanation) -> std::fmt::Result {
    let work = &explanation.work;
    if work.is_exact() {
        writeln!(out, "\nwork, counted")?;
    } else {
        writeln!(
            out,
            "\nwork, estimated from {} of {} pixels",
            work.pixels, work.of
        )?;
    }
    out.write_str(&stats::lines(&work.counts, &work.by_light))
}

/// A lead and things after it, broken into lines; nothing if there are no things.
fn list(out: &mut String, lead: &str, mut things: Vec<String>, indent: usize) -> std::fmt::Result {
    if things.is_empty() {
        return Ok(());
    }
    let more = things.len().saturating_sub(MOST_NAMES);
    if more > 1 {
        things.truncate(MOST_NAMES);
        things.push(format!("{more} more"));
    }
    let mut line = format!("{:indent$}{lead}", "");
    let last = things.len() - 1;
    for (index, thing) in things.iter().enumerate() {
        let comma = if index == last { "" } else { ", " };
        let width = line.chars().count() + thing.chars().count() + comma.trim_end().len();
        if width > WIDTH && index > 0 {
            writeln!(out, "{}", line.trim_end())?;
            line = format!("{:1$}", "", indent + 2);
        }
        line += thing;
        line += comma;
    }
    writeln!(out, "{line}")
}

/// A thing with its line, or with its file and line if it stands in an included one.
pub(super) fn placed(thing: &SceneItem, scene: &str) -> String {
    let Some(place) = &thing.place else {
        return thing.title.clone();
    };
    let line = place.rsplit_once(':').map_or(&**place, |(line, _)| line);
    match line.strip_prefix(scene) {
        Some(line) => format!("{} (line {})", thing.title, line.trim_start_matches(':')),
        None => format!("{} ({line})", thing.title),
    }
}

/// A number with a noun.
pub(super) fn counted(count: usize, noun: &str) -> String {
    let ending = if count == 1 { "" } else { "s" };
    format!("{count} {noun}{ending}")
}
