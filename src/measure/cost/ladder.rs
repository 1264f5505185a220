//! Which settings are tried.

use super::{DIALS, Dial};
use crate::camera::Pattern;
use crate::film::{BitDepth, Rounding};
use crate::language::{Value, ValueError};
use crate::plan::Effect;
use crate::scene::{RenderSettings, Setting};

/// One combination of settings that is tried.
#[derive(Debug, Clone, PartialEq)]
pub struct Rung {
    /// What it is called: its settings, or "as it is".
    pub label: String,
    /// What is set differently from the scene.
    pub settings: Vec<Setting>,
    /// All settings together.
    pub picture: RenderSettings,
    /// The dial that alone is turned, if one is.
    pub dial: Option<&'static str>,
    /// Other dials of which this is a step, too.
    pub also: Vec<&'static str>,
}

/// The rungs in the order in which they are tried; the first is the scene as it is.
#[derive(Debug, Clone, PartialEq)]
pub struct Ladder(pub Vec<Rung>);

/// A dial and what it is set to in turn.
#[derive(Debug, Clone, PartialEq)]
pub struct Variation(Vec<Setting>);

impl Variation {
    /// A variation such as `samples=1,4,16`.
    ///
    /// # Errors
    /// Tells what was expected.
    pub fn new(text: &str) -> Result<Self, String> {
        let (word, steps) = text
            .split_once('=')
            .ok_or("expected a property of `image` and its values, such as samples=1,4,16")?;
        let word = word.trim();
        let settings = steps.split(',').map(|step| {
            let setting = Setting::new(word, step.trim());
            setting.map_err(|expected| match step.trim() {
                "" => format!("{expected} between the commas"),
                step if expected.starts_with("expected one of") => {
                    format!("there is no property {word:?}; {expected} before ={step}")
                }
                step => format!("{step:?} is no {word}: {expected}"),
            })
        });
        let settings = settings.collect::<Result<_, _>>()?;
        if Dial::of(word).is_none() {
            let dials: Vec<_> = DIALS.iter().map(|dial| dial.word).collect();
            return Err(format!(
                "no {word} is more accurate than another; expected one of {} before =",
                dials.join(", ")
            ));
        }
        Ok(Self(settings))
    }
}

impl Ladder {
    /// The ladder of a scene whose picture has these settings and in which these effects are
    /// simulated: each dial alone that can change the picture.
    #[must_use]
    pub fn of(base: RenderSettings, on: &[Effect]) -> Self {
        let mut ladder = Self::starting_at(base);
        for dial in DIALS.into_iter().filter(|dial| dial.matters(on)) {
            let beside = dial.together_with.iter();
            let beside = beside.filter_map(|(word, text)| Setting::new(word, text).ok());
            let beside: Vec<_> = beside.collect();
            for step in dial.steps {
                let setting = Setting::new(dial.word, step).ok();
                // What cannot be combined is no step of this ladder.
                let settings = beside.iter().cloned().chain(setting).collect();
                let _ = ladder.add(base, Some(dial.word), settings);
            }
        }
        ladder
    }

    /// Each variation alone.
    ///
    /// # Errors
    /// Refuses settings that make no sense together.
    pub fn of_each(base: RenderSettings, variations: &[Variation]) -> Result<Self, ValueError> {
        let mut ladder = Self::starting_at(base);
        for setting in variations.iter().flat_map(|variation| &variation.0) {
            ladder.add(base, Some(setting.word()), vec![setting.clone()])?;
        }
        Ok(ladder)
    }

