//! The renderer's thread: it owns the session, does what it is asked between batches, and hands light to the screen. While
//! something moves it draws small pictures, so that many of them fit into a second.

use crate::desk::{Event, Inbox};
use crate::error::Result;
use crate::hub::CameraText;
use crate::opening;
use crate::saver::Saver;
use crate::saving;
use crate::screen::{Frame, Light, Screen};
use crate::wire::{Kind, Look};
use glam::Vec3;
use lampyris::backend::Settings;
use lampyris::cpu::Cpu;
use lampyris::document::{self, Document};
use lampyris::scene::{Camera, Edit, Scene, View, find_view, upward};
use lampyris::session::Session;
use lampyris::world::World;
use serde_json::Value;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Condvar, Mutex, MutexGuard, PoisonError};
use std::time::{Duration, Instant};

/// Light groups that lamps are sorted into when a scene opens.
pub(crate) const GROUPS: usize = 16;

/// Batches after which a picture is finished.
const ENOUGH: u32 = 256;

/// How long nothing must move before the picture is drawn in its full size.
const REST: Duration = Duration::from_millis(160);

/// What a frame shall take while something moves [s], and the least share of the full edges it may have then.
const QUICK: f32 = 0.07;
const SMALLEST: f32 = 0.25;

/// Relative error at which a picture is good.
pub(crate) const GOOD: f32 = 0.02;

/// A scene to open, and how.
pub struct Opened {
    /// The scene, and what was edited in it before.
    pub document: document::Opened,
    /// From where to look, if the arguments say so.
    pub camera: Option<Camera>,
}

/// What is to be done, until it is.
#[derive(Default)]
struct Work {
    /// From where to look, the number of that camera, and the message that asked.
    camera: Option<(Look, u32, u32)>,
    size: Option<[u32; 2]>,
    /// Edits in order; of those of one thing that follow each other only the last.
    edits: Vec<(Edit, u32)>,
    questions: Vec<Asked>,
    /// What the desk wants to be kept with the edits, and the name of the version, if it is to have one.
    save: Option<(Value, Option<String>)>,
    ended: bool,
}

/// A question about a frame that was shown.
pub(crate) struct Asked {
    pub(crate) client: u64,
    pub(crate) id: u32,
    pub(crate) frame: Frame,
    pub(crate) at: [f32; 2],
}

/// What lies behind a pixel.
pub(crate) struct Found {
    pub(crate) point: Vec3,
    pub(crate) normal: Vec3,
    pub(crate) instance: u32,
    pub(crate) material: u32,
    pub(crate) emitter: Option<u32>,
}

/// How far a picture is.
#[derive(Clone, Debug)]
pub(crate) struct Progress {
    pub(crate) stage: &'static str,
    pub(crate) batches: u32,
    /// Half the relative 95 % interval of the mean.
    pub(crate) error: f32,
    pub(crate) good_in: Option<f32>,
    pub(crate) fps: f32,
    pub(crate) size: [u32; 2],
    pub(crate) layers: Vec<(u32, u32, bool)>,
}

/// The way to the thread.
pub(crate) struct Studio {
    work: Mutex<Work>,
    wake: Condvar,
    /// What is to be done makes the batch at hand pointless, or shall not wait for it.
    urgent: AtomicBool,
}

impl Studio {
    pub(crate) fn new() -> Studio {
        Studio { work: Mutex::default(), wake: Condvar::new(), urgent: AtomicBool::new(false) }
    }

    /// Looks from elsewhere.
    pub(crate) fn look(&self, look: Look, number: u32, seq: u32) {
        self.put(true, |work| work.camera = Some((look, number, seq)));
    }

    /// Draws in another size.
    pub(crate) fn resize(&self, size: [u32; 2]) {
        self.put(true, |work| work.size = Some(size));
    }

