//! What rays may spend is the same to the last bit, whatever else is simulated.

use std::iter::Sum;

use heliodon::render::{Event, Probe, Render, Unfollowed};
use heliodon::scene::Scene;

use super::{differing, scene};

/// What each ray could have added that was too faint to be followed.
#[derive(Default)]
struct Missed(Vec<f64>);

impl Probe for Missed {
    fn on(&mut self, event: Event<'_>) {
        if let Event::NotFollowed(_, Unfollowed::TooFaint(missed)) = event {
            self.0.push(missed);
        }
    }
}

impl Sum for Missed {
    fn sum<I: Iterator<Item = Self>>(all: I) -> Self {
        Self(all.flat_map(|missed| missed.0).collect())
    }
}

/// A wall of this material before the eye, something behind it, and behind the eye a bright mirror.
fn with_mirror(wall: &str, behind: &str) -> Scene {
    let text = format!(
        r#"
        image 16 12
        camera {{ viewpoint 1 2 9; look-at 0 0 0 }}
        material "wall" {{ ambient 0.125; {wall} }}
        material "silver" {{ ambient 1; specular 0.5 }}
        material "glass" {{ ambient 0.5; transparency 0.875; ior 1.5 }}
        plane {{ material "wall"; point 0 0 0; normal 0 0 1 }}
        plane {{ material "silver"; point 0 0 12; normal 0.125 0 -1 }}
        {behind}
        "#
    );
    scene(&text).expect("a scene")
}

/// Lets each of a scene's rays be the last one, by a hair, that is followed or not.
fn is_the_same_at_every_brink(mut scene: Scene) {
    scene.settings.cut_off = 1.0;
    let (_, Missed(missed)) = Render::new(&scene).film().expect("a camera");
    assert_eq!(missed.len(), 16 * 12);
    for missed in missed {
        for cut_off in [missed, missed.next_down()] {
            scene.settings.cut_off = cut_off;
            let differing = differing(&scene);
            assert!(differing.is_empty(), "{cut_off}: {differing:?}");
        }
    }
}

#[test]
fn what_varnish_lets_through_to_nowhere_takes_nothing_from_what_it_mirrors() {
    is_the_same_at_every_brink(with_mirror("ior 1.5", ""));
}

#[test]
fn glass_that_only_rays_that_nothing_called_for_meet_takes_nothing_from_others() {
    let glass = r#"plane { material "glass"; point 0 0 -1; normal 0 0 1 }"#;
    is_the_same_at_every_brink(with_mirror("specular 0.375", glass));
}