    /// All combinations of the variations' settings; several variations of one dial are one.
    ///
    /// # Errors
    /// Refuses settings that make no sense together.
    pub fn of_all(base: RenderSettings, variations: &[Variation]) -> Result<Self, ValueError> {
        let mut combinations = vec![Vec::new()];
        for variation in joined(variations) {
            let longer = combinations.iter().flat_map(|combination: &Vec<Setting>| {
                let with =
                    |setting: &Setting| [combination.clone(), vec![setting.clone()]].concat();
                variation.0.iter().map(with)
            });
            combinations = longer.collect();
        }
        let mut ladder = Self::starting_at(base);
        for settings in combinations {
            let alone = match settings.as_slice() {
                [alone] => Some(alone.word()),
                _ => None,
            };
            ladder.add(base, alone, settings)?;
        }
        Ok(ladder)
    }

    fn starting_at(base: RenderSettings) -> Self {
        Self(vec![Rung {
            label: "as it is".to_owned(),
            settings: Vec::new(),
            picture: base,
            dial: None,
            also: Vec::new(),
        }])
    }

    /// Adds a rung, which turns this dial alone if any, unless another gives the same picture.
    fn add(
        &mut self,
        base: RenderSettings,
        dial: Option<&'static str>,
        settings: Vec<Setting>,
    ) -> Result<(), ValueError> {
        let with = |picture: RenderSettings, setting| picture.with(setting);
        let rung = Rung {
            label: label(&settings),
            picture: settings.iter().fold(base, with),
            dial,
            also: Vec::new(),
            settings,
        };
        rung.picture.check()?;
        let same = |other: &Rung| {
            let [one, two] = [other, &rung].map(|it| (seen(it.picture), it.is_as_written()));
            one == two
        };
        match self.0.iter().position(same) {
            // The scene as it is, is a step of all dials without that.
            Some(0) => {}
            Some(known) => self.0[known].also.extend(rung.dial),
            None => self.0.push(rung),
        }
        Ok(())
    }
}

impl Rung {
    /// Whether the picture is compared as it is written, in code values.
    #[must_use]
    pub fn is_as_written(&self) -> bool {
        let dials = self.settings.iter().map(|setting| Dial::of(setting.word()));
        dials.flatten().any(|dial| dial.in_writing)
    }

    /// What a dial is turned to: as it was given if it was, else as the scene would say it.
    pub(super) fn step(&self, dial: &Dial, value: &Value) -> String {
        let given = self.settings.iter().find(|it| it.word() == dial.word);
        match given {
            Some(setting) => setting.text().to_owned(),
            None => value.to_string().trim_matches('"').to_owned(),
        }
    }

    /// Whether it is a step of a dial, alone or beside what else is set.
    pub(super) fn turns(&self, dial: &Dial) -> bool {
        let mut turned = self.dial.iter().chain(&self.also);
        turned.any(|turned| *turned == dial.word)
    }
}

/// The variations, of each dial one.
fn joined(variations: &[Variation]) -> Vec<Variation> {
    let word = |variation: &Variation| variation.0.first().map(Setting::word);
    let mut joined: Vec<Variation> = Vec::new();
    for variation in variations {
        match joined.iter_mut().find(|it| word(it) == word(variation)) {
            Some(known) => known.0.extend_from_slice(&variation.0),
            None => joined.push(variation.clone()),
        }
    }
    joined
}

/// The settings that can be seen in a picture: floats are not rounded to code values, a single ray goes
/// through the middle of its pixel, and those that `max-error` adds have a pattern of their own.
fn seen(picture: RenderSettings) -> RenderSettings {
    let rounding = match picture.depth {
        BitDepth::Eight | BitDepth::Sixteen => picture.rounding,
        BitDepth::Float => Rounding::default(),
    };
    let is_spread = picture.samples > 1 && picture.max_error == 0.0;
    let pattern = if is_spread {
        picture.pattern
    } else {
        Pattern::default()
    };
    RenderSettings {
        rounding,
        pattern,
        ..picture
    }
}

/// The settings as they are given, such as `samples=4 numerics=classic`.
fn label(settings: &[Setting]) -> String {
    let words = settings.iter();
    let words = words.map(|setting| format!("{}={}", setting.word(), setting.text()));
    words.collect::<Vec<_>>().join(" ")
}

