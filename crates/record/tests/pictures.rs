//! What a person sees after a run: pictures and the report, for every kind of experiment.

use std::fs;
use std::path::{Path, PathBuf};

use experiment::{Experiment, FilmExperiment, Options, Plan, Rim, run};
use plateau::{Fill, MethodResult, Results};
use record::deliver;

const LARGEST_PICTURE: usize = 300_000;
const LARGEST_REPORT: usize = 1_500_000;

/// The files of a run, in a folder that vanishes with it.
struct Files(tempfile::TempDir, PathBuf);

impl Files {
    fn of(file: &str, text: &str) -> Self {
        let plan = Plan::parse(file, text).unwrap_or_else(|refusal| panic!("{refusal}"));
        let finished = run(&plan, Options::default(), &()).unwrap();
        let out = tempfile::tempdir().unwrap();
        let folder = deliver(&plan, &finished, out.path()).unwrap().folder;
        Self(out, folder)
    }

    fn fixture(name: &str) -> Self {
        let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../fixtures").join(name);
        Self::of(name, &fs::read_to_string(path).unwrap())
    }

    fn read(&self, name: &str) -> String {
        fs::read_to_string(self.1.join(name)).unwrap_or_else(|error| panic!("{name}: {error}"))
    }

    fn pictures(&self) -> Vec<String> {
        let mut names: Vec<String> = fs::read_dir(&self.1)
            .unwrap()
            .map(|entry| entry.unwrap().file_name().into_string().unwrap())
            .filter(|name| name.ends_with(".svg"))
            .collect();
        names.sort();
        names
    }

    fn check(&self, expected: &[&str]) {
        assert!(self.0.path().exists());
        assert_eq!(self.pictures(), expected);
        for name in expected {
            let svg = self.read(name);
            assert!(svg.len() < LARGEST_PICTURE, "{name}: {} bytes", svg.len());
            well_formed(&svg);
        }
        let report = self.read("report.html");
        assert!(report.len() < LARGEST_REPORT, "{} bytes", report.len());
        loads_nothing(&report);
    }
}

#[test]
fn films_are_drawn_patch_by_patch() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../fixtures/gallery/hexagon.toml");
    let text = fs::read_to_string(path).unwrap() + "\n[output]\npictures = true\n";
    let files = Files::of("hexagon.toml", &text);
    // A map over the parameters is for surfaces over one domain.
    files.check(&["surfaces.svg"]);
    let svg = files.read("surfaces.svg");
    assert!(svg.contains("borders of their patches") && svg.contains("Gauss curvature"));
    // Six borders from the middle, all cut into as many pieces; no kink.
    let borders = svg.matches("stroke-width=\"0.5\" stroke-opacity=\"0.6\"").count();
    assert!(borders > 0 && borders.is_multiple_of(6) && !svg.contains("stroke-width=\"1.6\""), "{borders}");
    let report = files.read("report.html");
    let lines = |kind: &str| report.matches(&format!("\"kind\":\"{kind}\"")).count();
    assert_eq!(["rim", "border", "kink"].map(lines), [12, 6, 0]);
    assert!(report.contains("Gauss curvature"));
}

/// The catenoid of the gallery, with another second variation if one is given.
fn catenoid(second_variation: Option<f64>) -> Results {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../fixtures/gallery/catenoid.toml");
    let plan = Plan::parse("catenoid.toml", &fs::read_to_string(path).unwrap()).unwrap();
    let Experiment::Film(FilmExperiment { rim: Rim::Loops(loops), .. }) = &plan.experiment else { panic!() };
    let mut film = Fill::default().with_degree(8).loops(loops, &()).unwrap();
    let found = film.extremal.as_mut().unwrap();
    found.second_variation = second_variation.or(found.second_variation);
    let outcome = Ok(Box::new(film.into_done()));
    Results::of_methods("catenoid", vec![MethodResult { name: "Least area".to_owned(), outcome }])
}

