//! `result.json` read back: the surfaces of its methods, bit for bit.

use std::collections::{HashMap, HashSet};
use std::fs::File;
use std::io::{self, ErrorKind, Read};
use std::path::Path;

use serde::Deserialize;
use serde::de::DeserializeOwned;
use serde_json::Value;
use surfaces::{
    Bezier, Complex, FixedEdge, Mesh, Net, Pieces, Point, SurfaceError, TensorPatch, TriangleNet,
    TrianglePatch, Vertex,
};
use thiserror::Error;

use crate::atomic::regular;
use crate::export::{self, Named};
use crate::file_name::file_names;
use crate::result_size::{Excess, MAX_TABLES, MAX_VALUES, excess};
use crate::{Destination, ExportError, SCHEMA};
use exchange::{Format, SurfaceForm};
use plateau::{Family, MAX_DEGREE, MethodResult, Surface};

/// Largest size in bytes of a result file.
const LARGEST_FILE: u64 = 64 * 1024 * 1024;

/// Why a result could not be read.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum ReadError {
    /// The file system.
    #[error("cannot be read: {0}")]
    Io(#[from] io::Error),
    /// Too large to be one.
    #[error("is larger than {} MiB, the most that is read of a result", LARGEST_FILE >> 20)]
    TooLarge,
    /// More than fits into a reasonable amount of memory.
    #[error("holds more than {most} {what}, the most that is read of a result")]
    TooMuch {
        /// The limit.
        most: usize,
        /// What there is too much of.
        what: &'static str,
    },
    /// A folder.
    #[error("is a folder: name the result.json in it")]
    Folder,
    /// No JSON, or a value of the wrong kind.
    #[error("{place}{source}; this should be a result.json of `plateau run`")]
    Json {
        /// The key and a colon, or nothing.
        place: String,
        /// What was found, and what was expected.
        source: serde_json::Error,
    },
    /// Another layout.
    #[error("`schema` is {found:?}, this program reads {SCHEMA:?}")]
    Schema {
        /// What the file says.
        found: String,
    },
    /// A key that is needed.
    #[error("`{key}` is missing: results of early versions lack it; run the experiment again to have it")]
    Missing {
        /// The key, from the root.
        key: String,
    },
    /// A value that does not fit.
    #[error("`{key}`: {why}")]
    Unfit {
        /// The key, from the root.
        key: String,
        /// What is wrong with it.
        why: String,
    },
}

/// The surfaces of a result.
#[derive(Debug, Clone)]
#[non_exhaustive]
pub struct StoredResult {
    /// The title of the experiment.
    pub title: String,
    /// Its methods, in the order of the file.
    pub methods: Vec<StoredMethod>,
}

/// A method of a result.
#[derive(Debug, Clone)]
#[non_exhaustive]
pub struct StoredMethod {
    /// The name of the row.
    pub name: String,
    /// A name for files of it, distinct from those of the other methods.
    pub file_name: String,
    /// Its surface and what that is made of, or the error with which the method failed.
    pub surface: Result<(Surface, Family), String>,
}

/// What is read of the file; everything else in it is left alone.
#[derive(Deserialize)]
struct Record {
    schema: Option<String>,
    title: Option<String>,
    methods: Option<Vec<Entry>>,
}

#[derive(Deserialize)]
struct Entry {
    name: Option<String>,
    error: Option<String>,
    patch: Option<String>,
    basis: Option<String>,
    shape: Option<Value>,
    net: Option<Value>,
    domain: Option<Value>,
    pieces: Option<Value>,
    faces: Option<Value>,
    vertices: Option<Value>,
}

#[derive(Deserialize)]
struct DomainEntry {
    u: [f64; 2],
    v: [f64; 2],
}

#[derive(Deserialize)]
struct PieceEntry {
    u: [f64; 2],
    v: [f64; 2],
    net: Vec<Vec<[f64; 3]>>,
}

#[derive(Deserialize)]
struct FaceEntry {
    vertices: [String; 4],
    net: Rows,
}

#[derive(Deserialize)]
struct IndexedPoint {
    index: [usize; 3],
    point: [f64; 3],
}

impl StoredResult {
    /// Reads a file.
    ///
    /// # Errors
    /// [`ReadError`]; the file itself is not named in it.
    pub fn read(path: &Path) -> Result<Self, ReadError> {
        Self::parse(&contents(path)?)
    }

