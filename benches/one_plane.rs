//! What everything that a scene does not call for costs: a scene of one plane and no light, beside a
//! loop written for that scene alone.
//!
//! `cargo bench --bench one_plane [-- PAIRS]` renders both in turn on the same thread and prints the
//! median CPU times, which other programs disturb less, and the median of their ratios. The pictures
//! are the same to a rounding.

use std::error::Error;
use std::path::PathBuf;

use cpu_time::ProcessTime;
use glam::DVec3;
use heliodon::film::Film;
use heliodon::math::Rgb;
use heliodon::read::{Options, read_bytes};
use heliodon::render::render;
use heliodon::scene::Scene;

const PAIRS: usize = 21;
const WIDTH: usize = 1600;
const HEIGHT: usize = 1200;

/// A floor seen through the chapter's screen.
const SCENE: &str = r#"
    image 1600 1200
    camera { viewpoint 4 3 8; screen 8 6 }
    material "chalk" { ambient 2 3 4 }
    plane "floor" { material "chalk"; point 0 -1 0; normal 0 1 0 }
"#;

fn main() -> Result<(), Box<dyn Error>> {
    let named = std::env::args().find_map(|argument| argument.parse().ok());
    let scene = read_bytes("floor", SCENE.into(), PathBuf::new(), &Options::default());
    let scene = scene.map_err(|no| format!("{:?}", no.diagnostics))?.scene;
    let pool = rayon::ThreadPoolBuilder::new().num_threads(1).build()?;
    let mut times = Vec::new();
    for _ in 0..named.unwrap_or(PAIRS) {
        let (ours, film) = timed(|| pool.install(|| rendered(&scene)));
        let (loops, other) = timed(|| pool.install(by_hand));
        let pairs = film.pixels().iter().zip(other.pixels());
        let apart = pairs.map(|(a, b)| (a.r - b.r).abs()).fold(0.0, f64::max);
        assert!(apart < 1e-12, "the pictures differ by {apart}");
        times.push((ours, loops));
    }
    println!("one plane, no light, {WIDTH}x{HEIGHT}, one thread, CPU time");
    println!(
        "heliodon      {:.1} ms",
        1e3 * median(&times, |pair| pair.0)
    );
    println!(
        "loop by hand  {:.1} ms",
        1e3 * median(&times, |pair| pair.1)
    );
    println!(
        "ratio         {:.3}",
        median(&times, |pair| pair.0 / pair.1)
    );
    Ok(())
}

fn rendered(scene: &Scene) -> Film {
    let (film, counts) = render(scene, &|_| ()).expect("a possible camera");
    assert_eq!(counts.rays(), counts.camera_rays);
    film
}

/// The same picture by a loop that knows nothing but this scene.
fn by_hand() -> Film {
    let mut film = Film::new(WIDTH, HEIGHT).expect("memory");
    let eye = DVec3::new(4.0, 3.0, 8.0);
    let steps = [8.0 / (WIDTH - 1) as f64, 6.0 / (HEIGHT - 1) as f64];
    let color = Rgb::new(2.0, 3.0, 4.0);
    for (row, pixels) in film.pixels_mut().chunks_mut(WIDTH).enumerate() {
        let y = (HEIGHT - 1 - row) as f64 * steps[1];
        for (column, pixel) in pixels.iter_mut().enumerate() {
            let way = DVec3::new(column as f64 * steps[0], y, 0.0) - eye;
            let dir = way / way.length();
            // Behind the screen, where z is below 0.
            let t = -(eye.y + 1.0) / dir.y;
            if t > 0.0 && t >= -eye.z / dir.z {
                *pixel = color / t;
            }
        }
    }
    film
}

fn timed(draw: impl FnOnce() -> Film) -> (f64, Film) {
    let start = ProcessTime::now();
    let film = draw();
    (start.elapsed().as_secs_f64(), film)
}

fn median(times: &[(f64, f64)], of: impl Fn(&(f64, f64)) -> f64) -> f64 {
    let mut values: Vec<_> = times.iter().map(of).collect();
    values.sort_by(f64::total_cmp);
    values[values.len() / 2]
}
