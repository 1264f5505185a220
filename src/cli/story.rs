//! What `explain --pixel` prints.

use std::fmt::Write;

use super::explanation::placed;
use crate::measure::{LightStep, Met, PixelStory, Step};
use crate::scene::Scene;

/// The story of a pixel for people.
pub(super) fn text(story: &PixelStory, scene: &Scene, title: &str) -> String {
    let mut text = String::new();
    // Writing to a String cannot fail.
    let _ = write_text(&mut text, story, scene, title);
    text
}

fn write_text(
    out: &mut String,
    story: &PixelStory,
    scene: &Scene,
    title: &str,
) -> std::fmt::Result {
    let [x, y] = story.pixel;
    let kept = kept(story.color, scene);
    let color = color(story.color);
    writeln!(
        out,
        "pixel {x},{y} of {title}: {color}, in the picture {kept}"
    )?;
    if let [ray] = &story.rays[..] {
        return step(out, ray, title, 0);
    }
    let all = story.rays.len();
    match story.rays.iter().filter(|ray| ray.met.is_none()).count() {
        0 => {}
        1 => writeln!(out, "\n1 of {all} rays from the eye meets nothing")?,
        some if some == all => writeln!(out, "\nall {all} rays from the eye meet nothing")?,
        some => writeln!(out, "\n{some} of {all} rays from the eye meet nothing")?,
    }
    for (number, ray) in (1..).zip(&story.rays) {
        if ray.met.is_some() {
            writeln!(out, "\nray {number} of {all}")?;
            step(out, ray, title, 1)?;
        }
    }
    Ok(())
}

/// What became of a ray and of all that it caused.
fn step(out: &mut String, ray: &Step, title: &str, depth: usize) -> std::fmt::Result {
    let indent = 2 * depth;
    let Some(met) = &ray.met else {
        return writeln!(out, "{:indent$}ray {} meets nothing", "", ray.kind);
    };
    meeting(out, ray, met, title, indent)?;
    for light in &ray.lights {
        arrival(out, light, title, indent)?;
    }
    let its_own = match ray.of_lamps {
        _ if met.glows => "of its own glow".to_owned(),
        [0.0, 0.0, 0.0] => "of its own".to_owned(),
        of_lamps => format!("of its own, of which {} is light of lamps", color(of_lamps)),
    };
    writeln!(
        out,
        "{:indent$}  sends back {} {its_own}",
        "",
        color(ray.own)
    )?;
    for unfollowed in &ray.unfollowed {
        let (kind, why) = (unfollowed.kind, &unfollowed.why);
        writeln!(out, "{:indent$}  no ray {kind}: {why}", "")?;
    }
    for caused in &ray.causes {
        step(out, caused, title, depth + 1)?;
    }
    if !ray.causes.is_empty() {
        writeln!(
            out,
            "{:indent$}  sends back {} in all",
            "",
            color(ray.brings)
        )?;
    }
    Ok(())
}

/// Where a ray meets a surface, and which.
fn meeting(
    out: &mut String,
    ray: &Step,
    met: &Met,
    title: &str,
    indent: usize,
) -> std::fmt::Result {
    let kind = ray.kind;
    let share = if ray.share == [1.0; 3] {
        String::new()
    } else {
        format!(", of which {} counts", color(ray.share))
    };
    let [x, y, z] = met.place.map(number);
    writeln!(
        out,
        "{:indent$}ray {kind}{share}\n{:indent$}  meets {} after {}, at {x} {y} {z}",
        "",
        "",
        placed(&met.surface, title),
        number(met.distance),
    )?;
    if met.texel != [1.0; 3] {
        writeln!(
            out,
            "{:indent$}  its image is {} there",
            "",
            color(met.texel)
        )?;
    }
    Ok(())
}

/// What arrives there from a light or a lamp.
fn arrival(out: &mut String, light: &LightStep, title: &str, indent: usize) -> std::fmt::Result {
    let arrives = light.arrives.map(|arrives| color(arrives) + " ");
    let arrives = arrives.unwrap_or_default();
    let light_title = placed(&light.light, title);
    let partial = light.share.filter(|_| light.arrives.is_some());
    let share = match partial.filter(|share| *share != [1.0; 3]) {
        Some([r, g, b]) if r == g && g == b => format!(": {} of its light passes", number(r)),
        Some(share) => format!(": {} of its light passes", color(share)),
        None => String::new(),
    };
    writeln!(
        out,
        "{:indent$}  {light_title}: {arrives}{}{share}",
        "", light.what
    )
}

/// What the picture's file says of a colour.
fn kept(color: [f64; 3], scene: &Scene) -> String {
    let picture = &scene.settings;
    let kept = color.map(|channel| picture.depth.stored(channel, picture.encoding()));
    kept.map(|number| number.to_string()).join(" ")
}

fn color(color: [f64; 3]) -> String {
    color.map(number).join(" ")
}

/// A number with four digits, but no more behind the point than it needs.
fn number(number: f64) -> String {
    if number != 0.0 && !(1e-3..1e6).contains(&number.abs()) {
        return format!("{number:.3e}");
    }
    let fixed = format!("{number:.4}");
    fixed.trim_end_matches('0').trim_end_matches('.').to_owned()
}
