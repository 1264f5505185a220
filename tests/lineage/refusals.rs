//! What cannot be drawn is refused, never guessed. The exact words are kept elsewhere.

use super::tools::{Stage, assert_color};

fn refused(text: &str) -> String {
    Stage::eye(text).image("white", &["W"]).error()
}

/// G10: an xdir that is zero or along the normal is refused.
#[test]
fn an_xdir_without_a_direction_in_the_plane() {
    let plane = |xdir: &str| {
        let text = format!(
            r#"finite-plane {{
                material "red"; point 0 0 0; normal 1 2 3; xdir {xdir}; dimensions 1 1
            }}"#
        );
        refused(&text)
    };
    assert_eq!(plane("0 0 0"), "xdir is zero");
    assert_eq!(plane("2 4 6"), "xdir is parallel to the normal");
    assert_eq!(plane("-1 -2 -3"), "xdir is parallel to the normal");
}

/// G11: a width or height that is not above zero is refused.
#[test]
fn dimensions_that_are_not_above_zero() {
    for dimensions in ["0 1", "1 0", "-1 1", "1 -0.0", "0 0"] {
        let text = format!(
            r#"finite-plane {{
                material "red"; point 0 0 0; normal 0 0 1; xdir 1 0 0; dimensions {dimensions}
            }}"#
        );
        let message = refused(&text);
        assert!(message.contains("`dimensions`"), "{dimensions}: {message}");
    }
}

/// R15, G5: there are two modes; any other word is refused.
#[test]
fn an_unknown_mode() {
    let text = r#"
        texture "white" "white.ppm"
        texture-plane {
            material "white"; point 0 0 0; normal 0 0 1; xdir 1 0 0; dimensions 1 1
            texture "white" mode="mirror"
        }"#;
    let message = refused(text);
    assert!(
        message.contains("`mode`") && message.contains("mirror"),
        "{message}"
    );
}

fn poster(file: &[u8]) -> Stage {
    Stage::eye(
        r#"lighting { view-falloff "none" }
        texture "poster" "poster.ppm"
        texture-plane {
            material "white"; point 0 0 0; normal 0 0 1; xdir 1 0 0; dimensions 1 1
            texture "poster"
        }"#,
    )
    .file("poster.ppm", file)
}

/// G12, R34: the sample textures' comment lines are read over, and so is any white space.
#[test]
fn comments_in_a_pixmap_are_accepted() {
    let creator = b"P6\n# CREATOR: XV Version 3.10\n1 1\n# another\n255\n\xff\x66\x00";
    assert_color(poster(creator).pixel(), [1.0, 0.4, 0.0]);
    assert_color(
        poster(b"P6 1\t1\n255\n\xff\x66\x00").pixel(),
        [1.0, 0.4, 0.0],
    );
}

/// G12: a largest value other than 255 scales the channels.
#[test]
fn other_largest_values_scale_the_channels() {
    assert_color(poster(b"P6 1 1 1 \x01\x00\x01").pixel(), [1.0, 0.0, 1.0]);
    let deep = poster(b"P6 1 1 65535 \xff\xff\x00\x00\x33\x33").pixel();
    assert_color(deep, [1.0, 0.0, 0.2]);
}

/// G12: a missing, short, empty or foreign file is an error that names the file.
#[test]
fn bad_image_files() {
    let missing = r#"
        texture "gone" "gone.ppm"
        texture-plane {
            material "white"; point 0 0 0; normal 0 0 1; xdir 1 0 0; dimensions 1 1
            texture "gone"
        }"#;
    let message = refused(missing);
    assert!(message.contains("gone.ppm"), "{message}");
    let files: [&[u8]; 5] = [
        b"P6 2 2 255\n\xff\xff",
        b"",
        b"P9 1 1 255\n\xff\xff\xff",
        b"hello",
        b"P6 0 1 255\n",
    ];
    for file in files {
        let message = poster(file).error();
        assert!(message.contains("poster.ppm"), "{message}");
    }
}

/// R35, G9: a file name may be longer than 63 characters, and a name longer than 31.
#[test]
fn names_have_no_limit() {
    let (file, name) = ("f".repeat(200), "n".repeat(300));
    let text = format!(
        r#"texture "{name}" "{file}.ppm"
        texture-plane "{name}" {{
            material "white"; point 0 0 0; normal 0 0 1; xdir 1 0 0; dimensions 1 1
            texture "{name}"
        }}"#
    );
    let scene = Stage::eye(&text).image(&file, &["W"]).scene();
    assert_eq!(scene.surfaces[0].common().name, Some(name));
}
