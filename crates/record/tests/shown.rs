//! A figure is the same in the table, on the page and in the record, for every figure of every fixture.

use std::fs;
use std::path::Path;

use experiment::{Options, Plan, run};
use record::deliver;
use serde_json::Value;
use show::{WIDTH, table};

/// The cells of a row of the terminal's table, cut where the rule below the headings has its gaps.
fn cells(line: &str, rule: &str) -> Vec<String> {
    let (line, rule): (Vec<char>, Vec<char>) = (line.chars().collect(), rule.chars().collect());
    let starts: Vec<usize> =
        (0..rule.len()).filter(|&k| rule[k] == '─' && (k == 0 || rule[k - 1] != '─')).collect();
    let end = |k: usize| starts.get(k + 1).copied().unwrap_or(usize::MAX);
    let cell =
        |k: usize| line.iter().skip(starts[k]).take(end(k) - starts[k]).collect::<String>().trim().to_owned();
    (0..starts.len()).map(cell).collect()
}

/// What stands between `<tag …>` and `</tag>`, with the attributes.
fn elements<'a>(html: &'a str, tag: &str) -> Vec<(&'a str, &'a str)> {
    let (open, close) = (format!("<{tag}"), format!("</{tag}>"));
    let parts = html.split(open.as_str()).skip(1).filter_map(|part| part.split_once(close.as_str()));
    parts.filter_map(|(element, _)| element.split_once('>')).collect()
}

/// The number of a cell and half a unit of its last digit.
fn read(cell: &str) -> Option<(f64, f64)> {
    let (text, factor) = cell.strip_suffix(" %").map_or((cell, 1.0), |text| (text, 0.01));
    let (mantissa, exponent) = text.split_once('e').unwrap_or((text, "0"));
    let decimals = mantissa.split_once('.').map_or(0, |(_, decimals)| decimals.len());
    let unit = factor * 10f64.powi(exponent.parse::<i32>().ok()? - decimals as i32);
    Some((factor * text.parse::<f64>().ok()?, 0.500_001 * unit))
}

/// Runs an experiment and compares; how many figures were compared.
fn compare(file: &str, text: &str, room: usize) -> usize {
    let plan = Plan::parse(file, text).unwrap_or_else(|refusal| panic!("{refusal}"));
    let finished = run(&plan, Options::default(), &()).unwrap();
    let out = tempfile::tempdir().unwrap();
    let folder = deliver(&plan, &finished, out.path()).unwrap().folder;
    let contents = |name: &str| fs::read_to_string(folder.join(name)).unwrap();
    let (record, page): (Value, String) =
        (serde_json::from_str(&contents("result.json")).unwrap(), contents("report.html"));
    let Some(methods) = record["methods"].as_array().filter(|methods| !methods.is_empty()) else { return 0 };
    let terminal = table(&finished.results, room);
    let lines: Vec<&str> = terminal.lines().collect();
    let rule = lines.iter().position(|line| line.starts_with('─')).expect("a rule");
    let headings = cells(lines[rule - 2], lines[rule]);
    let on_page = elements(&page, "thead")[0].1;
    let keys: Vec<&str> = elements(on_page, "th")
        .iter()
        .map(|(tag, _)| tag.split("data-figure=\"").nth(1).map_or("", |k| k.trim_end_matches('"')))
        .collect();
    let names: Vec<&str> = elements(on_page, "th")
        .iter()
        .map(|(_, heading)| heading.split('<').next().unwrap_or(heading))
        .collect();
    let rows = elements(elements(&page, "tbody")[0].1, "tr");
    let mut compared = 0;
    // A line stands above the rows that are set apart.
    let mut below = lines[rule + 1..].iter().filter(|line| !line.starts_with("the boundary moved"));
    for (tag, row) in rows {
        let number = tag.split("data-row=\"").nth(1).and_then(|rest| rest.split('"').next());
        let method = &methods[number.expect("a number").parse::<usize>().unwrap()];
        let line = below.next().expect("a line for each row");
        let row: Vec<&str> = elements(row, "td").iter().map(|(_, cell)| *cell).collect();
        if method.get("error").is_some() {
            assert!(row[1].starts_with("failed: "), "{file}");
            continue;
        }
        for (heading, cell) in headings.iter().zip(cells(line, lines[rule])).skip(1) {
            let at =
                names.iter().position(|name| name == heading).unwrap_or_else(|| panic!("{file}: {heading}"));
            assert_eq!(row[at], cell, "{file}: {heading} of {}", method["name"]);
        }
        let size = method["dirichlet"].as_f64().unwrap().sqrt();
        for (key, cell) in keys.iter().zip(row).filter(|(key, _)| !key.is_empty()) {
            let recorded =
                key.split('.').try_fold(method, |value, part| value.get(part)).and_then(Value::as_f64);
            let Some((shown, half)) = read(cell) else {
                assert_eq!(recorded, None, "{file}: {key} is {cell:?}");
                continue;
            };
            let recorded =
                recorded.unwrap_or_else(|| panic!("{file}: {key} is shown as {cell} and not recorded"));
            // What is written 0 is rounding of a length or a curvature beside those of a patch of this size.
            let rounding = match *key {
                "boundary_deviation" if shown == 0.0 => 1e-12 * size,
                "mean_curvature.max_abs" | "mean_curvature.rms" if shown == 0.0 => 1e-6 / size,
                _ => half,
            };
            assert!((recorded - shown).abs() <= rounding, "{file}: {key} is {recorded}, shown {cell}");
            compared += 1;
        }
    }
    compared
}

