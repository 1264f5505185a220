//! The crates of the workspace: `cargo test` misses no test in them.

use support::files::sources;

/// The folders whose crates or programs Cargo does not test: their manifests say `test = false`.
const UNTESTED: [&str; 3] = ["oracle/src", "tools/src", "examples"];

/// The programs in them that are tested all the same.
const TESTED: [&str; 1] = ["tools/src/bin/textures"];

#[test]
fn no_test_is_where_cargo_does_not_look_for_it() {
    for (path, text) in UNTESTED.into_iter().flat_map(sources) {
        let is_tested = TESTED.iter().any(|folder| path.starts_with(folder));
        let has_tests = text.lines().any(|line| line.trim() == "#[test]");
        assert!(is_tested || !has_tests, "{} is not run", path.display());
    }
}
