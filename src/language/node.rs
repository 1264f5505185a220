//! Nodes: the statements of a scene.

use std::fmt;

use glam::{DVec2, DVec3};

use super::{Attribute, Location, Schema, Value};

/// A node of a scene; its words and types agree with its [`Schema`].
#[derive(Debug, Clone, PartialEq)]
pub struct Node {
    /// Its kind.
    pub schema: &'static Schema,
    /// The word for its kind in its file and in messages.
    pub word: &'static str,
    /// Its name, if it has one.
    pub name: Option<String>,
    /// The value on its own line, if its kind has one.
    pub value: Option<Value>,
    /// The settings on its own line.
    pub properties: Vec<Entry>,
    /// The attributes between its braces.
    pub attributes: Vec<Entry>,
    /// Place of its first line; `None` if it was not read from a file.
    pub location: Option<Location>,
    /// False if the reader reported an error in it; then only its name is used.
    pub valid: bool,
}

/// One attribute or property of a node.
#[derive(Debug, Clone, PartialEq)]
pub struct Entry {
    /// The attribute's word, type and default.
    pub attribute: &'static Attribute,
    /// Its value; `None` if it takes none.
    pub value: Option<Value>,
    /// The settings on its line.
    pub properties: Vec<Self>,
    /// Its place in the file.
    pub location: Option<Location>,
}

impl Node {
    /// An empty node of a kind.
    #[must_use]
    pub fn new(schema: &'static Schema, name: Option<&str>) -> Self {
        Self {
            schema,
            word: schema.word,
            name: name.map(str::to_owned),
            value: None,
            properties: Vec::new(),
            attributes: Vec::new(),
            location: None,
            valid: true,
        }
    }

    /// The same node with a value on its own line.
    #[must_use]
    pub fn value(self, value: impl Into<Value>) -> Self {
        Self {
            value: Some(value.into()),
            ..self
        }
    }

    /// The same node with one more attribute.
    ///
    /// # Panics
    /// If the schema has no such attribute.
    #[must_use]
    pub fn with(self, word: &str, value: impl Into<Value>) -> Self {
        self.with_entry(word, Some(value.into()), &[])
    }

    /// The same node with one more attribute and the settings on its line.
    ///
    /// # Panics
    /// If the schema has no such attribute or setting.
    #[must_use]
    pub fn with_entry(
        mut self,
        word: &str,
        value: Option<Value>,
        properties: &[(&str, Value)],
    ) -> Self {
        let attribute = find(self.schema.all_attributes(), word);
        let properties = properties
            .iter()
            .map(|(word, value)| Entry::new(find(attribute.properties, word), value.clone()))
            .collect();
        self.attributes.push(Entry {
            attribute,
            value,
            properties,
            location: None,
        });
        self
    }

    /// The same node with a place for its last attribute.
    #[must_use]
    pub fn last_at(mut self, location: Location) -> Self {
        if let Some(last) = self.attributes.last_mut() {
            last.location = Some(location);
        }
        self
    }

    /// The same node with one more setting on its own line.
    ///
    /// # Panics
    /// If the schema has no such setting.
    #[must_use]
    pub fn with_property(mut self, word: &str, value: impl Into<Value>) -> Self {
        let attribute = find(self.schema.properties, word);
        self.properties.push(Entry::new(attribute, value.into()));
        self
    }

    /// The attribute with this word, if the node has it.
    #[must_use]
    pub fn entry(&self, word: &str) -> Option<&Entry> {
        self.attributes
            .iter()
            .find(|entry| entry.attribute.word == word)
    }

    /// An attribute's value or default; `None` if it has neither.
    #[must_use]
    pub fn get(&self, word: &str) -> Option<Value> {
        value_or_default(&self.attributes, find(self.schema.all_attributes(), word))
    }

    /// The value or default of a setting on the node's own line.
    #[must_use]
    pub fn property(&self, word: &str) -> Option<Value> {
        value_or_default(&self.properties, find(self.schema.properties, word))
    }

    /// An attribute of three numbers; zero if it has neither value nor default.
    #[must_use]
    pub fn triple(&self, word: &str) -> DVec3 {
        self.get(word).map_or(DVec3::ZERO, |value| value.triple())
    }

