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

#[cfg(test)]
mod tests {
    use super::super::pen::FAMILY;
    use super::*;

    /// How many pixels are dark in a sheet of 100 x 20 units that holds a text.
    fn dark(text: &str) -> usize {
        let svg = format!(
            r#"<svg xmlns="http://www.w3.org/2000/svg" width="100" height="20">
            <rect width="100" height="20" fill="white"/>
            <text x="5" y="15" font-size="12" font-family="{FAMILY}">{text}</text></svg>"#
        );
        let picture = rasterised(&svg).unwrap();
        assert_eq!((picture.width, picture.height), (200, 40));
        picture.pixels.iter().filter(|p| p[1] < 128).count()
    }

    #[test]
    fn text_is_drawn_with_the_embedded_font() {
        assert_eq!(dark(""), 0);
        let (one, three) = (dark("Θ"), dark("Θ⁻¹√"));
        assert!(one > 20 && three > one + 40, "{one} {three}");
    }

    #[test]
    fn what_is_no_svg_is_told() {
        assert!(rasterised("<svg").is_err());
    }
}
