//! Files for other programs, read back by small parsers; results read back bit for bit.

use std::collections::BTreeMap;
use std::fs;
use std::path::PathBuf;
use std::process::Command;

use base64::prelude::{BASE64_STANDARD, Engine};
use exchange::{DEFAULT_TOLERANCE, Format};
use experiment::{Options, Plan, Template, run};
use plateau::{Family, Surface};
use proptest::prelude::*;
use record::{Destination, ExportError, ReadError, StoredResult, deliver};

const NET: &str = "[boundary]\n\
    u0 = [[0, 0, 0], [2, 0, 2], [4, 0, -2], [6, 0, 0]]\nu1 = [[0, 6, 0], [2, 6, 2], [4, 6, -2], [6, 6, 0]]\n\
    v0 = [[0, 0, 0], [0, 2, 2], [0, 4, -2], [0, 6, 0]]\nv1 = [[6, 0, 0], [6, 2, 2], [6, 4, -2], [6, 6, 0]]\n";

const METHODS: &str = "[[method]]\nname = 'Bernstein'\nenergy = 'dirichlet'\n\
    [[method]]\nname = 'GT'\nbasis = 'gt'\nenergy = 'dirichlet'\nshape = [0.3, 2, 4, 1]\n\
    [[method]]\nname = 'Coons'\npatch = 'tb-coons'\nenergy = 'dirichlet'\nshape = [1, 0.5, 2, 3]\n";

const TRIANGLE: &str = "[boundary]\nab = [[0, 0, 0], [1, 0, 1], [3, 0, 0]]\nbc = [[3, 0, 0], [2, 2, 1], [1, 3, 0]]\n\
    ca = [[1, 3, 0], [0, 1, -1], [0, 0, 0]]\n[[method]]\nname = 'triangle'\nenergy = 'dirichlet'\n";

const FORMATS: &str =
    "[output]\nmesh = 6\nformats = ['obj', 'ply', 'stl', 'glb', 'vtu', 'vtu-bezier', 'step']\n";

/// A folder of its own for each test, removed at its end.
struct Folder(PathBuf);

impl Folder {
    fn new(name: &str) -> Self {
        let folder = std::env::temp_dir().join(format!("plateau-export-{}-{name}", std::process::id()));
        fs::create_dir_all(&folder).unwrap();
        Self(folder)
    }
}

impl Drop for Folder {
    fn drop(&mut self) {
        let _ = fs::remove_dir_all(&self.0);
    }
}

fn plans() -> Vec<Plan> {
    let helicoid = "[helicoid]\na = 1.0\nb = 2.0\nu-span = 1.5\nv-span = 12.0\n";
    let trapezium = "[trapezium-helicoid]\nspan = 3.9\ngamma = [6.2, 12.5]\nbeta = [1.0, 0.5]\n";
    [
        ("net", &*format!("{NET}{METHODS}")),
        ("triangle", TRIANGLE),
        ("helicoid", helicoid),
        ("trapezium", trapezium),
    ]
    .map(|(name, body)| {
        Plan::parse(&format!("{name}.toml"), &format!("title = 'α {name}'\n{body}{FORMATS}")).unwrap()
    })
    .into()
}

/// What follows a tag up to the next line break.
fn after<'a>(text: &'a str, tag: &str) -> &'a str {
    text.split_once(tag).unwrap_or_else(|| panic!("{tag}")).1.lines().next().unwrap()
}

fn doubles(bytes: &[u8]) -> Vec<f64> {
    bytes.chunks_exact(8).map(|b| f64::from_le_bytes(b.try_into().unwrap())).collect()
}

#[test]
fn stored_surfaces_are_those_that_were_found() {
    let folder = Folder::new("stored");
    for plan in plans() {
        let finished = run(&plan, Options::default(), &()).unwrap();
        let delivered = deliver(&plan, &finished, &folder.0).unwrap();
        assert!(delivered.refusals.is_empty());
        let stored = StoredResult::read(&delivered.folder.join("result.json")).unwrap();
        assert_eq!(stored.methods.len(), finished.results.methods().len());
        for (stored, method) in stored.methods.iter().zip(finished.results.methods()) {
            let (surface, family) = stored.surface.as_ref().unwrap();
            let done = method.outcome.as_ref().unwrap();
            assert_eq!((&stored.name, *family), (&method.name, done.solved.family()));
            assert_eq!(surface.mesh(6).unwrap(), done.mesh, "{}", stored.name);
            for format in Format::ALL {
                let written = delivered.folder.join(format!("{}.{}", stored.file_name, format.ending()));
                let again = folder.0.join("again");
                stored.export(format, 6, DEFAULT_TOLERANCE, &Destination::own(again.clone())).unwrap();
                assert_eq!(fs::read(written).unwrap(), fs::read(again).unwrap(), "{} {format}", stored.name);
            }
        }
    }
}