    /// Edits the scene.
    pub(crate) fn edit(&self, edits: Vec<Edit>, seq: u32) {
        let urgent = edits.iter().any(|edit| !matches!(edit, Edit::Mix { .. }));
        self.put(urgent, |work| {
            for edit in edits {
                match work.edits.last_mut().filter(|(last, _)| replaces(&edit, last)) {
                    Some(last) => *last = (edit, seq),
                    None => work.edits.push((edit, seq)),
                }
            }
        });
    }

    /// Asks what lies behind a pixel.
    pub(crate) fn ask(&self, asked: Asked) {
        self.put(true, |work| work.questions.push(asked));
    }

    pub(crate) fn end(&self) {
        self.put(true, |work| work.ended = true);
    }

    /// Writes the edits down, with what the desk wants to be kept; as a version of a name, if it has one.
    pub(crate) fn save(&self, desk: Value, name: Option<String>) {
        self.put(false, |work| work.save = Some((desk, name)));
    }

    fn put(&self, urgent: bool, put: impl FnOnce(&mut Work)) {
        let mut work = self.work();
        put(&mut work);
        if urgent {
            self.urgent.store(true, Ordering::Relaxed);
        }
        self.wake.notify_one();
    }

    fn work(&self) -> MutexGuard<'_, Work> {
        self.work.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// What there is to do; waits for it until a time, for ever where there is none.
    fn take(&self, until: Option<Instant>) -> Work {
        let mut work = self.work();
        let idle = |work: &Work| {
            !work.ended
                && work.camera.is_none()
                && work.size.is_none()
                && work.edits.is_empty()
                && work.questions.is_empty()
                && work.save.is_none()
        };
        while idle(&work) {
            work = match until.map(|until| until.saturating_duration_since(Instant::now())) {
                Some(Duration::ZERO) => break,
                Some(left) => self.wake.wait_timeout(work, left).unwrap_or_else(PoisonError::into_inner).0,
                None => self.wake.wait(work).unwrap_or_else(PoisonError::into_inner),
            };
        }
        self.urgent.store(false, Ordering::Relaxed);
        std::mem::take(&mut work)
    }
}

/// Whether an edit makes the one before it pointless.
fn replaces(edit: &Edit, last: &Edit) -> bool {
    match (edit, last) {
        (Edit::Light { light: a, .. }, Edit::Light { light: b, .. }) => a == b,
        (Edit::Move { instance: a, .. }, Edit::Move { instance: b, .. }) => a == b,
        (Edit::Material { material: a, .. }, Edit::Material { material: b, .. }) => a == b,
        (Edit::Mix { group: a, .. }, Edit::Mix { group: b, .. }) => a == b,
        _ => false,
    }
}

/// The session with all that is known of its picture.
struct Stage {
    session: Session,
    /// The scene as its file has it, without its geometry.
    before: Scene,
    document: Document,
    saver: Saver,
    look: Arc<Look>,
    camera: Arc<CameraText>,
    /// What was asked for, and what is drawn now.
    size: [u32; 2],
    drawn: [u32; 2],
    /// The last message that asked for rays and was followed.
    seq: u32,
    /// When something moved last.
    moved: Option<Instant>,
    /// What a pixel takes in a batch [s].
    pixel: f32,
    shown: Instant,
}

