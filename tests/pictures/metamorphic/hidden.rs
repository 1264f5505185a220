//! What cannot be seen and throws no shadow does not change the picture.

use heliodon::film::Film;

use super::rooms::{Room, rooms};
use super::subject::{Subject, difference, fail_on};

/// The room with its rays followed by their length alone: how long the dial `cut-off` follows them
/// depends on how bright anything in the scene could be, seen or not.
fn text(room: &Room) -> String {
    let text = room.subject.text();
    let (cut_off, falloff) = ("cut-off=0.00098", "view-falloff ");
    assert!(text.contains(cut_off) && text.contains(falloff), "{text}");
    text.replacen(cut_off, "cut-off=0", 1)
        .replacen(falloff, "reach 40; view-falloff ", 1)
}

fn film(room: &Room) -> Film {
    Subject::new(&room.subject.name, &text(room)).film()
}

/// The room with more nodes, once at the end of the file and once at its beginning.
fn with(room: &Room, nodes: &str) -> [Subject; 2] {
    let name = &room.subject.name;
    let text = text(room);
    [format!("{text}\n{nodes}"), format!("{nodes}\n{text}")].map(|text| Subject::new(name, &text))
}

fn complaints(what: &str, nodes: impl Fn(&Room) -> String) -> Vec<String> {
    let mut complaints = Vec::new();
    for room in rooms() {
        let expected = film(&room);
        for (place, other) in ["last", "first"].iter().zip(with(&room, &nodes(&room))) {
            let title = format!("{} with {what} {place} in the file", room.subject.name);
            complaints.extend(difference(&title, &expected, &other.film()));
        }
    }
    complaints
}

/// The rooms are closed, so what is outside is behind everything.
#[test]
fn nothing_outside_of_a_room_changes_it() {
    fail_on(complaints("things outside", |room| {
        let [x, y, z] = room.low.map(|low| low - 2.5);
        let [right, top, front] = room.high.map(|high| high + 0.001);
        format!(
            r#"material "loud" {{ ambient 1000; diffuse 1000; specular 1 }}
            sphere {{ material "loud"; center {x} {y} {z}; radius 2 }}
            plane {{ material "loud"; point {right} 0 0; normal -1 0 0 }}
            tiled-plane {{
                material "loud"; alternate "loud"; point 0 {top} 0; normal 0 -1 0; xdir 1 0 0
                dimensions 1 1 }}
            finite-plane {{
                material "loud"; point -50 -50 {front}; normal 0 0 -1; xdir -1 0 0
                dimensions 100 100 }}
            triangle {{ material "loud"; vertex1 -99 -99 {z}; vertex2 99 -99 {z}; vertex3 0 99 {z} }}"#
        )
    }));
}

/// What is inside of an opaque ball is seen by nothing, and lies in its shadow already.
#[test]
fn nothing_inside_of_a_ball_changes_it() {
    fail_on(complaints("things in the ball", |room| {
        let ([x, y, z], radius) = room.ball;
        let half = radius / 2.0;
        format!(
            r#"material "loud" {{ ambient 1000; diffuse 1000; specular 1 }}
            sphere {{ material "loud"; center {x} {y} {z}; radius {half} }}
            ellipsoid {{ material "loud"; center {x} {y} {z}; radius {half}; scale 1 0.5 1.5 }}
            finite-plane {{
                material "loud"; point {x} {y} {z}; normal 1 2 3; xdir 1 0 0
                dimensions {half} {half} }}"#
        )
    }));
}

/// The next number below the floor is behind the floor, and nearer than any tolerance would be.
#[test]
fn no_floor_one_rounding_below_another_changes_it() {
    fail_on(complaints("a floor below the floor", |room| {
        let below = room.low[1].next_down();
        format!(
            r#"material "loud" {{ ambient 1000; diffuse 1000; specular 1 }}
            plane {{ material "loud"; point 0 {below:?} 0; normal 0 1 0 }}"#
        )
    }));
}

#[test]
fn no_wall_a_trifle_behind_another_changes_it() {
    fail_on(complaints("a wall behind the wall", |room| {
        let beside = room.high[0] + 1e-9;
        format!(
            r#"material "loud" {{ ambient 1000; diffuse 1000; specular 1 }}
            finite-plane {{
                material "loud"; point {beside:?} -50 -50; normal -1 0 0; xdir 0 0 1
                dimensions 100 100 }}"#
        )
    }));
}

/// Of two walls in one plane the first in the file is seen.
#[test]
fn no_wall_in_the_plane_of_an_earlier_one_changes_it() {
    fail_on(rooms().filter_map(|room| {
        let z = room.low[2];
        let twin = format!(
            r#"material "loud" {{ ambient 1000; diffuse 1000; specular 1 }}
            finite-plane {{
                material "loud"; point -50 -50 {z}; normal 0 0 1; xdir 1 0 0; dimensions 100 100 }}"#
        );
        let title = format!("{} with a second back wall", room.subject.name);
        let [last, _first] = with(&room, &twin);
        difference(&title, &film(&room), &last.film())
    }));
}

/// A room whose right edge, from back to front, is aimed at by a column of pixels, and two sheets in the
/// planes of the walls there, on the same lines but far above the room.
#[test]
fn walls_keep_their_edges_beside_neighbours_elsewhere_on_the_line() {
    let room = r#"
        image 41 41
        camera { viewpoint 5 5 10; screen 10 10 }
        lighting { view-falloff "none" }
        material "white" { ambient 1 }
        finite-plane { material "white"; point 0 0 -10; normal 0 0 1; xdir 1 0 0; dimensions 10 10 }
        finite-plane { material "white"; point 0 0 0; normal 0 1 0; xdir 1 0 0; dimensions 10 10 }
        finite-plane { material "white"; point 0 10 -10; normal 0 -1 0; xdir 1 0 0; dimensions 10 10 }
        finite-plane { material "white"; point 0 0 0; normal 1 0 0; xdir 0 0 -1; dimensions 10 10 }
        finite-plane { material "white"; point 10 0 -10; normal -1 0 0; xdir 0 0 1; dimensions 10 10 }"#;
    for (side, sheet) in [("left", 0.0), ("right", 10.0)] {
        let along = if side == "left" { -5.0 } else { 10.0 };
        let sheets = format!(
            r#"
        finite-plane {{ material "white"; point {sheet} 20 -10; normal 1 0 0; xdir 0 0 -1; dimensions 5 5 }}
        finite-plane {{ material "white"; point {along} 20 -10; normal 0 0 1; xdir 1 0 0; dimensions 5 5 }}"#
        );
        let expected = Subject::new("room", room).film();
        let film = Subject::new("room", &format!("{room}{sheets}")).film();
        fail_on(difference(side, &expected, &film));
    }
}
