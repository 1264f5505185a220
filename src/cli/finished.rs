//! What there is to say about a picture.

use std::io::{BufWriter, ErrorKind, Write};
use std::time::Instant;

use super::certificate::Report;
use super::messages::{Messages, problems_json};
use super::output::Output;
use super::{Status, stats};
use crate::film::{EncodedImage, Notes, Region, save};
use crate::language::Diagnostic;
use crate::measure::LightTests;
use crate::render::Counts;
use crate::scene::Scene;

/// A finished picture, and what there is to say about it.
#[derive(Debug)]
pub(super) struct Finished<'a> {
    pub(super) title: String,
    pub(super) scene: Scene,
    pub(super) warnings: Vec<Diagnostic>,
    pub(super) counts: Counts,
    /// The part that was asked for.
    pub(super) crop: Option<Region>,
    /// Its width and height in pixels, or those of the whole.
    pub(super) size: [usize; 2],
    /// Whether to tell how much work it was.
    pub(super) stats: bool,
    pub(super) certificate: Option<Report>,
    pub(super) hash: String,
    pub(super) output: &'a Output,
    pub(super) start: Instant,
    pub(super) status: Status,
}

impl Finished<'_> {
    /// Writes it to its place, with the settings and the scene that it is of.
    pub(super) fn write(&self, print: &EncodedImage) -> std::io::Result<()> {
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
        match &self.output.path {
            Some(path) => save(path, |out| print.write(out, &notes)),
            None => {
                let mut out = BufWriter::new(std::io::stdout().lock());
                let written = print.write(&mut out, &notes);
                match written.and_then(|()| out.flush()) {
                    // A reader that has seen enough is no error.
                    Err(error) if error.kind() == ErrorKind::BrokenPipe => Ok(()),
                    written => written,
                }
            }
        }
    }

    /// All there is to say, as one line of JSON.
    pub(super) fn json(&self) -> String {
        let picture = &self.scene.settings;
        let mut line = serde_json::json!({
            "scene": self.title,
            "exit": self.status.code(),
            "output": self.output.title(),
            "width": self.size[0],
            "height": self.size[1],
            "samples": picture.samples,
            "rays": self.counts,
            "hash": self.hash,
            "seconds": self.start.elapsed().as_secs_f64(),
            "problems": problems_json(&self.warnings, &self.scene.sources),
        });
        if let Some(crop) = &self.crop {
            line["crop"] = serde_json::json!(crop.bounds());
        }
        if self.stats {
            let by_light = LightTests::all(&self.scene, &self.counts);
            line["by_light"] = serde_json::json!(by_light);
        }
        if let Some(certificate) = &self.certificate {
            line["certificate"] = serde_json::json!(certificate);
        }
        format!("{line}\n")
    }

    /// Says what is asked, and gives the status to end with.
    pub(super) fn say(&self, messages: &Messages) -> Status {
        let picture = &self.scene.settings;
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
        let answers = [self.certificate.as_ref().map(Report::to_string), stats];
        for answer in answers.into_iter().flatten() {
            // The answer to a question is a result.
            let printed = messages.result(&answer, self.status);
            if printed != self.status {
                return printed;
            }
        }
        if messages.verbose {
            let counts = &self.counts;
            messages.note(&format!(
                "  {} rays: {} from the eye, {} to lights, {} from mirrors, {} through surfaces\n  \
                 {} samples a pixel, scene hash {}",
                counts.rays(),
                counts.camera_rays,
                counts.shadow_rays + counts.lamp_rays,
                counts.mirror_rays,
                counts.transmitted_rays,
                picture.samples,
                self.hash,
            ));
        }
        self.status
    }
}
