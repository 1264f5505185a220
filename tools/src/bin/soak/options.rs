//! The command line of the soak program.

use clap::{Parser, ValueEnum};

use oracle::tally::Tally;

/// Sends rays in any number and checks what they meet; ends with exit code 1 if anything is not as
/// exact arithmetic has it.
///
/// Rays come in blocks of 65536 with a scene or two each; every block is a function of the seed and
/// of its number, so a run can be continued where another ended.
#[derive(Debug, Parser)]
#[command(name = "soak")]
pub(crate) struct Options {
    /// What to send.
    #[arg(long, value_enum)]
    pub(crate) kind: Kind,
    /// How many rays; rounded up to whole blocks.
    #[arg(long, default_value_t = 1 << 20)]
    pub(crate) rays: u64,
    /// The seed of all random numbers.
    #[arg(long, default_value_t = 1)]
    pub(crate) seed: u64,
    /// The ray to start with, as the last line of an earlier run says.
    #[arg(long, default_value_t = 0)]
    pub(crate) from: u64,
    /// How many threads; 0 for one per core.
    #[arg(long, default_value_t = 0)]
    pub(crate) threads: usize,
}

/// The kinds of rays.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(crate) enum Kind {
    /// Aimed at shared edges, corners and T-junctions of tiles: exactly one tile is met.
    Edges,
    /// From inside of closed rooms of planes and of tiles, at their edges and corners: none leaks.
    Rooms,
    /// From mirror to mirror and through panes, in rooms from 2^-200 to 2^200: none meets the
    /// sheet that it leaves, or a wall from behind.
    Bounces,
    /// At surfaces of every kind, decided by production and by rational numbers: hits, sides,
    /// order and shadows.
    Oracle,
    /// At spheres and ellipsoids as far away as 1e10 radii and with axes 1e6 times as long as
    /// others, against rational numbers.
    Spheres,
    /// In any direction from anywhere at one surface of any kind: how many cannot be decided by
    /// rounded values.
    Random,
}

impl Options {
    /// What is printed about a run: one line.
    pub(crate) fn line(&self, tally: &Tally, next: u64, seconds: f64) -> String {
        let kind = self.kind.to_possible_value();
        let kind = kind.as_ref().map_or("", |kind| kind.get_name());
        let Tally {
            cases,
            positive,
            none,
            several,
            leaks,
            self_hits,
            exactly,
            by_rule,
            mismatches,
            ..
        } = tally;
        #[expect(clippy::cast_precision_loss, reason = "a rate for people")]
        let rate = *cases as f64 / seconds / 1e6;
        // What "met" counts is the one tile, the wall, or any surface.
        format!(
            "{kind} seed={} rays={cases} met={positive} none={none} several={several} \
             leaks={leaks} self-hits={self_hits} exactly={exactly} ties={by_rule} \
             mismatches={mismatches} next: --seed {} --from {next} ({rate:.2} million rays/s)",
            self.seed, self.seed
        )
    }
}
