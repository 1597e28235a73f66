//! Boundaries from files: points of the sides in, a ready experiment out.

use std::fmt::Write;
use std::fs::File;
use std::io::{self, Read};
use std::path::Path;

use surfaces::Point;
use thiserror::Error;

use crate::Plan;
use plateau::{MAX_COORDINATE, MAX_DEGREE};

mod fit;
mod read;

use fit::Fit;
use read::Side;

/// Share of the size below which the ends of two sides are one corner.
const SAME: f64 = 1e-6;

/// Largest size in bytes of a file that is imported.
const MAX_SIZE: u64 = 16 * 1024 * 1024;

/// Most samples of a side that is fitted.
const MOST_SAMPLES: usize = 5000;

/// Names of the sides, in the order in which they run around the boundary; whether the experiment has them in that sense.
const TENSOR: [(&str, bool); 4] = [("u0", true), ("v1", true), ("u1", false), ("v0", false)];
const TRIANGLE: [(&str, bool); 3] = [("ab", true), ("bc", true), ("ca", true)];

/// Why no boundary could be made of a file.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum ImportError {
    /// The file system.
    #[error("cannot be read: {0}")]
    Io(#[from] io::Error),
    /// Bytes that are no text.
    #[error("is no text in UTF-8: save it as one")]
    NotText,
    /// Too large.
    #[error("is larger than {} MiB", MAX_SIZE >> 20)]
    TooLarge,
    /// A line that is not understood.
    #[error("line {line}: {why}")]
    Line {
        /// Its number, from 1.
        line: usize,
        /// What is wrong with it.
        why: String,
    },
    /// The lines are no boundary.
    #[error("{0}")]
    Sides(String),
    /// The ends of two sides are apart.
    #[error(
        "{first} and {second} should meet in a corner, but lie {gap:.3e} apart: their ends must agree to within \
         {SAME:e} of the size, {size:.3e}{}",
        if *named { "; sides of these names run as in an experiment, under other names they are chained by their ends, in any order \
         and sense" } else { "" }
    )]
    Corner {
        /// One side.
        first: String,
        /// The other.
        second: String,
        /// Their distance.
        gap: f64,
        /// Diagonal of the box around the boundary.
        size: f64,
        /// Whether they have the names of sides of experiments, which say how they run.
        named: bool,
    },
    /// A side cannot be fitted.
    #[error("{side}: {why}")]
    Fit {
        /// Its name.
        side: String,
        /// Why, and what to do.
        why: String,
    },
    /// The boundary is not one of an experiment.
    #[error("the points make no sound experiment: {0}")]
    Plan(String),
}

/// A side in the sense in which it runs around the boundary.
struct Curve {
    name: &'static str,
    /// What the file calls it.
    label: String,
    points: Vec<Point>,
    forward: bool,
    fit: Option<Fit>,
}

/// Reads the sides of a boundary, from a table (`side,x,y,z`) or an OBJ file with lines, and prints an experiment with them.
/// Without a degree the points are control points; with one they are samples, and each side is the Bernstein curve of
/// that degree nearest to them in the sense of least squares, its ends on theirs. How near is said in comments.
///
/// # Errors
/// [`ImportError`]; the file itself is not named in it.
pub fn import(path: &Path, degree: Option<usize>) -> Result<String, ImportError> {
    let mut bytes = Vec::new();
    File::open(path)?.take(MAX_SIZE + 1).read_to_end(&mut bytes)?;
    if bytes.len() as u64 > MAX_SIZE {
        return Err(ImportError::TooLarge);
    }
    let text = String::from_utf8(bytes).map_err(|_| ImportError::NotText)?;
    let is_obj = path.extension().is_some_and(|extension| extension.eq_ignore_ascii_case("obj"));
    let sides = if is_obj { read::obj(&text)? } else { read::table(&text)? };
    let stem = path.file_stem().map_or_else(|| "boundary".into(), |stem| stem.to_string_lossy().into_owned());
    experiment(&stem, sides, degree)
}

