//! A scene that is looked at and worked on: a world, a back end, a picture that grows batch by batch, and the log of all
//! edits. No thread and no clock is in here: a step is as long as a batch takes, and whose turn it is the caller decides.
//!
//! *Edited is fresh*: a picture never depends on how the scene came to be what it is. After any edits it has the bits of
//! one begun anew with [`Session::scene`], once all light groups have as many batches. What changes the light of a group
//! starts that group at batch 0 again; what changes all light, or where it is seen from, starts the picture; and levels and
//! colours of groups start nothing ([`Edit::Mix`]).

use crate::backend::{Backend, Batch, Settings, Statistics};
use crate::color::Rgb;
use crate::cpu::{Answer, Cpu, GoOn, Question};
use crate::error::{Error, Result};
use crate::eye::{Eye, Meter};
use crate::frame::Frame;
use crate::scene::{Camera, Edit, Scene, View};
use crate::world::{Changes, World};

/// A scene being edited while its picture grows.
pub struct Session {
    cpu: Cpu,
    /// Width and height [pixels].
    size: [u32; 2],
    settings: Settings,
    /// What is nearer to the eye than this is not seen [m].
    near: f32,
    /// Beside the picture.
    sketch: Option<Sketch>,
    /// The picture is of another view or of surfaces that are no more: it is begun anew when a batch is asked for.
    stale: bool,
    /// Number of the next batch that is drawn while light changes, below [`Settings::window`].
    turn: u32,
    log: Vec<Edit>,
    /// What takes the last edits back, the latest at the end.
    undo: Vec<Edit>,
    /// What brings back what was taken back last.
    redo: Vec<Edit>,
}

/// A small picture of the view beside the large one: a few small batches are soon drawn while something moves.
#[derive(Clone, Debug)]
pub struct Sketch {
    /// Width and height [pixels].
    pub size: [u32; 2],
    /// How its light is estimated.
    pub settings: Settings,
    /// The colours of all light groups by number, where their light is summed in one layer: what takes other ways is drawn
    /// sooner, and to show it in other colours costs a sketch anew. `None` for a layer a group, as in the picture.
    pub melted: Option<Vec<Rgb>>,
}

impl Session {
    /// Opens a scene, seen by its [`Scene::view`] in a picture of `size` pixels, on `threads` threads; on all cores where
    /// `None`.
    ///
    /// # Errors
    /// [`Error::BadSetting`] for settings that make no sense, and for a scene whose view is not decided.
    pub fn open(
        scene: Scene,
        size: [u32; 2],
        settings: &Settings,
        threads: Option<usize>,
    ) -> Result<Session> {
        eye(scene.view.as_ref(), size, 0.0)?;
        let cpu = Cpu::new(threads)?;
        let world = cpu.install(|| World::new(scene));
        Session::begin(cpu, world, size, settings)
    }

    /// [`Session::open`] of a world that was built, on a back end that is at hand.
    ///
    /// # Errors
    /// As [`Session::open`].
    pub fn begin(mut cpu: Cpu, world: World, size: [u32; 2], settings: &Settings) -> Result<Session> {
        let eye = eye(world.scene().view.as_ref(), size, 0.0)?;
        cpu.begin_world(world, eye, settings)?;
        Ok(Session {
            cpu,
            size,
            settings: settings.clone(),
            near: 0.0,
            sketch: None,
            stale: false,
            turn: 0,
            log: Vec::new(),
            undo: Vec::new(),
            redo: Vec::new(),
        })
    }

    /// Changes the scene. It takes effect in the next step.
    ///
    /// # Errors
    /// As [`Scene::apply`], and [`Error::BadSetting`] for taking the view away; nothing is changed then.
    pub fn edit(&mut self, edit: &Edit) -> Result<Changes> {
        let changes = self.carry_out(edit)?;
        self.undo.push(changes.inverse.clone());
        self.redo.clear();
        Ok(changes)
    }

