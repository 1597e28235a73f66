//! The formats of surfaces, one file each: one table of them.

mod glb;
mod obj;
mod ply;
mod stl;
mod vtu;

use std::fmt;

pub(super) use glb::{Motion, write as write_glb};

use super::subject::Export;

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

/// The enum of formats, the list of them and their rows, from one line each: variant, name, meaning, what it says of lengths, writer of meshes.
macro_rules! formats {
    ($($variant:ident = $name:literal, $meaning:literal, $lengths:ident, $writer:expr;)*) => {
        /// A file format for surfaces.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
        pub enum Format {
            $(#[doc = $meaning] $variant,)*
        }

        impl Format {
            /// Every format, in the order of the documentation.
            pub const ALL: [Self; [$(Self::$variant),*].len()] = [$(Self::$variant),*];

            /// The format's name in experiment files, which is also its file extension.
            #[must_use]
            pub const fn name(self) -> &'static str {
                match self {
                    $(Self::$variant => $name,)*
                }
            }

            /// What a file of it says of the unit of its numbers.
            #[must_use]
            pub const fn lengths(self) -> Lengths {
                match self {
                    $(Self::$variant => Lengths::$lengths,)*
                }
            }

            /// The writer of its meshes; none if it holds the surface itself.
            pub(super) const fn of_meshes(self) -> Option<&'static dyn Export> {
                match self {
                    $(Self::$variant => $writer,)*
                }
            }
        }
    };
}

formats! {
    Obj = "obj", "Wavefront OBJ.", Unsaid, Some(&obj::Obj);
    Ply = "ply", "Stanford PLY with colours.", Unsaid, Some(&ply::Ply);
    Stl = "stl", "STL.", Unsaid, Some(&stl::Stl);
    Glb = "glb", "Binary glTF.", Metres, Some(&glb::Glb);
    Vtu = "vtu", "VTK unstructured grid, for ParaView.", Unsaid, Some(&vtu::Vtu);
    Step = "step", "STEP AP214, the patch itself as one B-spline face.", Named, None;
}

impl Format {
    /// Whether its files hold a mesh of the surface, and not the surface itself.
    #[must_use]
    pub const fn holds_a_mesh(self) -> bool {
        self.of_meshes().is_some()
    }

    /// The format of files with a given extension, in letters of either kind: its name, or `stp`.
    #[must_use]
    pub fn of_extension(extension: &str) -> Option<Self> {
        let extension = extension.to_ascii_lowercase();
        if extension == "stp" {
            return Some(Self::Step);
        }
        Self::ALL.into_iter().find(|format| format.name() == extension)
    }
}

impl fmt::Display for Format {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}
