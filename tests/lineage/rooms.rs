//! The chapter's pictures: rooms with oak, bricks and a portrait, and saucers before a photograph.

use heliodon::film::Film;

use super::tools::Stage;

/// The chapter's room: floor and wall fill the view, the portrait hangs before the wall.
struct Room {
    brick: &'static str,
    wall_ambient: f64,
    floor_specular: f64,
    tilt: f64,
    frame: bool,
}

const ROOM: Room = Room {
    brick: "brick-384",
    wall_ambient: 4.0,
    floor_specular: 0.4,
    tilt: 0.0,
    frame: false,
};

impl Room {
    fn film(&self) -> Film {
        let Self {
            brick,
            wall_ambient,
            floor_specular,
            tilt,
            frame,
        } = self;
        let frame = if *frame {
            r#"texture-plane "frame" {
                material "canvas"; point 3.5 3.5 -9.95; normal 0 0 1; xdir 1 0 0
                dimensions 4 5; texture "oak"
            }"#
        } else {
            ""
        };
        let text = format!(
            r#"
            image 80 60
            camera {{ viewpoint 6 4.5 9; screen 12 9 }}
            texture "oak" "../textures/oak-128.png"
            texture "brick" "../textures/{brick}.png"
            texture "portrait" "../textures/portrait.png"
            material "floor" {{ ambient 4; diffuse 6; specular {floor_specular} }}
            material "wall" {{ ambient {wall_ambient}; diffuse 6 }}
            material "canvas" {{ ambient 6; diffuse 6 }}
            light {{ location 3 8 1; emissivity 6 }}
            texture-plane "floor" {{
                material "floor"; point -10 0 0; normal 0 1 0; xdir 1 0 0; dimensions 32 12
                texture "oak" mode="repeat" texel=0.015
            }}
            texture-plane "wall" {{
                material "wall"; point -10 0 -10; normal 0 0 1; xdir 1 0 0; dimensions 32 20
                texture "brick" mode="repeat" texel=0.015
            }}
            {frame}
            texture-plane "portrait" {{
                material "canvas"; point 4 4 -9.9; normal 0 0 1; xdir 1 {tilt} 0
                dimensions 3 4; texture "portrait" mode="clamp"
            }}"#
        );
        Stage::new(&text).film()
    }
}

/// The columns and rows of the pixels in which two pictures differ.
fn differing(a: &Film, b: &Film) -> Vec<(usize, usize)> {
    let places = (0..a.height()).flat_map(|row| (0..a.width()).map(move |column| (column, row)));
    places
        .filter(|(column, row)| a.pixel(*column, *row) != b.pixel(*column, *row))
        .collect()
}

/// R18: floor and wall fill the whole visible space.
#[test]
fn floor_and_wall_fill_the_view() {
    let film = ROOM.film();
    assert!(
        film.pixels()
            .iter()
            .all(|pixel| !pixel.is_black() && pixel.is_finite())
    );
}

/// R20: the 384 brick image is the 128 one enlarged three times, so at a third of the texel size it
/// shows nearly the same wall, and at the same size bricks three times as large.
#[test]
fn the_enlarged_brick_is_the_small_one() {
    let wall = |brick: &str, texel: f64| {
        let text = format!(
            r#"texture "brick" "../textures/{brick}.png"
            texture-plane {{
                material "white"; point -0.5 -0.5 0; normal 0 0 1; xdir 1 0 0; dimensions 32 16
                texture "brick" mode="repeat" texel={texel}
            }}"#
        );
        Stage::grid(&text).film()
    };
    let difference = |a: &Film, b: &Film| {
        let pairs = a.pixels().iter().zip(b.pixels());
        pairs.map(|(a, b)| (a.g - b.g).abs()).sum::<f64>() / 512.0
    };
    let large = wall("brick-384", 0.09);
    let (same, small) = (wall("brick-128", 0.27), wall("brick-128", 0.09));
    let (near, far) = (difference(&large, &same), difference(&large, &small));
    assert!(3.0 * near < far, "{near} {far}");
}

