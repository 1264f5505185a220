//! The command `heliodon cost`.

use std::process::{Command, Output};

use support::shell::program;

use super::SCENE;

/// Runs the command on the scene of all these tests in a folder of its own.
fn run(folder: &tempfile::TempDir, arguments: &[&str]) -> Output {
    std::fs::write(folder.path().join("scene.kdl"), SCENE).expect("a file");
    let mut command = Command::new(program());
    command.current_dir(folder.path());
    command.args(["cost", "scene.kdl", "--runs", "1"]);
    command.args(arguments).output().expect("heliodon runs")
}

#[test]
fn exit_codes_answer() {
    let folder = tempfile::tempdir().expect("a folder");
    let code = |arguments: &[&str]| {
        let arguments = [&["--vary", "samples=2"], arguments].concat();
        run(&folder, &arguments).status.code()
    };
    assert_eq!(code(&["--target", "max=255"]), Some(0));
    assert_eq!(code(&["--target", "max=0"]), Some(1));
    assert_eq!(code(&["--target", "flip=1"]), Some(0));
    assert_eq!(code(&["--target", "flip=0"]), Some(1));
    assert_eq!(code(&["--budget", "1h"]), Some(2));
    assert_eq!(code(&["--budget", "500s"]), Some(0));
    assert_eq!(code(&["--reference", "none.png"]), Some(4));
    assert_eq!(code(&["--csv", "scene.kdl"]), Some(2));
    assert_eq!(code(&["--csv", "a", "--plot", "a"]), Some(2));
    assert_eq!(code(&["--csv", "a", "--plot", "./a"]), Some(2));
    assert_eq!(code(&["--csv", "-"]), Some(2), "the table is there");
    assert_eq!(code(&["--report", "."]), Some(4));
    assert_eq!(code(&["--vary", "transfer=srgb"]), Some(2));
    assert_eq!(code(&["--csv", "no/such.csv"]), Some(4));
    // Refused before anything is drawn, and so before there is anything to print.
    let long = "a".repeat(300);
    let output = run(&folder, &["--vary", "samples=2", "--report", &long]);
    let said = String::from_utf8(output.stderr).expect("text");
    assert!(said.ends_with("its name is too long\n"), "{said}");
    assert_eq!(output.status.code(), Some(4));
    assert_eq!(run(&folder, &["--grid"]).status.code(), Some(2));
}

#[test]
fn what_cannot_be_varied_is_refused() {
    let folder = tempfile::tempdir().expect("a folder");
    for (arguments, expected) in [
        (["--vary", "sampels=2"], "did you mean \"samples\"?"),
        (
            ["--vary", "samples=0"],
            "\"0\" is not a valid value of samples: expected a whole number",
        ),
        (["--vary", "samples"], "such as samples=1,4,16"),
        (
            ["--target", "error=1"],
            "expected one of rmse, max, off, psnr, ssim, flip",
        ),
    ] {
        let output = run(&folder, &arguments);
        let said = String::from_utf8_lossy(&output.stderr);
        assert_eq!(output.status.code(), Some(2), "{said}");
        assert!(said.contains(expected), "{said}");
    }
}

