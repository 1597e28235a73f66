//! Binary glTF 2.0: one mesh, coloured by its mean curvature, or moving between shapes.
//!
//! glTF has y up and single precision. The vertices keep their own coordinates; a rotation of the node turns z up. Far from the
//! origin, where single precision would lose the shape, the vertices are seen from the middle of their box, and a translation of
//! the node puts them back. glTF is in metres: where the unit of the numbers is known, the node scales them.

use std::io::{self, Write};

use serde_json::{Map, Value, json};
use surfaces::Point;

use crate::LengthUnit;
use crate::writers::extent::extent;
use crate::writers::single;
use crate::writers::subject::{Colours, Export, Subject};

/// Which parameter of a vertex, index or key frame a number is, in the terms of glTF.
const FLOAT: u32 = 5126;
const UNSIGNED_INT: u32 = 5125;
const UNSIGNED_BYTE: u32 = 5121;
const ARRAY_BUFFER: u32 = 34962;
const ELEMENT_ARRAY_BUFFER: u32 = 34963;

pub(crate) struct Glb;

impl Export for Glb {
    fn write(&self, subject: &Subject<'_>, out: &mut dyn Write) -> io::Result<()> {
        write(subject, None, out)
    }
}

/// How a mesh moves: the vertices at time t are `points + Σ_k weights_k(t) targets_k`, the weights linear between the keys.
/// Normals do not move.
pub(crate) struct Motion<'a> {
    /// Name and displacements of the vertices.
    pub(crate) targets: Vec<(&'a str, Vec<Point>)>,
    /// Times in seconds, ascending from 0, each with one weight per target.
    pub(crate) keys: Vec<(f64, Vec<f64>)>,
}

fn beyond_single() -> io::Error {
    let why =
        "its coordinates are beyond the single precision of glTF: scale the points, or write another format";
    io::Error::new(io::ErrorKind::InvalidData, why)
}

/// Writes the whole file, as it comes.
///
/// # Errors
/// `InvalidData` if a coordinate is beyond single precision or the file beyond 4 GiB, which the format cannot hold;
/// else what `out` says.
pub(crate) fn write(
    &Subject { name, mesh, colours, unit }: &Subject<'_>,
    motion: Option<&Motion<'_>>,
    out: &mut dyn Write,
) -> io::Result<()> {
    if !single::fits(&mesh.points) {
        return Err(beyond_single());
    }
    let origin = single::origin(&mesh.points);
    let mut buffer = Buffer::default();
    let mut attributes = Map::new();
    attributes
        .insert("POSITION".into(), buffer.positions(&mesh.points, origin.unwrap_or(Point::ZERO))?.into());
    attributes.insert("NORMAL".into(), buffer.vectors(&mesh.normals, Point::ZERO)?.into());
    let mut extras = Map::new();
    if motion.is_none()
        && let Some(Colours { of_vertices, full }) = colours
    {
        attributes.insert("COLOR_0".into(), buffer.colours(of_vertices).into());
        extras.insert("mean_curvature_at_full_colour".into(), full.into());
    }
    let mut primitive = json!({
        "attributes": attributes,
        "indices": buffer.indices(&mesh.triangles),
        "material": 0,
        "mode": 4,
    });
    let mut gltf_mesh = json!({ "name": name });
    let mut animations = Vec::new();
    if let Some(motion) = motion {
        primitive["targets"] = targets(motion, &mut buffer)?.into();
        gltf_mesh["weights"] = motion.keys.first().map_or(Vec::new(), |(_, weights)| weights.clone()).into();
        extras.insert("targetNames".into(), motion.targets.iter().map(|(name, _)| *name).collect());
        animations.push(animation(name, motion, &mut buffer));
    }
    gltf_mesh["primitives"] = vec![primitive].into();
    if !extras.is_empty() {
        gltf_mesh["extras"] = extras.into();
    }
    let mut root = json!({
        "asset": { "version": "2.0", "generator": concat!("plateau ", env!("CARGO_PKG_VERSION")) },
        "scene": 0,
        "scenes": [{ "nodes": [0] }],
        "nodes": [node(name, origin, unit.map_or(1.0, LengthUnit::metres))],
        "meshes": [gltf_mesh],
        "materials": [{
            "doubleSided": true,
            "pbrMetallicRoughness": { "metallicFactor": 0.0, "roughnessFactor": 0.5 },
        }],
    });
    if !animations.is_empty() {
        root["animations"] = animations.into();
    }
    root["accessors"] = std::mem::take(&mut buffer.accessors).into();
    root["bufferViews"] = std::mem::take(&mut buffer.views).into();
    root["buffers"] = json!([{ "byteLength": buffer.length }]);
    chunks(&root, &buffer, out)
}

