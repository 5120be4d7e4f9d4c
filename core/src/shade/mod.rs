//! From a scene to a display's codes.

mod camera;
mod checker;
mod dither;
mod grey;
mod light;
mod linear;
mod palette;
mod placing;
mod placing_f32;
mod placing_q15;
mod placing_q31;
mod plane;
mod root;
mod scene;
mod sphere;
mod srgb;
mod srgb_quick;
mod surface;
mod tracing;
mod tracing_f32;
mod tracing_q15;
mod tracing_q31;

pub use camera::Camera;
pub use checker::Checker;
pub use grey::{grey16, grey16_nearest};
pub use light::{Beam, Dimmed, FloodLight, Light, PointLight};
pub use linear::{LINEAR_ONE, Linear};
pub use palette::Palette565;
pub use placing::Placing;
pub use plane::{Ground, Plane};
pub use scene::Scene;
pub use sphere::Sphere;
pub use srgb::{srgb8, srgb8_bisected};
pub use srgb_quick::srgb8_quick;
pub use surface::{AlbedoDaylight, Coat, Daylight, NoDaylight, Surface};
pub use tracing::Tracing;