    /// Makes lamps of one light group a group of their own, if others share it, and returns its number: to be dimmed by
    /// themselves ([`Edit::Mix`]). The picture stays; how far the layers solved anew are [`Frame::progress`] tells.
    ///
    /// # Errors
    /// As [`Session::edit`]: where the scene has no groups, or as many as it may have; emitters that it does not have, or of
    /// several groups.
    pub fn split(&mut self, emitters: &[u32]) -> Result<u16> {
        let scene = self.scene()?;
        let (shares, next) = (&scene.reference.shares, scene.groups.len() as u16);
        let group_of = |emitter: &u32| shares.get(*emitter as usize).map(|share| share.group);
        let group = emitters.first().and_then(group_of);
        let mut all = (0..).zip(shares);
        let shared = all.any(|(number, share)| Some(share.group) == group && !emitters.contains(&number));
        match group.filter(|own| !shared && emitters.iter().all(|e| group_of(e) == Some(*own))) {
            Some(group) if next > 0 => Ok(group),
            _ => self.edit(&Edit::Regroup { emitters: emitters.to_vec(), group: next }).map(|_| next),
        }
    }

    /// Takes the last edit back that has not been; `None` where there is none.
    ///
    /// # Errors
    /// None that could be told of: what was done can be undone.
    pub fn undo(&mut self) -> Result<Option<Changes>> {
        let Some(edit) = self.undo.pop() else { return Ok(None) };
        let changes = self.carry_out(&edit)?;
        self.redo.push(changes.inverse.clone());
        Ok(Some(changes))
    }

    /// Brings back what was undone last; `None` where nothing was since the last edit.
    ///
    /// # Errors
    /// As [`Session::undo`].
    pub fn redo(&mut self) -> Result<Option<Changes>> {
        let Some(edit) = self.redo.pop() else { return Ok(None) };
        let changes = self.carry_out(&edit)?;
        self.undo.push(changes.inverse.clone());
        Ok(Some(changes))
    }

    /// Everything that was done to the scene, in order; what was undone and redone too. On the scene that was opened it
    /// makes the scene as it stands, and the same bits of its picture.
    pub fn log(&self) -> &[Edit] {
        &self.log
    }

    /// Does what a log says.
    ///
    /// # Errors
    /// As [`Session::edit`], at the first edit that does not fit the scene; those before it stay.
    pub fn replay(&mut self, log: &[Edit]) -> Result<()> {
        log.iter().try_for_each(|edit| self.edit(edit).map(drop))
    }

    /// Adds a batch to the picture: the next one of the light groups that have fewest.
    ///
    /// With a [`Settings::window`] of N batches successive steps take the numbers 0 to N − 1 in turn while light changes, so
    /// that the last N are of different light paths; until the turn comes to 0 they are shown and not added.
    ///
    /// # Errors
    /// Those of the back end.
    pub fn step(&mut self) -> Result<()> {
        self.step_while(&|| true).map(drop)
    }

    /// [`Session::step`] as long as `go_on` says, which threads ask before every tile; false if the batch was given up. What
    /// was done of it is not lost: the next steps complete it, for all light groups that are not begun anew meanwhile, and
    /// the picture has the bits that it would have had. Until then the first rows of those groups have the batch, and no
    /// count and no error knows of it.
    ///
    /// # Errors
    /// As [`Session::step`].
    pub fn step_while(&mut self, go_on: GoOn<'_>) -> Result<bool> {
        if self.stale {
            self.restart()?;
        }
        let (index, turn) = (self.frame()?.batches(), self.turn);
        let done = if index == 0 && turn > 0 {
            self.cpu.show_while(Batch { index: turn }, go_on)?
        } else {
            self.cpu.add_while(Batch { index }, go_on)?
        };
        if done {
            self.turn = (turn + 1) % self.settings.window;
        }
        Ok(done)
    }

