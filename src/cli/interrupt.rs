//! Clean-up when the program is interrupted.

use std::thread;

use signal_hook::consts::{SIGINT, SIGTERM};
use signal_hook::iterator::Signals;
use signal_hook::low_level::emulate_default_handler;

use crate::film::discard_unfinished;

/// Removes half-written files on an interrupt; the program still ends by its signal.
pub(super) fn clean_up() {
    // The program works as well where signals cannot be caught.
    let Ok(mut signals) = Signals::new([SIGINT, SIGTERM]) else {
        return;
    };
    thread::spawn(move || {
        for signal in signals.forever() {
            discard_unfinished();
            // It ends the program; an error has no place to go.
            let _ = emulate_default_handler(signal);
        }
    });
}
