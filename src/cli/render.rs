//! `heliodon render`.

use std::io::{BufWriter, ErrorKind, Write};
use std::path::{Path, PathBuf};
use std::time::Instant;

use clap::Args;
use rayon::prelude::*;

use super::asked::Asked;
use super::certificate::{self, Report};
use super::dials::Dials;
use super::input::Failure;
use super::messages::{Json, Messages, problems_json};
use super::output::{Output, Outputs, plan};
use super::threads::Threads;
use super::{FormatWord, Status, input, progress, stats};
use crate::film::{Notes, Print, Region, save};
use crate::language::{Problem, Refusal};
use crate::math::Rgb;
use crate::measure::LightTests;
use crate::plan::Scope;
use crate::read::{self, Reading};
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
    dials: Dials,
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
}

/// A part of the picture from `10,20,30,40`.
fn crop(text: &str) -> Result<Region, String> {
    let corners: Result<Vec<u32>, _> = text.split(',').map(|side| side.trim().parse()).collect();
    let Ok([left, top, right, bottom]) = corners.as_deref() else {
        return Err("expected four whole numbers, such as 10,20,30,40".to_owned());
    };
    Region::between([*left, *top], [*right, *bottom])
        .map_err(|refusal| format!("{}; {}", refusal.reason, refusal.advice))
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
    let one = |(scene, outputs): (&PathBuf, &Outputs)| {
        let made = picture(scene, outputs, &reader, options, &pool, messages);
        match (made, options.json.is_asked()) {
            (Ok(done), true) => messages.result(&done.json(), done.status),
            (Ok(done), false) => done.say(messages),
            (Err(failure), true) => messages.result(&failure.json(scene), failure.status),
            (Err(failure), false) => failure.status,
        }
    };
    let statuses: Vec<_> = options.scenes.iter().zip(&outputs).map(one).collect();
    messages.tally(&statuses);
    statuses.into_iter().fold(Status::Done, Status::worst)
}

/// Renders one scene and writes its picture.
fn picture<'a>(
    scene: &Path,
    outputs: &'a Outputs,
    reader: &read::Options,
    options: &Options,
    pool: &rayon::ThreadPool,
    messages: &Messages,
) -> Result<Done<'a>, Failure> {
    let start = Instant::now();
    let Reading {
        scene: mut read,
        warnings,
        ..
    } = input::read(scene, reader, messages)?;
    let title = input::title(scene);
    let output = outputs.of_depth(read.picture.depth);
    // The command line comes before the scene, and what was kept is what the settings say.
    read.picture.depth = output.format.depth();
    let replaced = output
        .path
        .as_ref()
        .and_then(|path| input::part_at(path, scene, &read));
    if let Some(replaced) = replaced {
        let error = format!("the picture of {title} would replace {replaced}, which it is made of");
        return Err(Failure::new(Status::Usage, error, messages));
    }
    let size = [read.picture.width, read.picture.height];
    let part = options.crop.unwrap_or_else(|| Region::whole(size));
    part.check_within(size).map_err(|refusal| {
        let error = format!("{title}: {}; {}", refusal.reason, refusal.advice);
        Failure::new(Status::Usage, error, messages)
    })?;
    let bar = progress::bar(&title, part.height as u64, messages);
    let progress = |rows| bar.set_position(rows as u64);
    let scope = if options.simulate_everything {
        Scope::Everything
    } else {
        Scope::CalledFor
    };
    let rendered = pool.install(|| {
        if options.certify {
            let (film, seen): (_, Both<Counts, Certificate>) =
                render::observed_part(&read, scope, part, &progress)?;
            let report = certificate::report(&seen, &read, &film);
            let print = Print::of(&film, output.format, read.picture.encoding());
            let print = print.ok_or_else(|| render::no_memory(part))?;
            return Ok((print, seen.0, Some(report)));
        }
        let (print, counts) = render::printed_part(&read, scope, part, output.format, &progress)?;
        Ok((print, counts, None))
    });
    bar.finish_and_clear();
    let (mut print, counts, certificate) = rendered.map_err(|refusal: Refusal| {
        Failure::new(
            Status::BadInput,
            format!("{title}: {}", refusal.reason),
            messages,
        )
    })?;
    inject_fault(&mut print);
    let hash = read.hash();
    write(&print, &read, options.crop, &hash, output).map_err(|error| {
        let error = format!("cannot write {}: {error}", output.title());
        Failure::new(Status::Io, error, messages)
    })?;
    let status = non_finite(&print, &title, messages);
    Ok(Done {
        stats: options.stats,
        certificate,
        title,
        read,
        warnings,
        counts,
        crop: options.crop,
        size: [part.width, part.height],
        hash,
        output,
        start,
        status,
    })
}

/// A finished picture, and what there is to say about it.
#[derive(Debug)]
struct Done<'a> {
    title: String,
    read: Scene,
    warnings: Vec<Problem>,
    counts: Counts,
    /// The part that was asked for.
    crop: Option<Region>,
    /// Its width and height in pixels, or those of the whole.
    size: [usize; 2],
    /// Whether to tell how much work it was.
    stats: bool,
    certificate: Option<Report>,
    hash: String,
    output: &'a Output,
    start: Instant,
    status: Status,
}

impl Done<'_> {
    fn json(&self) -> String {
        let picture = &self.read.picture;
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
            "problems": problems_json(&self.warnings, &self.read.sources),
        });
        if let Some(crop) = &self.crop {
            line["crop"] = serde_json::json!(crop.corners());
        }
        if self.stats {
            let by_light = LightTests::all(&self.read, &self.counts);
            line["by_light"] = serde_json::json!(by_light);
        }
        if let Some(certificate) = &self.certificate {
            line["certificate"] = serde_json::json!(certificate);
        }
        format!("{line}\n")
    }

    fn say(&self, messages: &Messages) -> Status {
        let picture = &self.read.picture;
        messages.note(&format!(
            "{} -> {}, {}x{}, {:.2} s",
            self.title,
            self.output.title(),
            self.size[0],
            self.size[1],
            self.start.elapsed().as_secs_f64(),
        ));
        let stats = self.stats.then(|| {
            let by_light = LightTests::all(&self.read, &self.counts);
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

fn write(
    print: &Print,
    scene: &Scene,
    crop: Option<Region>,
    hash: &str,
    output: &Output,
) -> std::io::Result<()> {
    let settings = scene.picture.describe().to_string();
    let mut notes = Notes(vec![
        (
            "Software",
            concat!("heliodon ", env!("CARGO_PKG_VERSION")).to_owned(),
        ),
        ("Settings", settings.trim_end().to_owned()),
        ("Scene hash", hash.to_owned()),
    ]);
    if let Some(crop) = crop {
        notes
            .0
            .push(("Crop", crop.corners().map(|it| it.to_string()).join(",")));
    }
    match &output.path {
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

/// Spoils a pixel if the environment asks for it, so that a test can see what the program does
/// about a fault that it ought not to have.
fn inject_fault(print: &mut Print) {
    let asked = std::env::var_os("HELIODON_FAULT").is_some_and(|fault| fault == "non-finite");
    if asked {
        let nonsense = Rgb::new(f64::NAN, 0.0, 0.0);
        print
            .rows()
            .take(1)
            .for_each(|mut row| row.expose(&[nonsense]));
    }
}

/// Reports pixels that are no numbers; there should never be one.
fn non_finite(print: &Print, title: &str, messages: &Messages) -> Status {
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
