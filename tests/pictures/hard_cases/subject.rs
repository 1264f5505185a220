//! The program under test: the only file here that knows how Heliodon is called.

pub(crate) use heliodon::film::{Encoding, Rounding, Transfer};
use heliodon::film::{Film, Region};
use heliodon::geometry::Hit;
use heliodon::language::{Node, render_diagnostics};
use heliodon::math::{Numerics, Point, Ray, Span, unit};
use heliodon::measure::check;
use heliodon::plan::{Plan, Scope};
use heliodon::read::{Options, SceneError, read_bytes};
use heliodon::render::{Counts, Render, render};
use heliodon::scene::{Scene, Setting};
use heliodon::surface::Surface;
use heliodon::visibility::{Accelerator, Primitive, SurfaceList};

use super::cases;

/// A way to compute.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum BackEnd {
    /// The default: every yes/no is decided exactly.
    Robust,
    /// The chapter's own algorithm in doubles.
    Classic,
    /// The same in single precision.
    ClassicF32,
}

impl BackEnd {
    /// All of them, in the order of the table.
    pub(crate) const ALL: [Self; 3] = [Self::Robust, Self::Classic, Self::ClassicF32];

    /// Its word in the scene language, in the table and in case files.
    pub(crate) fn word(self) -> &'static str {
        match self {
            Self::Robust => "robust",
            Self::Classic => "classic",
            Self::ClassicF32 => "classic-f32",
        }
    }

    pub(crate) fn numerics(self) -> Numerics {
        match self {
            Self::Robust => Numerics::Robust,
            Self::Classic => Numerics::Classic,
            Self::ClassicF32 => Numerics::ClassicF32,
        }
    }

    fn options(self) -> Options {
        Options {
            settings: vec![Setting::new("numerics", self.numerics().word()).expect("a setting")],
            ..Options::default()
        }
    }
}

/// A scene as a back end has read it.
///
/// Scenes and what is made of them live until the test ends, which saves them from owning each other.
#[derive(Debug)]
pub(crate) struct Subject {
    scene: &'static Scene,
    numerics: Numerics,
}

/// Why a scene is refused.
#[derive(Debug)]
pub(crate) struct OutputError {
    /// Everything that is said: message, place, advice.
    pub(crate) said: String,
    /// Whether a line of the file is pointed at.
    pub(crate) has_place: bool,
}

/// Where a ray first meets a surface.
#[derive(Debug)]
pub(crate) struct Met {
    entry: Primitive<'static>,
    hit: Hit,
}

/// A scene ready to be asked about rays.
#[derive(Debug)]
pub(crate) struct Stage {
    list: SurfaceList<'static>,
    /// The same surfaces in a tree of boxes, if the numerics allow for it.
    tree: Option<SurfaceList<'static>>,
}

impl Subject {
    /// Reads a whole scene.
    pub(crate) fn read(back_end: BackEnd, text: &str) -> Result<Self, OutputError> {
        let read = read_bytes(
            "scene.kdl",
            text.into(),
            cases::folder(),
            &back_end.options(),
        );
        read.map(|reading| {
            let scene: &'static Scene = Box::leak(Box::new(reading.scene));
            let numerics = back_end.numerics();
            Self { scene, numerics }
        })
        .map_err(|scene_error| OutputError::from(&scene_error))
    }

    /// The scene as nodes of the scene language.
    pub(crate) fn nodes(&self) -> Vec<Node> {
        self.scene.describe()
    }

    /// The surfaces as nodes of the scene language.
    pub(crate) fn surfaces(&self) -> Vec<Node> {
        let surfaces = self.scene.surfaces.iter();
        surfaces
            .map(|surface| surface.common().describe(surface.describe()))
            .collect()
    }

    /// What is odd about the scene.
    pub(crate) fn warnings(&self) -> String {
        render_diagnostics(&check(self.scene), &self.scene.sources, false, 100)
    }

    /// The scene ready to be asked about rays.
    pub(crate) fn stage(&self) -> Stage {
        let surfaces = &self.scene.surfaces;
        Stage {
            tree: (self.numerics == Numerics::Robust)
                .then(|| SurfaceList::with(surfaces, Accelerator::Tree)),
            list: match self.numerics {
                Numerics::Robust => SurfaceList::with(surfaces, Accelerator::List),
                Numerics::Classic | Numerics::ClassicF32 => {
                    SurfaceList::classic(surfaces, self.numerics)
                }
            },
        }
    }

