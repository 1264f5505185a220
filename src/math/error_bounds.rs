//! Bounds of the difference between rounded and exact values.
//!
//! All bounds hold for doubles with rounding to nearest, `u` = 2⁻⁵³, and vectors of length at most
//! `1 + 4u`. `docs/numerics.md` has them in a table, with the longer derivations.
//!
//! An expression whose longest path has `k` roundings is off by at most `γ(k) S`. There `γ(k)` is
//! `k u / (1 − k u)`, and `S` is the expression with every term made positive (Higham 2002,
//! "Accuracy and Stability of Numerical Algorithms", §3.1).
//!
//! A vector `c` from a scene point to a ray's origin is itself rounded twice: `c = (anchor − p) +
//! offset`. With `size = |anchor − p|₁ + |offset|₁`, every sum of `|cᵢ|` is at most `size`. Where
//! it saves work, `|anchor|₁ + |p|₁` stands for `|anchor − p|₁`, which it exceeds. A wider bound
//! sends more cases to exact arithmetic and cannot decide wrongly.

/// The largest relative rounding error: half of the step from 1 to the next double.
pub const UNIT: f64 = f64::EPSILON / 2.0;

/// The limit of underflow: the smallest double of full precision, and no length.
///
/// Products below it can lose bits; such values are always decided exactly.
pub(crate) const UNDERFLOW: f64 = f64::MIN_POSITIVE;

/// The error of a slope `D = n·d`, as a number.
// A product and two sums, γ(3) Σ|nᵢdᵢ|, where the sum is at most (1 + 4u)². And 2 u Σ|dᵢ|, at most
// 2√3 u, because the deciding normal may be that of a neighbour in the same plane.
pub(crate) const SLOPE: f64 = 7.0 * UNIT;

/// The error of a height `N = −n·c`, in units of `size`.
// Two roundings in c, a product and two sums; and two for the normal of a neighbour.
pub(crate) const HEIGHT: f64 = 8.0 * UNIT;

/// The error of a moment `v·(d × c)`, in units of `size`.
// Two roundings in c, a product and a difference in the cross product, a product and two sums: γ(7)
// A. A = Σ|vᵢ|(|dⱼcₖ| + |dₖcⱼ|) is at most |c|₁ maxₖ(|vᵢdⱼ| + |vⱼdᵢ|) ≤ |c|₁ (1 + 4u)². And 2 more:
// a border point given by decimals is their sum rounded, while the filter adds the size to the
// rounded corner.
pub(crate) const MOMENT: f64 = 9.0 * UNIT;

/// The error of a moment in units of the error of a height, for one `size`.
pub(crate) const MOMENT_PER_HEIGHT: f64 = MOMENT / HEIGHT;

/// The error that `w D` adds to `w D − v·(d × c)`, in units of `w`.
///
/// [`MOMENT`] has the rest.
// 5 for the product. And 4, because a border that is a line of whole numbers is that far from the
// one along a rounded unit vector.
pub(crate) const EXTENT: f64 = 9.0 * UNIT;

/// The rounding of a quotient `t = N/D`, in units of `t`.
// The errors of N and D come on top.
pub(crate) const QUOTIENT: f64 = 2.0 * UNIT;

/// The error of a hit point off its ray, in units of `size` plus its own offset.
// The roundings of c, of t d, of their sum, and of the projection along the normal; both lengths
// together bound |c|₁ + t. The error along the ray is that of t.
pub(crate) const FOOT: f64 = 16.0 * UNIT;

/// The error of a hit point along a flat surface, per error of its distance.
///
/// [`FOOT`] has the error off the ray.
// On a plane it is 1, because the point is the foot at that distance. A rectangle's point is a sum
// of two quotients of moments, X (Y·m)/D − Y (X·m)/D with m = d × c.
//
// An error of c moves the line as a whole, and so the crossing by at most itself over D: 2 u. An
// error of m does likewise: 2 u |c|₁ for a product and a difference in each component. The products
// with both axes have three roundings each. X and Y may be 2 u off from right angles to n and each
// other: together √2 (3 + 2) u |m|. D, with its three roundings and the neighbour's normal, changes
// the offset by (3 + 2√3) u times its length.
//
// With the ray's part c∥ along c, |m| is |c⊥|, and the offset is √((t + |c∥|)² + c⊥²) at most. Both
// together are at most √((5√2)² + (3 + 2√3)²) |c| + (3 + 2√3) t. The sum is (13.6 |c|₁ + 6.5 t) u /
// D, where the error of t is (8 size + 7 t) u / D.
pub(crate) const FLAT_SLIP: f64 = 1.75;

