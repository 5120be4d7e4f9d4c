//! The command line.

use std::path::PathBuf;

use clap::{Args, Parser, Subcommand, ValueEnum};

use crate::arithmetic::ArithmeticName;
use crate::drawing::Format;

/// Renders, compares and inspects what a microcontroller shades.
///
/// Exit status: 0 done; 1 ran, but the result is incomplete or differs; 2 a
/// mistake in the call or in a file; 3 the environment lacks something.
#[derive(Debug, Parser)]
#[command(
    name = "microbrdf",
    version,
    after_help = "Example: microbrdf render scenes/demo.toml --arithmetic q31 -o demo.png"
)]
pub struct Cli {
    /// What to do.
    #[command(subcommand)]
    pub command: Command,
}

/// The commands.
#[derive(Debug, Subcommand)]
pub enum Command {
    /// Renders a scene to a PNG, just as a device does.
    #[command(
        after_help = "Example: microbrdf render scenes/demo.toml --arithmetic q31 -o demo.png"
    )]
    Render(Render),
    /// Measures renderings against the double precision reference.
    #[command(after_help = "Example: microbrdf compare scenes/demo.toml --arithmetic f32,q31")]
    Compare(Compare),
    /// Evaluates a material for directions on standard input.
    #[command(
        after_help = "Each line is lx,ly,lz,vx,vy,vz in the shading frame (N is +z): L to the \
        light, V to the viewer, of any length.\n\n\
        Example: echo 0.6,0,0.8,-0.6,0,0.8 | \
        microbrdf eval --material 'model = \"metallic-phong\", exponent = 20' --arithmetic q31"
    )]
    Eval(Eval),
    /// Prints the directional albedo of a material as an arithmetic computes it.
    #[command(
        after_help = "Example: microbrdf albedo --material 'model = \"patch\", radius = 0.5' \
        --arithmetic q31 --angles 0,30,60,89.9 --mean"
    )]
    Albedo(Albedo),
    /// Acts as a microcontroller would on the wire.
    #[command(
        after_help = "Example: microbrdf device scenes/demo.toml --tcp 127.0.0.1:7777, and \
        elsewhere microbrdf-receive socket://127.0.0.1:7777 -o demo.png"
    )]
    Device(Device),
    /// Writes a scene as Rust source for firmware.
    #[command(after_help = "Example: microbrdf bake scenes/demo.toml --arithmetic q31 -o scene.rs")]
    Bake(Bake),
    /// Measures how fast this host renders a scene, beside plain f32 with powf.
    #[command(
        after_help = "The scene is enlarged to 1024 pixels; the renderers take turns, and all use \
        all cores. Times are wall clock: only their ratios within a run mean something.\n\n\
        In f32 spheres and planes under distant lights come eight pixels at a time, with the \
        bits of the core's own row function; other scenes, and other arithmetics, pixel by pixel.\n\n\
        Example: microbrdf bench scenes/demo.toml"
    )]
    Bench(Bench),
    /// Draws curves of materials, or figures of the thesis, as SVG or PNG.
    #[command(
        after_help = "Materials are evaluated in double precision. Figures are computed from the \
        models; what each leaves out or chooses is printed and stands below it.\n\n\
        Examples:\n  \
        microbrdf plot --material 'model = \"phong\", exponent = 20' \\\n      \
        --material 'model = \"metallic-phong\", exponent = 20' -o albedo.svg\n  \
        microbrdf plot --quantity lobe --incidence 0,40,80 \\\n      \
        --material 'model = \"patch-exponential\", sharpness = 8' -o lobe.png\n  \
        microbrdf plot --figure 3.1 -o figure.svg\n  \
        microbrdf plot --figure all --out figures"
    )]
    Plot(Plot),
    /// Names the cheapest arithmetic and size of table that are exact enough.
    #[command(
        after_help = "Cycles and bytes are those that `cargo xtask measure` found for the nearest \
        material of the model; the error is the pixel error of the material itself on a sphere, \
        coarse directions included. Status 1 if nothing holds the bounds.\n\n\
        Example: microbrdf advise --core cortex-m0plus --max-error 0.75 --max-bytes 2000 \\\n    \
        --material 'model = \"metallic-phong\", exponent = 20'"
    )]
    Advise(Advise),
    /// Tells what a scene will take on a board, before anything is built.
    #[command(
        after_help = "Bytes and cycles are sums over what the scene has, with costs that `cargo \
        xtask forecast` measured; docs/budget.md says how near they come. Cycles are estimates. \
        The error is that of the picture, which this command renders.\n\n\
        Example: microbrdf budget scenes/demo.toml --board microbit --arithmetic q15"
    )]
    Budget(Budget),
    /// Draws the test card: values and errors where no scene shows them.
    #[command(
        after_help = "Pixels are pairs of directions: across, how far V lies from the mirror \
        direction; down, the larger cosine, from 1 to 1e-8; a band for each of several exponents, \
        radii and sharpnesses. Errors are arithmetic errors of the 8-bit sRGB code. Writes \
        chart-ARITHMETIC.png for each arithmetic and prints each band's greatest error.\n\n\
        Example: microbrdf chart --arithmetic f32,q31 --out charts"
    )]
    Chart(Chart),
    /// Computes every number that the papers print again, and prints both.
    #[command(
        after_help = "Columns: id, quantity, params, published, computed, verdict. Status 1 if a \
        value is not that of the independent computation that comes with the data.\n\n\
        Examples:\n  \
        microbrdf tables\n  \
        microbrdf tables --csv > tables.csv"
    )]
    Tables(Tables),
}

