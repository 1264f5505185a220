//! Questions about whole pictures.

use heliodon::film::Film;
use heliodon::math::Rgb;
use heliodon::visibility::Accelerator;

use super::cases::{self, Case, Node};
use super::floor::Floor;
use super::numbers::{exact, is_close, nearest, words};
use super::rays::Answer;
use super::scenes::{self, whole};
use super::subject::{BackEnd, Encoding, Subject, code};

/// The scene that a question is about.
pub(crate) fn subject(node: &Node, case: &Case, back_end: BackEnd) -> Result<Subject, String> {
    read(back_end, &whole(case.scene(node.get("in"))))
}

fn read(back_end: BackEnd, text: &str) -> Result<Subject, String> {
    Subject::read(back_end, text)
        .map_err(|refused| format!("the scene is refused:\n{}", refused.said))
}

/// `picture …`: what a picture shows, and how many rays it took.
pub(crate) fn picture(node: &Node, case: &Case, back_end: BackEnd) -> Answer {
    let (film, counts) = subject(node, case, back_end)?.picture()?;
    all_finite(&film)?;
    if let Some(color) = node.get("color") {
        let within = node.get("within").unwrap_or("8 ulp");
        let truth = words::<3>(color).map(exact);
        let is_true = |pixel: Rgb| {
            let mut pairs = pixel.channels().into_iter().zip(&truth);
            pairs.all(|(found, truth)| is_close(found, truth, within))
        };
        every(&film, &format!("expected {color}"), is_true)?;
    }
    if node.get("lit").is_some() {
        every(&film, "expected light", |pixel| pixel.max_channel() > 0.0)?;
    }
    if node.get("white").is_some() {
        every(&film, "expected white", |pixel| {
            pixel
                .channels()
                .iter()
                .all(|channel| code(*channel, Encoding::default(), 255) == 255)
        })?;
    }
    for drawn in node.all("drawn") {
        compare(&letters(&film), drawn.value())?;
    }
    if let Some(eye) = node.get("floor-from") {
        let screen = node
            .get("screen")
            .unwrap_or_else(|| panic!("a floor is seen through a screen"));
        shows_floor(
            &film,
            &Floor::new(eye, screen),
            node.get("within").unwrap_or("8 ulp"),
        )?;
    }
    if let Some(most) = node.number::<usize>("changes") {
        few_changes(&film, most)?;
    }
    if let Some(other) = node.get("same-as") {
        let other = read(back_end, &whole(case.scene(Some(other))))?
            .picture()?
            .0;
        same(&film, &other, "the other scene")?;
    }
    let rays = [
        ("mirror-rays", counts.mirror_rays),
        ("shadow-rays", counts.shadow_rays),
        ("transmitted-rays", counts.transmitted_rays),
    ];
    for (word, found) in rays {
        if let Some(expected) = node.number::<u64>(word)
            && found != expected
        {
            return Err(format!("{found} {word}, expected {expected}"));
        }
    }
    Ok(())
}

/// `look "eye" "point" …`: one pixel, seen from the eye straight at a point.
pub(crate) fn look(node: &Node, case: &Case, back_end: BackEnd) -> Answer {
    let [eye, point] = node.values.as_slice() else {
        panic!("`look` takes an eye and a point");
    };
    let up = node.get("up").unwrap_or("0 1 0");
    let text = scenes::looking(case.scene(node.get("in")), eye, point, up);
    let (film, _) = read(back_end, &text)?.picture()?;
    all_finite(&film)?;
    let lit = film.pixel(0, 0).max_channel() > 0.0;
    let expected: bool = node
        .number("lit")
        .unwrap_or_else(|| panic!("`look` needs lit=…"));
    if lit == expected {
        return Ok(());
    }
    let word = |lit| if lit { "lit" } else { "dark" };
    Err(format!(
        "{point} is {}, expected {}",
        word(lit),
        word(expected)
    ))
}

