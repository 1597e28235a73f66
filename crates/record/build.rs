//! What a result says of the program that made it: the revision of the source, where there is a git checkout to ask, the
//! compiler, the dependencies.
#![allow(clippy::print_stdout, reason = "this is how a build script speaks to cargo")]

use std::path::Path;
use std::process::Command;

use sha2::{Digest, Sha256};

/// Where this package stands in our repository: anywhere else the repository around it is somebody else's.
const HOME: &str = "crates/record/";

/// What the numbers of a result are made of, from the root of our repository.
const SOURCES: [&str; 12] = [
    "Cargo.toml",
    "Cargo.lock",
    "crates/bases",
    "crates/surfaces",
    "crates/energy",
    "crates/solve",
    "crates/optim",
    "crates/plateau",
    "crates/exchange",
    "crates/show",
    "crates/experiment",
    "crates/record",
];

fn main() {
    println!("cargo:rerun-if-changed=build.rs");
    println!("cargo:rerun-if-env-changed=PLATEAU_REVISION");
    if std::env::var_os("PLATEAU_REVISION").is_none() {
        tell("PLATEAU_REVISION", packed().or_else(checked_out));
    }
    let compiler = std::env::var("RUSTC").unwrap_or("rustc".into());
    tell("PLATEAU_TOOLCHAIN", answer(&compiler, &["--version"]));
    // In the workspace, or in the package as published.
    let lockfile = ["../../Cargo.lock", "Cargo.lock"].into_iter().find_map(|path| {
        let bytes = std::fs::read(path).ok()?;
        println!("cargo:rerun-if-changed={path}");
        Some(format!("{:x}", Sha256::digest(bytes)))
    });
    tell("PLATEAU_LOCKFILE", lockfile);
}

/// The revision that cargo wrote into a package.
fn packed() -> Option<String> {
    let text = std::fs::read_to_string(".cargo_vcs_info.json").ok()?;
    let (_, rest) = text.split_once("\"sha1\": \"")?;
    let revision = rest.get(..12).filter(|revision| revision.bytes().all(|b| b.is_ascii_hexdigit()))?;
    Some(marked(revision, text.contains("\"dirty\": true")))
}

/// The revision of our own repository around this package, marked if its sources were changed since.
fn checked_out() -> Option<String> {
    let is_home = answer("git", &["rev-parse", "--show-prefix"])? == HOME;
    // A copy of our files in another repository is none of its files.
    answer("git", &["ls-files", "--error-unmatch", "build.rs"]).filter(|_| is_home)?;
    for file in ["HEAD", "logs/HEAD"] {
        // Where that is depends on the kind of checkout.
        watch(&answer("git", &["rev-parse", "--git-path", file])?);
    }
    // What of them this package is made of, whose changes rebuild it anyway.
    for source in SOURCES {
        for place in ["", "/src", "/build.rs", "/Cargo.toml"] {
            let path = format!("../../{source}{place}");
            if !place.is_empty() || Path::new(&path).is_file() {
                watch(&path);
            }
        }
    }
    let mut status = vec!["-C", "../..", "status", "--porcelain", "--untracked-files=no", "--"];
    status.extend(SOURCES);
    let changed = !answer("git", &status)?.is_empty();
    Some(marked(&answer("git", &["rev-parse", "--short=12", "HEAD"])?, changed))
}

fn marked(revision: &str, changed: bool) -> String {
    format!("{revision}{}", if changed { "-changed" } else { "" })
}

fn watch(path: &str) {
    if Path::new(path).exists() {
        println!("cargo:rerun-if-changed={path}");
    }
}

fn tell(name: &str, value: Option<String>) {
    if let Some(value) = value {
        println!("cargo:rustc-env={name}={value}");
    }
}

fn answer(program: &str, arguments: &[&str]) -> Option<String> {
    let output = Command::new(program).args(arguments).output().ok()?;
    let text = String::from_utf8(output.stdout).ok()?;
    output.status.success().then(|| text.trim().to_owned())
}
