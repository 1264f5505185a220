//! Table of the picture's settings: the scene language, the command line and `cost` follow it.

use super::render_settings::whole;
use super::{RenderSettings, SettingKind};
use crate::camera::Pattern;
use crate::film::{BitDepth, Rounding, Transfer};
use crate::language::{Default, Range, Takes};
use crate::math::Numerics;
use crate::texture::Filter;

const DEFAULT: RenderSettings = RenderSettings::DEFAULT;

/// Settings of the `image` node, in the order in which a scene is described.
pub const SETTINGS: &[SettingKind] = &[
    SettingKind {
        word: "samples",
        takes: Takes::Number(Range::Whole(1, RenderSettings::MOST_SAMPLES)),
        default: Default::Number(DEFAULT.samples as f64),
        about: "rays through each pixel; a single ray goes through the centre",
        get: |it| f64::from(it.samples).into(),
        set: |it, value| it.samples = whole(value.number()),
        rank: 1,
        steps: &["1", "2", "3", "4", "6", "9", "16", "25"],
        by_reference: true,
        ..SettingKind::PLAIN
    },
    SettingKind {
        word: "pattern",
        takes: Takes::Word(&Pattern::WORDS),
        default: Default::Word(DEFAULT.pattern.word()),
        about: "placement of several rays in a pixel: `grid` at the centres of equal cells, \
                `stratified` at random in each cell, `sobol` in an Owen-scrambled Sobol sequence \
                that includes the points on lamps, `random` anywhere; `center` is for one ray",
        get: |it| it.pattern.word().into(),
        set: |it, value| it.pattern = Pattern::from_word(value.text()).unwrap_or(it.pattern),
        rank: 2,
        steps: &["random", "grid", "stratified", "sobol"],
        together_with: &[("samples", "16")],
        // The reference's halves have nothing in common only if they are stratified.
        best: Some("stratified"),
        by_reference: true,
        ..SettingKind::PLAIN
    },
    SettingKind {
        word: "max-error",
        takes: Takes::Number(Range::Between(0.0, 1.0)),
        default: Default::Number(DEFAULT.max_error),
        about: "target for each pixel's error, as a share of the largest code value: rays of a \
                Sobol sequence are added until the error is probably no larger; `samples` is then \
                the smallest number of rays, at least 4, and 4096 the largest; 0 is no target",
        get: |it| it.max_error.into(),
        set: |it, value| it.max_error = value.number(),
        rank: 3,
        // Smaller targets take more rays, and a reference of more samples still.
        steps: &["0.1", "0.05", "0.025"],
        best: Some("0"),
        by_reference: true,
        ..SettingKind::PLAIN
    },
    SettingKind {
        word: "transfer",
        takes: Takes::Word(&Transfer::WORDS),
        default: Default::Word(DEFAULT.transfer.word()),
        about: "curve from intensities to code values: `none`, as in the chapter, or `srgb`, which \
                screens expect; PFM files hold intensities and have no curve",
        get: |it| it.transfer.word().into(),
        set: |it, value| it.transfer = Transfer::from_word(value.text()).unwrap_or(it.transfer),
        // A matter of taste: no curve is more accurate than another.
        ..SettingKind::PLAIN
    },
    SettingKind {
        word: "depth",
        takes: Takes::Word(&BitDepth::WORDS),
        default: Default::Word(DEFAULT.depth.word()),
        about: "number format of the picture: code values of `8` or `16` bits, or intensities as \
                32-bit floats (`float`); an output name or a `--format` that implies another \
                depth takes precedence over the scene",
        get: |it| it.depth.word().into(),
        set: |it, value| it.depth = BitDepth::from_word(value.text()).unwrap_or(it.depth),
        rank: 7,
        steps: &["8", "16", "float"],
        in_writing: true,
        ..SettingKind::PLAIN
    },
    SettingKind {
        word: "quantize",
        takes: Takes::Word(&Rounding::WORDS),
        default: Default::Word(DEFAULT.rounding.word()),
        about: "rounding to code values: to the nearest one (`round`) or to the next lower one \
                (`truncate`)",
        get: |it| it.rounding.word().into(),
        set: |it, value| it.rounding = Rounding::from_word(value.text()).unwrap_or(it.rounding),
        rank: 8,
        steps: &["truncate", "round"],
        in_writing: true,
        ..SettingKind::PLAIN
    },
    SettingKind {
        word: "cut-off",
        takes: Takes::Number(Range::Between(0.0, 1.0)),
        default: Default::Number(DEFAULT.cut_off),
        about: "most that a pixel may lose because mirrored and transmitted rays are not followed \
                forever, as a share of the largest code value",
        get: |it| it.cut_off.into(),
        set: |it, value| it.cut_off = value.number(),
        rank: 5,
        steps: &["1", "0.25", "0.0625", "0.016", "0.004", "0.00098", "6e-5"],
        best: Some("0.00001"),
        ..SettingKind::PLAIN
    },
    SettingKind {
        word: "numerics",
        takes: Takes::Word(&Numerics::WORDS),
        default: Default::Word(DEFAULT.numerics.word()),
        about: "arithmetic that decides where rays hit surfaces: `robust` decides exactly, \
                `classic` and `classic-f32` are the chapter's own algorithm in 64 and 32 bits",
        get: |it| it.numerics.word().into(),
        set: |it, value| it.numerics = Numerics::from_word(value.text()).unwrap_or(it.numerics),
        rank: 6,
        steps: &["classic-f32", "classic", "robust"],
        best: Some("robust"),
        ..SettingKind::PLAIN
    },
    SettingKind {
        word: "texture-filter",
        takes: Takes::Word(&Filter::WORDS),
        default: Default::Word(DEFAULT.texture_filter.word()),
        about: "colour that a pixel takes from a texture: the texel in its middle (`nearest`), an \
                interpolation of four texels (`bilinear`), or a mean over the area that it covers, \
                approximate (`mipmap`, `anisotropic`) or exact (`exact`)",
        get: |it| it.texture_filter.word().into(),
        set: |it, value| {
            it.texture_filter = Filter::from_word(value.text()).unwrap_or(it.texture_filter);
        },
        rank: 4,
        steps: &["nearest", "bilinear", "mipmap", "anisotropic", "exact"],
        best: Some("exact"),
        ..SettingKind::PLAIN
    },
];