#[test]
fn films_are_read_back_and_written_in_every_format() {
    let folder = Folder::new("films");
    let text = format!(
        "{}formats = [\"obj\", \"ply\", \"stl\", \"glb\", \"vtu\", \"vtu-bezier\", \"step\"]\n",
        Template::Faces.text().replace("formats", "# ")
    );
    let plan = Plan::parse("film.toml", &text).unwrap();
    let finished = run(&plan, Options::default(), &()).unwrap();
    let delivered = deliver(&plan, &finished, &folder.0).unwrap();
    assert!(delivered.refusals.is_empty(), "{:?}", delivered.refusals);
    let stored = StoredResult::read(&delivered.folder.join("result.json")).unwrap();
    let (surface, family) = stored.methods[0].surface.as_ref().unwrap();
    let found = finished.results.methods()[0].outcome.as_ref().unwrap();
    let (Surface::Complex(ours), Surface::Complex(theirs)) = (surface, found.solved.surface()) else {
        panic!("{surface:?}")
    };
    assert_eq!((*family, ours.edges().len()), (Family::Complex, theirs.edges().len()));
    for face in 0..theirs.faces().len() {
        assert_eq!(ours.net(face).unwrap().points(), theirs.net(face).unwrap().points(), "face {face}");
    }
    // Three films meet in the free line from head to foot.
    assert!(ours.edges().iter().any(|edge| edge.uses().len() == 3));
    for format in Format::ALL {
        let again = folder.0.join(format!("again.{format}"));
        stored.methods[0].export(format, 48, DEFAULT_TOLERANCE, &Destination::own(again.clone())).unwrap();
        let written = fs::read(delivered.folder.join(format!("least-area.{}", format.ending()))).unwrap();
        // The record does not number vertices: they may come in another order, and some digits more or less with them.
        let (again, written) = (fs::read(again).unwrap().len(), written.len());
        assert!(again.abs_diff(written) <= written / 100, "{format}: {again} and {written} bytes");
    }
}