#[test]
fn json_csv_plot_and_page_have_every_step() {
    let folder = tempfile::tempdir().expect("a folder");
    let read = |name: &str| std::fs::read_to_string(folder.path().join(name)).expect("a file");
    let output = run(
        &folder,
        &[
            "--vary",
            "samples=1,4",
            "--vary",
            "numerics=classic",
            "--target",
            "max=255",
            "--json",
            "--csv",
            "it.csv",
            "--plot",
            "it.svg",
            "--report",
            "it.html",
        ],
    );
    let answer: serde_json::Value = serde_json::from_slice(&output.stdout).expect("JSON");
    assert_eq!((&answer["exit"], &answer["runs"]), (&0.into(), &1.into()));
    assert_eq!(answer["scene"], "scene.kdl");
    assert_eq!(answer["size"], serde_json::json!([32, 24]));
    let steps = answer["steps"].as_array().expect("steps");
    let labels: Vec<_> = steps.iter().map(|step| &step["label"]).collect();
    assert_eq!(labels, ["as it is", "samples=4", "numerics=classic"]);
    for field in [
        "cpu", "wall", "rays", "counts", "largest", "pixels", "rmse", "psnr", "ssim", "flip",
    ] {
        assert!(!steps[0][field].is_null(), "{field}: {}", steps[0]);
    }
    assert!(answer["target"]["label"].is_string());
    assert!(answer["budget"].is_null());
    assert!(answer["reference"]["uncertainty"]["rmse"].is_number());
    for field in ["laws", "breakdowns", "recommended"] {
        assert!(!answer[field].is_null(), "{field}");
    }
    assert_eq!(answer["rungs"], answer["steps"], "a former name");
    assert_eq!(answer["rungs"][1]["dial"], "samples");
    assert_eq!(answer["rungs"][1]["own"][0]["step"], "4");
    assert_eq!(
        answer["blames"][0]["rung"],
        answer["breakdowns"][0]["label"]
    );
    assert!(answer["blames"][0]["spots"][0]["spot"].is_string());
    assert_eq!(
        answer["reference"]["doubt"],
        answer["reference"]["uncertainty"]
    );

    let validator = schema();
    let errors: Vec<_> = validator.iter_errors(&answer).collect();
    assert!(errors.is_empty(), "{errors:?}");
    let unmet = [
        "--vary", "depth=8", "--target", "max=0", "--budget", "1e-9s", "--json",
    ];
    let unmet = run(&folder, &unmet);
    let unmet: serde_json::Value = serde_json::from_slice(&unmet.stdout).expect("JSON");
    let errors: Vec<_> = validator.iter_errors(&unmet).collect();
    assert!(errors.is_empty(), "{errors:?}");
    for asked in ["target", "budget"] {
        assert!(unmet[asked]["label"].is_null() && unmet[asked]["why"].is_string());
    }
    assert_eq!(unmet["exit"], 1);
    let mut wrong = answer.clone();
    wrong["steps"][0]["rays"] = serde_json::Value::Null;
    assert!(!validator.is_valid(&wrong));

    assert!(
        steps.iter().all(|step| step["within_max_error"].is_null()),
        "{steps:?}"
    );

    let csv = read("it.csv");
    assert!(
        csv.starts_with("rung,dial,value,runs,cpu,cpu_mad,wall,wall_mad,rays,"),
        "{csv}"
    );
    assert_eq!(csv.lines().count(), 4);
    assert!(csv.contains(",psnr,ssim,flip,efficiency,"), "{csv}");
    assert!(csv.contains("\nsamples=4,samples,4,1,"), "{csv}");

    let plot = read("it.svg");
    assert!(plot.starts_with("<svg xmlns="), "{plot}");
    assert_eq!(plot.matches("class=\"step\"").count(), 3);

    let page = read("it.html");
    assert!(!page.contains("http"), "the page needs nothing else");
    assert!(!page.contains("{{"), "a part was not filled in");
    assert!(
        page.matches("data:image/png;base64,").count() >= 5,
        "each picture is there"
    );
    assert_eq!(page.matches("<tr class").count(), 3);
    assert!(page.contains("<th>FLIP</th>"), "{page}");
    for step in steps {
        let flip = step["flip"].as_f64().expect("a number");
        // As hovering over the plots tells, and in the table.
        assert!(page.matches(&format!("\nFLIP {flip:.4}\n")).count() >= 2);
        assert!(page.contains(&format!("<td>{flip:.4}</td>")));
    }
    let said = String::from_utf8(output.stderr).expect("text");
    let files = ["it.csv", "it.svg", "it.html"];
    let expected = files.map(|file| format!("scene.kdl -> {file}\n"));
    assert_eq!(said, expected.concat());
}

