//! The back end of the machine at hand: tiles in parallel on a pool of threads.
//!
//! A tile's pixels are summed by one thread in a fixed order, so the picture does not know how many threads there are.

mod begun;
mod draw;
mod film;
mod question;

pub use question::{Answer, Question, Reading, Shares};

use crate::backend::{Backend, Batch, Settings, Statistics};
use crate::color::Rgb;
use crate::error::{Error, Result};
use crate::eye::{Eye, Meter};
use crate::frame::Frame;
use crate::scene::{Edit, Scene};
use crate::world::{Changes, World};
use film::Film;

/// All cores of this machine, or as many threads as one likes.
pub struct Cpu {
    pool: rayon::ThreadPool,
    job: Option<Job>,
    /// Counts the states of the world: who asked what lights a point asks anew in each.
    state: u64,
}

/// Says whether a batch is still wanted.
pub type GoOn<'a> = &'a (dyn Fn() -> bool + Sync);

/// What `begin` was given, and what else looks at that world.
struct Job {
    world: World,
    picture: Film,
    sketch: Option<Film>,
    meters: Option<Film>,
}

impl Job {
    fn films(&mut self) -> impl Iterator<Item = (&World, &mut Film)> {
        let Job { world, picture, sketch, meters } = self;
        std::iter::once(picture).chain(sketch).chain(meters).map(|film| (&*world, film))
    }
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
        Ok(Cpu { pool, job: None, state: 0 })
    }

    /// Does something on the threads of this back end, [`World::new`] for instance.
    pub fn install<R: Send>(&self, work: impl FnOnce() -> R + Send) -> R {
        self.pool.install(work)
    }

    /// [`Backend::begin`] with a world that is already built, where a view had to be found in it first.
    pub fn begin_world(&mut self, world: World, eye: Eye, settings: &Settings) -> Result<()> {
        let picture = Film::new(&world, eye, settings)?;
        self.job = Some(Job { world, picture, sketch: None, meters: None });
        self.state += 1;
        Ok(())
    }

    /// Starts the picture afresh in the world in use. Meters stay as they are.
    ///
    /// # Errors
    /// [`Error::BadSetting`] for settings that make no sense, and before `begin`; nothing is changed then.
    pub fn restart(&mut self, eye: Eye, settings: &Settings) -> Result<()> {
        let job = self.job()?;
        job.picture = Film::new(&job.world, eye, settings)?;
        Ok(())
    }

    /// Sketches what an eye sees from now on, beside the picture and in the same world, with a layer a light group, or with
    /// one for all of them, each in its colour of those `melted`. A sketch has batches and sums of its own, which edits renew
    /// as they do the picture's.
    ///
    /// # Errors
    /// As [`Cpu::restart`].
    pub fn sketch(&mut self, eye: Eye, settings: &Settings, melted: Option<&[Rgb]>) -> Result<()> {
        let job = self.job()?;
        job.sketch = Some(match melted {
            Some(colors) => Film::melted(&job.world, eye, settings, colors)?,
            None => Film::new(&job.world, eye, settings)?,
        });
        Ok(())
    }

    /// Sketches no more.
    ///
    /// # Errors
    /// [`Error::BadSetting`] before `begin`.
    pub fn sketch_no_more(&mut self) -> Result<()> {
        self.job()?.sketch = None;
        Ok(())
    }

    /// The sketch as it stands.
    pub fn sketched(&self) -> Option<&Frame> {
        self.job.as_ref()?.sketch.as_ref().map(|film| &film.frame)
    }

    /// Adds a batch to the sketch, as long as `go_on` says ([`Cpu::add_while`]); false also where there is none.
    ///
    /// # Errors
    /// [`Error::BadSetting`] before `begin`.
    pub fn add_to_sketch(&mut self, batch: Batch, go_on: GoOn<'_>) -> Result<bool> {
        let Cpu { pool, job, .. } = self;
        let Job { world, sketch, .. } = job.as_mut().ok_or_else(nothing)?;
        Ok(sketch.as_mut().is_some_and(|film| pool.install(|| film.add(world, batch, true, go_on))))
    }

    /// Measures at some points from now on, beside the picture and in the same world; `None` does not any more. Meters have
    /// batches and sums of their own, which edits renew as they do the picture's.
    ///
    /// # Errors
    /// As [`Cpu::restart`].
    pub fn measure(&mut self, meters: Option<Vec<Meter>>, settings: &Settings) -> Result<()> {
        let job = self.job()?;
        let film = |meters| Film::new(&job.world, Eye::Meters(meters), settings);
        job.meters = meters.map(film).transpose()?;
        Ok(())
    }

    /// What the meters' sums are, row by row a pixel each: illuminance over π [lx].
    pub fn meters(&self) -> Option<&Frame> {
        self.job.as_ref()?.meters.as_ref().map(|film| &film.frame)
    }

    /// Adds a batch to the meters, as long as `go_on` says ([`Cpu::add_while`]); false also where there are none.
    ///
    /// # Errors
    /// [`Error::BadSetting`] before `begin`.
    pub fn add_to_meters(&mut self, batch: Batch, go_on: GoOn<'_>) -> Result<bool> {
        let Cpu { pool, job, .. } = self;
        let Job { world, meters, .. } = job.as_mut().ok_or_else(nothing)?;
        Ok(meters.as_mut().is_some_and(|film| pool.install(|| film.add(world, batch, true, go_on))))
    }

    /// [`Cpu::let_go`] and [`Cpu::forget_begun`] for the meters.
    ///
    /// # Errors
    /// [`Error::BadSetting`] before `begin`.
    pub fn settle_meters(&mut self, batches: u32) -> Result<()> {
        if let Some(film) = &mut self.job()?.meters {
            film.forget_begun(batches);
            film.frame.let_go();
        }
        Ok(())
    }

    /// Adds a batch to what is known of a question, as long as `go_on` says; false if it was given up, and then nothing is
    /// changed. After an edit that changed any light it is the first.
    ///
    /// # Errors
    /// [`Error::BadSetting`] before `begin`, and where the scene has very many lamps.
    pub fn pursue(&mut self, question: &mut Question, go_on: GoOn<'_>) -> Result<bool> {
        let Cpu { pool, job, state } = self;
        let job = job.as_ref().ok_or_else(nothing)?;
        pool.install(|| question.add(&job.world, *state, go_on))
    }

    /// What is known of a question, in the levels and colours that the lamps have now; nothing, where light has changed since it
    /// was pursued last.
    ///
    /// # Errors
    /// [`Error::BadSetting`] before `begin`.
    pub fn answer(&self, question: &Question) -> Result<Answer> {
        let job = self.job.as_ref().ok_or_else(nothing)?;
        Ok(question.answer(&job.world, self.state))
    }

    /// Starts all sums, of meters too, afresh after an edit that [`Changes::restarts_all`] and left the view as it was, with
    /// the settings in use. What the last batches showed stays as long as [`Settings::window`] says.
    ///
    /// # Errors
    /// [`Error::BadSetting`] before `begin`.
    pub fn renew(&mut self) -> Result<()> {
        self.job()?.films().try_for_each(|(world, film)| film.renew(world))
    }

    /// [`Cpu::renew`] of the sketch and the meters, where the picture is to be begun anew later ([`Cpu::restart`]).
    ///
    /// # Errors
    /// [`Error::BadSetting`] before `begin`.
    pub fn renew_beside(&mut self) -> Result<()> {
        self.job()?.films().skip(1).try_for_each(|(world, film)| film.renew(world))
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
        let Cpu { pool, job, .. } = self;
        let job = job.as_mut().ok_or_else(nothing)?;
        Ok(pool.install(|| job.picture.add(&job.world, batch, kept, go_on)))
    }

    /// Light groups that have part of a batch, beside `batches` or more of them, begin anew.
    ///
    /// # Errors
    /// [`Error::BadSetting`] before `begin`.
    pub fn forget_begun(&mut self, batches: u32) -> Result<()> {
        self.job().map(|job| job.picture.forget_begun(batches))
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
        let Cpu { pool, job, state } = self;
        let job = job.as_mut().ok_or_else(nothing)?;
        let changes = pool.install(|| job.world.apply(edit))?;
        job.films().for_each(|(world, film)| film.follow(world, edit, &changes));
        *state += u64::from(changes.geometry || changes.materials || !changes.emitters.is_empty());
        Ok(changes)
    }

    /// From now on what is shown follows from the batches of the sums alone: nothing of what was before an edit stands in
    /// for any ([`Frame::progress`], [`Settings::window`]).
    ///
    /// # Errors
    /// [`Error::BadSetting`] before `begin`.
    pub fn let_go(&mut self) -> Result<()> {
        self.job().map(|job| job.picture.frame.let_go())
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
        self.job().map(|job| &job.picture.frame)
    }

    fn statistics(&self) -> Statistics {
        self.job.as_ref().map(|job| job.picture.statistics).unwrap_or_default()
    }
}