/// Opens a scene and renders it until the end.
pub(crate) fn run(
    studio: &Studio,
    opened: Opened,
    size: [u32; 2],
    threads: Option<usize>,
    screen: &Screen,
    inbox: &Inbox,
) -> Result<()> {
    let settings = Settings::interactive();
    let Opened { document, camera } = opened;
    let document::Opened { scene, before, document: own, warnings, .. } = &document;
    let cpu = Cpu::new(threads)?;
    let mut world = cpu.install(|| World::new(scene.clone()));
    cpu.install(|| world.separate(own.layers.map_or(GROUPS, |layers| layers as usize)))?;
    let aspect = size[0] as f32 / size[1] as f32;
    let found = || find_view(scene, &|ray| world.tracer().closest(ray), aspect).camera;
    let first = || scene.view.clone().or_else(|| scene.cameras.first().cloned());
    let camera = camera.or_else(first).unwrap_or_else(|| cpu.install(found));
    let look = Arc::new(Look::from(&camera));
    world.apply(&Edit::View { camera: Some(camera) })?;
    let mut model = opening::open(&world);
    let lost = saving::restore(&mut model, &own.desk);
    let bare = bare(world.scene());
    let session = Session::begin(cpu, world, size, &settings)?;
    let warnings =
        warnings.iter().cloned().chain(lost.into_iter().map(|lost| format!("not found any more: {lost}")));
    inbox.put(Event::Opened {
        model: Box::new(model),
        scene: Box::new(bare),
        look: (*look).clone(),
        warnings: warnings.collect(),
    });
    let before = before.clone();
    let own = own.clone();
    let saver = Saver::start(document, inbox.clone())?;
    let mut stage = Stage {
        session,
        before,
        document: own,
        saver,
        camera: Arc::new(camera_text(&look, 0)),
        look,
        size,
        drawn: size,
        seq: 0,
        moved: None,
        pixel: 0.0,
        shown: Instant::now(),
    };
    stage.work(studio, screen, inbox)
}

/// A scene without its geometry: what edits are tried on.
fn bare(scene: &Scene) -> Scene {
    let meshes = scene.meshes.iter().map(|mesh| lampyris::scene::Mesh {
        materials: mesh.materials.first().copied().into_iter().collect(),
        ..Default::default()
    });
    Scene { meshes: meshes.collect(), images: Vec::new(), up: Some(upward(scene)), ..scene.clone() }
}

pub(crate) fn camera_text(look: &Look, number: u32) -> CameraText {
    let mut text = serde_json::to_value(look).unwrap_or_default();
    (text["is"], text["number"]) = ("camera".into(), number.into());
    CameraText { number, text: text.to_string() }
}

impl Stage {
    fn work(&mut self, studio: &Studio, screen: &Screen, inbox: &Inbox) -> Result<()> {
        loop {
            let work = studio.take(self.wait());
            if work.ended {
                return Ok(());
            }
            self.follow(work, inbox)?;
            let moving = self.moved.is_some_and(|at| at.elapsed() < REST);
            if !moving && self.moved.take().is_some() && self.drawn != self.size {
                self.draw_in(self.size)?;
            }
            let batches = self.session.frame()?.batches();
            if batches >= ENOUGH || (moving && batches >= 2) {
                continue;
            }
            let begun = Instant::now();
            if !self.session.step_while(&|| !studio.urgent.load(Ordering::Relaxed))? {
                continue;
            }
            let seconds = begun.elapsed().as_secs_f32();
            let pixels = (self.drawn[0] * self.drawn[1]) as f32;
            self.pixel =
                if self.pixel == 0.0 { seconds / pixels } else { 0.7 * self.pixel + 0.3 * seconds / pixels };
            self.show(moving, seconds, screen, inbox)?;
        }
    }

    /// Until when nothing is to be done: not at all while there are batches to add.
    fn wait(&mut self) -> Option<Instant> {
        let batches = self.session.frame().map_or(0, |frame| frame.batches());
        match self.moved {
            Some(at) if batches >= 2 => Some(at + REST),
            _ if batches >= ENOUGH => None,
            _ => Some(Instant::now()),
        }
    }

