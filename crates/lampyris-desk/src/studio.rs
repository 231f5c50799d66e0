//! The renderer's thread: it owns the session, does what it is asked between batches, and hands light to the screen. While
//! something moves it draws small pictures, so that many of them fit into a second.

mod asking;
mod beside;
mod work;

use beside::BEFORE_CLAMPED;
use work::Work;
pub(crate) use work::{Asked, Studio, Survey, What};

use crate::Options;
use crate::error::Result;
use crate::event::{Event, Inbox, Opened, Progress};
use crate::hub::CameraText;
use crate::opening;
use crate::saver::Saver;
use crate::saving;
use crate::screen::{Light, Screen};
use crate::surfaces;
use crate::wire::{Kind, Look};
use lampyris::Rgb;
use lampyris::backend::Settings;
use lampyris::cpu::Cpu;
use lampyris::document::{self, Document};
use lampyris::frame::Frame as Sums;
use lampyris::measuring::{Estimate, readable};
use lampyris::scene::{Camera, Edit, Mesh, Scene, find_view, upward};
use lampyris::session::Session;
use lampyris::world::World;
use serde_json::Value;
use std::f32::consts::PI;
use std::sync::Arc;
use std::sync::atomic::Ordering;
use std::time::{Duration, Instant};

/// Light groups that lamps are sorted into when a scene opens.
pub(crate) const GROUPS: usize = 16;

/// How long nothing must move before the picture is drawn in its full size.
const REST: Duration = Duration::from_millis(160);

/// Batches of a sketch, if nothing moves on meanwhile.
const SKETCHED: u32 = 4;

/// Batches of meters, and light paths of each.
const METERED: u32 = 64;
const METER_PATHS: u32 = 512;

/// The version of the edits that is kept when some find their place no more.
const BEFORE: &str = "before reload";

/// Batches that are drawn while nobody looks on.
const UNSEEN: u32 = 8;

/// Relative error at which what lights a point is known.
const ENOUGH_KNOWN: f32 = 0.01;

/// How often a picture is sent that hardly changes.
const SELDOM: Duration = Duration::from_millis(400);

/// Relative error at which a picture is good.
pub(crate) const GOOD: f32 = 0.02;

/// The session with all that is known of its picture.
struct Stage {
    session: Session,
    /// The scene as its file has it, without its geometry.
    before: Scene,
    document: Document,
    saver: Saver,
    look: Arc<Look>,
    /// The last camera that was no section: that one is kept.
    plain: Camera,
    camera: Arc<CameraText>,
    size: [u32; 2],
    /// The colours of the layers, as they are shown.
    colors: Vec<Rgb>,
    /// Size of the sketch, and the colours of its light groups where their light is summed together.
    sketch: [u32; 2],
    melted: Option<Vec<Rgb>>,
    /// Whether a sketch was shown last.
    sketched: bool,
    /// Beside the picture is no sketch, but what clamping takes.
    clamped: bool,
    /// Batches after which a picture is finished.
    enough: u32,
    /// The last message that asked for rays and was followed.
    seq: u32,
    /// When something moved last.
    moved: Option<Instant>,
    /// What a pixel of a sketch takes in a batch, of one in layers and of one without [s].
    pixel: [f32; 2],
    shown: Instant,
    /// What people want to know more of.
    pursued: Vec<Pursued>,
    /// What is told besides light.
    survey: Survey,
}

/// What lights a point, batch by batch.
struct Pursued {
    client: u64,
    id: u32,
    question: lampyris::cpu::Question,
}

/// Whose batch is next.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Turn {
    Sketch,
    Picture,
    Meters,
    Clamped,
    Question,
}

