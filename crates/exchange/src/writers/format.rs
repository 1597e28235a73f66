use std::fmt;

/// Largest distance of a fitted surface from the patch where none is asked for, as a share of the size.
pub const DEFAULT_TOLERANCE: f64 = 1e-6;

/// A file format for surfaces.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Format {
    /// Wavefront OBJ.
    Obj,
    /// Stanford PLY with colours.
    Ply,
    /// STL.
    Stl,
    /// Binary glTF.
    Glb,
    /// VTK unstructured grid, for ParaView.
    Vtu,
    /// STEP AP214, the patch itself as one B-spline face.
    Step,
}

impl Format {
    /// Every format, in the order of the documentation.
    pub const ALL: [Self; 6] = [Self::Obj, Self::Ply, Self::Stl, Self::Glb, Self::Vtu, Self::Step];

    /// The format's name in experiment files, which is also its file extension.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Obj => "obj",
            Self::Ply => "ply",
            Self::Stl => "stl",
            Self::Glb => "glb",
            Self::Vtu => "vtu",
            Self::Step => "step",
        }
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
