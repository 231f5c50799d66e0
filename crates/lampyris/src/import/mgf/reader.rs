//! The machine that reads MGF: a stack of open files, a stack of transforms, and the limits on both.
//! An array is a transform whose block is read again for each instance, as the reference implementation does it, so
//! that what the block redefines is redefined each time. No recursion: the depth of a scene is data.

use super::args::Reason;
use super::contexts::Contexts;
use super::material::Surface;
use super::shapes::Vertex;
use super::sink::Sink;
use super::transform::Transform;
use crate::chromaticity::Chromaticity;
use crate::error::{Error, Result};
use crate::import::files::Root;
use crate::import::lines::{LINE_BYTES, Place, TooLong, next_line, words};
use crate::import::name::NAME_BYTES;
use crate::import::report::{Report, quote};
use crate::import::{Loaded, Options};
use glam::DAffine3;
use std::collections::HashMap;
use std::path::{Path, PathBuf};
use std::rc::Rc;

/// What is long costs as much as many, so that repetitions of it are bounded all the same: beside its line, an entity
/// counts once for each so many bytes.
const BYTES_PER_ENTITY: usize = 256;

/// Longest line the format's specification allows [bytes].
const STRICT_LINE_BYTES: usize = 4096;

/// A file being read.
struct OpenFile {
    path: Rc<PathBuf>,
    bytes: Rc<[u8]>,
    place: Place,
    /// Transforms and objects open when it began.
    levels: usize,
    objects: usize,
    /// Whether the transform below belongs to its inclusion and ends with it.
    placed: bool,
}

/// An open transform.
struct Level {
    transform: Transform,
    instance: u64,
    /// What encloses it.
    outer: DAffine3,
    /// It and what encloses it.
    total: DAffine3,
    /// Product of all array sizes up to here.
    product: u64,
    /// Where its block begins.
    block: Place,
}

/// The reader of one scene.
pub(super) struct Reader<'o> {
    pub(super) options: &'o Options,
    root: Root,
    /// Files already read, and where names in them led: arrays may include the same file again and again.
    cache: HashMap<Rc<PathBuf>, Rc<[u8]>>,
    resolved: HashMap<(Rc<PathBuf>, String), Rc<PathBuf>>,
    files: Vec<OpenFile>,
    levels: Vec<Level>,
    /// Number of the line being read.
    line: u64,
    entities: u64,
    pub(super) vertices: Contexts<Vertex>,
    pub(super) colors: Contexts<Chromaticity>,
    pub(super) surfaces: Contexts<Surface>,
    /// The current material in the scene, until an edit or another choice.
    pub(super) material: Option<u32>,
    pub(super) sink: Sink,
    report: Report,
    /// The scene's file, for messages while none is open.
    main: Rc<PathBuf>,
    folder: PathBuf,
}

/// Why an entity could not be carried out.
pub(super) enum Fault {
    /// The file is wrong at the current line.
    Bad(String),
    /// Something else, with its own place.
    Other(Error),
}

impl From<String> for Fault {
    fn from(reason: String) -> Fault {
        Fault::Bad(reason)
    }
}

impl From<Error> for Fault {
    fn from(error: Error) -> Fault {
        Fault::Other(error)
    }
}

