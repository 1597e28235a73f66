//! Inputs that mean harm, or that nobody meant: each is a line of a table, and made by the shell that hands it to the program. None may make it
//! panic, wait, fill the memory, write to a terminal what a name says, or touch a file it was not told to write.

#![cfg(target_os = "linux")]

use std::fs;
use std::os::unix::process::ExitStatusExt;
use std::process::Command;

/// What is done, the status it must end with, what it must say.
type Attack = (&'static str, i32, &'static str);

/// Four sides of a net; `NAME` and `METHOD` stand for what a line puts there.
const NET: &str = "title = \"NAME\"\n[boundary]\nu0 = [[0,0,0],[2,0,2],[4,0,-2],[6,0,0]]\nu1 = [[0,6,0],[2,6,2],[4,6,-2],[6,6,0]]\n\
                   v0 = [[0,0,0],[0,2,2],[0,4,-2],[0,6,0]]\nv1 = [[6,0,0],[6,2,2],[6,4,-2],[6,6,0]]\n[[method]]\nname = \"NAME\"\nMETHOD\n\
                   [output]\npictures = false\nformats = [\"obj\"]\n";

/// Every script has the program as `$0`, `net.toml` (a plain experiment), `square.obj` (a skew quadrilateral), `polygon SCALE FAR` (an experiment
/// over one), `await FILE` (until it is there), `listening PID` (until it
/// takes SIGTERM) and `named NAME` (the plain experiment under a name).
const TOOLS: &str = r#"
ulimit -c 0
polygon() { printf 'title = "p"\n[boundary]\npolygon = [[%s, 0, 0], [%s, 0, %s], [%s, %s, 0], [%s, %s, %s]]\n[[method]]\nname = "m"\nenergy = "area"\n[output]\npictures = false\n' "$2" "$3" "$1" "$3" "$1" "$2" "$1" "$1"; }
listening() { until test $((0x$(sed -n 's/SigCgt:\t//p' /proc/$1/status) & 0x4000)) != 0; do sleep 0.02; done; }
await() { until test -e "$1"; do sleep 0.02; done; }
named() { sed "s/NAME/$1/; s/NAME/$1/" template; }
"#;

fn run(script: &str) -> (i32, String) {
    let folder = tempfile::tempdir().unwrap();
    let at = |name: &str| folder.path().join(name);
    let plain = NET.replace("METHOD", "energy = \"dirichlet\"");
    fs::write(at("template"), &plain).unwrap();
    fs::write(at("net.toml"), plain.replace("NAME", "m")).unwrap();
    fs::write(at("area.toml"), NET.replace("NAME", "m").replace("METHOD", "energy = \"area\"\nraise = 11"))
        .unwrap();
    let search = "basis = \"gt\"\nenergy = \"dirichlet\"\nsearch = \"pso\"";
    let long = "[search]\nparticles = 500\niterations = 300\nruns = 4000\n";
    fs::write(at("search.toml"), NET.replace("NAME", "m").replace("METHOD", search) + long).unwrap();
    fs::write(at("square.obj"), "v 0 0 0\nv 1 0 .5\nv 1 1 0\nv 0 1 .5\nl 1 2 3 4 1\n").unwrap();
    let output = Command::new("bash")
        .args(["-c", &format!("{TOOLS}{script}"), env!("CARGO_BIN_EXE_plateau")])
        .current_dir(folder.path())
        .env("MALLOC_ARENA_MAX", "1")
        .output()
        .expect("a shell");
    let said = [output.stdout, output.stderr].map(|bytes| String::from_utf8(bytes).expect("UTF-8")).concat();
    let status = output
        .status
        .code()
        .unwrap_or_else(|| panic!("{script}: signal {:?}\n{said}", output.status.signal()));
    assert!(!said.contains("panicked") && !said.contains('\u{1b}'), "{script}: {said}");
    (status, said)
}

fn hold(attacks: &[Attack]) {
    for (script, expected, words) in attacks {
        let (status, said) = run(script);
        assert_eq!(status, *expected, "{script}: {said}");
        // Messages are broken into lines.
        let whole = said.split_whitespace().collect::<Vec<_>>().join(" ");
        assert!(whole.contains(words), "{script}: {said}");
    }
}