#[test]
fn meshes_hold_what_the_mesh_knows() {
    let folder = Folder::new("meshes");
    let plan = &plans()[0];
    let finished = run(plan, Options::default(), &()).unwrap();
    let delivered = deliver(plan, &finished, &folder.0).unwrap();
    let mesh = &finished.results.methods()[0].outcome.as_ref().unwrap().mesh;
    let read = |format: &str| fs::read(delivered.folder.join(format!("bernstein.{format}"))).unwrap();
    let coordinates: Vec<f64> = mesh.points.iter().flat_map(|p| [p.x, p.y, p.z]).collect();

    let ply = read("ply");
    let end = b"end_header\n";
    let body = ply.windows(end.len()).position(|window| window == end).unwrap() + end.len();
    let header = str::from_utf8(&ply[..body]).unwrap();
    assert!(header.starts_with("ply\nformat binary_little_endian 1.0\n"));
    assert_eq!(after(header, "element vertex "), "49");
    assert_eq!(after(header, "element face "), "72");
    assert!(!header.contains("singular"));
    let stride = 10 * 8 + 3;
    for (k, vertex) in ply[body..].chunks_exact(stride).take(49).enumerate() {
        let numbers = doubles(&vertex[..80]);
        assert_eq!(numbers[..3], coordinates[3 * k..][..3]);
        assert_eq!(numbers[6..8], mesh.parameters[k]);
        assert_eq!(numbers[8..], [mesh.mean_curvature[k].unwrap(), mesh.gauss_curvature[k].unwrap()]);
        let [red, .., blue] = vertex[80..] else { panic!("three colours") };
        assert_eq!(red >= blue, numbers[8] >= 0.0 || red == blue, "{numbers:?}");
    }
    assert_eq!(ply.len(), body + 49 * stride + 72 * 13);

    let stl = read("stl");
    assert_eq!((stl.len(), stl[80..84].to_vec()), (84 + 72 * 50, 72u32.to_le_bytes().to_vec()));
    assert!(!stl.starts_with(b"solid"));
    for (facet, triangle) in stl[84..].chunks_exact(50).zip(&mesh.triangles) {
        let singles: Vec<f32> =
            facet[..48].chunks_exact(4).map(|b| f32::from_le_bytes(b.try_into().unwrap())).collect();
        let length: f32 = singles[..3].iter().map(|x| x * x).sum();
        assert!((length - 1.0).abs() < 1e-6);
        let corners: Vec<f32> = triangle
            .iter()
            .flat_map(|&k| coordinates[3 * k as usize..][..3].iter().map(|x| *x as f32))
            .collect();
        assert_eq!(singles[3..], corners);
    }

    let vtu = String::from_utf8(read("vtu")).unwrap();
    let array = |name: &str| -> Vec<u8> {
        let text = vtu.split_once(&format!("Name=\"{name}\"")).unwrap().1.lines().nth(1).unwrap();
        let bytes = BASE64_STANDARD.decode(text).unwrap();
        let (count, data) = bytes.split_at(8);
        assert_eq!(u64::from_le_bytes(count.try_into().unwrap()) as usize, data.len());
        data.to_vec()
    };
    assert_eq!(doubles(&array("points")), coordinates);
    let curvatures: Vec<f64> = mesh.mean_curvature.iter().map(|h| h.unwrap()).collect();
    assert_eq!(doubles(&array("mean_curvature")), curvatures);
    let connectivity: Vec<u8> =
        mesh.triangles.iter().flatten().flat_map(|&k| i64::from(k).to_le_bytes()).collect();
    assert_eq!(array("connectivity"), connectivity);
    assert_eq!(array("types"), [5; 72]);
}

/// Entities of a STEP file by number, after a check that every reference points backwards.
fn entities(step: &str) -> BTreeMap<usize, String> {
    let data = step.split_once("DATA;").unwrap().1.split_once("ENDSEC;").unwrap().0;
    let mut entities = BTreeMap::new();
    for entity in data.replace('\n', "").split(';').filter(|entity| !entity.is_empty()) {
        let (number, body) = entity.split_once('=').unwrap();
        let number: usize = number[1..].parse().unwrap();
        for reference in body.split('#').skip(1) {
            let digits: String = reference.chars().take_while(char::is_ascii_digit).collect();
            assert!(entities.contains_key(&digits.parse::<usize>().unwrap()), "{entity}");
        }
        entities.insert(number, body.to_owned());
    }
    entities
}

#[test]
fn step_files_hold_one_face_on_one_surface() {
    let folder = Folder::new("step");
    for plan in plans() {
        let finished = run(&plan, Options::default(), &()).unwrap();
        let delivered = deliver(&plan, &finished, &folder.0).unwrap();
        for method in StoredResult::read(&delivered.folder.join("result.json")).unwrap().methods {
            let step =
                fs::read_to_string(delivered.folder.join(format!("{}.step", method.file_name))).unwrap();
            assert!(
                step.starts_with("ISO-10303-21;\n")
                    && step.ends_with("END-ISO-10303-21;\n")
                    && step.is_ascii()
            );
            let entities = entities(&step);
            let of = |kind: &str| -> Vec<&String> {
                entities.values().filter(|body| body.starts_with(&format!("{kind}("))).collect()
            };
            let edges = if method.name == "triangle" { 3 } else { 4 };
            assert_eq!(
                (of("ADVANCED_FACE").len(), of("EDGE_CURVE").len(), of("ORIENTED_EDGE").len()),
                (1, edges, edges)
            );
            let surface = of("B_SPLINE_SURFACE_WITH_KNOTS")[0];
            let poles = surface.matches('#').count();
            let tail: Vec<&str> =
                surface.split(".UNSPECIFIED.,.F.,.F.,.F.,").nth(1).unwrap().split("),(").collect();
            let sum = |list: &str| -> usize {
                list.trim_matches(['(', ')']).split(',').map(|m| m.parse::<usize>().unwrap()).sum()
            };
            let degrees: Vec<usize> =
                surface.split(',').skip(1).take(2).map(|degree| degree.parse().unwrap()).collect();
            assert_eq!((sum(tail[0]) - degrees[0] - 1) * (sum(tail[1]) - degrees[1] - 1), poles);
            let exact = ["Bernstein", "triangle"].contains(&method.name.as_str());
            assert_eq!(exact, after(&step, "FILE_DESCRIPTION").contains("exact"), "{}", method.name);
            assert_eq!(exact, !step.contains("B-spline fit"), "{}", method.name);
        }
    }
}

