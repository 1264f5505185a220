//! What no ray can meet, by mirrors and panes too.

use std::path::PathBuf;

use heliodon::plan::{Plan, Reachability, Scope};
use heliodon::read::{Options, read_bytes};

const HEAD: &str = r#"
    image 8 6
    camera { viewpoint 0 1 9; look-at 0 1 0; field-of-view 30 }
    material "chalk" { ambient 1 }
    material "silver" { specular 0.5 }
    material "pane" { transparency 0.5 }
"#;

/// How rays can meet each surface of a scene, in file order.
fn seen(nodes: &str) -> Vec<Reachability> {
    let text = format!("{HEAD}{nodes}").into_bytes();
    let reading = read_bytes("seen", text, PathBuf::new(), &Options::default());
    let scene = reading.expect("a scene").scene;
    let plan = Plan::new(&scene, Scope::CalledFor).expect("a camera");
    plan.reachability
}

/// A square in sight that faces the eye, and balls behind it, before it, and touching its plane.
fn beside_square(material: &str) -> Vec<Reachability> {
    seen(&format!(
        r#"
        finite-plane {{ material "{material}"; point -1 0 0; normal 0 0 1; xdir 1 0 0; dimensions 2 2 }}
        sphere "behind" {{ material "chalk"; center 50 0 -3; radius 1 }}
        sphere "before" {{ material "chalk"; center 0 0 30; radius 1 }}
        sphere "touching" {{ material "chalk"; center 50 0 -1; radius 1 }}
        plane "endless" {{ material "chalk"; point 0 0 40; normal 0 0 -1 }}
        "#
    ))
}

#[test]
fn what_sends_nothing_on_shows_nothing() {
    use Reachability::{Directly, Never};
    let mut seen = beside_square("chalk");
    // A plane without end is never said to be out of sight.
    assert_eq!(seen.pop(), Some(Directly));
    assert_eq!(seen, [Directly, Never, Never, Never]);
}

#[test]
fn a_mirror_shows_what_is_before_it_and_what_may_be() {
    use Reachability::{Directly, Never, SentOn};
    let seen = beside_square("silver");
    assert_eq!(seen[..4], [Directly, Never, SentOn, SentOn]);
}

#[test]
fn a_pane_lets_rays_through_and_mirrors_nothing() {
    use Reachability::{Directly, Never, SentOn};
    let seen = beside_square("pane");
    assert_eq!(seen[..4], [Directly, SentOn, Never, SentOn]);
}

#[test]
fn mirrors_show_what_mirrors_show_from_the_side_that_rays_come_from() {
    use Reachability::{Directly, SentOn};
    // The first mirror faces the eye; the second is behind the eye and only seen in the first.
    let seen = seen(
        r#"
        finite-plane { material "silver"; point -1 0 0; normal 0 0 1; xdir 1 0 0; dimensions 2 2 }
        finite-plane { material "silver"; point -1 0 20; normal 0 0 1; xdir 1 0 0; dimensions 2 2 }
        sphere "between" { material "chalk"; center 40 0 15; radius 1 }
        sphere "behind both" { material "chalk"; center 40 0 -5; radius 1 }
        sphere "beyond the second" { material "chalk"; center 40 0 25; radius 1 }
        "#,
    );
    // The first mirror alone shows what is beyond the second's plane.
    assert_eq!(seen, [Directly, SentOn, SentOn, SentOn, SentOn]);
}

#[test]
fn something_round_sends_rays_anywhere() {
    use Reachability::{Directly, SentOn};
    let seen = seen(
        r#"
        sphere { material "silver"; center 0 1 0; radius 1 }
        sphere { material "chalk"; center 0 1 30; radius 1 }
        sphere { material "chalk"; center 50 1 -9; radius 1 }
        "#,
    );
    assert_eq!(seen, [Directly, SentOn, SentOn]);
}