/// Opens a scene and renders it until the end; if its file changes meanwhile, with the edits made here.
pub(crate) fn run(
    studio: &Studio,
    mut opened: Opened,
    options: &Options,
    screen: &Screen,
    inbox: &Inbox,
) -> Result<()> {
    // Who saves needs no scene, and it may be large.
    let scene = std::mem::take(&mut opened.document.scene);
    let saver = Saver::start(opened.document.clone(), inbox.clone())?;
    let document = opened.document.document.clone();
    opened.document.scene = scene;
    let mut stage = Stage::open(opened, document, saver, options, inbox)?;
    // A sketch is there long before the first batch of the picture.
    stage.begin_to_move(true)?;
    while let Some((mut opened, desk)) = stage.work(studio, screen, inbox)? {
        let document = stage.document(desk)?;
        let (scene, lost) = document.apply(std::mem::take(&mut opened.document.scene));
        opened.document.scene = scene;
        // A file that is being written may lack what comes back with the next reading.
        if !lost.is_empty() {
            stage.saver.save(document.clone(), Some(BEFORE.into()));
        }
        opened.document.warnings.extend(lost.iter().map(|lost| format!("an edit is left out: {lost}")));
        opened.camera = Some(stage.look.camera());
        let Stage { saver, size, camera, look, plain, .. } = stage;
        let options = Options { size, ..options.clone() };
        stage = Stage::open(opened, document, saver, &options, inbox)?;
        stage.session.cut(look.near)?;
        (stage.camera, stage.look, stage.plain) = (camera, look, plain);
        inbox.put(Event::Reloaded { lost });
    }
    Ok(())
}

/// A scene without its geometry: what edits are tried on.
pub(crate) fn bare(scene: &Scene) -> Scene {
    let meshes = vec![Mesh::default(); scene.meshes.len()];
    Scene { meshes, up: Some(upward(scene)), ..document::outline(scene) }
}

pub(crate) fn camera_text(look: &Look, number: u32) -> CameraText {
    let mut text = serde_json::to_value(look).unwrap_or_default();
    (text["is"], text["number"]) = ("camera".into(), number.into());
    CameraText { number, text: text.to_string().into() }
}

/// How light at points is estimated.
fn meter_settings() -> Settings {
    Settings { paths: METER_PATHS, passes: Some(METER_PATHS / 16), ..Settings::default() }
}

/// How a picture is estimated; with what its surfaces reflect, where that is wanted: then batches that are given up are lost.
fn picture_settings(survey: bool) -> Settings {
    Settings { auxiliary: survey, ..Settings::interactive() }
}

impl Stage {
    /// A scene as it was edited; `own` says so, and what the desk keeps with it.
    fn open(opened: Opened, own: Document, saver: Saver, options: &Options, inbox: &Inbox) -> Result<Stage> {
        let Options { size, threads, batches, .. } = *options;
        let Opened { mut document, camera } = opened;
        let cpu = Cpu::new(threads)?;
        let scene = std::mem::take(&mut document.scene);
        let mut world = cpu.install(|| World::new(scene));
        cpu.install(|| world.separate(own.layers.map_or(GROUPS, |layers| layers as usize)))?;
        let scene = world.scene();
        let aspect = size[0] as f32 / size[1] as f32;
        let found = || find_view(scene, &|ray| world.tracer().closest(ray), aspect).camera;
        let first = || scene.view.clone().or_else(|| scene.cameras.first().cloned());
        let camera = camera.or_else(first).unwrap_or_else(|| cpu.install(found));
        let look = Arc::new(Look::from(&camera));
        world.apply(&Edit::View { camera: Some(camera.clone()) })?;
        let mut model = opening::open(&world);
        let lost = saving::restore(&mut model, &own.desk);
        let lost = lost.into_iter().map(|lost| format!("not found any more: {lost}"));
        let warnings = document.warnings.into_iter().chain(lost).collect();
        let scene = Box::new(bare(world.scene()));
        let colors = world.mix();
        let session = Session::begin(cpu, world, size, &picture_settings(false))?;
        inbox.put(Event::Opened { model: Box::new(model), scene, look: (*look).clone(), warnings });
        Ok(Stage {
            session,
            before: document.before,
            document: own,
            saver,
            camera: Arc::new(camera_text(&look, 0)),
            look,
            plain: camera,
            size,
            colors,
            sketch: [0; 2],
            melted: None,
            sketched: false,
            clamped: false,
            enough: batches,
            seq: 0,
            moved: None,
            pixel: [0.0; 2],
            shown: Instant::now(),
            pursued: Vec::new(),
            survey: Survey::default(),
        })
    }

