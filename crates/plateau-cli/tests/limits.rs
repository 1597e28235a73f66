//! What is too large is refused before memory is taken for it: the command refuses each file in an address space of 64 MiB,
//! and the largest experiments that make sense are admitted.

#![cfg(target_os = "linux")]

use std::fs;
use std::process::{Command, Stdio};

use experiment::{MAX_FILE_SIZE, MAX_KEYS, MAX_TOKENS, Plan};

const LARGEST: usize = MAX_FILE_SIZE as usize;

/// As many units as fit between a beginning and an end.
fn filled(size: usize, begin: &str, unit: &str, end: &str) -> String {
    let count = (size - begin.len() - end.len()) / unit.len();
    format!("{begin}{}{end}", unit.repeat(count))
}

fn numbered(size: usize, entry: impl Fn(usize) -> String) -> String {
    let mut text = String::new();
    for k in 0.. {
        let next = entry(k);
        if text.len() + next.len() > size {
            break;
        }
        text += &next;
    }
    text
}

/// Texts of a size that are costly to read, each in its own way.
fn costly(size: usize) -> Vec<(&'static str, String)> {
    let boundary = "title = \"x\"\n[boundary]\nu0 = [";
    vec![
        ("points", filled(size, boundary, "[1,2,3],", "]\n")),
        ("numbers", filled(size, boundary, "1,", "]\n")),
        ("empty points", filled(size, boundary, "[],", "]\n")),
        ("methods", filled(size, "title = \"x\"\n", "[[method]]\n", "")),
        ("named methods", filled(size, "title = \"x\"\n", "[[method]]\nname = \"a\"\n", "")),
        ("inline methods", filled(size, "title = \"x\"\nmethod = [", "{},", "]\n")),
        ("published", filled(size, "title = \"x\"\n[[method]]\npublished = [", "{},", "]\n")),
        ("keys", numbered(size, |k| format!("{k:x} = 1\n"))),
        ("dotted keys", numbered(size, |k| format!("a{k:x}.b.c.d = 1\n"))),
        ("digits as keys", numbered(size, |k| format!("{k}.1.2.3 = 1\n"))),
        ("tables", numbered(size, |k| format!("[t{k:x}]\n"))),
        ("one table again and again", filled(size, "", "[a]\n", "")),
        ("nested lists", filled(size, "a = ", "[", "")),
        ("nested tables", filled(size, "a = ", "{a = ", "")),
        ("one long dotted key", filled(size, "", "a.", "a = 1")),
        ("one long key", filled(size, "", "k", " = 1")),
        ("one long text", filled(size, "title = \"", "t", "\"\n")),
        ("escapes", filled(size, "title = \"", "\\q", "\"\n")),
        ("backslashes", filled(size, "title = \"", "\\", "")),
        ("controls", filled(size, "", "\u{1}", "")),
        ("equals", filled(size, "", "=\n", "")),
        ("quotes", filled(size, "", "\"\n", "")),
        ("quotes in one line", filled(size, "", "\"", "")),
        ("open lists", filled(size, "", "= [\n", "")),
        ("comments", filled(size, "", "#\n", "")),
        ("empty lines", filled(size, "", "\n", "")),
        ("commas", filled(size, "a = [", ",", "]")),
    ]
}

/// A net in which the GT basis, too, can be read, lest that be why a text is refused.
const NET: &str = "title = \"x\"\n[boundary]\nu0 = [[0,0,0],[0,1,0],[0,2,1]]\nu1 = [[2,0,1],[2,1,0],[2,2,0]]\n\
                   v0 = [[0,0,0],[1,0,0],[2,0,1]]\nv1 = [[0,2,1],[1,2,0],[2,2,0]]\n";

