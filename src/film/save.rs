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
    if old
        .as_ref()
        .is_some_and(|old| !old.is_file() && !old.is_dir())
    {
        let mut out = fs::OpenOptions::new().write(true).open(&place)?;
        return write(&mut out);
    }
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
    #[cfg(unix)]
    builder.permissions(std::os::unix::fs::PermissionsExt::from_mode(0o666));
    let file = builder.tempfile_in(folder)?;
    note_unfinished(Some(file.path().to_owned()));
    let written = write_to(file, write).and_then(|file| Ok(file.persist(&place)?));
    note_unfinished(None);
    written?;
    match old {
        Some(old) => fs::set_permissions(&place, old.permissions()),
        None => Ok(()),
    }
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
    file: tempfile::NamedTempFile,
    write: impl FnOnce(&mut dyn Write) -> io::Result<()>,
) -> io::Result<tempfile::NamedTempFile> {
    let mut out = BufWriter::with_capacity(1 << 16, file);
    write(&mut out)?;
    out.into_inner().map_err(io::IntoInnerError::into_error)
}
