//! How much an experiment may spend, where its scenes are, and whether it is still wanted.

use crate::error::{Error, Result};
use lampyris::backend::{Backend, Batch};
use lampyris::cpu::Cpu;
use lampyris::import::{self, Options};
use lampyris::scene::Scene;
use std::path::{Path, PathBuf};

/// What an experiment is given.
pub struct Effort<'a> {
    /// Small settings: seconds instead of minutes.
    pub quick: bool,
    /// Folder of the scenes that ship.
    pub scenes: &'a Path,
    /// Folder of scenes that do not ship, as `LAMPYRIS_SCENES` names it.
    pub further: Option<&'a Path>,
    /// Whether the experiment is still wanted.
    pub go_on: &'a (dyn Fn() -> bool + Sync),
    /// Is told which share of the experiment is done.
    pub told: &'a (dyn Fn(f64) + Sync),
}

impl Effort<'_> {
    /// The one for a quick run, or the other.
    pub fn of<T>(&self, quick: T, full: T) -> T {
        if self.quick { quick } else { full }
    }

    /// So many steps of so many are done.
    ///
    /// # Errors
    /// [`Error::Interrupted`] where nobody wants the rest.
    pub fn step(&self, done: usize, of: usize) -> Result<()> {
        (self.told)(done as f64 / of.max(1) as f64);
        self.go_on_or_stop()
    }

    /// Between steps.
    ///
    /// # Errors
    /// [`Error::Interrupted`] where nobody wants the rest.
    pub fn go_on_or_stop(&self) -> Result<()> {
        if (self.go_on)() { Ok(()) } else { Err(Error::Interrupted) }
    }

    /// Adds a batch.
    ///
    /// # Errors
    /// As [`Effort::step`], in the middle of the batch too.
    pub fn add(&self, cpu: &mut Cpu, batch: Batch) -> Result<()> {
        if cpu.add_while(batch, self.go_on)? { Ok(()) } else { Err(Error::Interrupted) }
    }

    /// Begins with a scene and adds so many batches.
    ///
    /// # Errors
    /// As [`Effort::add`].
    pub fn render(
        &self,
        cpu: &mut Cpu,
        (scene, eye): (Scene, lampyris::eye::Eye),
        settings: &lampyris::backend::Settings,
        batches: u32,
    ) -> Result<()> {
        cpu.begin(scene, eye, settings)?;
        (0..batches).try_for_each(|index| self.add(cpu, Batch { index }))
    }

    /// A scene that ships.
    ///
    /// # Errors
    /// The library's where it cannot be read, with what to do about it.
    pub fn scene(&self, name: &str) -> Result<Scene> {
        let file = self.scenes.join(name);
        if !file.is_file() {
            let reason = "there is no such file; --scenes names the folder of the scenes that ship".into();
            return Err(lampyris::Error::CannotRead { file, reason }.into());
        }
        Ok(import::load(&file, &Options::default())?.scene)
    }

    /// A scene that does not ship, and else, in words, how it can be had.
    ///
    /// # Errors
    /// The library's where it is there and cannot be read.
    pub fn further_scene(&self, name: &str) -> Result<std::result::Result<Scene, String>> {
        let file: Option<PathBuf> = self.further.map(|folder| folder.join(name));
        match file {
            Some(file) if file.is_file() => {
                let options = Options { root: self.further.map(Path::to_path_buf), ..Options::default() };
                Ok(Ok(import::load(&file, &options)?.scene))
            }
            Some(_) => Ok(Err(format!("Not measured: the folder that LAMPYRIS_SCENES names has no {name}."))),
            None => Ok(Err(format!(
                "Not measured: {name} does not ship. Set LAMPYRIS_SCENES to a folder that has it, and run this again."
            ))),
        }
    }
}
