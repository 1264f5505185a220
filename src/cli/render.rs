//! `heliodon render`.

use std::path::{Path, PathBuf};
use std::time::Instant;

use clap::Args;
use rayon::prelude::*;

use super::asked::Asked;
use super::certificate::{self, Report};
use super::error::CommandError;
use super::finished::Finished;
use super::format_word::FormatWord;
use super::messages::{Json, Messages};
use super::numbers::separated;
use super::output::{Outputs, plan};
use super::setting_options::SettingOptions;
use super::threads::Threads;
use super::{Status, input, progress};
use crate::film::{EncodedImage, Format, Region, check_writable};
use crate::language::ValueError;
use crate::math::Rgb;
use crate::plan::Scope;
use crate::read;
use crate::render::{self, Both, Certificate, Counts};
use crate::scene::Scene;

/// Render scenes to pictures.
///
/// A picture is written to the current folder under the scene's name, unless -o names another
/// place. The same scene gives the same bytes on any number of threads.
#[derive(Debug, Args)]
pub(super) struct Options {
    /// Scene files in KDL or in the course's block grammar; `-` reads standard input.
    #[arg(required = true, value_name = "SCENE")]
    scenes: Vec<PathBuf>,
    /// Output: a file, a folder, or a name with `{stem}`; `-` writes to standard output.
    ///
    /// `{stem}` stands for the scene's name. The ending .png, .ppm or .pfm selects the format; a
    /// PNG has 16 bits a channel if the depth is 16.
    #[arg(short, long, value_name = "OUT")]
    output: Option<String>,
    /// Render a part: columns and rows from X0,Y0 up to but not including X1,Y1.
    ///
    /// They are counted from 0 at the top left. The pixels equal those of the whole picture.
    #[arg(long, value_name = "X0,Y0,X1,Y1", allow_hyphen_values = true, value_parser = crop)]
    crop: Option<Region>,
    #[command(flatten)]
    threads: Threads,
    /// Format of the pictures, or language of the scenes; may be given for both.
    #[arg(long, value_name = "FORMAT", value_enum)]
    format: Vec<FormatWord>,
    /// Report how accurate the picture is: how hits were decided, and the largest errors.
    #[arg(long)]
    certify: bool,
    /// Report how much work the picture took: rays of each kind, tests, texel fetches.
    #[arg(long)]
    stats: bool,
    /// Disable all lossless shortcuts: the same bytes, but slower.
    #[arg(long)]
    simulate_everything: bool,
    #[command(flatten)]
    json: Json,
    // The last, since the help lists later options under its heading.
    #[command(flatten)]
    settings: SettingOptions,
}

/// A part of the picture from `10,20,30,40`.
fn crop(text: &str) -> Result<Region, String> {
    let corners = separated(text, &[',']);
    let [left, top, right, bottom] =
        corners.ok_or("expected four whole numbers, such as 10,20,30,40")?;
    Region::between([left, top], [right, bottom])
        .map_err(|error| format!("{}; {}", error.reason, error.advice))
}

pub(super) fn run(options: &Options, messages: &Messages) -> Status {
    let (batch, outputs) = match prepare(options, messages) {
        Ok(prepared) => prepared,
        Err(error) => return messages.failed(&error),
    };
    let scenes = options.scenes.iter().zip(&outputs);
    let statuses: Vec<_> = scenes.map(|(scene, to)| batch.one(scene, to)).collect();
    messages.tally(&statuses);
    statuses.into_iter().max().unwrap_or(Status::Done)
}

/// Checks the command line as a whole, and starts the threads.
fn prepare<'a>(
    options: &'a Options,
    messages: &'a Messages,
) -> Result<(Batch<'a>, Vec<Outputs>), CommandError> {
    let words = options.format.iter();
    let formats: Vec<_> = words.clone().filter_map(|word| word.picture()).collect();
    let languages: Vec<_> = words.filter_map(|word| word.language()).collect();
    let is_dash = |scene: &&PathBuf| scene.as_os_str() == input::DASH;
    let refused = if formats.len() > 1 || languages.len() > 1 {
        Some("--format takes at most one format for pictures and one language for scenes")
    } else if options.output.as_deref() == Some(input::DASH) && options.json.is_asked() {
        Some("--json and a picture cannot both go to standard output")
    } else if options.scenes.iter().filter(is_dash).count() > 1 {
        Some("standard input can be read only once")
    } else {
        None
    };
    if let Some(reason) = refused {
        return Err(CommandError::usage(reason));
    }
    let asked = Asked {
        pattern: options.output.as_deref(),
        format: formats.first().copied(),
        depth: options.settings.depth(),
    };
    let outputs = plan(&options.scenes, asked)?;
    let reader = options.settings.added_to(read::Options {
        language: languages.first().copied(),
        ..read::Options::default()
    });
    let pool = options.threads.pool()?;
    let batch = Batch {
        options,
        reader,
        pool,
        messages,
    };
    Ok((batch, outputs))
}

