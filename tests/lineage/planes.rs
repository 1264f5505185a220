//! The finite plane.

use glam::{DVec2, DVec3};
use heliodon::math::{Frame, unit};
use proptest::prelude::*;

use super::tools::{Stage, assert_color, assert_drawn, hit, letters};

const DOOR: &str = r#"
    finite-plane { material "red"; point 1 2 -3; normal 0 0 1; xdir 1 0 0; dimensions 4 2 }
"#;

/// R1: a finite plane is a plane with bounds; of the same plane it shows a part.
#[test]
fn a_finite_plane_is_a_part_of_its_plane() {
    let plane = r#"plane { material "blue"; point 0 0 -3; normal 0 0 1 }"#;
    let both = Stage::grid(&[DOOR, plane].concat()).film();
    let whole = Stage::grid(plane).film();
    let (mut inside, mut outside) = (0, 0);
    for (both, whole) in both.pixels().iter().zip(whole.pixels()) {
        assert_color(*whole, [0.0, 0.0, 1.0]);
        inside += u32::from(both.r == 1.0 && both.b == 0.0);
        outside += u32::from(both == whole);
    }
    assert!(inside > 0 && outside > 0, "{inside} {outside}");
    assert_eq!(inside + outside, 32 * 16);
}

/// R2, R5, R10, R12: `uv` is the chapter's `lasthit`, counted from the lower-left corner along x
/// and y in world units.
#[test]
fn a_hit_carries_its_offset_from_the_corner() {
    let scene = Stage::eye(DOOR).scene();
    let door = &*scene.surfaces[0];
    for (x, y) in [(0.0, 0.0), (0.25, 1.5), (4.0, 2.0), (3.0, 0.125)] {
        let found = hit(door, [1.0 + x, 2.0 + y, 0.0], [0.0, 0.0, -1.0]).unwrap();
        assert_eq!(found.uv, DVec2::new(x, y));
        assert_eq!(found.t, 3.0);
    }
}

/// R9: the hit's place stays in world space, whichever way the plane is turned.
#[test]
fn the_hit_point_stays_in_world_space() {
    let turned = r#"
        finite-plane { material "red"; point 3 2 -3; normal 0 0 1; xdir 0 1 0; dimensions 4 2 }
    "#;
    let scene = Stage::eye(turned).scene();
    let found = hit(&*scene.surfaces[0], [2.5, 3.0, 0.0], [0.0, 0.0, -1.0]).unwrap();
    assert_eq!(found.uv, DVec2::new(1.0, 0.5));
    assert_eq!(found.point.world(), DVec3::new(2.5, 3.0, -3.0));
}

/// R3: xdir turns the plane around its corner.
#[test]
fn xdir_is_the_way_that_x_grows() {
    let text = |xdir: &str| {
        format!(
            r#"finite-plane {{
                material "red"; point 15.5 7.5 0; normal 0 0 1; xdir {xdir}; dimensions 12 3
            }}"#
        )
    };
    let drawn = letters(&Stage::grid(&text("2 1 0")).film());
    assert_drawn(
        &drawn,
        "
        |........................RR......|
        |......................RRRR......|
        |....................RRRRRRR.....|
        |..................RRRRRRR.......|
        |................RRRRRRR.........|
        |...............RRRRRR...........|
        |...............RRRR.............|
        |................R...............|
        |................................|
        |................................|
        |................................|
        |................................|
        |................................|
        |................................|
        |................................|
        |................................|
        ",
    );
}

/// R7: where the unbounded plane is missed, the finite plane is missed.
#[test]
fn a_miss_of_the_plane_is_a_miss() {
    let scene = Stage::eye(DOOR).scene();
    let misses = |origin, direction| hit(&*scene.surfaces[0], origin, direction).is_none();
    assert!(misses([2.0, 3.0, 0.0], [0.0, 0.0, 1.0]), "leading away");
    assert!(misses([2.0, 3.0, 0.0], [1.0, 0.0, 0.0]), "beside it");
    assert!(misses([0.0, 3.0, -3.0], [1.0, 0.0, 0.0]), "in it");
    assert!(misses([2.0, 3.0, -3.0], [0.0, 0.0, -1.0]), "from it");
}

/// R7: the distance is the unbounded plane's, from both sides.
#[test]
fn a_plane_is_seen_from_both_sides() {
    let scene = Stage::eye(DOOR).scene();
    let t = |origin, direction| hit(&*scene.surfaces[0], origin, direction).map(|hit| hit.t);
    assert_eq!(t([2.0, 3.0, 1.0], [0.0, 0.0, -1.0]), Some(4.0));
    assert_eq!(t([2.0, 3.0, -5.0], [0.0, 0.0, 1.0]), Some(2.0));
}

