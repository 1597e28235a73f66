//! Binary glTF 2.0: one mesh, coloured by its mean curvature, or moving between shapes.
//!
//! glTF has y up and single precision. The vertices keep their own coordinates; a rotation of the node turns z up.

use std::io::{self, Write};

use serde_json::{Map, Value, json};
use surfaces::{Mesh, Point};

use super::{Export, Subject, colour, extent, fits_single};

/// Which parameter of a vertex, index or key frame a number is, in the terms of glTF.
const FLOAT: u32 = 5126;
const UNSIGNED_INT: u32 = 5125;
const UNSIGNED_BYTE: u32 = 5121;
const ARRAY_BUFFER: u32 = 34962;
const ELEMENT_ARRAY_BUFFER: u32 = 34963;

pub(crate) struct Glb;

impl Export for Glb {
    fn write(&self, subject: &Subject<'_>, out: &mut dyn Write) -> io::Result<()> {
        write(subject.name, subject.mesh, None, out)
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

/// Writes the whole file.
///
/// # Errors
/// `InvalidData` if a coordinate is beyond single precision or the file beyond 4 GiB, which the format cannot hold;
/// else what `out` says.
pub(crate) fn write(
    name: &str,
    mesh: &Mesh,
    motion: Option<&Motion<'_>>,
    out: &mut dyn Write,
) -> io::Result<()> {
    if !fits_single(&mesh.points) {
        return Err(beyond_single());
    }
    let mut buffer = Buffer::default();
    let vectors = |points: &[Point]| -> Vec<[f32; 3]> {
        points.iter().map(|p| [p.x as f32, p.y as f32, p.z as f32]).collect()
    };
    let mut attributes = Map::new();
    attributes.insert("POSITION".into(), buffer.positions(&vectors(&mesh.points))?.into());
    attributes.insert("NORMAL".into(), buffer.vectors(&vectors(&mesh.normals))?.into());
    let mut extras = Map::new();
    if motion.is_none()
        && let Some((colours, full)) = colour::by_mean_curvature(mesh)
    {
        attributes.insert("COLOR_0".into(), buffer.colours(&colours).into());
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
    if let Some(Motion { targets, keys }) = motion {
        let moved =
            targets.iter().map(|(_, shifts)| Ok(json!({ "POSITION": buffer.positions(&vectors(shifts))? })));
        primitive["targets"] = moved.collect::<io::Result<Vec<Value>>>()?.into();
        gltf_mesh["weights"] = keys.first().map_or(Vec::new(), |(_, weights)| weights.clone()).into();
        extras.insert("targetNames".into(), targets.iter().map(|(name, _)| *name).collect());
        let times: Vec<f32> = keys.iter().map(|(time, _)| *time as f32).collect();
        let weights: Vec<f32> = keys.iter().flat_map(|(_, weights)| weights).map(|w| *w as f32).collect();
        animations.push(json!({
            "name": name,
            "samplers": [{
                "input": buffer.times(&times),
                "interpolation": "LINEAR",
                "output": buffer.scalars(&weights),
            }],
            "channels": [{ "sampler": 0, "target": { "node": 0, "path": "weights" } }],
        }));
    }
    gltf_mesh["primitives"] = vec![primitive].into();
    if !extras.is_empty() {
        gltf_mesh["extras"] = extras.into();
    }
    let half = std::f64::consts::FRAC_1_SQRT_2;
    let mut root = json!({
        "asset": { "version": "2.0", "generator": concat!("plateau ", env!("CARGO_PKG_VERSION")) },
        "scene": 0,
        "scenes": [{ "nodes": [0] }],
        "nodes": [{ "name": name, "mesh": 0, "rotation": [-half, 0.0, 0.0, half] }],
        "meshes": [gltf_mesh],
        "materials": [{
            "doubleSided": true,
            "pbrMetallicRoughness": { "metallicFactor": 0.0, "roughnessFactor": 0.5 },
        }],
    });
    if !animations.is_empty() {
        root["animations"] = animations.into();
    }
    root["accessors"] = buffer.accessors.into();
    root["bufferViews"] = buffer.views.into();
    root["buffers"] = json!([{ "byteLength": buffer.bytes.len() }]);
    chunks(&root, &buffer.bytes, out)
}

/// The two chunks of the container, each padded to four bytes.
fn chunks(root: &Value, binary: &[u8], out: &mut dyn Write) -> io::Result<()> {
    let mut text = serde_json::to_vec(root)?;
    text.resize(text.len().next_multiple_of(4), b' ');
    let length = |bytes: usize| {
        let too_long = || {
            io::Error::new(io::ErrorKind::InvalidData, "a GLB file holds at most 4 GiB: take a coarser mesh")
        };
        u32::try_from(bytes).map_err(|_| too_long())
    };
    out.write_all(b"glTF")?;
    out.write_all(&2u32.to_le_bytes())?;
    out.write_all(&length(12 + 8 + text.len() + 8 + binary.len())?.to_le_bytes())?;
    for (kind, bytes) in [(b"JSON", text.as_slice()), (b"BIN\0", binary)] {
        out.write_all(&length(bytes.len())?.to_le_bytes())?;
        out.write_all(kind)?;
        out.write_all(bytes)?;
    }
    Ok(())
}

/// The binary chunk as it grows, with the views and accessors into it. Everything in it is made of four-byte words.
#[derive(Default)]
struct Buffer {
    bytes: Vec<u8>,
    views: Vec<Value>,
    accessors: Vec<Value>,
}

impl Buffer {
    /// Points, with their extent, which glTF demands of positions.
    fn positions(&mut self, points: &[[f32; 3]]) -> io::Result<usize> {
        let index = self.vectors(points)?;
        let [low, high] = extent(points.iter().map(|p| p.map(f64::from)));
        self.accessors[index]["min"] = json!(low);
        self.accessors[index]["max"] = json!(high);
        Ok(index)
    }

    fn vectors(&mut self, vectors: &[[f32; 3]]) -> io::Result<usize> {
        if !vectors.iter().flatten().all(|x| x.is_finite()) {
            return Err(beyond_single());
        }
        let bytes = vectors.iter().flatten().flat_map(|x| x.to_le_bytes());
        Ok(self.accessor(bytes, Some(ARRAY_BUFFER), FLOAT, "VEC3", vectors.len()))
    }

    fn colours(&mut self, colours: &[[u8; 3]]) -> usize {
        let bytes = colours.iter().flat_map(|c| c.map(linear).into_iter().chain([u8::MAX]));
        let index = self.accessor(bytes, Some(ARRAY_BUFFER), UNSIGNED_BYTE, "VEC4", colours.len());
        self.accessors[index]["normalized"] = true.into();
        index
    }

    fn indices(&mut self, triangles: &[[u32; 3]]) -> usize {
        let bytes = triangles.iter().flatten().flat_map(|k| k.to_le_bytes());
        self.accessor(bytes, Some(ELEMENT_ARRAY_BUFFER), UNSIGNED_INT, "SCALAR", 3 * triangles.len())
    }

    /// Times, with their extent, which glTF demands of the input of an animation.
    fn times(&mut self, times: &[f32]) -> usize {
        let index = self.scalars(times);
        self.accessors[index]["min"] = json!([times.first()]);
        self.accessors[index]["max"] = json!([times.last()]);
        index
    }

    fn scalars(&mut self, numbers: &[f32]) -> usize {
        self.accessor(numbers.iter().flat_map(|x| x.to_le_bytes()), None, FLOAT, "SCALAR", numbers.len())
    }

    fn accessor(
        &mut self,
        bytes: impl Iterator<Item = u8>,
        target: Option<u32>,
        component: u32,
        kind: &str,
        count: usize,
    ) -> usize {
        let offset = self.bytes.len();
        self.bytes.extend(bytes);
        let mut view = json!({ "buffer": 0, "byteOffset": offset, "byteLength": self.bytes.len() - offset });
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
        self.accessors.len() - 1
    }
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
        write("paraboloid", &mesh, None, &mut bytes).unwrap();
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
    fn coordinates_beyond_single_precision_are_refused() {
        let mut mesh = paraboloid();
        mesh.points[3].z = 1e39;
        let error = write("far", &mesh, None, &mut Vec::new()).unwrap_err();
        assert_eq!(error.kind(), io::ErrorKind::InvalidData);
    }
}
