//! The back end of the machine at hand: tiles in parallel on a pool of threads.
//!
//! A tile's pixels are summed by one thread in a fixed order, so the picture does not know how many threads there are.

mod begun;
mod draw;

use crate::backend::{Backend, Batch, Settings, Statistics};
use crate::error::{Error, Result};
use crate::eye::Eye;
use crate::frame::Frame;
use crate::integrator::{self, Integrator};
use crate::particle::Plan;
use crate::scene::{Edit, Scene};
use crate::world::{Changes, World};
use begun::Begun;
use draw::Plane;

/// All cores of this machine, or as many threads as one likes.
pub struct Cpu {
    pool: rayon::ThreadPool,
    job: Option<Job>,
}

/// Says whether a batch is still wanted.
pub type GoOn<'a> = &'a (dyn Fn() -> bool + Sync);

/// What `begin` was given.
struct Job {
    world: World,
    eye: Eye,
    settings: Settings,
    plan: Plan,
    integrators: Vec<&'static dyn Integrator>,
    /// What integrators draw into.
    planes: Vec<Plane>,
    /// Of each integrator, which of them the light of first eye paths is drawn into, and which that of second ones.
    planes_of: Vec<[usize; 2]>,
    frame: Frame,
    /// Batches that were given up.
    begun: Vec<Begun>,
    statistics: Statistics,
}

impl Cpu {
    /// A back end on `threads` threads; on all cores where `None`.
    ///
    /// # Errors
    /// [`Error::BadSetting`] if the system refuses the threads.
    pub fn new(threads: Option<usize>) -> Result<Cpu> {
        let pool = rayon::ThreadPoolBuilder::new()
            .num_threads(threads.unwrap_or(0))
            .build()
            .map_err(|e| Error::BadSetting(format!("cannot start the threads: {e}; ask for fewer")))?;
        Ok(Cpu { pool, job: None })
    }

    /// Does something on the threads of this back end, [`World::new`] for instance.
    pub fn install<R: Send>(&self, work: impl FnOnce() -> R + Send) -> R {
        self.pool.install(work)
    }

    /// [`Backend::begin`] with a world that is already built, where a view had to be found in it first.
    pub fn begin_world(&mut self, world: World, eye: Eye, settings: &Settings) -> Result<()> {
        settings.check()?;
        let integrators = integrator::select(&settings.parts)?;
        let names: Vec<&str> = integrators.iter().map(|i| i.name()).collect();
        // Either parts have planes of their own or light groups: both would be too many.
        let apart = world.scene().groups.is_empty();
        let (planes, planes_of) = Plane::deal(&integrators, apart);
        let (width, height) = eye.size();
        // Meters have no neighbours.
        let filter = settings.filter && matches!(eye, Eye::Camera(_));
        let settings = Settings { filter, ..settings.clone() };
        let mut job = Job {
            plan: Plan::new(&world, &settings),
            frame: Frame::new(width, height, if apart { &names } else { &[] }, &settings, world.groups()),
            planes,
            planes_of,
            begun: Vec::new(),
            statistics: Statistics::default(),
            settings,
            world,
            eye,
            integrators,
        };
        job.frame.set_mix(&job.world.mix());
        self.job = Some(job);
        Ok(())
    }

    /// Starts afresh in the world in use.
    pub fn restart(&mut self, eye: Eye, settings: &Settings) -> Result<()> {
        let world = self.job.take().ok_or_else(nothing)?.world;
        self.begin_world(world, eye, settings)
    }

    /// Starts all sums afresh after an edit that [`Changes::restarts_all`] and left the view as it was, with the settings in use.
    /// What the last batches showed stays as long as [`Settings::window`] says.
    ///
    /// # Errors
    /// [`Error::BadSetting`] before `begin`.
    pub fn renew(&mut self) -> Result<()> {
        let job = self.job()?;
        job.plan = Plan::new(&job.world, &job.settings);
        (0..job.world.groups()).for_each(|group| job.frame.change(group));
        job.frame.forget_first();
        job.frame.set_mix(&job.world.mix());
        job.statistics = Statistics::default();
        Ok(())
    }