/// R21: the wall's ambient times 1.5 brightens the wall, and the floor only by its reflection.
#[test]
fn a_brighter_wall_also_shows_in_the_floor() {
    let (before, after) = (
        ROOM.film(),
        Room {
            wall_ambient: 6.0,
            ..ROOM
        }
        .film(),
    );
    for (old, new) in before.pixels().iter().zip(after.pixels()) {
        let brighter = old
            .channels()
            .iter()
            .zip(new.channels())
            .all(|(old, new)| new >= *old);
        assert!(brighter, "{old:?} {new:?}");
    }
    assert!(after.pixel(2, 4).r > before.pixel(2, 4).r, "the wall");
    assert_eq!(after.pixel(40, 30), before.pixel(40, 30), "the portrait");
    assert!(
        after.pixel(2, 50).r > before.pixel(2, 50).r,
        "the wall in the floor"
    );
    let [dull_before, dull_after] = [4.0, 6.0].map(|wall_ambient| {
        Room {
            wall_ambient,
            floor_specular: 0.0,
            ..ROOM
        }
        .film()
    });
    assert_eq!(
        dull_before.pixel(2, 50),
        dull_after.pixel(2, 50),
        "the floor without a mirror"
    );
}

/// R22: less mirror in the floor shows less brick, and changes the floor alone.
#[test]
fn a_duller_floor_shows_less_brick() {
    let (bright, dull) = (
        ROOM.film(),
        Room {
            floor_specular: 0.15,
            ..ROOM
        }
        .film(),
    );
    let changed = differing(&bright, &dull);
    assert!(changed.len() > 500, "{}", changed.len());
    for (column, row) in changed {
        assert!(bright.pixel(column, row).r > dull.pixel(column, row).r);
        assert!(row > 36, "row {row} is not the floor");
    }
}

/// R22: turning xdir alone hangs the portrait askew, and changes nothing but where it hung, hangs
/// and is mirrored.
#[test]
fn the_portrait_hangs_askew() {
    let (level, askew) = (ROOM.film(), Room { tilt: 0.05, ..ROOM }.film());
    let changed = differing(&level, &askew);
    let wall: Vec<_> = changed.iter().filter(|(_, row)| *row <= 36).collect();
    assert!(wall.len() > 20, "{}", wall.len());
    assert!(
        wall.iter().all(|(column, _)| (30..=50).contains(column)),
        "{wall:?}"
    );
}

/// R23: the exercise: a second, larger plane of oak behind the portrait is its frame.
#[test]
fn an_oak_plane_behind_the_portrait_is_its_frame() {
    let (bare, framed) = (
        ROOM.film(),
        Room {
            frame: true,
            ..ROOM
        }
        .film(),
    );
    let changed = differing(&bare, &framed);
    assert!(!changed.is_empty());
    assert_eq!(
        bare.pixel(40, 26),
        framed.pixel(40, 26),
        "the portrait is before its frame"
    );
    let wall: Vec<_> = changed.iter().filter(|(_, row)| *row <= 36).collect();
    let portrait =
        |(column, row): &(usize, usize)| (34..=42).contains(column) && (19..=31).contains(row);
    assert!(wall.iter().all(|place| !portrait(place)), "{wall:?}");
    assert!(wall.len() > 20, "{}", wall.len());
}

/// R24, R26: saucers before a photograph that fills the view: where there is no saucer, the
/// picture is the photograph, pixel for pixel, and its shadows are off.
#[test]
fn saucers_fly_before_a_photograph() {
    let scene = |saucers: &str| {
        let text = format!(
            r#"
            image 80 60
            camera {{ viewpoint 4 3 8; screen 8 6 }}
            texture "wing" "../textures/wing-1024.png"
            material "photograph" {{ ambient 16 }}
            material "hull" {{ ambient 1; diffuse 20; specular 0.2; shininess 40 }}
            light {{ location 4 12 2; emissivity 5 }}
            texture-plane {{
                material "photograph"; point -4.5 -3.5 -8; normal 0 0 1; xdir 1 0 0
                dimensions 17 13; texture "wing"; shadows receive=#false
            }}
            {saucers}"#
        );
        Stage::new(&text).film()
    };
    let saucer = |x: f64| {
        format!(
            "ellipsoid {{ material \"hull\"; center {x} 3.5 -5; radius 0.8; scale 1 0.25 1 }}\n"
        )
    };
    let photograph = scene("");
    assert!(photograph.pixels().iter().all(|pixel| !pixel.is_black()));
    let with = scene(&[saucer(2.0), saucer(4.5), saucer(7.0)].concat());
    let changed = differing(&photograph, &with);
    assert!(changed.len() > 40, "{}", changed.len());
    let rows = changed.iter().map(|(_, row)| *row);
    let (top, bottom) = (rows.clone().min().unwrap(), rows.max().unwrap());
    assert!(
        bottom - top < 8,
        "the saucers' own rows, {top} to {bottom}, and no shadows below"
    );
}