#[test]
fn step_files_hold_the_net_of_a_bernstein_patch() {
    let folder = Folder::new("net");
    let plan = &plans()[0];
    let finished = run(plan, Options::default(), &()).unwrap();
    let delivered = deliver(plan, &finished, &folder.0).unwrap();
    let step = fs::read_to_string(delivered.folder.join("bernstein.step")).unwrap();
    let entities = entities(&step);
    let surface = entities.values().find(|body| body.starts_with("B_SPLINE_SURFACE")).unwrap();
    let points = surface.split('#').skip(1).map(|reference| {
        let digits: String = reference.chars().take_while(char::is_ascii_digit).collect();
        let body = &entities[&digits.parse().unwrap()];
        let numbers = body.split_once(",(").unwrap().1.trim_matches(')');
        assert!(numbers.split(',').all(|number| number.contains('.')), "{numbers}");
        numbers.split(',').map(|number| number.parse::<f64>().unwrap()).collect::<Vec<_>>()
    });
    let stored = StoredResult::read(&delivered.folder.join("result.json")).unwrap();
    let Ok((Surface::Tensor(patch), _)) = &stored.methods[0].surface else { panic!("a tensor patch") };
    let net: Vec<Vec<f64>> = patch.net().points().iter().map(|p| vec![p.x, p.y, p.z]).collect();
    assert_eq!(points.collect::<Vec<_>>(), net);
}

#[test]
fn refused_files_leave_the_result() {
    for size in ["6e50", "1e-45"] {
        refused_at(size);
    }
}

/// A net with one far corner, or so small that single precision holds few of its digits.
fn refused_at(size: &str) {
    let folder = Folder::new("refused");
    let far = match size {
        "6e50" => NET.replace("[6, 6, 0]", "[6e50, 6, 0]"),
        _ => "[boundary]\nu0 = [[0,0,0],[0,1e-45,0]]\nu1 = [[1e-45,0,0],[1e-45,1e-45,1e-45]]\n\
              v0 = [[0,0,0],[1e-45,0,0]]\nv1 = [[0,1e-45,0],[1e-45,1e-45,1e-45]]\n"
            .to_owned(),
    };
    let text = format!("title = 'far'\n{far}[[method]]\nname = 'far'\nenergy = 'dirichlet'\n{FORMATS}");
    let plan = Plan::parse("far.toml", &text).unwrap();
    let delivered = deliver(&plan, &run(&plan, Options::default(), &()).unwrap(), &folder.0).unwrap();
    let refused: Vec<String> = delivered.refusals.iter().map(ToString::to_string).collect();
    // Millimetres do not tell the tiny one from a point.
    assert_eq!(refused.len(), if size == "6e50" { 2 } else { 3 }, "{refused:?}");
    assert!(
        refused[0].contains("single precision of STL") && refused[1].contains("single precision of glTF")
    );
    let stored = StoredResult::read(&delivered.folder.join("result.json")).unwrap();
    let to = Destination::own(folder.0.join("x.stl"));
    let error = stored.methods[0].export(Format::Stl, 4, 1e-6, &to).unwrap_err();
    assert!(matches!(error, ExportError::Refused { .. }) && !folder.0.join("x.stl").exists());
}

#[test]
fn greedy_results_are_refused_before_they_fill_the_memory() {
    let many =
        format!("{{\"schema\": \"plateau-result/1\", \"methods\": [{}0]}}", "{\"\":0},".repeat(1_200_000));
    let said = StoredResult::parse(many.as_bytes()).unwrap_err().to_string();
    assert!(said.contains("more than 400000 tables"), "{said}");
    let folder = Folder::new("greedy");
    let path = folder.0.join("result.json");
    fs::write(&path, many).unwrap();
    let error = record::verify(&path, &()).unwrap_err();
    assert!(error.to_string().contains("more than 400000 tables"), "{error}");
}