    /// Adds batches until all light groups have `batches` of them. The picture is then that of so many batches, and nothing
    /// stands in for any of them, whatever was done before. Groups that have as many and part of another begin anew.
    ///
    /// # Errors
    /// As [`Session::step`].
    pub fn settle(&mut self, batches: u32) -> Result<()> {
        if self.stale {
            self.restart()?;
        }
        self.cpu.forget_begun(batches)?;
        while self.frame()?.batches() < batches {
            self.turn = 0;
            self.step()?;
        }
        self.cpu.let_go()
    }

    /// Measures at some points from now on, in the place of those before, by settings of their own: meters get their own
    /// batches, all light groups told apart as in the picture, and edits renew them as they do the picture. An empty list
    /// ends it.
    ///
    /// # Errors
    /// [`Error::BadSetting`] for settings that make no sense; nothing is changed then.
    pub fn measure(&mut self, meters: &[Meter], settings: &Settings) -> Result<()> {
        self.cpu.measure((!meters.is_empty()).then(|| meters.to_vec()), settings)
    }

    /// The meters' sums, a pixel each in one row: illuminance over π [lx]. Its [`Frame::mean`] is a figure to state as soon
    /// as all light groups have the same number of batches ([`Frame::progress`]).
    pub fn meters(&self) -> Option<&Frame> {
        self.cpu.meters()
    }

    /// [`Session::step_while`] for the meters; false also where there are none.
    ///
    /// # Errors
    /// As [`Session::step`].
    pub fn step_meters(&mut self, go_on: GoOn<'_>) -> Result<bool> {
        let index = self.meters().map_or(0, Frame::batches);
        self.cpu.add_to_meters(Batch { index }, go_on)
    }

    /// [`Session::settle`] for the meters.
    ///
    /// # Errors
    /// As [`Session::step`].
    pub fn settle_meters(&mut self, batches: u32) -> Result<()> {
        self.cpu.settle_meters(batches)?;
        while self.meters().is_some_and(|frame| frame.batches() < batches) {
            self.step_meters(&|| true)?;
        }
        Ok(())
    }

    /// Adds a batch to what is known of a question ([`Question::new`]), as long as `go_on` says; false if it was given up, and
    /// then nothing is changed. Neither picture nor meters notice. After an edit that changed any light it is the first
    /// batch; levels and colours of light groups change none.
    ///
    /// # Errors
    /// Those of the back end, and [`Error::BadSetting`] where the scene has very many lamps.
    pub fn pursue(&mut self, question: &mut Question, go_on: GoOn<'_>) -> Result<bool> {
        self.cpu.pursue(question, go_on)
    }

    /// What is known of a question, in the levels and colours that the lamps have now; nothing, where light has changed
    /// since it was pursued last.
    ///
    /// # Errors
    /// Those of the back end.
    pub fn answer(&self, question: &Question) -> Result<Answer> {
        self.cpu.answer(question)
    }

    /// Starts the picture again with other settings.
    ///
    /// # Errors
    /// [`Error::BadSetting`] for settings that make no sense; nothing is changed then.
    pub fn set(&mut self, settings: &Settings) -> Result<()> {
        settings.check()?;
        self.settings = settings.clone();
        self.restart()
    }

    /// Sees nothing that is nearer to the eye than a plane at that distance [m], as in a section: the light stays that of the
    /// whole. 0 sees everything.
    ///
    /// # Errors
    /// [`Error::BadSetting`] for a distance that is none; nothing is changed then.
    pub fn cut(&mut self, near: f32) -> Result<()> {
        if !(near >= 0.0 && near.is_finite()) {
            return Err(Error::BadSetting("a view is cut at a distance that is not negative".into()));
        }
        self.near = near;
        self.turn_to_view()
    }

    /// Sketches the view from now on, beside the picture; `None` does not any more. A sketch has batches and sums of its own,
    /// which edits renew as they do the picture's. After [`Edit::Regroup`] who melts tells the colours again.
    ///
    /// # Errors
    /// [`Error::BadSetting`] for settings that make no sense; nothing is changed then.
    pub fn sketch(&mut self, sketch: Option<Sketch>) -> Result<()> {
        let before = std::mem::replace(&mut self.sketch, sketch);
        let done = self.restart_sketch();
        if done.is_err() {
            self.sketch = before;
        }
        done
    }

