//! Degenerate boundaries, masks, shapes, spans and degrees: a warning or an error that names the cause, and no number that
//! is not finite in any file that is written.

#![allow(clippy::print_stdout)] // The counts are the figures asked for.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

use base64::prelude::{BASE64_STANDARD, Engine};
use experiment::{Finished, Options, Plan, run};
use record::{ResultFile, deliver};

fn fixtures() -> BTreeMap<String, PathBuf> {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../../fixtures/degenerate");
    fs::read_dir(folder)
        .expect("the folder is part of the repository")
        .map(|entry| entry.expect("a readable folder").path())
        .map(|path| (path.file_stem().unwrap().to_string_lossy().into_owned(), path))
        .collect()
}

fn finished(path: &Path) -> (Plan, Finished) {
    let plan = Plan::read(path).unwrap_or_else(|refusal| panic!("{refusal}"));
    let finished = run(&plan, Options::default(), &()).expect("a kind of experiment that is offered");
    (plan, finished)
}

/// What is said of a finished experiment: its own warnings, and "name: …" for those of its methods and their errors.
fn said(finished: &Finished) -> Vec<String> {
    let of_methods = finished.results.methods().iter().flat_map(|method| match &method.outcome {
        Ok(done) => done.warnings.iter().map(|w| format!("{}: {w}", method.name)).collect(),
        Err(error) => vec![format!("{}: failed: {error}", method.name)],
    });
    finished.results.remarks().iter().map(ToString::to_string).chain(of_methods).collect()
}

/// For each fixture: every line names words that one thing said must hold.
const CAUSES: &[(&str, &[&[&str]])] = &[
    (
        "coincident",
        &[
            &["all points of the boundary coincide at [1, 2, 3]"],
            &["Dirichlet: the patch has no area beyond rounding", "left out"],
            &["least area: failed", "singular", "coincident"],
            &["metric: failed", "singular", "coincident"],
        ],
    ),
    (
        "collinear",
        &[
            &["all points of the boundary lie on one straight line"],
            &["Dirichlet: the patch has no area"],
            &["TB–Coons: the patch has no area"],
            &["search: the patch has no area"],
            &["least area: failed", "collinear"],
        ],
    ),
    (
        "folded",
        &[
            &["the sides `u0` and `u1` are the same curve", "fold"],
            &["the side `v0` is one point, [0, 0, 0]"],
            &["the side `v1` is one point, [6, 0, 0]"],
            &["Coons: the patch has no area"],
            &["Dirichlet: the area has not settled", "folds"],
            &["harmonic: failed: no harmonic net"],
        ],
    ),
    (
        "crossing",
        &[
            &["planar and crosses itself near [3, 3, 0]"],
            &["Dirichlet: the area has not settled", "folds"],
            &["least area: the area has not settled", "folds"],
            &["metric: the area has not settled", "folds"],
        ],
    ),
    (
        "corner",
        &[
            &["the sides `u0` and `v0` meet at the corner P_00 under 0°"],
            &["points 0 and 1 of `u1` coincide", "corner P_m0"],
            &["bending: the root mean square of H is left out", "singular"],
        ],
    ),
    ("edge-in-a-point", &[&["the side `u0` is one point, [0, 0, 0]"]]),
    (
        "triangle-folded",
        &[
            &["the sides `ab` and `bc` are the same curve"],
            &["the side `ca` is one point"],
            &["mask: the area has not settled", "folds"],
            &["least area: failed", "singular"],
        ],
    ),
    (
        "singular-mask",
        &[&["Coons mask: failed: the Coons mask is exactly singular", "degree 6", "raise = 1"]],
    ),
    (
        "singular-tensor-mask",
        &[
            &["singular: failed: the mask is singular at the corner weight α = -0.5", "another weight"],
            &["nearly singular: the control points are ill-conditioned (about 3e12)"],
        ],
    ),
    ("shape-at-the-edge", &[]),
    ("span-at-the-edge", &[&["within 6e-5 % of the bound 7.853205"]]),
    (
        "high-degree",
        &[
            &["Dirichlet: parts of the extremal", "left out", "lower degree"],
            &["Dirichlet: the control points reach 1e8 times as far out as the boundary"],
            &["bending: parts of the extremal", "left out", "oscillate less"],
            &["dense: failed: at degree 40 the condition", "leave out `solver`"],
        ],
    ),
];

#[test]
fn the_cause_is_named() {
    let fixtures = fixtures();
    let named: Vec<&str> = CAUSES.iter().map(|(name, _)| *name).collect();
    assert_eq!(fixtures.keys().filter(|name| !named.contains(&name.as_str())).count(), 0, "{fixtures:?}");
    for (name, causes) in CAUSES {
        let (_, finished) = finished(&fixtures[*name]);
        assert_eq!(finished.missed(), [], "{name}");
        let said = said(&finished);
        for words in *causes {
            let names = |text: &String| words.iter().all(|word| text.contains(word));
            assert!(said.iter().any(names), "{name}: nothing says {words:?} in {said:#?}");
        }
        if causes.is_empty() {
            assert_eq!(said, Vec::<String>::new(), "{name}");
        }
    }
}