/// `unchanged …`: a picture that must stay the same, bit for bit.
pub(crate) fn unchanged(node: &Node, case: &Case, back_end: BackEnd) -> Answer {
    let subject = subject(node, case, back_end)?;
    let original = subject.picture()?.0;
    all_finite(&original)?;
    if original.pixels().iter().all(|pixel| pixel.is_black()) {
        return Err("the picture shows nothing".to_owned());
    }
    let nodes = subject.nodes();
    let changed = |nodes: Vec<_>, how: &str| {
        let film = read(back_end, &scenes::text(&nodes))
            .and_then(|subject| subject.picture())
            .map_err(|what| format!("{how}: {what}"))?
            .0;
        same(&film, &original, &format!("the picture {how}"))
    };
    for exponent in numbers::<i32>(node.get("scaled")) {
        changed(
            scenes::scaled(&nodes, exponent),
            &format!("scaled by 2^{exponent}"),
        )?;
    }
    if let Some(by) = node.get("moved") {
        changed(scenes::moved(&nodes, by), &format!("moved by {by}"))?;
    }
    if node.get("zeros").is_some() {
        changed(scenes::with_negative_zeros(&nodes), "with negative zeros")?;
    }
    if let Some(name) = node.get("split") {
        let [columns, rows] =
            words::<2>(node.get("into").unwrap_or("2 2")).map(|word| word.parse().unwrap());
        let parts = scenes::split(&nodes, name, columns, rows);
        changed(parts, &format!("with {name} in {columns} by {rows} parts"))?;
    }
    for threads in numbers::<usize>(node.get("threads")) {
        let pool = rayon::ThreadPoolBuilder::new()
            .num_threads(threads)
            .build()
            .unwrap();
        let film = pool.install(|| subject.picture())?.0;
        same(
            &film,
            &original,
            &format!("the picture on {threads} threads"),
        )?;
    }
    for word in node.get("found-by").unwrap_or_default().split_whitespace() {
        let accelerator = match word {
            "list" => Accelerator::List,
            "tree" => Accelerator::Tree,
            other => panic!("surfaces are not found by a {other}"),
        };
        let film = subject.picture_by(accelerator)?;
        same(&film, &original, &format!("the picture by a {word}"))?;
    }
    for part in node.get("parts").unwrap_or_default().split_whitespace() {
        let corners: Vec<usize> = part.split(',').map(|side| side.parse().unwrap()).collect();
        let &[left, top, right, bottom] = corners.as_slice() else {
            panic!("a part is left,top,right,bottom, and not {part}");
        };
        let film = subject.part([left, top], [right, bottom])?;
        let rows = top..bottom;
        let pixels = rows.flat_map(|row| (left..right).map(move |column| (column, row)));
        let expected: Vec<_> = pixels
            .map(|(column, row)| original.pixel(column, row))
            .collect();
        same_pixels(film.pixels(), &expected, &format!("the part {part}"))?;
    }
    Ok(())
}

/// `kept BACK-END="hash" …`: the picture has the bits that are kept for this back end, if any are.
pub(crate) fn kept(node: &Node, case: &Case, back_end: BackEnd) -> Answer {
    let Some(expected) = node.get(back_end.word()) else {
        return Ok(());
    };
    let (film, _) = subject(node, case, back_end)?.picture()?;
    let bits = film.pixels().iter().flat_map(|pixel| pixel.channels());
    let bytes: Vec<u8> = bits.flat_map(f64::to_le_bytes).collect();
    let found = blake3::hash(&bytes).to_string();
    if found == expected {
        return Ok(());
    }
    if std::env::var_os("HELIODON_UPDATE").is_some() {
        let both = [expected, &found].map(|hash| format!("{}=\"{hash}\"", back_end.word()));
        cases::replace(&both[0], &both[1]);
        return Ok(());
    }
    Err(format!(
        "the picture's hash is {found}, expected {expected}"
    ))
}

/// The numbers of a text, with `a..b` for all from `a` to `b`.
fn numbers<T: std::str::FromStr<Err: std::fmt::Debug>>(text: Option<&str>) -> Vec<T> {
    let words = text.unwrap_or_default().split_whitespace();
    let numbers = words.flat_map(|word| match word.split_once("..") {
        Some((first, last)) => {
            let [first, last] = [first, last].map(|end| end.parse::<i64>().unwrap());
            (first..=last).map(|number| number.to_string()).collect()
        }
        None => vec![word.to_owned()],
    });
    numbers.map(|number| number.parse().unwrap()).collect()
}

