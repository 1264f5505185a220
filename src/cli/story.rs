//! Output of `explain --pixel`.

use std::fmt::Write;

use super::explanation::placed;
use crate::measure::{HitReport, LightReport, PixelReport, RayReport};
use crate::scene::Scene;

/// The story of a pixel as text.
pub(super) fn text(story: &PixelReport, scene: &Scene, title: &str) -> String {
    let [x, y] = story.pixel;
    let (color, stored) = (color(story.color), stored(story.color, scene));
    let text = format!("pixel {x},{y} of {title}: {color}, stored as {stored}\n");
    let mut story_text = Story { text, title };
    // Writing to a String cannot fail.
    let _ = story_text.rays(&story.rays);
    story_text.text
}

/// Text in the making, about a scene of this title.
struct Story<'a> {
    text: String,
    title: &'a str,
}

impl Story<'_> {
    fn rays(&mut self, rays: &[RayReport]) -> std::fmt::Result {
        if let [ray] = rays {
            return self.step(ray, 0);
        }
        let misses = rays.iter().filter(|ray| ray.hit.is_none()).count();
        if misses > 0 {
            let all = rays.len();
            writeln!(
                self.text,
                "\ncamera rays that hit nothing: {misses} of {all}"
            )?;
        }
        for (number, ray) in (1..).zip(rays).filter(|(_, ray)| ray.hit.is_some()) {
            writeln!(self.text, "\nray {number} of {}", rays.len())?;
            self.step(ray, 1)?;
        }
        Ok(())
    }

    /// A line of its own, indented.
    fn line(&mut self, depth: usize, line: &str) -> std::fmt::Result {
        writeln!(self.text, "{:1$}{line}", "", 2 * depth)
    }

    /// A ray with everything that it caused.
    fn step(&mut self, ray: &RayReport, depth: usize) -> std::fmt::Result {
        let mut name = ray_name(ray.kind);
        let Some(hit) = &ray.hit else {
            return self.line(depth, &format!("{name} hits nothing"));
        };
        if ray.share != [1.0; 3] {
            name += &format!(", weight {}", color(ray.share));
        }
        self.line(depth, &name)?;
        let inner = depth + 1;
        self.hit(hit, inner)?;
        for light in &ray.lights {
            self.arrival(light, inner)?;
        }
        let own = color(ray.own);
        let own = match ray.of_lamps {
            _ if hit.glows => format!("emits {own}"),
            [0.0, 0.0, 0.0] => format!("own colour {own}"),
            of_lamps => format!(
                "own colour {own}, of which {} is from lamps",
                color(of_lamps)
            ),
        };
        self.line(inner, &own)?;
        for unfollowed in &ray.unfollowed {
            let (name, why) = (ray_name(unfollowed.kind), &unfollowed.why);
            self.line(inner, &format!("no {name}: {why}"))?;
        }
        for caused in &ray.causes {
            self.step(caused, inner)?;
        }
        if !ray.causes.is_empty() {
            self.line(inner, &format!("total {}", color(ray.brings)))?;
        }
        Ok(())
    }

    fn hit(&mut self, hit: &HitReport, depth: usize) -> std::fmt::Result {
        let (surface, distance) = (placed(&hit.surface, self.title), number(hit.distance));
        let point = color(hit.place);
        self.line(
            depth,
            &format!("hits {surface} at distance {distance}, point {point}"),
        )?;
        if hit.texel == [1.0; 3] {
            return Ok(());
        }
        self.line(depth, &format!("texture colour {}", color(hit.texel)))
    }

    /// The light of a light or a lamp at the hit.
    fn arrival(&mut self, light: &LightReport, depth: usize) -> std::fmt::Result {
        let (title, what) = (placed(&light.light, self.title), &light.what);
        let arrives = light.arrives.map(|arrives| color(arrives) + " ");
        let arrives = arrives.unwrap_or_default();
        let partial = light.share.filter(|_| light.arrives.is_some());
        let passes = match partial.filter(|share| *share != [1.0; 3]) {
            Some([r, g, b]) if r == g && g == b => format!("; transmittance {}", number(r)),
            Some(share) => format!("; transmittance {}", color(share)),
            None => String::new(),
        };
        self.line(depth, &format!("{title}: {arrives}{what}{passes}"))
    }
}

fn ray_name(kind: &str) -> String {
    match kind {
        "from the eye" => "camera ray".to_owned(),
        kind => format!("{kind} ray"),
    }
}

/// The numbers of a colour in the picture's file.
fn stored(color: [f64; 3], scene: &Scene) -> String {
    let settings = &scene.settings;
    let stored = color.map(|channel| settings.depth.stored(channel, settings.encoding()));
    stored.map(|number| number.to_string()).join(" ")
}

fn color(color: [f64; 3]) -> String {
    color.map(number).join(" ")
}

/// A number with up to four decimals, or with four digits and an exponent.
fn number(number: f64) -> String {
    if number != 0.0 && !(1e-3..1e6).contains(&number.abs()) {
        return format!("{number:.3e}");
    }
    let fixed = format!("{number:.4}");
    fixed.trim_end_matches('0').trim_end_matches('.').to_owned()
}