/// Everything that the scenes of a command have in common.
struct Batch<'a> {
    options: &'a Options,
    reader: read::Options,
    pool: rayon::ThreadPool,
    messages: &'a Messages,
}

/// A rendered picture, its work, and its certificate if that is wanted.
type Rendered = (EncodedImage, Counts, Option<Report>);

impl Batch<'_> {
    /// Renders one scene, writes its picture, and prints its results.
    fn one(&self, scene: &Path, outputs: &Outputs) -> Status {
        let json = self.options.json.is_asked();
        match self.picture(scene, outputs) {
            Ok(done) if json => self.messages.result(&done.json(), done.status),
            Ok(done) => done.say(self.messages),
            Err(error) => self.messages.finish(scene, json, Err(error)),
        }
    }

    /// Renders one scene and writes its picture.
    fn picture(&self, path: &Path, outputs: &Outputs) -> Result<Finished, CommandError> {
        let start = Instant::now();
        let title = input::title(path);
        let reading = input::read(path, &self.reader, self.messages)?;
        let (mut scene, warnings) = (reading.scene, reading.warnings);
        let output = outputs.of_depth(scene.settings.depth);
        // The command line overrides the scene, and the file keeps what the settings state.
        scene.settings.depth = output.format.depth();
        let replaced = output.path.as_ref();
        if let Some(part) = replaced.and_then(|output| input::part_at(output, path, &scene)) {
            return Err(CommandError::usage(format!(
                "the picture of {title} would replace {part}, which the scene uses"
            )));
        }
        let size = [scene.settings.width, scene.settings.height];
        let crop = self.options.crop;
        let part = crop.unwrap_or_else(|| Region::whole(size));
        part.check_within(size)
            .map_err(|error| CommandError::value(Status::Usage, &title, &error))?;
        let place = output.title();
        let cannot_write = |error| CommandError::write(&place, error);
        // Found out before the work, not after it.
        if let Some(path) = &output.path {
            check_writable(path).map_err(cannot_write)?;
        }
        let (mut image, counts, certificate) = self
            .render(&scene, part, output.format, &title)
            .map_err(|error| CommandError::value(Status::BadInput, &title, &error))?;
        inject_fault(&mut image);
        let mut finished = Finished {
            hash: scene.hash(),
            title,
            scene,
            warnings,
            counts,
            crop,
            size: [part.width, part.height],
            stats: self.options.stats,
            certificate,
            output,
            start,
            status: Status::Done,
        };
        finished.write(&image).map_err(cannot_write)?;
        finished.status = non_finite(&image, &finished.title, self.messages);
        Ok(finished)
    }

    /// Renders a part of a scene's picture, with a certificate if that is wanted.
    fn render(
        &self,
        scene: &Scene,
        part: Region,
        format: Format,
        title: &str,
    ) -> Result<Rendered, ValueError> {
        let bar = progress::bar(title, part.height as u64, self.messages);
        let progress = |rows| bar.set_position(rows as u64);
        let scope = if self.options.simulate_everything {
            Scope::Everything
        } else {
            Scope::CalledFor
        };
        let request = render::Render::new(scene)
            .scope(scope)
            .part(part)
            .progress(&progress);
        let rendered = self.pool.install(|| {
            if !self.options.certify {
                let (image, counts) = request.encoded(format)?;
                return Ok((image, counts, None));
            }
            let (film, seen): (_, Both<Counts, Certificate>) = request.film()?;
            let report = certificate::report(&seen, scene, &film);
            let image = EncodedImage::of(&film, format, scene.settings.encoding());
            let image = image.ok_or_else(|| render::no_memory(part))?;
            Ok((image, seen.0, Some(report)))
        });
        bar.finish_and_clear();
        rendered
    }
}

/// Spoils a pixel if the environment asks for it, so that tests can see exit code 5.
fn inject_fault(image: &mut EncodedImage) {
    let asked = std::env::var_os("HELIODON_FAULT").is_some_and(|fault| fault == "non-finite");
    if asked {
        let row = image.rows().take(1);
        row.for_each(|mut row| row.encode_row(&[Rgb::new(f64::NAN, 0.0, 0.0)]));
    }
}

/// Reports pixels that are no numbers; there should never be one.
fn non_finite(image: &EncodedImage, title: &str, messages: &Messages) -> Status {
    const MOST: usize = 10;
    let odd: Vec<_> = image.non_finite().collect();
    if odd.is_empty() {
        return Status::Done;
    }
    let places = odd.iter().take(MOST).map(|(x, y)| format!("{x},{y}"));
    let places: Vec<_> = places.collect();
    messages.error(&format!(
        "{title}: {} pixels are infinite or not a number: {}{}",
        odd.len(),
        places.join(" "),
        if odd.len() > MOST { " …" } else { "" },
    ));
    Status::NonFinite
}
