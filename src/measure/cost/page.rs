//! The cost of accuracy as a page that needs nothing else.

use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use serde_json::json;

use super::plot::color;
use super::words::percent;
use super::{Best, Blame, Cost, Law, Measured, pictures};
use crate::language::ValueError;
use crate::measure::Timing;
use crate::measure::clock::in_words;
use crate::measure::plot::{STYLE, escaped};

const TEMPLATE: &str = include_str!("page.html");

impl Cost {
    /// The page, about a scene that is called this, with the answers to what else was asked, each
    /// after a word for it.
    ///
    /// # Errors
    /// Refuses a picture that cannot be kept.
    pub fn page(&self, scene: &str, answers: &[(&str, Best)]) -> Result<String, ValueError> {
        let reference = pictures::png(&self.reference.film)?;
        let [width, height] = self.size;
        let parts = |word: &str| match word {
            "scene" => escaped(scene),
            "size" => format!("{width} × {height}"),
            "aspect" => format!("{width} / {height}"),
            "runs" => unbroken(&self.runs_words()),
            "reference" => unbroken(&self.reference_words()),
            "advice" => {
                let answers = answers.iter().map(|(word, best)| self.answer(word, best));
                self.answer("recommended", &self.recommended) + &answers.collect::<String>()
            }
            "laws" => {
                let law = |law: &Law| sentence(law.dial, &law.words(&self.rungs));
                let blame = |blame: &Blame| sentence(&blame.setting(), &blame.words());
                let laws = self.laws.iter().map(law);
                let met = self.met_words();
                let met = met.iter().map(|words| sentence("max-error", words));
                laws.chain(met)
                    .chain(self.blames.iter().map(blame))
                    .collect()
            }
            "style" => STYLE.to_owned(),
            "wide" => self.plot_element("wide", [1000.0, 520.0]),
            "narrow" => self.plot_element("narrow", [390.0, 470.0]),
            "rows" => self.rungs.iter().enumerate().map(row).collect(),
            "data" => self.data(&reference),
            _ => String::new(),
        };
        Ok(filled(TEMPLATE, parts))
    }

    /// What is the best by some rule, and why; where there is a rung, it can be chosen.
    fn answer(&self, word: &str, best: &Best) -> String {
        let choice = match self.number_of(best) {
            Some(rung) => format!(" data-rung=\"{rung}\" tabindex=\"0\" role=\"button\""),
            None => " class=\"none\"".to_owned(),
        };
        let [word, title, why] = [word, best.title(), &best.why].map(unbroken);
        format!("<dt>{word}</dt><dd><strong{choice}>{title}</strong> <span>{why}</span></dd>\n")
    }

    /// The place of a rung in the ladder.
    fn number_of(&self, best: &Best) -> Option<usize> {
        let mut rungs = self.rungs.iter();
        rungs.position(|rung| Some(&rung.label) == best.label.as_ref())
    }

    /// What the page's script shows.
    fn data(&self, reference: &[u8]) -> String {
        // Many rungs have the same picture; each is there once.
        let mut files: Vec<&[u8]> = vec![reference];
        let mut number_of = |file| {
            let known = files.iter().position(|known| *known == file);
            known.unwrap_or_else(|| {
                files.push(file);
                files.len() - 1
            })
        };
        let mut rungs = Vec::new();
        for rung in &self.rungs {
            let pictures = rung.pictures.as_ref();
            let picture = pictures.map(|pictures| number_of(&pictures.picture));
            let errors = pictures.map(|pictures| number_of(&pictures.errors));
            rungs.push(json!({
                "label": rung.label,
                "cpu": in_words(rung.cpu.median),
                "rmse": format!("{:.6}", rung.deviation.rmse),
                "max": format!("{:.2}", rung.deviation.change.largest),
                "off": percent(rung.deviation.change.pixels),
                "picture": picture,
                "errors": errors,
                "worst": pictures.map(|pictures| &pictures.worst),
            }));
        }
        let data = json!({
            "files": files.into_iter().map(url).collect::<Vec<_>>(),
            "rungs": rungs,
            "start": self.number_of(&self.recommended).unwrap_or(0),
        });
        // Nothing in it may end the script.
        data.to_string().replace('<', "\\u003c")
    }
}