/// `render`.
#[derive(Debug, Args)]
pub struct Render {
    /// Scene file.
    pub scene: PathBuf,
    /// How to compute; `reference` is double precision.
    #[arg(long, default_value = "q31")]
    pub arithmetic: String,
    /// PNG to write, 8-bit sRGB.
    #[arg(short, long, required_unless_present_any = ["panel", "rgb565"])]
    pub output: Option<PathBuf>,
    /// PNG to write of the 128 x 64 grey panel as the emulator shows it.
    #[arg(long)]
    pub panel: Option<PathBuf>,
    /// PNG to write of what a display of 65 536 colours shows.
    #[arg(long)]
    pub rgb565: Option<PathBuf>,
    /// With `--arithmetic reference`: Cook–Torrance's model with facets of
    /// this RMS slope in place of every material, 1e-4 to 10; not in daylight.
    #[arg(long, value_name = "SLOPE")]
    pub facets: Option<f64>,
}

/// `compare`.
#[derive(Debug, Args)]
pub struct Compare {
    /// Scene file.
    pub scene: PathBuf,
    /// What to compare with the reference, several parted by commas.
    #[arg(long, value_delimiter = ',', default_value = "f32,micromath,q31,q15")]
    pub arithmetic: Vec<ArithmeticName>,
    /// Print JSON.
    #[arg(long)]
    pub json: bool,
    /// Measure this picture, which a device sent, and tell whether it equals
    /// the host's; needs one --arithmetic.
    #[arg(long)]
    pub device: Option<PathBuf>,
    /// Folder for host.png, reference.png and error.png (with several
    /// arithmetics host-A.png and error-A.png).
    #[arg(long)]
    pub out: Option<PathBuf>,
}

/// What `eval` prints.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Quantity {
    /// f in 1/sr, without the cosine.
    Brdf,
    /// f·cosΘL, reflected radiance for unit normal irradiance.
    Reflect,
    /// The display code of clamp(K·ρ, 0, 1), ρ = reflect / peak.
    Code,
}

/// How `eval` encodes codes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Encoding {
    /// 8-bit sRGB.
    Srgb,
    /// 8-bit linear light.
    Linear,
}

/// `eval`.
#[derive(Debug, Args)]
pub struct Eval {
    /// Material: a TOML table written inline, or a file that holds one.
    #[arg(long)]
    pub material: String,
    /// How to compute; `reference` is double precision.
    #[arg(long, default_value = "q31")]
    pub arithmetic: String,
    /// What to print.
    #[arg(long, value_enum, default_value = "brdf")]
    pub quantity: Quantity,
    /// K of --quantity code, 1e-3 to 2e7.
    #[arg(long, default_value_t = 1.0)]
    pub exposure: f64,
    /// Encoding of --quantity code.
    #[arg(long, value_enum, default_value = "srgb")]
    pub encoding: Encoding,
    /// Print the six components as rounded before the values.
    #[arg(long)]
    pub print_directions: bool,
}

/// `albedo`.
#[derive(Debug, Args)]
pub struct Albedo {
    /// Material: a TOML table written inline, or a file that holds one.
    #[arg(long)]
    pub material: String,
    /// How to compute; `reference` is double precision.
    #[arg(long, default_value = "q31")]
    pub arithmetic: String,
    /// Angles from the normal in degrees, 0 to 90, parted by commas.
    #[arg(long, value_delimiter = ',', required = true)]
    pub angles: Vec<f64>,
    /// Print the mean albedo, too.
    #[arg(long)]
    pub mean: bool,
}

/// `device`.
#[derive(Debug, Args)]
pub struct Device {
    /// Scene file.
    pub scene: PathBuf,
    /// How to compute.
    #[arg(long, default_value = "q31")]
    pub arithmetic: ArithmeticName,
    /// Open a pseudo-terminal and print its path.
    #[arg(long, conflicts_with = "tcp", required_unless_present = "tcp")]
    pub pty: bool,
    /// Listen on this address, such as 127.0.0.1:7777, for one receiver.
    #[arg(long)]
    pub tcp: Option<String>,
    /// Frames to send without being asked; then one for each byte received.
    #[arg(long, default_value_t = 1)]
    pub frames: u16,
    /// Send RGB565 instead of 8-bit sRGB.
    #[arg(long)]
    pub rgb565: bool,
}

