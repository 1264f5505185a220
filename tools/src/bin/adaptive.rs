//! How often `max-error` is met, and what it costs beside equally many rays through every pixel.
//!
//! ```sh
//! cargo run --release --bin adaptive -- --size 80x60 scenes/room.kdl
//! ```
//!
//! For each scene it prints how many rays from the eye go through a pixel, the share of pixels whose error
//! against 4096 stratified rays is within the limit, and the processor's time; then the same for
//! uniform counts of rays in the pattern `sobol`: powers of two up to the first that meets the limit in
//! as many pixels as is asked for, and then eighths of that, of which the last one printed is the
//! cheapest that is enough.

use std::path::{Path, PathBuf};
use std::process::ExitCode;

use clap::Parser;
use cpu_time::ProcessTime;
use heliodon::film::{Film, Format, Notes, Rounding, Transfer, save};
use heliodon::read::{Options, read_file};
use heliodon::render::{Counts, Render, STACK};
use heliodon::scene::{Scene, Setting};

/// Compares adaptive with uniform sampling.
#[derive(Debug, Parser)]
struct Arguments {
    /// Scenes in KDL.
    #[arg(required = true)]
    scenes: Vec<PathBuf>,
    /// The picture's width and height.
    #[arg(long, default_value = "80x60", value_parser = size)]
    size: [u32; 2],
    /// The error that is aimed at.
    #[arg(long, default_value = "2/255")]
    max_error: String,
    /// The share of pixels that should meet it.
    #[arg(long, default_value_t = 0.995)]
    share: f64,
    /// The rays through each pixel of the reference.
    #[arg(long, default_value = "4096")]
    reference: String,
    /// The most rays through each pixel that are tried uniformly.
    #[arg(long, default_value_t = 2048)]
    most: u32,
    /// A folder in which references are kept for the next time, by scene, size and rays.
    #[arg(long)]
    keep: Option<PathBuf>,
}

fn size(text: &str) -> Result<[u32; 2], String> {
    let sides = text
        .split_once('x')
        .ok_or("expected a size such as 80x60")?;
    let side = |text: &str| {
        text.parse()
            .map_err(|_| "expected whole numbers".to_owned())
    };
    Ok([side(sides.0)?, side(sides.1)?])
}

fn main() -> ExitCode {
    let arguments = Arguments::parse();
    let pool = rayon::ThreadPoolBuilder::new().num_threads(1);
    let pool = pool.stack_size(STACK).build().expect("a thread");
    let mut met = true;
    for scene in &arguments.scenes {
        met &= pool.install(|| compare(scene, &arguments));
    }
    if met {
        ExitCode::SUCCESS
    } else {
        ExitCode::FAILURE
    }
}

/// Whether a scene meets the limit in as many pixels as it should.
fn compare(path: &Path, arguments: &Arguments) -> bool {
    let drawn = |settings: &[(&str, &str)]| draw(&read(path, arguments.size, settings));
    let reference = reference(path, arguments);
    let transfer = read(path, arguments.size, &[]).settings.transfer;
    let limit = Setting::new("max-error", &arguments.max_error).expect("a limit");
    let limit = limit.value().number();
    println!("{}", path.display());
    let row = |name: &str, settings: &[(&str, &str)]| {
        let (film, counts, seconds) = drawn(settings);
        let share = share_within(&film, &reference, transfer, limit);
        let pixels = (film.width() * film.height()) as f64;
        let rays = counts.camera_rays as f64 / pixels;
        println!(
            "  {name:<10} {rays:9.2} rays a pixel  {:8.3} %  {seconds:8.3} s",
            100.0 * share
        );
        share
    };
    let samples = ("samples", "1");
    let adaptive = row("max-error", &[("max-error", &arguments.max_error), samples]);
    let uniform = |count: u32| {
        let count = count.to_string();
        let uniform = [
            ("samples", &*count),
            ("pattern", "sobol"),
            ("max-error", "0"),
        ];
        row("uniform", &uniform) >= arguments.share
    };
    // The first power of two that is enough, and then what is less by eighths.
    let mut powers = (2..=arguments.most.ilog2()).map(|power| 1 << power);
    if let Some(enough) = powers.find(|count| uniform(*count)) {
        let mut less = (5..8).map(|eighths| enough / 8 * eighths);
        less.find(|count| *count > 0 && uniform(*count));
    }
    adaptive >= arguments.share
}

/// The picture that others are compared with: as it was kept, or drawn anew.
fn reference(path: &Path, arguments: &Arguments) -> Film {
    let count = &*arguments.reference;
    let kept = arguments.keep.as_ref().map(|folder| {
        let name = path.file_stem().unwrap_or_default().to_string_lossy();
        let [width, height] = arguments.size;
        folder.join(format!("{name}-{width}x{height}-{count}.pfm"))
    });
    if let Some(kept) = kept.as_ref().filter(|file| file.exists()) {
        return Film::read(kept, Transfer::None).expect("a picture");
    }
    let settings = [("samples", count), ("max-error", "0")];
    let (film, ..) = draw(&read(path, arguments.size, &settings));
    if let Some(kept) = kept {
        save(&kept, |out| {
            film.write(out, Format::Pfm, Rounding::default(), &Notes::default())
        })
        .expect("a place for the reference");
    }
    film
}

fn read(path: &Path, size: [u32; 2], settings: &[(&str, &str)]) -> Scene {
    let settings = settings.iter().map(|(word, text)| Setting::new(word, text));
    let options = Options {
        size: Some(size),
        settings: settings.collect::<Result<_, _>>().expect("settings"),
        ..Options::default()
    };
    let reading = read_file(path, &options).expect("a file");
    reading.expect("a scene without mistakes").scene
}

/// The picture, the work, and the seconds that the processor took.
fn draw(scene: &Scene) -> (Film, Counts, f64) {
    let start = ProcessTime::now();
    let drawn = Render::new(scene).film().expect("a possible camera");
    (drawn.0, drawn.1, start.elapsed().as_secs_f64())
}

/// The share of pixels of which no channel is further off than this, as a picture shows it.
fn share_within(film: &Film, reference: &Film, transfer: Transfer, limit: f64) -> f64 {
    let shown = |channel: f64| transfer.value(channel.clamp(0.0, 1.0));
    let pairs = film.pixels().iter().zip(reference.pixels());
    let met = pairs.filter(|(pixel, truth)| {
        let channels = pixel.channels().into_iter().zip(truth.channels());
        channels
            .map(|(a, b)| (shown(a) - shown(b)).abs())
            .all(|error| error <= limit)
    });
    met.count() as f64 / film.pixels().len() as f64
}
