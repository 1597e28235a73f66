//! A run that is killed or interrupted loses nothing that was finished, and resumed ends with the bytes of an undisturbed one.
#![cfg(unix)]
#![allow(clippy::print_stdout)] // the ignored test says what it did

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};
use std::sync::atomic::{AtomicUsize, Ordering::Relaxed};
use std::thread::sleep;
use std::time::{Duration, Instant};

use experiment::{Finished, Options, Plan, run, run_kept};
use plateau::Progress;
use record::{CHECKPOINT_FILE, Checkpoint, Manifest, ResultFile};

/// A fixture with other sizes of its search.
fn fixture(name: &str, particles: usize, iterations: usize, runs: usize) -> String {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../fixtures").join(name);
    let text = fs::read_to_string(path).expect("a fixture of that name");
    let enlarged = text
        .replace("particles = 50", &format!("particles = {particles}"))
        .replace("iterations = 100", &format!("iterations = {iterations}"))
        .replace("runs = 10", &format!("runs = {runs}"));
    assert!(enlarged != text || !text.contains("[search]"), "{name} has other sizes than it had");
    enlarged
}

/// Several experiments of some tenths of a second each, with all kinds of files.
fn batch(folder: &Path) -> Vec<PathBuf> {
    let searched = |name: &str| fixture(name, 100, 1500, 20);
    let exported = fixture("helicoid-deformation.toml", 0, 0, 0);
    let texts = [
        ("a", searched("gt-5.1.toml")),
        ("b", exported),
        ("c", searched("degree-5-4.toml")),
        ("d", searched("gt-5.2-local.toml") + "\n[output]\nformats = [\"obj\", \"step\", \"vtu\"]\n"),
        ("e", searched("tb-coons-5.1.toml")),
    ];
    let write = |(stem, text): (&str, String)| {
        let path = folder.join(stem).with_extension("toml");
        fs::write(&path, text).expect("a writable folder");
        path
    };
    texts.into_iter().map(write).collect()
}

fn plateau(files: &[PathBuf], out: &Path, more: &[&str]) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_plateau"));
    command.arg("run").args(files).arg("--out").arg(out).args(more).stdin(Stdio::null());
    command
}

fn text(bytes: &[u8]) -> &str {
    std::str::from_utf8(bytes).expect("UTF-8")
}

/// Every file below a folder, by its path from there.
fn contents(folder: &Path) -> BTreeMap<PathBuf, Vec<u8>> {
    let mut found = BTreeMap::new();
    let mut folders = vec![folder.to_owned()];
    while let Some(next) = folders.pop() {
        let Ok(entries) = fs::read_dir(&next) else { continue };
        for entry in entries {
            let path = entry.expect("a readable folder").path();
            if path.is_dir() {
                folders.push(path);
            } else {
                let name = path.strip_prefix(folder).expect("below the folder").to_owned();
                found.insert(name, fs::read(&path).expect("a readable file"));
            }
        }
    }
    found
}

fn is_final(path: &Path) -> bool {
    let name = path.file_name().expect("a file").to_string_lossy();
    name != CHECKPOINT_FILE && !name.starts_with(".plateau-")
}

/// SplitMix64, for the moments.
fn random(state: &mut u64) -> f64 {
    *state = state.wrapping_add(0x9e37_79b9_7f4a_7c15);
    let mut z = *state;
    z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    ((z ^ (z >> 31)) >> 11) as f64 / (1_u64 << 53) as f64
}