/// The displacements of the vertices, one accessor a target.
fn targets<'a>(motion: &'a Motion<'_>, buffer: &mut Buffer<'a>) -> io::Result<Vec<Value>> {
    let target = |(_, shifts): &'a (&str, Vec<Point>)| {
        Ok(json!({ "POSITION": buffer.positions(shifts, Point::ZERO)? }))
    };
    motion.targets.iter().map(target).collect()
}

/// The weights of the targets over the time.
fn animation(name: &str, motion: &Motion<'_>, buffer: &mut Buffer<'_>) -> Value {
    let times = motion.keys.iter().map(|(time, _)| *time as f32).collect();
    let weights = motion.keys.iter().flat_map(|(_, weights)| weights).map(|w| *w as f32).collect();
    json!({
        "name": name,
        "samplers": [{
            "input": buffer.times(times),
            "interpolation": "LINEAR",
            "output": buffer.scalars(weights),
        }],
        "channels": [{ "sampler": 0, "target": { "node": 0, "path": "weights" } }],
    })
}

/// The mesh with y up, moved to where it lies, its numbers of so many metres each.
fn node(name: &str, origin: Option<Point>, metres: f64) -> Value {
    let half = std::f64::consts::FRAC_1_SQRT_2;
    let mut node = json!({ "name": name, "mesh": 0, "rotation": [-half, 0.0, 0.0, half] });
    if let Some(p) = origin {
        // The translation follows the rotation, and both the scale.
        node["translation"] = json!([p.x * metres, p.z * metres, -p.y * metres]);
    }
    if metres != 1.0 {
        node["scale"] = json!([metres, metres, metres]);
    }
    node
}

/// The two chunks of the container, each padded to four bytes.
fn chunks(root: &Value, buffer: &Buffer<'_>, out: &mut dyn Write) -> io::Result<()> {
    let mut text = serde_json::to_vec(root)?;
    text.resize(text.len().next_multiple_of(4), b' ');
    let length = |bytes: usize| {
        let too_long = || {
            io::Error::new(io::ErrorKind::InvalidData, "a GLB file holds at most 4 GiB: take a coarser mesh")
        };
        u32::try_from(bytes).map_err(|_| too_long())
    };
    let whole = length(12 + 8 + text.len() + 8 + buffer.length)?;
    out.write_all(b"glTF")?;
    out.write_all(&2u32.to_le_bytes())?;
    out.write_all(&whole.to_le_bytes())?;
    out.write_all(&length(text.len())?.to_le_bytes())?;
    out.write_all(b"JSON")?;
    out.write_all(&text)?;
    out.write_all(&length(buffer.length)?.to_le_bytes())?;
    out.write_all(b"BIN\0")?;
    buffer.parts.iter().try_for_each(|part| part(out))
}

/// A part of the binary chunk: it is made when it is written.
type Part<'a> = Box<dyn Fn(&mut dyn Write) -> io::Result<()> + 'a>;

/// The binary chunk as it grows, with the views and accessors into it. Everything in it is made of four-byte words.
#[derive(Default)]
struct Buffer<'a> {
    parts: Vec<Part<'a>>,
    length: usize,
    views: Vec<Value>,
    accessors: Vec<Value>,
}

impl<'a> Buffer<'a> {
    /// Points as seen from `origin`, with their extent, which glTF demands of positions.
    fn positions(&mut self, points: &'a [Point], origin: Point) -> io::Result<usize> {
        let index = self.vectors(points, origin)?;
        let [low, high] = extent(points.iter().map(|&p| rounded(p - origin).map(f64::from)));
        self.accessors[index]["min"] = json!(low);
        self.accessors[index]["max"] = json!(high);
        Ok(index)
    }

    fn vectors(&mut self, vectors: &'a [Point], origin: Point) -> io::Result<usize> {
        let seen = move || vectors.iter().map(move |&p| rounded(p - origin));
        if !seen().flatten().all(f32::is_finite) {
            return Err(beyond_single());
        }
        let words = move || seen().flatten().map(f32::to_le_bytes);
        Ok(self.accessor(words, Some(ARRAY_BUFFER), FLOAT, ("VEC3", 3), vectors.len()))
    }

