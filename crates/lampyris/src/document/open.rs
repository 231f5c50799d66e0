//! Opening: a document, with the scene that it names, or a scene alone.

use super::{Digest, Document, Environment, Reading, outline, place, text};
use crate::color::Rgb;
use crate::error::{Error, Result};
use crate::import::files::Root;
use crate::import::{self, Loaded, Options};
use crate::scene::{Scene, upward};
use std::path::{Path, PathBuf};

/// How a scene's file is read; what is asked for here goes before what a document says.
#[derive(Clone, Debug, Default)]
pub struct Ask {
    /// Root and limits, and the facets around a circle where nobody says otherwise.
    pub options: Options,
    /// Facets around a full circle of curved shapes.
    pub circle: Option<u32>,
    /// The file of a picture around the scene, and the luminance of 1 in it [cd/m²].
    pub environment: Option<(PathBuf, f32)>,
}

/// What was opened.
#[derive(Clone, Debug, Default)]
pub struct Opened {
    /// The scene as it was edited, or as its file has it where that was opened alone.
    pub scene: Scene,
    /// The scene as its file has it, without meshes and pictures: what [`Document::of`] compares with.
    pub before: Scene,
    /// The document; one that says nothing where a scene was opened alone.
    pub document: Document,
    /// The scene's file.
    pub scene_file: PathBuf,
    /// The document's file, where one was opened.
    pub document_file: Option<PathBuf>,
    /// What surrounds the scene: its picture's file, and the luminance of 1 in it [cd/m²].
    pub environment: Option<(PathBuf, f32)>,
    /// What was odd about the files, and what of the edits was lost.
    pub warnings: Vec<String>,
    /// What of the edits had no place in the scene.
    pub lost: Vec<String>,
    /// Of the document's text.
    pub digest: Option<Digest>,
}

/// How many of the edits that were lost are told of among the warnings.
const TOLD: usize = 20;

/// True for a name that ends as a document's.
pub fn is_document(path: &Path) -> bool {
    path.file_name().is_some_and(|name| name.as_encoded_bytes().ends_with(place::SUFFIX.as_bytes()))
}

/// Opens a document and the scene that it names, edited; or a scene as it is, with a warning where edits lie beside it.
///
/// A document names files beside it. They are held to the rule of [`Options::root`], whose default here is the document's
/// folder. Only documents in the user's own folder for them (`state`, as [`super::state_folder`] says) name files anywhere.
///
/// # Errors
/// Those of [`Document::read`], of [`import::load`], and [`Error::CannotRead`] for names that lead out of the root.
pub fn open(path: &Path, ask: &Ask, state: Option<&Path>) -> Result<Opened> {
    let mut opened = if is_document(path) { edited(path, ask, state)? } else { alone(path, ask)? };
    let home = opened.document_file.clone().unwrap_or_else(|| super::beside(&opened.scene_file));
    let kept = state.and_then(|state| place::refuge(state, &home));
    let elsewhere = [Some(home), kept].into_iter().flatten();
    for file in elsewhere.filter(|file| opened.document_file.as_ref() != Some(file) && file.is_file()) {
        opened.warnings.push(format!("edits of it lie in {}: open that to see them", file.display()));
    }
    Ok(opened)
}

/// A scene as its file has it.
fn alone(path: &Path, ask: &Ask) -> Result<Opened> {
    let circle = ask.circle.unwrap_or(ask.options.circle_steps);
    let options = Options { circle_steps: circle, ..ask.options.clone() };
    let Loaded { mut scene, warnings } = import::load(path, &options)?;
    if let Some((file, scale)) = &ask.environment {
        surround(&mut scene, file, *scale, &options)?;
    }
    let document =
        Document { scene: Reading { circle: ask.circle, ..Reading::default() }, ..Document::default() };
    Ok(Opened {
        before: outline(&scene),
        scene,
        document,
        scene_file: path.into(),
        document_file: None,
        environment: ask.environment.clone(),
        warnings,
        lost: Vec::new(),
        digest: None,
    })
}

/// A scene as a document has it.
fn edited(path: &Path, ask: &Ask, state: Option<&Path>) -> Result<Opened> {
    let limits = &ask.options.limits;
    let (own, file) = Root::new(path, &Options { root: None, ..ask.options.clone() })?;
    text::within(path, std::fs::metadata(&file).map_or(0, |file| file.len()), limits)?;
    let text = own.read(&file)?;
    let document = Document::read(path, &text, limits)?;
    let trusted = state.is_some_and(|state| lies_in(path, state));
    let (root, from) = Root::new(path, &ask.options)
        .or_else(|e| if trusted { Root::new(path, &Options::default()) } else { Err(e) })?;
    let find = |name: &str| -> Result<PathBuf> {
        let named = Path::new(name);
        if trusted && named.is_absolute() {
            return Ok(named.into());
        }
        let refused = |reason| Error::CannotRead { file: path.into(), reason };
        root.resolve(&from, name).map_err(refused)?;
        // Under the name that it has, which may be in what it holds.
        Ok(path.parent().unwrap_or(Path::new("")).join(named))
    };
    let scene_file = find(&document.scene.file)?;
    if is_document(&scene_file) {
        let reason = "it names another document, not a scene".into();
        return Err(Error::CannotRead { file: path.into(), reason });
    }
    // What a scene in the document's folder may name is what the document may.
    let folder = if trusted { scene_file.parent() } else { path.parent() };
    let folder = folder.filter(|f| !f.as_os_str().is_empty()).unwrap_or(Path::new("."));
    let root = ask.options.root.clone().unwrap_or_else(|| folder.into());
    let environment = match (&ask.environment, &document.scene.environment) {
        (Some(asked), _) => Some(asked.clone()),
        (None, Some(Environment { file, scale })) => Some((find(file)?, *scale)),
        (None, None) => None,
    };
    let asked = Ask {
        options: Options { root: Some(root), ..ask.options.clone() },
        circle: ask.circle.or(document.scene.circle),
        environment,
    };
    let mut opened = alone(&scene_file, &asked)?;
    let (scene, lost) = document.apply(opened.scene);
    opened.warnings.extend(lost.iter().take(TOLD).map(|line| format!("an edit is left out: {line}")));
    if lost.len() > TOLD {
        opened.warnings.push(format!("{} more edits are left out", lost.len() - TOLD));
    }
    let digest = Some(Digest::new(&text));
    Ok(Opened { scene, document, document_file: Some(path.into()), lost, digest, ..opened })
}

/// Puts a picture around a scene.
fn surround(scene: &mut Scene, file: &Path, scale: f32, options: &Options) -> Result<()> {
    // A sky must know what is overhead, and not every format says.
    scene.up = Some(upward(scene));
    scene.environment = Rgb::grey(scale);
    scene.environment_image = Some(scene.images.len() as u32);
    scene.images.push(import::picture(file, options)?);
    Ok(())
}

/// True if a file lies in a folder itself, links followed.
fn lies_in(file: &Path, folder: &Path) -> bool {
    let (file, folder) = (file.canonicalize().ok(), folder.canonicalize().ok());
    file.as_deref().and_then(Path::parent).is_some_and(|parent| folder.as_deref() == Some(parent))
}
