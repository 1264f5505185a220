//! Files that appear complete or not at all.

use std::fs;
use std::io::{self, BufWriter, Write};
use std::path::{Path, PathBuf};
use std::sync::Mutex;

/// The temporary name of the file that is being written.
static UNFINISHED: Mutex<Option<PathBuf>> = Mutex::new(None);

/// Writes a file that appears when it is complete.
///
/// It is written under a temporary name in its folder and then renamed.
///
/// A pipe or a device is written directly. If the path is a link, its target is written. A new
/// file takes the permissions of the file that it replaces.
///
/// # Errors
/// Returns the error of `write` or of the file system; the old file is then unchanged.
pub fn save(path: &Path, write: impl FnOnce(&mut dyn Write) -> io::Result<()>) -> io::Result<()> {
    let target = resolved(path);
    let old = fs::metadata(&target).ok();
    if old.as_ref().is_some_and(is_special) {
        let mut out = fs::OpenOptions::new().write(true).open(&target)?;
        return write(&mut out);
    }
    let file = temporary_file(&target)?;
    note_unfinished(Some(file.path().to_owned()));
    let written = write_to(file.as_file(), write).and_then(|()| Ok(file.persist(&target)?));
    note_unfinished(None);
    written?;
    match old {
        Some(old) => fs::set_permissions(&target, old.permissions()),
        None => Ok(()),
    }
}

/// Checks that a file can be created at a path, without leaving one there.
///
/// # Errors
/// Returns the error of the file system.
pub fn check_writable(path: &Path) -> io::Result<()> {
    let target = resolved(path);
    match fs::metadata(&target) {
        Ok(old) if old.is_dir() => Err(io::Error::other("it is a folder")),
        Ok(old) if is_special(&old) => Ok(()),
        Err(error) if error.kind() == io::ErrorKind::InvalidFilename => {
            Err(io::Error::new(error.kind(), "its name is too long"))
        }
        _ => temporary_file(&target).map(drop),
    }
}

/// True for a pipe or a device.
fn is_special(old: &fs::Metadata) -> bool {
    !old.is_file() && !old.is_dir()
}

/// Creates an empty file under a temporary name in a path's folder.
///
/// Errors do not contain the temporary name.
fn temporary_file(target: &Path) -> io::Result<tempfile::NamedTempFile> {
    let parent = target
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

/// Removes the temporary file of a save that was interrupted.
pub fn discard_unfinished() {
    let unfinished = UNFINISHED
        .lock()
        .ok()
        .and_then(|mut unfinished| unfinished.take());
    if let Some(path) = unfinished {
        // An error means that the file is gone already.
        let _ = fs::remove_file(path);
    }
}

fn note_unfinished(path: Option<PathBuf>) {
    if let Ok(mut unfinished) = UNFINISHED.lock() {
        *unfinished = path;
    }
}

/// The path itself, or the target of a link, which need not exist.
fn resolved(path: &Path) -> PathBuf {
    if let Ok(target) = fs::canonicalize(path) {
        return target;
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
