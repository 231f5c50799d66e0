//! From light to the bytes of a frame, on a thread of its own: while the next batch is traced, a fader that is moved is
//! seen. Of what is to be shown only the latest is.

use crate::handled::{self, Kept};
use crate::hub::{CameraText, Hub, Shown};
use crate::legend::{self, Legend, Quantity};
use crate::wire::{Head, Kind};
use jpeg_encoder::{ColorType, SamplingFactor};
use lampyris::Rgb;
use lampyris::frame::Still;
use lampyris::output::{Display, Exposure, Picture, ToneCurve, display};
use std::collections::VecDeque;
use std::sync::{Arc, Condvar, Mutex, MutexGuard, PoisonError};
use std::time::{Duration, Instant};

/// The light of a picture, before it is mixed.
#[derive(Clone, Default)]
pub(crate) struct Light {
    pub(crate) size: [u32; 2],
    pub(crate) still: Option<Arc<Still>>,
    /// What the surfaces behind the pixels reflect, where that tells what they receive.
    pub(crate) albedos: Option<Arc<Vec<Rgb>>>,
    /// What clamping takes of it, in fewer pixels.
    pub(crate) clamped: Option<Arc<Still>>,
    pub(crate) camera: Arc<CameraText>,
    pub(crate) look: Option<Arc<crate::wire::Look>>,
    pub(crate) batches: u32,
    pub(crate) error: f32,
    pub(crate) kind: Option<Kind>,
    /// The light of all groups is in one layer, in the colours that it was drawn in.
    pub(crate) melted: bool,
    /// The last message of the editor that asked for rays and is in it.
    pub(crate) seq: u32,
    /// How long it took [s].
    pub(crate) seconds: f32,
}

/// How it is shown.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Show {
    /// `None` until it was metered.
    pub(crate) ev: Option<f32>,
    pub(crate) tone: ToneCurve,
    /// What each channel is multiplied by.
    pub(crate) white: Rgb,
    pub(crate) legend: Option<Arc<Legend>>,
}

impl Default for Show {
    fn default() -> Self {
        Show { ev: None, tone: ToneCurve::default(), white: Rgb::WHITE, legend: None }
    }
}

#[derive(Default)]
struct Wanted {
    light: Light,
    /// Level and colour of each layer, and those from which they are faded to.
    colors: Vec<Rgb>,
    fade: Option<Fade>,
    /// Those of what is compared with, if something is.
    against: Option<Vec<Rgb>>,
    /// When levels changed last: as long as a hand moves them, frames are made quickly rather than well.
    handled: Option<Instant>,
    show: Show,
    /// The last message of the editor that was applied, and the last that asked for rays.
    seq: u32,
    traced: u32,
    changed: bool,
    ended: bool,
    frames: VecDeque<(u32, Frame)>,
    number: u32,
}

/// From one mix to another.
struct Fade {
    from: Vec<Rgb>,
    began: Instant,
    lasts: Duration,
}

impl Wanted {
    /// The mix at this moment, and whether it is still another one than it will be.
    fn mix(&mut self) -> (Vec<Rgb>, bool) {
        let Some(fade) = &self.fade else { return (self.colors.clone(), false) };
        let passed = fade.began.elapsed().as_secs_f32() / fade.lasts.as_secs_f32().max(1e-3);
        if passed >= 1.0 {
            self.fade = None;
            return (self.colors.clone(), false);
        }
        let between = |(to, from): (&Rgb, &Rgb)| *from * (1.0 - passed) + *to * passed;
        let pairs = self.colors.iter().zip(fade.from.iter().chain(self.colors.iter().skip(fade.from.len())));
        (pairs.map(between).collect(), true)
    }
}

/// A frame that somebody may still ask about.
#[derive(Clone)]
pub(crate) struct Frame {
    pub(crate) look: Arc<crate::wire::Look>,
    pub(crate) size: [u32; 2],
}

