//! From light to the bytes of a frame, on a thread of its own: while the next batch is traced, a fader that is moved is
//! seen. Of what is to be shown only the latest is.

use crate::hub::{CameraText, Hub, Shown};
use crate::wire::{Head, Kind};
use jpeg_encoder::{ColorType, SamplingFactor};
use lampyris::Rgb;
use lampyris::output::{Display, Exposure, Picture, ToneCurve, display};
use std::collections::VecDeque;
use std::sync::{Arc, Condvar, Mutex, MutexGuard, PoisonError};
use std::time::Instant;

/// The light of a picture, before it is mixed.
#[derive(Clone, Default)]
pub(crate) struct Light {
    pub(crate) size: [u32; 2],
    pub(crate) radiance: Arc<Vec<Rgb>>,
    pub(crate) camera: Arc<CameraText>,
    pub(crate) look: Option<Arc<crate::wire::Look>>,
    pub(crate) batches: u32,
    pub(crate) error: f32,
    pub(crate) kind: Option<Kind>,
    /// The last message of the editor that asked for rays and is in it.
    pub(crate) seq: u32,
    /// How long it took [s].
    pub(crate) seconds: f32,
}

/// How it is shown.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Show {
    /// `None` until it was metered.
    pub(crate) ev: Option<f32>,
    pub(crate) tone: ToneCurve,
    /// What each channel is multiplied by.
    pub(crate) white: Rgb,
}

impl Default for Show {
    fn default() -> Self {
        Show { ev: None, tone: ToneCurve::default(), white: Rgb::WHITE }
    }
}

#[derive(Default)]
struct Wanted {
    light: Light,
    show: Show,
    /// The last message of the editor that was applied, and the last that asked for rays.
    seq: u32,
    traced: u32,
    changed: bool,
    ended: bool,
    frames: VecDeque<(u32, Frame)>,
    number: u32,
}

/// A frame that somebody may still ask about.
#[derive(Clone)]
pub(crate) struct Frame {
    pub(crate) look: Arc<crate::wire::Look>,
    pub(crate) size: [u32; 2],
}

/// Frames that can be asked about.
const ASKED: usize = 64;

/// The screen.
pub(crate) struct Screen {
    wanted: Mutex<Wanted>,
    wake: Condvar,
}

impl Screen {
    pub(crate) fn new() -> Screen {
        Screen { wanted: Mutex::default(), wake: Condvar::new() }
    }

    /// New light is there.
    pub(crate) fn light(&self, light: Light) {
        self.change(|wanted| wanted.light = light);
    }

    /// It is shown otherwise.
    pub(crate) fn show(&self, show: Show) {
        self.change(|wanted| wanted.show = show);
    }

    /// The editor's message of that number was applied; some ask for rays.
    pub(crate) fn applied(&self, seq: u32, traced: bool) {
        self.change(|wanted| {
            wanted.seq = seq;
            wanted.traced = if traced { seq } else { wanted.traced };
        });
    }

    /// How it is shown, once it was metered.
    pub(crate) fn shown(&self) -> Show {
        self.wanted().show
    }

    /// The camera and size of a frame that was shown.
    pub(crate) fn frame(&self, number: u32) -> Option<Frame> {
        self.wanted().frames.iter().find(|(own, _)| *own == number).map(|(_, frame)| frame.clone())
    }

    pub(crate) fn end(&self) {
        self.change(|wanted| wanted.ended = true);
    }

    /// Makes frames until the end; `metered` is told of an exposure that was found.
    pub(crate) fn run(&self, hub: &Hub, metered: impl Fn(f32)) {
        loop {
            let mut wanted = self.wanted();
            while !wanted.changed && !wanted.ended {
                wanted = self.wake.wait(wanted).unwrap_or_else(PoisonError::into_inner);
            }
            if wanted.ended {
                return;
            }
            wanted.changed = false;
            let (light, mut show) = (wanted.light.clone(), wanted.show);
            let Some((kind, look)) = light.kind.zip(light.look.clone()) else { continue };
            // What asked for rays and is not there yet holds back the number of what came after.
            let seq = if light.seq >= wanted.traced { wanted.seq } else { light.seq };
            wanted.number += 1;
            let number = wanted.number;
            wanted.frames.push_back((number, Frame { look, size: light.size }));
            if wanted.frames.len() > ASKED {
                wanted.frames.pop_front();
            }
            drop(wanted);
            let begun = Instant::now();
            if show.ev.is_none() {
                let ev = Exposure::Auto.ev(&light.radiance);
                show.ev = Some(ev);
                self.wanted().show.ev = Some(ev);
                metered(ev);
            }
            let Some(picture) = encode(&light, &show, kind) else { continue };
            let lossless = kind == Kind::Final;
            let head = Head {
                number,
                seq,
                camera: light.camera.number,
                size: light.size,
                kind,
                lossless,
                false_color: false,
                batches: light.batches,
                error: light.error,
                light: light.seconds,
                bytes: begun.elapsed().as_secs_f32(),
            };
            let bytes = [&head.write()[..], &picture].concat();
            hub.show(Shown { bytes, number, camera: light.camera });
        }
    }

    fn change(&self, change: impl FnOnce(&mut Wanted)) {
        let mut wanted = self.wanted();
        change(&mut wanted);
        wanted.changed = true;
        self.wake.notify_one();
    }

    fn wanted(&self) -> MutexGuard<'_, Wanted> {
        self.wanted.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

/// JPEG while it is not final, then PNG.
fn encode(light: &Light, show: &Show, kind: Kind) -> Option<Vec<u8>> {
    let [width, height] = light.size;
    let radiance = match show.white == Rgb::WHITE {
        true => light.radiance.to_vec(),
        false => light.radiance.iter().map(|c| *c * show.white).collect(),
    };
    let options = Display {
        exposure: Exposure::Ev(show.ev.unwrap_or(0.0)),
        tone: Some(show.tone),
        despeckle: kind != Kind::Moving,
    };
    let pixels = display(&Picture::new(width, height, radiance), &options);
    let pixels = pixels.as_flattened();
    let mut bytes = Vec::new();
    let (quality, sampling) = match kind {
        Kind::Moving => (80, SamplingFactor::R_4_2_0),
        Kind::Settled => (92, SamplingFactor::R_4_4_4),
        Kind::Final => {
            let mut encoder = png::Encoder::new(&mut bytes, width, height);
            encoder.set_color(png::ColorType::Rgb);
            encoder.set_compression(png::Compression::Fast);
            encoder.write_header().ok()?.write_image_data(pixels).ok()?;
            return Some(bytes);
        }
    };
    let mut encoder = jpeg_encoder::Encoder::new(&mut bytes, quality);
    encoder.set_sampling_factor(sampling);
    encoder.encode(pixels, width as u16, height as u16, ColorType::Rgb).ok()?;
    Some(bytes)
}
