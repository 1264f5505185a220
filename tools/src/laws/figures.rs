//! The laws that are measured.

use std::path::PathBuf;

use heliodon::measure::Figure;

use super::series::{Failed, Series};
use super::{cut_off, edges, filters, numerics};

/// A law that is measured and drawn.
#[derive(Debug)]
pub struct Law {
    /// The name of its files.
    pub name: &'static str,
    /// The columns of its numbers.
    pub columns: [&'static str; 4],
    /// Measures it.
    pub measured: fn() -> Result<Vec<Series>, Failed>,
    /// Draws it.
    pub figure: fn(&[Series]) -> Figure,
}

/// The laws, in the order of the page.
pub const LAWS: [Law; 4] = [
    Law {
        name: "edges",
        columns: edges::COLUMNS,
        measured: edges::measured,
        figure: edges::figure,
    },
    Law {
        name: "filters",
        columns: filters::COLUMNS,
        measured: filters::measured,
        figure: filters::figure,
    },
    Law {
        name: "numerics",
        columns: numerics::COLUMNS,
        measured: numerics::measured,
        figure: numerics::figure,
    },
    Law {
        name: "cut-off",
        columns: cut_off::COLUMNS,
        measured: cut_off::measured,
        figure: cut_off::figure,
    },
];

impl Law {
    /// Its file with this ending.
    pub fn file(&self, ending: &str) -> PathBuf {
        format!("docs/laws/{}.{ending}", self.name).into()
    }
}