/// The schema of what `--json` prints.
fn schema() -> jsonschema::Validator {
    let schema = std::fs::read_to_string("docs/cost.schema.json").expect("the schema");
    let schema = serde_json::from_str(&schema).expect("JSON");
    jsonschema::validator_for(&schema).expect("a schema")
}

#[test]
fn what_fails_is_in_the_schema_too() {
    let folder = tempfile::tempdir().expect("a folder");
    std::fs::write(folder.path().join("wrong.kdl"), "image 0 0\n").expect("a file");
    for (arguments, exit) in [
        (["scene.kdl", "--samples", "1", "--csv", "-"], 2),
        (["wrong.kdl", "--samples", "1", "--runs", "1"], 3),
        (["none.kdl", "--samples", "1", "--runs", "1"], 4),
        (["scene.kdl", "--reference", "none.png", "--runs", "1"], 4),
    ] {
        std::fs::write(folder.path().join("scene.kdl"), SCENE).expect("a file");
        let mut command = Command::new(program());
        command.current_dir(folder.path()).args(["cost", "--json"]);
        let output = command.args(arguments).output().expect("heliodon runs");
        let answer: serde_json::Value = serde_json::from_slice(&output.stdout).expect("JSON");
        assert_eq!(answer["exit"], exit, "{answer}");
        let validator = schema();
        let errors: Vec<_> = validator.iter_errors(&answer).collect();
        assert!(errors.is_empty(), "{answer}: {errors:?}");
        // What has failed has no other status, and says why.
        for (field, wrong) in [("exit", 0.into()), ("error", serde_json::Value::from(1))] {
            let mut answer = answer.clone();
            answer[field] = wrong;
            assert!(!validator.is_valid(&answer), "{answer}");
        }
    }
}

#[test]
fn the_page_answers_what_the_terminal_does() {
    let folder = tempfile::tempdir().expect("a folder");
    let arguments = [
        "--vary",
        "max-error=0.1,0.05",
        "--target",
        "max=0",
        "--budget",
        "500s",
        "--report",
        "it.html",
    ];
    let output = run(&folder, &arguments);
    assert_eq!(output.status.code(), Some(1));
    let text = String::from_utf8(output.stdout).expect("text");
    let page = std::fs::read_to_string(folder.path().join("it.html")).expect("a page");
    let (_, advice) = page.split_once("<dl class=\"advice\">\n").expect("a list");
    let (advice, _) = advice.split_once("</dl>").expect("its end");
    // What a reader sees: the text between tags, in which numbers and units stay in one line.
    let texts = advice
        .split('<')
        .filter_map(|part| Some(part.split_once('>')?.1));
    let seen = texts.collect::<String>().replace('\u{a0}', " ");
    for word in ["recommended", "target", "budget"] {
        let said = text
            .lines()
            .find(|line| line.starts_with(&format!("{word}: ")));
        let (_, answer) = said.expect(word).split_once(": ").expect("a sentence");
        let (label, why) = answer.split_once("; ").expect("a reason");
        assert!(seen.contains(&format!("{word}{label} {why}\n")), "{seen}");
    }
    assert!(advice.contains("<dt>target</dt><dd><strong class=\"none\">none</strong>"));
    assert!(advice.contains("<dt>budget</dt><dd><strong data-step=\""));
}

#[test]
fn a_table_a_plot_and_words_on_the_terminal() {
    let folder = tempfile::tempdir().expect("a folder");
    let output = run(&folder, &["--vary", "samples=4", "--target", "max=0"]);
    let text = String::from_utf8(output.stdout).expect("text");
    for words in [
        "scene.kdl, 32x24, one run on",
        "  RMSE    FLIP  better\n",
        "\na as it is ",
        "\nb samples=4 ",
        "  RMSE (1 = white)\n",
        "\nrecommended: ",
        "\nsamples: ",
        "\ntarget: none; no setting has largest error in code values ≤ 0\n",
    ] {
        assert!(text.contains(words), "{words:?} in\n{text}");
    }
}