    /// Reads the bytes of a file.
    ///
    /// # Errors
    /// [`ReadError`].
    pub fn parse(bytes: &[u8]) -> Result<Self, ReadError> {
        check_size(bytes)?;
        let record: Record = serde_json::from_slice(bytes)
            .map_err(|source| ReadError::Json { place: String::new(), source })?;
        check_schema(record.schema)?;
        let title = required(record.title, "title")?;
        let entries = required(record.methods, "methods")?;
        let name = |(k, entry): (usize, &Entry)| required(entry.name.clone(), &format!("methods[{k}].name"));
        let names: Vec<String> = entries.iter().enumerate().map(name).collect::<Result<_, _>>()?;
        let files = file_names(names.iter().map(String::as_str));
        let mut methods = Vec::new();
        for (k, ((entry, name), file_name)) in entries.into_iter().zip(names).zip(files).enumerate() {
            let surface = match entry.error.clone() {
                Some(error) => Err(error),
                None => Ok(surface(entry, &format!("methods[{k}]"))?),
            };
            methods.push(StoredMethod { name, file_name, surface });
        }
        Ok(Self { title, methods })
    }
}

/// The bytes of a result in a folder of this program. What is no regular file there is none of ours: a pipe would keep its
/// reader waiting.
///
/// # Errors
/// [`ReadError`]: what the file system says, or that it is too large to be one.
pub fn own_contents(path: &Path) -> Result<Vec<u8>, ReadError> {
    match regular(path) {
        Some(_) => contents(path),
        None => Err(io::Error::from(ErrorKind::NotFound).into()),
    }
}

/// The bytes of a file that may be a result, or of a pipe, where a person named one.
pub(crate) fn contents(path: &Path) -> Result<Vec<u8>, ReadError> {
    if path.is_dir() {
        return Err(ReadError::Folder);
    }
    let mut bytes = Vec::new();
    File::open(path)?.take(LARGEST_FILE + 1).read_to_end(&mut bytes)?;
    if bytes.len() as u64 > LARGEST_FILE {
        return Err(ReadError::TooLarge);
    }
    check_size(&bytes)?;
    Ok(bytes)
}

/// Refuses a text that would take many times its length, before it is parsed.
pub(crate) fn check_size(bytes: &[u8]) -> Result<(), ReadError> {
    match excess(bytes) {
        None => Ok(()),
        Some(Excess::Values) => Err(ReadError::TooMuch { most: MAX_VALUES, what: "values" }),
        Some(Excess::Tables) => Err(ReadError::TooMuch { most: MAX_TABLES, what: "tables" }),
    }
}

impl StoredMethod {
    /// A method that was just run, as it would be read back.
    #[must_use]
    pub fn of(result: &MethodResult) -> Self {
        let surface = result.outcome.as_ref().map(|done| (done.solved.surface.clone(), done.solved.family));
        let file_name = file_names(std::iter::once(result.name.as_str())).swap_remove(0);
        Self { name: result.name.clone(), file_name, surface: surface.map_err(ToString::to_string) }
    }

    /// Writes the surface as a file, whole or not at all: a mesh with `subdivisions` per side, or, for formats that hold a
    /// surface by a formula, that within `tolerance` times its size. In the latter case, what the file holds.
    ///
    /// # Errors
    /// [`ExportError::Refused`] if the method failed or the format cannot hold the surface, else the file system's.
    pub fn export(
        &self,
        format: Format,
        subdivisions: usize,
        tolerance: f64,
        to: &Destination,
    ) -> Result<Option<SurfaceForm>, ExportError> {
        let (surface, family) = self.surface.as_ref().map_err(|error| ExportError::Refused {
            path: to.path().to_owned(),
            reason: format!("the method failed: {error}"),
        })?;
        let mesh = if format.holds_a_mesh() {
            surface.mesh(subdivisions).map_err(|error| ExportError::Refused {
                path: to.path().to_owned(),
                reason: error.to_string(),
            })?
        } else {
            Mesh::default()
        };
        export::write(
            format,
            Named { name: &self.name, surface, family: *family, mesh: &mesh },
            tolerance,
            to,
        )
    }
}

fn surface(mut entry: Entry, place: &str) -> Result<(Surface, Family), ReadError> {
    let key = |name: &str| format!("{place}.{name}");
    let (patch, basis) =
        (required(entry.patch.take(), &key("patch"))?, required(entry.basis.take(), &key("basis"))?);
    let family = Family::named(&patch, &basis).ok_or_else(|| {
        let known: Vec<String> = Family::all()
            .map(|family| format!("{:?} with {:?}", family.names().0, family.names().1))
            .collect();
        unfit(
            &key("patch"),
            format!("{patch:?} with basis {basis:?} is not known; surfaces are {}", known.join(", ")),
        )
    })?;
    let net_key = key("net");
    let whole =
        |net: Option<Value>| -> Result<Net, ReadError> { net_of(&typed::<Rows>(net, &net_key)?, &net_key) };
    let shape = |value: Option<Value>| typed::<Vec<f64>>(value, &key("shape"));
    let sound = |result: Result<TensorPatch, SurfaceError>| {
        result.map(Surface::Tensor).map_err(|error| unfit(place, error.to_string()))
    };
    let surface = match family {
        Family::Bernstein => sound(TensorPatch::bernstein(whole(entry.net)?))?,
        Family::Shaped(family) => sound(family.patch(whole(entry.net)?, &shape(entry.shape)?))?,
        Family::Complex => {
            let faces: Vec<FaceEntry> = typed(entry.faces, &key("faces"))?;
            // Results of early versions lack it.
            let order = entry.vertices.map(|names| typed(Some(names), &key("vertices"))).transpose()?;
            complex(&faces, &numbers(&faces, order, &key("vertices"))?, &key("faces"))?
        }
        Family::Triangle => triangle(&typed::<Vec<IndexedPoint>>(entry.net, &net_key)?, &net_key)?,
        Family::Aht => all_pieces(entry, TensorPatch::aht, place)?,
        Family::At => all_pieces(entry, TensorPatch::at, place)?,
    };
    Ok((surface, family))
}

