//! What hangs in the gallery, and what is to be seen in each picture.

/// A scene with its words.
#[derive(Debug, Clone, Copy)]
pub struct Exhibit {
    /// Scene file, in `scenes/gallery` or else in `scenes`, without its ending; the picture has the same name.
    pub name: &'static str,
    /// Heading.
    pub title: &'static str,
    /// What it shows, strength or failure.
    pub words: &'static str,
    /// A further picture of the host's.
    pub beside: Option<Beside>,
}

/// What stands beside the device's picture.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Beside {
    /// The reference with Cook–Torrance facets, m = 0.1, in place of every material.
    Facets,
    /// What a display of 65 536 colours shows, without a dither and with one.
    Dither,
}

/// The scenes in their order.
pub const EXHIBITS: &[Exhibit] = &[
    Exhibit {
        name: "teapot",
        title: "A teapot",
        words: "A mesh, resolved to normals when the scene was built: a glazed body, a golden handle and knob, under two lights and a sky. Shaded by the same functions as all spheres here.",
        beside: None,
    },
    Exhibit {
        name: "shadows",
        title: "Shadows and smooth edges",
        words: "Where a scene asks for them: shadow rays, and four rays a pixel. Edges of shadows are sharp, and the sky reaches everything.",
        beside: None,
    },
    Exhibit {
        name: "metals",
        title: "Metals",
        words: "Gold, copper, silver, aluminium and chromium; n = 10, 40 and 190 from above. The colour of the sky's reflection fades towards the limb and the cool light's highlight there is nearly white: Fresnel's factor, per channel.",
        beside: None,
    },
    Exhibit {
        name: "patch-metals",
        title: "Metals of patches",
        words: "The exponential patch with Fresnel's factor, with the sharpnesses printed for figure 4.16 of the thesis: aluminium (s = 6), silver (8), copper (15), gold (20), a golden sphere (10) for the tank, a silver plane (4). The figure was traced with interreflection; a sky takes its place.",
        beside: None,
    },
    Exhibit {
        name: "paint",
        title: "Metallic paint",
        words: "(4.54): Fresnel's factor at the angle of half the projected difference of light and viewer. Gold, copper and aluminium at s = 12; below a blue paint of an invented index at s = 12 and 30, and, right, the same as a metal of patches.",
        beside: None,
    },
    Exhibit {
        name: "plastics",
        title: "Plastics",
        words: "After figure 3.12 of the thesis, with the printed specular shares and exponents, (0.04, 169), (0.065, 64), (0.09, 9) and (0.13, 3), on a plastic plate. The figure's reflections of one object in another are not there.",
        beside: None,
    },
    Exhibit {
        name: "ceramics",
        title: "Ceramics",
        words: "The glazes of figure 3.13 of the thesis, on teapots: n = 100 above, 20 below; Fresnel's factor of an index of 1.5 on the highlight (3.30) makes it faint in front and bright at the rim. The right column is without it (3.31).",
        beside: None,
    },
    Exhibit {
        name: "lambertian",
        title: "Generalised Lambert",
        words: "After figure 4.18 of the thesis: d = 1, flat as the full moon, 0.75, 0.5 and 0.25, the light at the viewer; below, Lambert's law beside d = 1.",
        beside: None,
    },
    Exhibit {
        name: "furnace",
        title: "In a furnace",
        words: "Sky and background have the same radiance: what reflects all that it receives vanishes. From the left: metallic Phong with n = 1000 and with n = 20, and reciprocal Phong with n = 20, which darkens at the limb; the basic patch with R = 1, the exponential patch with s = 4, and a white matt sphere. What is lost of the lobes lies below the horizon. **A failure that shows in the figures:** the albedo of the patch falls with the sine of the angle, steepest at the normal, where the table over the cosine has its widest cells: two codes, around the middle of that sphere.",
        beside: None,
    },
    Exhibit {
        name: "grazing",
        title: "Towards grazing",
        words: "One highlight for each angle between light and view, 0, 42.5, 85, 127.5 and 170 degrees, each of a colour, from the middle of a sphere to its limb; n = 20 with p = 0, 0.5 and 1, and a patch with R = 0.3. Without the division by cosΘmin highlights go out, with it they stay; there the patch bends along the limb.",
        beside: None,
    },
    Exhibit {
        name: "crease",
        title: "The crease at N·L = N·V",
        words: "**A failure:** where the greater of the two cosines changes hands, the slope of the metallic model jumps. n = 2, 4 and 8: the wider the lobe, the more of the crease is lit.",
        beside: None,
    },
    Exhibit {
        name: "wet-road",
        title: "A wet road",
        words: "**A failure:** a sun at 5 degrees over a plane with n = 200. All models here are functions of the angle to the mirror direction, and give a round spot. Below, in double precision, Cook–Torrance with m = 0.1: the long streak that everybody has seen.",
        beside: Some(Beside::Facets),
    },
    Exhibit {
        name: "dark-ramp",
        title: "A dark ramp",
        words: "A lamp low over a dark floor. Below, as a display of 65 536 colours shows it, left without the dither and right with it: bands, and grain in their place ([dither.md](dither.md) has the figures).",
        beside: Some(Beside::Dither),
    },
];
