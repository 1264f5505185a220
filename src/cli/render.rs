//! `heliodon render`.

use std::path::{Path, PathBuf};
use std::time::Instant;

use clap::Args;
use rayon::prelude::*;

use super::asked::Asked;
use super::certificate::{self, Report};
use super::dials::Dials;
use super::finished::Finished;
use super::input::ReadError;
use super::messages::{Json, Messages};
use super::output::{Outputs, plan};
use super::threads::Threads;
use super::{FormatWord, Status, input, progress};
use crate::film::{EncodedImage, Format, Region, check_writable};
use crate::language::ValueError;
use crate::math::Rgb;
use crate::plan::Scope;
use crate::read;
use crate::render::{self, Both, Certificate, Counts};
use crate::scene::Scene;

/// Renders scenes to pictures.
///
/// A picture goes to a file of the scene's name in the current folder, unless -o says otherwise.
/// The same scene gives the same bytes, on any number of threads.
#[derive(Debug, Args)]
pub(super) struct Options {
    /// Scene files, KDL or the course's block grammar; `-` is standard input.
    #[arg(required = true, value_name = "SCENE")]
    scenes: Vec<PathBuf>,
    /// Where pictures go: a file, a folder, or a name with `{stem}` in it; `-` is standard output.
    ///
    /// The ending .png, .ppm or .pfm names the format; a PNG has 16 bits if the depth is 16.
    #[arg(short, long, value_name = "OUT")]
    output: Option<String>,
    /// Only this part of the picture: first column and row, counted from the top left, from 0, and
    /// those behind the last; its pixels are those of the whole.
    #[arg(long, value_name = "X0,Y0,X1,Y1", allow_hyphen_values = true, value_parser = crop)]
    crop: Option<Region>,
    #[command(flatten)]
    threads: Threads,
    /// Format of the pictures or of the scenes; may be given for both.
    #[arg(long, value_name = "FORMAT", value_enum)]
    format: Vec<FormatWord>,
    /// Tell how right the picture is: how hits were decided, and the largest errors.
    #[arg(long)]
    certify: bool,
    /// Tell how much work the picture took: rays of each kind, tests, fetches.
    #[arg(long)]
    stats: bool,
    /// Leave nothing out that is proven to change nothing; the picture is the same, only slower.
    #[arg(long)]
    simulate_everything: bool,
    #[command(flatten)]
    json: Json,
    // The last, since the help has what comes after them under their heading.
    #[command(flatten)]
    dials: Dials,
}

/// A part of the picture from `10,20,30,40`.
fn crop(text: &str) -> Result<Region, String> {
    let corners: Result<Vec<u32>, _> = text.split(',').map(|side| side.trim().parse()).collect();
    let Ok([left, top, right, bottom]) = corners.as_deref() else {
        return Err("expected four whole numbers, such as 10,20,30,40".to_owned());
    };
    Region::between([*left, *top], [*right, *bottom])
        .map_err(|error| format!("{}; {}", error.reason, error.advice))
}

pub(super) fn run(options: &Options, messages: &Messages) -> Status {
    let picture_formats: Vec<_> = options
        .format
        .iter()
        .filter_map(|word| word.picture())
        .collect();
    let languages: Vec<_> = options
        .format
        .iter()
        .filter_map(|word| word.language())
        .collect();
    if picture_formats.len() > 1 || languages.len() > 1 {
        messages.error("error: --format names one format for pictures and one for scenes at most");
        return Status::Usage;
    }
    if options.output.as_deref() == Some(input::DASH) && options.json.is_asked() {
        messages.error("error: --json and a picture cannot both go to standard output");
        return Status::Usage;
    }
    let stdin = options
        .scenes
        .iter()
        .filter(|scene| scene.as_os_str() == input::DASH);
    if stdin.count() > 1 {
        messages.error("error: standard input can be read only once");
        return Status::Usage;
    }
    let asked = Asked {
        pattern: options.output.as_deref(),
        format: picture_formats.first().copied(),
        depth: options.dials.depth(),
    };
    let outputs = match plan(&options.scenes, asked) {
        Ok(outputs) => outputs,
        Err(refused) => {
            messages.error(&format!("error: {}", refused.reason));
            return refused.status;
        }
    };
    let pool = match options.threads.pool() {
        Ok(pool) => pool,
        Err(error) => {
            messages.error(&format!("error: {error}"));
            return Status::Io;
        }
    };
    let reader = options.dials.added_to(read::Options {
        language: languages.first().copied(),
        ..read::Options::default()
    });
    let batch = Batch {
        options,
        reader,
        pool,
        messages,
    };
    let scenes = options.scenes.iter().zip(&outputs);
    let statuses: Vec<_> = scenes.map(|(scene, to)| batch.one(scene, to)).collect();
    messages.tally(&statuses);
    statuses.into_iter().fold(Status::Done, Status::worst)
}

