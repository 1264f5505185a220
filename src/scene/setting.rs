//! One setting of the picture, from outside the scene file.

use super::{RenderSettings, SETTINGS};
use crate::language::{Attribute, Default, Range, Takes, Value, did_you_mean};

/// A property of the `image` node: its part in scenes, on the command line and in `cost`.
#[derive(Debug, Clone, Copy)]
pub struct SettingKind {
    /// Its word in scenes and on the command line.
    pub word: &'static str,
    /// Its type and range.
    pub takes: Takes,
    /// Its value if a scene does not give it.
    pub default: Default,
    /// Its meaning; the part up to the first colon or semicolon stands alone.
    pub about: &'static str,
    /// Reads it from the settings.
    pub(super) get: fn(&RenderSettings) -> Value,
    /// Writes a value that [`takes`](Self::takes) allows to the settings.
    pub(super) set: fn(&mut RenderSettings, &Value),
    /// Its place among those that `cost` varies, from 1; 0 if no value is more accurate than another.
    pub rank: usize,
    /// The values that `cost` tries.
    pub steps: &'static [&'static str],
    /// Other settings that hold while `cost` tries them.
    pub together_with: &'static [(&'static str, &'static str)],
    /// The most accurate value; `None` if the reference chooses for itself.
    pub best: Option<&'static str>,
    /// True if its error is that against the reference, false if it is the distance from the same
    /// picture with this setting at its best.
    pub by_reference: bool,
    /// True if it changes the file only, so that pictures are compared as they are written.
    pub in_writing: bool,
}

impl SettingKind {
    /// A setting without any part in `cost`; a start for the rows of the table.
    pub(super) const PLAIN: Self = Self {
        word: "",
        takes: Takes::Nothing,
        default: Default::Absent,
        about: "",
        get: |_| Value::Flag(false),
        set: |_, _| (),
        rank: 0,
        steps: &[],
        together_with: &[],
        best: None,
        by_reference: false,
        in_writing: false,
    };

    /// The setting with this word, if `cost` varies it.
    #[must_use]
    pub fn varied(word: &str) -> Option<&'static Self> {
        SETTINGS.iter().find(|it| it.word == word && it.rank > 0)
    }

    /// The setting at its most accurate value, if it has one.
    #[must_use]
    pub fn best(&self) -> Option<Setting> {
        Setting::new(self.word, self.best?).ok()
    }

    /// The property in the schema of the `image` node.
    #[must_use]
    pub const fn attribute(&self) -> Attribute {
        Attribute::new(self.word, self.takes, self.about).or(self.default)
    }

    /// The values that the command line accepts, in words.
    #[must_use]
    pub fn expected(&self) -> String {
        let fraction = match self.takes {
            Takes::Number(Range::Between(..)) => ", or a fraction such as 2/255",
            _ => "",
        };
        format!("{}{fraction}", self.takes.words())
    }
}

/// A setting and its value: a command-line option, or a step of `cost`.
#[derive(Debug, Clone, PartialEq)]
pub struct Setting {
    /// Its row in the table.
    row: usize,
    value: Value,
    text: String,
}

impl Setting {
    /// The setting of this word with the value in a text.
    ///
    /// # Errors
    /// The words or values that were expected, if the word is unknown or the value not allowed.
    pub fn new(word: &str, text: &str) -> Result<Self, String> {
        let row = SETTINGS.iter().position(|kind| kind.word == word);
        let row = row.ok_or_else(|| {
            let words: Vec<_> = SETTINGS.iter().map(|kind| kind.word).collect();
            let found = did_you_mean(word, words.iter().copied());
            let hint = found.map_or(String::new(), |word| format!("; did you mean {word:?}?"));
            format!("expected one of {}{hint}", words.join(", "))
        })?;
        let kind = &SETTINGS[row];
        let value = match kind.takes {
            Takes::Number(range) => {
                let number = number(text).filter(|number| range.contains(*number));
                number.map(Value::Number)
            }
            Takes::Word(words) => words.contains(&text).then(|| Value::from(text)),
            _ => None,
        };
        let value = value.ok_or_else(|| format!("expected {}", kind.expected()))?;
        let text = text.split_whitespace().collect();
        Ok(Self { row, value, text })
    }

    /// The setting without its value.
    #[must_use]
    pub fn kind(&self) -> &'static SettingKind {
        &SETTINGS[self.row]
    }

    /// The setting's word.
    #[must_use]
    pub fn word(&self) -> &'static str {
        self.kind().word
    }

    /// The setting's value.
    #[must_use]
    pub fn value(&self) -> &Value {
        &self.value
    }

    /// The text of the value without blanks, such as `2/255`.
    #[must_use]
    pub fn text(&self) -> &str {
        &self.text
    }
}

/// A number, or a fraction such as `2/255`.
fn number(text: &str) -> Option<f64> {
    let number = |text: &str| text.trim().parse::<f64>().ok();
    match text.split_once('/') {
        Some((above, below)) => Some(number(above)? / number(below)?),
        None => number(text),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_setting_is_what_the_scene_could_say() {
        let setting = |word, text| Setting::new(word, text).map(|it| it.value);
        assert_eq!(setting("samples", "16"), Ok(Value::Number(16.0)));
        assert_eq!(setting("numerics", "classic"), Ok(Value::from("classic")));
        let spaced = Setting::new("max-error", " 2 / 255 ").expect("a setting");
        assert_eq!(spaced.text(), "2/255");
        let fraction = setting("max-error", "2/255");
        assert_eq!(fraction, Ok(Value::Number(2.0 / 255.0)));
        let share = "expected a number from 0 to 1, or a fraction such as 2/255";
        for (word, text, expected) in [
            ("max-error", "2/0", share),
            ("max-error", "-2/255", share),
            ("max-error", "2/255/1", share),
            ("samples", "0", "expected a whole number from 1 to 65536"),
            ("samples", "2.5", "expected a whole number from 1 to 65536"),
            ("samples", "many", "expected a whole number from 1 to 65536"),
            ("cut-off", "nan", share),
            ("quantize", "up", "expected \"round\" or \"truncate\""),
        ] {
            assert_eq!(setting(word, text), Err(expected.to_owned()));
        }
        let unknown = setting("sample", "4").expect_err("no such word");
        assert!(unknown.ends_with("did you mean \"samples\"?"), "{unknown}");
    }

    #[test]
    fn every_property_of_the_picture_can_be_set() {
        for property in RenderSettings::SCHEMA.properties {
            let text = match property.takes {
                Takes::Word(words) => words[0],
                _ => "1",
            };
            let setting = Setting::new(property.word, text);
            assert!(setting.is_ok(), "{}: {setting:?}", property.word);
        }
    }
}
