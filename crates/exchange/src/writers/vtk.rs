//! The frame of a VTK file (XML, unstructured grid). Arrays are inline base64 of little-endian numbers.

use std::io::{self, Write};

use base64::prelude::BASE64_STANDARD;
use base64::write::EncoderWriter;
use surfaces::Point;

/// A cell by its type in VTK and the numbers of its points.
pub(super) struct Cell<'a> {
    pub(super) kind: u8,
    pub(super) nodes: &'a [u32],
}

/// Writes a whole file: points, what `data` writes of them and of the cells, cells.
pub(super) fn grid<'a>(
    points: &[Point],
    cells: impl ExactSizeIterator<Item = Cell<'a>> + Clone,
    data: impl FnOnce(&mut dyn Write) -> io::Result<()>,
    out: &mut dyn Write,
) -> io::Result<()> {
    let (count, cell_count) = (points.len(), cells.len());
    out.write_all(
        b"<?xml version=\"1.0\"?>\n\
          <VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\">\n\
          <UnstructuredGrid>\n",
    )?;
    writeln!(out, "<Piece NumberOfPoints=\"{count}\" NumberOfCells=\"{cell_count}\">")?;
    data(out)?;
    writeln!(out, "<Points>")?;
    doubles("points", [count, 3], points.iter().flat_map(|p| [p.x, p.y, p.z]), out)?;
    writeln!(out, "</Points>\n<Cells>")?;
    let ends = cells.clone().scan(0, |end, cell| {
        *end += cell.nodes.len();
        Some(*end)
    });
    let nodes = cells.clone().flat_map(|cell| cell.nodes).map(|&k| i64::from(k).to_le_bytes());
    array("Int64", "connectivity", [ends.clone().last().unwrap_or(0), 1], nodes, out)?;
    array("Int64", "offsets", [cell_count, 1], ends.map(|end| (end as i64).to_le_bytes()), out)?;
    array("UInt8", "types", [cell_count, 1], cells.map(|cell| [cell.kind]), out)?;
    out.write_all(b"</Cells>\n</Piece>\n</UnstructuredGrid>\n</VTKFile>\n")
}

pub(super) fn doubles(
    name: &str,
    size: [usize; 2],
    values: impl Iterator<Item = f64>,
    out: &mut dyn Write,
) -> io::Result<()> {
    array("Float64", name, size, values.map(f64::to_le_bytes), out)
}

/// One array of so many tuples of so many numbers: the number of its bytes, then the bytes, in base64, as they come.
pub(super) fn array<const N: usize>(
    kind: &str,
    name: &str,
    [tuples, components]: [usize; 2],
    numbers: impl Iterator<Item = [u8; N]>,
    out: &mut dyn Write,
) -> io::Result<()> {
    writeln!(
        out,
        "<DataArray type=\"{kind}\" Name=\"{name}\" NumberOfComponents=\"{components}\" format=\"binary\">"
    )?;
    let mut coded = EncoderWriter::new(&mut *out, &BASE64_STANDARD);
    coded.write_all(&((N * tuples * components) as u64).to_le_bytes())?;
    for bytes in numbers {
        coded.write_all(&bytes)?;
    }
    coded.finish()?;
    drop(coded);
    writeln!(out, "\n</DataArray>")
}