/// Other large demands, each in a small file, with the words in which the refusal states the limit.
fn greedy() -> Vec<(&'static str, &'static str, String)> {
    let method = "[[method]]\nname = \"m\"\nbasis = \"gt\"\nenergy = \"dirichlet\"\nsearch = true\n";
    let rows = "title = \"x\"\n[boundary]\nu0 = [[0,0,0],[1,0,1]]\nu1 = [[0,1,0],[1,1,0]]\n";
    let helicoid = "title = \"x\"\n[helicoid]\na = 1\nb = 0\nu-span = 3\nv-span = 3\n";
    vec![
        (
            "degree",
            "and 64",
            format!("{rows}u-degree = 1000000000\n[[method]]\nname = \"m\"\nconstruction = \"harmonic\"\n"),
        ),
        (
            "raise",
            "and 64",
            format!("{NET}[[method]]\nname = \"m\"\nenergy = \"dirichlet\"\nraise = 1000000000\n"),
        ),
        ("particles", "and 100000", format!("{NET}{method}[search]\nparticles = 1000000000000\n")),
        (
            "product",
            "at most 1000000000 ",
            format!("{NET}{method}[search]\nparticles = 10000\niterations = 10000\nruns = 10000\n"),
        ),
        ("runs", "and 10000", format!("{NET}{method}[search]\nruns = 9223372036854775807\n")),
        (
            "metric steps",
            "and 1000",
            format!("{NET}[[method]]\nname = \"m\"\nenergy = \"dirichlet\"\nmetric-steps = 1000000000\n"),
        ),
        (
            "mesh",
            "and 2000",
            format!("{NET}[[method]]\nname = \"m\"\nenergy = \"dirichlet\"\n[output]\nmesh = 100000\n"),
        ),
        (
            "mesh beyond",
            "and 2000",
            format!(
                "{NET}[[method]]\nname = \"m\"\nenergy = \"dirichlet\"\n[output]\nmesh = 18446744073709551616\n"
            ),
        ),
        ("frames", "and 1000", format!("{helicoid}frames = 1000000000\n")),
        ("frames and mesh", "mesh = 62", format!("{helicoid}frames = 1000\n[output]\nmesh = 2000\n")),
        (
            "histories",
            "at most 1500000",
            format!("{NET}{method}[search]\nparticles = 1\niterations = 1000000\nruns = 1000\n"),
        ),
        (
            "path degree",
            "and 64",
            format!("{helicoid}frames = 3\npath = \"bernstein\"\npath-degree = 1000000000\n"),
        ),
        (
            "samples",
            "and 100000",
            "title = \"x\"\n[curve]\nbasis = \"bernstein\"\npoints = [[0,0],[1,1]]\nsamples = 1000000000\n"
                .to_owned(),
        ),
        ("span", "and 100", helicoid.replace("u-span = 3", "u-span = 1e300")),
    ]
}

/// Exit status and report of `plateau check` in an address space of 64 MiB: what is resident is a part of that.
fn check(text: &str) -> (Option<i32>, String) {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("large.toml");
    fs::write(&file, text).unwrap();
    let output = Command::new("sh")
        .args(["-c", "ulimit -v 65536 && exec \"$0\" check \"$1\"", env!("CARGO_BIN_EXE_plateau")])
        .arg(&file)
        .stdin(Stdio::null())
        .output()
        .expect("a shell");
    (output.status.code(), String::from_utf8(output.stderr).expect("UTF-8"))
}

/// Exit status and all output of `plateau run` in an address space of so many MiB.
fn run_in(mebibytes: usize, text: &str) -> (Option<i32>, String) {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("large.toml");
    fs::write(&file, text).unwrap();
    let limit = format!("ulimit -v {}; ulimit -c 0; exec \"$0\" run \"$1\" --threads 1", 1024 * mebibytes);
    let output = Command::new("sh")
        .args(["-c", &limit, env!("CARGO_BIN_EXE_plateau")])
        .arg(&file)
        .current_dir(folder.path())
        // The limit is on addresses, of which the allocator of glibc reserves 64 MiB more where a second thread happens to allocate.
        .env("MALLOC_ARENA_MAX", "1")
        .stdin(Stdio::null())
        .output()
        .expect("a shell");
    let text = |bytes| String::from_utf8(bytes).expect("UTF-8");
    (output.status.code(), text(output.stdout) + &text(output.stderr))
}

