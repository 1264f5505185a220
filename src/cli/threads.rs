//! The threads that render.

use clap::Args;

use super::numbers::whole;
use crate::render;

/// How many threads render.
#[derive(Debug, Clone, Copy, Args)]
pub(super) struct Threads {
    /// Threads to render with; all processors if not given.
    #[arg(long, value_name = "N", allow_hyphen_values = true, value_parser = whole(1024))]
    threads: Option<u32>,
}

impl Threads {
    /// As many as there are processors.
    pub(super) const ALL: Self = Self { threads: None };

    /// The threads.
    pub(super) fn pool(self) -> Result<rayon::ThreadPool, String> {
        let threads = self.threads.map_or(0, |threads| threads as usize);
        let builder = rayon::ThreadPoolBuilder::new().num_threads(threads);
        let pool = builder.stack_size(render::STACK).build();
        pool.map_err(|error| format!("cannot start {threads} threads: {error}"))
    }
}
