//! Results of `cost` as a table and as sentences.

use heliodon::measure::{CostOptions, Sweep, Timing, Variation, cost, effects_of};
use heliodon::render::render;

use super::{SCENE, measured, room, scene};

#[test]
fn the_share_of_pixels_that_keep_max_error_is_reported() {
    let mut scene = scene(SCENE);
    let cost = measured(&mut scene, &["max-error=0.05,0.00001", "samples=4"], 2);
    let mut reported = Vec::new();
    for (number, text, max_error) in [(1, "0.05", 0.05), (2, "0.00001", 1e-5)] {
        scene.settings.max_error = max_error;
        let (film, _) = render(&scene, &|_| ()).expect("a picture");
        let pairs = film.pixels().iter().zip(cost.reference.film.pixels());
        let met = pairs.filter(|(pixel, truth)| {
            let channels = pixel.channels().into_iter().zip(truth.channels());
            let errors = channels.map(|(a, b)| (a.clamp(0.0, 1.0) - b.clamp(0.0, 1.0)).abs());
            errors.fold(0.0, f64::max) <= max_error
        });
        let share = met.count() as f64 / f64::from(32 * 24);
        assert!(
            share > 0.5 && (share < 1.0) == (max_error < 0.05),
            "{share}"
        );
        assert_eq!(cost.steps[number].within_max_error, Some(share));
        reported.push(format!("{:.2} % ({text})", 100.0 * share));
    }
    assert_eq!(
        [&cost.steps[0], &cost.steps[3]].map(|step| step.within_max_error),
        [None; 2]
    );
    let words = format!(
        "\nmax-error: kept in {} of the pixels\n",
        reported.join(", ")
    );
    assert!(cost.words().contains(&words), "{words}: {}", cost.words());

    // Steps of other settings keep it, and are not reported.
    scene.settings.max_error = 0.05;
    let cost = measured(&mut scene, &["max-error=0.1", "samples=64"], 2);
    assert!(
        cost.steps
            .iter()
            .all(|step| step.within_max_error.is_some())
    );
    let words = cost.max_error_words().expect("a target");
    let steps: Vec<_> = words.split('(').skip(1).collect();
    assert_eq!(steps.len(), 2, "{words}");
    assert!(
        steps[0].starts_with("0.05)") && steps[1].starts_with("0.1)"),
        "{words}"
    );

    // Where nothing turns it alone, all are.
    scene.settings.max_error = 0.0;
    let grid = ["samples=1,64", "max-error=0.1"];
    let grid = grid.map(|text| Variation::new(text).expect("a variation"));
    let grid = Sweep::grid(scene.settings, &grid).expect("a sweep");
    let options = CostOptions::default();
    let cost = heliodon::measure::cost(&mut scene, &grid, options, &|_, _| ()).expect("a cost");
    let words = cost.max_error_words().expect("a target");
    for label in ["(samples=1 max-error=0.1)", "(samples=64 max-error=0.1)"] {
        assert!(words.contains(label), "{words}");
    }
}

#[test]
fn what_is_tried_keeps_the_words_it_was_given_in() {
    // Each value twice: the first spelling stands for both.
    let variations = ["max-error=2/255, 0.00784313725490196", "cut-off=1 / 255"];
    let cost = measured(&mut scene(SCENE), &variations, 1);
    let labels = cost.steps.iter().map(|step| step.label.as_str());
    assert!(labels.eq(["as it is", "max-error=2/255", "cut-off=1/255"]));
    for (step, setting, text, value) in [
        (0, "max-error", "0", 0.0),
        (1, "max-error", "2/255", 2.0 / 255.0),
        (2, "cut-off", "1/255", 1.0 / 255.0),
    ] {
        let own = cost.steps[step].own(setting).expect("a step");
        assert_eq!((own.text.as_str(), own.value), (text, Some(value)));
    }
    let words = cost.words();
    for sentence in ["\nmax-error=2/255: ", " % (2/255) of the pixels\n"] {
        assert!(words.contains(sentence), "{sentence}: {words}");
    }
}

#[test]
fn without_errors_no_error_is_drawn() {
    let black = "image 32 24; camera { viewpoint 0 1 4; look-at 0 1 0 }";
    let cost = measured(&mut scene(black), &["samples=2,4"], 1);
    assert!(cost.steps.iter().all(|step| step.deviation.rmse == 0.0));
    // All letters are in the lowest row, which alone has a number.
    let text = cost.to_string();
    let (_, chart) = text.split_once("  RMSE (1 = white)\n").expect("a chart");
    let (rows, _) = chart.split_once('└').expect("its end");
    let rows: Vec<_> = rows.lines().filter(|row| row.contains('│')).collect();
    let (lowest, others) = rows.split_last().expect("rows");
    assert!(others.iter().all(|row| row.trim() == "│"), "{chart}");
    assert!(lowest.trim_start().starts_with("0 │"), "{chart}");
    assert!(lowest.contains(|it: char| it.is_ascii_lowercase()));
    let plot = cost.plot();
    let marks = plot.matches("class=\"mark\" text-anchor=\"end\"").count();
    assert_eq!(marks, 1, "{plot}");
    assert!(!plot.contains("class=\"noise\""), "{plot}");
}