/// What is the same for all scenes of a command.
struct Batch<'a> {
    options: &'a Options,
    reader: read::Options,
    pool: rayon::ThreadPool,
    messages: &'a Messages,
}

/// A picture that is drawn, and what was seen meanwhile.
type Drawn = (EncodedImage, Counts, Option<Report>);

impl Batch<'_> {
    /// Renders one scene, writes its picture, and tells of it as is asked.
    fn one(&self, scene: &Path, outputs: &Outputs) -> Status {
        match (self.picture(scene, outputs), self.options.json.is_asked()) {
            (Ok(done), true) => self.messages.result(&done.json(), done.status),
            (Ok(done), false) => done.say(self.messages),
            (Err(failure), true) => self.messages.result(&failure.json(scene), failure.status),
            (Err(failure), false) => failure.status,
        }
    }

    /// Renders one scene and writes its picture.
    fn picture<'o>(&self, scene: &Path, outputs: &'o Outputs) -> Result<Finished<'o>, ReadError> {
        let start = Instant::now();
        let title = input::title(scene);
        let failure = |status, error| ReadError::new(status, error, self.messages);
        let reading = input::read(scene, &self.reader, self.messages)?;
        let (mut read, warnings) = (reading.scene, reading.warnings);
        let output = outputs.of_depth(read.settings.depth);
        // The command line comes before the scene, and what was kept is what the settings say.
        read.settings.depth = output.format.depth();
        let replaced = output.path.as_ref();
        if let Some(replaced) = replaced.and_then(|path| input::part_at(path, scene, &read)) {
            let error =
                format!("the picture of {title} would replace {replaced}, which it is made of");
            return Err(failure(Status::Usage, error));
        }
        let size = [read.settings.width, read.settings.height];
        let crop = self.options.crop;
        let part = crop.unwrap_or_else(|| Region::whole(size));
        part.check_within(size).map_err(|error| {
            let error = format!("{title}: {}; {}", error.reason, error.advice);
            failure(Status::Usage, error)
        })?;
        let cannot_write = |error: std::io::Error| {
            let error = format!("cannot write {}: {error}", output.title());
            failure(Status::Io, error)
        };
        // What cannot be written need not be drawn.
        if let Some(path) = &output.path {
            check_writable(path).map_err(cannot_write)?;
        }
        let drawn = self.draw(&read, part, output.format, &title);
        let (mut print, counts, certificate) = drawn
            .map_err(|error| failure(Status::BadInput, format!("{title}: {}", error.reason)))?;
        inject_fault(&mut print);
        let mut finished = Finished {
            hash: read.hash(),
            title,
            scene: read,
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
        finished.write(&print).map_err(cannot_write)?;
        finished.status = non_finite(&print, &finished.title, self.messages);
        Ok(finished)
    }

    /// Draws a part of a scene's picture, and finds out how right it is if that is asked.
    fn draw(
        &self,
        scene: &Scene,
        part: Region,
        format: Format,
        title: &str,
    ) -> Result<Drawn, ValueError> {
        let bar = progress::bar(title, part.height as u64, self.messages);
        let progress = |rows| bar.set_position(rows as u64);
        let scope = if self.options.simulate_everything {
            Scope::Everything
        } else {
            Scope::CalledFor
        };
        let drawn = self.pool.install(|| {
            if !self.options.certify {
                let (print, counts) = render::printed_part(scene, scope, part, format, &progress)?;
                return Ok((print, counts, None));
            }
            let (film, seen): (_, Both<Counts, Certificate>) =
                render::observed_part(scene, scope, part, &progress)?;
            let report = certificate::report(&seen, scene, &film);
            let print = EncodedImage::of(&film, format, scene.settings.encoding());
            let print = print.ok_or_else(|| render::no_memory(part))?;
            Ok((print, seen.0, Some(report)))
        });
        bar.finish_and_clear();
        drawn
    }
}

/// Spoils a pixel if the environment asks for it, so that a test can see what the program does
/// about a fault that it ought not to have.
fn inject_fault(print: &mut EncodedImage) {
    let asked = std::env::var_os("HELIODON_FAULT").is_some_and(|fault| fault == "non-finite");
    if asked {
        let nonsense = Rgb::new(f64::NAN, 0.0, 0.0);
        print
            .rows()
            .take(1)
            .for_each(|mut row| row.encode_row(&[nonsense]));
    }
}

/// Reports pixels that are no numbers; there should never be one.
fn non_finite(print: &EncodedImage, title: &str, messages: &Messages) -> Status {
    const MOST: usize = 10;
    let odd: Vec<_> = print.non_finite().collect();
    if odd.is_empty() {
        return Status::Done;
    }
    let places: Vec<_> = odd
        .iter()
        .take(MOST)
        .map(|(x, y)| format!("{x},{y}"))
        .collect();
    let more = if odd.len() > MOST { " …" } else { "" };
    messages.error(&format!(
        "error: {title}: {} pixels are infinite or not a number: {}{more}",
        odd.len(),
        places.join(" "),
    ));
    Status::NonFinite
}
