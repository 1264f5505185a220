//! Options that override the scene's picture settings: its size, and one for each row of the table.

use clap::builder::{PossibleValuesParser, StringValueParser, TypedValueParser, ValueParser};
use clap::{Arg, ArgMatches, Args, Command, Error, FromArgMatches};

use super::numbers::separated;
use crate::film::BitDepth;
use crate::language::{Range, Takes};
use crate::read;
use crate::scene::{RenderSettings, SETTINGS, Setting, SettingKind};

/// The heading of these options in the help.
const HEADING: &str = "Picture settings, instead of those of the scene";

/// Values of the `image` node that the command line gives.
#[derive(Debug, Clone)]
pub(super) struct SettingOptions {
    size: Option<[u32; 2]>,
    settings: Vec<Setting>,
}

impl SettingOptions {
    /// The depth, if it is given.
    pub(super) fn depth(&self) -> Option<BitDepth> {
        let depth = self.settings.iter().find(|it| it.word() == "depth")?;
        BitDepth::from_word(depth.value().text())
    }

    /// The reader's options with these settings.
    pub(super) fn added_to(&self, options: read::Options) -> read::Options {
        read::Options {
            size: self.size,
            settings: self.settings.clone(),
            ..options
        }
    }
}

impl Args for SettingOptions {
    fn augment_args(command: Command) -> Command {
        let size = Arg::new("size")
            .long("size")
            .value_name("WxH")
            .allow_hyphen_values(true)
            .value_parser(size)
            .help("Width and height in pixels, such as 800x600");
        let settings = SETTINGS.iter().map(option);
        command.next_help_heading(HEADING).arg(size).args(settings)
    }

    fn augment_args_for_update(command: Command) -> Command {
        Self::augment_args(command)
    }
}

impl FromArgMatches for SettingOptions {
    fn from_arg_matches(matches: &ArgMatches) -> Result<Self, Error> {
        let given = SETTINGS.iter().filter_map(|it| matches.get_one(it.word));
        Ok(Self {
            size: matches.get_one("size").copied(),
            settings: given.cloned().collect(),
        })
    }

    fn update_from_arg_matches(&mut self, matches: &ArgMatches) -> Result<(), Error> {
        *self = Self::from_arg_matches(matches)?;
        Ok(())
    }
}

/// The option of a setting: `-h` shows what it is about up to the first colon or semicolon.
fn option(kind: &'static SettingKind) -> Arg {
    let parsed = move |text: String| Setting::new(kind.word, &text);
    let (value_name, parser) = match kind.takes {
        Takes::Word(words) => {
            let parser = PossibleValuesParser::new(words).try_map(parsed);
            ("WORD", ValueParser::new(parser))
        }
        takes => {
            let is_count = matches!(takes, Takes::Number(Range::Whole(..)));
            let parser = StringValueParser::new().try_map(parsed);
            (if is_count { "N" } else { "X" }, ValueParser::new(parser))
        }
    };
    let (first, rest) = kind.about.split_at(1);
    let about = first.to_uppercase() + rest;
    let expected = match kind.takes {
        Takes::Word(_) => String::new(),
        _ => format!(" [{}]", kind.expected().trim_start_matches("a ")),
    };
    let short = about.split([':', ';']).next().unwrap_or_default();
    Arg::new(kind.word)
        .long(kind.word)
        .value_name(value_name)
        .allow_hyphen_values(!matches!(kind.takes, Takes::Word(_)))
        .value_parser(parser)
        .help(format!("{short}{expected}"))
        .long_help(format!("{about}{expected}"))
}

/// A width and a height from `800x600`.
fn size(text: &str) -> Result<[u32; 2], String> {
    let sides = separated(text, &['x', 'X', '×']).ok_or_else(|| {
        let longest = RenderSettings::LONGEST_SIDE;
        format!("expected width and height from 1 to {longest}, such as 800x600")
    })?;
    RenderSettings::check_size(sides).map_err(|error| error.reason)?;
    Ok(sides)
}