#[test]
fn numbers_far_away_large_and_small() {
    hold(&[
        (
            "polygon 1 1000000000000000 1000000000000001 > p.toml; \"$0\" run p.toml",
            0,
            "lost 15 of their 16 digits to that distance",
        ),
        ("polygon 1 1e17 1e17 > p.toml; \"$0\" run p.toml", 1, "away from the origin"),
        ("polygon 1e-70 0 1e-70 > p.toml; \"$0\" run p.toml", 2, "at least 1e-60"),
        ("polygon 1e-60 0 1e-60 > p.toml; \"$0\" run p.toml", 0, "1.2792616"),
        ("polygon 1e-320 0 1e-320 > p.toml; \"$0\" run p.toml", 2, "at least 1e-60"),
        ("polygon 1e60 0 1e60 > p.toml; \"$0\" run p.toml", 0, "1.2792616"),
        ("polygon 1e70 0 1e70 > p.toml; \"$0\" run p.toml", 2, "too large"),
        (
            "printf 'x,y,z\\n0,0,0\\n1e999,0,0\\n1,1,0\\n' > a.csv; \"$0\" import a.csv",
            2,
            "line 3: \"1e999\" is no coordinate",
        ),
        (
            "printf 'x,y,z\\n-1e308,0,0\\n1e308,0,0\\n1,1,0\\n' > a.csv; \"$0\" fill a.csv -o a.stl",
            2,
            "the largest is 1e60",
        ),
        (
            "printf 'v 0 0 0\\nv 1e-310 0 0\\nv 0 1e-310 1e-310\\nl 1 2 3 1\\n' > a.obj; \"$0\" fill a.obj -o a.step",
            2,
            "no size",
        ),
        (
            "printf 'v 0 0 0\\nv 1e-300 1 0\\nv 1 1 1e-300\\nv 1 0 1\\nl 1 2 3 4 1\\n' > a.obj; \"$0\" fill a.obj -o a.step",
            0,
            "area",
        ),
        (
            "printf 'v 0 0 0\\nv 1 0 0\\nv 0 1 0\\nv 1 1 0\\nl 1 2 3 4 1\\n' > a.obj; \"$0\" fill a.obj -o a.step",
            2,
            "crosses itself near [0.5, 0.5, 0]",
        ),
    ]);
}

#[test]
fn names_that_turn_vanish_forge_or_belong_to_a_system() {
    hold(&[
        ("named 'a\u{202e}b\u{2066}c' > n.toml; \"$0\" run n.toml", 0, "a\\u202eb\\u2066c"),
        ("named 'a\u{200b}b\u{ad}c' > n.toml; \"$0\" run n.toml", 0, "a\\u200bb\\u00adc"),
        ("named 'a\u{e0041}b' > n.toml; \"$0\" run n.toml", 0, "a\\ue0041b"),
        ("named 'a\u{2028}b\\\\u009b31mc' > n.toml; \"$0\" run n.toml", 0, "a\\u2028b\\u009b31mc"),
        (
            "(printf 's/NAME/'; printf '\\360\\237\\221\\251\\342\\200\\215%.0s' $(seq 60000); echo /) > joined; sed -f joined template > n.toml; ulimit -t 60; \"$0\" run n.toml > told && test $(wc -c < told) -lt 3000 && cat told",
            0,
            "…",
        ),
        ("named 'LPT\u{b9}' > n.toml; \"$0\" run n.toml && ls out/n", 0, "method-lpt"),
        ("named '$(touch forged)' > n.toml; \"$0\" run n.toml && ls", 0, "n.toml net.toml"),
        (
            "for n in Aux aux AUX; do named $n | tail -n 6 | head -n 3; done > more; (named x; cat more) > n.toml; sed -i '/output/,/formats/d' n.toml; printf '[output]\\npictures = false\\nformats = [\"obj\"]\\n' >> n.toml; \"$0\" run n.toml && ls out/n | grep -c 'aux.*obj'",
            0,
            " 3",
        ),
        (
            "mkdir c; cp net.toml c/A.toml; cp net.toml c/a.toml; \"$0\" run c/A.toml c/a.toml",
            2,
            "where a disk does not tell capitals apart",
        ),
        ("cp net.toml con.toml; \"$0\" run con.toml && ls out", 0, "experiment-con"),
        (
            "f=$(printf 'x\\033[2J\\nerror: forged.csv'); echo nonsense > \"$f\"; \"$0\" import \"$f\"",
            2,
            "x\\u001b[2J\\nerror: forged.csv: line 1",
        ),
    ]);
}

