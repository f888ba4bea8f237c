//! The code of the figures that move, for the pages: the lessons compiled to WebAssembly, in a script.
//!
//! It is a script, `live-code.js`, with the code compressed and in base64, since a page that is opened as a file may load scripts
//! but not fetch. With the code it has what the page's script, `theme/live.js`, must know of the figures, and the shades of their
//! colours on a dark page.

use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::Command;

use anyhow::{Context, bail, ensure};
use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use flate2::Compression;
use flate2::write::ZlibEncoder;
use live::{FIGURES, Figure, HEAD, Input};
use serde_json::{Value, json};

use crate::cargo::cargo;

const TARGET: &str = "wasm32-unknown-unknown";

/// The code of all figures is no larger once `wasm-opt` has made it smaller: a page loads it whole, and the head beside it.
const LIMIT: usize = 400_000;

/// For `wasm-opt`: by size, which costs no speed here, with what the compiler uses of WebAssembly, which every browser has had
/// since March 2023. No program of ours has anything in the lowest 1024 bytes of memory: there is the end of the stack.
const OPTIMISE: [&str; 13] = [
    "-Oz",
    "--converge",
    // Once more from the start, with its loops and branches made anew.
    "--flatten",
    "--rereloop",
    "-Oz",
    "-Oz",
    "--const-hoisting",
    "--low-memory-unused",
    "--enable-bulk-memory",
    "--enable-mutable-globals",
    "--enable-nontrapping-float-to-int",
    "--enable-sign-ext",
    "--enable-simd",
];

/// Writes the script into the folder of the book. Where the code cannot be compiled here, it says so and is empty: the figures
/// stay still.
///
/// # Errors
/// Where the code does not compile or is too large, or a file cannot be written.
pub(crate) fn write(out: &Path) -> anyhow::Result<()> {
    let script = match code()? {
        Some(code) => script(&compressed(&code)?, &compressed(HEAD)?),
        None => {
            println!("The figures stay still: to see them move, rustup target add {TARGET}");
            "// The figures stay still: their code was not compiled.\n".into()
        }
    };
    let path = out.join("live-code.js");
    std::fs::write(&path, script).with_context(|| path.display().to_string())
}

/// The code as it is loaded, in less than half of the bytes: of the lessons' loops many are alike, and there are as many as
/// methods.
fn compressed(code: &[u8]) -> anyhow::Result<Vec<u8>> {
    let mut encoder = ZlibEncoder::new(Vec::new(), Compression::best());
    encoder.write_all(code)?;
    Ok(encoder.finish()?)
}

/// The script for that code and the head, compressed.
fn script(code: &[u8], head: &[u8]) -> String {
    let figures: Vec<Value> = FIGURES.iter().map(figure).collect();
    let style = sheet::shades(".navy .live-drawing ");
    let all = json!({ "figures": figures, "style": style, "code": STANDARD.encode(code), "head": STANDARD.encode(head) });
    format!("liveFigures({all});\n")
}

/// What the page's script must know of a figure.
fn figure(figure: &Figure) -> Value {
    let inputs: Vec<Value> = figure.inputs.iter().map(input).collect();
    json!({ "name": figure.name, "stays": figure.stays, "hint": figure.hint, "inputs": inputs })
}

fn input(input: &Input) -> Value {
    let of = |number: fn(live::Range) -> f64| input.ranges().map(number).collect::<Vec<f64>>();
    let [from, low, high] = [of(|range| range.from), of(|range| range.low), of(|range| range.high)];
    match input {
        Input::Point { label, step, .. } => {
            json!({ "kind": "point", "label": label, "from": from, "low": low, "high": high, "step": step })
        }
        Input::Slider { label, step, .. } => {
            json!({ "kind": "slider", "label": label, "from": from, "low": low[0], "high": high[0], "step": step })
        }
        Input::Turn { .. } => json!({ "kind": "turn", "from": from, "low": low, "high": high }),
        Input::Choice { label, rows, .. } => {
            let row = |row: &common::Method<()>| json!({ "name": row.name, "promise": row.promise, "failure": row.failure });
            let rows: Vec<Value> = rows().iter().map(row).collect();
            json!({ "kind": "choice", "label": label, "from": from, "rows": rows })
        }
        Input::Times => json!({ "kind": "times", "from": from }),
    }
}

/// The compiled code, smaller by `wasm-opt` where there is one; `None` where this machine has no compiler for it.
/// `LIVE_CODE` names a file that has it.
fn code() -> anyhow::Result<Option<Vec<u8>>> {
    let compiled = match std::env::var_os("LIVE_CODE") {
        Some(file) => PathBuf::from(file),
        None if has_target() => compile()?,
        None => return Ok(None),
    };
    let folder = tempfile::tempdir()?;
    let small = folder.path().join("small.wasm");
    let optimised = Command::new("wasm-opt").args(OPTIMISE).arg(&compiled).arg("-o").arg(&small).output();
    if !optimised.is_ok_and(|output| output.status.success()) {
        return read(&compiled).map(Some);
    }
    let code = read(&small)?;
    let size = code.len();
    ensure!(size <= LIMIT, "the code of the figures that move has {size} bytes, more than {LIMIT}");
    Ok(Some(code))
}

fn read(file: &Path) -> anyhow::Result<Vec<u8>> {
    std::fs::read(file).with_context(|| file.display().to_string())
}

/// Whether the compiler has the standard library for WebAssembly.
fn has_target() -> bool {
    let rustc = std::env::var_os("RUSTC").unwrap_or_else(|| "rustc".into());
    let folder = Command::new(rustc).args(["--print", "target-libdir", "--target", TARGET]).output();
    folder.is_ok_and(|output| Path::new(String::from_utf8_lossy(&output.stdout).trim()).is_dir())
}

/// Compiles the code.
fn compile() -> anyhow::Result<PathBuf> {
    let root = Path::new(crate::ROOT);
    let target = root.join("target");
    let mut command = cargo();
    command
        // There is .cargo/config.toml, which cargo looks for from its working folder on.
        .current_dir(root)
        .args(["build", "--quiet", "--package", "live-wasm", "--profile", "live", "--target", TARGET])
        .arg("--target-dir")
        .arg(&target);
    if !command.status().context("cannot start cargo")?.success() {
        bail!("the figures that move cannot be compiled");
    }
    Ok(target.join(TARGET).join("live/live_wasm.wasm"))
}