#[cfg(test)]
mod tests {
    use super::*;

    fn base() -> RenderSettings {
        let node = crate::language::Node::new(&RenderSettings::SCHEMA, None).value([4.0, 3.0]);
        RenderSettings::from_node(&node).expect("a picture")
    }

    fn labels(ladder: &Ladder) -> Vec<&str> {
        ladder.0.iter().map(|rung| rung.label.as_str()).collect()
    }

    #[test]
    fn only_what_the_scene_calls_for_is_tried() {
        let plain = Ladder::of(base(), &[]);
        assert!(plain.0.len() >= 12, "{:?}", labels(&plain));
        let about = |ladder: &Ladder, word: &str| {
            labels(ladder)
                .iter()
                .filter(|label| label.starts_with(word))
                .count()
        };
        assert_eq!(about(&plain, "cut-off"), 0);
        let mirrored = Ladder::of(base(), &[Effect::Mirrors]);
        assert!(about(&mirrored, "cut-off") >= 5);
        assert_eq!(labels(&mirrored)[0], "as it is");
    }

    #[test]
    fn variations_alone_and_together() {
        let variations = ["samples=1, 4", "numerics=classic,robust"];
        let variations = variations.map(|text| Variation::new(text).expect("a variation"));
        let each = Ladder::of_each(base(), &variations).expect("a ladder");
        assert_eq!(labels(&each), ["as it is", "samples=4", "numerics=classic"]);
        assert_eq!(each.0[2].dial, Some("numerics"));
        let all = Ladder::of_all(base(), &variations).expect("a ladder");
        let expected = [
            "as it is",
            "samples=1 numerics=classic",
            "samples=4 numerics=classic",
            "samples=4 numerics=robust",
        ];
        assert_eq!(labels(&all), expected);
        let variations = ["samples=4", "pattern=grid,random"];
        let variations = variations.map(|text| Variation::new(text).expect("a variation"));
        let all = Ladder::of_all(base(), &variations).expect("a ladder");
        let turned = all.0.iter().map(|rung| rung.dial);
        assert!(turned.eq([None; 3]), "no dial is turned alone");
        let variations = ["samples=1,4", "max-error=0,0.1", "pattern=sobol,stratified"];
        let variations = variations.map(|text| Variation::new(text).expect("a variation"));
        let all = Ladder::of_all(base(), &variations).expect("a ladder");
        let expected = [
            "as it is",
            "samples=1 max-error=0.1 pattern=sobol",
            "samples=4 max-error=0 pattern=sobol",
            "samples=4 max-error=0 pattern=stratified",
            "samples=4 max-error=0.1 pattern=sobol",
        ];
        assert_eq!(labels(&all), expected, "a pattern is one of many rays");
        let variations = ["samples=4", "depth=16", "samples=9"];
        let variations = variations.map(|text| Variation::new(text).expect("a variation"));
        let all = Ladder::of_all(base(), &variations).expect("a ladder");
        let expected = ["as it is", "samples=4 depth=16", "samples=9 depth=16"];
        assert_eq!(labels(&all), expected, "one dial, one setting");
    }

    #[test]
    fn what_is_no_variation_is_told() {
        for (text, expected) in [
            ("samples", "such as samples=1,4,16"),
            ("sample=1", "did you mean \"samples\"?"),
            (
                "samples=1,0",
                "\"0\" is no samples: expected a whole number from 1",
            ),
            ("samples=1,,4", "between the commas"),
            (
                "transfer=srgb",
                "no transfer is more accurate than another; expected one of samples, ",
            ),
            (
                "numerics=f32",
                "\"f32\" is no numerics: expected \"robust\"",
            ),
        ] {
            let error = Variation::new(text).expect_err("no variation");
            assert!(error.contains(expected), "{text}: {error}");
        }
    }
}
