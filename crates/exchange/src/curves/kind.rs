use super::CurveFileError;

/// The kinds of files whose curves are read.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Kind {
    /// Wavefront OBJ: lines `l` and free-form curves `curv`.
    Obj,
    /// A table of points: CSV and its relatives.
    Table,
    /// STEP, ISO 10303-21.
    Step,
    /// ASCII DXF.
    Dxf,
}

/// How files begin that hold no curves for us: bytes, what they are, what to do.
const BEGINNINGS: &[(&[u8], &str, Advice)] = &[
    (b"glTF", "a binary glTF file, a mesh", Advice::Mesh),
    (b"ply\n", "a PLY file, a mesh", Advice::Mesh),
    (b"ply\r", "a PLY file, a mesh", Advice::Mesh),
    (b"OFF", "an OFF file, a mesh", Advice::Mesh),
    (b"$MeshFormat", "a mesh of Gmsh", Advice::Mesh),
    (b"# vtk DataFile", "a VTK file, a mesh", Advice::Mesh),
    (b"\x89PNG", "a picture (PNG)", Advice::Picture),
    (b"\xFF\xD8\xFF", "a picture (JPEG)", Advice::Picture),
    (b"GIF8", "a picture (GIF)", Advice::Picture),
    (b"II*\0", "a picture (TIFF)", Advice::Picture),
    (b"MM\0*", "a picture (TIFF)", Advice::Picture),
    (b"RIFF", "a picture, sound or film (RIFF)", Advice::Picture),
    (b"BM", "a picture (BMP)", Advice::Picture),
    (b"%PDF", "a PDF document", Advice::Curves),
    (b"%!PS", "a PostScript document", Advice::Curves),
    (b"3D Geometry File Format", "a Rhino file (3dm)", Advice::Curves),
    (b"AutoCAD Binary DXF", "a binary DXF file", Advice::AsciiDxf),
    (b"AC10", "an AutoCAD drawing (DWG)", Advice::AsciiDxf),
    (b"BLENDER", "a Blender file", Advice::Curves),
    (b"DBRep_DrawableShape", "an OpenCASCADE shape (BREP)", Advice::Step),
    (b"CASCADE Topology", "an OpenCASCADE shape (BREP)", Advice::Step),
    (b"Open CASCADE Binary", "an OpenCASCADE shape (BREP)", Advice::Step),
    (b"\x89HDF", "an HDF5 file", Advice::Curves),
    (b"\xD0\xCF\x11\xE0", "a file of an old office or CAD program", Advice::Curves),
    (b"\x1F\x8B", "a compressed file (gzip)", Advice::Unpack),
    (b"7z\xBC\xAF", "a compressed file (7z)", Advice::Unpack),
    (b"\x7FELF", "a program", Advice::Curves),
    (b"SQLite format", "a database", Advice::Curves),
];

/// What to do with a file that is none of ours.
#[derive(Clone, Copy)]
enum Advice {
    Mesh,
    Picture,
    Curves,
    AsciiDxf,
    Step,
    Unpack,
    Globe,
}

impl Advice {
    const fn sentence(self) -> &'static str {
        match self {
            Self::Mesh => {
                "a mesh has no boundary curves of its own: export the curves of its rim as OBJ lines, CSV, STEP or DXF, then \
                 `plateau fill rim.obj -o surface.step`"
            }
            Self::Picture => {
                "points are needed: write them as a table x,y,z, then `plateau fill rim.csv -o surface.step`"
            }
            Self::Curves => {
                "export its curves as STEP, ASCII DXF, OBJ lines or a table x,y,z, then `plateau fill rim.step -o surface.step`"
            }
            Self::AsciiDxf => "save it as ASCII DXF, then `plateau fill rim.dxf -o surface.step`",
            Self::Step => "save it as STEP, then `plateau fill rim.step -o surface.step`",
            Self::Unpack => "unpack it first",
            Self::Globe => {
                "it holds degrees of longitude and latitude, as a rule, which are no lengths: project them to metres, as GIS programs do, and \
                 export DXF or a table x,y,z, then `plateau fill rim.csv -o surface.step`"
            }
        }
    }
}

impl Kind {
    /// What a file is: by its content, by its name where the content leaves it open.
    pub(super) fn of(bytes: &[u8], name: &str) -> Result<Self, CurveFileError> {
        let content = bytes.strip_prefix(&[0xEF, 0xBB, 0xBF]).unwrap_or(bytes);
        let content = &content[content.iter().take_while(|byte| byte.is_ascii_whitespace()).count()..];
        if let Some((what, advice)) = foreign(bytes, content) {
            return Err(CurveFileError::OtherKind { what: what.into(), advice: advice.into() });
        }
        if content.is_empty() {
            return Err(CurveFileError::File(
                "is empty: curves are read from OBJ, CSV, STEP and ASCII DXF files".into(),
            ));
        }
        let head = head(content);
        if content.starts_with(b"ISO-10303-21") {
            if head.contains("'IFC") || head.contains("=IFC") {
                let what = "an IFC file, a model of a building".into();
                return Err(CurveFileError::OtherKind { what, advice: Advice::Curves.sentence().into() });
            }
            return Ok(Self::Step);
        }
        if is_dxf(&head) {
            return Ok(Self::Dxf);
        }
        let extension = name.rsplit_once('.').map(|(_, end)| end.to_ascii_lowercase()).unwrap_or_default();
        match extension.as_str() {
            "obj" => Ok(Self::Obj),
            "dxf" => Ok(Self::Dxf),
            "step" | "stp" | "p21" => Ok(Self::Step),
            "csv" | "tsv" | "txt" | "dat" | "xyz" | "asc" | "tab" => Ok(Self::Table),
            _ if is_obj(&head) => Ok(Self::Obj),
            _ => Ok(Self::Table),
        }
    }
}

