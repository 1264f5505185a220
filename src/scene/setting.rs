//! One setting of the picture, from outside of the scene file.

use super::RenderSettings;
use crate::language::{Attribute, Range, Takes, Value, did_you_mean};

/// A property of the `image` node and a value that it may have: what the command line says instead
/// of the scene, or one step of a dial.
#[derive(Debug, Clone, PartialEq)]
pub struct Setting {
    attribute: &'static Attribute,
    value: Value,
    text: String,
}

impl Setting {
    /// The property with this word, set to what stands in a text.
    ///
    /// # Errors
    /// Tells what was expected if the `image` node has no such property, or it no such value.
    pub fn new(word: &str, text: &str) -> Result<Self, String> {
        let properties = RenderSettings::SCHEMA.properties;
        let known = properties.iter().find(|property| property.word == word);
        let attribute = known.ok_or_else(|| {
            let words = || properties.iter().map(|property| property.word);
            let list: Vec<_> = words().collect();
            let found = did_you_mean(word, words());
            let hint = found.map_or(String::new(), |word| format!("; did you mean {word:?}?"));
            format!("expected one of {}{hint}", list.join(", "))
        })?;
        let value = match attribute.takes {
            Takes::Number(range) => {
                let number = number(text).filter(|number| range.contains(*number));
                number.map(Value::Number)
            }
            Takes::Word(words) => words.contains(&text).then(|| Value::from(text)),
            _ => None,
        };
        let value = value.ok_or_else(|| {
            let fraction = match attribute.takes {
                Takes::Number(Range::Between(..)) => ", or a fraction such as 2/255",
                _ => "",
            };
            format!("expected {}{fraction}", attribute.takes.words())
        })?;
        Ok(Self {
            attribute,
            value,
            text: text.split_whitespace().collect(),
        })
    }

    /// The property's word.
    #[must_use]
    pub fn word(&self) -> &'static str {
        self.attribute.word
    }

    /// What it is set to.
    #[must_use]
    pub fn value(&self) -> &Value {
        &self.value
    }

    /// The text that it was made from, without blanks, such as `2/255`.
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