    /// What was edited, with what the desk keeps.
    fn document(&self, desk: Value) -> Result<Document> {
        let scene = Scene { view: Some(self.plain.clone()), ..document::outline(self.session.scene()?) };
        let mut document = Document::of(&self.before, &scene);
        document.scene = self.document.scene.clone();
        (document.layers, document.desk) = (Some(GROUPS as u32), desk);
        Ok(document)
    }

    /// Renders until the end, or until the scene's file is another one.
    fn work(&mut self, studio: &Studio, screen: &Screen, inbox: &Inbox) -> Result<Option<(Opened, Value)>> {
        let mut last = Turn::Meters;
        loop {
            let watched = studio.watched.load(Ordering::Relaxed);
            let (_, until) = self.turn(last, watched);
            let mut work = studio.take(until);
            let reload = work.reload.take();
            if work.ended || reload.is_some() {
                self.follow(work, inbox)?;
                return Ok(reload.map(|(opened, desk)| (*opened, desk)));
            }
            self.follow(work, inbox)?;
            // What was asked may have changed whose turn it is.
            let Some(turn) = self.turn(last, watched).0 else {
                // What moved may have come back to where it was, and the picture is already there.
                let rests = self.moved.is_none_or(|at| at.elapsed() >= REST);
                if self.sketched && rests && self.session.is_current() && self.batches() > 0 {
                    self.show(Turn::Picture, 0.0, screen, inbox)?;
                }
                screen.reached(self.seq);
                continue;
            };
            let go_on = || !studio.urgent.load(Ordering::Relaxed);
            let begun = Instant::now();
            if turn == Turn::Clamped && !self.clamped {
                self.begin_clamped()?;
            }
            let done = match turn {
                // A hand that moves on would let no sketch be finished.
                Turn::Sketch => self.session.step_sketch(&|| true)?,
                Turn::Picture => self.session.step_while(&go_on)?,
                Turn::Meters => self.session.step_meters(&go_on)?,
                Turn::Clamped => self.session.step_sketch(&go_on)?,
                Turn::Question => match self.pursued.first_mut() {
                    Some(first) => self.session.pursue(&mut first.question, &go_on)?,
                    None => false,
                },
            };
            if !done {
                continue;
            }
            last = turn;
            let seconds = begun.elapsed().as_secs_f32();
            match turn {
                Turn::Sketch => {
                    let took = seconds / (self.sketch[0] * self.sketch[1]).max(1) as f32;
                    let pixel = &mut self.pixel[usize::from(self.melted.is_some())];
                    *pixel = if *pixel == 0.0 { took } else { 0.7 * *pixel + 0.3 * took };
                    self.show(Turn::Sketch, seconds, screen, inbox)?;
                }
                Turn::Picture | Turn::Clamped => self.show(turn, seconds, screen, inbox)?,
                Turn::Meters => self.tell_readings(inbox),
                Turn::Question => self.tell(inbox)?,
            }
        }
    }

    /// Tells what the meters read, if they have begun to.
    fn tell_readings(&self, inbox: &Inbox) {
        if let Some(frame) = self.session.meters().filter(|frame| frame.batches() > 0) {
            let done = frame.batches() >= METERED;
            inbox.put(Event::Measured { readings: read(frame), by_layer: layers(frame), done });
        }
    }

