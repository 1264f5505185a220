//! `heliodon explain`.

use clap::Args;

use super::error::CommandError;
use super::messages::{Json, Messages, problems_json};
use super::numbers::{separated, whole};
use super::threads::Threads;
use super::{Status, explanation, input, progress, story};
use crate::language::ValueError;
use crate::measure::{self, Prices};
use crate::read::Reading;
use crate::scene::Scene;

/// Explain which parts of a scene are simulated, which are skipped, and why.
///
/// Skipping is proven not to change the picture: `render --simulate-everything` gives the same
/// bytes. Numbers of rays are estimated from some of the pixels; --measure counts them.
#[derive(Debug, Args)]
pub(super) struct Options {
    #[command(flatten)]
    input: input::OneScene,
    /// Explain one pixel instead: column and row, counted from 0 at the top left.
    #[arg(long, value_name = "X,Y", allow_hyphen_values = true, value_parser = pixel, conflicts_with = "measure")]
    pixel: Option<[u32; 2]>,
    /// Count the rays by tracing the whole picture.
    #[arg(long)]
    measure: bool,
    /// Render the scene without each effect that is on; report the time saved and the pixels changed.
    #[arg(long, conflicts_with = "pixel")]
    prices: bool,
    /// Number of times that --prices renders each variant.
    #[arg(long, value_name = "N", default_value = "5", requires = "prices", allow_hyphen_values = true, value_parser = whole(1000))]
    runs: u32,
    #[command(flatten)]
    json: Json,
}

/// A column and a row from `12,34`.
fn pixel(text: &str) -> Result<[u32; 2], String> {
    separated(text, &[',']).ok_or_else(|| "expected a column and a row, such as 400,300".to_owned())
}

pub(super) fn run(options: &Options, messages: &Messages) -> Status {
    let json = options.json.is_asked();
    messages.finish(&options.input.scene, json, result(options, messages))
}

/// The text or the JSON to print, and the status.
fn result(options: &Options, messages: &Messages) -> Result<(String, Status), CommandError> {
    let reading = options.input.read(messages)?;
    let pool = Threads::ALL.pool()?;
    let text = pool.install(|| answer(options, &reading, messages));
    // Only the pixel comes from the command line.
    let status = if options.pixel.is_some() {
        Status::Usage
    } else {
        Status::BadInput
    };
    let title = options.input.title();
    let text = text.map_err(|error| CommandError::value(status, &title, &error))?;
    Ok((text, Status::Done))
}

/// The text or the JSON to print.
fn answer(options: &Options, reading: &Reading, messages: &Messages) -> Result<String, ValueError> {
    let (scene, title) = (&reading.scene, options.input.title());
    let json = options.json.is_asked();
    if let Some(pixel) = options.pixel {
        let story = measure::transcript(scene, pixel)?;
        return Ok(if json {
            line(&title, reading, story.json())
        } else {
            story::text(&story, scene, &title)
        });
    }
    let explanation = measure::explain(scene, options.measure)?;
    let prices = options.prices.then(|| prices(scene, options, messages));
    let prices = prices.transpose()?;
    if json {
        let mut answer = serde_json::json!(explanation);
        if let Some(prices) = prices {
            answer["prices"] = serde_json::json!(prices);
        }
        return Ok(line(&title, reading, answer));
    }
    let mut text = explanation::text(&explanation, &title);
    if let Some(prices) = prices {
        let runs = match prices.runs {
            1 => "one run".to_owned(),
            runs => format!("medians of {runs} runs ± median absolute deviation"),
        };
        text += &format!("\nprices ({runs})\n{prices}");
    }
    Ok(text)
}

/// An answer as one line of JSON, with the members that every answer has.
fn line(title: &str, reading: &Reading, answer: serde_json::Value) -> String {
    let mut line = serde_json::json!({
        "scene": title,
        "exit": Status::Done.code(),
        "problems": problems_json(&reading.warnings, &reading.scene.sources),
    });
    if let (Some(line), serde_json::Value::Object(answer)) = (line.as_object_mut(), answer) {
        line.extend(answer);
    }
    format!("{line}\n")
}

/// The prices of a scene's effects.
fn prices(scene: &Scene, options: &Options, messages: &Messages) -> Result<Prices, ValueError> {
    let bar = progress::bar(&options.input.title(), 0, messages);
    let prices = measure::prices(scene, options.runs, &|done, of| {
        progress::show(&bar, done, of);
    });
    bar.finish_and_clear();
    prices
}
