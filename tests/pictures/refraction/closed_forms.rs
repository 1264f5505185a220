//! Where rays go through slabs, prisms, balls and blocks, against the textbook's formulas.

use glam::DVec3;
use heliodon::math::{Refraction, direction};

use super::tools::{assert_edge, solve, wall};

const GLASS: f64 = 1.5;

/// The slope inside of a slab of that index, for a slope outside.
fn inside(slope: f64, index: f64) -> f64 {
    libm::tan(libm::asin(libm::sin(libm::atan(slope)) / index))
}

/// A slab from depth 2 to depth 3, made of planes.
const SLAB: &str = r#"
    plane { material "glass"; point 0 0 -2; normal 0 0 1 }
    plane { material "glass"; point 0 0 -3; normal 0 0 -1 }
    "#;

/// What is seen through a slab is shifted sideways, and nothing else.
#[test]
fn a_slab_shifts() {
    for edge in [0.25, 1.0, 4.0] {
        let slope = solve(3.0, edge, |slope| slope * 4.0 + inside(slope, GLASS));
        assert_edge(&[SLAB, &wall(5.0, edge)].concat(), slope);
    }
}

/// A block from depth 2 to depth `back`, two wide and high, of six rectangles.
fn block(back: f64) -> String {
    let side = |point: &str, normal: &str, xdir: &str, size: &str| {
        format!(
            "finite-plane {{ material \"glass\"; point {point}; normal {normal}; xdir {xdir};
            dimensions {size} }}\n"
        )
    };
    let length = back - 2.0;
    [
        side("-1 -1 -2", "0 0 1", "1 0 0", "2 2"),
        side(&format!("1 -1 {}", -back), "0 0 -1", "-1 0 0", "2 2"),
        side("1 -1 -2", "1 0 0", "0 0 -1", &format!("{length} 2")),
        side(
            &format!("-1 -1 {}", -back),
            "-1 0 0",
            "0 0 1",
            &format!("{length} 2"),
        ),
        side("-1 1 -2", "0 1 0", "1 0 0", &format!("2 {length}")),
        side(
            &format!("-1 -1 {}", -back),
            "0 -1 0",
            "1 0 0",
            &format!("2 {length}"),
        ),
    ]
    .concat()
}

/// The same of triangles.
fn block_of_triangles() -> String {
    let corner = |index: usize| {
        let bit = |bit: usize, low, high| if index & bit == 0 { low } else { high };
        format!("{} {} {}", bit(1, -1, 1), bit(2, -1, 1), bit(4, -3, -2))
    };
    let quads = [
        [4, 5, 7, 6],
        [1, 0, 2, 3],
        [5, 1, 3, 7],
        [0, 4, 6, 2],
        [6, 7, 3, 2],
        [0, 1, 5, 4],
    ];
    let triangles = quads.iter().flat_map(|[a, b, c, d]| [[a, b, c], [a, c, d]]);
    let node = |[a, b, c]: [&usize; 3]| {
        let [a, b, c] = [a, b, c].map(|index| corner(*index));
        format!("triangle {{ material \"glass\"; vertex1 {a}; vertex2 {b}; vertex3 {c} }}\n")
    };
    triangles.map(node).collect()
}

#[test]
fn a_block_of_rectangles_or_triangles_is_a_slab() {
    for edge in [0.25, 1.0] {
        let slope = solve(0.4, edge, |slope| slope * 4.0 + inside(slope, GLASS));
        for block in [block(3.0), block_of_triangles()] {
            assert_edge(&[block, wall(5.0, edge)].concat(), slope);
        }
    }
}

/// Light that enters the front of a long block cannot leave through its sides: it is mirrored
/// there, wholly, as if the block went on as a row of mirror images.
#[test]
fn a_block_is_a_light_guide() {
    // Where a ray of this slope meets a wall two behind the block, unfolded and folded.
    let unfolded = |slope: f64| slope * 2.0 + inside(slope, GLASS) * 8.0;
    let seen = |slope: f64| {
        let images = (unfolded(slope) + 1.0).rem_euclid(4.0) - 1.0;
        let (place, turned) = if images > 1.0 {
            (2.0 - images, -1.0)
        } else {
            (images, 1.0)
        };
        place + turned * slope * 2.0
    };
    for edge in [0.1, -0.3, 0.9, -1.2] {
        let slope = solve(0.49, edge, seen);
        assert_edge(&[block(10.0), wall(12.0, edge)].concat(), slope);
    }
}

