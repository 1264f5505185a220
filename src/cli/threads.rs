//! The threads that render.

use clap::Args;

use crate::render;

/// How many threads render.
#[derive(Debug, Clone, Copy, Args)]
pub(super) struct Threads {
    /// Threads to render with; all processors if not given.
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..=1024))]
    threads: Option<u16>,
}

impl Threads {
    /// As many as there are processors.
    pub(super) const ALL: Self = Self { threads: None };

    /// The threads.
    pub(super) fn pool(self) -> Result<rayon::ThreadPool, String> {
        let threads = self.threads.map_or(0, usize::from);
        let builder = rayon::ThreadPoolBuilder::new().num_threads(threads);
        let pool = builder.stack_size(render::STACK).build();
        pool.map_err(|error| format!("cannot start {threads} threads: {error}"))
    }
}
