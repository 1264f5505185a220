//! CPU time of a whole render, PNG written, side by side with Tachyon on the same room.
//!
//! `cargo bench --bench against_tachyon [-- TACHYON_SCENE]` writes `scenes/room.kdl` as a scene for
//! Tachyon (or takes the one that is named), runs both programs in turn on one thread, and prints
//! the ratio of each pair. Tachyon has to be installed; without it there is nothing to compare.

mod processor;

use std::error::Error;
use std::fmt::Write;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use glam::{DVec2, DVec3};
use heliodon::camera::{View, WindowOrigin};
use heliodon::read;
use heliodon::scene::Scene;
use heliodon::texture::Texture;
use processor::median;

const PAIRS: usize = 21;
const SCENE: &str = "scenes/room.kdl";

fn main() -> Result<(), Box<dyn Error>> {
    if Command::new("tachyon")
        .stdout(Stdio::null())
        .stderr(Stdio::null())
        .status()
        .is_err()
    {
        println!("tachyon is not installed; nothing to compare with");
        return Ok(());
    }
    let folder = PathBuf::from(env!("CARGO_TARGET_TMPDIR"));
    let named = std::env::args()
        .skip(1)
        .find(|argument| !argument.starts_with("--"));
    let twin = match named {
        Some(path) => PathBuf::from(path),
        None => write_twin(&folder)?,
    };
    let ours = |out: &Path| {
        let mut command = Command::new(env!("CARGO_BIN_EXE_heliodon"));
        command
            .args(["render", SCENE, "--threads", "1", "-q", "-o"])
            .arg(out);
        command
    };
    let theirs = |out: &Path| {
        let mut command = Command::new("tachyon");
        command
            .arg(&twin)
            .args(["-numthreads", "1", "-aasamples", "0", "-res", "800", "600"]);
        command.args(["-format", "PNG", "+V", "-o"]).arg(out);
        command
    };
    let (our_picture, their_picture) = (folder.join("ours.png"), folder.join("theirs.png"));
    let mut pairs = Vec::new();
    for _ in 0..PAIRS {
        let heliodon = processor::seconds(&mut ours(&our_picture))?;
        let tachyon = processor::seconds(&mut theirs(&their_picture))?;
        pairs.push((heliodon, tachyon));
    }
    println!(
        "{SCENE} against {}, {PAIRS} pairs, CPU time",
        twin.display()
    );
    println!(
        "heliodon  median {:.3} s",
        median(pairs.iter().map(|pair| pair.0))
    );
    println!(
        "tachyon   median {:.3} s",
        median(pairs.iter().map(|pair| pair.1))
    );
    println!(
        "ratio     median {:.3}",
        median(pairs.iter().map(|pair| pair.0 / pair.1))
    );
    Ok(())
}

/// The room for Tachyon: every rectangle as two triangles, textures as PPM.
///
/// Tachyon's lights do not fade, so its colours differ; rays, surfaces and textures are the same.
fn write_twin(folder: &Path) -> Result<PathBuf, Box<dyn Error>> {
    let reading = read::read_file(Path::new(SCENE), &read::Options::default())?
        .map_err(|scene_error| format!("{:?}", scene_error.diagnostics))?;
    let scene = reading.scene;
    let mut text = camera(&scene)?;
    for light in &scene.lights {
        writeln!(
            text,
            "LIGHT CENTER {} RAD 0.0001 COLOR 0.5 0.5 0.5",
            triple(light.location)
        )?;
    }
    for surface in &scene.surfaces {
        let node = surface.describe();
        let (flat, size) = (
            surface.shape().carrier().ok_or("only rectangles")?,
            node.pair("dimensions"),
        );
        let frame = heliodon::math::Frame::new(flat.normal, node.triple("xdir"))?;
        let name = node.text("texture");
        let texture = scene.textures.iter().find(|texture| texture.name == name);
        let texture = texture.ok_or("only texture planes")?;
        let file = folder.join(format!("{name}.ppm"));
        fs::write(&file, ppm(texture))?;
        let repeat = node
            .entry("texture")
            .and_then(|entry| entry.property("texel"));
        let image = repeat.map_or(size, |texel| {
            texel.pair() * DVec2::new(texture.texels.width as f64, texture.texels.height as f64)
        });
        let finish = format!(
            "TEXTURE AMBIENT 0.2 DIFFUSE 0.7 SPECULAR {} OPACITY 1.0 COLOR 1 1 1 \
             TEXFUNC 9 {} CENTER {} ROTATE 0 0 0 SCALE {} {} 1 UAXIS {} VAXIS {}",
            surface.common().material.specular.r,
            file.display(),
            triple(flat.point),
            1.0 / image.x,
            1.0 / image.y,
            triple(frame.x),
            triple(frame.y),
        );
        let corner =
            |x: f64, y: f64| triple(flat.point + frame.x * (x * size.x) + frame.y * (y * size.y));
        let (a, b, c, d) = (
            corner(0.0, 0.0),
            corner(1.0, 0.0),
            corner(1.0, 1.0),
            corner(0.0, 1.0),
        );
        writeln!(
            text,
            "TRI V0 {a} V1 {b} V2 {c}\n{finish}\nTRI V0 {a} V1 {c} V2 {d}\n{finish}"
        )?;
    }
    text += "END_SCENE\n";
    let path = folder.join("room.dat");
    fs::write(&path, text)?;
    Ok(path)
}

fn camera(scene: &Scene) -> Result<String, Box<dyn Error>> {
    let View::Screen {
        viewpoint: eye,
        size,
        origin: WindowOrigin::Corner,
        at,
    } = &scene.view
    else {
        return Err("the room is seen through the chapter's screen".into());
    };
    // The window at distance 1; Tachyon is left-handed, so left and right change places.
    let from = *eye - *at;
    let [left, right] = [from.x, from.x - size.x].map(|side| side / from.z);
    let [bottom, top] = [-from.y, size.y - from.y].map(|side| side / from.z);
    Ok(format!(
        "BEGIN_SCENE\nRESOLUTION {} {}\nCAMERA\nZOOM 1.0\nASPECTRATIO 1.0\nANTIALIASING 0\n\
         RAYDEPTH 6\nCENTER {}\nVIEWDIR 0 0 -1\nUPDIR 0 1 0\n\
         FRUSTUM {left} {right} {bottom} {top}\nEND_CAMERA\n",
        scene.settings.width,
        scene.settings.height,
        triple(*eye),
    ))
}

fn triple(vector: DVec3) -> String {
    format!("{:?} {:?} {:?}", vector.x, vector.y, vector.z)
}

fn ppm(texture: &Texture) -> Vec<u8> {
    let (width, height) = (texture.texels.width, texture.texels.height);
    let mut bytes = format!("P6\n{width} {height}\n255\n").into_bytes();
    // Tachyon counts rows from the bottom.
    let rows = texture.texels.channels.chunks(width).rev();
    bytes.extend(
        rows.flatten()
            .flatten()
            .map(|channel| channel.to_le_bytes()[0]),
    );
    bytes
}
