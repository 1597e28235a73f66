//! What a result says of the program that made it: the revision of the source, where there is a git checkout to ask, the
//! compiler, the dependencies.
#![allow(clippy::print_stdout, reason = "this is how a build script speaks to cargo")]

use std::process::Command;

use sha2::{Digest, Sha256};

fn main() {
    println!("cargo:rerun-if-changed=build.rs");
    println!("cargo:rerun-if-env-changed=PLATEAU_REVISION");
    if std::env::var_os("PLATEAU_REVISION").is_none() {
        for file in ["HEAD", "logs/HEAD"] {
            // Where that is depends on the kind of checkout.
            let path = answer("git", &["rev-parse", "--git-path", file]);
            if let Some(path) = path.filter(|path| std::path::Path::new(path).exists()) {
                println!("cargo:rerun-if-changed={path}");
            }
        }
        tell("PLATEAU_REVISION", answer("git", &["rev-parse", "--short=12", "HEAD"]));
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
