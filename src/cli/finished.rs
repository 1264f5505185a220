//! Output of `render` about a finished picture.

use std::io::{BufWriter, ErrorKind, Write};
use std::time::Instant;

use super::certificate::Report;
use super::explanation::counted;
use super::messages::{Messages, problems_json};
use super::output::Output;
use super::{Status, stats};
use crate::film::{EncodedImage, Notes, Region, save};
use crate::language::Diagnostic;
use crate::measure::LightTests;
use crate::render::Counts;
use crate::scene::Scene;

/// A finished picture, and everything that can be printed about it.
#[derive(Debug)]
pub(super) struct Finished {
    pub(super) title: String,
    pub(super) scene: Scene,
    pub(super) warnings: Vec<Diagnostic>,
    pub(super) counts: Counts,
    /// The part that was asked for.
    pub(super) crop: Option<Region>,
    /// Width and height in pixels, of the part if there is one.
    pub(super) size: [usize; 2],
    /// True if the work is to be printed.
    pub(super) stats: bool,
    pub(super) certificate: Option<Report>,
    pub(super) hash: String,
    pub(super) output: Output,
    pub(super) start: Instant,
    pub(super) status: Status,
}

impl Finished {
    /// Writes the picture to its place, with notes about settings and scene.
    pub(super) fn write(&self, image: &EncodedImage) -> std::io::Result<()> {
        let settings = self.scene.settings.describe().to_string();
        let version = concat!("heliodon ", env!("CARGO_PKG_VERSION"));
        let mut notes = vec![
            ("Software", version.to_owned()),
            ("Settings", settings.trim_end().to_owned()),
            ("Scene hash", self.hash.clone()),
        ];
        if let Some(crop) = self.crop {
            let corners = crop.bounds().map(|it| it.to_string());
            notes.push(("Crop", corners.join(",")));
        }
        let notes = Notes(notes);
        if let Some(path) = &self.output.path {
            return save(path, |out| image.write(out, &notes));
        }
        let mut out = BufWriter::new(std::io::stdout().lock());
        let written = image.write(&mut out, &notes);
        match written.and_then(|()| out.flush()) {
            // A pipe that its reader has closed is no error.
            Err(error) if error.kind() == ErrorKind::BrokenPipe => Ok(()),
            written => written,
        }
    }

    /// Everything as one line of JSON.
    pub(super) fn json(&self) -> String {
        let mut line = serde_json::json!({
            "scene": self.title,
            "exit": self.status.code(),
            "output": self.output.title(),
            "width": self.size[0],
            "height": self.size[1],
            "samples": self.scene.settings.samples,
            "rays": self.counts,
            "hash": self.hash,
            "seconds": self.start.elapsed().as_secs_f64(),
            "problems": problems_json(&self.warnings, &self.scene.sources),
        });
        if let Some(crop) = &self.crop {
            line["crop"] = serde_json::json!(crop.bounds());
        }
        if self.stats {
            line["by_light"] = serde_json::json!(LightTests::all(&self.scene, &self.counts));
        }
        if let Some(certificate) = &self.certificate {
            line["certificate"] = serde_json::json!(certificate);
        }
        format!("{line}\n")
    }

    /// Prints the results that are wanted, and returns the status to end with.
    pub(super) fn say(&self, messages: &Messages) -> Status {
        messages.note(&format!(
            "{} -> {}, {}x{}, {:.2} s",
            self.title,
            self.output.title(),
            self.size[0],
            self.size[1],
            self.start.elapsed().as_secs_f64(),
        ));
        let stats = self.stats.then(|| {
            let by_light = LightTests::all(&self.scene, &self.counts);
            stats::table(&self.counts, &by_light)
        });
        let results = [self.certificate.as_ref().map(Report::to_string), stats];
        for result in results.into_iter().flatten() {
            let printed = messages.result(&result, self.status);
            if printed != self.status {
                return printed;
            }
        }
        if messages.verbose {
            messages.note(&self.work());
        }
        self.status
    }

    /// The work in short.
    fn work(&self) -> String {
        let counts = &self.counts;
        format!(
            "  {} rays: {} camera, {} shadow, {} mirrored, {} transmitted\n  \
             {} per pixel, scene hash {}",
            counts.rays(),
            counts.camera_rays,
            counts.shadow_rays + counts.lamp_rays,
            counts.mirror_rays,
            counts.transmitted_rays,
            counted(self.scene.settings.samples as usize, "sample"),
            self.hash,
        )
    }
}
