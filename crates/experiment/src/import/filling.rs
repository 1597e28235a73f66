//! From curves of files to the surface over them.

use exchange::{Assembly, CurveFile, CurveFileError, Frame, LengthUnit, Sentence, Shape, Side};
use plateau::{Fill, Film, MethodError, Progress};
use show::RimSource;

use super::{ImportError, ImportOptions, checked, control, limits, printed};

/// The curves of one or several files as one boundary, ready to be filled.
#[derive(Debug, Clone)]
pub struct Filling {
    assembly: Assembly,
    frame: Frame,
    options: ImportOptions,
    /// What the files say of themselves.
    told: Vec<Sentence>,
    notes: Vec<Sentence>,
    unit: Option<LengthUnit>,
}

impl Filling {
    /// Assembles the curves of all files together: a rim may stand in one, a hole in another. Polylines are samples, to be met within the
    /// tolerance of the options, or control points: if the options say so, or if they have the names of all sides of an experiment
    /// (`u0`, `u1`, `v0`, `v1` or `ab`, `bc`, `ca`) and no degree is asked for, as [`import`](super::import()) has it.
    ///
    /// # Errors
    /// [`ImportError`]; no file is named in it.
    pub fn new(files: Vec<CurveFile>, options: &ImportOptions) -> Result<Self, ImportError> {
        options.check()?;
        let mut files = files.into_iter();
        let none = || CurveFileError::File("there is no file of curves".into());
        let file = files.next().ok_or_else(none)?;
        let file = files.try_fold(file, CurveFile::with)?;
        let (file, note) = control::taken(file, options)?;
        let assembly = Assembly::new(&file, &options.assembly)?;
        limits::check(&assembly)?;
        let frame = assembly.frame(options.rim_tolerance(&assembly))?;
        let notes = note.map(Sentence::from).into_iter().chain(assembly.notes.iter().cloned()).collect();
        Ok(Self { assembly, frame, options: options.clone(), told: file.notes, notes, unit: file.unit })
    }

    /// Sentences a user should see on how the curves became one boundary; what the files say of themselves is not among them.
    pub fn notes(&self) -> &[Sentence] {
        &self.notes
    }

    /// What the numbers of the files are, where one says so.
    pub fn unit(&self) -> Option<LengthUnit> {
        self.unit
    }

    /// The same with numbers of this unit, whatever the files say.
    #[must_use]
    pub fn with_unit(self, unit: LengthUnit) -> Self {
        Self { unit: Some(unit), ..self }
    }

    pub(super) fn assembly(&self) -> &Assembly {
        &self.assembly
    }

    pub(super) fn options(&self) -> &ImportOptions {
        &self.options
    }

    /// The surface over the boundary.
    ///
    /// # Errors
    /// As [`Fill::loops`].
    pub fn span(&self, fill: &Fill, progress: &dyn Progress) -> Result<Film, MethodError> {
        let fill = self.asked_of(fill);
        match &self.frame {
            Frame::Loops(loops) => fill.loops(loops, progress),
            Frame::Graph(graph) => fill.graph(graph, progress),
        }
    }

    /// A tolerance nearer than the usual one is asked of arcs and rational splines, too, not only of samples.
    fn asked_of(&self, fill: &Fill) -> Fill {
        let asked = self.options.tolerance.filter(|asked| *asked < Fill::RIM_TOLERANCE * self.assembly.size);
        asked.map_or(*fill, |asked| fill.with_rim_tolerance(asked))
    }

    /// What the curves were before they are filled.
    pub fn rim_source(&self) -> RimSource {
        let is_sampled = |side: &Side| matches!(&side.shape, Shape::Polyline(points) if points.len() > 2);
        let weld = self.assembly.weld;
        RimSource {
            sampled: self.assembly.sides.iter().any(is_sampled),
            welded: weld.count,
            moved: weld.largest,
        }
    }

    /// The experiment that does what `fill` does, but for the mesh: loops or faces over curves, sampled ones to be met within the
    /// tolerance.
    ///
    /// # Errors
    /// [`ImportError::Plan`].
    pub fn experiment(&self, title: &str, fill: &Fill) -> Result<String, ImportError> {
        let notes: Vec<String> = self.told.iter().chain(self.notes()).map(Sentence::to_string).collect();
        let text = printed::assembly(title, &self.assembly, &self.options, &self.asked_of(fill), &notes);
        checked(text + &printed::output(self.unit))
    }
}
