//! Files that appear whole or not at all.

use std::fs;
use std::io::{self, BufWriter, Write};
use std::path::{Path, PathBuf};
use std::sync::Mutex;

/// The file that is being written, under its temporary name.
static UNFINISHED: Mutex<Option<PathBuf>> = Mutex::new(None);

/// Writes a file under a temporary name beside its place, and renames it when it is complete.
///
/// What is not a regular file (a pipe, a device) is written directly; a link keeps its place and
/// its target is written. A file that is replaced hands on its permissions.
///
/// # Errors
/// Whatever `write`, the file system or the rename fails with; the old file is then untouched.
pub fn save(path: &Path, write: impl FnOnce(&mut dyn Write) -> io::Result<()>) -> io::Result<()> {
    let place = target(path);
    let old = fs::metadata(&place).ok();
    if old.as_ref().is_some_and(is_special) {
        let mut out = fs::OpenOptions::new().write(true).open(&place)?;
        return write(&mut out);
    }
    let file = beside(&place)?;
    note_unfinished(Some(file.path().to_owned()));
    let written = write_to(file.as_file(), write).and_then(|()| Ok(file.persist(&place)?));
    note_unfinished(None);
    written?;
    match old {
        Some(old) => fs::set_permissions(&place, old.permissions()),
        None => Ok(()),
    }
}

/// Whether a file can be saved here, as far as can be told without writing anything.
///
/// # Errors
/// Whatever keeps a file from being made in the folder.
pub fn check_place(path: &Path) -> io::Result<()> {
    let place = target(path);
    match fs::metadata(&place) {
        Ok(old) if old.is_dir() => Err(io::Error::other("it is a folder")),
        Ok(old) if is_special(&old) => Ok(()),
        Err(error) if error.kind() == io::ErrorKind::InvalidFilename => {
            Err(io::Error::new(error.kind(), "its name is too long"))
        }
        _ => beside(&place).map(drop),
    }
}

/// Whether something is written where it is: a pipe, a device.
fn is_special(old: &fs::Metadata) -> bool {
    !old.is_file() && !old.is_dir()
}

/// An empty file under a temporary name beside a place. Errors do not tell that name, which nobody asked
/// for.
fn beside(place: &Path) -> io::Result<tempfile::NamedTempFile> {
    let parent = place
        .parent()
        .filter(|parent| !parent.as_os_str().is_empty());
    let folder = parent.unwrap_or(Path::new("."));
    if !folder.is_dir() {
        let reason = format!("there is no folder {}", folder.display());
        return Err(io::Error::new(io::ErrorKind::NotFound, reason));
    }
    let mut builder = tempfile::Builder::new();
    builder.prefix(".heliodon-");
    builder.make_in(folder, |path| fs::File::create_new(path))
}

/// Removes what a save that will not be completed has left behind.
pub fn discard_unfinished() {
    let unfinished = UNFINISHED
        .lock()
        .ok()
        .and_then(|mut unfinished| unfinished.take());
    if let Some(path) = unfinished {
        // If it is gone already, so much the better.
        let _ = fs::remove_file(path);
    }
}

fn note_unfinished(path: Option<PathBuf>) {
    if let Ok(mut unfinished) = UNFINISHED.lock() {
        *unfinished = path;
    }
}

/// The place that a path stands for: that which a link points to, whether it exists or not.
fn target(path: &Path) -> PathBuf {
    if let Ok(place) = fs::canonicalize(path) {
        return place;
    }
    match (fs::read_link(path), path.parent()) {
        (Ok(link), Some(parent)) => parent.join(link),
        _ => path.to_owned(),
    }
}

fn write_to(
    file: &fs::File,
    write: impl FnOnce(&mut dyn Write) -> io::Result<()>,
) -> io::Result<()> {
    let mut out = BufWriter::with_capacity(1 << 16, file);
    write(&mut out)?;
    out.flush()
}