    /// Whose turn it is, if it is anybody's, and until when there is nothing to do but what is asked.
    fn turn(&mut self, last: Turn, watched: bool) -> (Option<Turn>, Option<Instant>) {
        let now = Instant::now();
        if !watched && self.batches() >= UNSEEN {
            return (None, Some(now + REST));
        }
        let rest = self.moved.map(|at| at + REST).filter(|rest| *rest > now);
        let sketched = self.session.sketched().map_or(0, Sums::batches);
        if let Some(rest) = rest {
            return if sketched < SKETCHED { (Some(Turn::Sketch), Some(now)) } else { (None, Some(rest)) };
        }
        if last != Turn::Question && !self.pursued.is_empty() {
            return (Some(Turn::Question), Some(now));
        }
        let picture = !self.session.is_current() || self.batches() < self.enough;
        let meters = self.session.meters().is_some_and(|frame| frame.batches() < METERED);
        let clamped = self.lacks_clamped() && self.batches() >= BEFORE_CLAMPED;
        let turns = [(Turn::Picture, picture), (Turn::Meters, meters), (Turn::Clamped, clamped)];
        let after = turns.iter().position(|(turn, _)| *turn == last).map_or(0, |last| last + 1);
        match turns.iter().cycle().skip(after).take(turns.len()).find(|(_, wanted)| *wanted) {
            Some((turn, _)) => (Some(*turn), Some(now)),
            None if !self.pursued.is_empty() => (Some(Turn::Question), Some(now)),
            // The picture is there, and is to be shown where a sketch was last.
            None => (None, self.sketched.then_some(now)),
        }
    }

    fn batches(&mut self) -> u32 {
        self.session.frame().map_or(0, Sums::batches)
    }

    /// Does what was asked.
    fn follow(&mut self, work: Work, inbox: &Inbox) -> Result<()> {
        // A mix asks for no ray: what meters read of it is known at once.
        let mixed = work.edits.iter().any(|(edit, _)| matches!(edit, Edit::Mix { .. }));
        for (edit, seq) in work.edits {
            match self.session.edit(&edit) {
                Err(error) => inbox.put(Event::Refused { why: error.to_string() }),
                Ok(changes) => {
                    let lights = !changes.groups.is_empty() && !matches!(edit, Edit::Regroup { .. });
                    if changes.restarts_all() || lights {
                        self.begin_to_move(changes.restarts_all())?;
                    }
                    self.seq = self.seq.max(seq);
                }
            }
        }
        if mixed {
            self.tell_readings(inbox);
        }
        if let Some((colors, seq)) = work.mix {
            self.seq = self.seq.max(seq);
            if self.colors != colors {
                self.colors = colors;
                // What has no layers can't be mixed: who goes on to dim has some.
                if self.sketched && self.melted.is_some() {
                    self.begin_to_move(false)?;
                }
            }
        }
        if let Some(size) = work.size.filter(|size| *size != self.size) {
            self.size = size;
            self.session.resize(size)?;
            // Something is seen at once, though it be coarse.
            self.moved = None;
            self.begin_to_move(true)?;
        }
        self.seq = self.seq.max(work.survey.map_or(0, |(_, seq)| seq));
        if let Some((survey, _)) = work.survey.filter(|(survey, _)| *survey != self.survey) {
            let surfaces = survey.surfaces != self.survey.surfaces;
            let clamped = survey.clamped != self.survey.clamped;
            self.survey = survey;
            if clamped {
                self.put_clamped_away()?;
            }
            if surfaces {
                self.session.set(&picture_settings(survey.surfaces))?;
                if self.sketch != [0; 2] {
                    self.begin_sketch()?;
                }
            }
        }
        if let Some((look, number, seq)) = work.camera {
            self.begin_to_move(true)?;
            self.seq = self.seq.max(seq);
            self.camera = Arc::new(camera_text(&look, number));
            if look.near != self.look.near {
                self.session.cut(look.near)?;
            }
            self.session.edit(&Edit::View { camera: Some(look.camera()) })?;
            if look.near == 0.0 {
                self.plain = look.camera();
            }
            self.look = Arc::new(look);
        }
        if let Some(meters) = work.meters {
            self.session.measure(&meters, &meter_settings())?;
        }
        self.session.forget();
        if let Some((desk, name)) = work.save {
            self.saver.save(self.document(desk)?, name);
        }
        for Asked { client, id, what } in work.questions {
            let found = match what {
                What::Pixel(frame, at, compared) => self.behind(&frame, at, compared.as_ref()),
                What::Ray(ray) => self.met(&ray),
                What::Light(meter) => {
                    // Who asks again wants to know no more of what was asked before.
                    self.pursued.retain(|own| own.client != client);
                    let settings = meter_settings();
                    let question = lampyris::cpu::Question::new(meter, &settings)?;
                    self.pursued.push(Pursued { client, id, question });
                    continue;
                }
            };
            inbox.put(Event::Found { client, id, found });
        }
        Ok(())
    }

