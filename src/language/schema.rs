//! Schemas: the words, types, units and defaults of the scene language, as data.
//!
//! The readers check nodes against them, a test compares `docs/scene-language.md` with them, and
//! `convert` omits values that equal their defaults.

use super::{Value, joined, words};

/// One kind of node: `plane`, `material`, `camera` …
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Schema {
    /// The node's word in the scene file.
    pub word: &'static str,
    /// A description in one sentence.
    pub about: &'static str,
    /// Whether the node carries a name as its first argument.
    pub naming: Naming,
    /// The value after the word and the name on the same line, if it takes one.
    pub value: Option<&'static Attribute>,
    /// `key=value` settings on the node's own line.
    pub properties: &'static [Attribute],
    /// The attributes between the braces, in groups that several kinds share.
    pub attributes: &'static [&'static [Attribute]],
}

impl Schema {
    /// Every attribute that may stand between the braces.
    pub fn all_attributes(&self) -> impl Iterator<Item = &'static Attribute> {
        self.attributes.iter().copied().flatten()
    }
}

/// One attribute of a node, or one property on a line.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Attribute {
    /// The attribute's word.
    pub word: &'static str,
    /// The type and number of its values.
    pub takes: Takes,
    /// The unit of its values; empty for numbers without one.
    pub unit: &'static str,
    /// The value of a missing attribute.
    pub default: Default,
    /// `key=value` settings on the attribute's line.
    pub properties: &'static [Self],
    /// A description in one sentence.
    pub about: &'static str,
}

/// The name of a node: none, optional or required.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Naming {
    /// No name: `image`, `camera`.
    None,
    /// An optional name: surfaces and lights.
    Optional,
    /// A required name, which other nodes refer to: materials and textures.
    Required,
}

/// The value of a missing attribute.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Default {
    /// No value: a missing attribute is an error.
    Required,
    /// No value: the effect is absent.
    Absent,
    /// A number.
    Number(f64),
    /// Three numbers.
    Triple([f64; 3]),
    /// A word.
    Word(&'static str),
    /// `#true` or `#false`.
    Flag(bool),
}

impl Default {
    /// The value, if there is one.
    #[must_use]
    pub fn value(self) -> Option<Value> {
        match self {
            Self::Required | Self::Absent => None,
            Self::Number(number) => Some(Value::Number(number)),
            Self::Triple(triple) => Some(Value::Triple(triple)),
            Self::Word(word) => Some(Value::from(word)),
            Self::Flag(flag) => Some(Value::Flag(flag)),
        }
    }
}

/// The type of an attribute's value.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Takes {
    /// No value: the attribute has only properties.
    Nothing,
    /// One number.
    Number(Range),
    /// Two numbers.
    Pair(Range),
    /// Three finite numbers.
    Triple,
    /// Three numbers, or one that stands for three equal ones.
    Color,
    /// A number or a pair written in quotes, `"0.02 0.01"`.
    NumberOrPair(Range),
    /// One of these words.
    Word(&'static [&'static str]),
    /// The name of a material or a texture.
    Name(Reference),
    /// A file, relative to the scene file.
    Path,
    /// `#true` or `#false`.
    Flag,
}

/// The kind of node that a name refers to.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Reference {
    /// A `material`.
    Material,
    /// A `texture`.
    Texture,
}

words!(Reference {
    Material: "material",
    Texture: "texture",
});

/// The range of numbers that an attribute takes, always without infinities and NaN.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Range {
    /// Any finite number.
    Any,
    /// Above zero.
    Positive,
    /// Zero or above.
    NotNegative,
    /// Between two bounds, bounds included.
    Between(f64, f64),
    /// Between two bounds, bounds excluded.
    Inside(f64, f64),
    /// A whole number between two bounds, bounds included.
    Whole(u32, u32),
}

impl Range {
    /// The largest number in a scene, about 1.8e75; directions may be longer.
    ///
    /// Products of four such numbers, and sums of a few such products, are finite. A scene of
    /// usual size can be scaled by 2²⁰⁰.
    pub const LARGEST: f64 = f64::from_bits((1023 + 250) << 52);

    /// The smallest radius, 2⁻²⁵⁰: the square of its reciprocal is finite.
    pub const SMALLEST_RADIUS: f64 = f64::from_bits((1023 - 250) << 52);

    /// True if a number lies in the range.
    #[must_use]
    pub fn contains(self, number: f64) -> bool {
        number.is_finite()
            && match self {
                Self::Any => true,
                Self::Positive => number > 0.0,
                Self::NotNegative => number >= 0.0,
                Self::Between(low, high) => (low..=high).contains(&number),
                Self::Inside(low, high) => low < number && number < high,
                Self::Whole(low, high) => {
                    number.fract() == 0.0 && (f64::from(low)..=f64::from(high)).contains(&number)
                }
            }
    }

    /// The range in words: `a number above 0`, `two whole numbers from 1 to 9`.
    #[must_use]
    pub fn words(self, article: &str, noun: &str) -> String {
        let numbers = format!("{article} {noun}");
        match self {
            Self::Any => numbers,
            Self::Positive => format!("{numbers} above 0"),
            Self::NotNegative => format!("{numbers} of 0 or more"),
            Self::Between(low, high) => format!("{numbers} from {low} to {high}"),
            Self::Inside(low, high) => format!("{numbers} between {low} and {high}"),
            Self::Whole(low, high) => format!("{article} whole {noun} from {low} to {high}"),
        }
    }
}

impl Takes {
    /// The type in words: `three numbers`, `"clamp" or "repeat"`.
    #[must_use]
    pub fn words(&self) -> String {
        match self {
            Self::Nothing => "nothing".to_owned(),
            Self::Number(range) => range.words("a", "number"),
            Self::Pair(range) => range.words("two", "numbers"),
            Self::Triple => "three numbers".to_owned(),
            Self::Color => "one or three numbers".to_owned(),
            Self::NumberOrPair(range) => {
                format!("{}, or two of them in quotes", range.words("a", "number"))
            }
            Self::Word(words) => {
                let quoted: Vec<_> = words.iter().map(|word| format!("{word:?}")).collect();
                joined(&quoted, "or")
            }
            Self::Name(reference) => format!("the name of a {}", reference.word()),
            Self::Path => "a file name in quotes".to_owned(),
            Self::Flag => "#true or #false".to_owned(),
        }
    }
}

impl Attribute {
    /// A required attribute without unit and properties.
    #[must_use]
    pub const fn new(word: &'static str, takes: Takes, about: &'static str) -> Self {
        Self {
            word,
            takes,
            unit: "",
            default: Default::Required,
            properties: &[],
            about,
        }
    }

    /// The same attribute with a unit.
    #[must_use]
    pub const fn unit(self, unit: &'static str) -> Self {
        Self { unit, ..self }
    }

    /// The same attribute with a default.
    #[must_use]
    pub const fn or(self, default: Default) -> Self {
        Self { default, ..self }
    }

    /// The same attribute, optional and without a default.
    #[must_use]
    pub const fn optional(self) -> Self {
        Self {
            default: Default::Absent,
            ..self
        }
    }

    /// The same attribute with properties on its line.
    #[must_use]
    pub const fn with(self, properties: &'static [Self]) -> Self {
        Self { properties, ..self }
    }

    /// True if it takes a vector of which only the direction counts.
    #[must_use]
    pub fn is_direction(&self) -> bool {
        self.takes == Takes::Triple && self.unit.is_empty()
    }
}