#[test]
fn every_figure_of_every_fixture_is_shown_as_it_is_recorded() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../fixtures");
    let (mut compared, room) = (0, usize::MAX);
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.extension().is_some_and(|extension| extension == "toml") {
            let name = path.file_name().unwrap().to_string_lossy().into_owned();
            compared += compare(&name, &fs::read_to_string(&path).unwrap(), room);
        }
    }
    assert!(compared > 500, "{compared}");
}

#[test]
fn figures_are_shown_as_recorded_in_any_unit() {
    for unit in ["1e-20", "1e-9", "1e12"] {
        let point = |x: &str| {
            x.replace('2', &format!("2{}", &unit[1..]))
                .replace('4', &format!("4{}", &unit[1..]))
                .replace('6', &format!("6{}", &unit[1..]))
        };
        let side = |points: &[&str]| {
            format!("[{}]", points.iter().map(|p| format!("[{}]", point(p))).collect::<Vec<_>>().join(","))
        };
        let text = format!(
            "title = \"{unit}\"\n[boundary]\nu0 = {}\nu1 = {}\nv0 = {}\nv1 = {}\n\
             [[method]]\nname = \"GT\"\nbasis = \"gt\"\nshape = [1, 2, 3, 0.5]\nenergy = \"dirichlet\"\n\
             [[method]]\nname = \"Bernstein\"\nenergy = \"dirichlet\"\n",
            side(&["0,0,0", "2,0,2", "4,0,-2", "6,0,0"]),
            side(&["0,6,0", "2,6,2", "4,6,-2", "6,6,0"]),
            side(&["0,0,0", "0,2,2", "0,4,-2", "0,6,0"]),
            side(&["6,0,0", "6,2,2", "6,4,-2", "6,6,0"]),
        );
        assert!(compare("unit.toml", &text, WIDTH) > 15, "{unit}");
    }
}

#[test]
fn no_table_is_wider_than_its_room() {
    for name in [
        "gt-5.1.toml",
        "area-5.1.toml",
        "helicoid-deformation.toml",
        "curve-gt-1-1.toml",
        "tri-enneper-n3.toml",
    ] {
        let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../fixtures").join(name);
        let plan = Plan::read(&path).unwrap();
        let results = run(&plan, Options::default(), &()).unwrap().results;
        for room in [60, WIDTH, 100, 200] {
            let text = table(&results, room);
            let rule = text.lines().position(|line| line.starts_with('─')).unwrap();
            let rows = rule + 1 + results.methods().len().max(1);
            let widest =
                text.lines().skip(rule - 1).take(rows + 2 - rule).map(|line| line.chars().count()).max();
            assert!(widest <= Some(room), "{room}\n{text}");
            assert!(!results.curves().is_empty() || text.contains("area A"), "{text}");
        }
    }
}

/// What is said of every least area is how far it is from the least, or why that is not said.
#[test]
fn every_least_area_is_told_how_far_it_is_or_that_it_is_not_estimated() {
    let text = "title = \"t\"\n[boundary]\nu0 = [[-1, -1, 0], [-1, 0, 2], [-1, 1, 0]]\nu1 = [[1, -1, 0], [1, 0, 2], [1, 1, 0]]\n\
                v0 = [[-1, -1, 0], [0, -1, -2], [1, -1, 0]]\nv1 = [[-1, 1, 0], [0, 1, -2], [1, 1, 0]]\n\
                [[method]]\nname = \"low\"\nenergy = \"area\"\n[[method]]\nname = \"high\"\nenergy = \"area\"\nraise = 13\n\
                [[method]]\nname = \"gt\"\nbasis = \"gt\"\nshape = [1, 1, 1, 1]\nenergy = \"area\"\n";
    let plan = Plan::parse("t.toml", text).unwrap_or_else(|refusal| panic!("{refusal}"));
    let finished = run(&plan, Options::default(), &()).unwrap();
    let said = table(&finished.results, WIDTH);
    for method in finished.results.methods() {
        let done = method.outcome.as_ref().unwrap();
        let estimated = said.lines().any(|line| line.contains(&format!("{}: least ≤", method.name)));
        assert_eq!(estimated, done.estimate.is_some(), "{}: {said}", method.name);
    }
    let costly = said.lines().find(|line| line.contains("not estimated, which would cost more"));
    assert!(costly.is_some_and(|line| line.contains(": high;")), "{said}");
    // Functions of a shape are not among those of a higher degree: no cost is to blame.
    assert!(costly.is_some_and(|line| !line.contains("gt") && !line.contains("low")), "{said}");
}
