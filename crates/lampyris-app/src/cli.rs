//! The arguments, as their help describes them.

use crate::parse;
use crate::play::script::WINDOW;
use clap::{Args, Parser, Subcommand};
use glam::Vec3;
use lampyris::backend::Gather;
use lampyris::output::{Display, Exposure, ToneCurve};
use std::net::IpAddr;
use std::path::PathBuf;
use std::time::Duration;

const AFTER: &str = "\
Exit codes: 0 done, 2 usage, 3 bad input, 4 output failed, 5 over a limit, 130 after Ctrl-C.
Results go to standard output, everything else to standard error.";

const RENDER_EXAMPLES: &str = "\
Examples:
  lampyris render room.mgf
      a picture room.png from a view that the program finds
  lampyris render room.mgf -o room.exr -o room.png --size 1280x960 --time 60
      the best picture of one minute, as light and as a display shows it
  lampyris render room.mgf -o direct.exr --parts direct --batches 4 --aov --json
      direct light alone with all further layers, and a report for a script
  lampyris render room.mgf --eye 1,2,1.6 --target 4,2,1.2 --up 0,0,1 --fov 60

The picture is in cd/m². OpenEXR holds just that; PNG shows it through --exposure and
--tone, HDR through --exposure and, if given, --tone. Ctrl-C writes what is there, a second Ctrl-C ends at once.";

const PLAY_EXAMPLES: &str = "\
Examples:
  lampyris play walk.json -o frame_%04d.png
      a picture for each frame, of the scene that the script names
  lampyris play walk.json room.mgf -o walk.y4m --settle 4
      a film of another scene, four batches a frame
  lampyris play walk.json --flicker 64 --json
      how much it flickers, against frames of 64 batches