/// The beginning of a file as text.
fn head(content: &[u8]) -> String {
    String::from_utf8_lossy(&content[..content.len().min(65_536)]).into_owned()
}

fn is_dxf(head: &str) -> bool {
    let mut lines = head.lines().map(str::trim);
    // Comments, code 999, may stand before the first section.
    loop {
        match (lines.next(), lines.next()) {
            (Some("999"), Some(_)) => {}
            (Some("0"), Some(value)) => return value.eq_ignore_ascii_case("SECTION"),
            _ => return false,
        }
    }
}

fn is_obj(head: &str) -> bool {
    let words = ["v", "o", "g", "l", "cstype", "mtllib", "usemtl", "vn", "vt", "vp", "f", "deg"];
    let mut firsts = head.lines().map(str::trim).filter(|line| !line.is_empty() && !line.starts_with('#'));
    // The last line of the head may be torn, and a table may have a side v: a vertex is `v` and three numbers.
    firsts
        .clone()
        .take(50)
        .all(|line| line.split_whitespace().next().is_some_and(|word| words.contains(&word)))
        && firsts.any(|line| {
            line.starts_with("v ")
                && line.split_whitespace().skip(1).filter(|cell| cell.parse::<f64>().is_ok()).count() >= 3
        })
        && head.lines().any(|line| {
            matches!(line.split_whitespace().next(), Some("l" | "f" | "curv" | "cstype" | "vn" | "o" | "g"))
        })
}

/// What a file is that is not read, and what to do.
fn foreign(bytes: &[u8], content: &[u8]) -> Option<(&'static str, &'static str)> {
    if let Some((_, what, advice)) = BEGINNINGS.iter().find(|(start, _, _)| content.starts_with(start)) {
        // Two letters are little: a table may begin with a side BM.
        if *what != "a picture (BMP)" || content.contains(&0) {
            return Some((what, advice.sentence()));
        }
    }
    if content.starts_with(b"PK\x03\x04") {
        return Some(archive(content));
    }
    if bytes.len() >= 84
        && bytes.len() == 84 + 50 * u32::from_le_bytes([bytes[80], bytes[81], bytes[82], bytes[83]]) as usize
    {
        return Some(("an STL file, a mesh", Advice::Mesh.sentence()));
    }
    let head = head(content);
    let begins = |word: &str| head.get(..word.len()).is_some_and(|start| start.eq_ignore_ascii_case(word));
    if begins("solid") && (head.contains("facet") || head.contains("endsolid")) {
        return Some(("an STL file, a mesh", Advice::Mesh.sentence()));
    }
    if begins("<") {
        return Some(markup(&head));
    }
    if begins("{") || begins("[{") {
        return Some(json(&head));
    }
    // The card image of IGES: a letter in column 73.
    if head.lines().next().is_some_and(|line| line.len() == 80 && line.as_bytes()[72] == b'S') {
        return Some(("an IGES file", Advice::Step.sentence()));
    }
    let is_key =
        |line: &str, key: &str| line.strip_prefix(key).is_some_and(|rest| rest.trim_start().starts_with('='));
    let is_experiment = head.lines().map(str::trim).any(|line| {
        [
            "[boundary]",
            "[[method]]",
            "[[curve]]",
            "[curve]",
            "[helicoid]",
            "[trapezium-helicoid]",
            "[net]",
            "[search]",
        ]
        .contains(&line)
            || is_key(line, "title")
    });
    is_experiment.then_some((
        "an experiment of plateau (TOML)",
        "`plateau run` computes it; curves are read from OBJ, CSV, STEP and ASCII DXF files",
    ))
}

fn archive(content: &[u8]) -> (&'static str, &'static str) {
    let head = String::from_utf8_lossy(content);
    if head.contains("xl/workbook") {
        ("an Excel workbook", "save the sheet as CSV, then `plateau fill rim.csv -o surface.step`")
    } else if head.contains("3D/3dmodel") {
        ("a 3MF file, a mesh", Advice::Mesh.sentence())
    } else if head.contains("Document.xml") {
        ("a FreeCAD document", Advice::Step.sentence())
    } else if head.contains("opendocument.spreadsheet") {
        ("a spreadsheet (ODS)", "save the sheet as CSV, then `plateau fill rim.csv -o surface.step`")
    } else {
        ("an archive (zip)", Advice::Unpack.sentence())
    }
}

fn markup(head: &str) -> (&'static str, &'static str) {
    for (word, what, advice) in [
        ("<VTKFile", "a VTK file, a mesh", Advice::Mesh),
        ("<svg", "a drawing (SVG)", Advice::Curves),
        ("<COLLADA", "a COLLADA file, a mesh", Advice::Mesh),
        ("<X3D", "an X3D file, a mesh", Advice::Mesh),
        ("<kml", "a KML file", Advice::Globe),
        ("<gpx", "a GPX file", Advice::Globe),
        ("<gml", "a GML file", Advice::Globe),
        ("<html", "a web page", Advice::Curves),
    ] {
        if head.contains(word) {
            return (what, advice.sentence());
        }
    }
    ("an XML file", Advice::Curves.sentence())
}

fn json(head: &str) -> (&'static str, &'static str) {
    if head.contains("plateau-result") {
        ("a result of plateau", "`plateau export` writes its surfaces, `plateau verify` computes it again")
    } else if head.contains("\"FeatureCollection\"") || head.contains("\"coordinates\"") {
        ("a GeoJSON file", Advice::Globe.sentence())
    } else if head.contains("\"asset\"") {
        ("a glTF file, a mesh", Advice::Mesh.sentence())
    } else {
        ("a JSON file", "write the points as a table x,y,z, then `plateau fill rim.csv -o surface.step`")
    }
}