    /// Tells what is known of the first question, and puts it behind the others, or away if that is enough.
    fn tell(&mut self, inbox: &Inbox) -> Result<()> {
        let first = self.pursued.remove(0);
        let answer = self.session.answer(&first.question)?;
        let all = answer.total().all;
        let done =
            answer.batches() >= METERED || (answer.batches() >= 8 && all.error < ENOUGH_KNOWN * all.lux);
        inbox.put(Event::Lit { client: first.client, id: first.id, answer, done });
        if !done {
            self.pursued.push(first);
        }
        Ok(())
    }

    /// Hands what was drawn to the screen, and tells how far it is.
    fn show(&mut self, turn: Turn, seconds: f32, screen: &Screen, inbox: &Inbox) -> Result<()> {
        let sketched = turn == Turn::Sketch;
        let (enough, size) = (self.enough, if sketched { self.sketch } else { self.size });
        let (survey, lacks) = (self.survey.surfaces, self.lacks_clamped());
        let telling = if survey { readable(self.session.scene()?) } else { Vec::new() };
        let clamped =
            self.session.sketched().filter(|frame| self.clamped && !sketched && frame.batches() > 0);
        let clamped = clamped.map(|frame| Arc::new(frame.still()));
        let frame = match self.session.sketched().filter(|_| sketched) {
            Some(frame) => frame,
            None => self.session.frame()?,
        };
        let batches = frame.batches();
        let done = !sketched && batches >= enough && !lacks;
        // A picture that hardly changes is not sent for each batch.
        if batches > 8 && !done && self.shown.elapsed() < SELDOM {
            return Ok(());
        }
        let error = frame.relative_error() * frame.student_factor();
        let kind = match (sketched, done) {
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
        let melted = sketched && self.melted.is_some();
        let layers: Vec<_> = frame.progress().iter().map(|p| (p.batches, p.of, p.held)).collect();
        let layers = if melted { layers.repeat(self.colors.len()) } else { layers };
        let progress =
            Progress { stage, batches, error, good_in, fps: 1.0 / seconds.max(1e-3), size, layers };
        screen.light(Light {
            size,
            still: Some(Arc::new(frame.still())),
            clamped,
            albedos: frame
                .auxiliary()
                .filter(|_| survey)
                .map(|seen| Arc::new(surfaces::albedos(seen, &telling))),
            camera: self.camera.clone(),
            look: Some(self.look.clone()),
            batches,
            error,
            kind: Some(kind),
            melted,
            seq: self.seq,
            seconds,
        });
        (self.shown, self.sketched) = (Instant::now(), sketched);
        inbox.put(Event::Progress(progress));
        Ok(())
    }
}

/// What meters read [lx], with 95 % errors.
fn read(frame: &Sums) -> Vec<Estimate> {
    let factor = frame.student_factor() * PI;
    let reading = |(pixel, mean): (usize, &Rgb)| {
        let error = factor * frame.standard_error(pixel);
        Estimate { value: f64::from(mean.luminance() * PI), error: error.is_finite().then_some(error.into()) }
    };
    frame.mean().iter().enumerate().map(reading).collect()
}

/// What each layer, in white, gives each of them, as the radiance of what is matt and white [cd/m²].
fn layers(frame: &Sums) -> Vec<Vec<Rgb>> {
    let still = frame.still();
    (0..still.layers()).filter_map(|layer| still.layer(layer)).collect()
}
