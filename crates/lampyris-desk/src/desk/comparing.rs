//! Compares what is with a look: in false colour of what surfaces receive more or less, and at each meter. Both are mixes of
//! the same layers; lamps that differ in one of them have layers of their own as long as they are compared, if there are
//! enough.

use super::{Desk, SOON};
use crate::mixer;
use crate::model::{Model, Touched};
use crate::state;
use crate::studio::Survey;
use lampyris::Rgb;
use lampyris::measuring::Estimate;
use lampyris::scene::Edit;
use serde_json::{Value, json};
use std::f32::consts::PI;

impl Desk {
    /// The lamps as in the look that is compared with.
    pub(super) fn compared(&self) -> Option<Model> {
        self.as_in(self.show.legend.as_ref()?.against()?)
    }

    /// What the layers have in that look, as far as they are shown, and whether it is that to the bit.
    pub(super) fn against(&self) -> Option<(Vec<Rgb>, bool)> {
        let (colors, exact) = self.colors_in(self.show.legend.as_ref()?.against()?)?;
        Some((self.soloed(colors), exact))
    }

    /// Shows the layers in the colours that they have by a message, faded to in so many seconds, and compared with those of a
    /// look, if one is compared with.
    pub(super) fn mix(&mut self, seq: u32, seconds: f32) {
        let colors = self.colors();
        self.studio.mix(colors.clone(), seq);
        let (against, exact) = self.against().map_or((None, true), |(colors, exact)| (Some(colors), exact));
        self.screen.mix(colors, against, seconds);
        if std::mem::replace(&mut self.exact, exact) != exact {
            self.tell_patch(json!({"display": self.display()}));
        }
    }

    /// The edits that bring the layers to what the model wants of them; of what is compared with as far as there are layers
    /// for it.
    pub(super) fn sorted(&mut self) -> Result<Vec<Edit>, String> {
        let against = self.compared();
        let Some(scene) = &mut self.scene else { return Err("the scene is not there yet".into()) };
        match against.map(|against| mixer::mix(&self.model, Some(&against), scene)) {
            Some(Ok(edits)) => Ok(edits),
            _ => mixer::mix(&self.model, None, scene),
        }
    }

    /// Something else is compared with: lamps are sorted so that both can be shown. Returns whether that asks for rays.
    pub(super) fn sort_to_compare(&mut self, seq: u32) -> Result<bool, String> {
        let edits = self.sorted()?;
        let Some(scene) = self.scene.as_ref().filter(|_| !edits.is_empty()) else { return Ok(false) };
        let lamps = (0..self.model.lamps.len() as u32).collect();
        let patch = state::of(&self.model, scene, &Touched { lamps, ..Touched::default() });
        self.studio.edit(edits, seq);
        self.tell_patch_of(seq, patch);
        self.save_in(SOON);
        Ok(true)
    }

    /// A look that is gone is not compared with.
    pub(super) fn end_comparison_with_nothing(&mut self) {
        let against = self.show.legend.as_ref().and_then(|legend| legend.against());
        if against.is_some_and(|look| self.as_in(look).is_none()) {
            self.show.legend = None;
            self.studio.survey(Survey::default(), self.seq);
            self.screen.show(self.show.clone());
            self.tell_patch(json!({"display": self.display()}));
        }
    }

    /// What meters and areas read now and by how much that is more than in the look, if one is compared with.
    pub(super) fn read_meters(&mut self) {
        self.told = self.layout.told(&self.readings, self.measured);
        let Some((then, _)) = self.against() else { return };
        // From the same sums, so that equal mixes differ by nothing.
        let [now, then] =
            [self.colors(), then].map(|colors| self.layout.told(&self.read_in(&colors), self.measured));
        let lux = |told: &Value| told["lux"][0].as_f64().or(told["mean"].as_f64());
        for slice in ["meters", "grids"] {
            for (id, told) in self.told[slice].as_object_mut().into_iter().flatten() {
                let change = lux(&now[slice][id]).zip(lux(&then[slice][id])).map(|(now, then)| now - then);
                told["change"] = json!(change);
            }
        }
    }

    /// What each point reads if the layers have these colours.
    fn read_in(&self, colors: &[Rgb]) -> Vec<Estimate> {
        let points = self.by_layer.first().map_or(0, Vec::len);
        let lux = |point: usize| {
            let of = |(layer, color): (&Vec<Rgb>, &Rgb)| f64::from((layer[point] * *color).luminance() * PI);
            self.by_layer.iter().zip(colors).map(of).sum::<f64>()
        };
        (0..points).map(|point| Estimate { value: lux(point), error: None }).collect()
    }
}