#[test]
fn lack_of_memory_is_an_error_of_the_method_that_lacks_it() {
    let boundary = |degree: u8| {
        let side = |of: &dyn Fn(f64) -> [f64; 3]| {
            format!("{:?}", (0..=degree).map(|k| of(f64::from(k) / f64::from(degree))).collect::<Vec<_>>())
        };
        format!(
            "title = \"x\"\n[boundary]\nu0 = {}\nu1 = {}\nv0 = {}\nv1 = {}\n",
            side(&|t| [0.0, t, 0.0]),
            side(&|t| [1.0, t, t]),
            side(&|t| [t, 0.0, 0.0]),
            side(&|t| [t, 1.0, t])
        )
    };
    let small = "[[method]]\nname = \"small\"\nconstruction = \"discrete-coons\"\n";
    let output = "[output]\nmesh = 2\npictures = false\n";
    for (name, degree, large, output, at_least) in [
        ("dense", 60, "energy = \"bending\"\nsolver = \"dense\"", output, "about 8"),
        ("area", 30, "basis = \"gt\"\nshape = [1, 1, 1, 1]\nenergy = \"area\"", output, "about 2"),
        (
            "mesh",
            60,
            "construction = \"discrete-coons\"",
            "[output]\nmesh = 1400\npictures = false\n",
            "about 25",
        ),
    ] {
        let text = format!("{}{small}[[method]]\nname = \"large\"\n{large}\n{output}", boundary(degree));
        for mebibytes in [64, 100, 200] {
            let (status, said) = run_in(mebibytes, &text);
            assert_eq!(status, Some(1), "{name} in {mebibytes} MiB: {said}");
            let whole = said.replace('\n', " ");
            assert!(whole.contains("out of memory: ") && whole.contains(at_least), "{name}: {said}");
            // The other method keeps its row, unless it lacks the same.
            assert_eq!(
                whole.matches("out of memory").count(),
                if name == "mesh" { 2 } else { 1 },
                "{name}: {said}"
            );
        }
    }
    // Extremals that are solved direction by direction need none of it, nor least areas that are sought by displacements of low degree.
    let boundary = boundary(60);
    for energy in ["bending", "area"] {
        let text = format!("{boundary}{small}[[method]]\nname = \"large\"\nenergy = \"{energy}\"\n{output}");
        let (status, said) = run_in(120, &text);
        assert_eq!(status, Some(0), "{said}");
    }
}

#[test]
fn lack_of_memory_for_a_mesh_is_said_by_export() {
    let folder = tempfile::tempdir().unwrap();
    let method = "[[method]]\nname = \"m\"\nenergy = \"dirichlet\"\n";
    fs::write(folder.path().join("m.toml"), format!("{NET}{method}[output]\nmesh = 2\npictures = false\n"))
        .unwrap();
    let shell = |script: &str| {
        Command::new("sh")
            .args(["-c", &format!("ulimit -c 0; {script}"), env!("CARGO_BIN_EXE_plateau")])
            .current_dir(folder.path())
            .output()
            .expect("a shell")
    };
    assert!(shell("\"$0\" run m.toml --out out").status.success());
    for format in ["obj", "ply", "stl", "glb", "vtu"] {
        let output = shell(&format!(
            "ulimit -v 100000; exec \"$0\" export out/m/result.json --format {format} --mesh 2000 --out x.{format}"
        ));
        let said = String::from_utf8(output.stderr).unwrap();
        assert_eq!(output.status.code(), Some(1), "{said}");
        assert!(said.starts_with(&format!("error: x.{format}: not written: out of memory: ")), "{said}");
        assert_eq!(said.lines().count(), 1, "{said}");
        assert!(!folder.path().join(format!("x.{format}")).exists());
    }
}

#[test]
fn costly_texts_are_refused_in_64_mib() {
    // As large as is admitted, too large by a byte, and as large as the limits of tokens let pass.
    for size in [LARGEST, MAX_TOKENS, MAX_TOKENS / 4] {
        for (name, text) in costly(size) {
            let (status, report) = check(&text);
            assert_eq!(status, Some(2), "{name}, {size} bytes: {report}");
            assert!(report.starts_with("error: ") && report.len() < 20_000, "{name}: {report}");
            assert!(report.contains("large.toml:"), "{name}, {size} bytes: {report}");
        }
    }
    let (status, report) = check(&"#".repeat(LARGEST + 1));
    assert_eq!(status, Some(2), "{report}");
    assert!(report.contains("above the limit of 1048576"), "{report}");
}

#[test]
fn greedy_demands_are_refused_in_64_mib_with_the_limit() {
    for (name, limit, text) in greedy() {
        let (status, report) = check(&text);
        assert_eq!(status, Some(2), "{name}: {report}");
        // For nothing but the demand.
        assert_eq!(report.matches("error: ").count(), 1, "{name}: {report}");
        assert!(report.contains("help: ") && report.contains(limit), "{name}: {report}");
    }
}