#[test]
fn every_missing_figure_is_explained() {
    for (name, path) in fixtures() {
        let (plan, finished) = finished(&path);
        for method in finished.results.methods() {
            let Ok(done) = &method.outcome else { continue };
            let f = &done.figures;
            for (missing, word) in [
                (f.conformality_gap.is_none(), "left out"),
                (f.mean_curvature_max.is_none(), "mean curvature"),
                (f.mean_curvature_rms.is_none(), "left out"),
                (!f.area.settled && f.conformality_gap.is_some(), "has not settled"),
            ] {
                let explained = done.warnings.iter().any(|warning| warning.to_string().contains(word));
                assert!(!missing || explained, "{name}, {}: {word} in {:#?}", method.name, done.warnings);
            }
            for x in [f.dirichlet, f.area, f.laplacian_defect, f.bending] {
                assert!(x.value.is_finite() && x.error.is_finite(), "{name}, {}: {x:?}", method.name);
            }
        }
        let json = ResultFile::new(&plan, &finished).to_json().unwrap();
        assert!(!json.contains("null"), "{name}");
    }
}

#[test]
fn no_written_number_is_not_finite() {
    let out = tempfile::tempdir().unwrap();
    let mut files = BTreeMap::new();
    for (name, path) in fixtures() {
        let (plan, finished) = finished(&path);
        let delivered = deliver(&plan, &finished, out.path()).unwrap();
        // A surface in one point is none that STEP tells from a point.
        let right = |reason: String| name == "coincident" && reason.contains("told apart from");
        assert!(delivered.refusals.iter().all(|r| right(r.to_string())), "{name}: {:?}", delivered.refusals);
        for entry in fs::read_dir(&delivered.folder).unwrap() {
            let path = entry.unwrap().path();
            let kind = path.extension().unwrap().to_string_lossy().into_owned();
            let bytes = fs::read(&path).unwrap();
            match kind.as_str() {
                "stl" => bytes[84..].chunks_exact(50).for_each(|t| singles(&t[..48], &path)),
                "glb" => glb(&bytes, &path),
                "ply" => ply(&bytes, &path),
                "vtu" => vtu(&String::from_utf8(bytes).unwrap(), &path),
                "html" => words(&without_scripts(&String::from_utf8(bytes).unwrap()), &path),
                "json" | "obj" | "step" | "svg" | "csv" => words(&String::from_utf8(bytes).unwrap(), &path),
                other => panic!("a file of an unknown kind: {other}"),
            }
            *files.entry(kind).or_insert(0) += 1;
        }
    }
    println!("files read back: {files:?}");
    for kind in ["json", "obj", "ply", "stl", "glb", "vtu", "step", "svg", "html", "csv"] {
        assert!(files.contains_key(kind), "no {kind} was written: {files:?}");
    }
}

/// No word of a text is a spelling of a number that is not finite.
fn words(text: &str, path: &Path) {
    let word = text
        .split(|c: char| !(c.is_alphanumeric() || c == '_'))
        .find(|word| ["nan", "inf", "infinity", "1e999"].contains(&word.to_lowercase().as_str()));
    assert_eq!(word, None, "{}", path.display());
}

fn singles(bytes: &[u8], path: &Path) {
    for word in bytes.chunks_exact(4) {
        assert!(f32::from_le_bytes(word.try_into().unwrap()).is_finite(), "{}", path.display());
    }
}

fn doubles(bytes: &[u8], path: &Path) {
    for word in bytes.chunks_exact(8) {
        assert!(f64::from_le_bytes(word.try_into().unwrap()).is_finite(), "{}", path.display());
    }
}

/// The program of a report speaks of NaN and Infinity as its language does; its text and its numbers must not.
fn without_scripts(html: &str) -> String {
    html.split("<script").map(|part| part.split_once("</script>").map_or(part, |(_, rest)| rest)).collect()
}

/// Floats of every accessor, through its view of the binary chunk.
fn glb(bytes: &[u8], path: &Path) {
    let word = |at: usize| u32::from_le_bytes(bytes[at..at + 4].try_into().unwrap()) as usize;
    let json: serde_json::Value = serde_json::from_slice(&bytes[20..20 + word(12)]).unwrap();
    words(&json.to_string(), path);
    let binary = &bytes[28 + word(12)..];
    for accessor in json["accessors"].as_array().unwrap() {
        if accessor["componentType"] == 5126 {
            let view = &json["bufferViews"][accessor["bufferView"].as_u64().unwrap() as usize];
            let start = view["byteOffset"].as_u64().unwrap_or(0) as usize;
            singles(&binary[start..start + view["byteLength"].as_u64().unwrap() as usize], path);
        }
    }
}

fn ply(bytes: &[u8], path: &Path) {
    const END: &[u8] = b"end_header\n";
    let end = bytes.windows(END.len()).position(|window| window == END).unwrap() + END.len();
    let header = std::str::from_utf8(&bytes[..end]).unwrap();
    words(header, path);
    let count: usize =
        header.lines().find_map(|line| line.strip_prefix("element vertex ")).unwrap().parse().unwrap();
    let of_vertices = header.split("element face").next().unwrap();
    let [wide, narrow] = ["property double", "property uchar"].map(|p| of_vertices.matches(p).count());
    for vertex in bytes[end..].chunks_exact(8 * wide + narrow).take(count) {
        doubles(&vertex[..8 * wide], path);
    }
}

fn vtu(text: &str, path: &Path) {
    let mut arrays = 0;
    for array in text.split("<DataArray").skip(1).filter(|array| array.contains("Float64")) {
        let data = array.split_once('>').unwrap().1.split('<').next().unwrap().trim();
        doubles(&BASE64_STANDARD.decode(data).unwrap()[8..], path);
        arrays += 1;
    }
    assert!(arrays >= 4, "{}", path.display());
}