    /// An attribute of two numbers; zero if it has neither value nor default.
    #[must_use]
    pub fn pair(&self, word: &str) -> DVec2 {
        self.get(word).map_or(DVec2::ZERO, |value| value.pair())
    }

    /// An attribute of one number; zero if it has neither value nor default.
    #[must_use]
    pub fn number(&self, word: &str) -> f64 {
        self.get(word).map_or(0.0, |value| value.number())
    }

    /// An attribute of one number that may be absent.
    #[must_use]
    pub fn number_if_any(&self, word: &str) -> Option<f64> {
        self.get(word).map(|value| value.number())
    }

    /// A word, a name or a path; empty if it has neither value nor default.
    #[must_use]
    pub fn text(&self, word: &str) -> String {
        self.get(word)
            .map_or_else(String::new, |value| value.text().to_owned())
    }

    /// The place of an attribute or setting; the node's own if it is not given.
    #[must_use]
    pub fn place(&self, word: &str) -> Option<Location> {
        let property = || {
            let mut properties = self.properties.iter();
            properties.find(|property| property.attribute.word == word)
        };
        let entry = self.entry(word).or_else(property);
        entry.and_then(|entry| entry.location).or(self.location)
    }

    /// The node without the attributes and settings that equal their defaults.
    #[must_use]
    pub fn without_defaults(mut self) -> Self {
        self.properties.retain(|entry| !entry.is_default());
        for entry in &mut self.attributes {
            entry.properties.retain(|property| !property.is_default());
        }
        self.attributes.retain(|entry| {
            !(entry.properties.is_empty() && (entry.is_default() || entry.value.is_none()))
        });
        self
    }
}

impl Entry {
    fn new(attribute: &'static Attribute, value: Value) -> Self {
        Self {
            attribute,
            value: Some(value),
            properties: Vec::new(),
            location: None,
        }
    }

    /// The value or default of a setting on the attribute's line.
    #[must_use]
    pub fn property(&self, word: &str) -> Option<Value> {
        value_or_default(&self.properties, find(self.attribute.properties, word))
    }

    /// True if the default is written alike. A negative zero differs from zero.
    fn is_default(&self) -> bool {
        let written = |value: &Option<Value>| value.as_ref().map(Value::to_string);
        self.value.is_some() && written(&self.value) == written(&self.attribute.default.value())
    }
}

fn find(
    attributes: impl IntoIterator<Item = &'static Attribute>,
    word: &str,
) -> &'static Attribute {
    let mut attributes = attributes.into_iter();
    let found = attributes.find(|attribute| attribute.word == word);
    found.unwrap_or_else(|| unreachable!("the schema has no word {word:?}"))
}

fn value_or_default(entries: &[Entry], attribute: &'static Attribute) -> Option<Value> {
    let given = entries
        .iter()
        .find(|entry| entry.attribute.word == attribute.word);
    given
        .and_then(|entry| entry.value.clone())
        .or_else(|| attribute.default.value())
}

impl fmt::Display for Node {
    /// Writes the node as KDL 2.
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        out.write_str(self.schema.word)?;
        if let Some(name) = &self.name {
            write!(out, " {}", Value::from(name.as_str()))?;
        }
        if let Some(value) = &self.value {
            write!(out, " {value}")?;
        }
        write_properties(out, &self.properties)?;
        if !self.attributes.is_empty() {
            out.write_str(" {\n")?;
            for entry in &self.attributes {
                write!(out, "    {}", entry.attribute.word)?;
                if let Some(value) = &entry.value {
                    write!(out, " {value}")?;
                }
                write_properties(out, &entry.properties)?;
                out.write_str("\n")?;
            }
            out.write_str("}")?;
        }
        out.write_str("\n")
    }
}

fn write_properties(out: &mut fmt::Formatter<'_>, properties: &[Entry]) -> fmt::Result {
    for property in properties {
        if let Some(value) = &property.value {
            write!(out, " {}={value}", property.attribute.word)?;
        }
    }
    Ok(())
}
