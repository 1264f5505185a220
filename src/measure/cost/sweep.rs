//! Settings that are tried.

use super::varied::VARIED;
use crate::film::BitDepth;
use crate::language::{Value, ValueError};
use crate::plan::Effect;
use crate::scene::{RenderSettings, Setting, SettingKind};

/// Steps in the order in which they are tried; the first is the scene as it is.
#[derive(Debug, Clone, PartialEq)]
pub struct Sweep(pub Vec<Step>);

/// One combination of settings that is tried.
#[derive(Debug, Clone, PartialEq)]
pub struct Step {
    /// Its changes such as `samples=4 numerics=classic`, or "as it is".
    pub label: String,
    /// Settings that differ from the scene.
    pub changes: Vec<Setting>,
    /// All settings together.
    pub settings: RenderSettings,
    /// The setting that alone is varied, if one is.
    pub varied: Option<&'static str>,
    /// Other settings of which it is a step, too.
    pub also: Vec<&'static str>,
}

/// A setting and the values that are tried of it.
#[derive(Debug, Clone, PartialEq)]
pub struct Variation(Vec<Setting>);

impl Variation {
    /// Reads a variation such as `samples=1,4,16`.
    ///
    /// # Errors
    /// Returns what was expected instead.
    pub fn new(text: &str) -> Result<Self, String> {
        let (word, values) = text
            .split_once('=')
            .ok_or("expected a property of `image` and its values, such as samples=1,4,16")?;
        let word = word.trim();
        let settings = values.split(',').map(|value| {
            let setting = Setting::new(word, value.trim());
            setting.map_err(|expected| match value.trim() {
                "" => format!("{expected} between the commas"),
                value if expected.starts_with("expected one of") => {
                    format!("there is no property {word:?}; {expected} before ={value}")
                }
                value => format!("{value:?} is not a valid value of {word}: {expected}"),
            })
        });
        let settings = settings.collect::<Result<_, _>>()?;
        if SettingKind::varied(word).is_none() {
            let known = VARIED.map(|kind| kind.word);
            return Err(format!(
                "{word} does not trade accuracy for time; expected one of {} before =",
                known.join(", ")
            ));
        }
        Ok(Self(settings))
    }
}

impl Sweep {
    /// Each setting alone that can change a picture in which these effects are simulated.
    #[must_use]
    pub fn of(base: RenderSettings, on: &[Effect]) -> Self {
        let mut sweep = Self::starting_at(base);
        for kind in VARIED.into_iter().filter(|kind| kind.matters(on)) {
            for value in kind.steps {
                let all = kind
                    .together_with
                    .iter()
                    .copied()
                    .chain([(kind.word, *value)]);
                let changes = all.filter_map(|(word, text)| Setting::new(word, text).ok());
                // A value that the scene's other settings forbid is left out.
                let _ = sweep.add(base, Some(kind.word), changes.collect());
            }
        }
        sweep
    }

    /// Each variation alone.
    ///
    /// # Errors
    /// Refuses settings that contradict each other.
    pub fn each(base: RenderSettings, variations: &[Variation]) -> Result<Self, ValueError> {
        let settings = variations.iter().flat_map(|variation| &variation.0);
        Self::with(base, settings.map(|setting| vec![setting.clone()]))
    }

    /// All combinations of the variations' values; variations of one setting are joined.
    ///
    /// # Errors
    /// Refuses settings that contradict each other.
    pub fn grid(base: RenderSettings, variations: &[Variation]) -> Result<Self, ValueError> {
        let mut combinations = vec![Vec::new()];
        for variation in joined(variations) {
            let longer = combinations.iter().flat_map(|combination: &Vec<Setting>| {
                let values = variation.iter();
                values.map(|value| [combination.as_slice(), std::slice::from_ref(value)].concat())
            });
            combinations = longer.collect();
        }
        Self::with(base, combinations.into_iter())
    }

    fn with(
        base: RenderSettings,
        all: impl Iterator<Item = Vec<Setting>>,
    ) -> Result<Self, ValueError> {
        let mut sweep = Self::starting_at(base);
        for changes in all {
            let varied = match changes.as_slice() {
                [alone] => Some(alone.word()),
                _ => None,
            };
            sweep.add(base, varied, changes)?;
        }
        Ok(sweep)
    }

    fn starting_at(base: RenderSettings) -> Self {
        Self(vec![Step {
            label: "as it is".to_owned(),
            changes: Vec::new(),
            settings: base,
            varied: None,
            also: Vec::new(),
        }])
    }

    /// Adds a step unless another gives the same picture.
    fn add(
        &mut self,
        base: RenderSettings,
        varied: Option<&'static str>,
        changes: Vec<Setting>,
    ) -> Result<(), ValueError> {
        let step = Step {
            label: label(&changes),
            settings: changes.iter().fold(base, RenderSettings::with),
            varied,
            also: Vec::new(),
            changes,
        };
        step.settings.check()?;
        let same = |other: &Step| {
            visible(other.settings) == visible(step.settings)
                && other.is_as_written() == step.is_as_written()
        };
        match self.0.iter().position(same) {
            // The scene as it is counts as a step of every setting without that.
            Some(0) => {}
            Some(known) => self.0[known].also.extend(varied),
            None => self.0.push(step),
        }
        Ok(())
    }
}

