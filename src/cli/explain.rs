//! `heliodon explain`.

use clap::Args;

use super::input::ReadError;
use super::messages::{Json, Messages, problems_json};
use super::numbers::whole;
use super::threads::Threads;
use super::{Status, explanation, input, progress, story};
use crate::language::ValueError;
use crate::measure::{self, Prices};
use crate::read::Reading;
use crate::scene::Scene;

/// Tells what of a scene is simulated and why, and what is left out.
///
/// What is left out is proven to change nothing: `render --simulate-everything` gives the same
/// bytes. The rays are estimated from some of the pixels; --measure counts them.
#[derive(Debug, Args)]
pub(super) struct Options {
    #[command(flatten)]
    input: input::OneScene,
    /// Tell how one pixel comes by its colour instead: column and row, from 0, from the top left.
    #[arg(long, value_name = "X,Y", allow_hyphen_values = true, value_parser = pixel, conflicts_with = "measure")]
    pixel: Option<[u32; 2]>,
    /// Count the rays by tracing the whole picture.
    #[arg(long)]
    measure: bool,
    /// Draw the scene without each effect that is on, and tell what that saves and changes.
    #[arg(long, conflicts_with = "pixel")]
    prices: bool,
    /// How often to draw everything for the prices.
    #[arg(long, value_name = "N", default_value = "5", requires = "prices", allow_hyphen_values = true, value_parser = whole(1000))]
    runs: u32,
    #[command(flatten)]
    json: Json,
}

/// A column and a row from `12,34`.
fn pixel(text: &str) -> Result<[u32; 2], String> {
    let places = text
        .split_once(',')
        .and_then(|(x, y)| Some([x.trim().parse().ok()?, y.trim().parse().ok()?]));
    places.ok_or_else(|| "expected a column and a row, such as 400,300".to_owned())
}

pub(super) fn run(options: &Options, messages: &Messages) -> Status {
    let failed = |failure: &ReadError| {
        if options.json.is_asked() {
            messages.result(&failure.json(&options.input.scene), failure.status)
        } else {
            failure.status
        }
    };
    let reading = match options.input.read(messages) {
        Ok(reading) => reading,
        Err(failure) => return failed(&failure),
    };
    let pool = match Threads::ALL.pool() {
        Ok(pool) => pool,
        Err(error) => {
            messages.error(&format!("error: {error}"));
            return Status::Io;
        }
    };
    match pool.install(|| answer(options, &reading, messages)) {
        Ok(text) => messages.result(&text, Status::Done),
        Err(error) => {
            let title = options.input.title();
            let error = format!("{title}: {}; {}", error.reason, error.advice);
            let status = if options.pixel.is_some() {
                Status::Usage
            } else {
                Status::BadInput
            };
            failed(&ReadError::new(status, error, messages))
        }
    }
}

/// What is printed, if the scene can be rendered.
fn answer(options: &Options, reading: &Reading, messages: &Messages) -> Result<String, ValueError> {
    let (scene, title) = (&reading.scene, options.input.title());
    let as_json = |value: serde_json::Value| {
        let mut line = serde_json::json!({
            "scene": title,
            "exit": Status::Done.code(),
            "problems": problems_json(&reading.warnings, &scene.sources),
        });
        if let (Some(line), serde_json::Value::Object(value)) = (line.as_object_mut(), value) {
            line.extend(value);
        }
        format!("{line}\n")
    };
    if let Some(pixel) = options.pixel {
        let story = measure::transcript(scene, pixel)?;
        return Ok(if options.json.is_asked() {
            as_json(story.json())
        } else {
            story::text(&story, scene, &title)
        });
    }
    let explanation = measure::explain(scene, options.measure)?;
    let prices = options.prices.then(|| prices(scene, options, messages));
    let prices = prices.transpose()?;
    if options.json.is_asked() {
        let mut answer = serde_json::json!(explanation);
        if let Some(prices) = prices {
            answer["prices"] = serde_json::json!(prices);
        }
        return Ok(as_json(answer));
    }
    let mut text = explanation::text(&explanation, &title);
    if let Some(prices) = prices {
        let runs = match prices.runs {
            1 => "one run".to_owned(),
            runs => format!("medians of {runs} runs, and their median absolute deviation"),
        };
        text += &format!("\nprices, in processor time of one thread: {runs}\n{prices}");
    }
    Ok(text)
}

/// What the effects of a scene cost.
fn prices(scene: &Scene, options: &Options, messages: &Messages) -> Result<Prices, ValueError> {
    let bar = progress::bar(&options.input.title(), 0, messages);
    let prices = measure::prices(scene, options.runs, &|drawn, of| {
        bar.set_length(of as u64);
        bar.set_position(drawn as u64);
    });
    bar.finish_and_clear();
    prices
}
