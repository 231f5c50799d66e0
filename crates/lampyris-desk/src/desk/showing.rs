//! How the picture is shown: exposure, tone curve, white, false colour. None of it is an edit.

use super::Desk;
use crate::legend::Legend;
use crate::screen::Show;
use crate::state;
use crate::studio::Survey;
use lampyris::output::ToneCurve;
use serde_json::{Value, json};
use std::sync::Arc;

impl Desk {
    /// Shows the picture as a patch of `display` says, or says why not. Returns whether it asks for rays.
    pub(super) fn display_as(&mut self, seq: u32, patch: &Value) -> Result<bool, String> {
        let mut show = self.show.clone();
        if let Some(ev) = patch.get("ev") {
            let ev =
                ev.as_f64().filter(|ev| ev.abs() <= 60.0).ok_or("an exposure lies between -60 and 60")?;
            show.ev = Some(ev as f32);
        }
        if let Some(tone) = patch.get("tone") {
            show.tone = tone.as_str().and_then(ToneCurve::from_name).ok_or("there is no such tone curve")?;
        }
        if let Some(white) = patch.get("white") {
            show.white = state::white(white)?;
        }
        if let Some(legend) = patch.get("false_color") {
            show.legend = Legend::read(legend)?.map(Arc::new);
            let against = show.legend.as_ref().and_then(|legend| legend.against());
            if against.is_some_and(|look| self.as_in(look).is_none()) {
                return Err("there is no such look".into());
            }
        }
        if let Some(white) = patch.get("white") {
            self.white = white.clone();
        }
        if patch.get("ev").is_some() {
            self.metered = false;
        }
        // Light that tells of surfaces is not there yet.
        let [survey, before] = [&show, &self.show].map(|show| Survey::of(show.legend.as_deref()));
        let mut traced = survey.surfaces && !before.surfaces;
        if survey != before {
            self.studio.survey(survey, seq);
        }
        let against = |show: &Show| show.legend.as_ref().and_then(|legend| legend.against());
        let compares = against(&show) != against(&self.show);
        self.show = show.clone();
        self.screen.show(show);
        if compares {
            traced |= self.sort_to_compare(seq)?;
            self.mix(seq, 0.0);
            self.read_meters();
            self.tell_readings();
        }
        self.tell_patch_of(seq, json!({"display": self.display()}));
        Ok(traced)
    }
}
