//! `[output]`.

use crate::text::{Flag, Interval, Key, List, Name, Names, Section, Ways, Whole};
use exchange::{Format, LengthUnit};

/// Most subdivisions of a mesh per side.
pub(crate) const LARGEST_MESH: usize = 2000;

static NAMES: [(&str, Format); Format::ALL.len()] = {
    let mut names = [("", Format::Obj); Format::ALL.len()];
    let mut k = 0;
    while k < names.len() {
        names[k] = (Format::ALL[k].name(), Format::ALL[k]);
        k += 1;
    }
    names
};

pub(crate) static MESH: Key<Whole<usize>> = Key::new(
    "mesh",
    Whole::between(2, LARGEST_MESH as u64),
    "the number of subdivisions of each side of the surface mesh",
)
.or("48");
pub(crate) static FORMATS: Key<Names<Format>> = Key::new(
    "formats",
    List { each: Name(&NAMES), least: 0, most: 100, example: "[\"obj\", \"ply\"]" },
    "the formats of the files for other programs",
)
.or("[]")
.such_as("[\"obj\"]");
pub(crate) static PICTURES: Key<Flag> =
    Key::new("pictures", Flag, "whether SVG pictures and report.html are written").or("true");
pub(crate) static STEP_TOLERANCE: Key<Interval> = Key::new(
    "step-tolerance",
    Interval::above(0.0, 1.0),
    "the largest distance between a fitted surface, in a STEP file or in Bézier cells, and the patch, as a share of the patch's size",
)
.or("1e-6");
pub(crate) static STEP_UNIT: Key<Name<LengthUnit>> = Key::new(
    "step-unit",
    Name(&LengthUnit::NAMED),
    "what the numbers are: STEP files say so and have them unchanged, GLB, which is in metres, is scaled; without it STEP says millimetres and GLB \
     has the numbers as they are",
)
.such_as("\"m\"");

pub(crate) static SECTION: Section = Section {
    doc: "what is written beside result.json",
    keys: &[&MESH, &FORMATS, &PICTURES, &STEP_TOLERANCE, &STEP_UNIT],
    ways: Ways::Free,
};