fn all_finite(film: &Film) -> Answer {
    match film.non_finite().next() {
        None => Ok(()),
        Some((column, row)) => {
            let channels = film.pixel(column, row).channels();
            Err(format!("pixel ({column}, {row}) is {channels:?}"))
        }
    }
}

fn every(film: &Film, expected: &str, is_true: impl Fn(Rgb) -> bool) -> Answer {
    let wrong: Vec<_> = (0..film.pixels().len())
        .filter(|index| !is_true(film.pixels()[*index]))
        .collect();
    let Some(first) = wrong.first() else {
        return Ok(());
    };
    let (column, row) = (first % film.width(), first / film.width());
    let (found, count) = (film.pixels()[*first].channels(), wrong.len());
    Err(format!(
        "pixel ({column}, {row}) is {found:?}, {expected} ({count} pixels are wrong)"
    ))
}

/// Every pixel is as bright as its part of the floor.
fn shows_floor(film: &Film, floor: &Floor, within: &str) -> Answer {
    let within = nearest(&exact(within));
    let [width, height] = [film.width(), film.height()].map(|side| u32::try_from(side).unwrap());
    let (mut most, mut place) = (0f64, [0, 0]);
    for row in 0..height {
        for column in 0..width {
            let found = film.pixel(column as usize, row as usize).g;
            let off = (found - floor.mean([column, row], [width, height])).abs();
            if off > most {
                (most, place) = (off, [column, row]);
            }
        }
    }
    if most <= within {
        return Ok(());
    }
    Err(format!("pixel {place:?} is off by {most}"))
}

fn same(film: &Film, original: &Film, which: &str) -> Answer {
    same_pixels(film.pixels(), original.pixels(), which)
}

fn same_pixels(pixels: &[Rgb], expected: &[Rgb], which: &str) -> Answer {
    let pairs = pixels.iter().zip(expected);
    let bits = |pixel: &Rgb| pixel.channels().map(f64::to_bits);
    let differ = pairs
        .filter(|(one, other)| bits(one) != bits(other))
        .count();
    if differ == 0 && pixels.len() == expected.len() {
        return Ok(());
    }
    Err(format!("{which} differs in {differ} pixels"))
}

/// Along each row, brightness goes from dark to lit or back at most so many times.
fn few_changes(film: &Film, most: usize) -> Answer {
    for (number, row) in film.pixels().chunks(film.width()).enumerate() {
        let lit = |pixel: &Rgb| pixel.max_channel() > 0.0;
        let changes = row
            .windows(2)
            .filter(|pair| lit(&pair[0]) != lit(&pair[1]))
            .count();
        if changes > most {
            return Err(format!(
                "row {number} changes {changes} times, expected at most {most}"
            ));
        }
    }
    Ok(())
}

/// A picture as letters: R, G, B, Y, C, M, W for the channels that are at least half as bright as
/// the brightest, `.` for black.
fn letters(film: &Film) -> String {
    let letter = |pixel: &Rgb| {
        let brightest = pixel.max_channel();
        if brightest <= 0.0 {
            return '.';
        }
        match pixel.channels().map(|channel| channel >= brightest / 2.0) {
            [true, true, true] => 'W',
            [true, true, false] => 'Y',
            [true, false, true] => 'M',
            [false, true, true] => 'C',
            [true, false, false] => 'R',
            [false, true, false] => 'G',
            _ => 'B',
        }
    };
    let rows = film.pixels().chunks(film.width());
    rows.map(|row| row.iter().map(letter).collect::<String>())
        .collect::<Vec<_>>()
        .join("\n")
}

fn compare(drawn: &str, expected: &str) -> Answer {
    let expected = expected.trim();
    if drawn == expected {
        return Ok(());
    }
    Err(format!("the picture is\n{drawn}\nexpected\n{expected}"))
}