/// The same on a round surface, before the factor for the ratio of its axes.
// The point is pushed out from the centre. The roundings of the vector to it are 4 u of size, while
// the error of its distance is at least 15 u.
pub(crate) const ROUND_SLIP: f64 = 1.25;

/// The largest error of a hit along its ray that counts: 2⁻²⁶ of its distance.
// Half of a double's digits. A ray nearly parallel to a plane may hit it anywhere. The computed
// point then decides nothing about its surroundings.
pub(crate) const SLIDE: f64 = 134_217_728.0 * UNIT;

/// The slope below which borders are decided in the plane: 2⁻²⁶.
// Half of a double's digits. A border is a line off its plane by a rounding. A ray passes the line
// as it passes its image in the plane, up to that rounding over the slope; see WIDEN.
pub(crate) const GRAZING: f64 = 134_217_728.0 * UNIT;

/// The distance outside its corners at which a flat surface can be hit: 2⁻²⁰.
///
/// It is in units of the lengths of its box.
// Borders are off the plane by at most EXTENT of the size, which over GRAZING is an eighth of this.
// The rest is for corners that are twice as far away as they are wide.
pub(crate) const WIDEN: f64 = 8_589_934_592.0 * UNIT;

/// The error of a slab `(face − o)/d`, in units of the sizes of `o` and the faces.
// Two roundings in o, two in a face, one for moving it outward, and one each for the difference,
// the reciprocal and the product, which are as good as moving the face: 8 for each of the two. And
// 8 more, because the start of a ray may be that far beyond a plane (HEIGHT) that it has not
// crossed.
pub(crate) const SLAB: f64 = 32.0 * UNIT;

/// The distance at which a line decided to hit an occluder may pass outside it.
///
/// It is in units of all lengths and divided by the sine of the least angle between light and
/// occluder.
// 16 for the corners of surfaces that share planes and borders, twice that where two borders meet,
// 9 for the border, 8 for the ray's direction. And an eighth of the whole for the ray's start,
// which no hit exceeds except at a small angle. See "Derivation: shadow rectangle".
pub(crate) const SHADE: f64 = 16_384.0 * UNIT;

/// The margin between a cone and a sphere outside of it: 2⁻²⁰ radians.
// Points are off by less than 64 roundings of their size: corners by 16, and two more for a middle
// and a difference. If that exceeds a sixteenth of the margin, in units of the distance, nothing is
// decided. So the centre is off by 1/16 of the margin.
//
// The half-angle is the arc sine of a quotient below 0.9, whose derivative is below 2.3. Radius and
// distance put the quotient off by 1.9/16, and the angle by 0.28 of the margin. Together that is
// 0.34, and twice that for a cone around a sphere. A cosine that is off by 8 u puts its angle off
// by 4 √u at most, which is 0.05: once for the arc cosine and once for a light's own cone. The sum
// is below 0.8.
pub(crate) const APART: f64 = 8_589_934_592.0 * UNIT;

/// The error of a vector between two positions, in units of the sizes of both.
// A corner is off by 16 roundings; two more are for a middle and a difference. See APART.
pub(crate) const POSITION: f64 = 64.0 * UNIT;

/// The error of the normal through a light and a border, before division.
///
/// It is in units of the sizes of all three points times both lengths.
// Each vector from the light is off by 18 roundings of its size at most, which the cross product
// multiplies by the length of the other. Its own roundings are few.
pub(crate) const BEAM_NORMAL: f64 = 64.0 * UNIT;

/// The error of `|c|² − r²` for a sphere, in units of `size² + r²`.
// Two roundings in each component of c, a product and two sums, and a difference.
pub(crate) const BALL_SIDE: f64 = 16.0 * UNIT;

/// The error along the line of a chord's middle in a sphere, in units of `size`.
// The middle is f = c·d/a, where c has o = 2 roundings and d has e = 0. The product c·d has o + e +
// 3. With a = d·d, 2e + 3, and the division, (o + 3e + 7) u. For a sphere a is 1: the length of d
// then puts it off by 8 u, in place of 4 for a and the division. One more is for the sum with half
// the chord, and one for the rounding of the bound: 9 − 4 + 8 + 2. See "Derivation: spheres".
pub(crate) const BALL_ALONG: f64 = 15.0 * UNIT;

/// The error across the line of a chord's middle in a sphere, in units of `size`.
// The roundings of c and d, the product and the difference, (o + e + 2) u; and one for the bound.
pub(crate) const BALL_ACROSS: f64 = 5.0 * UNIT;

/// The same as [`BALL_ALONG`] for an ellipsoid, in the space where it is a sphere.
// With o = 3 and e = 1, one more for the product with the reciprocal of an axis:
// o + 3e + 7 = 13, and 2. Rounding the reciprocals is as good as rounding the axes.
pub(crate) const ELLIPSOID_ALONG: f64 = 15.0 * UNIT;