#[test]
fn the_command_exports() {
    let folder = Folder::new("command");
    let plan = &plans()[0];
    let delivered = deliver(plan, &run(plan, Options::default(), &()).unwrap(), &folder.0).unwrap();
    let result = delivered.folder.join("result.json").display().to_string();
    let out = folder.0.join("one.step").display().to_string();
    let export = |arguments: &[&str]| {
        let output = Command::new(env!("CARGO_BIN_EXE_plateau"))
            .arg("export")
            .arg(&result)
            .args(arguments)
            .output()
            .unwrap();
        let text = |bytes| String::from_utf8(bytes).unwrap();
        (output.status.code().unwrap(), text(output.stdout), text(output.stderr))
    };
    let (status, stdout, _) = export(&["--format", "ply"]);
    assert_eq!((status, stdout.lines().count()), (0, 3));
    let (status, stdout, stderr) =
        export(&["--format", "step", "--method", "GT", "--tolerance", "1e-9", "--out", &out]);
    assert!(status == 0 && stdout.contains("no point farther than"), "{stdout}{stderr}");
    assert!(fs::read_to_string(&out).unwrap().contains("no point farther than"));
    let (status, _, stderr) = export(&["--format", "step", "--method", "Gt"]);
    assert!(status == 2 && stderr.contains("has no method \"Gt\"; it has \"Bernstein\""), "{stderr}");
    let (status, _, stderr) = export(&["--format", "step", "--out", &out]);
    assert!(status == 2 && stderr.contains("choose one with --method"), "{stderr}");
    let (status, _, stderr) = export(&["--format", "step", "--tolerance", "1e-18"]);
    assert!(status == 1 && stderr.contains("allow a larger tolerance"), "{stderr}");
    assert_eq!(export(&["--format", "step", "--tolerance", "0"]).0, 2);
}

fn record(method: &str) -> String {
    format!("{{\"schema\": \"plateau-result/1\", \"title\": \"t\", \"methods\": [{method}]}}")
}

#[test]
fn what_is_wrong_with_a_result_is_named() {
    let square = "[[[0,0,0],[0,1,0]],[[1,0,0],[1,1,1]]]";
    let bernstein = |net: &str| {
        record(&format!(
            "{{\"name\": \"a\", \"patch\": \"tensor\", \"basis\": \"bernstein\", \"net\": {net}}}"
        ))
    };
    assert!(StoredResult::parse(bernstein(square).as_bytes()).is_ok());
    let cases = [
        (String::new(), "EOF"),
        (bernstein(square).replace("result/1", "result/2"), "`schema` is \"plateau-result/2\""),
        (record("{}"), "`methods[0].name` is missing"),
        (record("{\"name\": \"a\"}"), "`methods[0].patch` is missing"),
        (
            bernstein(square).replace("tensor", "tb-coons"),
            "`methods[0].patch`: \"tb-coons\" with basis \"bernstein\"",
        ),
        (bernstein("[[[0,0,0],[0,1,0]],[[1,0,0]]]"), "`methods[0].net[1]`: has 1 points, the first row 2"),
        (bernstein("[[[0,0,0]]]"), "`methods[0].net`: has 1 x 1 points"),
        (bernstein("[[[0,0],[0,1]]]"), "`methods[0].net[0][0]`: invalid length 2"),
        (
            bernstein("[[[0,0,0],[0,\"x\",1]]]"),
            "`methods[0].net[0][1][1]`: invalid type: string \"x\", expected f64",
        ),
        (bernstein("[3]"), "`methods[0].net[0]`: invalid type: integer `3`, expected a row of points"),
        (
            bernstein("[{\"index\": [1,0,0], \"point\": [0,0,0]}]"),
            "`methods[0].net[0]`: is a point with its index",
        ),
        (record("7"), "`methods[0]`: invalid type: integer `7`"),
        (bernstein("[[[0,0,1e999]]]"), "number out of range"),
        (bernstein(square).replace("bernstein", "gt"), "`methods[0].shape` is missing"),
        (bernstein(square).replace("bernstein", "aht"), "`methods[0].domain` is missing"),
        (
            bernstein(square).replace("\"tensor\"", "\"triangle\""),
            "`methods[0].net`: has 2 points, no triangular net",
        ),
        (
            record(
                "{\"name\": \"a\", \"patch\": \"triangle\", \"basis\": \"bernstein\", \"net\": [\
                 {\"index\": [1,0,0], \"point\": [0,0,0]}, {\"index\": [1,0,0], \"point\": [0,0,0]}, \
                 {\"index\": [0,0,1], \"point\": [0,0,0]}]}",
            ),
            "`methods[0].net[1].index`: [1, 0, 0] stands there twice",
        ),
    ];
    for (text, message) in cases {
        let error = StoredResult::parse(text.as_bytes()).unwrap_err();
        assert!(error.to_string().contains(message), "{error}\ninstead of {message}");
    }
    let failed = record("{\"name\": \"a\", \"error\": \"singular\"}");
    assert!(StoredResult::parse(failed.as_bytes()).unwrap().methods[0].surface.is_err());
    assert!(matches!(StoredResult::read("/nowhere".as_ref()), Err(ReadError::Io(_))));
}

