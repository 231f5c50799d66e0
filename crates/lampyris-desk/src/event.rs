//! What happens at a desk: all that other threads tell it comes by one inbox.

use crate::door::Role;
use crate::model::Model;
use crate::wire::{Look, Message};
use glam::Vec3;
use lampyris::Rgb;
use lampyris::cpu::Answer;
use lampyris::document;
use lampyris::measuring::Estimate;
use lampyris::scene::{Camera, Scene};
use serde_json::Value;
use std::sync::mpsc::{self, Receiver, Sender};

/// What happens at a desk.
pub(crate) enum Event {
    /// The scene is there.
    Opened {
        model: Box<Model>,
        scene: Box<Scene>,
        look: Look,
        warnings: Vec<String>,
    },
    Joined {
        client: u64,
        role: Role,
    },
    Left {
        client: u64,
    },
    Said {
        client: u64,
        message: Message,
    },
    Progress(Progress),
    Found {
        client: u64,
        id: u32,
        found: Option<Found>,
    },
    /// An exposure was metered.
    Metered {
        ev: f32,
    },
    /// What is known of what lights a point.
    Lit {
        client: u64,
        id: u32,
        answer: Answer,
        done: bool,
    },
    /// What the meters read.
    Measured {
        readings: Vec<Estimate>,
        /// Of each layer in white, the radiance of what it gives each of them, matt and white [cd/m²].
        by_layer: Vec<Vec<Rgb>>,
        /// They have all the batches that meters get.
        done: bool,
    },
    /// The scene's file is another one, and was read.
    Changed(Box<Opened>),
    /// It is another one, and cannot be read.
    Broken {
        why: String,
    },
    /// The edits were made in the scene that was read again, but for some.
    Reloaded {
        lost: Vec<String>,
    },
    /// A picture to keep was made, of that name, or was not.
    Made {
        client: u64,
        id: u32,
        done: Result<String, String>,
    },
    /// Edits were written down, or could not be.
    Saved {
        saved: Value,
        /// How many times of saving that was the last of.
        times: u32,
    },
    /// Nothing happened for a while.
    Idle,
    /// The renderer did not follow an edit.
    Refused {
        why: String,
    },
    /// The program shall end.
    End,
}

/// Where events go.
#[derive(Clone)]
pub(crate) struct Inbox(Sender<Event>);

impl Inbox {
    pub(crate) fn new() -> (Inbox, Receiver<Event>) {
        let (send, receive) = mpsc::channel();
        (Inbox(send), receive)
    }

    /// Nobody listens any more once the program ends.
    pub(crate) fn put(&self, event: Event) {
        let _ = self.0.send(event);
    }
}

/// A scene to open, and how.
pub struct Opened {
    /// The scene, and what was edited in it before.
    pub document: document::Opened,
    /// From where to look, if the arguments say so.
    pub camera: Option<Camera>,
}

/// How far a picture is.
#[derive(Clone, Debug)]
pub(crate) struct Progress {
    pub(crate) stage: &'static str,
    pub(crate) batches: u32,
    /// Half the relative 95 % interval of the mean.
    pub(crate) error: f32,
    pub(crate) good_in: Option<f32>,
    pub(crate) fps: f32,
    pub(crate) size: [u32; 2],
    pub(crate) layers: Vec<(u32, u32, bool)>,
}

/// What lies behind a pixel.
pub(crate) struct Found {
    pub(crate) point: Vec3,
    pub(crate) normal: Vec3,
    pub(crate) instance: u32,
    pub(crate) material: u32,
    pub(crate) emitter: Option<u32>,
    /// What it reflects, where that tells what it receives [lx], as far as the picture tells, and what it sends to the eye [cd/m²], each with its 95 % error.
    pub(crate) albedo: Option<Rgb>,
    pub(crate) lux: Option<Estimate>,
    pub(crate) luminance: Option<Estimate>,
    /// How much more it receives than in the look that is compared with [lx].
    pub(crate) change: Option<f64>,
}