#[test]
fn the_table_is_in_columns_and_has_the_letter_of_what_is_better() {
    let mut cost = measured(&mut scene(SCENE), &["samples=4,64"], 1);
    let better = [Some("samples=64"), None, Some("samples=4")];
    for (step, better) in cost.steps.iter_mut().zip(better) {
        step.dominated_by = better.map(str::to_owned);
    }
    let rows = cost.rows();
    let rows: Vec<Vec<char>> = rows.lines().map(|row| row.chars().collect()).collect();
    let text = rows[0].iter().collect::<String>();
    let place = text.find("better").expect("a column");
    // The first two rows are heads.
    for (row, expected) in rows[2..].iter().zip(["c", "none", "b"]) {
        let text: String = row[place - 2..].iter().collect();
        assert_eq!(text, format!("  {expected}"));
        assert!(row[place - 3].is_ascii_digit(), "FLIP: {row:?}");
    }
}

#[test]
fn the_table_fits_into_eighty_columns() {
    let grid = [
        "samples=1,4,6,9",
        "texture-filter=nearest,bilinear,anisotropic,exact",
        "cut-off=1,0.016",
        "numerics=classic-f32,robust",
    ];
    let grid = grid.map(|text| Variation::new(text).expect("a variation"));
    let mut room = room();
    room.settings.width = 20;
    room.settings.height = 15;
    let effects = effects_of(&room).expect("a possible camera");
    let each = Sweep::of(room.settings, &effects);
    let all = Sweep::grid(room.settings, &grid).expect("a sweep");
    for (sweep, lines) in [(each, 1), (all, 2)] {
        let options = CostOptions {
            runs: 2,
            ..CostOptions::default()
        };
        let cost = cost(&mut room, &sweep, options, &|_, _| ()).expect("a cost");
        let rows = cost.rows();
        let rows: Vec<_> = rows.lines().collect();
        assert_eq!(rows.len(), 2 + 1 + lines * (sweep.0.len() - 1), "{rows:#?}");
        for row in &rows {
            assert!(row.chars().count() <= 80 && row.trim_end() == *row, "{row}");
        }
        // Each label is whole, and each step has a name of its own.
        let named = rows
            .iter()
            .filter(|row| row.contains('=') || row.contains("as it is"));
        let mut names: Vec<_> = named.filter_map(|row| row.split(' ').next()).collect();
        for step in &sweep.0 {
            assert!(
                rows.iter().any(|row| row.contains(&step.label)),
                "{rows:#?}"
            );
        }
        names.sort_unstable();
        names.dedup();
        assert_eq!(names.len(), sweep.0.len(), "{names:?}");
    }
}

#[test]
fn no_time_is_shown_as_zero() {
    let mut cost = measured(&mut scene(SCENE), &["samples=4"], 1);
    let shown = ["12.3", "24.7"];
    for (seconds, unit, on_page) in [
        (0.000_012_34, "µs", "0.0123 ± 0.0002 ms"),
        (0.012_34, "ms", "12.3 ± 0.2 ms"),
        (12.34, "s", "12340 ± 247 ms"),
    ] {
        for (step, factor) in cost.steps.iter_mut().zip([1.0, 2.0]) {
            step.cpu = Timing {
                median: factor * seconds,
                deviation: Some(0.02 * seconds),
            };
            step.wall = step.cpu;
        }
        let rows = cost.rows();
        let words: Vec<Vec<_>> = rows
            .lines()
            .map(|row| row.split_whitespace().collect())
            .collect();
        assert_eq!(words[1][..2], [unit; 2], "{rows}");
        assert_eq!(words[2][4..6], [shown[0]; 2], "{rows}");
        assert_eq!(words[3][2..4], [shown[1]; 2], "{rows}");
        let page = cost.page("it", &[]).expect("a page");
        assert!(
            page.contains(&format!("<td>{on_page}</td>")),
            "{on_page} in\n{page}"
        );
    }
}

#[test]
fn a_step_of_a_setting_has_the_value_of_that_setting() {
    for (rounding, others) in [("round", "truncate"), ("truncate", "round")] {
        let image = format!("image 32 24 quantize=\"{rounding}\"");
        let mut scene = scene(&SCENE.replace("image 32 24", &image));
        let effects = effects_of(&scene).expect("a possible camera");
        let sweep = Sweep::of(scene.settings, &effects);
        let cost = cost(&mut scene, &sweep, CostOptions::default(), &|_, _| ()).expect("a cost");
        let words = cost.words();
        for expected in [
            "\npattern: own error ",
            " (stratified), ",
            &format!(" ({rounding}), "),
            &format!(" ({others})\n"),
            "\nnumerics: own error 0 in ",
            "\npattern=random: ",
            "\nquantize=truncate: ",
        ] {
            assert!(words.contains(expected), "{expected:?} in\n{words}");
        }
        for line in words.lines().filter(|line| line.contains(": own error ")) {
            assert!(!line.contains("as it is") && !line.contains('='), "{line}");
        }
        let plot = cost.plot();
        let both = "samples=16\nalso pattern=stratified\n";
        assert!(plot.contains(both), "{plot}");
    }
}