/// The least deviation δ of a prism tells the index: n = sin((A + δ)/2) / sin(A/2) (Fraunhofer 1817);
/// any other is `α + asin(sin A √(n² − sin²α) − cos A sin α) − A`.
#[test]
fn a_prism_deviates_as_fraunhofer_measured() {
    let apex = 60f64.to_radians();
    let [first, second] =
        [-apex / 2.0, apex / 2.0].map(|turn| DVec3::new(libm::sin(turn), 0.0, libm::cos(turn)));
    // The faces look outward: to the light and away from it.
    let second = -second;
    let deviation = |angle: f64| {
        let turn = -apex / 2.0 + angle;
        let dir = -DVec3::new(libm::sin(turn), 0.0, libm::cos(turn));
        let inside = Refraction::new(dir, first, 1.0, GLASS).bent.unwrap();
        let outside = Refraction::new(inside, second, GLASS, 1.0).bent.unwrap();
        libm::acos(outside.dot(dir).min(1.0))
    };
    for degrees in [30.0f64, 40.0, 48.6, 60.0, 80.0] {
        let angle = degrees.to_radians();
        let sine = libm::sin(angle);
        let exit = libm::sin(apex) * (GLASS * GLASS - sine * sine).sqrt() - libm::cos(apex) * sine;
        let expected = angle + libm::asin(exit) - apex;
        assert!((deviation(angle) - expected).abs() < 1e-12, "{degrees}");
    }
    let least = deviation(libm::asin(GLASS * libm::sin(apex / 2.0)));
    let index = libm::sin(f64::midpoint(apex, least)) / libm::sin(apex / 2.0);
    assert!((index - GLASS).abs() < 1e-14, "{index}");
}

/// A ball at depth 4 with the wall so far behind its centre, and where a ray of this slope meets
/// the wall.
///
/// The ray passes the centre at the distance p = 4 sin θ, before and behind. It is turned by α − β at
/// both surfaces, with sin α = p and sin β = p/n.
fn behind_ball(slope: f64, index: f64, behind: f64) -> f64 {
    let angle = libm::atan(slope);
    let passing = 4.0 * libm::sin(angle);
    let turned = angle - 2.0 * (libm::asin(passing) - libm::asin(passing / index));
    passing / libm::cos(turned) + behind * libm::tan(turned)
}

#[test]
fn a_ball_is_a_lens() {
    for round in ["sphere", "ellipsoid"] {
        let scale = if round == "sphere" {
            ""
        } else {
            "; scale 1 1 1"
        };
        let ball = format!("{round} {{ material \"glass\"; center 0 0 -4; radius 1{scale} }}\n");
        for (behind, edge) in [(1.2, 0.0), (1.8, 0.0), (2.3, 0.0), (1.5, -0.1), (7.0, -2.0)] {
            let slope = solve(0.25, edge, |slope| behind_ball(slope, GLASS, behind));
            assert_edge(&[ball.as_str(), &wall(4.0 + behind, edge)].concat(), slope);
        }
    }
}

/// The focal length of a ball lens, n R / (2 (n − 1)), and the image that a point at distance 4 has:
/// 1/v = 1/f − 1/4.
#[test]
fn a_ball_has_a_focal_length() {
    let focal = GLASS / (2.0 * (GLASS - 1.0));
    let image = 1.0 / (1.0 / focal - 0.25);
    assert!(behind_ball(1e-6, GLASS, image).abs() < 1e-15);
}

/// A flattened ball: each ray is followed by hand through `x² + z²/a² = 1`.
#[test]
fn an_ellipsoid_bends_by_its_own_normals() {
    let axis = 0.4;
    let normal = |x: f64, z: f64| direction(DVec3::new(x, 0.0, z / (axis * axis)));
    let seen = |slope: f64| {
        let dir = direction(DVec3::new(slope, 0.0, -1.0));
        let meet = |from: DVec3, dir: DVec3, far: f64| {
            let [o, d] = [from, dir].map(|v| DVec3::new(v.x, 0.0, v.z / axis));
            let (a, b, c) = (d.dot(d), o.dot(d), o.dot(o) - 1.0);
            from + dir * ((-b + far * (b * b - a * c).sqrt()) / a)
        };
        let entry = meet(DVec3::Z * 4.0, dir, -1.0);
        let bent = Refraction::new(dir, normal(entry.x, entry.z), 1.0, GLASS)
            .bent
            .unwrap();
        let exit = meet(entry, bent, 1.0);
        let met = Refraction::new(bent, normal(exit.x, exit.z), GLASS, 1.0);
        let Some(out) = met.bent else { return f64::NAN };
        exit.x + out.x * (exit.z + 3.0) / -out.z
    };
    let lens = "ellipsoid { material \"glass\"; center 0 0 -4; radius 1; scale 1 1 0.4 }\n";
    for edge in [0.1, 0.2] {
        let slope = solve(0.24, edge, seen);
        assert_edge(&[lens, &wall(7.0, edge)].concat(), slope);
    }
}
