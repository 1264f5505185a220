//! How far a rounded value can lie from the exact one.
//!
//! All bounds are for doubles with rounding to nearest, `u` = 2⁻⁵³, and vectors of length at most
//! `1 + 4u`. An expression whose longest path has `k` roundings is off by at most `γ(k) S`, where
//! `γ(k) = k u / (1 − k u)` and `S` is the same expression with every term made positive (Higham
//! 2002, "Accuracy and Stability of Numerical Algorithms", §3.1). A vector `c` from a scene point
//! to a ray's origin is itself rounded twice: `c = (anchor − p) + offset`; with
//! `size = |anchor − p|₁ + |offset|₁` every sum of `|cᵢ|` is at most `size`. Where it saves work,
//! `|anchor|₁ + |p|₁` stands for `|anchor − p|₁`, which is never more: a wider bound sends more to exact
//! arithmetic, but cannot decide wrongly.

/// Half of the distance from 1 to the next double: the largest relative rounding.
pub const UNIT: f64 = f64::EPSILON / 2.0;

/// Below this, products of doubles can lose bits to underflow; such values are always decided
/// exactly. It stands for no length: it is the smallest double of full precision.
pub(crate) const UNDERFLOW: f64 = f64::MIN_POSITIVE;

/// `D = n·d`: a product and two sums, `γ(3) Σ|nᵢdᵢ|`, and the sum is at most `(1 + 4u)²`; and `2 u Σ|dᵢ|`, which
/// is at most `2√3 u`, because the normal that decides may be that of a neighbour in the same plane.
pub(crate) const SLOPE: f64 = 7.0 * UNIT;

/// `N = −n·c`, in units of `size`: two roundings in `c`, a product and two sums; and two for the
/// normal of a neighbour.
pub(crate) const HEIGHT: f64 = 8.0 * UNIT;

/// `v·(d × c)`, in units of `size`: two roundings in `c`, a product and a difference in the cross
/// product, a product and two sums: `γ(7) A`, and `A = Σ|vᵢ|(|dⱼcₖ| + |dₖcⱼ|)` is at most
/// `|c|₁ maxₖ(|vᵢdⱼ| + |vⱼdᵢ|) ≤ |c|₁ (1 + 4u)²`. And 2 more, because the point of a border that is
/// meant by decimals is their sum rounded, while the filter adds the size to the rounded corner.
pub(crate) const MOMENT: f64 = 9.0 * UNIT;

/// What a moment is off by, in units of what a height is off by; `size` is the same in both.
pub(crate) const MOMENT_PER_HEIGHT: f64 = MOMENT / HEIGHT;

/// `w D − v·(d × c)`, in units of `w`, beside [`MOMENT`] for the other term and its difference: 5 for
/// the product, and 4 because a border that is a line of whole numbers lies that far from the one
/// along a rounded unit vector.
pub(crate) const EXTENT: f64 = 9.0 * UNIT;

/// `t = N/D`: beside the errors of both, the rounding of the quotient, in units of `t`.
pub(crate) const QUOTIENT: f64 = 2.0 * UNIT;

/// How far a computed hit point lies off the ray that led to it, in units of `size` plus the sum of
/// the hit's own offset, which together bound `|c|₁ + t`: the roundings of `c`, of `t d`, of their sum,
/// and of taking off the part along the normal. How far it lies along the ray is the error of `t`.
pub(crate) const FOOT: f64 = 16.0 * UNIT;

/// How far a hit point on something flat lies from where it ought to, in units of the error of its distance,
/// beside [`FOOT`].
///
/// On a plane that is 1, for the point is the foot at that distance. A rectangle's is a sum of two quotients of
/// moments, `X (Y·m)/D − Y (X·m)/D` with `m = d × c`. An error of `c` moves the line as a whole, and so the
/// crossing by no more than itself over `D`: 2 u. An error of `m` does likewise: 2 u `|c|₁` for a product and a
/// difference in each component. The products with both axes have three roundings each, and `X` and `Y` may be
/// 2 u off from right angles to `n` and each other: together `√2 (3 + 2) u |m|`. And `D` with its three
/// roundings and the neighbour's normal puts the offset off by `(3 + 2√3) u` times its length. With the
/// ray's part `c∥` along `c`, `|m|` is `|c⊥|`, and the offset `√((t + |c∥|)² + c⊥²)` at most; so both together are
/// at most `√((5√2)² + (3 + 2√3)²) |c| + (3 + 2√3) t`. In all `(13.6 |c|₁ + 6.5 t) u / D`, where the error of `t` is
/// `(8 size + 7 t) u / D`.
pub(crate) const FLAT_SLIP: f64 = 1.75;

