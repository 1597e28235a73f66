//! However the cells of a sweep are shared out, interrupted, damaged and run again, the table is the same, and says what is missing.

use std::fs;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicUsize, Ordering::Relaxed};

use experiment::Sweep;
use plateau::Progress;
use proptest::prelude::*;
use proptest::test_runner::Config;
use sweep::{Merged, Order, Shard, Tally, merge, run};
use tempfile::{TempDir, tempdir};

fn sweep(heights: usize, raises: usize) -> Sweep {
    let text = format!(
        r#"title = "Saddles"
[boundary]
u0 = [[-1, -1, 0], [-1, 0, 2], [-1, 1, 0]]
u1 = [[1, -1, 0], [1, 0, 2], [1, 1, 0]]
v0 = [[-1, -1, 0], [0, -1, -2], [1, -1, 0]]
v1 = [[-1, 1, 0], [0, 1, -2], [1, 1, 0]]
[[method]]
name = "Coons, \"quoted\""
construction = "discrete-coons"
raise = 0
[output]
pictures = false
mesh = 2
[[sweep.axis]]
name = "height"
scale = "z"
from = 0.1
to = 2
count = {heights}
[[sweep.axis]]
name = "raise"
key = "method.*.raise"
from = 0
to = {}
by = 1
"#,
        raises - 1
    );
    Sweep::parse("saddles.toml", &text, Path::new("")).unwrap_or_else(|refusal| panic!("{refusal}"))
}

fn silent(what: &str) {
    panic!("there is nothing to tell: {what}");
}

fn ran(sweep: &Sweep, shard: Shard, out: &Path) -> Tally {
    let order = Order { threads: 2, ..Order::new(sweep, shard, out) };
    let tally = run(&order, &(), &silent).unwrap();
    assert!(tally.is_sound(), "{tally:?}");
    tally
}

fn table(folders: &[PathBuf]) -> Merged {
    merge(folders).unwrap_or_else(|error| panic!("{error}"))
}

/// All that is written of a merged table but the links of the page.
fn bytes(merged: &Merged) -> (String, String, String) {
    (merged.to_json().unwrap(), merged.csv(), merged.table(200))
}

#[test]
fn the_table_of_200_cells_is_the_same_for_any_shards_in_any_order() {
    let saddles = sweep(40, 5);
    assert_eq!(saddles.cells(), 200);
    let whole = tempdir().unwrap();
    assert_eq!(ran(&saddles, Shard::WHOLE, whole.path()).done, 200);
    let expected = table(&[whole.path().join("saddles")]);
    assert!(expected.is_whole() && expected.counts() == (200, 200));
    assert_eq!(expected.csv().lines().count(), 201);
    for of in [4, 7] {
        // Each shard into a folder of its own, and all into one.
        let (apart, together) = (tempdir().unwrap(), tempdir().unwrap());
        let mut folders = Vec::new();
        for k in (1..=of).rev() {
            let shard = Shard::new(k, of).unwrap();
            let out = apart.path().join(k.to_string());
            let done = ran(&saddles, shard, &out).done;
            assert_eq!(done, shard.cells(200).count());
            folders.push(out.join("saddles"));
            if of == 4 {
                ran(&saddles, shard, together.path());
            }
        }
        for _ in 0..of {
            folders.rotate_left(1);
            assert_eq!(bytes(&table(&folders)), bytes(&expected), "{of} shards");
        }
        if of == 4 {
            assert_eq!(bytes(&table(&[together.path().join("saddles")])), bytes(&expected));
        }
        // One shard less is seen, and every cell that lacks is named.
        let lacking = table(&folders[1..]);
        assert!(!lacking.is_whole());
        assert_eq!(lacking.faults().len() + lacking.counts().0, 200);
        assert!(lacking.faults().iter().all(|fault| fault.starts_with("missing: height=")));
    }
}

/// A small sweep, run whole.
fn small() -> (Sweep, TempDir, PathBuf) {
    let (saddles, out) = (sweep(3, 2), tempdir().unwrap());
    ran(&saddles, Shard::WHOLE, out.path());
    let folder = out.path().join("saddles");
    (saddles, out, folder)
}

#[test]
fn shards_that_overlap_double_nothing() {
    let (saddles, _out, folder) = small();
    let expected = bytes(&table(std::slice::from_ref(&folder)));
    let second = tempdir().unwrap();
    ran(&saddles, Shard::new(1, 2).unwrap(), second.path());
    let other = second.path().join("saddles");
    for folders in [[folder.clone(), other.clone()], [other, folder]] {
        assert_eq!(bytes(&table(&folders)), expected);
    }
}

