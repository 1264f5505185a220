//! `render --crop`.

use support::shell::{Shell, size_of};

fn pixels(shell: &Shell, name: &str) -> image::RgbImage {
    image::open(shell.path(name)).expect("a picture").to_rgb8()
}

#[test]
fn a_crop_is_a_part_of_the_picture() {
    let shell = Shell::with_scene();
    shell.run(&["render", "scene.kdl"]).ends_with(0);
    let whole = pixels(&shell, "scene.png");
    let crop = ["render", "scene.kdl", "--crop", "12,7,31,29"];
    shell
        .run(&[&crop[..], &["-o", "part.png"]].concat())
        .ends_with(0)
        .says("19x22");
    assert_eq!(size_of(&shell.path("part.png")), (19, 22));
    let part = pixels(&shell, "part.png");
    for (x, y, pixel) in part.enumerate_pixels() {
        assert_eq!(pixel, whole.get_pixel(x + 12, y + 7), "{x},{y}");
    }
}

#[test]
fn what_is_told_of_a_crop_is_of_its_pixels() {
    let shell = Shell::with_scene();
    let crop = ["render", "scene.kdl", "--crop", "12,7,31,29", "--json"];
    let run = shell
        .run(&[&crop[..], &["--certify"]].concat())
        .ends_with(0);
    let line: serde_json::Value = serde_json::from_str(run.stdout_text()).expect("JSON");
    assert_eq!(line["crop"], serde_json::json!([12, 7, 31, 29]));
    assert_eq!((&line["width"], &line["height"]), (&19.into(), &22.into()));
    assert_eq!(line["rays"]["camera_rays"], 19 * 22);
    assert!(line["certificate"]["picture_hash"].is_string());
    let stats = [&crop[..4], &["--stats"]].concat();
    let run = shell.run(&stats).ends_with(0);
    assert!(run.stdout_text().contains("418"), "{}", run.stdout_text());
}

#[test]
fn a_crop_without_pixels_or_beyond_the_picture_is_refused() {
    let shell = Shell::with_scene();
    for (crop, says) in [
        ("1,2,3", "expected four whole numbers, such as 10,20,30,40"),
        (
            "1,2,3,-4",
            "expected four whole numbers, such as 10,20,30,40",
        ),
        ("5,2,5,4", "the region from 5,2 to 5,4 has no pixels"),
        ("5,4,6,2", "the region from 5,4 to 6,2 has no pixels"),
        (
            "0,0,41,30",
            "the crop 0,0,41,30 reaches beyond the picture of 40 by 30 pixels; give one within \
             0,0,40,30",
        ),
    ] {
        let run = shell.run(&["render", "scene.kdl", "--crop", crop]);
        run.ends_with(2).says(says);
    }
    assert_eq!(shell.files(), ["scene.kdl"]);
}