#[test]
fn an_unstable_least_area_shows_how_it_gives_way() {
    let about = || show::About {
        source: show::Source::Experiment("catenoid.toml"),
        text: "",
        seed: 0,
        comparisons: Vec::new(),
        files: Vec::new(),
        origin: Vec::new(),
    };
    let shown = |results: &Results| {
        let scene = show::Scene::of(results);
        let pictures = show::pictures(results, scene.as_ref());
        let page = show::page(results, &about(), scene.as_ref(), &pictures);
        let json = page.split("id=\"surfaces\">").nth(1).unwrap().split("</script>").next().unwrap();
        (pictures, serde_json::from_str::<serde_json::Value>(json).unwrap())
    };
    let (pictures, data) = shown(&catenoid(None));
    assert!(pictures.iter().all(|picture| picture.name != "mode"));
    // A stable one is shown plain, its mode for those who ask.
    let mode = data["mode"].as_u64().expect("a mode") as usize;
    assert!(data["field"].is_null() && data["fields"][mode]["label"] == "mode", "{}", data["field"]);
    assert!(data["surfaces"][0]["caption"].as_str().unwrap().ends_with(": stable"));
    let (pictures, data) = shown(&catenoid(Some(-0.125)));
    let picture = pictures.iter().find(|picture| picture.name == "mode").expect("a picture");
    assert!(picture.svg.contains("unstable: second variation −0.125"), "{}", picture.caption);
    well_formed(&picture.svg);
    assert_eq!(data["field"].as_u64(), Some(mode as u64));
    assert!(data["surfaces"][0]["caption"].as_str().unwrap().ends_with("second variation −0.125: unstable"));
}

#[test]
fn a_page_made_of_curves_names_their_files_and_nothing_that_is_not() {
    let text = include_str!("../../../fixtures/gallery/catenoid.toml");
    let plan = Plan::parse("catenoid.toml", text).unwrap();
    let page = record::report(
        &plan,
        &run(&plan, Options::default(), &()).unwrap(),
        show::Source::Curves("ring <1>.obj, ring 2.obj"),
    );
    assert!(
        page.contains("<p class=\"faint\">The surface over the curves of ring &lt;1&gt;.obj, ring 2.obj</p>")
    );
    assert!(!page.contains("<h2>Files</h2>") && page.contains("As an experiment file"));
}

/// XML whose elements nest, whose attributes are quoted, and whose numbers are all finite.
fn well_formed(svg: &str) {
    let mut open: Vec<&str> = Vec::new();
    let mut rest = svg;
    while let Some(start) = rest.find('<') {
        let text = &rest[..start];
        assert!(!text.contains('>') && entities_only(text), "{text}");
        let end = start + rest[start..].find('>').expect("an element ends");
        let tag = &rest[start + 1..end];
        rest = &rest[end + 1..];
        if let Some(name) = tag.strip_prefix('/') {
            assert_eq!(open.pop(), Some(name));
            continue;
        }
        let name = tag.split([' ', '/']).next().unwrap();
        let attributes = tag[name.len()..].trim_end_matches('/');
        let quoted: Vec<&str> = attributes.split('"').collect();
        assert_eq!(quoted.len() % 2, 1, "{tag}");
        for (k, part) in quoted.iter().enumerate() {
            if k % 2 == 1 {
                assert!(entities_only(part), "{tag}");
                let is_data = part.starts_with("data:");
                assert!(is_data || !(part.contains("NaN") || part.contains("inf")), "{tag}");
            } else {
                let key = part.trim();
                assert!(key.is_empty() || key.ends_with('='), "{tag}");
            }
        }
        if !tag.ends_with('/') {
            open.push(name);
        }
    }
    assert!(open.is_empty() && rest.trim().is_empty(), "{open:?} {rest}");
}

fn entities_only(text: &str) -> bool {
    let known = ["&lt;", "&gt;", "&amp;", "&quot;", "&#39;"];
    text.match_indices('&').all(|(at, _)| known.iter().any(|entity| text[at..].starts_with(entity)))
}

/// No address of a network beyond the names of XML.
fn loads_nothing(html: &str) {
    let names = ["http://www.w3.org/2000/svg", "http://www.w3.org/1999/xlink"];
    for (at, _) in html.match_indices("http://").chain(html.match_indices("https://")) {
        assert!(
            names.iter().any(|name| html[at..].starts_with(name)),
            "{}",
            &html[at..(at + 60).min(html.len())]
        );
    }
    for forbidden in ["@import", "src=\"", "url(//", "fetch(", "XMLHttpRequest", "import("] {
        assert!(!html.contains(forbidden), "{forbidden}");
    }
}

#[test]
fn searches_over_a_boundary() {
    let files = Files::fixture("gt-5.1.toml");
    files.check(&["convergence.svg", "mean-curvature.svg", "surfaces.svg"]);
    let report = files.read("report.html");
    for words in ["37.4395612", "GT Dirichlet + PSO", "SHA-256", "seed 7", "[boundary]"] {
        assert!(report.contains(words), "{words}");
    }
    assert!(report.contains("coloured by mean curvature H, clipped at ±"));
    // One scale for all methods: one bar, symmetric about 0.
    let map = files.read("mean-curvature.svg");
    assert_eq!(map.matches("mean curvature H (1/length)").count(), 1);
    assert!(map.contains(">0.4<") && map.contains(">−0.4<") && map.contains(">0<"));
}