#[test]
fn what_is_torn_or_lost_is_named_and_run_again_alone() {
    let (saddles, out, folder) = small();
    let expected = bytes(&table(std::slice::from_ref(&folder)));
    let cell = |k: usize| folder.join(saddles.cell(k).name).join("result.json");
    let whole = fs::read(cell(2)).unwrap();
    fs::remove_dir_all(cell(0).parent().unwrap()).unwrap();
    // The result of another cell, and one of another seed.
    fs::copy(cell(5), cell(1)).unwrap();
    fs::write(cell(3), fs::read_to_string(cell(3)).unwrap().replace("\"seed\": 0", "\"seed\": 1")).unwrap();
    for length in [0, 1, whole.len() / 2, whole.len() - 3] {
        fs::write(cell(2), &whole[..length]).unwrap();
        let merged = table(std::slice::from_ref(&folder));
        let faults = merged.faults();
        let named = |k: usize, how: &str| faults[k].starts_with(&format!("{how}: {}", saddles.cell(k).name));
        assert!(
            named(0, "missing") && named(1, "torn") && named(2, "torn") && named(3, "torn"),
            "{faults:?}"
        );
        assert!(!merged.is_whole() && merged.counts() == (2, 6));
        assert_eq!(merged.csv().lines().count(), 3);
    }
    let again = ran(&saddles, Shard::WHOLE, out.path());
    assert_eq!((again.done, again.kept), (4, 2));
    assert_eq!(bytes(&table(&[folder])), expected);
}

#[test]
fn a_cell_in_other_hands_is_left_alone_and_nothing_of_it_is_lost() {
    let (saddles, out) = (sweep(3, 2), tempdir().unwrap());
    let folder = out.path().join("saddles");
    let theirs = record::prepare(&saddles.plan(4).unwrap(), &folder).unwrap();
    let tally = run(&Order::new(&saddles, Shard::WHOLE, out.path()), &(), &silent).unwrap();
    assert_eq!((tally.done, tally.elsewhere.as_slice()), (5, [saddles.cell(4).name].as_slice()));
    assert!(!tally.is_sound());
    assert_eq!(table(std::slice::from_ref(&folder)).faults().len(), 1);
    drop(theirs);
    assert_eq!(ran(&saddles, Shard::WHOLE, out.path()).done, 1);
    assert!(table(&[folder]).is_whole());
}

/// Wants an end after so many cells.
struct Until(AtomicUsize);

impl Progress for Until {
    fn begin(&self, _: &str, _: Option<u64>) {}

    fn step(&self) {
        let _ = self.0.fetch_update(Relaxed, Relaxed, |left| left.checked_sub(1));
    }

    fn end(&self) {}

    fn cancelled(&self) -> bool {
        self.0.load(Relaxed) == 0
    }
}

#[test]
fn an_interrupted_shard_goes_on_where_it_was() {
    let (saddles, _out, whole) = small();
    let out = tempdir().unwrap();
    let mut runs = 0;
    loop {
        let order = Order::new(&saddles, Shard::WHOLE, out.path());
        let tally = run(&order, &Until(AtomicUsize::new(2 + runs)), &silent).unwrap();
        assert_eq!(tally.done + tally.kept + tally.left, 6, "{tally:?}");
        runs += 1;
        if tally.left == 0 {
            break;
        }
        assert!(!tally.is_sound());
    }
    assert!(runs > 2, "{runs}");
    assert_eq!(bytes(&table(&[out.path().join("saddles")])), bytes(&table(&[whole])));
}

#[test]
fn a_cell_that_cannot_be_kept_takes_no_other_with_it() {
    let (saddles, out) = (sweep(3, 2), tempdir().unwrap());
    let folder = out.path().join("saddles");
    fs::create_dir_all(&folder).unwrap();
    let blocked = folder.join(saddles.cell(3).name);
    fs::write(&blocked, "a file where a folder should be").unwrap();
    let told = AtomicUsize::new(0);
    let hear = |what: &str| {
        assert!(what.starts_with(&saddles.cell(3).name), "{what}");
        told.fetch_add(1, Relaxed);
    };
    let tally = run(&Order::new(&saddles, Shard::WHOLE, out.path()), &(), &hear).unwrap();
    assert_eq!((tally.done, tally.unsound.as_slice()), (5, [saddles.cell(3).name].as_slice()));
    assert_eq!(told.into_inner(), 1);
    fs::remove_file(blocked).unwrap();
    assert_eq!(ran(&saddles, Shard::WHOLE, out.path()).kept, 5);
    assert!(table(&[folder]).is_whole());
}

#[test]
fn copies_with_other_numbers_are_named_and_the_same_one_is_taken_in_any_order() {
    let (saddles, _out, folder) = small();
    let second = tempdir().unwrap();
    ran(&saddles, Shard::WHOLE, second.path());
    let other = second.path().join("saddles");
    let cell = other.join(saddles.cell(1).name).join("result.json");
    fs::write(&cell, fs::read_to_string(&cell).unwrap().replacen("\"area\": ", "\"area\": 1", 1)).unwrap();
    let tables = [[folder.clone(), other.clone()], [other, folder]].map(|folders| table(&folders));
    for merged in &tables {
        assert!(!merged.is_whole());
        assert!(merged.faults()[0].starts_with(&format!("contradicted: {}", saddles.cell(1).name)));
    }
    assert_eq!(bytes(&tables[0]), bytes(&tables[1]));
}

