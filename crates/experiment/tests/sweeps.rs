//! A file with [sweep] is as many experiments as its axes say, each an ordinary one; whatever is wrong is told at its place.

use std::collections::HashSet;
use std::path::Path;

use experiment::{Experiment, Plan, Refusal, Source, Sweep};

const SADDLE: &str = r#"# A saddle over four parabolas.
title = "Saddle"

[boundary]
u0 = [[-1, -1, 0], [-1, 0, 2], [-1, 1, 0]]
u1 = [[1, -1, 0], [1, 0, 2], [1, 1, 0]]
v0 = [[-1, -1, 0], [0, -1, -2], [1, -1, 0]]
v1 = [[-1, 1, 0], [0, 1, -2], [1, 1, 0]]

[[method]]
name = "Dirichlet"
energy = "dirichlet"
raise = 0

[[method]]
name = "Least area"
energy = "area"
raise = 1
"#;

fn sweep(axes: &str) -> Result<Sweep, Refusal> {
    Sweep::parse("saddle.toml", &format!("{SADDLE}{axes}"), Path::new(""))
}

fn sound(axes: &str) -> Sweep {
    sweep(axes).unwrap_or_else(|refusal| panic!("{refusal}"))
}

/// The raises of the methods of a cell.
fn raises(plan: &Plan) -> Vec<usize> {
    match &plan.experiment {
        Experiment::Patch(patches) => patches.methods.iter().map(|method| method.raise()).collect(),
        other => panic!("{other:?}"),
    }
}

/// The coordinate of the first side's middle point.
fn height(plan: &Plan) -> f64 {
    let table: toml::Table = toml::from_str(&plan.text).unwrap();
    let z = &table["boundary"]["u0"][1][2];
    z.as_float().or(z.as_integer().map(|z| z as f64)).unwrap()
}

const TWO: &str = r#"
[[sweep.axis]]
name = "height"
scale = "z"
values = [0.5, 1, 1.5]

[[sweep.axis]]
name = "degree"
key = 'method.*.raise'
from = 0
to = 6
by = 2
"#;

#[test]
fn cells_are_all_combinations_and_the_last_axis_is_the_fastest() {
    let sweep = sound(TWO);
    assert_eq!((sweep.cells(), sweep.title(), sweep.stem().as_str()), (12, "Saddle", "saddle"));
    let mut names = HashSet::new();
    for index in 0..12 {
        let (cell, plan) = (sweep.cell(index), sweep.plan(index).unwrap());
        let (h, d) = ([0.5, 1.0, 1.5][index / 4], 2 * (index % 4));
        assert_eq!(cell.name, format!("height={h},degree={d}"));
        assert_eq!(cell.at, [index / 4, index % 4]);
        assert_eq!((raises(&plan), height(&plan)), (vec![d, d], 2.0 * h));
        assert_eq!(plan.title, format!("Saddle (height = {h}, degree = {d})"));
        assert_eq!(plan.stem, cell.name);
        assert!(names.insert(cell.name));
        // What the researcher wrote stands in the cell, the sweep does not.
        assert!(plan.text.starts_with("# A saddle over four parabolas.\n") && !plan.text.contains("sweep"));
    }
}

