//! Boundaries from the files of other programs, surfaces and curves as files for them.
//!
//! [`read_curves`] knows what a file is by its content: a table of points, the lines and free-form curves of an OBJ file, the
//! edges of a STEP file, the entities of a DXF file; what it does not read it names. [`Assembly::new`] makes one boundary of
//! the curves, whatever their order and direction: ends that should meet are welded, closed polygons are cut at their corners,
//! and a graph of curves gets its faces.
//!
//! ```
//! use exchange::{Assembly, AssemblyOptions, Form, read_curves};
//!
//! let file = read_curves(b"v 0 0 0\nv 1 0 0\nv 1 1 1\nv 0 1 0\nl 3 4\nl 1 2\nl 1 4\nl 2 3\n", "skew.obj")?;
//! let assembly = Assembly::new(&file, &AssemblyOptions::default())?;
//! let Form::Loops(loops) = &assembly.form else { panic!("a loop") };
//! assert_eq!((loops.len(), loops[0].len()), (1, 4));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # What is here
//!
//! | noun | here |
//! |---|---|
//! | files of curves | [`read_curves()`], [`CurveFile`], [`FileCurve`], [`Shape`], [`Kind`], [`CurveFileError`] |
//! | one boundary of many curves | [`Assembly`], [`AssemblyOptions`], [`Form`], [`Side`], [`Walk`], [`Weld`], [`AssemblyError`]; [`Frame`], [`FrameError`] |
//! | files of surfaces | [`SurfaceFile`] in a [`Format`], which says what of [`Lengths`], of a [`Subject`], [`Colours`]; [`SurfaceForm`], [`Unfit`], [`DEFAULT_TOLERANCE`], [`StepForm`] |
//! | what the numbers of files are | [`LengthUnit`] |
//! | what is said of all that | [`Sentence`], which speaks of a [`Setting`] |
//! | the B-spline of a surface | [`spline()`] with its [`Accuracy`]; [`SplineError`] |
//! | others | [`write_curves()`], [`write_deformation()`], [`diagonal()`], [`shortest_edge()`], [`is_straight()`] |

#![warn(clippy::wildcard_enum_match_arm)]

mod assembly;
mod curves;
mod sentence;
mod unit;
mod writers;

pub use assembly::{
    Assembly, AssemblyError, AssemblyOptions, Form, Frame, FrameError, Side, Walk, Weld, is_straight,
    shortest_edge,
};
pub use curves::{CurveFile, CurveFileError, FileCurve, Kind, Shape, read_curves};
pub use sentence::{Sentence, Setting};
pub use unit::LengthUnit;
pub use writers::{
    Accuracy, Colours, DEFAULT_TOLERANCE, Format, Lengths, SplineError, StepForm, Subject, SurfaceFile,
    SurfaceForm, Unfit, diagonal, spline, write_curves, write_deformation,
};
