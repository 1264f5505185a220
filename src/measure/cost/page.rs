//! Results as a self-contained HTML page.

use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use serde_json::json;

use super::choice::Best;
use super::measurement::Measurement;
use super::pictures;
use super::plot::hue;
use super::run::Cost;
use crate::language::ValueError;
use crate::measure::Timing;
use crate::measure::plot::{STYLE, color_class, escaped};
use crate::measure::text::{duration, percent, unbroken};

const TEMPLATE: &str = include_str!("page.html");

impl Cost {
    /// The page for a scene with this title, with further choices and their titles.
    ///
    /// # Errors
    /// Refuses a picture that cannot be encoded.
    pub fn page(&self, scene: &str, choices: &[(&str, Best)]) -> Result<String, ValueError> {
        let reference = pictures::png(&self.reference.film)?;
        let [width, height] = self.size;
        let part = |word: &str| match word {
            "scene" => escaped(scene),
            "size" => format!("{width} × {height}"),
            "aspect" => format!("{width} / {height}"),
            "runs" => markup(&self.runs_words()),
            "reference" => markup(&self.reference_words()),
            "advice" => {
                let choices = choices.iter().map(|(title, best)| self.choice(title, best));
                self.choice("recommended", &self.recommended) + &choices.collect::<String>()
            }
            "sections" => self.sections().map(section).collect(),
            "style" => STYLE.to_owned(),
            "wide" => self.scatter().element("wide", [1000.0, 520.0]),
            "narrow" => self.scatter().element("narrow", [390.0, 470.0]),
            "rows" => self.steps.iter().enumerate().map(row).collect(),
            "data" => self.data(&reference),
            _ => String::new(),
        };
        Ok(filled(TEMPLATE, part))
    }

    /// A choice and its reason; its step can be selected.
    fn choice(&self, title: &str, best: &Best) -> String {
        let select = match self.number_of(best) {
            Some(step) => format!(" data-step=\"{step}\" tabindex=\"0\" role=\"button\""),
            None => " class=\"none\"".to_owned(),
        };
        let [title, label, why] = [title, best.title(), &best.why].map(markup);
        format!("<dt>{title}</dt><dd><strong{select}>{label}</strong> <span>{why}</span></dd>\n")
    }

    /// Place of the chosen step in the sweep.
    fn number_of(&self, best: &Best) -> Option<usize> {
        let mut steps = self.steps.iter();
        steps.position(|step| Some(&step.label) == best.label.as_ref())
    }

    /// Data of the script of the page.
    fn data(&self, reference: &[u8]) -> String {
        // Many steps have equal pictures; each is stored once.
        let mut files: Vec<&[u8]> = vec![reference];
        let mut number_of = |file| {
            let known = files.iter().position(|known| *known == file);
            known.unwrap_or_else(|| {
                files.push(file);
                files.len() - 1
            })
        };
        let mut steps = Vec::new();
        for step in &self.steps {
            let pictures = step.pictures.as_ref();
            steps.push(json!({
                "label": step.label,
                "cpu": duration(step.cpu.median),
                "rmse": format!("{:.6}", step.deviation.rmse),
                "max": format!("{:.2}", step.deviation.change.largest),
                "off": percent(step.deviation.change.pixels),
                "picture": pictures.map(|pictures| number_of(&pictures.picture)),
                "errors": pictures.map(|pictures| number_of(&pictures.errors)),
                "worst": pictures.map(|pictures| &pictures.worst),
            }));
        }
        let url = |png| format!("data:image/png;base64,{}", STANDARD.encode(png));
        let data = json!({
            "files": files.into_iter().map(url).collect::<Vec<_>>(),
            "steps": steps,
            "start": self.number_of(&self.recommended).unwrap_or(0),
        });
        // No text in it may end the script.
        data.to_string().replace('<', "\\u003c")
    }
}

/// A title and a list of sentences.
fn section((title, lines): (&str, Vec<String>)) -> String {
    let lines: String = lines.iter().map(|line| sentence(line)).collect();
    format!("<p>{title}</p>\n<ul>\n{lines}</ul>\n")
}

/// A sentence with the setting at its start set apart.
fn sentence(words: &str) -> String {
    let (about, rest) = words.split_once(": ").unwrap_or(("", words));
    let [about, rest] = [about, rest].map(markup);
    format!("<li><b>{about}</b> <span>{rest}</span></li>\n")
}

/// A text as markup in which numbers keep their units, and words with hyphens stay whole.
fn markup(text: &str) -> String {
    let whole = |word: &str| match escaped(word) {
        // A path may be longer than a line.
        word if word.contains('-') && word.len() < 40 => {
            format!("<span class=\"whole\">{word}</span>")
        }
        word => word,
    };
    let text = unbroken(text);
    text.split(' ').map(whole).collect::<Vec<_>>().join(" ")
}

/// Row of a step in the table.
fn row((number, step): (usize, &Measurement)) -> String {
    let deviation = &step.deviation;
    let (class, better) = match &step.dominated_by {
        None => ("on-front", "none".to_owned()),
        Some(better) => ("", escaped(better)),
    };
    let wall = Timing {
        deviation: None,
        ..step.wall
    };
    let or_dash = |number: Option<String>| number.unwrap_or("–".to_owned());
    let cells = [
        step.cpu.to_string(),
        wall.to_string(),
        step.rays.to_string(),
        format!("{:.2}", deviation.change.largest),
        percent(deviation.change.pixels),
        format!("{:.6}", deviation.rmse),
        or_dash(deviation.psnr.map(|psnr| format!("{psnr:.1}"))),
        format!("{:.4}", deviation.ssim),
        format!("{:.4}", deviation.flip),
        or_dash(step.efficiency.map(|it| format!("{it:.0}"))),
        better,
    ];
    let cells = cells.map(|cell| format!("<td>{cell}</td>")).concat();
    let (color, label) = (color_class(hue(step)), escaped(&step.label));
    format!(
        "<tr class=\"{class}\" data-step=\"{number}\" tabindex=\"0\">\
         <th><i class=\"{color}\"></i>{label}</th>{cells}</tr>\n"
    )
}

/// A template with every `{{word}}` replaced.
fn filled(template: &str, part: impl Fn(&str) -> String) -> String {
    let mut text = String::new();
    let mut rest = template;
    while let Some((before, from)) = rest.split_once("{{") {
        let (word, after) = from.split_once("}}").unwrap_or((from, ""));
        text += before;
        text += &part(word);
        rest = after;
    }
    text + rest
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_setting_of_a_sentence_is_set_apart() {
        for (words, about, rest) in [
            ("depth: own error 1 (8)", "depth", "own error 1 (8)"),
            ("a=1: on plane c: d", "a=1", "on plane c: d"),
            (
                "depth: own error 1.1e-8 in 1.23 ms, no ms in 2 s",
                "depth",
                "own error <span class=\"whole\">1.1e-8</span> in 1.23\u{a0}ms, no ms in 2\u{a0}s",
            ),
        ] {
            let expected = format!("<li><b>{about}</b> <span>{rest}</span></li>\n");
            assert_eq!(sentence(words), expected);
        }
    }
}