impl Step {
    /// True if its picture is compared as it is written, in code values.
    pub(super) fn is_as_written(&self) -> bool {
        self.changes.iter().any(|setting| setting.kind().in_writing)
    }

    /// Text of a setting's value: as given by the user, else as the scene would give it.
    pub(super) fn text_of(&self, word: &str, value: &Value) -> String {
        match self.changes.iter().find(|it| it.word() == word) {
            Some(setting) => setting.text().to_owned(),
            None => value.to_string().trim_matches('"').to_owned(),
        }
    }

    /// True if it is a step of a setting, alone or beside what else is set.
    pub(super) fn varies(&self, word: &str) -> bool {
        self.varied.iter().chain(&self.also).any(|it| *it == word)
    }
}

/// The values of the variations, one list for each setting.
fn joined(variations: &[Variation]) -> Vec<Vec<Setting>> {
    let mut joined: Vec<Vec<Setting>> = Vec::new();
    for setting in variations.iter().flat_map(|variation| &variation.0) {
        match joined.iter_mut().find(|it| it[0].word() == setting.word()) {
            Some(known) => known.push(setting.clone()),
            None => joined.push(vec![setting.clone()]),
        }
    }
    joined
}

/// Settings with a default for those that cannot change the picture.
fn visible(settings: RenderSettings) -> RenderSettings {
    // Floats are not rounded to code values, a single ray goes through the middle of its pixel, and
    // rays that `max-error` adds have a pattern of their own.
    let rounding = match settings.depth {
        BitDepth::Eight | BitDepth::Sixteen => settings.rounding,
        BitDepth::Float => RenderSettings::DEFAULT.rounding,
    };
    let pattern = if settings.samples > 1 && settings.max_error == 0.0 {
        settings.pattern
    } else {
        RenderSettings::DEFAULT.pattern
    };
    RenderSettings {
        rounding,
        pattern,
        ..settings
    }
}

/// Settings as they are given, such as `samples=4 numerics=classic`.
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

    fn labels(sweep: &Sweep) -> Vec<&str> {
        sweep.0.iter().map(|step| step.label.as_str()).collect()
    }

    #[test]
    fn only_what_the_scene_calls_for_is_tried() {
        let plain = Sweep::of(base(), &[]);
        assert!(plain.0.len() >= 12, "{:?}", labels(&plain));
        let about = |sweep: &Sweep, word: &str| {
            labels(sweep)
                .iter()
                .filter(|label| label.starts_with(word))
                .count()
        };
        assert_eq!(about(&plain, "cut-off"), 0);
        let mirrored = Sweep::of(base(), &[Effect::Mirrors]);
        assert!(about(&mirrored, "cut-off") >= 5);
        assert_eq!(labels(&mirrored)[0], "as it is");
    }

    #[test]
    fn variations_alone_and_together() {
        let variations = ["samples=1, 4", "numerics=classic,robust"];
        let variations = variations.map(|text| Variation::new(text).expect("a variation"));
        let each = Sweep::each(base(), &variations).expect("a sweep");
        assert_eq!(labels(&each), ["as it is", "samples=4", "numerics=classic"]);
        assert_eq!(each.0[2].varied, Some("numerics"));
        let all = Sweep::grid(base(), &variations).expect("a sweep");
        let expected = [
            "as it is",
            "samples=1 numerics=classic",
            "samples=4 numerics=classic",
            "samples=4 numerics=robust",
        ];
        assert_eq!(labels(&all), expected);
        let variations = ["samples=4", "pattern=grid,random"];
        let variations = variations.map(|text| Variation::new(text).expect("a variation"));
        let all = Sweep::grid(base(), &variations).expect("a sweep");
        let varied = all.0.iter().map(|step| step.varied);
        assert!(varied.eq([None; 3]), "no setting is varied alone");
        let variations = ["samples=1,4", "max-error=0,0.1", "pattern=sobol,stratified"];
        let variations = variations.map(|text| Variation::new(text).expect("a variation"));
        let all = Sweep::grid(base(), &variations).expect("a sweep");
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
        let all = Sweep::grid(base(), &variations).expect("a sweep");
        let expected = ["as it is", "samples=4 depth=16", "samples=9 depth=16"];
        assert_eq!(labels(&all), expected, "one setting, one value");
    }

    #[test]
    fn what_is_no_variation_is_refused() {
        for (text, expected) in [
            ("samples", "such as samples=1,4,16"),
            ("sample=1", "did you mean \"samples\"?"),
            (
                "samples=1,0",
                "\"0\" is not a valid value of samples: expected a whole number from 1",
            ),
            ("samples=1,,4", "between the commas"),
            (
                "transfer=srgb",
                "transfer does not trade accuracy for time; expected one of samples, ",
            ),
            (
                "numerics=f32",
                "\"f32\" is not a valid value of numerics: expected \"robust\"",
            ),
        ] {
            let error = Variation::new(text).expect_err("no variation");
            assert!(error.contains(expected), "{text}: {error}");
        }
    }
}