/// Kills a batch at random moments, `kills` times in a row before it may end, `rounds` times over; after every kill, what
/// lies there under its final name is whole, and nothing of what lay there before is gone.
fn kill(rounds: usize, kills: usize) {
    let folder = tempfile::tempdir().unwrap();
    let files = batch(folder.path());
    let reference = folder.path().join("undisturbed");
    let start = Instant::now();
    assert!(plateau(&files, &reference, &[]).output().unwrap().status.success());
    let lasting = start.elapsed().as_secs_f64();
    let reference = contents(&reference);
    assert!(reference.keys().all(|path| is_final(path)), "{:?}", reference.keys());

    let manifest = |file: &PathBuf| Manifest::new(&Plan::read(file).unwrap(), Options::default());
    let manifests: Vec<Manifest> = files.iter().map(manifest).collect();
    let (mut state, mut struck, mut checkpoints, mut left) = (20_261_123, 0, 0, 0);
    for round in 0..rounds {
        let out = folder.path().join(format!("out-{round}"));
        let mut before: BTreeMap<PathBuf, Vec<u8>> = BTreeMap::new();
        let mut kept = vec![0; files.len()];
        for _ in 0..kills {
            let log = folder.path().join("log");
            let mut child = plateau(&files, &out, &["--resume", "--checkpoint-every", "0"])
                .stdout(fs::File::create(&log).unwrap())
                .stderr(Stdio::piped())
                .spawn()
                .unwrap();
            // The moments cover the whole batch: what is done already is not done again.
            sleep(Duration::from_secs_f64(lasting * 2.0 / kills as f64 * random(&mut state)));
            child.kill().unwrap();
            let output = child.wait_with_output().unwrap();
            struck += usize::from(output.status.code().is_none());
            assert!(!text(&output.stderr).contains("ignored"), "{}", text(&output.stderr));

            let after = contents(&out);
            for (path, bytes) in after.iter().filter(|(path, _)| is_final(path)) {
                assert!(reference.get(path) == Some(bytes), "round {round}: {} is not whole", path.display());
            }
            for path in before.keys().filter(|path| is_final(path)) {
                assert!(after.contains_key(path), "round {round}: {} is lost", path.display());
            }
            for line in fs::read_to_string(&log).unwrap().lines() {
                if let Some(folder) = line.strip_prefix("written to ") {
                    assert!(Path::new(folder).join("result.json").exists(), "{folder} was said to be done");
                }
            }
            for ((file, manifest), kept) in files.iter().zip(&manifests).zip(&mut kept) {
                let folder = out.join(file.file_stem().unwrap());
                if !folder.join("result.json").exists() {
                    let runs = Checkpoint::new(&folder, manifest.clone(), Duration::ZERO).load();
                    let runs = runs.expect("checkpoints are whole, too");
                    assert!(runs >= *kept, "round {round}: {} of {kept} runs are lost", folder.display());
                    checkpoints += usize::from(runs > 0);
                    *kept = runs;
                }
            }
            left += after.keys().filter(|path| path.to_string_lossy().contains(".plateau-")).count();
            before = after;
        }
        let output = plateau(&files, &out, &["--resume"]).output().unwrap();
        assert!(output.status.success(), "{}", text(&output.stderr));
        let resumed = contents(&out);
        assert!(resumed.keys().eq(reference.keys()), "round {round}: {:?}", resumed.keys());
        assert!(resumed == reference, "round {round}: other bytes than the undisturbed run");
        fs::remove_dir_all(&out).unwrap();
    }
    println!(
        "{} kills, {struck} before the batch was done; {checkpoints} checkpoints and {left} unfinished files found; \
         {rounds} resumed batches equal the undisturbed one",
        rounds * kills
    );
    assert!(2 * struck > rounds * kills, "{struck} of {} kills came in time", rounds * kills);
}

#[test]
fn ten_kills_lose_nothing() {
    kill(2, 5);
}

#[test]
#[ignore = "a minute: `just kill`"]
fn two_hundred_kills_lose_nothing() {
    kill(50, 4);
}

fn json(plan: &Plan, finished: &Finished) -> String {
    ResultFile::new(plan, finished).to_json().unwrap()
}

/// Wants an end after so many steps.
struct After(AtomicUsize);

