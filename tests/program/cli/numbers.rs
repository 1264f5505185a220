//! Numbers that make no sense are told from options, and what is expected instead is said.

use support::shell::Shell;

/// What is no number for any option.
const NONSENSE: [&str; 12] = [
    "", " ", "x", "-", "-1", "-0.5", "nan", "-nan", "inf", "-inf", "1e999", "--quiet",
];

#[test]
fn every_option_tells_which_numbers_it_takes() {
    let shell = Shell::with_scene();
    for (command, option, before, expected) in [
        ("render", "--size", "", "width and height from 1 to 32768"),
        ("render", "--samples", "", "a whole number from 1 to 65536"),
        ("render", "--max-error", "", "a fraction such as 2/255"),
        ("render", "--cut-off", "", "a number from 0 to 1"),
        ("render", "--threads", "", "a whole number from 1 to 1024"),
        ("render", "--crop", "", "four whole numbers, such as"),
        ("render", "--crop", "1,2,", "four whole numbers, such as"),
        ("cost", "--samples", "", "a whole number from 1 to 65536"),
        ("cost", "--runs", "", "a whole number from 1 to 1000"),
        ("cost", "--threads", "", "a whole number from 1 to 1024"),
        ("cost", "--budget", "", "a time above zero, such as 2s"),
        ("cost", "--target", "", "such as rmse=1e-3"),
        ("cost", "--target", "rmse=", "a number from 0 to 1 after"),
        ("cost", "--target", "max=", "a number from 0 to 255 after"),
        ("cost", "--target", "psnr=", "a number of 0 or more after"),
        (
            "cost",
            "--vary",
            "samples=",
            "a whole number from 1 to 65536",
        ),
        ("cost", "--vary", "max-error=", "a fraction such as 2/255"),
        ("explain", "--pixel", "", "a column and a row, such as"),
        ("explain", "--pixel", "3,", "a column and a row, such as"),
        ("explain", "--runs", "", "a whole number from 1 to 1000"),
    ] {
        for nonsense in NONSENSE {
            let value = format!("{before}{nonsense}");
            let run = shell.run(&[command, "scene.kdl", option, &value]);
            run.ends_with(2).says(expected).says(option);
        }
    }
}

#[test]
fn what_is_too_large_is_told_the_same() {
    let shell = Shell::with_scene();
    let huge = "99999999999999999999999";
    for (command, option, value, expected) in [
        ("render", "--size", "4x99999999999", "from 1 to 32768"),
        ("render", "--size", "32769x4", "from 1 to 32768"),
        (
            "render",
            "--size",
            "32768x32768",
            "at most 134 million pixels",
        ),
        ("render", "--samples", huge, "from 1 to 65536"),
        ("render", "--cut-off", huge, "from 0 to 1"),
        ("render", "--max-error", "1.5", "from 0 to 1"),
        ("render", "--threads", "1025", "from 1 to 1024"),
        ("render", "--threads", huge, "from 1 to 1024"),
        (
            "render",
            "--crop",
            "0,0,99999999999,1",
            "four whole numbers",
        ),
        ("cost", "--runs", "1001", "from 1 to 1000"),
        ("explain", "--pixel", "0,99999999999", "a column and a row"),
    ] {
        let run = shell.run(&[command, "scene.kdl", option, value]);
        run.ends_with(2).says(expected).says(option);
    }
}

#[test]
fn what_options_make_senseless_is_no_mistake_of_the_scene() {
    let shell = Shell::with_scene();
    for (options, reason) in [
        (
            ["--samples", "4", "--pattern", "center"],
            "scene.kdl: 4 rays through the centre of a pixel are the same ray",
        ),
        (
            ["--max-error", "0.1", "--pattern", "grid"],
            "`max-error` adds rays to a pixel, which the pattern \"grid\" cannot do",
        ),
    ] {
        for command in ["render", "cost"] {
            let run = shell.run(&[&[command, "scene.kdl"], &options[..]].concat());
            run.ends_with(2).says(reason).says("; set `");
        }
    }
}
