//! What is told of curves that become one boundary is true.

use exchange::{Assembly, AssemblyError, AssemblyOptions, Form, read_curves};
use proptest::prelude::*;

fn assembled(text: &str) -> Result<Assembly, AssemblyError> {
    let file = read_curves(text.as_bytes(), "-").unwrap_or_else(|error| panic!("{error}\n{text}"));
    Assembly::new(&file, &AssemblyOptions::default())
}

/// The whole numbers of a text, in order, but for those that are degrees.
fn counts(text: &str) -> Vec<usize> {
    let words = text.split([' ', ',', ';', '(', ')', ':']);
    words.filter(|word| !word.is_empty()).filter_map(|word| word.parse().ok()).collect()
}

proptest! {
    /// The corners that are told, those found and those of the file together, are the ends of the sides.
    #[test]
    fn every_end_of_a_side_is_a_corner_told(
        turns in prop::collection::vec(5.0..120.0_f64, 3..9),
        is_named in any::<bool>(),
    ) {
        // A convex polygon: edges of length 1 that turn by shares of a full turn, closed by a last point in the middle of nowhere.
        let whole: f64 = turns.iter().sum();
        prop_assume!(turns.iter().all(|turn| 300.0 * turn / whole < 150.0));
        let (mut points, mut at, mut direction) = (vec![[0.0, 0.0]], [0.0, 0.0], 0.0_f64);
        for turn in &turns {
            at = [at[0] + direction.cos(), at[1] + direction.sin()];
            points.push(at);
            direction += (300.0 * turn / whole).to_radians();
        }
        let row = |name: usize, p: &[f64; 2]| format!("s{name},{:?},{:?},0\n", p[0], p[1]);
        let count = points.len();
        let text: String = if is_named {
            let side = |k: usize| row(k, &points[k]) + &row(k, &points[(k + 1) % count]);
            "side,x,y,z\n".to_owned() + &(0..count).map(side).collect::<String>()
        } else {
            "x,y,z\n".to_owned() + &points.iter().map(|p| format!("{:?},{:?},0\n", p[0], p[1])).collect::<String>()
        };
        let assembly = assembled(&text).unwrap();
        let Form::Loops(loops) = &assembly.form else { panic!("a loop") };
        let note = assembly.notes.iter().map(ToString::to_string).find(|note| note.starts_with("polylines have")).unwrap();
        let told = match note.split_once(" more where the file begins another side") {
            Some((before, _)) => counts(before).iter().sum(),
            None => counts(note.split(';').next().unwrap()).first().copied().unwrap_or(0),
        };
        prop_assert_eq!(told, loops[0].len(), "{}", note);
        prop_assert_eq!(is_named, is_named && loops[0].len() == count);
    }

    /// A loop that is given twice is one loop, wherever and in whichever sense the second one begins, and both lines are told.
    #[test]
    fn a_loop_given_twice_is_one(
        count in 3_usize..9,
        start in 0_usize..9,
        is_reversed in any::<bool>(),
        is_repeated in any::<bool>(),
    ) {
        let point = |k: usize| {
            let (s, c) = (std::f64::consts::TAU * (k % count) as f64 / count as f64).sin_cos();
            format!("{c:?},{s:?},{}\n", k % count % 2)
        };
        let last = if is_repeated { count + 1 } else { count };
        let once: String = (0..last).map(point).collect();
        // Where the loop is closed by the reader, the copy is the same rows.
        let from = if is_repeated { start } else { 0 };
        let mut again: Vec<String> = (0..last).map(|k| point(from + k)).collect();
        if is_reversed {
            again.reverse();
        }
        let text = format!("x,y,z\n{once}\n{}", again.concat());
        let single = assembled(&format!("x,y,z\n{once}")).unwrap();
        let double = assembled(&text).unwrap();
        prop_assert_eq!(&single.form, &double.form);
        prop_assert_eq!(single.vertices.len(), double.vertices.len());
        let note = double.notes.iter().find(|note| note.to_string().starts_with("given twice")).unwrap();
        let line = |k: usize| format!("the curve of line {k}");
        prop_assert!(note.to_string().contains(&line(2)) && note.to_string().contains(&line(last + 3)), "{}", note);
    }

    /// Points of one line bound nothing, wherever it lies.
    #[test]
    fn points_of_a_line_are_told(
        direction in [-1.0..1.0, -1.0..1.0, 0.1..1.0],
        offset in [-1e6..1e6, -1e3..1e3, -1.0..1.0],
        at in prop::collection::vec(-5.0..5.0, 3..9),
    ) {
        let row = |t: &f64| {
            let p: [f64; 3] = std::array::from_fn(|k| direction[k] * t + offset[k]);
            format!("{:?},{:?},{:?}\n", p[0], p[1], p[2])
        };
        let text = "x,y,z\n".to_owned() + &at.iter().map(row).collect::<String>();
        prop_assert_eq!(assembled(&text).unwrap_err(), AssemblyError::Line);
    }
}

#[test]
fn a_segment_that_two_curves_share_is_told_by_both() {
    // Two panels, each with its whole rim.
    let panels = "side,x,y,z\na,0,0,0\na,1,0,0\na,1,1,0\na,0,0,0\nb,0,0,0\nb,1,1,0\nb,0,1,1\nb,0,0,0\n";
    let notes = assembled(panels).unwrap().notes;
    assert!(
        notes.iter().any(|note| note.to_string().contains("1 segment of a (line 2) in b (line 6)")),
        "{notes:?}"
    );
}
