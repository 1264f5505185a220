//! Output of `explain`.

use std::fmt::{Result, Write};

use textwrap::core::Word;
use textwrap::{Options, WordSeparator, WordSplitter, WrapAlgorithm};

use super::stats;
use crate::measure::{EffectRow, Explanation, LightRow, NoShadow, SceneItem};
use crate::plan::{Effect, Reachability, Unlit};
use crate::visibility::{Accelerator, MOST_LISTS};

/// The widest line of a list, in columns.
const WIDTH: usize = 100;

/// The most things of a list.
const MOST_NAMES: usize = 12;

/// The effects that reflect or transmit rays.
const SEND_ON: [Effect; 2] = [Effect::Mirrors, Effect::Transparency];

/// An explanation as text.
pub(super) fn text(explanation: &Explanation, title: &str) -> String {
    let mut text = String::new();
    // Writing to a String cannot fail.
    let _ = write_text(&mut text, explanation, title);
    text
}

fn write_text(out: &mut String, explanation: &Explanation, title: &str) -> Result {
    let [width, height] = explanation.size;
    let lamps = explanation.lights.iter().filter(|row| row.is_lamp).count();
    let surfaces = counted(explanation.surfaces.len(), "surface");
    let lights = counted(explanation.lights.len() - lamps, "light");
    write!(
        out,
        "{title}: {width}x{height} pixels, {surfaces}, {lights}"
    )?;
    if lamps > 0 {
        write!(out, ", {}", counted(lamps, "lamp"))?;
    }
    writeln!(
        out,
        "\n\neffects (simulated only if the scene calls for them)"
    )?;
    for row in &explanation.effects {
        effect(out, row, title, explanation.work.is_exact())?;
    }
    if !explanation.lights.is_empty() {
        writeln!(
            out,
            "\nlights (the surfaces that they light, and that can block them)"
        )?;
    }
    for row in &explanation.lights {
        light(out, row, explanation, title)?;
    }
    write_surfaces(out, explanation)?;
    paths(out, explanation)?;
    textures(out, explanation)?;
    let work = &explanation.work;
    if work.is_exact() {
        writeln!(out, "\nwork, counted")?;
    } else {
        let (some, all) = (work.pixels, work.of);
        writeln!(out, "\nwork, estimated from {some} of {all} pixels")?;
    }
    out.write_str(&stats::lines(&work.counts, &work.by_light))
}

fn effect(out: &mut String, row: &EffectRow, title: &str, is_exact: bool) -> Result {
    let switch = if row.on { "on" } else { "off" };
    let about = if is_exact { "" } else { "about " };
    let rays = match row.rays.filter(|_| row.on) {
        Some(rays) => format!(": {about}{rays} rays"),
        None => String::new(),
    };
    let effect = row.effect.title();
    writeln!(out, "  {effect:<15}{switch:<5}{}{rays}", row.why)?;
    let things = row.because_of.iter().map(|thing| placed(thing, title));
    list(out, "because of ", things.collect(), 22)
}

fn light(out: &mut String, row: &LightRow, explanation: &Explanation, title: &str) -> Result {
    let (light, lit) = (placed(&row.light, title), row.lights);
    let surfaces = counted(explanation.surfaces.len(), "surface");
    writeln!(out, "  {light} can light {lit} of {surfaces}")?;
    let name = |index: &usize| explanation.surfaces[*index].surface.title.clone();
    if row.casters.is_none() && row.lights > 0 {
        writeln!(
            out,
            "    the surfaces that can block it are listed in scenes of up to {MOST_LISTS} surfaces"
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
            "everything that it lights is on its own side",
        ),
        (
            NoShadow::FallsBeside,
            "the shadow misses everything that it lights",
        ),
        (NoShadow::Told, "`shadows cast=#false`"),
    ] {
        let some = casting_nothing.clone().filter(|(_, reason)| *reason == why);
        let lead = format!("cannot block this light ({words}): ");
        list(out, &lead, some.map(|(index, _)| name(index)).collect(), 4)?;
    }
    for (why, words) in [
        (Unlit::Behind, "behind the surface or in its plane"),
        (Unlit::Dark, "no emissivity"),
        (Unlit::Colorless, colorless(row.is_lamp)),
        (Unlit::Clear, "fully transparent"),
        (Unlit::OutsideBeam, "outside its beam"),
        (Unlit::Unseen, "never visible"),
    ] {
        let some = row.unlit.iter().filter(|(_, reason)| *reason == why);
        let lead = format!("does not light ({words}): ");
        list(out, &lead, some.map(|(index, _)| name(index)).collect(), 4)?;
    }
    Ok(())
}

