//! What each way to compute costs, as `cargo xtask measure` found.

use microbrdf_scene::{Material, PatchShape};
use serde_json::Value;

/// How a variant begins whose tables hold one light's gain.
const EXPOSED: &str = "gain in the table, ";

/// The cost of an arithmetic and a size of table.
#[derive(Clone, Debug, PartialEq)]
pub struct Cost {
    /// Arithmetic.
    pub arithmetic: String,
    /// Cells or knots of its tables, where it has any.
    pub size: Option<usize>,
    /// Whether one light's gain is in its tables.
    pub exposed: bool,
    /// What was measured: the material's fields.
    pub measured: String,
    /// Mean cycles within the lobe.
    pub cycles: f64,
    /// Bytes of code.
    pub code: u64,
    /// Bytes of tables.
    pub tables: u64,
    /// Whether the cycles are an estimate.
    pub estimate: bool,
}

impl Cost {
    /// Bytes in flash.
    #[must_use]
    pub fn bytes(&self) -> u64 {
        self.code + self.tables
    }

    /// Whether it is the same way to compute, measured of another material.
    fn is_way_of(&self, other: &Self) -> bool {
        (&self.arithmetic, self.size, self.exposed)
            == (&other.arithmetic, other.size, other.exposed)
    }
}

/// The costs of a material on a core: for each arithmetic and size of table
/// the measured material of the same model whose parameter is nearest.
///
/// # Errors
/// Data that is not what `cargo xtask measure` writes; a core or a model that
/// it does not hold, with those that it does.
pub fn costs(data: &str, core: &str, material: &Material) -> Result<Vec<Cost>, String> {
    let data: Value = serde_json::from_str(data).map_err(|error| error.to_string())?;
    let rows = data.as_array().ok_or("is not a list of rows")?;
    let text = |row: &Value, field: &str| row[field].as_str().unwrap_or_default().to_owned();
    let mut cores: Vec<_> = rows.iter().map(|row| text(row, "core")).collect();
    cores.sort();
    cores.dedup();
    if !cores.iter().any(|name| name == core) {
        return Err(format!(
            "--core {core}: must be one of {}",
            cores.join(", ")
        ));
    }
    let (model, wanted) = kind(material);
    let glazed = matches!(material, Material::Plastic { index: Some(_), .. });
    let mut best: Vec<(f64, Cost)> = Vec::new();
    for row in rows {
        let variant = text(row, "variant");
        let exposed = variant.strip_prefix(EXPOSED);
        let own = variant == "core" || variant.starts_with("core, ");
        if !(own || exposed.is_some())
            || text(row, "core") != core
            || text(row, "model") != model
            || text(row, "exposure") != "1"
        {
            continue;
        }
        let measured = text(row, "parameters");
        // Another shape of its lobe, or without its glaze, costs something else.
        if field(&measured, wanted.0).is_none() || field(&measured, "index").is_some() != glazed {
            continue;
        }
        let number = |name: &str| {
            row[name]
                .as_f64()
                .ok_or_else(|| format!("a row without {name}"))
        };
        let cost = Cost {
            arithmetic: text(row, "arithmetic"),
            size: exposed.or(variant.strip_prefix("core, ")).and_then(size),
            exposed: exposed.is_some(),
            cycles: number("cycles_mean")?,
            code: number("code_bytes")? as u64,
            tables: number("flash_table_bytes")? as u64,
            estimate: row["estimate"].as_bool().unwrap_or(true),
            measured,
        };
        let distance = distance(&cost.measured, wanted);
        match best.iter_mut().find(|(_, known)| known.is_way_of(&cost)) {
            Some(known) if distance < known.0 => *known = (distance, cost),
            Some(_) => {}
            None => best.push((distance, cost)),
        }
    }
    if best.is_empty() {
        let field = if glazed { "index" } else { wanted.0 };
        return Err(format!(
            "nothing was measured of {model} with {field} on {core}"
        ));
    }
    Ok(best.into_iter().map(|(_, cost)| cost).collect())
}

/// Cells or knots, from `1024 cells`.
fn size(variant: &str) -> Option<usize> {
    variant.split(' ').next()?.parse().ok()
}

/// The model's name in the data, and the field whose value tells materials of
/// it apart, with that value.
fn kind(material: &Material) -> (&'static str, (&'static str, f64)) {
    match material {
        Material::Lambert { .. } => ("lambert", ("albedo", 1.0)),
        Material::Phong {
            exponent, p, retro, ..
        } => {
            let name = match (retro, *p == 1.0) {
                (true, _) => "retro-phong",
                (false, true) => "metallic-phong",
                (false, false) => "phong",
            };
            (name, ("exponent", *exponent))
        }
        Material::Patch { radius } => ("patch", ("radius", *radius)),
        Material::PatchExponential { sharpness } => {
            ("patch-exponential", ("sharpness", *sharpness))
        }
        // Its cost is the same for all points.
        Material::PatchProfile { .. } => ("profile", ("points", 0.0)),
        Material::Metal { exponent, .. } => ("metal", ("exponent", *exponent)),
        Material::PatchMetal {
            shape: PatchShape::Basic { radius },
            ..
        } => ("patch-metal", ("radius", *radius)),
        Material::PatchMetal {
            shape: PatchShape::Exponential { sharpness },
            ..
        } => ("patch-metal", ("sharpness", *sharpness)),
        Material::MetallicPaint { sharpness, .. } => ("metallic-paint", ("sharpness", *sharpness)),
        Material::GeneralisedLambert { smoothness, .. } => {
            ("generalised-lambert", ("smoothness", *smoothness))
        }
        Material::Plastic { exponent, .. } => ("plastic", ("exponent", *exponent)),
    }
}

/// How far a measured material's field is from the value that is wanted, as a
/// ratio.
fn distance(parameters: &str, (name, wanted): (&str, f64)) -> f64 {
    let value = field(parameters, name).and_then(|value| value.parse::<f64>().ok());
    value.map_or(0.0, |value| (value.max(1e-3) / wanted.max(1e-3)).ln().abs())
}

/// What a material's field is given as; a list to its first comma.
fn field<'a>(parameters: &'a str, name: &str) -> Option<&'a str> {
    parameters
        .split(", ")
        .find_map(|part| part.strip_prefix(name)?.strip_prefix(" = "))
}