#[test]
fn triangles() {
    Files::fixture("tri-ni1-n3.toml").check(&["mean-curvature.svg", "surfaces.svg"]);
}

#[test]
fn deformations_are_strips_and_minimal_surfaces_have_no_map() {
    let text = "title = \"d\"\n[helicoid]\na = 1.0\nb = 2.0\nu-span = 1.5\nv-span = 6.0\nframes = 40\n";
    let files = Files::of("deformation.toml", text);
    files.check(&["deformation.svg"]);
    assert!(files.read("report.html").contains("17 more surfaces"));
    let strip = files.read("deformation.svg");
    assert!(strip.contains("frame 01 of 40") && strip.contains("frame 40 of 40"));
}

#[test]
fn curves() {
    let text =
        "title = \"c\"\n[curve]\nbasis = \"bernstein\"\npoints = [[0,0],[1,2],[3,2],[4,0]]\nsamples = 5\n";
    Files::of("c.toml", text).check(&["curvature.svg"]);
    // A cusp, and a curve that is one point.
    let cusp = text.replace("[[0,0],[1,2],[3,2],[4,0]]", "[[0,0],[1,1],[0,1],[1,0]]");
    Files::of("c.toml", &cusp).check(&["curvature.svg"]);
    let point = text.replace("[[0,0],[1,2],[3,2],[4,0]]", "[[1,2],[1,2]]");
    Files::of("c.toml", &point).check(&["curvature.svg"]);
    let space = text.replace("[[0,0],[1,2],[3,2],[4,0]]", "[[0,0,1],[1,2,3],[3,2,0],[4,0,1]]");
    Files::of("c.toml", &space).check(&["curvature.svg"]);
}

fn saddle(title: &str, name: &str, size: f64, rest: &str) -> String {
    let point = |p: [i32; 3]| {
        format!("[{:e}, {:e}, {:e}]", size * f64::from(p[0]), size * f64::from(p[1]), size * f64::from(p[2]))
    };
    let row = |points: [[i32; 3]; 3]| points.map(point).join(", ");
    let row = |points| format!("[{}]", row(points));
    format!(
        "title = {title:?}\n[boundary]\nu0 = {}\nu1 = {}\nv0 = {}\nv1 = {}\n[[method]]\nname = {name:?}\n\
         basis = \"bernstein\"\nenergy = \"dirichlet\"\n{rest}",
        row([[0, 0, 0], [0, 1, 0], [0, 2, 0]]),
        row([[2, 0, 0], [2, 1, 1], [2, 2, 2]]),
        row([[0, 0, 0], [1, 0, 0], [2, 0, 0]]),
        row([[0, 2, 0], [1, 2, 1], [2, 2, 2]]),
    )
}

#[test]
fn hostile_names_stay_text() {
    let hostile = "</script><script>alert(1)</script><img onerror=alert(2)>&\\u0007";
    let files =
        Files::of("</title>.toml", &saddle("HOSTILE", "HOSTILE", 1.0, "").replace("HOSTILE", hostile));
    files.check(&["mean-curvature.svg", "surfaces.svg"]);
    let report = files.read("report.html");
    for markup in ["<img", "</script><script>alert", "\u{7}"] {
        assert!(!report.contains(markup), "{markup:?}");
    }
    // The data and the viewer, each opened and closed once; the title twice.
    assert_eq!((report.matches("<script").count(), report.matches("</script>").count()), (2, 2));
    assert!(report.contains("<h1>&lt;/script&gt;") && report.contains("\\u003c/script\\u003e"));
}

#[test]
fn any_size_of_surface_can_be_drawn() {
    for size in [1e-60, 1e-3, 1e6, 1e59] {
        let files = Files::of("size.toml", &saddle("s", "m", size, ""));
        files.check(&["mean-curvature.svg", "surfaces.svg"]);
    }
}

#[test]
fn many_methods_keep_the_files_small() {
    let more: String = (0..30)
        .map(|k| {
            format!(
                "[[method]]\nname = \"mask {k}\"\nbasis = \"bernstein\"\nmask = {}\n",
                f64::from(k) / 100.0
            )
        })
        .collect();
    Files::of("many.toml", &saddle("s", "m", 1.0, &more)).check(&["mean-curvature.svg", "surfaces.svg"]);
}

#[test]
fn pictures_can_be_refused() {
    let files = Files::of("plain.toml", &saddle("s", "m", 1.0, "[output]\npictures = false\n"));
    let names: Vec<_> = fs::read_dir(&files.1).unwrap().map(|entry| entry.unwrap().file_name()).collect();
    assert_eq!(names, ["result.json"]);
}