/// The pieces of an entry, or the one of its net and domain.
fn all_pieces(entry: Entry, patch: OfNet, place: &str) -> Result<Surface, ReadError> {
    let key = |name: &str| format!("{place}.{name}");
    let pieces = match entry.pieces {
        Some(value) => {
            let key = key("pieces");
            pieces(&typed::<Vec<PieceEntry>>(Some(value), &key)?, patch, &key)?
        }
        None => {
            let DomainEntry { u, v } = typed(entry.domain, &key("domain"))?;
            let net = typed::<Rows>(entry.net, &key("net"))?;
            pieces(&[PieceEntry { u, v, net }], patch, place)?
        }
    };
    Ok(Surface::Pieces(pieces))
}

type Rows = Vec<Vec<[f64; 3]>>;

fn net_of(rows: &Rows, key: &str) -> Result<Net, ReadError> {
    let cols = rows.first().map_or(0, Vec::len);
    if let Some(row) = rows.iter().position(|row| row.len() != cols) {
        let found = rows[row].len();
        return Err(unfit(&format!("{key}[{row}]"), format!("has {found} points, the first row {cols}")));
    }
    let most = MAX_DEGREE + 1;
    if !((2..=most).contains(&rows.len()) && (2..=most).contains(&cols)) {
        return Err(unfit(key, format!("has {} x {cols} points; 2 to {most} are possible", rows.len())));
    }
    let points = rows.iter().flatten().copied().map(Point::from).collect();
    Net::new(rows.len(), cols, points).map_err(|error| unfit(key, error.to_string()))
}

fn triangle(points: &[IndexedPoint], key: &str) -> Result<Surface, ReadError> {
    let size = |n: usize| (n + 1) * (n + 2) / 2;
    let degree = (1..=MAX_DEGREE).find(|&n| size(n) == points.len()).ok_or_else(|| {
        unfit(key, format!("has {} points, no triangular net of degree 1 to {MAX_DEGREE}", points.len()))
    })?;
    let blank = TriangleNet::new(degree, vec![Point::ZERO; points.len()])
        .map_err(|error| unfit(key, error.to_string()))?;
    let mut ordered = vec![None; points.len()];
    for (k, entry) in points.iter().enumerate() {
        let [i, j, l] = entry.index;
        let here = format!("{key}[{k}].index");
        if i > degree || j > degree || l > degree || i + j + l != degree {
            return Err(unfit(&here, format!("{:?} does not add up to the degree {degree}", entry.index)));
        }
        let place = blank.position(i, j);
        if ordered[place].replace(Point::from(entry.point)).is_some() {
            return Err(unfit(&here, format!("{:?} stands there twice", entry.index)));
        }
    }
    let points: Vec<Point> = ordered.into_iter().flatten().collect();
    TriangleNet::new(degree, points)
        .and_then(TrianglePatch::new)
        .map(Surface::Triangle)
        .map_err(|error| unfit(key, error.to_string()))
}

fn pieces(entries: &[PieceEntry], patch: OfNet, key: &str) -> Result<Pieces, ReadError> {
    let Some(first) = entries.first() else { return Err(unfit(key, "is empty".into())) };
    let cols = entries.iter().take_while(|entry| entry.u == first.u).count();
    let cuts = |ends: &mut dyn Iterator<Item = [f64; 2]>| -> Vec<f64> {
        let mut cuts = Vec::new();
        for [start, end] in ends {
            if cuts.is_empty() {
                cuts.push(start);
            }
            cuts.push(end);
        }
        cuts
    };
    let v = cuts(&mut entries[..cols].iter().map(|entry| entry.v));
    let u = cuts(&mut entries.iter().step_by(cols).map(|entry| entry.u));
    let mut patches = Vec::with_capacity(entries.len());
    for (k, entry) in entries.iter().enumerate() {
        let here = format!("{key}[{k}]");
        let net = net_of(&entry.net, &format!("{here}.net"))?;
        let (row, col) = (k / cols, k % cols);
        if [u[row], u[row + 1]] != entry.u || [v[col], v[col + 1]] != entry.v {
            return Err(unfit(
                &here,
                "its intervals do not continue the grid of the pieces before it".into(),
            ));
        }
        let spans = [entry.u, entry.v].map(|[start, end]| end - start);
        patches.push(patch(net, spans).map_err(|error| unfit(&here, error.to_string()))?);
    }
    Pieces::from_patches(u, v, patches).map_err(|error| unfit(key, error.to_string()))
}