impl Progress for After {
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
fn a_resumed_search_has_the_bytes_of_an_undisturbed_one() {
    let folder = tempfile::tempdir().unwrap();
    let descents = "\n[[method]]\nname = \"descents\"\nbasis = \"gt\"\nenergy = \"laplacian\"\nsearch = \"polish\"\n\
                    \n[[method]]\nname = \"swarm\"\nbasis = \"gt\"\nenergy = \"bending\"\nsearch = \"pso\"\n";
    let text = fixture("gt-5.1.toml", 20, 40, 6).replace("\n[search]", &format!("{descents}\n[search]"));
    let plan = Plan::parse("three-searches.toml", &text).unwrap();
    let options = Options::default();
    let undisturbed = json(&plan, &run(&plan, options, &()).unwrap());
    let mut kept = Vec::new();
    for steps in [1, 60, 150, 250, 251, 254, 300, 400, 490] {
        let checkpoint = || Checkpoint::new(folder.path(), Manifest::new(&plan, options), Duration::ZERO);
        let (first, second) = (checkpoint(), checkpoint());
        let cut = run_kept(&plan, options, &After(AtomicUsize::new(steps)), &first).unwrap();
        assert!(cut.results.was_interrupted());
        first.flush().unwrap();
        kept.push(second.load().unwrap());
        assert_eq!(kept.last(), Some(&first.runs()));
        let resumed = run_kept(&plan, options, &(), &second).unwrap();
        assert!(json(&plan, &resumed) == undisturbed, "cut after {steps} steps");
        assert_eq!(second.runs(), 18);
        second.remove().unwrap();
    }
    assert!(kept.iter().any(|&runs| runs > 6) && kept[0] == 0, "{kept:?}");
}

#[test]
fn a_checkpoint_that_was_loaded_is_completed_when_a_search_ends() {
    let folder = tempfile::tempdir().unwrap();
    let plan = Plan::parse("resumed.toml", &fixture("gt-5.1.toml", 20, 40, 6)).unwrap();
    let options = Options::default();
    let checkpoint =
        |seconds| Checkpoint::new(folder.path(), Manifest::new(&plan, options), Duration::from_secs(seconds));
    let first = checkpoint(0);
    run_kept(&plan, options, &After(AtomicUsize::new(100)), &first).unwrap();
    first.flush().unwrap();
    let second = checkpoint(3600);
    let kept = second.load().unwrap();
    run_kept(&plan, options, &(), &second).unwrap();
    assert_eq!((kept > 0 && kept < 6, checkpoint(0).load().unwrap()), (true, 6), "{kept} were kept");
}

#[test]
fn short_searches_write_no_checkpoint() {
    let folder = tempfile::tempdir().unwrap();
    let plan = Plan::parse("short.toml", &fixture("gt-5.1.toml", 20, 40, 6)).unwrap();
    let manifest = Manifest::new(&plan, Options::default());
    let checkpoint = Checkpoint::new(folder.path(), manifest, Duration::from_secs(3600));
    run_kept(&plan, Options::default(), &(), &checkpoint).unwrap();
    assert_eq!((checkpoint.runs(), folder.path().read_dir().unwrap().count()), (6, 0));
}

#[test]
fn checkpoints_that_do_not_fit_are_ignored_and_say_why() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("x.toml");
    let text = fixture("gt-5.1.toml", 20, 40, 6);
    fs::write(&file, &text).unwrap();
    let options = Options::default();
    let plan = Plan::read(&file).unwrap();
    let out = folder.path().join("out");
    let path = out.join("x").join(CHECKPOINT_FILE);
    let checkpoint = Checkpoint::new(&out.join("x"), Manifest::new(&plan, options), Duration::ZERO);
    run_kept(&plan, options, &(), &checkpoint).unwrap();
    let whole = fs::read(&path).unwrap();
    let files = [file.clone()];
    let undisturbed = {
        let out = folder.path().join("undisturbed");
        assert!(plateau(&files, &out, &[]).output().unwrap().status.success());
        contents(&out)
    };
    let resume = |bytes: &[u8], more: &[&str]| -> String {
        let _ = fs::remove_dir_all(&out);
        fs::create_dir_all(out.join("x")).unwrap();
        fs::write(&path, bytes).unwrap();
        let output = plateau(&files, &out, &[&["--resume"], more].concat()).output().unwrap();
        assert!(output.status.success(), "{output:?}");
        if more.is_empty() {
            assert!(contents(&out) == undisturbed);
        }
        assert!(!path.exists());
        text_of(&output)
    };
    assert!(resume(&whole, &[]).contains("6 finished search runs taken from"));

