//! The body of each fuzz target: bytes go in, and a panic is a bug.
//!
//! `tests/language/fuzz_seeds.rs` of the main crate runs the same bodies over the seed corpus.

use std::cell::RefCell;
use std::io::{Cursor, Seek, SeekFrom, Write};
use std::path::{Path, PathBuf};

use heliodon::film::{Film, Transfer};
use heliodon::language::render_diagnostics;
use heliodon::read::{Language, Options, read_bytes};
use heliodon::scene::Scene;
use heliodon::texture;

/// Texels and pixels of the largest image that is decoded; larger ones only cost time.
const LARGEST_IMAGE: u64 = 1 << 20;

/// Reads a scene in KDL.
///
/// # Panics
///
/// Panics if an error has no message, or if an accepted scene changes when written and read again.
pub fn kdl(bytes: &[u8]) {
    scene(bytes, Language::Kdl);
}

/// Reads a scene in the course's block grammar.
///
/// # Panics
///
/// Panics as [`kdl`] does.
pub fn course(bytes: &[u8]) {
    scene(bytes, Language::Course);
}

/// Decodes a texture.
///
/// # Panics
///
/// Panics if the number of texels is not width times height.
pub fn texture(bytes: &[u8]) {
    if is_too_large(bytes) {
        return;
    }
    with_file(bytes, |path| {
        if let Ok(texels) = texture::decode(path) {
            assert!(texture::check(path).is_ok(), "decoded, but not a texture");
            assert_eq!(texels.channels.len(), texels.width * texels.height);
        }
    });
}

/// Reads a reference picture.
///
/// # Panics
///
/// Panics if a pixel is not finite.
pub fn reference(bytes: &[u8]) {
    if is_too_large(bytes) {
        return;
    }
    with_file(bytes, |path| {
        for transfer in [Transfer::None, Transfer::Srgb] {
            if let Ok(film) = Film::read(path, transfer) {
                assert_eq!(film.non_finite().count(), 0, "a pixel is not finite");
            }
        }
    });
}

fn scene(bytes: &[u8], language: Language) {
    let scene = match read(bytes.to_vec(), language) {
        Ok(scene) => scene,
        Err(messages) => {
            assert!(!messages.is_empty(), "an error without a message");
            return;
        }
    };
    let file = |texture: &texture::Texture| {
        let path = texture.path.canonicalize();
        path.expect("the texture exists").display().to_string()
    };
    let text = scene.to_kdl(true, file);
    match read(text.clone().into_bytes(), Language::Kdl) {
        Ok(again) => assert!(again.hash() == scene.hash(), "another scene:\n{text}"),
        Err(messages) => panic!("refused when written and read again:\n{messages}\n{text}"),
    }
}

/// Reads a scene; gives all messages if it has errors.
fn read(bytes: Vec<u8>, language: Language) -> Result<Scene, String> {
    let options = Options {
        language: Some(language),
        ..Options::default()
    };
    match read_bytes("scene", bytes, folder(language), &options) {
        Ok(reading) => Ok(reading.scene),
        Err(error) => Err(render_diagnostics(
            &error.diagnostics,
            &error.sources,
            false,
            100,
        )),
    }
}

/// The folder where the files of a scene are looked for.
fn folder(language: Language) -> PathBuf {
    let folder = match language {
        Language::Kdl => "scenes",
        Language::Course => "tests/course",
    };
    // The main crate compiles this file, too.
    let crates = Path::new(env!("CARGO_MANIFEST_DIR")).ancestors();
    let mut folders = crates.map(|above| above.join(folder));
    let existing = folders.find(|folder| folder.is_dir());
    existing.expect("a folder of the repository")
}

/// True if an image's header promises more than [`LARGEST_IMAGE`].
fn is_too_large(bytes: &[u8]) -> bool {
    let reader = image::ImageReader::new(Cursor::new(bytes)).with_guessed_format();
    let size = reader.ok().and_then(|reader| reader.into_dimensions().ok());
    size.is_some_and(|(width, height)| u64::from(width) * u64::from(height) > LARGEST_IMAGE)
}

/// Puts bytes into a file, because the decoders read files. Each thread has one file.
fn with_file(bytes: &[u8], run: impl FnOnce(&Path)) {
    thread_local! {
        static FILE: RefCell<tempfile::NamedTempFile> =
            RefCell::new(tempfile::NamedTempFile::new().expect("a temporary file"));
    }
    FILE.with_borrow_mut(|file| {
        let out = file.as_file_mut();
        out.set_len(0).expect("an empty file");
        out.seek(SeekFrom::Start(0)).expect("its start");
        out.write_all(bytes).expect("the bytes");
        run(file.path());
    });
}
