//! Which camera: the arguments', the scene's, or one that is found.

use crate::cli::ViewArgs;
use crate::failure::Failure;
use lampyris::Error;
use lampyris::scene::{Camera, Scene, Seen, find_view, upward};
use lampyris::world::World;

/// A camera and, if the program had to find it, what it shows.
pub(crate) struct Chosen {
    pub(crate) camera: Camera,
    pub(crate) seen: Option<Seen>,
}

/// Vertical field of view where nothing says otherwise [degrees].
const FOV_Y: f32 = 60.0;

/// The camera for a picture of that aspect (width / height).
pub(crate) fn choose(args: &ViewArgs, world: &World, aspect: f32) -> Result<Chosen, Failure> {
    let scene = world.scene();
    let (camera, seen) =
        match asked(args, scene)?.or_else(|| scene.view.clone()).or_else(|| scene.cameras.first().cloned()) {
            Some(camera) => (camera, None),
            None => {
                let found = find_view(scene, &|ray| world.tracer().closest(ray), aspect);
                (found.camera, Some(found.seen))
            }
        };
    Ok(Chosen { camera: turned(args, camera)?, seen })
}

/// The camera that the arguments ask for by its place or name, if they do.
pub(crate) fn asked(args: &ViewArgs, scene: &Scene) -> Result<Option<Camera>, Failure> {
    let camera = match (args.eye, args.target, &args.camera) {
        (Some(eye), Some(target), _) => {
            let up = args.up.unwrap_or_else(|| upward(scene));
            Camera { name: "arguments".into(), eye, target, up, fov_y: FOV_Y }
        }
        (_, _, Some(name)) => named(scene, name)?,
        _ => return Ok(None),
    };
    turned(args, camera).map(Some)
}

/// The camera as the other arguments have it.
fn turned(args: &ViewArgs, mut camera: Camera) -> Result<Camera, Failure> {
    camera.up = args.up.unwrap_or(camera.up);
    camera.fov_y = args.fov.unwrap_or(camera.fov_y);
    let axis = camera.target - camera.eye;
    if axis.cross(camera.up).length_squared() <= 1e-12 * axis.length_squared() * camera.up.length_squared() {
        let text =
            "the view has no axis or no side: eye and target must differ, and up must not point along them";
        return Err(Error::BadSetting(text.into()).into());
    }
    Ok(camera)
}

fn named(scene: &Scene, name: &str) -> Result<Camera, Error> {
    scene.cameras.iter().find(|c| c.name == name).cloned().ok_or_else(|| {
        let known: Vec<_> = scene.cameras.iter().map(|c| c.name.as_str()).collect();
        let known = if known.is_empty() { "none".into() } else { known.join(", ") };
        Error::BadSetting(format!("no camera is called \"{name}\"; the scene has: {known}"))
    })
}

/// The arguments that repeat a view.
pub(crate) fn arguments(camera: &Camera, near: Option<f32>) -> String {
    let [e, t, u] = [camera.eye, camera.target, camera.up];
    let near = near.map_or(String::new(), |near| format!(" --near {near}"));
    format!(
        "--eye {},{},{} --target {},{},{} --up {},{},{} --fov {}{near}",
        e.x, e.y, e.z, t.x, t.y, t.z, u.x, u.y, u.z, camera.fov_y
    )
}