    let mut changed = whole.clone();
    let digit = changed.iter().rposition(u8::is_ascii_digit).unwrap();
    changed[digit] ^= 1;
    let mut broken: Vec<(Vec<u8>, &str)> = vec![
        (Vec::new(), "is damaged: it is cut off"),
        (b"garbage".to_vec(), "is damaged: it is cut off"),
        (b"garbage\ngarbage\n".to_vec(), "is damaged: its hash is not the one it states"),
        (vec![0xff; 1000], "is damaged: it is not text"),
        (changed, "is damaged: its hash is not the one it states"),
    ];
    for length in [1, 63, 64, 65, 66, whole.len() / 2, whole.len() - 2, whole.len() - 1] {
        broken.push((whole[..length].to_vec(), "is damaged"));
    }
    for (bytes, words) in broken {
        let said = resume(&bytes, &[]);
        assert!(said.contains("is ignored: it") && said.contains(words), "{said}");
        assert_eq!(said.lines().count(), 1, "{said}");
    }
    let said = resume(&whole, &["--seed", "8"]);
    assert!(said.contains("is ignored: it was written with another seed"), "{said}");
    let said = resume(&whole, &["--arithmetic", "portable"]);
    assert!(said.contains("is ignored: it was written with another arithmetic"), "{said}");
    fs::write(&file, text.replace("inertia = 0.7", "inertia = 0.6")).unwrap();
    let said = resume(&whole, &["--quiet"]);
    assert!(said.contains("is ignored: it was written with another experiment"), "{said}");
}

/// What is changed in the record of a run.
type Forge = fn(&mut serde_json::Value);

#[test]
fn a_forged_run_with_the_right_hash_is_run_again() {
    use sha2::{Digest, Sha256};
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("x.toml");
    fs::write(&file, fixture("gt-5.1.toml", 20, 40, 6)).unwrap();
    let plan = Plan::read(&file).unwrap();
    let files = [file];
    let (out, undisturbed) = (folder.path().join("out"), folder.path().join("undisturbed"));
    assert!(plateau(&files, &undisturbed, &[]).output().unwrap().status.success());
    let options = Options::default();
    let forge: [(&str, Forge); 11] = [
        ("value", |run| run["polish"]["value"] = 0.into()),
        ("shape", |run| run["polish"]["point"][1] = 1.25_f64.to_bits().into()),
        ("history", |run| run["swarm"]["history"][3] = 1e9_f64.to_bits().into()),
        ("seed", |run| run["seed"] = 8.into()),
        ("evaluations", |run| run["swarm"]["evaluations"] = 0.into()),
        ("no history", |run| run["swarm"]["history"] = serde_json::json!([])),
        ("short history", |run| {
            run["swarm"]["history"].as_array_mut().unwrap().pop();
        }),
        ("reason", |run| run["swarm"]["reason"] = "stagnation".into()),
        ("descent on budget", |run| run["polish"]["reason"] = "budget".into()),
        ("descents' evaluations", |run| run["polish"]["evaluations"] = 0.into()),
        ("length", |run| {
            run["polish"]["point"].as_array_mut().unwrap().pop();
            run["polish"]["gradient"].as_array_mut().unwrap().pop();
            run["polish"]["active"].as_array_mut().unwrap().pop();
        }),
    ];
    for (what, forge) in forge {
        let _ = fs::remove_dir_all(&out);
        let checkpoint = Checkpoint::new(&out.join("x"), Manifest::new(&plan, options), Duration::ZERO);
        run_kept(&plan, options, &(), &checkpoint).unwrap();
        let whole = fs::read_to_string(checkpoint.path()).unwrap();
        let mut record: serde_json::Value = serde_json::from_str(whole.lines().nth(1).unwrap()).unwrap();
        forge(&mut record["runs"][2]);
        let body = record.to_string();
        fs::write(checkpoint.path(), format!("{:x}\n{body}\n", Sha256::digest(&body))).unwrap();
        let output = plateau(&files, &out, &["--resume"]).output().unwrap();
        let said = text_of(&output);
        assert!(output.status.success() && contents(&out) == contents(&undisturbed), "{what}: {said}");
        assert!(said.contains("6 finished search runs taken from"), "{what}: {said}");
        assert!(
            said.contains("not what the search finds, so run again: 1 finished search run"),
            "{what}: {said}"
        );
    }
}

fn text_of(output: &Output) -> String {
    text(&output.stderr).to_owned()
}

#[test]
fn being_asked_to_end_keeps_the_finished_runs_and_says_how_to_go_on() {
    for signal in ["-INT", "-TERM", "-HUP"] {
        asked_to_end(signal, false);
    }
}

#[cfg(target_os = "linux")]
#[test]
fn who_outlives_the_terminal_may_be_asked_to_end() {
    asked_to_end("-TERM", true);
}