    fn colours(&mut self, colours: &'a [[u8; 3]]) -> usize {
        let count = colours.len();
        let words = move || {
            colours.iter().map(|c| {
                let [r, g, b] = c.map(linear);
                [r, g, b, u8::MAX]
            })
        };
        let index = self.accessor(words, Some(ARRAY_BUFFER), UNSIGNED_BYTE, ("VEC4", 1), count);
        self.accessors[index]["normalized"] = true.into();
        index
    }

    fn indices(&mut self, triangles: &'a [[u32; 3]]) -> usize {
        let words = || triangles.iter().flatten().map(|k| k.to_le_bytes());
        self.accessor(words, Some(ELEMENT_ARRAY_BUFFER), UNSIGNED_INT, ("SCALAR", 1), 3 * triangles.len())
    }

    /// Times, with their extent, which glTF demands of the input of an animation.
    fn times(&mut self, times: Vec<f32>) -> usize {
        let ends = [times.first().copied(), times.last().copied()];
        let index = self.scalars(times);
        self.accessors[index]["min"] = json!([ends[0]]);
        self.accessors[index]["max"] = json!([ends[1]]);
        index
    }

    fn scalars(&mut self, numbers: Vec<f32>) -> usize {
        let count = numbers.len();
        let words = move || numbers.clone().into_iter().map(f32::to_le_bytes);
        self.accessor(words, None, FLOAT, ("SCALAR", 1), count)
    }

    /// `count` elements of so many words each, of which `words` gives all in order.
    fn accessor<I: Iterator<Item = [u8; 4]>>(
        &mut self,
        words: impl Fn() -> I + 'a,
        target: Option<u32>,
        component: u32,
        (kind, size): (&str, usize),
        count: usize,
    ) -> usize {
        let length = 4 * size * count;
        let mut view = json!({ "buffer": 0, "byteOffset": self.length, "byteLength": length });
        if let Some(target) = target {
            view["target"] = target.into();
        }
        self.accessors.push(json!({
            "bufferView": self.views.len(),
            "componentType": component,
            "count": count,
            "type": kind,
        }));
        self.views.push(view);
        self.length += length;
        self.parts.push(Box::new(move |out| words().try_for_each(|word| out.write_all(&word))));
        self.accessors.len() - 1
    }
}

fn rounded(p: Point) -> [f32; 3] {
    [p.x as f32, p.y as f32, p.z as f32]
}

/// An sRGB component as glTF's vertex colours want it: linear.
fn linear(component: u8) -> u8 {
    let x = f64::from(component) / 255.0;
    let light = if x <= 0.04045 { x / 12.92 } else { libm::pow((x + 0.055) / 1.055, 2.4) };
    (255.0 * light).round() as u8
}

#[cfg(test)]
mod tests {
    use super::*;
    use surfaces::Mesh;