/// R11: all four borders and corners belong to a finite plane; the next number outside does not.
#[test]
fn borders_belong() {
    let square = r#"
        finite-plane { material "red"; point 0 0 -3; normal 0 0 1; xdir 1 0 0; dimensions 1 1 }
    "#;
    let scene = Stage::eye(square).scene();
    let hits = |x, y| hit(&*scene.surfaces[0], [x, y, 0.0], [0.0, 0.0, -1.0]).is_some();
    let (below, above) = ((-0.0f64).next_down(), 1.0f64.next_up());
    for edge in [0.0, 1.0] {
        for along in [0.0, 0.5, 1.0] {
            assert!(hits(edge, along) && hits(along, edge), "{edge} {along}");
        }
    }
    for outside in [below, above] {
        for along in [0.0, 0.5, 1.0] {
            let missed = !hits(outside, along) && !hits(along, outside);
            assert!(missed, "{outside} {along}");
        }
    }
}

/// G10: an xdir that does not lie in the plane is projected into it, and its length is nothing.
#[test]
fn xdir_is_projected_and_made_unit() {
    let found = |xdir: &str| {
        let text = format!(
            r#"finite-plane {{
                material "red"; point 0 0 -3; normal 0 0 7; xdir {xdir}; dimensions 4 2
            }}"#
        );
        let scene = Stage::eye(&text).scene();
        hit(&*scene.surfaces[0], [3.0, 1.0, 0.0], [0.0, 0.0, -1.0]).unwrap()
    };
    assert_eq!(found("1 0 0"), found("1000 0 0"));
    assert_eq!(found("1 0 0"), found("3 0 -4"));
}

/// R13: six finite planes make a box, and no ray that is aimed inside slips through.
#[test]
fn six_finite_planes_make_a_box() {
    let side = |point: &str, normal: &str, xdir: &str, size: &str| {
        format!(
            r#"finite-plane {{
                material "red"; point {point}; normal {normal}; xdir {xdir}; dimensions {size}
            }}
            "#
        )
    };
    // A brick from (0, 0, 0) to (3, 2, 1); each normal is outward.
    let brick = [
        side("0 0 1", "0 0 1", "1 0 0", "3 2"),
        side("3 0 0", "0 0 -1", "-1 0 0", "3 2"),
        side("3 0 1", "1 0 0", "0 0 -1", "1 2"),
        side("0 0 0", "-1 0 0", "0 0 1", "1 2"),
        side("0 2 1", "0 1 0", "1 0 0", "3 1"),
        side("0 0 0", "0 -1 0", "1 0 0", "3 1"),
    ];
    let scene = Stage::eye(&brick.concat()).scene();
    for step in 0..1000u32 {
        let angle = f64::from(step);
        let direction = [angle.sin(), (0.7 * angle).cos(), (1.3 * angle).sin()];
        let from_inside = [1.0, 1.5, 0.25];
        let hits = scene
            .surfaces
            .iter()
            .filter(|side| hit(&***side, from_inside, direction).is_some());
        assert!(hits.count() >= 1, "{direction:?} leads out of the box");
    }
    // Seen from outside along a diagonal, the line enters once and leaves once.
    let crossed = scene
        .surfaces
        .iter()
        .filter(|side| hit(&***side, [-2.0, -1.0, -2.0], [3.0, 2.0, 2.5]).is_some());
    assert_eq!(crossed.count(), 2);
}

proptest! {
    /// R4, R8: a finite plane works in any orientation: aimed at an offset from its corner, a ray
    /// finds that offset.
    #[test]
    fn any_orientation_works(
        normal in prop::array::uniform3(-1.0..1.0f64),
        xdir in prop::array::uniform3(-1.0..1.0f64),
        (across, upward) in (0.01..0.99f64, 0.01..0.99f64),
        slant in prop::array::uniform3(-0.5..0.5f64),
    ) {
        let (normal, xdir) = (DVec3::from(normal), DVec3::from(xdir));
        prop_assume!(normal.length() > 0.1 && normal.cross(xdir).length() > 0.1);
        let text = format!(
            "finite-plane {{ material \"red\"; point 1 2 -3; normal {} {} {}; xdir {} {} {}
            dimensions 4 2 }}",
            normal.x, normal.y, normal.z, xdir.x, xdir.y, xdir.z,
        );
        let scene = Stage::eye(&text).scene();
        let normal = unit(normal).unwrap();
        let frame = Frame::new(normal, xdir).unwrap();
        let corner = DVec3::new(1.0, 2.0, -3.0);
        let offset = DVec2::new(4.0 * across, 2.0 * upward);
        let target = corner + frame.x * offset.x + frame.y * offset.y;
        let direction = -(normal + DVec3::from(slant) * 0.9);
        let origin = target - direction * 3.0;
        let found = hit(&*scene.surfaces[0], origin.into(), direction.into());
        let found = found.expect("aimed at the middle");
        prop_assert!((found.uv - offset).length() < 1e-13, "{} {}", found.uv, offset);
        prop_assert!((found.point.world() - target).length() < 1e-13);
    }
}