/// How long hands must rest until frames are made well again.
const REST: Duration = Duration::from_millis(200);

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

    /// All that asked for rays until that message was followed, and none of it changes what is shown.
    pub(crate) fn reached(&self, seq: u32) {
        if self.wanted().light.seq < seq {
            self.change(|wanted| wanted.light.seq = seq);
        }
    }

    /// It is shown otherwise.
    pub(crate) fn show(&self, show: Show) {
        self.change(|wanted| wanted.show = show);
    }

    /// The layers have other levels and colours, faded to in so many seconds, and are compared with others.
    pub(crate) fn mix(&self, colors: Vec<Rgb>, against: Option<Vec<Rgb>>, seconds: f32) {
        self.change(|wanted| {
            let (from, _) = wanted.mix();
            let lasts = Duration::from_secs_f32(seconds.clamp(0.0, 3600.0));
            wanted.handled = Some(Instant::now());
            wanted.fade = (seconds > 0.0).then(|| Fade { from, began: Instant::now(), lasts });
            (wanted.colors, wanted.against) = (colors, against);
        });
    }

    /// The editor's message of that number was applied; some ask for rays.
    pub(crate) fn applied(&self, seq: u32, traced: bool) {
        self.change(|wanted| {
            wanted.seq = seq;
            wanted.traced = if traced { seq } else { wanted.traced };
        });
    }

    /// What is shown if it is no sketch and has all that was asked for, and what it is.
    pub(crate) fn settled(&self) -> Option<(Arc<Still>, Kind)> {
        let wanted = self.wanted();
        let kind =
            wanted.light.kind.filter(|kind| *kind != Kind::Moving && wanted.light.seq >= wanted.traced);
        wanted.light.still.clone().zip(kind)
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
        let mut kept = Kept::default();
        loop {
            let mut wanted = self.wanted();
            while !wanted.changed && !wanted.ended {
                wanted = match wanted.handled.map(|at| REST.saturating_sub(at.elapsed())) {
                    // What was made quickly is made well.
                    Some(Duration::ZERO) => break,
                    Some(left) => {
                        self.wake.wait_timeout(wanted, left).unwrap_or_else(PoisonError::into_inner).0
                    }
                    None => self.wake.wait(wanted).unwrap_or_else(PoisonError::into_inner),
                };
            }
            if wanted.ended {
                return;
            }
            let handled = wanted.handled.is_some_and(|at| at.elapsed() < REST);
            if !handled {
                wanted.handled = None;
                kept = Kept::default();
            }
            let (colors, fading) = wanted.mix();
            wanted.changed = fading;
            let (light, mut show) = (wanted.light.clone(), wanted.show.clone());
            let against = wanted.against.clone();
            // What has no layers can be compared with nothing; soon there is light that has some.
            if light.melted && show.legend.as_ref().is_some_and(|legend| legend.against().is_some()) {
                wanted.changed = false;
                continue;
            }
            let (Some(kind), Some(look), Some(still)) = (light.kind, light.look.clone(), light.still.clone())
            else {
                wanted.changed = false;
                continue;
            };
            let kind = if handled { Kind::Moving } else { kind };
            let quick = handled && show.legend.is_none() && !light.melted;
            let asks = |quantity| show.legend.as_ref().is_some_and(|legend| legend.quantity == quantity);
            let clamped = light.clamped.as_ref().filter(|_| asks(Quantity::Clamped));
            let size = match (quick, clamped) {
                (true, _) => handled::size(light.size),
                (_, Some(clamped)) => clamped.size(),
                _ => light.size,
            };
            // What asked for rays and is not there yet holds back the number of what came after.
            let seq = if light.seq >= wanted.traced && !light.melted { wanted.seq } else { light.seq };
            wanted.number += 1;
            let number = wanted.number;
            wanted.frames.push_back((number, Frame { look, size }));
            if wanted.frames.len() > ASKED {
                wanted.frames.pop_front();
            }
            drop(wanted);
            let begun = Instant::now();
            let radiance = match (quick, light.melted) {
                (_, true) => still.mix(&[]),
                (true, _) => kept.mix(&still, &colors),
                (false, _) if size != light.size => still.small(&colors, size),
                (false, _) => still.mix(&colors),
            };
            if show.ev.is_none() {
                let ev = Exposure::Auto.ev(&radiance);
                show.ev = Some(ev);
                self.wanted().show.ev = Some(ev);
                metered(ev);
            }
            let painted = show.legend.as_ref().and_then(|legend| {
                let against = legend.against().and(against).map(|colors| still.mix(&colors));
                let clamped = clamped.map(|still| still.mix(&colors));
                let albedos = light.albedos.as_ref().map(|own| own.as_slice());
                let (against, clamped) = (against.as_deref(), clamped.as_deref());
                legend.paint(&legend::Picture { radiance: &radiance, against, albedos, clamped, size })
            });
            let false_color = painted.is_some();
            let picture = match painted {
                Some(painted) => painted.png().ok(),
                None => encode(radiance, size, &show, kind),
            };
            let Some(picture) = picture else { continue };
            let lossless = kind == Kind::Final || false_color;
            let head = Head {
                number,
                seq,
                camera: light.camera.number,
                size,
                kind,
                lossless,
                false_color,
                batches: light.batches,
                error: light.error,
                light: light.seconds,
                bytes: begun.elapsed().as_secs_f32(),
            };
            let bytes = [&head.write()[..], &picture].concat();
            hub.show(Shown { bytes: bytes.into(), camera: light.camera });
            // A fade is not shown more often than a display shows it.
            if fading {
                std::thread::sleep(Duration::from_millis(25).saturating_sub(begun.elapsed()));
            }
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
pub(crate) fn encode(
    mut radiance: Vec<Rgb>,
    [width, height]: [u32; 2],
    show: &Show,
    kind: Kind,
) -> Option<Vec<u8>> {
    if show.white != Rgb::WHITE {
        radiance.iter_mut().for_each(|c| *c *= show.white);
    }
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
