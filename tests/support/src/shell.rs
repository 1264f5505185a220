//! Runs of the program, in the repository or in a folder of their own.

use std::fs;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};

use snapbox::assert::DEFAULT_ACTION_ENV;
use snapbox::{Assert, IntoData};

use crate::files;

/// A picture of a floor and a ball, in a few milliseconds.
pub const SCENE: &str = r#"
image 40 30
camera { viewpoint 0 1 4; look-at 0 1 0 }
material "chalk" { ambient 1; diffuse 3; specular 0.3; shininess 9 }
light { location 2 4 3; emissivity 8 }
plane "floor" { material "chalk"; point 0 0 0; normal 0 1 0 }
sphere "ball" { material "chalk"; center 0 1 0; radius 1 }
"#;

/// An empty folder that vanishes with its test.
#[derive(Debug)]
pub struct Shell {
    folder: tempfile::TempDir,
}

/// How a run of the program ended.
#[derive(Debug)]
pub struct Run {
    /// The exit code; `None` if a signal ended it.
    pub code: Option<i32>,
    /// Everything on standard output.
    pub stdout: Vec<u8>,
    /// Everything on standard error.
    pub stderr: String,
}

/// The program that Cargo has built for this test.
///
/// # Panics
///
/// Panics if the program is not in the folder above the one of the test.
#[must_use]
pub fn program() -> PathBuf {
    let test = std::env::current_exe().expect("the path of this test");
    // target/release/deps/test-0123 is a neighbour of target/release/heliodon.
    let folder = test.ancestors().nth(2).expect("the folder of programs");
    let program = folder.join(format!("heliodon{}", std::env::consts::EXE_SUFFIX));
    assert!(program.exists(), "no {}", program.display());
    program
}

/// Runs the program with these arguments in the folder in which the test runs.
#[must_use]
pub fn heliodon(arguments: &[&str]) -> Run {
    let output = Command::new(program()).args(arguments).output();
    output.expect("the program runs").into()
}

impl Default for Shell {
    fn default() -> Self {
        Self::new()
    }
}

impl Shell {
    /// An empty folder.
    ///
    /// # Panics
    ///
    /// Panics if there is no place for one; all functions of this type panic if a file or the
    /// program fails them.
    #[must_use]
    pub fn new() -> Self {
        Self {
            folder: tempfile::tempdir().expect("a temporary folder"),
        }
    }

    /// A folder with the scene above as `scene.kdl`.
    #[must_use]
    pub fn with_scene() -> Self {
        let shell = Self::new();
        shell.write("scene.kdl", SCENE);
        shell
    }

    /// The path of a file in the folder.
    #[must_use]
    pub fn path(&self, name: &str) -> PathBuf {
        self.folder.path().join(name)
    }

    /// Writes a file of the folder.
    pub fn write(&self, name: &str, text: &str) {
        fs::write(self.path(name), text).expect("a file in the temporary folder");
    }

    /// The bytes of a file of the folder.
    #[must_use]
    pub fn read(&self, name: &str) -> Vec<u8> {
        fs::read(self.path(name)).unwrap_or_else(|error| panic!("{name}: {error}"))
    }

    /// The names of all files and folders in it, sorted.
    #[must_use]
    pub fn files(&self) -> Vec<String> {
        let entries = files::entries(self.folder.path());
        let names = entries.iter().filter_map(|path| path.file_name());
        names
            .map(|name| name.to_string_lossy().into_owned())
            .collect()
    }

    /// The program with these arguments in this folder, to be started.
    #[must_use]
    pub fn command(&self, arguments: &[&str]) -> Command {
        let mut command = Command::new(program());
        command
            .args(arguments)
            .current_dir(self.folder.path())
            .env_remove("CLICOLOR_FORCE");
        command
    }

    /// Runs the program with these arguments.
    #[must_use]
    pub fn run(&self, arguments: &[&str]) -> Run {
        self.run_with_input(arguments, "")
    }

    /// Runs the program with this text on standard input.
    #[must_use]
    pub fn run_with_input(&self, arguments: &[&str], input: &str) -> Run {
        let mut child = self
            .command(arguments)
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .spawn()
            .expect("the program starts");
        let mut stdin = child.stdin.take().expect("a pipe");
        // A program that does not read its input has closed it.
        let _ = stdin.write_all(input.as_bytes());
        drop(stdin);
        child.wait_with_output().expect("the program ends").into()
    }
}

impl From<Output> for Run {
    fn from(output: Output) -> Self {
        Self {
            code: output.status.code(),
            stdout: output.stdout,
            stderr: String::from_utf8(output.stderr).expect("messages are text"),
        }
    }
}

impl Run {
    /// Fails unless the exit code is this one.
    #[track_caller]
    pub fn ends_with(self, code: i32) -> Self {
        assert_eq!(self.code, Some(code), "{}", self.stderr);
        self
    }

    /// Fails unless these words stand on standard error.
    #[track_caller]
    pub fn says(self, words: &str) -> Self {
        assert!(
            self.stderr.contains(words),
            "not said: {words:?}\nsaid: {}",
            self.stderr
        );
        self
    }

    /// Fails unless standard output is this text; `SNAPSHOTS=overwrite` rewrites the text in the
    /// test.
    #[track_caller]
    pub fn prints(&self, text: impl IntoData) {
        let assert = Assert::new().action_env(DEFAULT_ACTION_ENV);
        assert.eq(self.stdout_text(), text);
    }

    /// Standard output as text.
    #[must_use]
    pub fn stdout_text(&self) -> &str {
        std::str::from_utf8(&self.stdout).expect("results are text")
    }
}

/// The decoded size of a picture file.
#[must_use]
pub fn size_of(path: &Path) -> (u32, u32) {
    image::image_dimensions(path).expect("a picture")
}