#[test]
fn files_that_are_none_or_are_those_of_others() {
    hold(&[
        ("\"$0\" fill square.obj -o square.obj", 2, "is a file that is read"),
        ("ln square.obj hard.obj; \"$0\" fill square.obj -o hard.obj", 2, "is a file that is read"),
        ("\"$0\" fill - -o square.obj < square.obj", 2, "is a file that is read"),
        ("ln square.obj hard.obj; \"$0\" fill - -o hard.obj < square.obj", 2, "is a file that is read"),
        ("\"$0\" fill /dev/stdin -o square.obj < square.obj", 2, "is a file that is read"),
        ("\"$0\" fill - -o other.obj < square.obj && test -s other.obj", 0, "area"),
        (
            "ln -s /dev/stdout d.obj; \"$0\" fill square.obj -o d.obj 2> told | grep -qv '^[#ogvstnf]' ; test $? = 1 && cat told",
            0,
            "area",
        ),
        (
            "ln -s /dev/stdout d.obj; \"$0\" fill square.obj -o d.obj > whole.obj 2> told; \"$0\" fill square.obj -o d2.obj > table; cmp <(sed s/d2/d/ d2.obj) whole.obj && grep -q area told && cat table",
            0,
            "area",
        ),
        (
            "touch a.step; chmod 600 a.step; \"$0\" fill square.obj -o a.step && stat -c mode=%a a.step",
            0,
            "mode=600",
        ),
        ("mkdir a.step; \"$0\" fill square.obj -o a.step", 2, "is a directory"),
        (
            "ln -s b.step a.step; ln -s a.step b.step; \"$0\" fill square.obj -o a.step",
            2,
            "lead to one another",
        ),
        (
            "ln -s /dev/full a.step; \"$0\" fill square.obj -o a.step; s=$?; test -L a.step && exit $s",
            1,
            "No space left",
        ),
        ("\"$0\" run net.toml --out square.obj", 1, "not run, for its result could not be written"),
        (
            "mkdir -p out/net/result.json; \"$0\" run net.toml; s=$?; ls out/net; exit $s",
            1,
            "not run, for its result could not be written",
        ),
        (
            "mkdir -p out/net; echo precious > other; ln -s ../../other out/net/result.json; \"$0\" run net.toml && cat other",
            0,
            "precious",
        ),
        (
            "mkdir -p out/net; echo precious > other; printf '{\"schema\":\"plateau-result/1\",\"title\":\"m\",\"seed\":0,\"methods\":[],\"files\":[{\"file\":\"../../other\"},{\"file\":\"result.json\"}]}' > out/net/result.json; \"$0\" run net.toml && cat other && test -s out/net/result.json",
            0,
            "precious",
        ),
        (
            "mkdir -p out/net; for f in checkpoint .lock m.obj report.html; do mkfifo out/net/$f; done; \"$0\" run net.toml --resume && ls out/net",
            0,
            "result.json",
        ),
        ("mkfifo p; \"$0\" verify p & exec 3> p; kill -TERM $!; wait $!", 130, ""),
        ("mkfifo p; \"$0\" fill p -o a.step & exec 3> p; kill -TERM $!; wait $!", 130, ""),
        ("mkfifo p; \"$0\" fill p -o a.step & listening $!; kill -TERM $!; wait $!", 130, ""),
        (
            "mkfifo p.step; \"$0\" fill square.obj -o p.step -o b.obj & await b.obj; sleep 0.3; kill -TERM $!; wait $!; s=$?; test -s b.obj && exit $s",
            130,
            "area",
        ),
        (
            "mkfifo p.step; cat p.step > got & \"$0\" fill square.obj -o p.step && wait && cat got",
            0,
            "ISO-10303-21",
        ),
        (
            "\"$0\" run net.toml > done; mkfifo p; \"$0\" verify out/net/result.json p & exec 3> p; kill -TERM $!; wait $!",
            130,
            "equal",
        ),
        ("\"$0\" run net.toml > done; mkfifo p; cat out/net/result.json > p & \"$0\" verify p", 0, "equal"),
        ("\"$0\" run net.toml >&-; s=$?; ls out/net; exit $s", 0, "result.json"),
    ]);
}

