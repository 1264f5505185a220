//! The media that a path is inside of, and their boundaries.

use glam::DVec3;

use crate::material::Material;
use crate::math::{Refraction, Rgb};

use super::Scattering;

/// The media that a path is inside of: a linked list on the stack of the recursion.
///
/// A point belongs to the medium that was entered last and not left since. So a bubble in glass in
/// water is three surfaces, which may overlap. Media of equal index of refraction count as the same
/// medium.
#[derive(Debug, Clone, Copy)]
pub(super) enum Media<'a> {
    /// Air only.
    Air,
    /// The path has entered a medium of this index.
    Entered { index: f64, before: &'a Self },
    /// The path has left a medium of this index, before one that it entered later.
    Left { index: f64, before: &'a Self },
}

/// The split of a ray at a surface: reflected and passing shares.
#[derive(Debug, Clone, Copy)]
pub(super) struct Boundary<'a> {
    /// The reflected share, by channel.
    pub(super) mirrored: Rgb,
    /// The share that remains for the surface's own colour and the transmitted ray.
    pub(super) passing: f64,
    /// The direction of the transmitted ray; `None` for total reflection.
    pub(super) onward: Option<DVec3>,
    /// The scattering of the transmitted ray.
    pub(super) scattering: Scattering,
    /// The media that the transmitted ray is inside of.
    pub(super) beyond: Media<'a>,
}

impl<'a> Media<'a> {
    /// The split of a ray at a surface; `dir` and `normal` are unit vectors.
    #[inline(always)]
    pub(super) fn boundary(
        &'a self,
        material: &Material,
        dir: DVec3,
        normal: DVec3,
    ) -> Boundary<'a> {
        match material.ior {
            None => Boundary {
                mirrored: material.specular,
                passing: 1.0,
                onward: Some(dir),
                scattering: Scattering::Straight,
                beyond: *self,
            },
            Some(index) => self.refracting(index, material.is_entered(), dir, normal),
        }
    }

    /// The [`boundary`](Self::boundary) of a medium with this index.
    ///
    /// A surface that is not entered has a clear coat on both sides.
    #[cold]
    fn refracting(&'a self, index: f64, entered: bool, dir: DVec3, normal: DVec3) -> Boundary<'a> {
        let enters = !entered || dir.dot(normal) < 0.0;
        let (from, beyond) = match (enters, self.nearest(index)) {
            (true, _) => (
                self.index(),
                Self::Entered {
                    index,
                    before: self,
                },
            ),
            (false, Some(_)) => (self.index(), self.without(index)),
            // The path started inside.
            (false, None) => (index, *self),
        };
        let into = beyond.index();
        let Refraction { reflectance, bent } = Refraction::new(dir, normal, from, into);
        Boundary {
            mirrored: Rgb::WHITE * reflectance,
            passing: 1.0 - reflectance,
            onward: bent,
            scattering: if from.to_bits() == into.to_bits() {
                Scattering::Straight
            } else {
                Scattering::Refracted(from / into)
            },
            beyond,
        }
    }

    /// The index of refraction of the current medium.
    fn index(&self) -> f64 {
        const AIR: f64 = 1.0;
        let mut here = self;
        loop {
            match here {
                Self::Air => return AIR,
                Self::Entered { index, before } => {
                    if self
                        .nearest(*index)
                        .is_some_and(|it| std::ptr::eq(it, here))
                    {
                        return *index;
                    }
                    here = before;
                }
                Self::Left { before, .. } => here = before,
            }
        }
    }

    /// The latest entry into a medium of this index that was not left since.
    fn nearest(&self, wanted: f64) -> Option<&Self> {
        let (mut here, mut left) = (self, 0);
        loop {
            match here {
                Self::Air => return None,
                Self::Entered { index, before } => {
                    if index.to_bits() == wanted.to_bits() {
                        if left == 0 {
                            return Some(here);
                        }
                        left -= 1;
                    }
                    here = before;
                }
                Self::Left { index, before } => {
                    left += u32::from(index.to_bits() == wanted.to_bits());
                    here = before;
                }
            }
        }
    }

    /// The media after leaving the nearest one of this index, which must exist.
    fn without(&'a self, wanted: f64) -> Self {
        match self {
            Self::Entered { index, before } if index.to_bits() == wanted.to_bits() => **before,
            _ => Self::Left {
                index: wanted,
                before: self,
            },
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_medium_entered_last_is_here() {
        let air = Media::Air;
        let enter = |index, before| Media::Entered { index, before };
        let water = enter(1.33, &air);
        let glass = enter(1.5, &water);
        let bubble = enter(1.0, &glass);
        let indices = [&air, &water, &glass, &bubble].map(Media::index);
        assert_eq!(
            indices.map(f64::to_bits),
            [1.0, 1.33, 1.5, 1.0].map(f64::to_bits)
        );
        // Out of the bubble and the glass again, in their order.
        let out = bubble.without(1.0);
        let back = out.without(1.5);
        assert!(matches!(
            back,
            Media::Entered {
                before: Media::Air,
                ..
            }
        ));
    }

    #[test]
    fn what_overlaps_is_left_in_any_order() {
        let air = Media::Air;
        let enter = |index, before| Media::Entered { index, before };
        let (glass, index) = (enter(1.5, &air), |media: &Media| media.index().to_bits());
        let both = enter(1.33, &glass);
        let water = both.without(1.5);
        assert_eq!(index(&water), 1.33f64.to_bits());
        assert!(water.nearest(1.5).is_none() && water.nearest(1.33).is_some());
        assert_eq!(index(&water.without(1.33)), 1.0f64.to_bits());
        // Entered anew after it was left, and twice.
        let anew = enter(1.5, &water);
        assert_eq!(index(&anew), 1.5f64.to_bits());
        assert_eq!(index(&anew.without(1.5)), 1.33f64.to_bits());
        let twice = enter(1.5, &both);
        assert_eq!(index(&twice), 1.5f64.to_bits());
        assert_eq!(index(&twice.without(1.33)), 1.5f64.to_bits());
        assert_eq!(index(&twice.without(1.5)), 1.33f64.to_bits());
    }
}
