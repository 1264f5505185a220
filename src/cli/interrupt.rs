//! What happens when someone stops the program.

use std::thread;

use signal_hook::consts::{SIGINT, SIGTERM};
use signal_hook::iterator::Signals;
use signal_hook::low_level::emulate_default_handler;

use crate::film::discard_unfinished;

/// From now on an interrupt leaves no half-written file; the program still ends by its signal.
pub(super) fn clean_up() {
    // Where signals cannot be caught, the program works as well without.
    let Ok(mut signals) = Signals::new([SIGINT, SIGTERM]) else {
        return;
    };
    thread::spawn(move || {
        for signal in signals.forever() {
            discard_unfinished();
            // It ends the program, so there is nobody to tell if it fails.
            let _ = emulate_default_handler(signal);
        }
    });
}