#[test]
fn a_value_more_on_an_axis_leaves_the_other_cells_as_they_are() {
    let (_, out, _) = small();
    // 0.1, 1.05 and 2 again, and one more raise.
    let longer = sweep(3, 3);
    let tally = ran(&longer, Shard::WHOLE, out.path());
    assert_eq!((tally.done, tally.kept), (3, 6));
}

#[test]
fn folders_of_different_sweeps_are_not_merged() {
    let (_, _out, folder) = small();
    let second = tempdir().unwrap();
    ran(&sweep(2, 2), Shard::WHOLE, second.path());
    let error = merge(&[folder.clone(), second.path().join("saddles")]).unwrap_err();
    assert!(error.to_string().contains("different sweeps"), "{error}");
    let error = merge(&[folder, second.path().to_owned()]).unwrap_err();
    assert!(error.to_string().contains("sweep.json") && error.to_string().contains("plateau run"), "{error}");
}

#[test]
fn the_files_hold_the_table_and_the_page_leads_to_every_cell() {
    let (saddles, _out, folder) = small();
    let merged = table(std::slice::from_ref(&folder));
    merged.write(&folder).unwrap();
    assert_eq!(fs::read_to_string(folder.join("merged.json")).unwrap(), merged.to_json().unwrap());
    let csv = fs::read_to_string(folder.join("merged.csv")).unwrap();
    assert_eq!(csv, merged.csv());
    let heading = csv.lines().next().unwrap();
    assert!(
        heading.starts_with("cell,height,raise,method,dirichlet,dirichlet_error,area,area_error"),
        "{heading}"
    );
    assert!(
        csv.lines().nth(1).unwrap().starts_with(r#""height=0.1,raise=0",0.1,0.0,"Coons, ""quoted""","#),
        "{csv}"
    );
    let page = fs::read_to_string(folder.join("index.html")).unwrap();
    for k in 0..saddles.cells() {
        let plain = saddles.cell(k).name.replace('=', "%3D").replace(',', "%2C");
        assert!(page.contains(&format!("href=\"./{plain}/result.json\"")), "{plain}");
    }
    // A ring in each of three panels, and one in the key.
    assert_eq!(page.matches("r=\"6\"").count(), 4);
    // The surface, and so its area, is the same at both degrees, but for rounding.
    assert!((3..=6).contains(&page.matches("<tr class=\"best\">").count()));
}

proptest! {
    #![proptest_config(Config { cases: 12, failure_persistence: None, ..Config::default() })]

    #[test]
    fn cells_left_out_at_random_are_missing_and_no_others(gone in prop::collection::vec(any::<bool>(), 6)) {
        let (saddles, _out, folder) = small();
        for (k, _) in gone.iter().enumerate().filter(|(_, gone)| **gone) {
            fs::remove_dir_all(folder.join(saddles.cell(k).name)).unwrap();
        }
        let merged = table(&[folder]);
        let names: Vec<String> = gone.iter().enumerate().filter(|(_, gone)| **gone)
            .map(|(k, _)| format!("missing: {}", saddles.cell(k).name)).collect();
        prop_assert_eq!(merged.faults(), names);
        prop_assert_eq!(merged.is_whole(), !gone.contains(&true));
    }
}

#[test]
fn the_least_value_of_searches_is_compared_in_its_unit() {
    for (energy, search_energy, unit) in [
        ("dirichlet", "dirichlet", "search-minimum (length²)"),
        ("bending", "bending", "search-minimum (length²)"),
        ("dirichlet", "conformality", "search-minimum"),
    ] {
        let text = format!(
            r#"title = "Searches"
[boundary]
u0 = [[0, 0, 0], [2, 0, 2], [4, 0, -2], [6, 0, 0]]
u1 = [[0, 6, 0], [2, 6, 2], [4, 6, -2], [6, 6, 0]]
v0 = [[0, 0, 0], [0, 2, 2], [0, 4, -2], [0, 6, 0]]
v1 = [[6, 0, 0], [6, 2, 2], [6, 4, -2], [6, 6, 0]]
[[method]]
name = "GT"
basis = "gt"
energy = "{energy}"
search = "polish"
search-energy = "{search_energy}"
[search]
runs = 1
[output]
pictures = false
mesh = 2
[sweep]
figure = "search-minimum"
[[sweep.axis]]
name = "height"
scale = "z"
from = 0.5
to = 1
by = 0.5
"#
        );
        let searches =
            Sweep::parse("searches.toml", &text, Path::new("")).unwrap_or_else(|refusal| panic!("{refusal}"));
        let out = tempdir().unwrap();
        ran(&searches, Shard::WHOLE, out.path());
        let folder = out.path().join("searches");
        let merged = table(std::slice::from_ref(&folder));
        let csv = merged.csv();
        let place = csv.lines().next().unwrap().split(',').position(|name| name == "search.minimum");
        let place = place.unwrap_or_else(|| panic!("{csv}"));
        for row in csv.lines().skip(1) {
            assert!(row.split(',').nth(place).unwrap().parse::<f64>().unwrap() > 0.0, "{row}");
        }
        let plots = merged.plots();
        assert!(plots.contains(&format!(">{unit}</text>")), "{energy}: {unit}");
    }
}