A script is JSON, described in docs/formats.md: {\"scene\": \"room.mgf\", \"frames\": 60, \"camera\":
[{\"frame\": 0, \"eye\": [1, 2, 1.6], \"target\": [4, 2, 1.2]}, …], \"lights\": …, \"objects\": …}.
Ctrl-C ends after the frame at hand and keeps those that are written.";

const MEASURE_EXAMPLES: &str = "\
Examples:
  lampyris measure room.mgf --points desk.txt
  lampyris measure room.mgf --points desk.txt --batches 64 --json

Each line of the file is a meter: x y z nx ny nz [m; the normal of the side that measures].
Further columns, empty lines and lines that start with # are ignored. The error is half the
95 % interval, in lux.";

const VIEW_EXAMPLES: &str = "\
Examples:
  lampyris view room.mgf
      prints a link and opens it, where there is a desktop
  lampyris view room.mgf --no-open --port 8080
      on a machine without one: open the link through a tunnel
  lampyris view room.mgf --listen 192.168.1.7 --expose
      for a tablet beside you; what is said is not encrypted

Ctrl-C ends the desk; closing the page does not. The link holds a secret: who has it edits.";

const LAB_EXAMPLES: &str = "\
Examples:
  lampyris lab list
  lampyris lab run all --quick
      a page report/index.html of all experiments, with small settings
  lampyris lab run keller97-figure-8 -o /tmp/report

Experiments that are in the report stay until they are run again. Ctrl-C keeps those that are finished.
Some also measure scenes that do not ship, beneath the folder that LAMPYRIS_SCENES names.";

/// What a frame fixes.
const FRAME_CONFLICTS: [&str; 13] = [
    "parts",
    "paths",
    "batches",
    "spp",
    "interleave",
    "light_points",
    "picks",
    "time",
    "no_compensate",
    "clamp",
    "absorption",
    "sequence",
    "filter",
];

/// A heading of single arguments: one of a whole struct would cover all that follow it.
const LIMITS: &str = "Limits on what a scene may ask for";

/// Global illumination by virtual point lights.
#[derive(Debug, Parser)]
#[command(name = "lampyris", version, after_help = AFTER, subcommand_required = true, arg_required_else_help = true)]
pub(crate) struct Cli {
    #[command(subcommand)]
    pub(crate) command: Command,
}

#[derive(Debug, Subcommand)]
pub(crate) enum Command {
    /// Render a picture of a scene
    #[command(after_help = RENDER_EXAMPLES)]
    Render(Box<RenderArgs>),
    /// Play a script: a walkthrough with camera, lights and objects in motion
    #[command(after_help = PLAY_EXAMPLES)]
    Play(Box<PlayArgs>),
    /// Measure illuminance [lx] at points of a scene
    #[command(after_help = MEASURE_EXAMPLES)]
    Measure(Box<MeasureArgs>),
    /// Open the lighting desk: a page in the browser in which to walk, and to move and dim the lamps
    #[command(after_help = VIEW_EXAMPLES)]
    View(Box<ViewerArgs>),
    /// Measure how fast this machine is
    Bench(BenchArgs),
    /// Repeat the experiments of the papers, and set their figures beside ours
    #[command(after_help = LAB_EXAMPLES)]
    Lab(LabArgs),
    /// Say what is in a scene
    Info(Box<InfoArgs>),
    /// List parts, sequences, formats and tone curves
    List(ListArgs),
    /// Print completions for a shell
    Completions(CompletionsArgs),
}

#[derive(Debug, Args)]
pub(crate) struct RenderArgs {
    #[command(flatten)]
    pub(crate) scene: SceneArgs,
    /// Picture to write, by extension .exr, .png or .hdr; may repeat [default: SCENE.png in the working directory]
    #[arg(short, long = "output", value_name = "FILE")]
    pub(crate) output: Vec<PathBuf>,
    /// Width and height [pixels]
    #[arg(long, value_name = "WxH", default_value = "640x480", value_parser = parse::size)]
    pub(crate) size: (u32, u32),
    #[command(flatten)]
    pub(crate) view: ViewArgs,
    #[command(flatten)]
    pub(crate) estimate: EstimateArgs,
    /// One frame as a session shows it first: one short batch, filtered
    #[arg(long, conflicts_with_all = FRAME_CONFLICTS)]
    pub(crate) frame: bool,
    #[command(flatten)]
    pub(crate) display: DisplayArgs,
    /// Average each batch between neighbours that see the same surface: auto, while the error shows, or off [default: auto;
    /// off where --parts, --paths or --spp say how to estimate]
    #[arg(long, value_name = "auto|off", value_parser = parse::filter)]
    pub(crate) filter: Option<bool>,
    /// Further layers in OpenEXR: direct, indirect, albedo, normal, depth, object
    #[arg(long)]
    pub(crate) aov: bool,
    /// Sum the light of up to N groups of lamps apart, luminaires by their names, then by material: in OpenEXR each has a
    /// layer, which add up to the picture, so that lamps can be dimmed and coloured afterwards
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=64))]
    pub(crate) groups: Option<u32>,
    /// Print a report as one JSON value
    #[arg(long)]
    pub(crate) json: bool,
    /// Say nothing but errors
    #[arg(long)]
    pub(crate) quiet: bool,
}

#[derive(Debug, Args)]
pub(crate) struct PlayArgs {
    /// Script in JSON
    #[arg(value_name = "SCRIPT")]
    pub(crate) script: PathBuf,
    /// Scene file [default: the script's]
    #[arg(value_name = "SCENE")]
    pub(crate) scene: Option<PathBuf>,
    #[command(flatten)]
    pub(crate) reading: ReadingArgs,
    /// Pictures to write, frame_%04d.png or another format, or a film, .y4m, - for standard output; may repeat
    #[arg(short, long = "output", value_name = "FILE", required_unless_present = "flicker")]
    pub(crate) output: Vec<PathBuf>,
    /// Width and height [pixels; default: the script's, or 640x480]
    #[arg(long, value_name = "WxH", value_parser = parse::size)]
    pub(crate) size: Option<(u32, u32)>,
    #[command(flatten)]
    pub(crate) view: ViewArgs,
    /// Batches a frame
    #[arg(long, value_name = "N", default_value_t = 1, value_parser = clap::value_parser!(u32).range(1..=1_000_000))]
    pub(crate) settle: u32,
    /// Show the mean of the last N batches while lights and objects move [default: the script's, or 1]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=i64::from(WINDOW)))]
    pub(crate) window: Option<u32>,
    /// How particles thin out: fractional, paper, roulette
    #[arg(long, value_name = "NAME", default_value = "fractional")]
    pub(crate) absorption: String,
    /// Frames of the workload of `lampyris bench` in its mode wald: every virtual light of a class traced
    #[arg(long)]
    pub(crate) wald: bool,
    /// Also measure flicker, against frames of that many batches
    #[arg(long, value_name = "BATCHES", value_parser = clap::value_parser!(u32).range(1..=1_000_000))]
    pub(crate) flicker: Option<u32>,
    /// Sum the light of up to N groups of lamps apart: a lamp that a track only dims is weighted otherwise, and no light is
    /// rendered anew
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=64))]
    pub(crate) groups: Option<u32>,
    /// Another seed, other pictures of the same mean
    #[arg(long, value_name = "N", default_value_t = 0)]
    pub(crate) seed: u32,
    /// Threads [default: one a core]; the frames do not depend on it
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=4096))]
    pub(crate) threads: Option<u32>,
    #[command(flatten)]
    pub(crate) display: DisplayArgs,
    /// Print a report as one JSON value
    #[arg(long)]
    pub(crate) json: bool,
    /// Say nothing but errors
    #[arg(long)]
    pub(crate) quiet: bool,
}