/// The numbers of the vertices of faces: as `order` lists their names, else as they are met.
fn numbers(
    faces: &[FaceEntry],
    order: Option<Vec<String>>,
    key: &str,
) -> Result<HashMap<String, usize>, ReadError> {
    let (mut met, mut listed) = (HashMap::new(), HashMap::new());
    for name in faces.iter().flat_map(|face| &face.vertices) {
        let next = met.len();
        met.entry(name.clone()).or_insert(next);
    }
    let Some(order) = order else { return Ok(met) };
    for name in order {
        let next = listed.len();
        if !met.contains_key(&name) || listed.contains_key(&name) {
            return Err(unfit(key, format!("{name:?} is no vertex of a face, or stands twice")));
        }
        listed.insert(name, next);
    }
    match met.into_keys().find(|name| !listed.contains_key(name)) {
        Some(name) => Err(unfit(key, format!("{name:?} is missing, a vertex of a face"))),
        None => Ok(listed),
    }
}

/// The complex of faces that share the edges between vertices of the same names.
fn complex(faces: &[FaceEntry], numbers: &HashMap<String, usize>, key: &str) -> Result<Surface, ReadError> {
    let Some(first) = faces.first() else { return Err(unfit(key, "is empty".into())) };
    let degree = first.net.len().saturating_sub(1);
    let mut vertices = vec![Vertex::Free(None); numbers.len()];
    let (mut corners, mut edges, mut met) = (Vec::new(), Vec::new(), HashSet::new());
    for (k, face) in faces.iter().enumerate() {
        let here = format!("{key}[{k}].net");
        let net = net_of(&face.net, &here)?;
        if net.degrees() != (degree, degree) {
            return Err(unfit(&here, format!("has degrees {:?}, the first face {degree}", net.degrees())));
        }
        let [u0, u1, v0, v1] = net.boundary();
        let places = [u0[0], u1[0], u1[degree], u0[degree]];
        let quad: [usize; 4] = std::array::from_fn(|c| numbers[&face.vertices[c]]);
        for (vertex, place) in quad.into_iter().zip(places) {
            if let Vertex::Free(_) = vertices[vertex] {
                vertices[vertex] = Vertex::Fixed(place);
            }
        }
        for (ends, side) in [([0, 3], u0), ([1, 2], u1), ([0, 1], v0), ([3, 2], v1)] {
            let ends = ends.map(|c| quad[c]);
            if met.insert([ends[0].min(ends[1]), ends[0].max(ends[1])]) {
                let curve = Bezier::new(side).map_err(|error| unfit(&here, error.to_string()))?;
                edges.push(FixedEdge { ends, curve });
            }
        }
        corners.push(quad);
    }
    let whole = Complex::new(degree, &vertices, &corners, &edges);
    let filled = whole.and_then(|whole| {
        let mut points = whole.points().to_vec();
        for (face, entry) in whole.faces().iter().zip(faces) {
            for (&node, &point) in face.nodes().iter().zip(entry.net.iter().flatten()) {
                points[node] = point.into();
            }
        }
        whole.with_points(points)
    });
    filled.map(Surface::Complex).map_err(|error| unfit(key, error.to_string()))
}

/// The patch of a net over intervals of two lengths.
type OfNet = fn(Net, [f64; 2]) -> Result<TensorPatch, SurfaceError>;

pub(crate) fn check_schema(found: Option<String>) -> Result<(), ReadError> {
    let found = required(found, "schema")?;
    if found == SCHEMA { Ok(()) } else { Err(ReadError::Schema { found: found.chars().take(80).collect() }) }
}

pub(crate) fn required<T>(value: Option<T>, key: &str) -> Result<T, ReadError> {
    value.ok_or_else(|| ReadError::Missing { key: key.into() })
}

fn typed<T: DeserializeOwned>(value: Option<Value>, key: &str) -> Result<T, ReadError> {
    serde_json::from_value(required(value, key)?)
        .map_err(|source| ReadError::Json { place: format!("`{key}`: "), source })
}

fn unfit(key: &str, why: String) -> ReadError {
    ReadError::Unfit { key: key.into(), why }
}