    /// Renders one batch and adds it to what is shown, not to the sums.
    ///
    /// # Errors
    /// [`Error::BadSetting`] before `begin`.
    pub fn show(&mut self, batch: Batch) -> Result<()> {
        self.render(batch, false, &|| true).map(drop)
    }

    /// [`Cpu::show`] as long as `go_on` says; see [`Cpu::add_while`].
    ///
    /// # Errors
    /// As [`Cpu::show`].
    pub fn show_while(&mut self, batch: Batch, go_on: GoOn<'_>) -> Result<bool> {
        self.render(batch, false, go_on)
    }

    /// [`Backend::add`] as long as `go_on` says, which threads ask before every tile; false if the batch was given up. Then
    /// the first rows of its layers have it, each in its weight, and no count and no error knows of it: to add the same
    /// batch again completes it. Light groups that an edit changes meanwhile begin anew, the others go on where they were,
    /// and if another batch is added to them instead they begin anew as well.
    ///
    /// # Errors
    /// As [`Backend::add`].
    pub fn add_while(&mut self, batch: Batch, go_on: GoOn<'_>) -> Result<bool> {
        self.render(batch, true, go_on)
    }

    fn render(&mut self, batch: Batch, kept: bool, go_on: GoOn<'_>) -> Result<bool> {
        let Cpu { pool, job } = self;
        let job = job.as_mut().ok_or_else(nothing)?;
        Ok(pool.install(|| job.add(batch, kept, go_on)))
    }

    /// Light groups that have part of a batch, beside `batches` or more of them, begin anew.
    ///
    /// # Errors
    /// [`Error::BadSetting`] before `begin`.
    pub fn forget_begun(&mut self, batches: u32) -> Result<()> {
        self.job().map(|job| job.forget_begun(batches))
    }

    /// The world in use, once `begin` was called.
    pub fn world(&self) -> Option<&World> {
        self.job.as_ref().map(|j| &j.world)
    }

    /// Changes the world in use, on the threads of this back end. Sums of light groups whose light is another one now begin
    /// anew; where [`Changes::restarts_all`], what has been summed is of the world before, and it is the caller's to
    /// [`Cpu::renew`], or to [`Cpu::restart`] if the view is another one.
    ///
    /// # Errors
    /// As [`World::apply`], and [`Error::BadSetting`] before `begin`.
    pub fn edit(&mut self, edit: &Edit) -> Result<Changes> {
        let Cpu { pool, job } = self;
        let job = job.as_mut().ok_or_else(nothing)?;
        let changes = pool.install(|| job.world.apply(edit))?;
        if !changes.groups.is_empty() {
            job.plan = Plan::new(&job.world, &job.settings);
        }
        match edit {
            Edit::Regroup { .. } => job.frame.regroup(&changes.groups),
            _ => changes.groups.iter().for_each(|group| job.frame.change(*group)),
        }
        job.frame.set_mix(&job.world.mix());
        Ok(changes)
    }

    /// From now on what is shown follows from the batches of the sums alone: nothing of what was before an edit stands in
    /// for any ([`Frame::progress`], [`Settings::window`]).
    ///
    /// # Errors
    /// [`Error::BadSetting`] before `begin`.
    pub fn let_go(&mut self) -> Result<()> {
        self.job().map(|job| job.frame.let_go())
    }

    fn job(&mut self) -> Result<&mut Job> {
        self.job.as_mut().ok_or_else(nothing)
    }
}

fn nothing() -> Error {
    Error::BadSetting("nothing to render: call begin first".into())
}

impl Backend for Cpu {
    fn begin(&mut self, scene: Scene, eye: Eye, settings: &Settings) -> Result<()> {
        settings.check()?;
        let world = self.install(|| World::new(scene));
        self.begin_world(world, eye, settings)
    }

    fn add(&mut self, batch: Batch) -> Result<()> {
        self.render(batch, true, &|| true).map(drop)
    }

    fn frame(&mut self) -> Result<&Frame> {
        self.job().map(|j| &j.frame)
    }

    fn statistics(&self) -> Statistics {
        self.job.as_ref().map(|j| j.statistics).unwrap_or_default()
    }
}