#[derive(Debug, Args)]
pub(crate) struct ViewerArgs {
    #[command(flatten)]
    pub(crate) scene: SceneArgs,
    /// Address to listen on
    #[arg(long, value_name = "ADDR", default_value = "127.0.0.1")]
    pub(crate) listen: IpAddr,
    /// Port to listen on, 0 for a free one
    #[arg(long, value_name = "N", default_value_t = 0)]
    pub(crate) port: u16,
    /// Listen even where other machines can reach it: what is said is not encrypted, and who reads along learns the links
    #[arg(long)]
    pub(crate) expose: bool,
    /// Do not open the page
    #[arg(long)]
    pub(crate) no_open: bool,
    /// End when the last page is closed
    #[arg(long)]
    pub(crate) exit_with_page: bool,
    /// Width and height of the picture until a page says what it has room for [pixels]
    #[arg(long, value_name = "WxH", default_value = "640x480", value_parser = parse::size)]
    pub(crate) size: (u32, u32),
    #[command(flatten)]
    pub(crate) view: ViewArgs,
    /// Batches after which a picture is finished
    #[arg(long, value_name = "N", default_value_t = 256, value_parser = clap::value_parser!(u32).range(1..=1_000_000))]
    pub(crate) batches: u32,
    /// Threads that render [default: one a core]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=4096))]
    pub(crate) threads: Option<u32>,
    /// Say nothing but the link and errors
    #[arg(long)]
    pub(crate) quiet: bool,
}

/// From light to what a display shows.
#[derive(Debug, Args)]
pub(crate) struct DisplayArgs {
    /// Exposure value of PNG, HDR and films: 100 cd/m² divided by 2^EV is white; auto finds it in the first frame
    #[arg(long, value_name = "EV|auto", default_value = "auto", allow_hyphen_values = true, value_parser = parse::exposure)]
    exposure: Exposure,
    /// Tone curve: linear, reinhard, filmic [default: filmic, linear in HDR]
    #[arg(long, value_name = "NAME", value_parser = parse::tone)]
    tone: Option<ToneCurve>,
    /// Leave single bright speckles in PNG and films, where caustics have not settled
    #[arg(long)]
    no_despeckle: bool,
}

impl DisplayArgs {
    pub(crate) fn display(&self) -> Display {
        Display { exposure: self.exposure, tone: self.tone, despeckle: !self.no_despeckle }
    }
}

/// Where to look from; found by the program where neither scene nor arguments say.
#[derive(Debug, Args)]
pub(crate) struct ViewArgs {
    /// Eye point
    #[arg(long, value_name = "x,y,z", allow_hyphen_values = true, requires = "target", value_parser = parse::vector)]
    pub(crate) eye: Option<Vec3>,
    /// Point looked at
    #[arg(long, value_name = "x,y,z", allow_hyphen_values = true, requires = "eye", value_parser = parse::vector)]
    pub(crate) target: Option<Vec3>,
    /// Upward direction
    #[arg(long, value_name = "x,y,z", allow_hyphen_values = true, value_parser = parse::vector)]
    pub(crate) up: Option<Vec3>,
    /// Vertical field of view
    #[arg(long, value_name = "DEGREES", value_parser = parse::fov)]
    pub(crate) fov: Option<f32>,
    /// Show nothing that is nearer to the eye's plane, as in a section; the light stays that of the whole [m]
    #[arg(long, value_name = "M", value_parser = parse::positive)]
    pub(crate) near: Option<f32>,
    /// A camera of the scene
    #[arg(long, value_name = "NAME", conflicts_with = "eye")]
    pub(crate) camera: Option<String>,
}

