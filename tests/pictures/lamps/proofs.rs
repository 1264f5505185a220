//! What must not change a picture with lamps.

use heliodon::plan::Scope;
use support::scenes::lamps::scene;

use super::{bits, drawn, picture};

#[test]
fn what_is_left_out_changes_no_bit() {
    let (mut few, mut many) = (0, 0);
    for index in 0..150 {
        let scene = scene(index);
        let (planned, counts) = picture(&scene, Scope::CalledFor);
        let (all, all_counts) = picture(&scene, Scope::Everything);
        (few, many) = (few + counts.lamp_rays, many + all_counts.lamp_rays);
        assert!(
            bits(&planned) == bits(&all),
            "scene {index} differs:\n{scene}"
        );
    }
    assert!(
        few > 0 && 3 * few < 2 * many,
        "{few} of {many} rays are left"
    );
}

/// A scene of numbers that are sums of few powers of two, moved and scaled.
fn moved_and_scaled(by: f64, scale: f64) -> String {
    let at = |x: f64, y: f64, z: f64| {
        let numbers = [x, y, z].map(|number| format!("{:?}", (number + by) * scale));
        numbers.join(" ")
    };
    let length = |length: f64| format!("{:?}", length * scale);
    format!(
        "image 40 30\ncamera {{ viewpoint {}; look-at {} }}\nmaterial \"chalk\" {{ diffuse 1 }}\n\
         lamp {{ point {}; normal 0 -1 0; xdir 1 0 0; dimensions {} {}; emissivity 3; samples 16 }}\n\
         lamp {{ center {}; radius {}; emissivity 2 1 4; samples 16 }}\n\
         plane {{ material \"chalk\"; point {}; normal 0 1 0 }}\n\
         finite-plane {{ material \"chalk\"; point {}; normal 1 0 0; xdir 0 0 -1; dimensions {} {} }}\n\
         sphere {{ material \"chalk\"; center {}; radius {} }}",
        at(0.0, 2.0, 5.0),
        at(0.0, 0.5, 0.0),
        at(-1.0, 3.0, -1.0),
        length(2.0),
        length(1.5),
        at(1.5, 0.5, 1.5),
        length(0.25),
        at(0.0, 0.0, 0.0),
        at(-1.5, 0.0, 1.0),
        length(2.0),
        length(1.0),
        at(0.0, 0.75, 0.0),
        length(0.75),
    )
}

#[test]
fn scaling_and_moving_change_no_bit() {
    let (here, counts) = drawn(&moved_and_scaled(0.0, 1.0));
    assert!(counts.lamp_rays > 1000);
    for power in [-100, -3, 7, 100] {
        let (there, _) = drawn(&moved_and_scaled(0.0, 2f64.powi(power)));
        assert!(bits(&here) == bits(&there), "scaled by 2^{power}");
    }
    let (far, _) = drawn(&moved_and_scaled(1e9, 1.0));
    assert!(bits(&here) == bits(&far), "moved by 1e9");
}

#[test]
fn threads_change_no_bit() {
    let scene = moved_and_scaled(0.0, 1.0);
    let [one, three] = [1, 3].map(|threads| {
        let pool = rayon::ThreadPoolBuilder::new()
            .num_threads(threads)
            .build()
            .expect("threads");
        bits(&pool.install(|| drawn(&scene)).0)
    });
    assert!(one == three);
}

/// What is mirrored looks mirrored: exactly where the whole lamp is seen, and as well as 64 places of
/// it can say elsewhere.
#[test]
fn a_symmetric_scene_looks_symmetric() {
    let scene = "image 48 36\ncamera { viewpoint 0 2 5; look-at 0 0.5 0 }\nmaterial \"chalk\" { diffuse 1 }\n\
        lamp { point -1 3 -1; normal 0 -1 0; xdir 1 0 0; dimensions 2 2; emissivity 3 }\n\
        plane { material \"chalk\"; point 0 0 0; normal 0 1 0 }\n\
        sphere { material \"chalk\"; center 0 0.75 0; radius 0.5 }";
    let film = drawn(scene).0;
    let mut exact = 0;
    for (x, y) in (0..24).flat_map(|x| (0..36).map(move |y| (x, y))) {
        let [left, right] = [x, 47 - x].map(|x| film.pixel(x, y).r);
        let off = (left - right).abs();
        assert!(off <= 0.05, "{x} {y}: {left} {right}");
        exact += usize::from(off <= 1e-12 * left);
    }
    assert!(
        exact > 400,
        "only {exact} are as bright as their mirror images"
    );
}
