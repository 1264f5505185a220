//! The course's entities as data.

use super::words::{Entity, Role, Word};
use crate::camera::View;
use crate::language::{Range, Takes};
use crate::light::{Cone, Light, Slide};
use crate::material::Material;
use crate::scene::RenderSettings;
use crate::surface::{Plain, ProceduralPlane, Textured, TiledPlane};
use crate::texture::Texture;

/// The supported entities.
pub(super) const ENTITIES: &[Entity] = &[
    Entity::new("camera", &View::SCHEMA, &[CAMERA]),
    Entity::new("material", &Material::SCHEMA, &[MATERIAL]),
    Entity::new("light", &Light::SCHEMA, &[LIGHT]),
    Entity::new("spotlight", &Cone::SCHEMA, &[LIGHT, CONE]),
    Entity::new(
        "projector",
        &Slide::SCHEMA,
        &[LIGHT, PLANE, XDIR, SIZE, IMAGE],
    ),
    Entity::new("texture", &Texture::SCHEMA, &[FILE]),
    Entity::new("plane", &Plain::PLANE, &[SURFACE, PLANE]),
    Entity::new(
        "fplane",
        &Plain::FINITE_PLANE,
        &[SURFACE, PLANE, XDIR, SIZE],
    ),
    Entity::new(
        "tiled_plane",
        &TiledPlane::SCHEMA,
        &[SURFACE, TILES, PLANE, SIZE],
    ),
    Entity::new(
        "texplane",
        &Textured::PLANE,
        &[SURFACE, PLANE, XDIR, SIZE, IMAGE],
    ),
    Entity::new("sphere", &Plain::ELLIPSOID, &[SURFACE, ROUND]).without("scale", &Plain::SPHERE),
    Entity::new("ellipsoid", &Plain::ELLIPSOID, &[SURFACE, ROUND]).without("scale", &Plain::SPHERE),
    Entity::new("triangle", &Plain::TRIANGLE, &[SURFACE, CORNERS]),
    Entity::new("tri", &Plain::TRIANGLE, &[SURFACE, CORNERS]),
    Entity::new(
        "pplane",
        &ProceduralPlane::SCHEMA,
        &[SURFACE, PLANE, SHADER],
    )
    .without("shader", &Plain::PLANE),
];

/// The supported entity with this word.
pub(super) fn find(word: &str) -> Option<&'static Entity> {
    ENTITIES.iter().find(|entity| entity.word == word)
}

/// The entities that are not supported, and a substitute for each.
pub(super) const UNSUPPORTED: &[(&str, &str)] = &[
    ("psphere", "a plain `sphere`"),
    ("pfplane", "a plain `fplane`"),
    ("hplane", "an `fplane`, which has no holes,"),
    ("revsurf", "one or more `ellipsoid`s"),
    ("cylinder", "several `fplane`s"),
    ("cone", "several `triangle`s"),
];

const CAMERA: &[Word] = &[
    Word::new("pixeldim")
        .means("size")
        .role(Role::PictureSize)
        .takes_a(match RenderSettings::SCHEMA.value {
            Some(size) => size.takes,
            None => Takes::Nothing,
        }),
    Word::new("worlddim").means("screen"),
    Word::new("viewpoint"),
];

/// Colours have three numbers. Some courses had one number for `specular`.
const MATERIAL: &[Word] = &[
    Word::new("ambient").takes_a(Takes::Triple).optional(),
    Word::new("diffuse").takes_a(Takes::Triple).optional(),
    Word::new("specular").optional(),
    Word::new("shininess").optional(),
    Word::new("transparency").optional(),
];

const LIGHT: &[Word] = &[
    Word::new("location"),
    Word::new("emissivity").takes_a(Takes::Triple),
];

const CONE: &[Word] = &[Word::new("point"), Word::new("theta")];

const FILE: &[Word] = &[Word::new("filename")
    .means("file")
    .role(Role::File)
    .takes_a(Takes::Path)];

const SURFACE: &[Word] = &[Word::new("material")];

const PLANE: &[Word] = &[Word::new("normal"), Word::new("point")];

const XDIR: &[Word] = &[Word::new("xdir")];

const SIZE: &[Word] = &[
    Word::new("dimensions"),
    Word::new("dimension").means("dimensions").optional(),
];

const TILES: &[Word] = &[
    Word::new("altmaterial").means("alternate"),
    Word::new("xdir").optional(),
];

const IMAGE: &[Word] = &[
    Word::new("texname").means("texture").role(Role::Texture),
    Word::new("mode")
        .role(Role::Mode)
        .takes_a(Takes::Number(Range::Whole(0, 1))),
];

const ROUND: &[Word] = &[
    Word::new("center"),
    Word::new("radius"),
    Word::new("scale").optional(),
];

/// In some courses triangles were planes and had a plane's attributes.
const CORNERS: &[Word] = &[
    Word::new("vertex1"),
    Word::new("vertex2"),
    Word::new("vertex3"),
    Word::new("normal")
        .role(Role::Ignored)
        .takes_a(Takes::Triple)
        .optional(),
    Word::new("point")
        .role(Role::Ignored)
        .takes_a(Takes::Triple)
        .optional(),
    Word::new("xdir")
        .role(Role::Ignored)
        .takes_a(Takes::Triple)
        .optional(),
];

const SHADER: &[Word] = &[
    Word::new("shader").role(Role::Shader).takes_a(PROCEDURE),
    Word::new("procedure")
        .means("shader")
        .role(Role::Shader)
        .takes_a(PROCEDURE)
        .optional(),
];

/// The numbers of formulas differed between programs.
const PROCEDURE: Takes = Takes::Number(Range::Whole(0, u32::MAX));

#[cfg(test)]
mod tests {
    use super::*;
    use crate::language::Default;

    #[test]
    fn every_word_has_a_type_and_every_attribute_is_in_its_schema() {
        for entity in ENTITIES {
            for word in entity.words() {
                assert_ne!(word.takes(entity), Takes::Nothing, "{entity:?} {word:?}");
                let known = entity
                    .schema
                    .all_attributes()
                    .any(|known| known.word == word.means);
                assert!(
                    known || word.role != Role::Attribute,
                    "{} {}",
                    entity.word,
                    word.word
                );
            }
        }
    }

    #[test]
    fn everything_that_a_node_requires_is_needed() {
        for entity in ENTITIES {
            for known in entity.schema.all_attributes() {
                let required = known.default == Default::Required;
                let given = entity.words().any(|word| word.means == known.word);
                assert!(given || !required, "{} {}", entity.word, known.word);
            }
        }
    }
}
