//! `heliodon render`.

use std::io::{BufWriter, Write};
use std::path::{Path, PathBuf};
use std::time::Instant;

use clap::Args;

use super::messages::Messages;
use super::output::{Output, plan};
use super::{FormatWord, Status, input, progress};
use crate::film::{Film, Format, Notes, save};
use crate::read::{self, Reading};
use crate::render::{Counts, render};
use crate::scene::{Picture, Scene};

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
    /// The ending .png, .ppm or .pfm names the format.
    #[arg(short, long, value_name = "OUT")]
    output: Option<String>,
    /// Size of the picture in pixels, such as 800x600, instead of the scene's.
    #[arg(long, value_name = "WxH", value_parser = size)]
    size: Option<[u32; 2]>,
    /// Rays through each pixel, instead of the scene's.
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=i64::from(Picture::MOST_SAMPLES)))]
    samples: Option<u32>,
    /// Threads to render with; all processors if not given.
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..=1024))]
    threads: Option<u16>,
    /// Format of the pictures or of the scenes; may be given for both.
    #[arg(long, value_name = "FORMAT", value_enum)]
    format: Vec<FormatWord>,
}

/// A width and a height from `800x600`.
fn size(text: &str) -> Result<[u32; 2], String> {
    let sides = text
        .split_once(['x', 'X', '×'])
        .and_then(|(width, height)| {
            Some([width.trim().parse().ok()?, height.trim().parse().ok()?])
        });
    let sides = sides.ok_or("expected width and height, such as 800x600")?;
    Picture::check_size(sides).map_err(|refusal| refusal.reason)?;
    Ok(sides)
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
    if options.output.as_deref() == Some(input::DASH) && messages.json {
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
    let format = picture_formats.first().copied();
    let outputs = match plan(&options.scenes, options.output.as_deref(), format) {
        Ok(outputs) => outputs,
        Err(refused) => {
            messages.error(&format!("error: {}", refused.reason));
            return refused.status;
        }
    };
    let threads = options.threads.map_or(0, usize::from);
    let pool = match rayon::ThreadPoolBuilder::new()
        .num_threads(threads)
        .stack_size(STACK)
        .build()
    {
        Ok(pool) => pool,
        Err(error) => {
            messages.error(&format!("error: cannot start {threads} threads: {error}"));
            return Status::Io;
        }
    };
    let reader = read::Options {
        language: languages.first().copied(),
        size: options.size,
        samples: options.samples,
    };
    let statuses: Vec<_> = options
        .scenes
        .iter()
        .zip(&outputs)
        .map(|(scene, output)| one(scene, output, &reader, &pool, messages))
        .collect();
    if statuses.len() > 1 {
        let ok = statuses
            .iter()
            .filter(|status| **status == Status::Done)
            .count();
        messages.note(&format!("{ok} ok, {} failed", statuses.len() - ok));
    }
    statuses.into_iter().fold(Status::Done, Status::worst)
}

/// Stack of a render thread in bytes: room for the longest path of mirrored rays.
const STACK: usize = 16 << 20;

fn one(
    scene: &Path,
    output: &Output,
    options: &read::Options,
    pool: &rayon::ThreadPool,
    messages: &Messages,
) -> Status {
    let start = Instant::now();
    let Reading { scene: read, .. } = match input::read(scene, options, messages) {
        Ok(reading) => reading,
        Err(failure) => {
            if messages.json {
                return report(messages, &failure.json(scene), failure.status);
            }
            return failure.status;
        }
    };
    let title = input::title(scene);
    let bar = progress::bar(&title, u64::from(read.picture.height), messages);
    let rendered = pool.install(|| render(&read, &|rows| bar.set_position(rows as u64)));
    bar.finish_and_clear();
    let (film, counts) = match rendered {
        Ok(rendered) => rendered,
        Err(refusal) => {
            messages.error(&format!("error: {title}: {}", refusal.reason));
            return Status::BadInput;
        }
    };
    let hash = read.hash();
    if let Err(error) = write(&film, &read, &hash, output) {
        let target = output
            .path
            .as_ref()
            .map_or("stdout".into(), |path| path.display().to_string());
        messages.error(&format!("error: cannot write {target}: {error}"));
        return Status::Io;
    }
    let status = non_finite(&film, &title, messages);
    let done = Done {
        scene: &title,
        read: &read,
        counts,
        hash: &hash,
        output,
        start,
        status,
    };
    done.say(messages)
}

/// What there is to say about a finished picture.
#[derive(Debug)]
struct Done<'a> {
    scene: &'a str,
    read: &'a Scene,
    counts: Counts,
    hash: &'a str,
    output: &'a Output,
    start: Instant,
    status: Status,
}

impl Done<'_> {
    fn say(&self, messages: &Messages) -> Status {
        let picture = &self.read.picture;
        let seconds = self.start.elapsed().as_secs_f64();
        let path = self
            .output
            .path
            .as_ref()
            .map(|path| path.display().to_string());
        if messages.json {
            let line = serde_json::json!({
                "scene": self.scene,
                "exit": self.status.code(),
                "output": path,
                "width": picture.width,
                "height": picture.height,
                "samples": picture.samples,
                "rays": self.counts,
                "hash": self.hash,
                "seconds": seconds,
            });
            return report(messages, &format!("{line}\n"), self.status);
        }
        let (width, height) = (picture.width, picture.height);
        let path = path.unwrap_or_else(|| "stdout".to_owned());
        messages.note(&format!(
            "{} -> {path}, {width}x{height}, {seconds:.2} s",
            self.scene
        ));
        if messages.verbose {
            let counts = &self.counts;
            messages.note(&format!(
                "  {} rays: {} from the eye, {} to lights, {} from mirrors, {} through surfaces\n  \
                 {} samples a pixel, scene hash {}",
                counts.rays(),
                counts.camera_rays,
                counts.shadow_rays,
                counts.mirror_rays,
                counts.transmitted_rays,
                picture.samples,
                self.hash,
            ));
        }
        self.status
    }
}

fn report(messages: &Messages, line: &str, status: Status) -> Status {
    match messages.result(line) {
        Ok(()) => status,
        Err(error) => {
            messages.error(&format!("error: cannot write to standard output: {error}"));
            status.worst(Status::Io)
        }
    }
}

fn write(film: &Film, scene: &Scene, hash: &str, output: &Output) -> std::io::Result<()> {
    let settings = scene.picture.describe().to_string();
    let notes = Notes(vec![
        (
            "Software",
            concat!("heliodon ", env!("CARGO_PKG_VERSION")).to_owned(),
        ),
        ("Settings", settings.trim_end().to_owned()),
        ("Scene hash", hash.to_owned()),
    ]);
    let rounding = scene.picture.rounding;
    let format: Format = output.format;
    match &output.path {
        Some(path) => save(path, |out| film.write(out, format, rounding, &notes)),
        None => {
            let mut out = BufWriter::new(std::io::stdout().lock());
            film.write(&mut out, format, rounding, &notes)?;
            out.flush()
        }
    }
}

/// Reports pixels that are no numbers; there should never be one.
fn non_finite(film: &Film, title: &str, messages: &Messages) -> Status {
    const MOST: usize = 10;
    let odd: Vec<_> = film.non_finite().collect();
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
