//! A film: what one eye sees of the world in use, by settings of its own, batch by batch. The first of a session is its
//! picture; meters are another one in the same world, so that figures follow the lamps while the picture is worked on.

use super::begun::Begun;
use super::draw::Plane;
use crate::coarse::Grounds;
use crate::color::Rgb;
use crate::error::Result;
use crate::eye::Eye;
use crate::frame::Frame;
use crate::integrator::{self, Integrator};
use crate::particle::Plan;
use crate::scene::Edit;
use crate::settings::{Rays, Settings, Statistics};
use crate::world::{Changes, World};

/// An eye, how its light is estimated, and the sums.
pub(super) struct Film {
    pub(super) eye: Eye,
    pub(super) settings: Settings,
    pub(super) plan: Plan,
    /// The colours in which the light of all groups is summed in one layer, where it is.
    melted: Option<Vec<Rgb>>,
    /// What coarse solutions stand on, where a part looks them up.
    pub(super) grounds: Option<Grounds>,
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

    /// Nothing as yet, in one layer that has the light of each light group in a colour of its own.
    ///
    /// # Errors
    /// As [`Film::new`].
    pub(super) fn melted(world: &World, eye: Eye, settings: &Settings, colors: &[Rgb]) -> Result<Film> {
        settings.check()?;
        let film = Film::by(world, eye, settings, Plan::melted(world, settings, colors), false)?;
        let mut melted = Film { melted: Some(colors.to_vec()), ..film };
        melted.frame.set_mix(&melted.mix(world));
        Ok(melted)
    }

    /// With the layers of a plan, which has been made by these settings, and planes for the parts or not.
    pub(super) fn by(world: &World, eye: Eye, settings: &Settings, plan: Plan, apart: bool) -> Result<Film> {
        let integrators = integrator::select(&settings.parts)?;
        let grounds = Grounds::new(world, settings, integrator::wants(&integrators))?;
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
            melted: None,
            begun: Vec::new(),
            statistics: begun(grounds.as_ref()),
            eye,
            settings,
            grounds,
            integrators,
            planes,
            planes_of,
            frame,
        })
    }

    /// The world was edited: sums of light groups whose light is another one begin anew.
    pub(super) fn follow(&mut self, world: &World, edit: &Edit, changes: &Changes) {
        if !changes.groups.is_empty() {
            self.plan = self.plan(world);
        }
        if let (Some(grounds), false) = (&mut self.grounds, changes.restarts_all()) {
            let before = grounds.rays();
            grounds.follow(world, &self.settings, &changes.emitters);
            self.statistics.rays.particle += grounds.rays() - before;
        }
        match (edit, &self.melted) {
            (Edit::Regroup { .. }, None) => self.frame.regroup(&changes.groups),
            // Light that is sorted otherwise is the same.
            (Edit::Regroup { .. }, Some(_)) => {}
            (_, None) => changes.groups.iter().for_each(|group| self.frame.change(*group)),
            (_, Some(_)) if changes.groups.is_empty() => {}
            (_, Some(_)) => self.frame.change(0),
        }
        self.frame.set_mix(&self.mix(world));
    }

    /// All light takes other ways now: all sums begin anew.
    ///
    /// # Errors
    /// [`Error::BadSetting`](crate::Error::BadSetting) where surfaces have grown beyond the elements that there may be.
    pub(super) fn renew(&mut self, world: &World) -> Result<()> {
        self.grounds = Grounds::new(world, &self.settings, integrator::wants(&self.integrators))?;
        self.plan = self.plan(world);
        (0..self.plan.layers()).for_each(|layer| self.frame.change(layer));
        self.frame.forget_first();
        self.frame.set_mix(&self.mix(world));
        self.statistics = begun(self.grounds.as_ref());
        Ok(())
    }

    fn plan(&self, world: &World) -> Plan {
        match &self.melted {
            Some(colors) => Plan::melted(world, &self.settings, colors),
            None => Plan::new(world, &self.settings),
        }
    }

    /// What the layers are multiplied by when they are shown.
    fn mix(&self, world: &World) -> Vec<Rgb> {
        if self.melted.is_some() { vec![Rgb::WHITE] } else { world.mix() }
    }
}

/// What was done before the first batch.
fn begun(grounds: Option<&Grounds>) -> Statistics {
    let rays = Rays { particle: grounds.map_or(0, Grounds::rays), ..Rays::default() };
    Statistics { rays, ..Statistics::default() }
}
