//! The two scene languages: what is read, what is refused and in which words, what is written.

mod bad_course;
mod bad_scenes;
mod course;
mod fuzz_seeds;
mod mutations;
mod round_trip;
mod scene_language;