/// A sentence that begins with a dial or a rung, which is set apart.
fn sentence(about: &str, words: &str) -> String {
    let rest = words.strip_prefix(about).unwrap_or(words);
    let rest = rest.trim_start_matches([':', ' ']);
    let [about, rest] = [about, rest].map(unbroken);
    format!("<li><b>{about}</b> <span>{rest}</span></li>\n")
}

/// Text in which a number and its unit stay in one line.
fn unbroken(text: &str) -> String {
    const UNITS: [&str; 6] = ["%", "s", "ms", "µs", "dB", "code"];
    let mut parts: Vec<String> = Vec::new();
    for word in text.split(' ') {
        let is_unit = UNITS.contains(&word.trim_end_matches([',', ';', ')']));
        match parts.last_mut() {
            Some(last) if is_unit && last.ends_with(|it: char| it.is_ascii_digit()) => {
                *last += "\u{a0}";
                *last += word;
            }
            _ => parts.push(word.to_owned()),
        }
    }
    let whole = |part: &String| match part.contains('-') {
        // An address of a file may be longer than a line.
        true if part.len() < 40 => format!("<span class=\"whole\">{}</span>", escaped(part)),
        _ => escaped(part),
    };
    parts.iter().map(whole).collect::<Vec<_>>().join(" ")
}

/// A rung's row of the table.
fn row((number, rung): (usize, &Measured)) -> String {
    let (class, better) = match &rung.dominated_by {
        None => ("on-front", "none".to_owned()),
        Some(better) => ("", escaped(better)),
    };
    let efficiency = rung
        .efficiency
        .map_or("–".to_owned(), |it| format!("{it:.0}"));
    let cells = figures(rung).into_iter().chain([efficiency]);
    let cells: String = cells.map(|cell| format!("<td>{cell}</td>")).collect();
    format!(
        "<tr class=\"{class}\" data-rung=\"{number}\" tabindex=\"0\"><th><i class=\"{}\"></i>{}</th>\
         {cells}<td>{better}</td></tr>\n",
        color(rung.dial),
        escaped(&rung.label),
    )
}

/// The figures of a rung's row: processor time, time, rays, and how far it is off.
fn figures(rung: &Measured) -> [String; 9] {
    let deviation = &rung.deviation;
    let wall = Timing {
        deviation: None,
        ..rung.wall
    };
    let psnr = deviation
        .psnr
        .map_or("–".to_owned(), |psnr| format!("{psnr:.1}"));
    [
        rung.cpu.to_string(),
        wall.to_string(),
        rung.rays.to_string(),
        format!("{:.2}", deviation.change.largest),
        percent(deviation.change.pixels),
        format!("{:.6}", deviation.rmse),
        psnr,
        format!("{:.4}", deviation.ssim),
        format!("{:.4}", deviation.flip),
    ]
}

/// A file within an address.
fn url(png: &[u8]) -> String {
    format!("data:image/png;base64,{}", STANDARD.encode(png))
}

/// A template in which every `{{word}}` is replaced.
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
    fn what_a_sentence_is_about_is_set_apart() {
        for (about, words, rest) in [
            (
                "depth",
                "depth: by itself 8 errs by 1",
                "by itself 8 errs by 1",
            ),
            (
                "a=1 b=2",
                "a=1 b=2 errs on plane c: d",
                "errs on plane c: d",
            ),
            (
                "depth",
                "depth: by itself 8 errs by 1.1e-8 in 1.23 ms, no ms in 2 s",
                "by itself 8 errs by <span class=\"whole\">1.1e-8</span> in 1.23\u{a0}ms, no ms in 2\u{a0}s",
            ),
        ] {
            let expected = format!("<li><b>{about}</b> <span>{rest}</span></li>\n");
            assert_eq!(sentence(about, words), expected);
        }
    }
}
