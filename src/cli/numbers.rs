//! Whole numbers on the command line.

/// A parser of whole numbers from 1 to `most`; its errors state that range.
pub(super) fn whole(most: u32) -> impl Fn(&str) -> Result<u32, String> + Clone + Send + Sync {
    move |text| {
        let number = text.trim().parse().ok();
        let number = number.filter(|number| (1..=most).contains(number));
        number.ok_or_else(|| format!("expected a whole number from 1 to {most}"))
    }
}

/// The `N` whole numbers of a text, with one of these characters between them.
pub(super) fn separated<const N: usize>(text: &str, separators: &[char]) -> Option<[u32; N]> {
    let numbers = text.split(separators).map(|number| number.trim().parse());
    let numbers: Vec<u32> = numbers.collect::<Result<_, _>>().ok()?;
    numbers.try_into().ok()
}