/// How the light is estimated.
#[derive(Clone, Debug, Args)]
pub(crate) struct EstimateArgs {
    /// Parts to add up: all, full-solution (that of 1996), path, or names of `lampyris list` separated by commas
    #[arg(long, value_name = "NAMES", default_value = "all", value_delimiter = ',')]
    pub(crate) parts: Vec<String>,
    /// Light paths started in one batch [default: 2400; unfiltered by the picture's size 16 to 64; by the number of meters 64 to 1024]
    #[arg(long, value_name = "N")]
    pub(crate) paths: Option<u32>,
    /// Caustic photons from the lights in one batch, and as many again from where light was reflected [default: 32768]
    #[arg(long, value_name = "N")]
    pub(crate) photons: Option<u32>,
    /// Rays that each point sends out in a batch for the part `final-gather`
    #[arg(long, value_name = "N", default_value_t = Gather::default().rays)]
    pub(crate) gather_rays: u32,
    /// Light paths of the random walk that lights the elements for `final-gather` in a batch
    #[arg(long, value_name = "N", default_value_t = Gather::default().paths)]
    pub(crate) gather_paths: u32,
    /// What these rays look up: the means of surface elements, or what photons bring to surfaces
    #[arg(long, value_name = "elements|photons", default_value = Gather::default().source.name())]
    pub(crate) gather_source: String,
    /// How far photons may lie from what they light for `final-gather`, on gloss or by photons, and `caustic-map` [radii of the scene]
    #[arg(long, value_name = "SHARE", default_value_t = Gather::default().radius)]
    pub(crate) gather_radius: f32,
    /// Glossy surfaces one behind the other for `final-gather`: light is followed to the last, which photons light
    #[arg(long, value_name = "N", default_value_t = Gather::default().levels)]
    pub(crate) gather_levels: u32,
    /// Interpolate irradiance for `final-gather` between points that are known, where surfaces reflect evenly, to this
    /// accuracy: 0.1 is fine, 0.4 coarse [default: gather at every point]
    #[arg(long, value_name = "A")]
    pub(crate) gather_cache: Option<f32>,
    /// Longest edge of an element for `final-gather` [m]
    #[arg(long, value_name = "METRES", default_value_t = Gather::default().element)]
    pub(crate) element: f32,
    /// Batches [default: 32, 8 unfiltered, or as many as --time allows]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..))]
    pub(crate) batches: Option<u32>,
    /// Eye samples a pixel in one batch; the 1997 report takes one a light path [default: one; unfiltered one for 16 paths; one a path for `path`]
    #[arg(long, value_name = "N")]
    pub(crate) spp: Option<u32>,
    /// Pixels that share the light paths of a batch among them, each lit by a class of its own [default: 5x5; unfiltered 1x1]
    #[arg(long, value_name = "NxM", value_parser = parse::size)]
    pub(crate) interleave: Option<(u32, u32)>,
    /// Light points in one batch [default: 50; unfiltered one a light path]
    #[arg(long, value_name = "N")]
    pub(crate) light_points: Option<u32>,
    /// Virtual lights that sixteen pixels pick by what they would give them unshadowed [default: 8; unfiltered all]
    #[arg(long, value_name = "N")]
    pub(crate) picks: Option<u32>,
    /// Segments of the longest paths counted, from the lamp to the eye; a limit takes light away [default: none]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(2..))]
    pub(crate) longest: Option<u32>,
    /// Time from loading to the last batch; writing comes on top, and one batch is always done
    #[arg(long, value_name = "SECONDS", value_parser = parse::seconds)]
    pub(crate) time: Option<Duration>,
    /// Another seed, another picture of the same mean [default: 0]
    #[arg(long, value_name = "N")]
    pub(crate) seed: Option<u32>,
    /// Threads [default: one a core]; the picture does not depend on it
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=4096))]
    pub(crate) threads: Option<u32>,
    /// Leave out what clamping takes: faster, too dark in corners
    #[arg(long)]
    pub(crate) no_compensate: bool,
    /// Clamping radius of virtual lights in units of √(area/virtual lights); 0 clamps nothing [default: 4; unfiltered 1.5]
    #[arg(long, value_name = "C")]
    pub(crate) clamp: Option<f32>,
    /// How particles thin out: fractional, paper, roulette [default: fractional]
    #[arg(long, value_name = "NAME")]
    pub(crate) absorption: Option<String>,
    /// Low-discrepancy sequence of the particles, a name of `lampyris list`
    #[arg(long, value_name = "NAME")]
    pub(crate) sequence: Option<String>,
}