/// The reason why a surface looks the same in any light; lamps make no highlights at all.
fn colorless(is_lamp: bool) -> &'static str {
    if is_lamp {
        "no diffuse colour"
    } else {
        "no diffuse colour and no specular highlight"
    }
}

fn write_surfaces(out: &mut String, explanation: &Explanation) -> Result {
    let all = explanation.surfaces.len();
    let those = |seen: Reachability| -> Vec<String> {
        let rows = explanation.surfaces.iter();
        let rows = rows.filter(move |row| row.seen == seen);
        rows.map(|row| row.surface.title.clone()).collect()
    };
    let (sent_on, unseen) = (those(Reachability::SentOn), those(Reachability::Never));
    writeln!(out, "\nsurfaces")?;
    writeln!(out, "  rays can hit {} of {all}", all - unseen.len())?;
    let lead = "visible only in mirrors or through transparent surfaces: ";
    list(out, lead, sent_on, 2)?;
    let is_list = explanation.accelerator == Accelerator::List.word();
    let how = match (is_list, all >= Accelerator::FEWEST) {
        (true, true) => format!(
            "one by one (numerics {:?} use no tree)",
            explanation.numerics
        ),
        (true, false) => format!(
            "one by one (a tree is used above {} surfaces)",
            Accelerator::FEWEST - 1
        ),
        (false, _) => format!(
            "in a tree (used above {} surfaces)",
            Accelerator::FEWEST - 1
        ),
    };
    writeln!(out, "  searched {how}")?;
    let lead = if explanation.effects.iter().any(sends_on) {
        "never hit (out of view, and no mirrored or transmitted ray gets there): "
    } else {
        "never hit (out of view, and nothing mirrors or transmits rays): "
    };
    list(out, lead, unseen, 2)
}

/// True if an effect is on that mirrors or transmits rays.
fn sends_on(row: &EffectRow) -> bool {
    row.on && SEND_ON.contains(&row.effect)
}

/// The rule that ends paths, if there are mirrored or transmitted rays.
fn paths(out: &mut String, explanation: &Explanation) -> Result {
    if !explanation.effects.iter().any(sends_on) {
        return Ok(());
    }
    writeln!(out, "\nmirrored and transmitted rays")?;
    match explanation.cut_off {
        0.0 => writeln!(
            out,
            "  all are followed that can add anything (`cut-off` 0)"
        ),
        share => writeln!(
            out,
            "  a pixel loses at most {share} of white to rays that are not followed (`cut-off`)"
        ),
    }
}

fn textures(out: &mut String, explanation: &Explanation) -> Result {
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

/// A lead and things after it, broken into lines between the things; nothing without things.
fn list(out: &mut String, lead: &str, mut things: Vec<String>, indent: usize) -> Result {
    if things.is_empty() {
        return Ok(());
    }
    let more = things.len().saturating_sub(MOST_NAMES);
    if more > 1 {
        things.truncate(MOST_NAMES);
        things.push(format!("{more} more"));
    }
    let [first, later] = [indent, indent + 2].map(|columns| " ".repeat(columns));
    let options = Options::new(WIDTH)
        .initial_indent(&first)
        .subsequent_indent(&later)
        .break_words(false)
        .word_separator(WordSeparator::Custom(split_at_commas))
        .word_splitter(WordSplitter::NoHyphenation)
        .wrap_algorithm(WrapAlgorithm::FirstFit);
    let text = format!("{lead}{}", things.join(", "));
    writeln!(out, "{}", textwrap::fill(&text, options))
}

/// The parts of a line between which it may be broken.
fn split_at_commas(line: &str) -> Box<dyn Iterator<Item = Word<'_>> + '_> {
    Box::new(line.split_inclusive(", ").map(Word::from))
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