    /// Does what was asked.
    fn follow(&mut self, work: Work, inbox: &Inbox) -> Result<()> {
        for (edit, seq) in work.edits {
            let changes = match self.session.edit(&edit) {
                Ok(changes) => changes,
                Err(error) => {
                    inbox.put(Event::Refused { why: error.to_string() });
                    continue;
                }
            };
            if changes.restarts_all() || !changes.groups.is_empty() {
                self.moved = Some(Instant::now());
            }
            self.seq = self.seq.max(seq);
        }
        let resized = work.size.is_some_and(|size| size != self.size);
        self.size = work.size.unwrap_or(self.size);
        if let Some((look, number, seq)) = work.camera {
            self.seq = self.seq.max(seq);
            self.camera = Arc::new(camera_text(&look, number));
            self.session.edit(&Edit::View { camera: Some(look.camera()) })?;
            self.look = Arc::new(look);
            self.moved = Some(Instant::now());
            self.draw_in(self.small())?;
        } else if resized {
            self.draw_in(self.size)?;
        }
        self.session.forget();
        if let Some((desk, name)) = work.save {
            let mut document = Document::of(&self.before, self.session.scene()?);
            document.scene = self.document.scene.clone();
            (document.layers, document.desk) = (Some(GROUPS as u32), desk);
            self.saver.save(document, name);
        }
        for asked in work.questions {
            let found = self.find(&asked);
            inbox.put(Event::Found { client: asked.client, id: asked.id, found });
        }
        Ok(())
    }

    /// As large as a picture can be that is drawn quickly.
    fn small(&self) -> [u32; 2] {
        let pixels = (self.size[0] * self.size[1]) as f32;
        let edge = (QUICK / (self.pixel * pixels).max(1e-6)).sqrt().clamp(SMALLEST, 1.0);
        // Few sizes, so that pictures do not jump.
        let edge = if edge >= 1.0 { 1.0 } else { (edge * 8.0).floor() / 8.0 };
        self.size.map(|n| ((n as f32 * edge.max(SMALLEST)) as u32).max(crate::wire::LEAST))
    }

    fn draw_in(&mut self, size: [u32; 2]) -> Result<()> {
        if size != self.drawn {
            self.drawn = size;
            self.session.resize(size)?;
        }
        Ok(())
    }

    fn show(&mut self, moving: bool, seconds: f32, screen: &Screen, inbox: &Inbox) -> Result<()> {
        let size = self.drawn;
        let frame = self.session.frame()?;
        let batches = frame.batches();
        let done = batches >= ENOUGH;
        // A picture that hardly changes is not sent for each batch.
        if batches > 8 && !done && self.shown.elapsed() < Duration::from_millis(400) {
            return Ok(());
        }
        let error = frame.relative_error() * frame.student_factor();
        let kind = match (moving || size != self.size, done) {
            (true, _) => Kind::Moving,
            (_, true) => Kind::Final,
            _ => Kind::Settled,
        };
        let stage = match kind {
            Kind::Moving => "moving",
            Kind::Final => "done",
            Kind::Settled if error <= GOOD => "good",
            Kind::Settled => "refining",
        };
        // The error falls as one over the root of the batches, or faster.
        let more = batches as f32 * ((error / GOOD).powi(2) - 1.0);
        let good_in = (error.is_finite() && error > GOOD).then_some(more * seconds);
        let layers = frame.progress().iter().map(|p| (p.batches, p.of, p.held)).collect();
        let progress =
            Progress { stage, batches, error, good_in, fps: 1.0 / seconds.max(1e-3), size, layers };
        screen.light(Light {
            size,
            still: Some(Arc::new(frame.still())),
            camera: self.camera.clone(),
            look: Some(self.look.clone()),
            batches,
            error,
            kind: Some(kind),
            seq: self.seq,
            seconds,
        });
        self.shown = Instant::now();
        inbox.put(Event::Progress(progress));
        Ok(())
    }

    fn find(&self, asked: &Asked) -> Option<Found> {
        let world = self.session.world().ok()?;
        let [width, height] = asked.frame.size;
        let view = View::new(&asked.frame.look.camera(), width, height);
        let ray = view.ray(asked.at[0], asked.at[1]);
        let surface = world.closest(&ray)?;
        Some(Found {
            point: surface.position,
            normal: surface.normal,
            instance: surface.instance,
            material: surface.material,
            emitter: world.emitter_of(&surface),
        })
    }
}