fn asked_to_end(signal: &str, under_nohup: bool) {
    let folder = tempfile::tempdir().unwrap();
    let files = [folder.path().join("first.toml"), folder.path().join("long.toml")];
    fs::write(&files[0], fixture("gt-5.1.toml", 20, 40, 6)).unwrap();
    fs::write(&files[1], fixture("gt-5.2-local.toml", 50, 1500, 150)).unwrap();
    let out = folder.path().join("out");
    // Once a run of the second has ended there is a checkpoint, long before all have.
    let mut command = plateau(&files, &out, &["--checkpoint-every", "0.01"]);
    if under_nohup {
        let mut outer = Command::new("nohup");
        outer.arg(command.get_program()).args(command.get_args()).stdin(Stdio::null());
        command = outer;
    }
    let mut child = command.stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap();
    while !out.join("long/checkpoint").exists() && child.try_wait().unwrap().is_none() {
        sleep(Duration::from_millis(2));
    }
    let sent = Command::new("kill").args([signal, &child.id().to_string()]).status().unwrap();
    assert!(sent.success());
    let output = child.wait_with_output().unwrap();
    assert_eq!(output.status.code(), Some(130), "{output:?}");
    let said = text_of(&output);
    assert!(said.starts_with("interrupted: 1 of 2 experiments done and written, "), "{said}");
    assert!(said.ends_with("long.toml kept; to go on, add --resume to the same command\n"), "{said}");
    assert_eq!(said.lines().count(), 1, "{said}");
    assert!(out.join("first/result.json").exists() && !out.join("long/result.json").exists());
    // The table of an experiment that is not done is not printed.
    assert!(!text(&output.stdout).contains("Example 5.2"), "{}", text(&output.stdout));

    let resumed = plateau(&files, &out, &["--resume"]).output().unwrap();
    assert!(resumed.status.success() && text_of(&resumed).contains(" taken from "), "{resumed:?}");
    assert!(text(&resumed.stdout).contains("not run again: its result is in"), "{resumed:?}");
    let undisturbed = folder.path().join("undisturbed");
    assert!(plateau(&files, &undisturbed, &[]).output().unwrap().status.success());
    assert!(contents(&out) == contents(&undisturbed));
}

#[cfg(target_os = "linux")]
#[test]
fn who_outlives_the_terminal_is_not_ended_with_it() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("x.toml");
    fs::write(&file, fixture("gt-5.2-local.toml", 50, 800, 20)).unwrap();
    let out = folder.path().join("out");
    let mut child = Command::new("nohup")
        .arg(env!("CARGO_BIN_EXE_plateau"))
        .arg("run")
        .args([&file, Path::new("--out"), &out])
        .stdin(Stdio::null())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    while !out.join("x").exists() && child.try_wait().unwrap().is_none() {
        sleep(Duration::from_millis(2));
    }
    assert!(Command::new("kill").args(["-HUP", &child.id().to_string()]).status().unwrap().success());
    let output = child.wait_with_output().unwrap();
    assert!(output.status.success() && out.join("x/result.json").exists(), "{output:?}");
}

#[test]
fn what_was_missed_is_missed_again_without_a_run() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("x.toml");
    let wrong = fixture("gt-5.1.toml", 20, 40, 6).replace("dirichlet = 38.3538462", "dirichlet = 38.3538463");
    fs::write(&file, wrong).unwrap();
    let out = folder.path().join("out");
    for _ in 0..2 {
        let output = plateau(std::slice::from_ref(&file), &out, &["--resume"]).output().unwrap();
        assert_eq!(output.status.code(), Some(1), "{output:?}");
    }
    let output = plateau(std::slice::from_ref(&file), &out, &["--resume"]).output().unwrap();
    assert!(text_of(&output).contains("1 expected number missed, 0 methods failed"), "{output:?}");
    // A result of something else is no result of this.
    let path = out.join("x/result.json");
    let record = fs::read_to_string(&path).unwrap();
    for damaged in [record.replace("\"seed\": 7", "\"seed\": 8"), record[..record.len() / 2].to_owned()] {
        fs::write(&path, damaged).unwrap();
        let output = plateau(std::slice::from_ref(&file), &out, &["--resume"]).output().unwrap();
        assert!(text(&output.stdout).contains("written to"), "{output:?}");
        assert!(fs::read_to_string(&path).unwrap() == record);
    }
}
