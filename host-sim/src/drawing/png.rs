//! SVG to pixels, with the embedded font alone.

use std::sync::Arc;

use resvg::tiny_skia::{Pixmap, Transform};
use resvg::usvg::{Options, Tree, fontdb};

use crate::picture::Picture;

/// DejaVu Sans; see fonts/README.md.
const FONT: &[u8] = include_bytes!("../../fonts/DejaVuSans-subset.ttf");
/// Pixels for each unit of the SVG.
const SCALE: f32 = 2.0;

/// The picture of an SVG with an opaque background.
///
/// # Errors
/// Why it could not be drawn.
pub fn rasterised(svg: &str) -> Result<Picture, String> {
    let mut fonts = fontdb::Database::new();
    fonts.load_font_data(FONT.to_vec());
    let options = Options {
        fontdb: Arc::new(fonts),
        font_family: "DejaVu Sans".to_owned(),
        ..Options::default()
    };
    let tree = Tree::from_str(svg, &options).map_err(|error| error.to_string())?;
    let size = tree.size().to_int_size();
    let size = size.scale_by(SCALE).ok_or("is too large")?;
    let mut pixels = Pixmap::new(size.width(), size.height()).ok_or("is too large")?;
    resvg::render(
        &tree,
        Transform::from_scale(SCALE, SCALE),
        &mut pixels.as_mut(),
    );
    Ok(Picture {
        width: size.width() as usize,
        height: size.height() as usize,
        pixels: pixels
            .pixels()
            .iter()
            .map(|p| [p.red(), p.green(), p.blue()])
            .collect(),
    })
}
