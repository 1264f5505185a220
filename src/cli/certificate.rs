//! Output of `render --certify`.

use std::fmt;

use serde::Serialize;

use super::explanation::counted;
use crate::film::Film;
use crate::geometry::SharedKind;
use crate::math::Numerics;
use crate::render::{Both, Certificate, Counts};
use crate::scene::Scene;

/// The accuracy of a picture in numbers; lengths are in world units, `null` if nothing bounds them.
#[derive(Debug, Serialize)]
pub(super) struct Report {
    numerics: &'static str,
    /// Tests whether a ray hits a surface, or a surface blocks a light.
    decisions: u64,
    /// A lower bound of the tests that rounded values decided, from one test for each other sign.
    by_filter: u64,
    /// Signs that were computed exactly; a test may need several.
    exactly: u64,
    /// Exact ties, and origins within rounding of a plane, which rules decide.
    by_rule: u64,
    shared_planes: usize,
    shared_lines: usize,
    /// The largest distance, in the file, between planes or lines that are shared.
    largest_shared_distance: f64,
    /// The largest error of a hit of a camera ray.
    largest_error: Option<f64>,
    /// The largest estimate of the error of a hit behind mirrors and transparent surfaces.
    largest_bounced_error: Option<f64>,
    /// Rays that were dropped because their camera ray had caused as many as it may.
    capped_rays: u64,
    /// The largest intensity that one of them could have added.
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
    let decisions = counts.hit_tests + counts.occlusion_tests;
    let taken = counts.decisions;
    let robust = scene.settings.numerics == Numerics::Robust;
    let bounded = |most: f64| Some(most).filter(|most| most.is_finite());
    // Nothing bounds the errors of classic surfaces.
    let proven = |most: f64| bounded(most).filter(|_| robust);
    let shared = |what| scene.shared.iter().filter(|it| it.what == what).count();
    let distances = scene.shared.iter().map(|shared| shared.distance);
    Report {
        numerics: scene.settings.numerics.word(),
        decisions,
        by_filter: decisions.saturating_sub(taken.exactly + taken.by_rule),
        exactly: taken.exactly,
        by_rule: taken.by_rule,
        shared_planes: shared(SharedKind::Plane),
        shared_lines: shared(SharedKind::Line),
        largest_shared_distance: distances.fold(0.0, f64::max),
        largest_error: proven(certificate.largest_error),
        largest_bounced_error: proven(certificate.largest_bounced_error),
        capped_rays: counts.capped_rays,
        largest_residual: bounded(certificate.largest_residual),
        non_finite_pixels: film.non_finite().count(),
        picture_hash: film.hash(),
        robust,
    }
}

impl fmt::Display for Report {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(out, "certificate (lengths in world units)")?;
        if self.robust {
            self.write_robust(out)?;
        } else {
            let (tests, numerics) = (self.decisions, self.numerics);
            writeln!(
                out,
                "  tests              {tests}, decided in floating point without bounds ({numerics})"
            )?;
        }
        if self.capped_rays > 0 {
            let worth = match self.largest_residual {
                Some(residual) => format!("each of which could add at most {}", Short(residual)),
                None => "and nothing bounds what they could add".to_owned(),
            };
            let rays = counted(
                usize::try_from(self.capped_rays).unwrap_or(usize::MAX),
                "ray",
            );
            writeln!(out, "  dropped by limit   {rays}, {worth}")?;
        }
        writeln!(
            out,
            "  non-finite pixels  {}\n  picture hash       {}",
            self.non_finite_pixels, self.picture_hash,
        )
    }
}

impl Report {
    /// The lines about robust numerics.
    fn write_robust(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(
            out,
            "  tests              {}, at least {} decided in floating point with proven bounds\n  \
             exact decisions    {} signs computed exactly, {} decided by rule\n  \
             shared geometry    {}, {}, at most {} apart in the file\n  \
             hit error          {}\n  \
             bounced hit error  {}",
            self.decisions,
            self.by_filter,
            self.exactly,
            self.by_rule,
            counted(self.shared_planes, "plane"),
            counted(self.shared_lines, "line"),
            Short(self.largest_shared_distance),
            bound(self.largest_error, "at most ", ""),
            bound(
                self.largest_bounced_error,
                "about ",
                " (an estimate; after mirrors and refraction)"
            ),
        )
    }
}

/// An error between two texts; `None` if nothing bounds it.
fn bound(error: Option<f64>, before: &str, after: &str) -> String {
    match error {
        Some(error) => format!("{before}{}{after}", Short(error)),
        None => "unbounded: rounding may have changed the path of a ray".to_owned(),
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
