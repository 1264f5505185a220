//! Former names of JSON keys.

use serde_json::Value;

/// Key of the object around a key, the key, and its former name, which is written as well.
const ALIASES: [[&str; 3]; 15] = [
    ["", "steps", "rungs"],
    ["", "breakdowns", "blames"],
    ["reference", "uncertainty", "doubt"],
    ["steps", "setting", "dial"],
    ["steps", "within_max_error", "met"],
    ["own", "setting", "dial"],
    ["own", "text", "step"],
    ["laws", "setting", "dial"],
    ["breakdowns", "setting", "dial"],
    ["breakdowns", "text", "step"],
    ["breakdowns", "label", "rung"],
    ["breakdowns", "features", "spots"],
    ["features", "feature", "spot"],
    ["rays", "hit", "met"],
    ["causes", "hit", "met"],
];

/// An answer in JSON, with former names of keys beside the current ones.
pub(super) fn json(answer: &impl serde::Serialize) -> Value {
    let mut value = serde_json::json!(answer);
    add_aliases(&mut value, "");
    value
}

fn add_aliases(value: &mut Value, around: &str) {
    match value {
        Value::Array(items) => items.iter_mut().for_each(|item| add_aliases(item, around)),
        Value::Object(object) => {
            for (key, value) in object.iter_mut() {
                add_aliases(value, key);
            }
            for [_, key, former] in ALIASES.iter().filter(|[within, ..]| *within == around) {
                if let Some(value) = object.get(*key).cloned() {
                    object.insert((*former).to_owned(), value);
                }
            }
        }
        _ => {}
    }
}
