//! Words for the formats of pictures and the languages of scenes.

use clap::ValueEnum;

use crate::film::Format;
use crate::read::Language;

/// A format of pictures or a language of scenes.
#[derive(Debug, Clone, Copy, ValueEnum)]
pub(super) enum FormatWord {
    /// Picture: PNG with 8 bits per channel.
    Png,
    /// Picture: PNG with 16 bits per channel.
    Png16,
    /// Picture: binary PPM (P6).
    Ppm,
    /// Picture: 32-bit floats, linear and unclamped.
    Pfm,
    /// Scene: KDL.
    Kdl,
    /// Scene: the course's block grammar.
    Course,
}

/// A language of scenes.
#[derive(Debug, Clone, Copy, ValueEnum)]
pub(super) enum LanguageWord {
    /// KDL.
    Kdl,
    /// The course's block grammar.
    Course,
}

impl FormatWord {
    pub(super) fn picture(self) -> Option<Format> {
        match self {
            Self::Png => Some(Format::Png8),
            Self::Png16 => Some(Format::Png16),
            Self::Ppm => Some(Format::Ppm),
            Self::Pfm => Some(Format::Pfm),
            Self::Kdl | Self::Course => None,
        }
    }

    pub(super) fn language(self) -> Option<Language> {
        match self {
            Self::Kdl => Some(Language::Kdl),
            Self::Course => Some(Language::Course),
            _ => None,
        }
    }
}

impl LanguageWord {
    pub(super) fn language(self) -> Language {
        match self {
            Self::Kdl => Language::Kdl,
            Self::Course => Language::Course,
        }
    }
}
