//! Sets the mix so that meters reach their targets: what each layer gives each meter is known, and light adds up.

use super::Desk;
use crate::patch::{LampPatch, Patch};
use lampyris::Rgb;
use lampyris::measuring::Fit;
use std::collections::BTreeMap;
use std::f32::consts::PI;

/// How strongly levels stay as they are where meters do not care.
const PULL: f64 = 1e-3;

impl Desk {
    /// Levels up to `full` of each lamp's flux by which the meters that have a target come nearest to it once so much of their
    /// light is left; one that is higher already may stay.
    pub(super) fn reach(&mut self, seq: u32, full: f32, maintenance: f64) -> Result<bool, String> {
        let given = self.by_layer.iter().zip(self.colors_of_scene());
        let lux = |(layer, color): (&Vec<Rgb>, Rgb)| {
            layer.iter().map(|white| f64::from((*white * color).luminance() * PI)).collect()
        };
        let by_layer: Vec<Vec<f64>> = given.map(lux).collect();
        let (rows, mut targets) = self.layout.wanted(&self.model.notes, &by_layer, &self.readings);
        targets.iter_mut().for_each(|target| *target /= maintenance);
        if targets.is_empty() {
            return Err("no meter and no area has a target, or they are not measured yet".into());
        }
        let scene = self.scene.as_ref().ok_or("the scene is not there yet")?;
        let layers = by_layer.len();
        let mut lamps: BTreeMap<usize, Vec<u32>> = BTreeMap::new();
        for (id, lamp) in (0..).zip(&self.model.lamps).filter(|(_, lamp)| !lamp.gone && lamp.on) {
            let share = lamp.emitters.first().and_then(|(k, _)| scene.reference.shares.get(*k as usize));
            if let Some(share) = share.filter(|share| usize::from(share.group) < layers) {
                lamps.entry(share.group.into()).or_default().push(id);
            }
        }
        let level = |layer: usize| {
            let own = lamps.get(&layer).into_iter().flatten().map(|id| self.model.lamps[*id as usize].level);
            own.fold(0.0, f32::max)
        };
        // In units of what each layer gives now; lamps that are dark stay so, since nothing is known of them.
        let most = |layer: usize| match level(layer) {
            0.0 => 1.0,
            level => f64::from((full / level).max(1.0)),
        };
        let fit = Fit {
            rows,
            targets,
            present: vec![1.0; layers],
            most: (0..layers).map(most).collect(),
            pull: PULL,
        };
        let factors = fit.solve().map_err(|e| e.to_string())?;
        let mut patch = Patch::default();
        for (layer, ids) in &lamps {
            for id in ids {
                let level = self.model.lamps[*id as usize].level * factors[*layer] as f32;
                let level = LampPatch { level: Some(level), ..LampPatch::default() };
                patch.lamps.insert(*id, level);
            }
        }
        self.in_gesture(seq, "Reach the targets", |desk| desk.edit(seq, patch, 0.0))
    }
}
