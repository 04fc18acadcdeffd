//! Pictures: SVG as it is drawn and, behind a feature, PNG and PDF that are made of it.

#[cfg(feature = "pictures")]
mod conversion;
#[cfg(feature = "pictures")]
mod fonts;

use std::path::PathBuf;

use clap::ValueEnum;

/// What a picture is written as.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Kind {
    /// Drawn as it is
    Svg,
    /// In pixels, twice as many as SVG has (a build with the feature `pictures`)
    Png,
    /// For print, its text as text (a build with the feature `pictures`)
    Pdf,
}

/// A file that a picture is to be written to, and as what.
#[derive(Clone, Debug)]
pub struct Plot {
    pub path: PathBuf,
    kind: Kind,
}

/// Makes pictures of one kind.
pub enum Pictures {
    Svg,
    #[cfg(feature = "pictures")]
    Converted(Kind, conversion::Conversion),
}

impl Kind {
    /// What names of such files end in.
    pub fn ending(self) -> &'static str {
        match self {
            Kind::Svg => "svg",
            Kind::Png => "png",
            Kind::Pdf => "pdf",
        }
    }

    /// What makes such pictures.
    ///
    /// # Errors
    ///
    /// In words, if this build makes none, or no font is found for their text.
    pub fn pictures(self) -> Result<Pictures, String> {
        match self {
            Kind::Svg => Ok(Pictures::Svg),
            #[cfg(feature = "pictures")]
            Kind::Png | Kind::Pdf => Ok(Pictures::Converted(self, conversion::Conversion::new()?)),
            #[cfg(not(feature = "pictures"))]
            Kind::Png | Kind::Pdf => Err(format!(
                "this build writes no {}: build it with `--features pictures`, or write SVG",
                self.ending().to_uppercase()
            )),
        }
    }
}

impl Plot {
    /// A path, and the kind that it ends in; SVG if it has no ending.
    ///
    /// # Errors
    ///
    /// In words, if it promises something else, or what this build does not write.
    pub fn new(path: PathBuf) -> Result<Self, String> {
        let ending = path.extension().map(|own| own.to_ascii_lowercase());
        let mut kinds = Kind::value_variants().iter();
        let kind = match ending {
            None => Some(&Kind::Svg),
            Some(ending) => kinds.find(|own| ending == own.ending()),
        };
        let kind =
            *kind.ok_or("it is SVG: give it a name that ends in .svg, or in .png or .pdf")?;
        if cfg!(not(feature = "pictures")) {
            kind.pictures()?;
        }
        Ok(Plot { path, kind })
    }

    /// A drawing as what the file is to be.
    ///
    /// # Errors
    ///
    /// As [`Kind::pictures`] and [`Pictures::made`].
    pub fn made(&self, svg: String) -> Result<Vec<u8>, String> {
        self.kind.pictures()?.made(svg)
    }
}

impl Pictures {
    /// A drawing as such a picture.
    ///
    /// # Errors
    ///
    /// In words, if its text cannot be set.
    pub fn made(&self, svg: String) -> Result<Vec<u8>, String> {
        match self {
            Pictures::Svg => Ok(svg.into_bytes()),
            #[cfg(feature = "pictures")]
            Pictures::Converted(Kind::Png, conversion) => conversion.png(&svg),
            #[cfg(feature = "pictures")]
            Pictures::Converted(_, conversion) => conversion.pdf(&svg),
        }
    }
}
