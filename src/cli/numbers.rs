//! Numbers on the command line.

/// A reader of whole numbers from 1 to `most`, which tells that they are expected.
pub(super) fn whole(most: u32) -> impl Fn(&str) -> Result<u32, String> + Clone + Send + Sync {
    move |text| {
        let number = text.trim().parse().ok();
        let number = number.filter(|number| (1..=most).contains(number));
        number.ok_or_else(|| format!("expected a whole number from 1 to {most}"))
    }
}