    /// False while the picture is that of a view before, or of surfaces as they were, because there is a sketch.
    pub fn is_current(&self) -> bool {
        !self.stale
    }

    /// The sketch as it stands.
    pub fn sketched(&self) -> Option<&Frame> {
        self.cpu.sketched()
    }

    /// [`Session::step_while`] for the sketch; false also where there is none.
    ///
    /// # Errors
    /// As [`Session::step`].
    pub fn step_sketch(&mut self, go_on: GoOn<'_>) -> Result<bool> {
        let index = self.sketched().map_or(0, Frame::batches);
        self.cpu.add_to_sketch(Batch { index }, go_on)
    }

    /// Starts the picture again in another size [pixels].
    ///
    /// # Errors
    /// Those of the back end.
    pub fn resize(&mut self, size: [u32; 2]) -> Result<()> {
        self.size = size;
        self.restart()
    }

    /// Forgets what was done, but not what came of it: nothing can be undone, and the log begins here. For those who keep
    /// their own.
    pub fn forget(&mut self) {
        (self.log, self.undo, self.redo) = Default::default();
    }

    /// What was done since the picture was started last.
    pub fn statistics(&self) -> Statistics {
        self.cpu.statistics()
    }

    /// The picture as it stands.
    ///
    /// # Errors
    /// Those of the back end.
    pub fn frame(&mut self) -> Result<&Frame> {
        self.cpu.frame()
    }

    /// The world as it stands.
    ///
    /// # Errors
    /// Those of the back end.
    pub fn world(&self) -> Result<&World> {
        self.cpu.world().ok_or_else(|| Error::BadSetting("nothing to render: call begin first".into()))
    }

    /// The scene as it stands.
    ///
    /// # Errors
    /// Those of the back end.
    pub fn scene(&self) -> Result<&Scene> {
        self.world().map(World::scene)
    }

    /// Changes the scene, notes it, and starts the picture again if it is another one now.
    fn carry_out(&mut self, edit: &Edit) -> Result<Changes> {
        if let Edit::View { camera } = edit {
            eye(camera.as_ref(), self.size, self.near)?;
        }
        let changes = self.cpu.edit(edit)?;
        self.log.push(edit.clone());
        if changes.restarts_all() && !changes.view {
            // Where there is a sketch the picture waits until it is asked for: to empty it takes longer than to sketch.
            self.stale |= self.sketch.is_some();
            if self.stale { self.cpu.renew_beside()? } else { self.cpu.renew()? }
        } else if changes.view {
            self.turn_to_view()?;
        }
        Ok(changes)
    }

    /// Batches seen from elsewhere show nothing of use, but their light paths are the same again. Where there is a sketch the
    /// picture waits until it is asked for.
    fn turn_to_view(&mut self) -> Result<()> {
        if self.sketch.is_none() {
            return self.restart();
        }
        self.stale = true;
        self.restart_sketch()
    }

    fn restart(&mut self) -> Result<()> {
        let eye = eye(self.scene()?.view.as_ref(), self.size, self.near)?;
        (self.turn, self.stale) = (0, false);
        self.cpu.restart(eye, &self.settings)
    }

    fn restart_sketch(&mut self) -> Result<()> {
        let Some(Sketch { size, settings, melted }) = &self.sketch else { return self.cpu.sketch_no_more() };
        let eye = eye(self.scene()?.view.as_ref(), *size, self.near)?;
        self.cpu.sketch(eye, settings, melted.as_deref())
    }
}

fn eye(camera: Option<&Camera>, [width, height]: [u32; 2], near: f32) -> Result<Eye> {
    let undecided =
        || Error::BadSetting("nobody has decided from where to look: give the scene a view".into());
    camera.map(|camera| Eye::Camera(View::new(camera, width, height).cut(near))).ok_or_else(undecided)
}