/// The same on something round, beside the ratio of its axes: the point is pushed out from the centre, and with it
/// go the roundings of the way to it, 4 u of `size`, while the error of its distance is no less than 15 u.
pub(crate) const ROUND_SLIP: f64 = 1.25;

/// How far a hit may slide along its ray and still say something about what is next to it, in units
/// of its distance: half of a double's digits, 2⁻²⁶. A ray that is nearly parallel to a plane may meet
/// it anywhere, and then what is near the hit cannot be told from where it was computed to be.
pub(crate) const SLIDE: f64 = 134_217_728.0 * UNIT;

/// A ray that rises less than this along a normal is so nearly parallel to the plane that borders are
/// decided *in* the plane: half of a double's digits, 2⁻²⁶. A border is a line that lies off its
/// plane by a rounding, and beside a line in space a ray passes where it passes beside its image in the
/// plane but for that rounding divided by the slope; see [`WIDEN`].
pub(crate) const GRAZING: f64 = 134_217_728.0 * UNIT;

/// How far outside of its corners a flat surface can be met, in units of the lengths of its box:
/// 2⁻²⁰. Borders lie off the plane by `EXTENT` of the size at most, which is an eighth of this when
/// divided by [`GRAZING`]; the rest is for corners that are twice as far away as they are wide.
pub(crate) const WIDEN: f64 = 8_589_934_592.0 * UNIT;

/// A slab `(face − o)/d` of a box, in units of the size of `o` and of the faces: two roundings in `o`,
/// two in a face, one for moving it outward, one each for the difference, the reciprocal and the
/// product, each of which is as good as moving the face: 8 for each of the two. And 8 more, because
/// the start of a ray may be that far beyond a plane ([`HEIGHT`]) and still before it.
pub(crate) const SLAB: f64 = 32.0 * UNIT;

/// How far a ray that is said to meet a surface can pass by the points around it, in units of the sum of
/// all lengths that went into both and the angle between them: 16 for the corners of surfaces that share
/// their planes and borders, twice that where two borders meet, 9 for the border and 8 for the ray's
/// direction; and an eighth of the whole, which no hit exceeds that is not met at a small angle, for
/// how far the ray's start may be off.
pub(crate) const SHADE: f64 = 16_384.0 * UNIT;

/// How far a ball has to be outside of a cone of directions, as an angle in radians, to be said to be: 2⁻²⁰.
///
/// Places are off by less than 64 roundings of their size: corners by 16, and two more for a middle and a
/// difference. Where that is not below a sixteenth of this margin, in units of the distance, nothing is
/// said. So the centre is off by 1/16 of the margin. The half-angle is the arc sine of a quotient below 0.9,
/// whose derivative is below 2.3; radius and distance put that quotient off by 1.9/16 and it by 0.28 of
/// the margin. Together that is 0.34, and twice that if the cone is one around a ball, too. A cosine that
/// is off by 8 u puts its angle off by 4 √u at most, which is 0.05, once for the arc cosine and once
/// for a light's own cone. All together it is less than 0.8 of the margin.
pub(crate) const APART: f64 = 8_589_934_592.0 * UNIT;

/// `|c|² − r²` of a ball, in units of `size² + r²`: two roundings in each component of `c`, a product and
/// two sums, and a difference.
pub(crate) const BALL_SIDE: f64 = 16.0 * UNIT;

/// A rounded value of the occlusion tests, in units of the sizes that it is made of: 2⁻⁴³.
///
/// Corners, hit points and points of a lamp are off by 16 roundings of their size at most. A product of
/// three differences of them is off by three times two of these and 11 more; that is far less. A ray whose
/// direction is rounded passes a corner of a lamp as if that were moved by a few roundings of the whole
/// distance. A larger bound only makes more tests.
pub(crate) const OCCLUSION: f64 = 1024.0 * UNIT;

/// Six times the volume of a tetrahedron, in units of products of its corners' sizes.
///
/// Each difference, product and sum is rounded once, 11 on the longest path; corners may be rounded too,
/// and points that are computed on a surface lie off it by 16 roundings. The rounded direction of a ray
/// moves its end by a few roundings of the whole distance.
pub(crate) const VOLUME: f64 = 128.0 * UNIT;

/// The error of a segment's crossing of an occluder's plane, in units of all sizes: far above what start,
/// direction and plane add.
pub(crate) const CROSSING_HEIGHT: f64 = 64.0 * UNIT;
