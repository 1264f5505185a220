//! The processor's time of other programs.

use std::error::Error;
use std::process::{Command, Stdio};

use nix::sys::resource::{UsageWho, getrusage};

/// User and system time, in seconds, of a command that runs to its end; what it prints goes nowhere.
///
/// # Errors
/// If it cannot be started, or fails.
pub(crate) fn seconds(command: &mut Command) -> Result<f64, Box<dyn Error>> {
    let used = || {
        let usage = getrusage(UsageWho::RUSAGE_CHILDREN)?;
        let times = [usage.user_time(), usage.system_time()];
        let micros = times.map(|time| time.tv_sec() * 1_000_000 + time.tv_usec());
        Ok::<_, nix::Error>(micros.iter().sum::<i64>())
    };
    let before = used()?;
    let quiet = command.stdout(Stdio::null()).stderr(Stdio::null());
    if !quiet.status()?.success() {
        return Err(format!("{command:?} failed").into());
    }
    Ok((used()? - before) as f64 / 1e6)
}

/// The middle one of some numbers; of an even count, the upper one of the two.
pub(crate) fn median(values: impl Iterator<Item = f64>) -> f64 {
    let mut values: Vec<_> = values.collect();
    values.sort_by(f64::total_cmp);
    values[values.len() / 2]
}