#[test]
fn methods_are_addressed_by_name_by_place_and_all_at_once() {
    for (key, expected) in [
        ("method.*.raise", vec![3, 3]),
        (r#"method."Least area".raise"#, vec![0, 3]),
        ("method.0.raise", vec![3, 1]),
        ("method.Dirichlet.raise", vec![3, 1]),
        (r#" method . "Dirichlet" . raise "#, vec![3, 1]),
    ] {
        let found = sound(&format!("[[sweep.axis]]\nname = \"d\"\nkey = '{key}'\nvalues = [3]\n"));
        assert_eq!(raises(&found.plan(0).unwrap()), expected, "{key}");
    }
    let several = sound(
        "[[sweep.axis]]\nname = \"h\"\nkey = [\"boundary.u0.1.2\", \"boundary.u1.1.2\"]\nvalues = [0.25]\n",
    );
    assert_eq!(height(&several.plan(0).unwrap()), 0.25);
}

#[test]
fn ranges_have_their_ends_and_no_rounding() {
    let labels = |range: &str| -> Vec<String> {
        let found = sound(&format!("[[sweep.axis]]\nname = \"h\"\nscale = \"size\"\n{range}\n"));
        found.axes()[0].settings().iter().map(|setting| setting.label().to_owned()).collect()
    };
    assert_eq!(labels("from = 0.1\nto = 0.5\nby = 0.1"), ["0.1", "0.2", "0.3", "0.4", "0.5"]);
    assert_eq!(labels("from = 3\nto = 1\nby = 1"), ["3", "2", "1"]);
    assert_eq!(labels("from = 0.3\nto = 0.9\ncount = 3"), ["0.3", "0.6", "0.9"]);
    assert_eq!(
        labels("from = 0.01\nto = 100\ncount = 5\nspacing = \"logarithmic\""),
        ["0.01", "0.1", "1", "10", "100"]
    );
    assert_eq!(
        labels("from = 1e-6\nto = 1e-10\ncount = 3\nspacing = \"logarithmic\""),
        ["1e-6", "1e-8", "1e-10"]
    );
    assert_eq!(labels("from = 1\nto = 2\nby = 0.75"), ["1", "1.75"]);
}

#[test]
fn axes_go_in_step() {
    let found = sound(&format!(
        "{TWO}\n[[sweep.axis]]\nname = \"seed\"\nkey = \"title\"\nvalues = [\"a\", \"b\", \"c\"]\nwith = \"height\"\n"
    ));
    assert_eq!(found.cells(), 12);
    for index in 0..12 {
        assert_eq!(found.plan(index).unwrap().title, ["a", "b", "c"][index / 4]);
        assert!(!found.cell(index).name.contains("seed"));
    }
}

#[test]
fn boundaries_of_a_folder_take_the_place_of_the_file_s() {
    let folder = std::env::temp_dir().join(format!("plateau-frames-{}", std::process::id()));
    std::fs::create_dir_all(&folder).unwrap();
    for (name, height) in [("b", 4), ("a", 1)] {
        let frame = SADDLE.replace("0, 2]", &format!("0, {height}]")).replace("raise = 1", "raise = 9");
        std::fs::write(folder.join(format!("{name}.toml")), frame).unwrap();
    }
    let axes = "[[sweep.axis]]\nname = \"frame\"\nboundaries = \".\"\n[[sweep.axis]]\nname = \"z\"\nscale = \"z\"\nvalues = [1, 10]\n";
    let found = Sweep::parse("saddle.toml", &format!("{SADDLE}{axes}"), &folder)
        .unwrap_or_else(|refusal| panic!("{refusal}"));
    let cells: Vec<(String, f64)> = (0..found.cells())
        .map(|index| (found.cell(index).name, height(&found.plan(index).unwrap())))
        .collect();
    let expected =
        [("frame=a,z=1", 1.0), ("frame=a,z=10", 10.0), ("frame=b,z=1", 4.0), ("frame=b,z=10", 40.0)];
    assert_eq!(cells, expected.map(|(name, height)| (name.to_owned(), height)));
    assert_eq!(raises(&found.plan(0).unwrap()), [0, 1]);

    std::fs::write(folder.join("c.toml"), SADDLE.replace("v1 = [[", "v1 = [[7, 7, 7], [")).unwrap();
    let refusal = Sweep::parse("saddle.toml", &format!("{SADDLE}{axes}"), &folder).unwrap_err().to_string();
    assert!(refusal.contains("c.toml:") && refusal.contains("frame = c"), "{refusal}");
    std::fs::remove_dir_all(&folder).unwrap();
}

#[test]
fn a_fault_in_a_cell_is_told_at_the_value_that_makes_it() {
    let refusal = sweep("[[sweep.axis]]\nname = \"height\"\nscale = \"z\"\nvalues = [1, 2]\n[[sweep.axis]]\nname = \"degree\"\nkey = 'method.*.raise'\nvalues = [0, 70, 2]\n").unwrap_err();
    let first = &refusal.diagnostics()[0];
    assert_eq!(refusal.diagnostics().len(), 2, "one for each method\n{refusal}");
    assert_eq!(first.message(), "degree = 70: `raise` in method \"Dirichlet\" must lie between 0 and 64");
    assert_eq!(refusal.position(first), Some((26, 14)), "{refusal}");
    assert!(first.remedies().iter().any(|help| help.contains("height = 1, degree = 70")), "{refusal}");

    // A fault that no axis makes stands where it is.
    let text = format!("{}{TWO}", SADDLE.replace("raise = 1", "raise = 1\nsolver = \"fast\""));
    let refusal = Sweep::parse("saddle.toml", &text, Path::new("")).unwrap_err();
    assert_eq!(refusal.diagnostics().len(), 1, "{refusal}");
    assert_eq!(refusal.position(&refusal.diagnostics()[0]), Some((19, 10)), "{refusal}");
}

#[test]
fn whatever_is_wrong_with_the_axes_is_told() {
    let axis = |keys: &str| format!("[[sweep.axis]]\nname = \"a\"\n{keys}\n");
    for (axes, expected) in [
        ("[sweep]\n".to_owned(), "lacks `axis`"),
        ("[sweep]\nfigures = \"area\"\n".to_owned(), "did you mean `figure`?"),
        ("[[sweep.axis]]\nname = \"a\"\nkye = \"seed\"\n".to_owned(), "did you mean `key`?"),
        (axis("values = [1]"), "lacks `key`"),
        (axis("key = \"seed\"\nscale = \"z\"\nvalues = [1]"), "one of `key`, `scale` and `boundaries`"),
        (axis("key = \"seed\""), "lacks `values`"),
        (axis("key = \"seed\"\nvalues = []"), "must hold 1 to 100000 values"),
        (axis("key = \"seed\"\nvalues = 7"), "wrong type"),
        (axis("key = \"seed\"\nvalues = [1]\nfrom = 2"), "`values` or a range, not both"),
        (axis("key = \"seed\"\nfrom = 1\nto = 2"), "lacks `count`"),
        (axis("key = \"seed\"\nfrom = 1\nto = 2\ncount = 2\nby = 1"), "`count` or `by`, not both"),
        (axis("key = \"seed\"\nfrom = 1\nto = 1e9\nby = 1e-9"), "more than 100000 values"),
        (
            axis("scale = \"z\"\nfrom = 0\nto = 2\ncount = 3\nspacing = \"logarithmic\""),
            "begins and ends above 0",
        ),
        (axis("scale = \"z\"\nvalues = [\"steep\"]"), "this is not a number"),
        (axis("scale = \"w\"\nvalues = [1]"), "\"x\", \"y\", \"z\" or \"size\""),
        (axis("key = \"seed\"\nvalues = [1]"), "`a` has nothing to replace: the file holds no `seed`"),
        (axis("key = \"method.*.rais\"\nvalues = [1]"), "did you mean `raise`?"),
        (axis("key = 'method.\"Least area'\nvalues = [1]"), "a quotation mark is not closed"),
        (axis("key = 'method.\"Leest area\".raise'\nvalues = [1]"), "did you mean `Least area`?"),
        (axis("key = \"method.7.raise\"\nvalues = [1]"), "`method` holds no `7`"),
        (axis("key = \"boundary\"\nvalues = [1]"), "a table with a header of its own"),
        (axis("key = \"method\"\nvalues = [1]"), "a table with a header of its own"),
        (axis("key = \"title..x\"\nvalues = [1]"), "a name is missing"),
        (axis("key = \"title\"\nvalues = [\"x\", \"X\"]"), "two values of an axis are called `X`"),
        (axis("key = \"title\"\nvalues = [\"x\"]\nlabels = [\"a/b\"]"), "stands in the names of folders"),
        (axis("key = \"title\"\nvalues = [\"x\"]\nlabels = [\"a\", \"b\"]"), "1 value has 2 labels"),
        (axis("key = \"title\"\nvalues = [\"x\"]\nwith = \"b\""), "no other axis `b`"),
        (axis("boundaries = \"nowhere\""), "cannot be read"),
        (axis("boundaries = \"nowhere\"\nvalues = [1]"), "`values` stands beside `boundaries`"),
        (
            "[[sweep.axis]]\nname = \"a/b\"\nkey = \"title\"\nvalues = [\"x\"]\n".to_owned(),
            "begins the names of folders",
        ),
        (axis("key = \"title\"\nvalues = [\"x\"]").repeat(2), "two axes are called `a`"),
        (
            format!(
                "{}{}",
                axis("scale = \"z\"\nvalues = [2]"),
                axis("key = \"boundary.u0.1.2\"\nvalues = [2]").replace("\"a\"", "\"b\"")
            ),
            "change the same place",
        ),
        (
            (0..3)
                .map(|k| {
                    format!(
                        "[[sweep.axis]]\nname = \"a{k}\"\nkey = \"title\"\nfrom = 1\nto = 100000\nby = 1\n"
                    )
                })
                .collect(),
            "100000 × 100000 × 100000 cells",
        ),
        (
            (0..9)
                .map(|k| format!("[[sweep.axis]]\nname = \"a{k}\"\nkey = \"title\"\nvalues = [\"x\"]\n"))
                .collect(),
            "9 axes",
        ),
    ] {
        let refusal = sweep(&axes).err().unwrap_or_else(|| panic!("{axes} is sound")).to_string();
        assert!(refusal.contains(expected), "{axes}\n{refusal}");
        assert!(refusal.contains("saddle.toml:"), "{refusal}");
    }
}

#[test]
fn a_circle_keeps_its_shape() {
    let text = |scale: &str| {
        format!(
            "title = \"ring\"\n[boundary]\nloops = [[\"ring\"]]\n[[curve]]\nname = \"ring\"\ncircle = {{ center = [0, 0, 1], normal = [0, 0, 1], radius = 2.0 }}\n\
             [[method]]\nname = \"m\"\nenergy = \"area\"\n[[sweep.axis]]\nname = \"s\"\nscale = \"{scale}\"\nvalues = [3]\n"
        )
    };
    let refusal = Sweep::parse("ring.toml", &text("z"), Path::new("")).unwrap_err().to_string();
    assert!(refusal.contains("a circle"), "{refusal}");
    let found =
        Sweep::parse("ring.toml", &text("size"), Path::new("")).unwrap_or_else(|refusal| panic!("{refusal}"));
    let plan = found.plan(0).unwrap();
    assert!(
        plan.text.contains("center = [0.0, 0.0, 3.0], normal = [0, 0, 1], radius = 6.0"),
        "{}",
        plan.text
    );
}

#[test]
fn sources_are_told_apart() {
    let plain = format!("{SADDLE}# a sweep would come here: [sweep]\n");
    assert!(matches!(Source::parse("a.toml", &plain, Path::new("")), Ok(Source::Experiment(_))));
    assert!(matches!(
        Source::parse("a.toml", &format!("{SADDLE}{TWO}"), Path::new("")),
        Ok(Source::Sweep(_))
    ));
    let refusal = Plan::parse("a.toml", &format!("{SADDLE}{TWO}")).unwrap_err().to_string();
    assert!(refusal.contains("this file is a sweep"), "{refusal}");
    let inline = format!("sweep = {{ axis = [] }}\n{SADDLE}");
    let refusal = Source::parse("a.toml", &inline, Path::new("")).unwrap_err().to_string();
    assert!(refusal.contains("this file is a sweep"), "{refusal}");
}