fn experiment(title: &str, sides: Vec<Side>, degree: Option<usize>) -> Result<String, ImportError> {
    let mut curves = around(sides)?;
    let size = crate::export::diagonal(curves.iter().flat_map(|curve| &curve.points).map(|&p| p.into()));
    for k in 0..curves.len() {
        let next = (k + 1) % curves.len();
        let (end, start) = (last(&curves[k].points), curves[next].points[0]);
        let gap = end.distance(start);
        if gap > SAME * size {
            let named = curves.iter().all(|curve| curve.label == curve.name);
            let [first, second] = [k, next].map(|k| curves[k].label.clone());
            return Err(ImportError::Corner { first, second, gap, size, named });
        }
        // Corners are repeated in an experiment and must agree digit for digit.
        curves[next].points[0] = end;
    }
    if let Some(degree) = degree {
        for curve in &mut curves {
            let fit = Fit::new(&curve.points, degree)
                .map_err(|why| ImportError::Fit { side: curve.label.clone(), why })?;
            curve.points.clone_from(&fit.points);
            curve.fit = Some(fit);
        }
    }
    let text = printed(title, &mut curves, size);
    match Plan::parse("imported.toml", &text) {
        Ok(_) => Ok(text),
        Err(refusal) => Err(ImportError::Plan(
            refusal.diagnostics().iter().map(|fault| fault.message()).collect::<Vec<_>>().join("; "),
        )),
    }
}

fn printed(title: &str, curves: &mut [Curve], size: f64) -> String {
    let mut text = format!("title = {}\n\n[boundary]\n", quoted(title));
    for curve in curves.iter_mut() {
        if !curve.forward {
            curve.points.reverse();
        }
    }
    curves.sort_by_key(|curve| curve.name);
    for curve in curves.iter() {
        if let Some(fit) = &curve.fit {
            let _ = writeln!(
                text,
                "# {}: fit of degree {} to {} samples; farthest {:.2e} ({:.1e} of the size), root mean square {:.2e}",
                curve.name,
                curve.points.len() - 1,
                fit.samples,
                fit.largest,
                fit.largest / size,
                fit.root_mean_square,
            );
        }
        let points: Vec<String> =
            curve.points.iter().map(|p| format!("[{:?}, {:?}, {:?}]", p.x, p.y, p.z)).collect();
        let _ = writeln!(text, "{} = [{}]", curve.name, points.join(", "));
    }
    text += "\n[[method]]\nname = \"Dirichlet\"\nenergy = \"dirichlet\"\n\n\
             [[method]]\nname = \"least area\"\nenergy = \"area\"\n";
    text
}

/// The sides in the order and the sense in which they run around the boundary.
fn around(sides: Vec<Side>) -> Result<Vec<Curve>, ImportError> {
    if let Some(side) = sides.iter().find(|side| side.points.len() < 2) {
        return Err(ImportError::Sides(format!(
            "side {:?} has a single point; two are the least",
            side.name
        )));
    }
    let names: &[(&str, bool)] = match sides.len() {
        3 => &TRIANGLE,
        4 => &TENSOR,
        count => {
            let sides = if count == 1 { "is 1 side".into() } else { format!("are {count} sides") };
            return Err(ImportError::Sides(format!(
                "there {sides}: four make a tensor boundary, three a triangular one; every side has a name of its own in a table, \
                 lines of its own in an OBJ file"
            )));
        }
    };
    let curve = |(name, forward): (&'static str, bool), mut side: Side, turned: bool| {
        if turned {
            side.points.reverse();
        }
        // Lines of an OBJ file need no name.
        let label = if side.name.is_empty() { name.to_owned() } else { side.name };
        Curve { name, label, points: side.points, forward, fit: None }
    };
    let named: Option<Vec<Curve>> = names
        .iter()
        .map(|&(name, forward)| {
            let side = sides.iter().find(|side| side.name == name)?;
            Some(curve((name, forward), side.clone(), !forward))
        })
        .collect();
    if let Some(named) = named {
        return Ok(named);
    }
    // Without the names of experiments the sides are chained, each the one that begins or ends nearest to where the chain ends.
    let mut rest = sides;
    let mut chain = vec![curve(names[0], rest.remove(0), false)];
    while let Some(end) = chain.last().map(|curve| last(&curve.points)) {
        let nearest = (0..rest.len())
            .flat_map(|k| [(k, false), (k, true)])
            .map(|(k, turned)| {
                let points = &rest[k].points;
                (end.distance(if turned { last(points) } else { points[0] }), k, turned)
            })
            .min_by(|a, b| a.0.total_cmp(&b.0));
        let Some((_, k, turned)) = nearest else { break };
        chain.push(curve(names[chain.len()], rest.remove(k), turned));
    }
    Ok(chain)
}

fn last(points: &[Point]) -> Point {
    points.last().copied().unwrap_or_default()
}

/// A basic string of TOML.
fn quoted(text: &str) -> String {
    let mut quoted = String::from("\"");
    for c in text.chars() {
        match c {
            '"' | '\\' => quoted.extend(['\\', c]),
            c if c.is_control() => quoted.push(' '),
            c => quoted.push(c),
        }
    }
    quoted.push('"');
    quoted
}
