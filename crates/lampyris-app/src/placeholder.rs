//! What the library is about to have, under the names it will have: replaced by `use lampyris::…` when it is there.

#![allow(dead_code, missing_docs, reason = "a stand-in that renders nothing")]

pub(crate) mod backend {
    use super::{eye::Eye, frame::Frame};
    use lampyris::sequence::Sequence;
    use lampyris::{Result, scene::Scene};
    use serde::Serialize;

    #[derive(Clone, Debug)]
    pub(crate) struct Settings {
        pub(crate) parts: Vec<String>,
        pub(crate) paths: u32,
        pub(crate) passes: Option<u32>,
        pub(crate) absorption: Absorption,
        pub(crate) sequence: Sequence,
        pub(crate) clamp: f32,
        pub(crate) replicates: u32,
        pub(crate) seed: u32,
        pub(crate) auxiliary: bool,
    }

    impl Default for Settings {
        fn default() -> Self {
            Settings {
                parts: super::integrator::WHOLE.iter().map(|n| (*n).to_owned()).collect(),
                paths: 64,
                passes: None,
                absorption: Absorption::Fractional,
                sequence: Sequence::default(),
                clamp: 1.0,
                replicates: 4,
                seed: 0,
                auxiliary: false,
            }
        }
    }

    impl Settings {
        pub(crate) fn check(&self) -> Result<()> {
            let known = |p: &String| super::integrator::ALL.iter().any(|i| i.name() == p);
            match self.parts.iter().find(|p| !known(p)) {
                Some(p) => Err(lampyris::Error::BadSetting(format!("no part is called \"{p}\""))),
                None => Ok(()),
            }
        }

        pub(crate) fn eye_passes(&self) -> u32 {
            self.passes.unwrap_or(self.paths)
        }
    }

    #[derive(Clone, Copy, Debug, PartialEq, Eq)]
    pub(crate) enum Absorption {
        Fractional,
        Paper,
        Roulette,
    }

    impl Absorption {
        pub(crate) const ALL: &[(&'static str, Absorption)] = &[
            ("fractional", Absorption::Fractional),
            ("paper", Absorption::Paper),
            ("roulette", Absorption::Roulette),
        ];
    }

    pub(crate) struct Batch {
        pub(crate) index: u32,
    }

    #[derive(Clone, Copy, Debug, Default, Serialize)]
    pub(crate) struct Statistics {
        pub(crate) rays: Rays,
        pub(crate) vpls: u64,
        pub(crate) non_finite: u64,
    }

    #[derive(Clone, Copy, Debug, Default, Serialize)]
    pub(crate) struct Rays {
        pub(crate) eye: u64,
        pub(crate) particle: u64,
        pub(crate) shadow: u64,
        pub(crate) compensation: u64,
        pub(crate) path: u64,
    }

    pub(crate) trait Backend {
        fn begin(&mut self, scene: Scene, eye: Eye, settings: &Settings) -> Result<()>;
        fn add(&mut self, batch: Batch) -> Result<()>;
        fn frame(&mut self) -> Result<&Frame>;
        fn statistics(&self) -> Statistics;
    }
}

pub(crate) mod eye {
    use glam::Vec3;
    use lampyris::scene::View;

    pub(crate) enum Eye {
        Camera(View),
        Meters(Vec<Meter>),
    }

    #[derive(Clone, Copy, Debug, PartialEq)]
    pub(crate) struct Meter {
        pub(crate) position: Vec3,
        pub(crate) normal: Vec3,
    }
}

pub(crate) mod frame {
    use lampyris::Rgb;

    #[derive(Default)]
    pub(crate) struct Frame {
        pub(crate) width: u32,
        pub(crate) height: u32,
    }

    pub(crate) struct Auxiliary {
        pub(crate) albedo: Vec<Rgb>,
        pub(crate) normal: Vec<Rgb>,
        pub(crate) depth: Vec<f32>,
        pub(crate) object: Vec<u32>,
        pub(crate) samples: u32,
    }

    impl Frame {
        pub(crate) fn batches(&self) -> u32 {
            0
        }

        pub(crate) fn part_names(&self) -> impl Iterator<Item = &str> {
            std::iter::empty()
        }

        pub(crate) fn part(&self, _: &str) -> Option<Vec<Rgb>> {
            None
        }

        pub(crate) fn mean(&self) -> Vec<Rgb> {
            Vec::new()
        }

        pub(crate) fn standard_error(&self, _: usize) -> f32 {
            f32::INFINITY
        }

        pub(crate) fn relative_error(&self) -> f32 {
            f32::INFINITY
        }

        pub(crate) fn student_factor(&self) -> f32 {
            f32::INFINITY
        }

        pub(crate) fn auxiliary(&self) -> Option<&Auxiliary> {
            None
        }
    }
}

pub(crate) mod cpu {
    use super::backend::{Backend, Batch, Settings, Statistics};
    use super::{eye::Eye, frame::Frame};
    use lampyris::{Error, Result, scene::Scene};

    pub(crate) struct Cpu(Frame);

    impl Cpu {
        pub(crate) fn new(_: Option<usize>) -> Result<Cpu> {
            Ok(Cpu(Frame::default()))
        }
    }

    impl Backend for Cpu {
        fn begin(&mut self, _: Scene, _: Eye, _: &Settings) -> Result<()> {
            Err(Error::BadSetting("this build cannot render yet".into()))
        }

        fn add(&mut self, _: Batch) -> Result<()> {
            Ok(())
        }

        fn frame(&mut self) -> Result<&Frame> {
            Ok(&self.0)
        }

        fn statistics(&self) -> Statistics {
            Statistics::default()
        }
    }
}

pub(crate) mod integrator {
    pub(crate) struct Row(&'static str, &'static str);

    impl Row {
        pub(crate) fn name(&self) -> &'static str {
            self.0
        }

        pub(crate) fn paths(&self) -> &'static str {
            self.1
        }
    }

    pub(crate) static ALL: &[&Row] = &[
        &Row("emission", "LS*E"),
        &Row("direct", "LDS*E"),
        &Row("vpl", "LD+DS*E"),
        &Row("compensation", "LD+DS*E, near"),
        &Row("caustic", "L(S|D)*S+DS*E"),
        &Row("path", "L(S|D)*E"),
    ];

    pub(crate) const WHOLE: &[&str] = &["emission", "direct", "vpl", "compensation", "caustic"];
}

pub(crate) mod world {
    use lampyris::geometry::{Hit, Ray};
    use lampyris::scene::Scene;

    pub(crate) struct World;

    impl World {
        pub(crate) fn new(_: Scene) -> World {
            World
        }

        pub(crate) fn tracer(&self) -> &World {
            self
        }

        pub(crate) fn closest(&self, _: &Ray) -> Option<Hit> {
            None
        }
    }
}