#[test]
fn texts_without_end_and_texts_that_are_none() {
    hold(&[
        (
            "(printf 'v 0 0 0\\nv 1 0 0\\nv 1 1 1\\nl'; yes ' 1 2 3' | head -n 300000 | tr -d '\\n'; echo) > a.obj; ulimit -v 200000; \"$0\" fill a.obj -o a.step",
            2,
            "the most that are read",
        ),
        (
            "(echo side,x,y,z; seq -f 's%.0f,%.0f,0,0' 20000 2> e || seq 20000 | sed 's/.*/s&,&,0,0/') > a.csv; ulimit -v 200000; \"$0\" import a.csv",
            2,
            "the sides become more than 10000",
        ),
        (
            "(printf '0\\nSECTION\\n2\\nENTITIES\\n0\\nLINE\\n'; yes '10\n1.0' | head -n 400000) > a.dxf; ulimit -v 200000; \"$0\" import a.dxf",
            2,
            "cut short",
        ),
        (
            "(printf 'ISO-10303-21;\\nDATA;\\n#1='; head -c 2000000 /dev/zero | tr '\\0' '('; echo ';') > a.step; ulimit -v 200000; \"$0\" import a.step",
            2,
            "error: a.step",
        ),
        (
            "printf \"ISO-10303-21;\\nHEADER;\\nENDSEC;\\nDATA;\\n#1=EDGE_CURVE('',#1,#1,#1,.T.);\\n#2=COMPOSITE_CURVE('',(#2),.F.);\\nENDSEC;\\nEND-ISO-10303-21;\\n\" > a.step; \"$0\" import a.step",
            2,
            "#1 (EDGE_CURVE)",
        ),
        ("head -c 2000000 /dev/zero | tr '\\0' '[' > r.json; \"$0\" verify r.json", 2, "recursion limit"),
        (
            "(printf '{\"schema\":\"plateau-result/1\",\"methods\":['; yes null, | head -n 5000000 | tr -d '\\n'; echo 'null]}') > r.json; ulimit -v 200000; \"$0\" verify r.json",
            2,
            "more than 4000000 values",
        ),
        (
            "printf '{\"schema\":\"plateau-result/1\",\"title\":\"x\",\"seed\":0,\"methods\":[{\"name\":\"m\",\"patch\":\"tensor\",\"basis\":\"bernstein\",\"net\":[[[0,0,0],[1,0,0]],[[0,1,0]]]}]}' > r.json; \"$0\" export r.json --format step --out r.step",
            2,
            "has 1 points, the first row 2",
        ),
        ("head -c 3000 /dev/urandom | tr '\\n' x | \"$0\" run -", 2, "not UTF-8 text"),
        (
            "iconv -t UTF-16 net.toml > u.toml 2>&1 || printf '\\377\\376t\\0' > u.toml; \"$0\" run u.toml",
            2,
            "begins no character",
        ),
        ("printf 'x,y,z\\n0,0,0\\n1,0\\0,0\\n1,1,1\\n' > a.csv; \"$0\" import a.csv", 2, "bytes of value 0"),
        (
            "printf 'x,y,z\\r0,0,0\\r1,0,0\\r1,1,1\\r' > a.csv; \"$0\" import a.csv",
            0,
            "points = [[1.0, 0.0, 0.0], [1.0, 1.0, 1.0]]",
        ),
    ]);
}

#[test]
fn memory_that_is_not_there_and_an_end_that_is_wanted() {
    hold(&[
        (
            "sed 's/raise = 11/raise = 8/' area.toml > l.toml; ulimit -v 80000; \"$0\" run l.toml --threads 1",
            0,
            "surfaces of the next degrees would take about",
        ),
        (
            "sed 's/raise = 11/raise = 27\\nbasis = \"gt\"\\nshape = [1, 1, 1, 1]/' area.toml > l.toml; ulimit -v 100000; \"$0\" run l.toml --threads 1",
            1,
            "out of memory",
        ),
        (
            "sed 's/pictures = false/pictures = false\\nmesh = 2000/' net.toml > l.toml; ulimit -v 300000; \"$0\" run l.toml --threads 1",
            1,
            "out of memory",
        ),
        (
            "printf 'v 0 0 0\\nv 1 0 0\\nv 1 1 0\\nv 1 1 1\\nv 0 1 1\\nv 0 0 1\\nl 1 2 3 4 5 6 1\\n' > a.obj; ulimit -v 60000; \"$0\" fill a.obj --degree 20 -o a.step",
            1,
            "out of memory",
        ),
        ("\"$0\" run search.toml & await out/search; kill -TERM $!; wait $!", 130, "to go on, add --resume"),
        (
            "\"$0\" run search.toml --checkpoint-every 0.01 & await out/search/checkpoint; kill -HUP $!; wait $!; s=$?; ls out/search; exit $s",
            130,
            "checkpoint",
        ),
        (
            "sed 's/raise = 11/raise = 21\\nbasis = \"gt\"\\nshape = [1, 1, 1, 1]/' area.toml > l.toml; \"$0\" run l.toml & await out/l; kill -TERM $!; wait $!",
            130,
            "interrupted",
        ),
        (
            "\"$0\" run search.toml & await out/search; kill -TERM $!; sleep 0.7; kill -TERM $! 2> e; wait $!",
            130,
            "",
        ),
    ]);
}
