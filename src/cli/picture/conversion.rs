//! SVG as PNG and as PDF.

use krilla::Document;
use krilla::geom::Size;
use krilla::metadata::Metadata;
use krilla::page::PageSettings;
use krilla_svg::{SurfaceExt, SvgSettings};
use resvg::tiny_skia::{Pixmap, Transform};
use resvg::usvg::roxmltree;
use resvg::usvg::{Group, Node, Options, Tree};

use super::fonts;

/// Pixels of a PNG for each of the drawing.
const SCALE: f32 = 2.0;

/// What drawings are read with.
pub struct Conversion {
    options: Options<'static>,
}

impl Conversion {
    /// With the fonts of this machine.
    ///
    /// # Errors
    ///
    /// As [`fonts::installed`].
    pub fn new() -> Result<Self, String> {
        let options = Options {
            fontdb: fonts::installed()?,
            ..Options::default()
        };
        Ok(Conversion { options })
    }

    /// A drawing in pixels.
    ///
    /// # Errors
    ///
    /// In words, if a character is in no font, or the drawing is too large.
    pub fn png(&self, svg: &str) -> Result<Vec<u8>, String> {
        let (tree, _) = self.read(svg)?;
        let size = tree.size().to_int_size().scale_by(SCALE);
        let pixels = size.and_then(|size| Pixmap::new(size.width(), size.height()));
        let mut pixels = pixels.ok_or("the picture is too large")?;
        let scale = Transform::from_scale(SCALE, SCALE);
        resvg::render(&tree, scale, &mut pixels.as_mut());
        pixels.encode_png().map_err(|error| error.to_string())
    }

    /// A drawing on a page of its size.
    ///
    /// # Errors
    ///
    /// In words, if a character is in no font, or what the library says.
    pub fn pdf(&self, svg: &str) -> Result<Vec<u8>, String> {
        let (tree, title) = self.read(svg)?;
        let size = Size::from_wh(tree.size().width(), tree.size().height());
        let size = size.ok_or("the picture has no size")?;
        let mut document = Document::new();
        document.set_metadata(Metadata::new().title(title));
        let mut page = document.start_page_with(PageSettings::new(size));
        let mut surface = page.surface();
        let drawn = surface.draw_svg(&tree, size, SvgSettings::default());
        surface.finish();
        page.finish();
        drawn.ok_or("the picture cannot be drawn")?;
        document.finish().map_err(|error| format!("{error:?}"))
    }

    /// The drawing, all of whose text is set, and its title.
    fn read(&self, svg: &str) -> Result<(Tree, String), String> {
        let document = roxmltree::Document::parse(svg).map_err(|error| error.to_string())?;
        let elements = || document.descendants().filter(roxmltree::Node::is_element);
        let title = elements().find(|own| own.has_tag_name((SVG, "title")));
        let title = title.and_then(|own| own.text()).unwrap_or_default();
        let texts = elements().filter(|own| own.has_tag_name((SVG, "text")));
        let tree =
            Tree::from_xmltree(&document, &self.options).map_err(|error| error.to_string())?;
        let set = all_set(tree.root())?;
        match set == texts.count() {
            true => Ok((tree, title.to_string())),
            false => Err("a text of the picture cannot be set in the fonts of this machine".into()),
        }
    }
}

const SVG: &str = "http://www.w3.org/2000/svg";

/// How many texts there are; a character that is in no font is an error.
fn all_set(group: &Group) -> Result<usize, String> {
    let mut count = 0;
    for node in group.children() {
        match node {
            Node::Group(inner) => count += all_set(inner)?,
            Node::Text(text) => {
                count += 1;
                let glyphs = text
                    .layouted()
                    .iter()
                    .flat_map(|span| &span.positioned_glyphs);
                let mut missing = glyphs.filter(|glyph| glyph.id.0 == 0);
                if let Some(glyph) = missing.next() {
                    return Err(format!(
                        "no font of this machine has `{}`: install one such as DejaVu Sans, or write SVG",
                        glyph.text
                    ));
                }
            }
            Node::Path(_) | Node::Image(_) => {}
        }
    }
    Ok(count)
}