/// Real results, to be spoilt.
fn results() -> &'static [Vec<u8>] {
    static RESULTS: std::sync::OnceLock<Vec<Vec<u8>>> = std::sync::OnceLock::new();
    RESULTS.get_or_init(|| {
        let folder = Folder::new("hostile");
        plans()
            .iter_mut()
            .map(|plan| {
                plan.output.formats.clear();
                let delivered =
                    deliver(plan, &run(plan, Options::default(), &()).unwrap(), &folder.0).unwrap();
                fs::read(delivered.folder.join("result.json")).unwrap()
            })
            .collect()
    })
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    #[test]
    fn spoilt_results_are_read_or_refused(
        which in 0..4usize,
        edits in prop::collection::vec((any::<prop::sample::Index>(), prop::sample::select(b"0123456789-e.,[]{}\":ux".to_vec())), 1..6),
        cut in prop::option::of(any::<prop::sample::Index>()),
    ) {
        let mut bytes = results()[which].clone();
        for (place, byte) in edits {
            let place = place.index(bytes.len());
            bytes[place] = byte;
        }
        if let Some(cut) = cut {
            bytes.truncate(cut.index(bytes.len()));
        }
        if let Ok(stored) = StoredResult::parse(&bytes) {
            for (surface, _) in stored.methods.iter().filter_map(|method| method.surface.as_ref().ok()) {
                let _ = surface.mesh(3);
            }
        }
    }
}

#[cfg(unix)]
#[test]
fn a_file_that_was_named_is_treated_as_what_it_is() {
    use std::os::unix::fs::PermissionsExt;
    let folder = Folder::new("destination");
    let plan =
        Plan::parse("x.toml", &format!("title = 'x'\n{NET}[[method]]\nname = 'm'\nenergy = 'dirichlet'\n"))
            .unwrap();
    deliver(&plan, &run(&plan, Options::default(), &()).unwrap(), &folder.0).unwrap();
    let result = folder.0.join("x/result.json");
    let before = fs::read(&result).unwrap();
    let export = |format: &str, out: &std::path::Path| {
        Command::new(env!("CARGO_BIN_EXE_plateau"))
            .args(["export", "--format", format, "--out"])
            .args([out, &result])
            .output()
            .unwrap()
    };
    // The result itself, under either of its names.
    let link = folder.0.join("link.obj");
    std::os::unix::fs::symlink(&result, &link).unwrap();
    for out in [&result, &link] {
        let output = export("obj", out);
        assert_eq!(output.status.code(), Some(2), "{output:?}");
        assert!(String::from_utf8_lossy(&output.stderr).contains("is the result that is read"), "{output:?}");
        assert!(fs::read(&result).unwrap() == before);
    }
    let plain = folder.0.join("plain.step");
    assert!(export("step", &plain).status.success());
    let expected = fs::read(&plain).unwrap();
    // What is written to stdout is the file and nothing else.
    let output = export("step", std::path::Path::new("/dev/stdout"));
    assert!(output.status.success() && output.stdout == expected, "{output:?}");
    assert!(String::from_utf8_lossy(&output.stderr).contains("exact: a polynomial surface"), "{output:?}");
    let private = folder.0.join("private.step");
    fs::write(&private, "").unwrap();
    fs::set_permissions(&private, fs::Permissions::from_mode(0o600)).unwrap();
    assert!(export("step", &private).status.success());
    assert_eq!(fs::metadata(&private).unwrap().permissions().mode() & 0o777, 0o600);
    assert!(fs::read(&private).unwrap() == expected);
}