    fn subject<'a>(name: &'a str, mesh: &'a Mesh, colours: Option<Colours<'a>>) -> Subject<'a> {
        Subject { name, mesh, colours, unit: None }
    }

    fn paraboloid() -> Mesh {
        let points: Vec<Point> = (0..9)
            .map(|k| {
                let (x, y) = (f64::from(k / 3), f64::from(k % 3));
                Point::new(x, y, x * x + y * y)
            })
            .collect();
        let net = surfaces::Net::new(3, 3, points).unwrap();
        Mesh::of(&surfaces::TensorPatch::bernstein(net).unwrap(), 4)
    }

    /// The JSON and the binary chunk.
    fn parts(bytes: &[u8]) -> (Value, Vec<u8>) {
        let word = |at: usize| u32::from_le_bytes(bytes[at..at + 4].try_into().unwrap()) as usize;
        assert_eq!((&bytes[..4], word(4), word(8)), (&b"glTF"[..], 2, bytes.len()));
        let json_length = word(12);
        assert_eq!((&bytes[16..20], json_length % 4), (&b"JSON"[..], 0));
        let binary = 20 + json_length;
        assert_eq!((&bytes[binary + 4..binary + 8], word(binary)), (&b"BIN\0"[..], bytes.len() - binary - 8));
        (serde_json::from_slice(&bytes[20..binary]).unwrap(), bytes[binary + 8..].to_vec())
    }

    fn floats(root: &Value, binary: &[u8], accessor: &Value) -> Vec<f32> {
        let view = &root["bufferViews"]
            [root["accessors"][accessor.as_u64().unwrap() as usize]["bufferView"].as_u64().unwrap() as usize];
        let at = |key: &str| view[key].as_u64().unwrap() as usize;
        binary[at("byteOffset")..at("byteOffset") + at("byteLength")]
            .chunks_exact(4)
            .map(|word| f32::from_le_bytes(word.try_into().unwrap()))
            .collect()
    }

    #[test]
    fn the_file_holds_the_mesh() {
        let mesh = paraboloid();
        let mut bytes = Vec::new();
        let of_vertices = vec![[1, 2, 3]; mesh.points.len()];
        let colours = Colours { of_vertices: &of_vertices, full: 1.0 };
        write(&subject("paraboloid", &mesh, Some(colours)), None, &mut bytes).unwrap();
        let (root, binary) = parts(&bytes);
        let primitive = &root["meshes"][0]["primitives"][0];
        let positions = floats(&root, &binary, &primitive["attributes"]["POSITION"]);
        let expected: Vec<f32> =
            mesh.points.iter().flat_map(|p| [p.x as f32, p.y as f32, p.z as f32]).collect();
        assert_eq!(positions, expected);
        let accessor = &root["accessors"][0];
        assert_eq!((&accessor["min"], &accessor["max"]), (&json!([0.0, 0.0, 0.0]), &json!([2.0, 2.0, 8.0])));
        assert!(primitive["attributes"]["COLOR_0"].is_number() && root["animations"].is_null());
        let indices = root["accessors"][primitive["indices"].as_u64().unwrap() as usize]["count"].as_u64();
        assert_eq!(indices, Some(3 * 32));
    }

    #[test]
    fn far_from_the_origin_the_shape_is_kept() {
        let (near, mut far) = (paraboloid(), paraboloid());
        // Exact in double precision.
        let offset = Point::new(500_000.0, 54_000_000.0, 128.0);
        far.points.iter_mut().for_each(|p| *p += offset);
        let mut bytes = Vec::new();
        write(&subject("far", &far, None), None, &mut bytes).unwrap();
        let (root, binary) = parts(&bytes);
        let primitive = &root["meshes"][0]["primitives"][0];
        let positions = floats(&root, &binary, &primitive["attributes"]["POSITION"]);
        let [x, z, y] = [0, 1, 2].map(|k| root["nodes"][0]["translation"][k].as_f64().unwrap());
        let middle = Point::new(x, -y, z);
        for (p, q) in near.points.iter().zip(positions.chunks_exact(3)) {
            let q = Point::new(q[0].into(), q[1].into(), q[2].into()) + middle - offset;
            assert!(p.distance(q) < 1e-6, "{p:?} {q:?}");
        }
    }

    #[test]
    fn a_known_unit_puts_the_mesh_in_metres_wherever_it_lies() {
        let half = std::f64::consts::FRAC_1_SQRT_2;
        for offset in [0.0, 600_000.0] {
            let mut mesh = paraboloid();
            mesh.points.iter_mut().for_each(|p| *p += Point::new(offset, 0.0, 0.0));
            for unit in std::iter::once(None).chain(LengthUnit::NAMED.map(|(_, unit)| Some(unit))) {
                let mut bytes = Vec::new();
                write(&Subject { unit, ..subject("m", &mesh, None) }, None, &mut bytes).unwrap();
                let (root, binary) = parts(&bytes);
                let node = &root["nodes"][0];
                assert_eq!(node["rotation"], json!([-half, 0.0, 0.0, half]));
                let triple = |key: &str, usual: f64| {
                    let number = |k: usize| node[key].get(k).map_or(usual, |x| x.as_f64().unwrap());
                    [0, 1, 2].map(number)
                };
                let (scale, shift) = (triple("scale", 1.0), triple("translation", 0.0));
                let metres = unit.map_or(1.0, LengthUnit::metres);
                let positions = &root["meshes"][0]["primitives"][0]["attributes"]["POSITION"];
                for (p, q) in mesh.points.iter().zip(floats(&root, &binary, positions).chunks_exact(3)) {
                    // Scaled, turned, then moved.
                    let [x, y, z] = [0, 1, 2].map(|k| f64::from(q[k]) * scale[k]);
                    let placed = Point::new(x + shift[0], z + shift[1], -y + shift[2]);
                    let wanted = Point::new(p.x, p.z, -p.y) * metres;
                    assert!(placed.distance(wanted) < 1e-6 * metres, "{unit:?}: {placed:?} {wanted:?}");
                }
            }
        }
    }

    #[test]
    fn coordinates_beyond_single_precision_are_refused() {
        let mut mesh = paraboloid();
        mesh.points[3].z = 1e39;
        let error = write(&subject("far", &mesh, None), None, &mut Vec::new()).unwrap_err();
        assert_eq!(error.kind(), io::ErrorKind::InvalidData);
    }
}