/// The same as [`BALL_ACROSS`] for an ellipsoid, in the space where it is a sphere.
// With o = 3 and e = 1: o + e + 2 = 6, and 1 for the bound.
pub(crate) const ELLIPSOID_ACROSS: f64 = 7.0 * UNIT;

/// The error of `(c·d)² − a (c·c − r²)`, in units of `a (size² + r²)`.
// The terms have up to 21 roundings.
pub(crate) const DISCRIMINANT: f64 = 64.0 * UNIT;

/// The error that half a chord adds to a distance, in units of half the chord.
// Both roots, a, the division and the sum.
pub(crate) const HALF_CHORD: f64 = 8.0 * UNIT;

/// The error of a difference of squares `x² − r²`, in units of their sum.
// A sum of squares has three roundings, and the difference one. r² has one, or two for the axes of
// an ellipsoid, which may be off by u.
pub(crate) const SQUARES: f64 = 5.0 * UNIT;

/// The error of `c·d` for a vector from a centre, in units of all its terms.
// Two roundings in c and, in the space of an ellipsoid, two in both; a product and two sums.
pub(crate) const NEAREST: f64 = 9.0 * UNIT;

/// The error of a number of the occlusion tests, in units of the sizes in it: 2⁻⁴³.
// Corners, hit points and points of a lamp are off by 16 roundings of their size at most. A product
// of three differences of them is off by three times two of these and 11 more. That is far less. A
// ray with a rounded direction passes a corner of a lamp as if that were moved by a few roundings
// of the whole distance. A larger bound only makes more tests.
pub(crate) const OCCLUSION: f64 = 1024.0 * UNIT;

/// The error of six times a tetrahedron's volume, in units of products of sizes.
// Each difference, product and sum is rounded once, 11 on the longest path. Corners may be rounded,
// and computed points of a surface are off it by 16 roundings. A rounded direction moves the end of
// the ray by a few roundings of the whole distance.
pub(crate) const VOLUME: f64 = 128.0 * UNIT;

/// The error of a segment's height at an occluder's plane, in units of all sizes.
// Far above the sum for start, direction and plane.
pub(crate) const CROSSING_HEIGHT: f64 = 64.0 * UNIT;

/// The error of a number of cells on a grid, relative.
// One rounding each of the product, the density, the pitch and the line, and of the scaled error.
pub(crate) const CELL: f64 = 8.0 * UNIT;

/// The error of the distance to a grid line, in units of the position.
// One rounding each of the pitch, the division, the product and the line.
pub(crate) const GRID_LINE: f64 = 4.0 * UNIT;

/// The error of a size that is recovered from the error of a height, relative.
// Three sums and the product; HEIGHT is a power of two.
pub(crate) const SIZE: f64 = 4.0 * UNIT;

/// The largest difference of normals, by component, that counts as rounding.
// Surfaces in one plane may have normals that differ by one rounding of each component.
pub(crate) const OWN_NORMAL: f64 = 2.0 * UNIT;

/// The error of the distance of a plane across the z axis, in units of its terms.
// The difference of anchors and the sum have a rounding each. The slope, a component of the
// direction, has none. The reciprocal and the product have one each. In units of the rounded values
// that is 1 and 3.
pub(crate) const SCREEN: f64 = 4.0 * UNIT;

/// The error of a point's image on the screen, in units of the sizes of both ends.
// A corner is off by 16 roundings; the vector from the eye and its image add few. The raster
// rectangle has a whole pixel more on every side.
pub(crate) const IMAGE: f64 = 64.0 * UNIT;

/// The rounding of a reflected direction, in radians.
// Twice the product with the normal is off by 6 u. Subtracting it and making the rest unit add 3
// and 5.
pub(crate) const REFLECTION: f64 = 16.0 * UNIT;

/// The rounding of an angle of incidence, in radians.
// As for a mirror. Errors behind surfaces are estimates of first order.
pub(crate) const INCIDENCE: f64 = 16.0 * UNIT;

/// The rounding of a refracted direction, in radians.
///
/// `ratio` is that of the indices of refraction, `cosine` that of the largest refracted angle.
pub(crate) fn refraction(ratio: f64, cosine: f64) -> f64 {
    // cos α is off by 5 u, so μ² sin² α by (10 μ² + 5) u. The root cos β is off by half of that and
    // u, divided by itself. The unit direction adds (10 μ + 12) u.
    ((5.0 * ratio * ratio + 3.0) / cosine + 10.0 * ratio + 12.0) * UNIT
}
