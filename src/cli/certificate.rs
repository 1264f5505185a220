//! What `render --certify` prints.

use std::fmt;

use serde::Serialize;

use super::explanation::counted;
use crate::film::Film;
use crate::geometry::SharedKind;
use crate::math::Numerics;
use crate::render::{Both, Certificate, Counts};
use crate::scene::Scene;

/// How right a picture is, in numbers.
#[derive(Debug, Serialize)]
pub(super) struct Report {
    numerics: &'static str,
    /// Surface tests: does this ray meet it, does it hide the light.
    decisions: u64,
    /// Those of them that rounded values decided: all, but for one for each sign that they did not.
    by_filter: u64,
    /// Signs, of which a test may need several.
    exactly: u64,
    by_rule: u64,
    shared_planes: usize,
    shared_lines: usize,
    /// The largest distance between what was welded, in world units.
    largest_weld: f64,
    /// In world units; `null` if nothing bounds it.
    largest_error: Option<f64>,
    /// In world units; `null` if nothing bounds it.
    largest_bounced_error: Option<f64>,
    /// Rays that were not followed because a ray from the eye may cause only so many, and how much
    /// intensity one of them could have added at most; `null` if nothing bounds it.
    capped_rays: u64,
    largest_residual: Option<f64>,
    non_finite_pixels: usize,
    picture_hash: String,
    #[serde(skip)]
    robust: bool,
}

pub(super) fn report(
    Both(counts, certificate): &Both<Counts, Certificate>,
    scene: &Scene,
    film: &Film,
) -> Report {
    let Certificate {
        largest_error,
        largest_bounced_error,
        largest_residual,
    } = *certificate;
    let decisions = counts.hit_tests + counts.occlusion_tests;
    let taken = counts.decisions;
    let robust = scene.settings.numerics == Numerics::Robust;
    let bounded = |most: f64| Some(most).filter(|most| most.is_finite());
    // What classic surfaces decide may be off by anything.
    let proven = |most: f64| bounded(most).filter(|_| robust);
    let welds = |what| scene.shared.iter().filter(|weld| weld.what == what).count();
    let distances = scene.shared.iter().map(|weld| weld.distance);
    Report {
        numerics: scene.settings.numerics.word(),
        decisions,
        by_filter: decisions.saturating_sub(taken.exactly + taken.by_rule),
        exactly: taken.exactly,
        by_rule: taken.by_rule,
        shared_planes: welds(SharedKind::Plane),
        shared_lines: welds(SharedKind::Line),
        largest_weld: distances.fold(0.0, f64::max),
        largest_error: proven(largest_error),
        largest_bounced_error: proven(largest_bounced_error),
        capped_rays: counts.capped_rays,
        largest_residual: bounded(largest_residual),
        non_finite_pixels: film.non_finite().count(),
        picture_hash: film.hash(),
        robust,
    }
}

impl fmt::Display for Report {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.robust {
            writeln!(
                out,
                "certificate\n  \
                 surface tests       {}, at least {} of them by rounded values with proven bounds\n  \
                 other signs         {} exactly, {} by rule\n  \
                 welded              {}, {}, {} apart at most\n  \
                 error of a hit      {}\n  \
                 error after mirrors {}",
                self.decisions,
                self.by_filter,
                self.exactly,
                self.by_rule,
                counted(self.shared_planes, "shared plane"),
                counted(self.shared_lines, "shared line"),
                Short(self.largest_weld),
                said(self.largest_error, " at most, in world units"),
                said(self.largest_bounced_error, ", an estimate"),
            )?;
        } else {
            writeln!(
                out,
                "certificate\n  \
                 surface tests       {} by rounded values without bounds ({})",
                self.decisions, self.numerics,
            )?;
        }
        if self.capped_rays > 0 {
            let worth = match self.largest_residual {
                Some(residual) => format!("each worth {} at most", Short(residual)),
                None => "and nothing bounds what mirrors without loss bring".to_owned(),
            };
            let rays = self.capped_rays;
            writeln!(out, "  cut off by the cap  {rays} rays, {worth}")?;
        }
        writeln!(
            out,
            "  not finite          {} pixels\n  picture             {}",
            self.non_finite_pixels, self.picture_hash,
        )
    }
}

/// An error with what it is; `None` if nothing bounds it.
fn said(error: Option<f64>, what: &str) -> String {
    match error {
        Some(error) => format!("{}{what}", Short(error)),
        None => "unknown: rounding may have led a ray anywhere".to_owned(),
    }
}

/// A number of which only the magnitude matters.
struct Short(f64);

impl fmt::Display for Short {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.0 == 0.0 {
            out.write_str("0")
        } else {
            write!(out, "{:.1e}", self.0)
        }
    }
}
