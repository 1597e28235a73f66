//! The formats of surfaces, one file each: one table of them.

mod glb;
mod obj;
mod ply;
mod stl;
mod vtu;

use std::fmt;

pub(super) use glb::{Motion, write as write_glb};

use plateau::Notation;

use super::subject::Export;
use crate::LengthUnit;

/// What a file says of the unit of its numbers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Lengths {
    /// Nothing.
    Unsaid,
    /// Their unit; where none is given, readers take them for millimetres.
    Named,
    /// They are metres, whatever they were before.
    Metres,
}

impl Lengths {
    /// What a program that reads such a file takes its numbers for, where that is not left open; `unit` is what they were.
    #[must_use]
    pub fn told(self, unit: LengthUnit) -> Option<String> {
        match (self, unit) {
            (Self::Named, unit) => Some(format!("its numbers are {}", unit.plural())),
            (Self::Metres, LengthUnit::Metre) => Some("in metres, as glTF is".into()),
            (Self::Metres, unit) => Some(format!(
                "in metres, as glTF is: 1 {} became {}",
                unit.name(),
                Notation::Short(12).of(unit.metres())
            )),
            (Self::Unsaid, _) => None,
        }
    }
}

/// What the files of a format hold.
#[derive(Clone, Copy)]
pub(super) enum Holds {
    /// A mesh, in the words of its writer.
    Mesh(&'static dyn Export),
    /// The surface itself, as Bézier cells.
    Cells,
    /// The surface itself, as faces of CAD programs.
    Faces,
}

/// The enum of formats, the list of them and their rows, from one line each: variant, name, ending of its files, meaning, what it says of
/// lengths, what it holds.
macro_rules! formats {
    ($($variant:ident = $name:literal, $ending:literal, $meaning:literal, $lengths:ident, $holds:expr;)*) => {
        /// A file format for surfaces.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
        pub enum Format {
            $(#[doc = $meaning] $variant,)*
        }

        impl Format {
            /// Every format, in the order of the documentation.
            pub const ALL: [Self; [$(Self::$variant),*].len()] = [$(Self::$variant),*];

            /// The format's name in experiment files.
            #[must_use]
            pub const fn name(self) -> &'static str {
                match self {
                    $(Self::$variant => $name,)*
                }
            }

            /// What names of its files end in, after a dot: its name, but for `vtu-bezier`, whose files are `bezier.vtu`, since
            /// programs know all VTU files by their extension.
            #[must_use]
            pub const fn ending(self) -> &'static str {
                match self {
                    $(Self::$variant => $ending,)*
                }
            }

            /// What a file of it says of the unit of its numbers.
            #[must_use]
            pub const fn lengths(self) -> Lengths {
                match self {
                    $(Self::$variant => Lengths::$lengths,)*
                }
            }

            /// What its files hold.
            pub(super) const fn holds(self) -> Holds {
                match self {
                    $(Self::$variant => $holds,)*
                }
            }
        }
    };
}

formats! {
    Obj = "obj", "obj", "Wavefront OBJ.", Unsaid, Holds::Mesh(&obj::Obj);
    Ply = "ply", "ply", "Stanford PLY with colours.", Unsaid, Holds::Mesh(&ply::Ply);
    Stl = "stl", "stl", "STL.", Unsaid, Holds::Mesh(&stl::Stl);
    Glb = "glb", "glb", "Binary glTF.", Metres, Holds::Mesh(&glb::Glb);
    Vtu = "vtu", "vtu", "VTK unstructured grid, for ParaView.", Unsaid, Holds::Mesh(&vtu::Vtu);
    VtuBezier = "vtu-bezier", "bezier.vtu", "VTK unstructured grid, the patches themselves as Bézier cells.", Unsaid, Holds::Cells;
    Step = "step", "step", "STEP AP214, the patch itself as one B-spline face.", Named, Holds::Faces;
}

impl Format {
    /// Whether its files hold a mesh of the surface, and not the surface itself.
    #[must_use]
    pub const fn holds_a_mesh(self) -> bool {
        match self.holds() {
            Holds::Mesh(_) => true,
            Holds::Cells | Holds::Faces => false,
        }
    }

    /// The format of a file by the end of its name, in letters of either kind; the longest ending counts: `roof.bezier.vtu` has Bézier
    /// cells. STEP files may end in `stp`.
    ///
    /// ```
    /// use exchange::Format;
    ///
    /// let of = Format::of_file;
    /// assert_eq!((of("roof.vtu"), of("Roof.Bezier.VTU")), (Some(Format::Vtu), Some(Format::VtuBezier)));
    /// assert_eq!((of("a.b.stp"), of("vtu"), of("x.bezier")), (Some(Format::Step), None, None));
    /// ```
    #[must_use]
    pub fn of_file(name: &str) -> Option<Self> {
        let name = name.to_ascii_lowercase();
        let ends_in = |ending: &str| name.strip_suffix(ending).is_some_and(|stem| stem.ends_with('.'));
        if ends_in("stp") {
            return Some(Self::Step);
        }
        Self::ALL
            .into_iter()
            .filter(|format| ends_in(format.ending()))
            .max_by_key(|format| format.ending().len())
    }

    /// The format of this name; `stp` is another for `step`.
    #[must_use]
    pub fn named(name: &str) -> Option<Self> {
        let name = name.to_ascii_lowercase();
        Self::ALL
            .into_iter()
            .find(|format| format.name() == name)
            .or_else(|| (name == "stp").then_some(Self::Step))
    }
}

impl fmt::Display for Format {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}
