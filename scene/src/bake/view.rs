//! The table of what is seen of meshes.

use std::fmt::Debug;

use super::line;
use crate::host::HostArithmetic;
use crate::mesh::{PreparedView, StoredNormals};

/// Writes the statics of a view; gives its type and its value.
pub(super) fn bake<A: HostArithmetic>(
    code: &mut String,
    view: Option<&PreparedView<A>>,
) -> (String, String) {
    let Some(view) = view else {
        return ("NoView".into(), "NoView".into());
    };
    let spans: Vec<_> = view
        .spans
        .iter()
        .map(|span| {
            let (start, end, first, material) = span.parts();
            format!("Span::new({start}, {end}, {first}, {material})")
        })
        .collect();
    list(code, "ROWS", "u32", &view.rows);
    line(
        code,
        format!(
            "static SPANS: [Span; {}] = [{}];",
            spans.len(),
            spans.join(", ")
        ),
    );
    let normal = match &view.normals {
        StoredNormals::Three(normals) => list(code, "NORMALS", "[u8; 3]", normals),
        StoredNormals::Four(normals) => list(code, "NORMALS", "[i16; 2]", normals),
    };
    let (kind, depths) = match &view.depths {
        None => ("NoDepths", "NoDepths".to_owned()),
        Some((near, range, codes)) => {
            list(code, "DEPTHS", "u16", codes);
            let value = format!(
                "StoredDepths {{ near: {}, range: {}, codes: &DEPTHS }}",
                A::length_code(*near),
                A::length_code(*range)
            );
            ("StoredDepths<'static, A>", value)
        }
    };
    line(
        code,
        format!("type SeenMesh = MeshView<'static, {normal}, {kind}>;"),
    );
    (
        "SeenMesh".into(),
        format!("MeshView {{ rows: &ROWS, spans: &SPANS, normals: &NORMALS, depths: {depths} }}"),
    )
}

/// A static array; gives the type of its entries.
fn list<'a, T: Debug>(code: &mut String, name: &str, kind: &'a str, entries: &[T]) -> &'a str {
    line(
        code,
        format!("static {name}: [{kind}; {}] = {entries:?};", entries.len()),
    );
    kind
}
