//! Meshes: read, placed, and turned into what the camera sees of them.

mod obj;
mod octahedral;
mod raster;
mod table;

pub use obj::{Obj, ObjError, ObjTriangle};
pub use octahedral::{encode, greatest_error};
pub use raster::{Seen, SeenView};
pub use table::{AnyView, PreparedView, StoredNormals};

pub(crate) use raster::{Mirrored, Placed, look};