    /// The picture, and how many rays it took.
    pub(crate) fn picture(&self) -> Result<(Film, Counts), String> {
        render(self.scene, &|_| ()).map_err(|error| error.reason.to_string())
    }

    /// A part of the picture, from its upper left pixel to before its lower right one.
    pub(crate) fn part(&self, from: [usize; 2], to: [usize; 2]) -> Result<Film, String> {
        let corners = [from, to].map(|corner| corner.map(|side| u32::try_from(side).unwrap()));
        Region::between(corners[0], corners[1])
            .and_then(|part| Render::new(self.scene).part(part).film::<Counts>())
            .map(|(film, _)| film)
            .map_err(|error| error.reason.to_string())
    }

    /// The picture with surfaces found in this way, and nothing left out.
    pub(crate) fn picture_by(&self, accelerator: Accelerator) -> Result<Film, String> {
        Plan::with(self.scene, Scope::Everything, accelerator)
            .and_then(|plan| Render::new(self.scene).planned::<Counts>(&plan))
            .map(|(film, _)| film)
            .map_err(|error| error.reason.to_string())
    }
}

impl From<&SceneError> for OutputError {
    fn from(scene_error: &SceneError) -> Self {
        Self {
            said: render_diagnostics(&scene_error.diagnostics, &scene_error.sources, false, 100),
            has_place: scene_error
                .diagnostics
                .iter()
                .any(|problem| problem.place.is_some()),
        }
    }
}

/// A ray that starts in free space, in a direction of any length.
pub(crate) fn ray(origin: [f64; 3], direction: [f64; 3]) -> Ray<'static> {
    let unit = unit(direction.into()).unwrap_or_else(|| panic!("{direction:?} is no direction"));
    Ray::new(Point::exact(origin.into()), unit)
}

/// The code value from 0 to the largest that an intensity becomes.
pub(crate) fn code(intensity: f64, encoding: Encoding, largest: u16) -> u16 {
    encoding.code(intensity, largest)
}

impl Stage {
    /// The surface that a ray meets first.
    pub(crate) fn first(&self, ray: &Ray<'static>) -> Option<Met> {
        let found = self.list.nearest(ray, Span::AHEAD, &mut 0);
        if let Some(tree) = &self.tree {
            let of_list = found.map(|(entry, hit)| (entry.index, hit));
            let of_tree = tree.nearest(ray, Span::AHEAD, &mut 0);
            let of_tree = of_tree.map(|(entry, hit)| (entry.index, hit));
            assert_eq!(of_tree, of_list, "the tree and the list differ");
        }
        let (entry, hit) = found?;
        let hit = hit.resolved(entry.resolve(&hit, ray));
        Some(Met { entry: *entry, hit })
    }

    /// The names of all surfaces that a ray meets, each asked by itself.
    pub(crate) fn every(&self, ray: &Ray<'static>) -> Vec<&'static str> {
        let primitives = self.list.primitives().iter();
        let hit = primitives.filter(|it| it.hits(ray, Span::AHEAD).is_some());
        hit.map(|it| name(it.surface)).collect()
    }
}

fn name(surface: &dyn Surface) -> &str {
    surface.common().name.as_deref().unwrap_or("(unnamed)")
}

impl Met {
    /// The surface's name.
    pub(crate) fn name(&self) -> &str {
        name(self.entry.surface)
    }

    /// The distance.
    pub(crate) fn t(&self) -> f64 {
        self.hit.t
    }

    /// The unit normal.
    pub(crate) fn normal(&self) -> [f64; 3] {
        self.hit.normal.to_array()
    }

    /// The ambient colour.
    pub(crate) fn color(&self) -> [f64; 3] {
        self.entry.surface.getamb(&self.hit).channels()
    }

    /// Column and row of the texel, in the textures of the suite.
    pub(crate) fn texel(&self) -> [f64; 2] {
        let [column, row, _] = self.hit.texel.channels();
        [column, row].map(|channel| channel * 255.0)
    }

    /// The ray that is mirrored here.
    pub(crate) fn mirrored(&self, ray: &Ray<'static>) -> Ray<'static> {
        let direction = ray.mirrored(self.hit.normal);
        let arriving: &'static Ray<'static> = Box::leak(Box::new(*ray));
        let ray_origin = self.entry.ray_origin(arriving, &self.hit);
        Ray::spawn(Box::leak(Box::new(ray_origin)), direction)
    }
}
