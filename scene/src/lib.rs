//! Scene and material files, and what they become: the core's constants on a
//! host, generated Rust for a microcontroller, and the reference's models.

mod albedo;
mod bake;
mod curve;
mod description;
mod error;
mod exposure;
mod extent;
pub mod files;
mod highlight;
mod host;
mod lamp;
mod material;
mod mesh;
mod model;
mod prepare;
mod profile;
mod quality;
mod reader;
mod square;
mod surface;
pub mod vector;
mod wide;

pub use albedo::{AlbedoTable, directional_albedo};
pub use bake::bake;
pub use curve::cosine_curve;
pub use description::{
    CameraDescription, CheckerDescription, Description, LightDescription, LightKind,
    PlaneDescription, SphereDescription,
};
pub use error::SceneError;
pub use host::{HostArithmetic, HostModels, Native};
pub use lamp::AnyLight;
pub use material::{Material, PatchShape, Reflectance};
pub use mesh::{
    AnyView, Obj, ObjError, ObjTriangle, PreparedView, Seen, SeenView, StoredNormals, encode,
    greatest_error,
};
pub use model::{AnyModel, generalised_profile};
pub use prepare::{Prepared, PreparedCoat, PreparedPart, camera_frame, half_pixel, plane_axes};
pub use profile::Profile;
pub use quality::{AnySamples, AnyShadows};
pub use reader::Colour;
pub use square::SquareProfile;
pub use surface::{AnyDaylight, AnyScene, AnySurface, SceneParts};
pub use wide::WideScene;