/// A plan over the usual net, every coordinate changed.
fn moved(change: impl Fn(usize, f64) -> f64, formats: &str) -> Plan {
    let side = |points: [[f64; 3]; 4]| {
        let point =
            |p: [f64; 3]| format!("[{:e}, {:e}, {:e}]", change(0, p[0]), change(1, p[1]), change(2, p[2]));
        format!("[{}]", points.map(point).join(", "))
    };
    let [u0, u1, v0, v1] = [
        [[0., 0., 0.], [2., 0., 2.], [4., 0., -2.], [6., 0., 0.]],
        [[0., 6., 0.], [2., 6., 2.], [4., 6., -2.], [6., 6., 0.]],
        [[0., 0., 0.], [0., 2., 2.], [0., 4., -2.], [0., 6., 0.]],
        [[6., 0., 0.], [6., 2., 2.], [6., 4., -2.], [6., 6., 0.]],
    ]
    .map(side);
    let text = format!(
        "title = 'x'\n[boundary]\nu0 = {u0}\nu1 = {u1}\nv0 = {v0}\nv1 = {v1}\n[[method]]\nname = 'm'\n\
         energy = 'dirichlet'\n[output]\nmesh = 12\npictures = false\nformats = [{formats}]\n"
    );
    Plan::parse("x.toml", &text).unwrap_or_else(|refusal| panic!("{refusal}"))
}

#[test]
fn step_refuses_what_millimetres_do_not_hold() {
    for (scale, refused) in [(1e-12, true), (1e-9, true), (1e-7, false), (1.0, false), (1e30, false)] {
        let folder = Folder::new(&format!("scale-{scale:e}"));
        let plan = moved(|_, x| scale * x, "'step'");
        let delivered = deliver(&plan, &run(&plan, Options::default(), &()).unwrap(), &folder.0).unwrap();
        assert_eq!(delivered.refusals.len(), usize::from(refused), "{scale:e}: {:?}", delivered.refusals);
        if let [refusal] = delivered.refusals.as_slice() {
            let said = refusal.to_string();
            assert!(said.contains("are told apart from 1e-7 on: scale the boundary"), "{said}");
        }
    }
}

#[test]
fn stl_says_what_it_loses_far_from_the_origin() {
    for (offset, told) in [(0.0, false), (50.0, false), (5_400_000.3, true)] {
        let folder = Folder::new(&format!("far-{offset}"));
        let plan = moved(|k, x| if k == 1 { x + offset } else { x }, "'stl', 'obj'");
        let delivered = deliver(&plan, &run(&plan, Options::default(), &()).unwrap(), &folder.0).unwrap();
        assert!(delivered.refusals.is_empty());
        let notes = &delivered.notes;
        assert_eq!(notes.iter().any(|note| note.contains("m.stl: far from the origin")), told, "{offset}");
        assert_eq!(notes.len(), usize::from(told), "{notes:?}");
        assert!(record::verify(&folder.0.join("x/result.json"), &()).unwrap().agrees());
    }
}

#[test]
fn coordinates_near_the_end_of_double_precision_are_refused_by_every_format() {
    let folder = Folder::new("overflow");
    let plan = moved(|_, x| x, "");
    deliver(&plan, &run(&plan, Options::default(), &()).unwrap(), &folder.0).unwrap();
    let result = fs::read_to_string(folder.0.join("x/result.json")).unwrap();
    let mut record: serde_json::Value = serde_json::from_str(&result).unwrap();
    for large in [1e308, 1e200] {
        record["methods"][0]["net"][0][0] = serde_json::json!([large, 0.0, 0.0]);
        let stored = StoredResult::parse(record.to_string().as_bytes()).unwrap();
        for format in Format::ALL {
            let path = folder.0.join(format!("large.{}", format.ending()));
            let written =
                stored.methods[0].export(format, 6, DEFAULT_TOLERANCE, &Destination::own(path.clone()));
            let holds = large < 1e308 && matches!(format, Format::Obj | Format::Ply | Format::Vtu);
            match written {
                Err(ExportError::Refused { reason, .. }) => {
                    assert!(!holds && reason.contains("scale"), "{reason}")
                }
                other => assert!(holds && matches!(other, Ok(None)), "{format} with {large:e}: {other:?}"),
            }
            assert_eq!(path.exists(), holds);
        }
    }
}