impl<'o> Reader<'o> {
    /// A reader about to read the first line of `scene`.
    pub(super) fn new(scene: &Path, options: &'o Options) -> Result<Reader<'o>> {
        let (root, file) = Root::new(scene, options)?;
        let stem = scene.file_stem().unwrap_or_default().to_string_lossy();
        let folder = file.parent().unwrap_or(Path::new("")).to_path_buf();
        let mut reader = Reader {
            options,
            root,
            cache: HashMap::new(),
            resolved: HashMap::new(),
            files: Vec::new(),
            levels: Vec::new(),
            line: 0,
            entities: 0,
            vertices: Contexts::new("v"),
            colors: Contexts::new("c"),
            surfaces: Contexts::new("m"),
            material: None,
            sink: Sink::new(&stem),
            report: Report::default(),
            main: Rc::new(scene.to_path_buf()),
            folder,
        };
        reader.open(Rc::new(file), false)?;
        Ok(reader)
    }

    /// Reads everything.
    pub(super) fn run(mut self) -> Result<Loaded> {
        while let Some(file) = self.files.last_mut() {
            let bytes = file.bytes.clone();
            let before = file.place.offset;
            let line = next_line(&bytes, &mut file.place, LINE_BYTES);
            let consumed = file.place.offset - before;
            match line {
                Err(TooLong(number)) => {
                    self.line = number;
                    return Err(self.bad(format!("the line has more than {LINE_BYTES} bytes; break it up")));
                }
                Ok(None) => self.end_of_file(consumed)?,
                Ok(Some(line)) => {
                    self.line = line.number;
                    self.charge(1 + (consumed / BYTES_PER_ENTITY) as u64)?;
                    if line.text.len() > STRICT_LINE_BYTES {
                        self.warn("a line longer than the 4096 characters that the format allows");
                    }
                    let words: Vec<&str> = words(&line.text).collect();
                    match self.entity(words[0], &words[1..]) {
                        Ok(()) => {}
                        Err(Fault::Bad(reason)) => return Err(self.bad(reason)),
                        Err(Fault::Other(error)) => return Err(error),
                    }
                }
            }
        }
        let scene = self.sink.finish(self.surfaces.named());
        Ok(Loaded { scene, warnings: self.report.into_lines() })
    }

    /// Notes something odd at the current line.
    pub(super) fn warn(&mut self, kind: &str) {
        let (file, line) = (self.shown(), self.line);
        self.report.warn(kind, || format!("{}:{line}", file.display()));
    }

    /// The transform in force.
    pub(super) fn place(&self) -> DAffine3 {
        self.levels.last().map_or(DAffine3::IDENTITY, |level| level.total)
    }

    /// Fails if `more` triangles are too many.
    pub(super) fn room_for(&self, more: u64) -> Result<()> {
        let (total, limit) = (self.sink.triangles + more, self.options.limits.triangles);
        if total <= limit {
            Ok(())
        } else {
            Err(self.over(format!("{total} triangles"), limit, "--max-triangles"))
        }
    }

    /// A limit exceeded at the current line.
    pub(super) fn over(&self, what: String, limit: u64, option: &'static str) -> Error {
        Error::OverLimit { file: self.shown(), place: format!("line {}", self.line), what, limit, option }
    }

    /// Counts entities, or work that costs as much.
    pub(super) fn charge(&mut self, count: u64) -> Result<()> {
        self.entities += count;
        let limit = self.options.limits.entities;
        if self.entities <= limit {
            return Ok(());
        }
        Err(self.over(format!("{} entities, repetitions counted,", self.entities), limit, "--max-entities"))
    }

    /// `xf` with words: a transform begins.
    pub(super) fn push_transform(&mut self, words: &[&str]) -> std::result::Result<(), Fault> {
        let transform = Transform::parse(words)?;
        let outer = self.place();
        let limit = self.options.limits.array;
        let product = self.levels.last().map_or(1, |l| l.product).saturating_mul(transform.instances());
        if product > limit {
            return Err(self.over(format!("an array of {product} instances"), limit, "--max-array").into());
        }
        let block = self.files.last().map_or(Place::default(), |f| f.place);
        let total = composed(outer, &transform, 0)?;
        self.levels.push(Level { transform, instance: 0, outer, total, product, block });
        Ok(())
    }

    /// `xf` alone: the innermost transform ends, or its block is read once more.
    pub(super) fn pop_transform(&mut self) -> Reason<()> {
        let Some(file) = self.files.last_mut() else { return Ok(()) };
        let first = file.levels + usize::from(file.placed);
        if self.levels.len() <= first {
            return Err("\"xf\" ends a transform, but none was begun in this file".into());
        }
        if let Some(block) = next_instance(&mut self.levels)? {
            file.place = block;
        }
        Ok(())
    }

    /// `o name`: an object begins.
    pub(super) fn open_object(&mut self, name: &str) {
        if self.sink.open(name) {
            self.warn(&format!("nested object names cut to {NAME_BYTES} bytes"));
        }
    }

    /// `o` alone: the innermost object ends.
    pub(super) fn close_object(&mut self) -> Reason<()> {
        if self.files.last().is_none_or(|file| self.sink.depth() <= file.objects) {
            return Err("\"o\" ends an object, but none was begun in this file".into());
        }
        self.sink.close();
        Ok(())
    }

    /// `i`: another file's lines come next, placed by a transform if `words` has one.
    pub(super) fn include(&mut self, name: &str, words: &[&str]) -> std::result::Result<(), Fault> {
        let (depth, limit) = (self.files.len() as u64, self.options.limits.include_depth);
        if depth > limit {
            return Err(self
                .over(format!("{depth} files within each other"), limit, "--max-include-depth")
                .into());
        }
        let from = self.files.last().map(|f| f.path.clone()).unwrap_or_default();
        let key = (from, name.to_string());
        let file = match self.resolved.get(&key) {
            Some(file) => file.clone(),
            None => {
                let file = Rc::new(self.root.resolve(&key.0, name)?);
                self.resolved.insert(key, file.clone());
                file
            }
        };
        if self.files.iter().any(|open| open.path == file) {
            return Err(format!("{} includes itself", quote(name)).into());
        }
        let placed = !words.is_empty();
        if placed {
            self.push_transform(words)?;
        }
        self.open(file, placed)?;
        Ok(())
    }

    fn open(&mut self, path: Rc<PathBuf>, placed: bool) -> Result<()> {
        let bytes = match self.cache.get(&path) {
            Some(bytes) => bytes.clone(),
            None => {
                let bytes: Rc<[u8]> = self.root.read(&path)?.into();
                self.cache.insert(path.clone(), bytes.clone());
                bytes
            }
        };
        let levels = self.levels.len() - usize::from(placed);
        let place = Place::default();
        if let Some(level) = self.levels.last_mut().filter(|_| placed) {
            level.block = place;
        }
        self.files.push(OpenFile { path, bytes, place, levels, objects: self.sink.depth(), placed });
        Ok(())
    }

    /// Ends what the file left open, then the file, or begins it again for the next instance.
    fn end_of_file(&mut self, consumed: usize) -> Result<()> {
        self.charge((consumed / BYTES_PER_ENTITY) as u64)?;
        let Some(file) = self.files.last_mut() else { return Ok(()) };
        self.line = file.place.line;
        if self.levels.len() > file.levels + usize::from(file.placed) {
            self.charge(1)?;
            self.warn("a transform is not ended by \"xf\" before the end of its file");
            return self.pop_transform().map_err(|reason| self.bad(reason));
        }
        if self.sink.depth() > file.objects {
            let open = file.objects;
            self.warn("an object is not ended by \"o\" before the end of its file");
            while self.sink.depth() > open {
                self.sink.close();
            }
        }
        if self.files.last().is_some_and(|file| file.placed) {
            self.charge(1)?;
            match next_instance(&mut self.levels) {
                Err(reason) => return Err(self.bad(reason)),
                Ok(Some(block)) => {
                    if let Some(file) = self.files.last_mut() {
                        file.place = block;
                    }
                    return Ok(());
                }
                Ok(None) => {}
            }
        }
        self.files.pop();
        Ok(())
    }

    fn bad(&self, reason: String) -> Error {
        Error::BadInput { file: self.shown(), place: format!("line {}", self.line), reason }
    }

    /// The current file as messages name it: the scene's by the name it was asked for, others relative to it.
    fn shown(&self) -> PathBuf {
        let beside = self.main.parent().unwrap_or(Path::new(""));
        match self.files.last() {
            Some(file) if self.files.len() > 1 => match file.path.strip_prefix(&self.folder) {
                Ok(relative) => beside.join(relative),
                Err(_) => file.path.to_path_buf(),
            },
            _ => self.main.to_path_buf(),
        }
    }
}

/// The next instance of the innermost transform, with the place where its block begins; or its end.
fn next_instance(levels: &mut Vec<Level>) -> Reason<Option<Place>> {
    let Some(level) = levels.last_mut() else { return Ok(None) };
    level.instance += 1;
    if level.instance < level.transform.instances() {
        level.total = composed(level.outer, &level.transform, level.instance)?;
        return Ok(Some(level.block));
    }
    levels.pop();
    Ok(None)
}

/// Inner transforms act first.
fn composed(outer: DAffine3, transform: &Transform, instance: u64) -> Reason<DAffine3> {
    let total = outer * transform.matrix(instance);
    let volume = total.matrix3.determinant().abs();
    let usable = total.is_finite() && volume > 0.0 && volume.is_finite();
    usable.then_some(total).ok_or_else(|| "the transform scales beyond all bounds".into())
}