/// Batches where neither their number nor a time is given: each randomisation has several. Filtered ones are short.
const BATCHES: u32 = 8;
const FILTERED_BATCHES: u32 = 32;

impl EstimateArgs {
    /// How many batches there will be, filtered or not; `None` where time alone decides.
    pub(crate) fn planned_batches(&self, filtered: bool) -> Option<u32> {
        let usual = if filtered { FILTERED_BATCHES } else { BATCHES };
        self.batches.or(if self.time.is_some() { None } else { Some(usual) })
    }
}

/// Which scene, and what its file may ask for.
#[derive(Debug, Args)]
pub(crate) struct SceneArgs {
    /// Scene file, or saved edits of one, .lampyris.json
    #[arg(value_name = "SCENE")]
    pub(crate) file: PathBuf,
    #[command(flatten)]
    pub(crate) reading: ReadingArgs,
}

/// How a scene is read.
#[derive(Debug, Args)]
pub(crate) struct ReadingArgs {
    /// Folder beneath which every file must lie [default: the scene's own]
    #[arg(long, value_name = "DIR")]
    pub(crate) root: Option<PathBuf>,
    /// Facets around a full circle of curved shapes, a multiple of 4 [default: 20]
    #[arg(long, value_name = "N")]
    pub(crate) circle: Option<u32>,
    /// Picture around the scene, by longitude and latitude, .hdr or .exr; overhead is its upper edge
    #[arg(long, value_name = "FILE")]
    pub(crate) environment: Option<PathBuf>,
    /// Luminance of 1 in that picture [cd/m²]
    #[arg(long, value_name = "X", default_value_t = 1.0, requires = "environment", value_parser = parse::positive)]
    pub(crate) environment_scale: f32,
    #[command(flatten)]
    pub(crate) limits: LimitArgs,
}

#[derive(Debug, Args)]
pub(crate) struct LimitArgs {
    /// Bytes in one file
    #[arg(long, value_name = "N", help_heading = LIMITS)]
    pub(crate) max_file_bytes: Option<u64>,
    /// Triangles in the whole scene
    #[arg(long, value_name = "N", help_heading = LIMITS)]
    pub(crate) max_triangles: Option<u64>,
    /// Files included within each other
    #[arg(long, value_name = "N", help_heading = LIMITS)]
    pub(crate) max_include_depth: Option<u64>,
    /// Entities, repetitions counted
    #[arg(long, value_name = "N", help_heading = LIMITS)]
    pub(crate) max_entities: Option<u64>,
    /// Product of nested array sizes
    #[arg(long, value_name = "N", help_heading = LIMITS)]
    pub(crate) max_array: Option<u64>,
    /// Vertices of a polygon
    #[arg(long, value_name = "N", help_heading = LIMITS)]
    pub(crate) max_polygon: Option<u64>,
    /// Bytes of JSON in a glTF file or in saved edits
    #[arg(long, value_name = "N", help_heading = LIMITS)]
    pub(crate) max_json_bytes: Option<u64>,
    /// Nodes, meshes, accessors of a glTF file; lists and objects of saved edits
    #[arg(long, value_name = "N", help_heading = LIMITS)]
    pub(crate) max_nodes: Option<u64>,
    /// Nodes within each other
    #[arg(long, value_name = "N", help_heading = LIMITS)]
    pub(crate) max_depth: Option<u64>,
    /// Meshes placed by nodes
    #[arg(long, value_name = "N", help_heading = LIMITS)]
    pub(crate) max_instances: Option<u64>,
    /// Objects and groups of an OBJ file
    #[arg(long, value_name = "N", help_heading = LIMITS)]
    pub(crate) max_objects: Option<u64>,
    /// Material libraries of an OBJ file
    #[arg(long, value_name = "N", help_heading = LIMITS)]
    pub(crate) max_libraries: Option<u64>,
    /// Bytes in a line of OBJ or MTL
    #[arg(long, value_name = "N", help_heading = LIMITS)]
    pub(crate) max_line_bytes: Option<u64>,
    /// Pixels of one picture
    #[arg(long, value_name = "N", help_heading = LIMITS)]
    pub(crate) max_image_pixels: Option<u64>,
    /// Bytes of all pictures, decoded
    #[arg(long, value_name = "N", help_heading = LIMITS)]
    pub(crate) max_image_bytes: Option<u64>,
}