#[test]
fn keys_and_tokens_are_counted_where_they_become_too_many() {
    let text = numbered(LARGEST, |k| format!("{k:x} = 1\n"));
    let refusal = Plan::parse("keys.toml", &text).unwrap_err();
    let line = refusal.position(&refusal.diagnostics()[0]).map(|(line, _)| line);
    assert_eq!((line, refusal.diagnostics().len()), (Some(MAX_KEYS + 1), 1), "{refusal}");
    let text = "\n".repeat(MAX_TOKENS + 1);
    let refusal = Plan::parse("tokens.toml", &text).unwrap_err();
    let line = refusal.position(&refusal.diagnostics()[0]).map(|(line, _)| line);
    assert_eq!(line, Some(MAX_TOKENS + 1), "{refusal}");
}

/// Four sides of degree 64 and a thousand methods, each with several expected numbers, all with 17 digits; 40 000 samples.
#[test]
fn the_largest_experiments_are_admitted() {
    let side = |f: &dyn Fn(f64) -> [f64; 3]| -> String {
        let points: Vec<String> = (0..=64)
            .map(|k| f(f64::from(k) / 64.0))
            .map(|p| format!("[{:.16e}, {:.16e}, {:.16e}]", p[0], p[1], p[2]))
            .collect();
        points.join(", ")
    };
    let z = |u: f64, v: f64| (u - v) / 3.0;
    let mut text = format!(
        "title = \"largest\"\n[boundary]\nu0 = [{}]\nu1 = [{}]\nv0 = [{}]\nv1 = [{}]\n",
        side(&|t| [0.0, t, z(0.0, t)]),
        side(&|t| [1.0, t, z(1.0, t)]),
        side(&|t| [t, 0.0, z(t, 0.0)]),
        side(&|t| [t, 1.0, z(t, 1.0)]),
    );
    for k in 0..1000 {
        text += &format!(
            "[[method]]\nname = \"method {k}\"\nbasis = \"bernstein\"\nenergy = \"dirichlet\"\n[method.expect]\n\
             dirichlet = 1.1111111111111111\narea = 1.1055415967851332\n"
        );
    }
    assert!(text.len() < LARGEST / 4, "{}", text.len());
    assert!(Plan::parse("largest.toml", &text).is_ok_and(|plan| plan.text.len() == text.len()));
    let samples: Vec<String> = (0..40_000).map(|k| format!("{:.17}", f64::from(k) / 40_000.0)).collect();
    let text = format!(
        "title = \"c\"\n[curve]\nbasis = \"bernstein\"\npoints = [[0,0],[1,1]]\nsamples = [{}]\n",
        samples.join(", ")
    );
    if let Err(refusal) = Plan::parse("samples.toml", &text) {
        panic!("{refusal}");
    }
}

#[test]
fn what_methods_keep_together_is_bounded() {
    let methods = |count: usize, more: &str| -> String {
        (0..count).map(|k| format!("[[method]]\nname = \"m{k}\"\nenergy = \"dirichlet\"\n{more}")).collect()
    };
    let searched = "basis = \"gt\"\nsearch = ";
    let parsed = |more: String| Plan::parse("x.toml", &format!("{NET}{more}"));
    let admitted = |more: String| parsed(more).unwrap_or_else(|refusal| panic!("{refusal}"));
    let refused = |more: String, words: &str| {
        let refusal = parsed(more).unwrap_err().to_string();
        assert!(refusal.contains(words), "{refusal}");
    };
    let mesh = |count, mesh| format!("{}[output]\nmesh = {mesh}\n", methods(count, ""));
    admitted(mesh(4, 2000));
    admitted(mesh(5, 1788));
    refused(mesh(5, 2000), "write mesh = 1788,");
    refused(mesh(5, 1789), "write mesh = 1788,");
    let search = |count, mode: &str, runs| {
        format!(
            "{}[search]\niterations = 999\nruns = {runs}\n",
            methods(count, &format!("{searched}{mode}\n"))
        )
    };
    admitted(search(1, "true", 1500));
    admitted(search(3, "\"pso\"", 500));
    refused(search(1, "true", 1501), "1501000 numbers, at most 1500000");
    refused(search(3, "\"pso\"", 501), "3 swarms × 501 runs × 999 iterations");
    // A descent keeps no history.
    admitted(search(3, "\"polish\"", 501));
}
