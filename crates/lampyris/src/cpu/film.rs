//! A film: what one eye sees of the world in use, by settings of its own, batch by batch. The first of a session is its
//! picture; meters are another one in the same world, so that figures follow the lamps while the picture is worked on.

use super::begun::Begun;
use super::draw::Plane;
use crate::error::Result;
use crate::eye::Eye;
use crate::frame::Frame;
use crate::integrator::{self, Integrator};
use crate::particle::Plan;
use crate::scene::Edit;
use crate::settings::{Settings, Statistics};
use crate::world::{Changes, World};

/// An eye, how its light is estimated, and the sums.
pub(super) struct Film {
    pub(super) eye: Eye,
    pub(super) settings: Settings,
    pub(super) plan: Plan,
    pub(super) integrators: Vec<&'static dyn Integrator>,
    /// What integrators draw into.
    pub(super) planes: Vec<Plane>,
    /// Of each integrator, which of them the light of first eye paths is drawn into, and which that of second ones.
    pub(super) planes_of: Vec<[usize; 2]>,
    pub(super) frame: Frame,
    /// Batches that were given up.
    pub(super) begun: Vec<Begun>,
    pub(super) statistics: Statistics,
}

impl Film {
    /// Nothing as yet, with a layer for each light group of the world.
    ///
    /// # Errors
    /// [`Error::BadSetting`](crate::Error::BadSetting) for settings that make no sense.
    pub(super) fn new(world: &World, eye: Eye, settings: &Settings) -> Result<Film> {
        settings.check()?;
        // Either parts have planes of their own or light groups: both would be too many.
        Film::by(world, eye, settings, Plan::new(world, settings), world.scene().groups.is_empty())
    }

    /// With the layers of a plan, which has been made by these settings, and planes for the parts or not.
    pub(super) fn by(world: &World, eye: Eye, settings: &Settings, plan: Plan, apart: bool) -> Result<Film> {
        let integrators = integrator::select(&settings.parts)?;
        let names: Vec<&str> = integrators.iter().map(|i| i.name()).collect();
        let (planes, planes_of) = Plane::deal(&integrators, apart);
        let (width, height) = eye.size();
        // Meters have no neighbours.
        let filter = settings.filter && matches!(eye, Eye::Camera(_));
        let settings = Settings { filter, ..settings.clone() };
        let mut frame = Frame::new(width, height, if apart { &names } else { &[] }, &settings, plan.layers());
        frame.set_mix(&world.mix());
        Ok(Film {
            plan,
            begun: Vec::new(),
            statistics: Statistics::default(),
            eye,
            settings,
            integrators,
            planes,
            planes_of,
            frame,
        })
    }

    /// The world was edited: sums of light groups whose light is another one begin anew.
    pub(super) fn follow(&mut self, world: &World, edit: &Edit, changes: &Changes) {
        if !changes.groups.is_empty() {
            self.plan = Plan::new(world, &self.settings);
        }
        match edit {
            Edit::Regroup { .. } => self.frame.regroup(&changes.groups),
            _ => changes.groups.iter().for_each(|group| self.frame.change(*group)),
        }
        self.frame.set_mix(&world.mix());
    }

    /// All light takes other ways now: all sums begin anew.
    pub(super) fn renew(&mut self, world: &World) {
        self.plan = Plan::new(world, &self.settings);
        (0..world.groups()).for_each(|group| self.frame.change(group));
        self.frame.forget_first();
        self.frame.set_mix(&world.mix());
        self.statistics = Statistics::default();
    }
}