#[derive(Debug, Args)]
pub(crate) struct MeasureArgs {
    #[command(flatten)]
    pub(crate) scene: SceneArgs,
    /// File of meters, one a line: x y z nx ny nz
    #[arg(long, value_name = "FILE")]
    pub(crate) points: PathBuf,
    #[command(flatten)]
    pub(crate) estimate: EstimateArgs,
    /// Print an array of {x, y, z, nx, ny, nz, lux, direct, indirect, error}
    #[arg(long)]
    pub(crate) json: bool,
    /// Say nothing but errors
    #[arg(long)]
    pub(crate) quiet: bool,
}

#[derive(Debug, Args)]
pub(crate) struct BenchArgs {
    /// Folder of the scenes that ship
    #[arg(long, value_name = "DIR", default_value = "scenes")]
    pub(crate) scenes: PathBuf,
    /// Measure this scene instead; may repeat
    #[arg(long, value_name = "FILE")]
    pub(crate) scene: Vec<PathBuf>,
    /// Width and height [pixels]
    #[arg(long, value_name = "WxH", default_value = "640x480", value_parser = parse::size)]
    pub(crate) size: (u32, u32),
    /// Threads, one row each [default: 1, and one a core]
    #[arg(long, value_name = "N", value_delimiter = ',', value_parser = clap::value_parser!(u32).range(1..=4096))]
    pub(crate) threads: Vec<u32>,
    /// Frames a row; the median counts
    #[arg(long, value_name = "N", default_value_t = 15, value_parser = clap::value_parser!(u32).range(1..))]
    pub(crate) frames: u32,
    /// Also measure frames as they are shown by default, with virtual lights picked
    #[arg(long)]
    pub(crate) picked: bool,
    /// Print an array of rows
    #[arg(long)]
    pub(crate) json: bool,
}

#[derive(Debug, Args)]
#[command(subcommand_required = true, arg_required_else_help = true)]
pub(crate) struct LabArgs {
    #[command(subcommand)]
    pub(crate) command: LabCommand,
}

#[derive(Debug, Subcommand)]
pub(crate) enum LabCommand {
    /// List the experiments
    List(ListArgs),
    /// Run experiments and write a report
    #[command(after_help = LAB_EXAMPLES)]
    Run(LabRunArgs),
}

#[derive(Debug, Args)]
pub(crate) struct LabRunArgs {
    /// Names of `lampyris lab list`, or all
    #[arg(value_name = "NAME", required = true)]
    pub(crate) names: Vec<String>,
    /// Small settings: all in a few minutes
    #[arg(long)]
    pub(crate) quick: bool,
    /// Folder of the report, made where there is none
    #[arg(short, long = "output", value_name = "DIR", default_value = "report")]
    pub(crate) output: PathBuf,
    /// Folder of the scenes that ship
    #[arg(long, value_name = "DIR", default_value = "scenes")]
    pub(crate) scenes: PathBuf,
    /// Say nothing but the page's name and errors
    #[arg(long)]
    pub(crate) quiet: bool,
}

#[derive(Debug, Args)]
pub(crate) struct InfoArgs {
    #[command(flatten)]
    pub(crate) scene: SceneArgs,
    /// Print one JSON value
    #[arg(long)]
    pub(crate) json: bool,
}

#[derive(Debug, Args)]
pub(crate) struct ListArgs {
    /// Print one JSON value
    #[arg(long)]
    pub(crate) json: bool,
}

#[derive(Debug, Args)]
pub(crate) struct CompletionsArgs {
    /// bash, elvish, fish, powershell or zsh
    #[arg(value_name = "SHELL")]
    pub(crate) shell: clap_complete::Shell,
}
