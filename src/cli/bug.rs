//! Reports of bugs in the program.

use std::backtrace::Backtrace;
use std::io::Write;
use std::panic::{self, AssertUnwindSafe};
use std::path::PathBuf;

use super::Status;

/// Explains panics from now on, and saves a report of each.
pub(super) fn report_panics() {
    panic::set_hook(Box::new(|panic| {
        let report = format!(
            "heliodon {}\narguments: {:?}\n{panic}\n{}\n",
            env!("CARGO_PKG_VERSION"),
            std::env::args().collect::<Vec<_>>(),
            Backtrace::force_capture(),
        );
        // If standard error is closed, there is no place for a message.
        let mut err = std::io::stderr().lock();
        let _ = writeln!(
            err,
            "This is a bug in heliodon, not a mistake of yours: {panic}"
        );
        if let Some(path) = save(&report) {
            let _ = writeln!(
                err,
                "A report that helps to fix it is in {}",
                path.display()
            );
        }
    }));
}

/// Runs a command; a panic ends it with an exit code of its own.
pub(super) fn guard(command: impl FnOnce() -> Status) -> Status {
    panic::catch_unwind(AssertUnwindSafe(command)).unwrap_or(Status::Bug)
}

fn save(report: &str) -> Option<PathBuf> {
    let mut file = tempfile::Builder::new()
        .prefix("heliodon-bug-")
        .suffix(".txt")
        .tempfile()
        .ok()?;
    file.write_all(report.as_bytes()).ok()?;
    file.into_temp_path().keep().ok()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_panic_becomes_an_exit_code() {
        assert_eq!(guard(|| panic!("on purpose")), Status::Bug);
        assert_eq!(Status::Bug.code(), 70);
    }
}
