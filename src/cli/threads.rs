//! Threads that render.

use clap::Args;

use super::error::CommandError;
use super::numbers::whole;
use crate::render;

/// The option for the number of threads.
#[derive(Debug, Clone, Copy, Args)]
pub(super) struct Threads {
    /// Number of threads; one for each processor if not given.
    #[arg(long, value_name = "N", allow_hyphen_values = true, value_parser = whole(1024))]
    threads: Option<u32>,
}

impl Threads {
    /// One thread for each processor.
    pub(super) const ALL: Self = Self { threads: None };

    pub(super) fn pool(self) -> Result<rayon::ThreadPool, CommandError> {
        let threads = self.threads.map_or(0, |threads| threads as usize);
        let builder = rayon::ThreadPoolBuilder::new().num_threads(threads);
        let pool = builder.stack_size(render::STACK).build();
        pool.map_err(|error| CommandError::io(format!("cannot start {threads} threads: {error}")))
    }
}