/// `bake`.
#[derive(Debug, Args)]
pub struct Bake {
    /// Scene file.
    pub scene: PathBuf,
    /// How the firmware is to compute.
    #[arg(long, default_value = "q31")]
    pub arithmetic: ArithmeticName,
    /// Rust file to write.
    #[arg(short, long)]
    pub output: PathBuf,
}

/// What `plot` shows of materials.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Curve {
    /// Directional albedo over the angle of incidence.
    Albedo,
    /// f in 1/sr in the plane of incidence, as a polar diagram.
    Lobe,
    /// f·cosΘL in the plane of incidence, over the viewing angle.
    Radiance,
    /// p(R), the density of a mixture of patches (patch-exponential only).
    Density,
    /// The inverse of its distribution function.
    Inverse,
}

/// `plot`.
#[derive(Debug, Args)]
pub struct Plot {
    /// Material: a TOML table written inline, or a file that holds one; may be given
    /// several times.
    #[arg(long, required_unless_present = "figure")]
    pub material: Vec<String>,
    /// What to show of the materials.
    #[arg(long, value_enum, default_value = "albedo")]
    pub quantity: Curve,
    /// Angles of incidence of --quantity lobe and radiance in degrees, 0 to 89.99,
    /// parted by commas [default: 45].
    #[arg(long, value_delimiter = ',')]
    pub incidence: Vec<f64>,
    /// A figure of the thesis instead, such as 3.1, or all.
    #[arg(long, conflicts_with_all = ["material", "quantity", "incidence"])]
    pub figure: Option<String>,
    /// File to write: .svg or .png.
    #[arg(short, long, conflicts_with = "out")]
    pub output: Option<PathBuf>,
    /// Folder for --figure all: figure-2.1.svg, figure-2.1.png and so on.
    #[arg(long, conflicts_with = "material")]
    pub out: Option<PathBuf>,
    /// What --figure all writes, parted by commas.
    #[arg(long, value_enum, value_delimiter = ',', default_value = "svg,png")]
    pub format: Vec<Format>,
}

/// `advise`.
#[derive(Debug, Args)]
pub struct Advise {
    /// Core, such as cortex-m0plus, cortex-m3 or rv32imc.
    #[arg(long)]
    pub core: String,
    /// Greatest pixel error in steps of an 8-bit sRGB code, from 0.5.
    #[arg(long)]
    pub max_error: f64,
    /// Most bytes of code and tables.
    #[arg(long)]
    pub max_bytes: Option<u64>,
    /// Material: a TOML table written inline, or a file that holds one.
    #[arg(long)]
    pub material: String,
    /// K, 1e-3 to 2e7: 1 puts a lobe's peak at full scale.
    #[arg(long, default_value_t = 1.0)]
    pub exposure: f64,
    /// Measured data to read in place of the project's.
    #[arg(long)]
    pub data: Option<PathBuf>,
}

/// `bench`.
#[derive(Debug, Args)]
pub struct Bench {
    /// Scene file: spheres, planes of one material, directional lights.
    pub scene: PathBuf,
    /// Turns of each renderer.
    #[arg(long, default_value_t = 7, value_parser = clap::value_parser!(u16).range(1..=1000))]
    pub repeat: u16,
    /// Exit with 1 unless f32 is so many times as fast as both others.
    #[arg(long, value_name = "TIMES", value_parser = positive)]
    pub at_least: Option<f64>,
}

/// `budget`.
#[derive(Debug, Args)]
pub struct Budget {
    /// Scene file.
    pub scene: PathBuf,
    /// Board, as `cargo xtask firmware` has it [default: all].
    #[arg(long)]
    pub board: Option<String>,
    /// How the firmware is to compute.
    #[arg(long, default_value = "q31")]
    pub arithmetic: ArithmeticName,
    /// Print JSON, a list with an entry for each board.
    #[arg(long)]
    pub json: bool,
}

/// `chart`.
#[derive(Debug, Args)]
pub struct Chart {
    /// What to draw, several parted by commas [default: all].
    #[arg(long, value_delimiter = ',')]
    pub arithmetic: Vec<ArithmeticName>,
    /// K, 1e-3 to 2e7: 1 puts a lobe's peak at full scale.
    #[arg(long, default_value_t = 1.0)]
    pub exposure: f64,
    /// Folder for the pictures.
    #[arg(long)]
    pub out: PathBuf,
}

/// `tables`.
#[derive(Debug, Args)]
pub struct Tables {
    /// Print CSV, quoted where needed, instead of aligned columns.
    #[arg(long)]
    pub csv: bool,
}

/// A number above 0.
fn positive(text: &str) -> Result<f64, String> {
    match text.parse() {
        Ok(number) if number > 0.0 && f64::is_finite(number) => Ok(number),
        _ => Err("must be a number above 0".to_owned()),
    }
}
