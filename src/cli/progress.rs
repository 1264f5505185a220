//! Progress bar, on terminals only.

use std::fmt;
use std::io::IsTerminal;
use std::time::{Duration, Instant};

use indicatif::style::ProgressTracker;
use indicatif::{HumanDuration, ProgressBar, ProgressDrawTarget, ProgressState, ProgressStyle};

use super::messages::Messages;

/// A bar for a picture of this many rows; hidden if standard error is no terminal.
pub(super) fn bar(title: &str, rows: u64, messages: &Messages) -> ProgressBar {
    if messages.quiet || !std::io::stderr().is_terminal() {
        return ProgressBar::hidden();
    }
    let style = ProgressStyle::with_template("{msg} [{wide_bar}] {percent:>3} %{left}")
        .unwrap_or_else(|_| ProgressStyle::default_bar())
        .with_key("left", Left::default())
        .progress_chars("█▌ ");
    // A bar of length zero would be full, so a length that is not known yet is one.
    let length = Some(rows.max(1));
    let bar = ProgressBar::with_draw_target(length, ProgressDrawTarget::stderr_with_hz(10));
    bar.set_style(style);
    bar.set_message(title.to_owned());
    bar.enable_steady_tick(Duration::from_millis(200));
    bar
}

/// Shows that so many steps of so many are done.
pub(super) fn show(bar: &ProgressBar, done: usize, of: usize) {
    bar.set_length(of as u64);
    bar.set_position(done as u64);
}

/// Estimate of the time left.
///
/// The first step does not count, since it may be another kind of work, such as a reference. There is
/// no estimate until another step is done.
#[derive(Debug, Clone, Copy, Default)]
struct Left {
    first: Option<(Instant, u64)>,
    left: Option<Duration>,
}

impl Left {
    fn note(&mut self, done: u64, of: u64, now: Instant) {
        let (start, first) = match self.first {
            Some(first) => first,
            None if done == 0 => return,
            None => *self.first.insert((now, done)),
        };
        let rest = of.saturating_sub(done);
        #[expect(clippy::cast_precision_loss, reason = "far below 2^53")]
        let each = |steps: u64| rest as f64 / steps as f64;
        let steps = done.checked_sub(first).filter(|steps| *steps > 0);
        let left = steps.map(|steps| now.duration_since(start).as_secs_f64() * each(steps));
        self.left = left.and_then(|left| Duration::try_from_secs_f64(left).ok());
    }
}

impl ProgressTracker for Left {
    fn clone_box(&self) -> Box<dyn ProgressTracker> {
        Box::new(*self)
    }

    fn tick(&mut self, state: &ProgressState, now: Instant) {
        self.note(state.pos(), state.len().unwrap_or(0), now);
    }

    fn reset(&mut self, _state: &ProgressState, _now: Instant) {
        *self = Self::default();
    }

    fn write(&self, _state: &ProgressState, out: &mut dyn fmt::Write) {
        if let Some(left) = self.left {
            // The bar is useful without it as well.
            let _ = write!(out, "  {:#} left", HumanDuration(left));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_time_left_is_shown_once_it_is_known_and_without_the_first_step() {
        let start = Instant::now();
        let mut left = Left::default();
        for (seconds, done, expected) in [
            (0, 0, None),
            // The reference takes a minute, and each setting half a second.
            (59, 0, None),
            (60, 2, None),
            (61, 4, Some(2.0)),
            (62, 6, Some(1.0)),
            (63, 8, Some(0.0)),
        ] {
            left.note(done, 8, start + Duration::from_secs(seconds));
            assert_eq!(left.left.map(|it| it.as_secs_f64()), expected, "{seconds}");
        }
    }
}
