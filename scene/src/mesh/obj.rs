//! Wavefront OBJ: corners, normals, faces and the names of their materials.
//!
//! Own code, because files come from anywhere: of the readers that were tried,
//! tobj 4.0 overflows on the index of a normal before it is checked, obj-rs 0.7
//! panics on statements that it has not implemented, obj 0.10 cuts a name
//! within a character; and none tells in which line a bad index stands.

use std::fmt;

/// Greatest number of triangles, polygons counted as the triangles of their fans.
const GREATEST_COUNT: usize = 100_000;
/// Greatest magnitude of a coordinate.
const GREATEST_COORDINATE: f64 = 1e6;
/// Least length of a normal.
const LEAST_NORMAL: f64 = 1e-6;
/// Least sine of a triangle's angles.
const LEAST_SINE: f64 = 1e-9;

/// What an OBJ file says of a surface; all indices are within range.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Obj {
    /// Positions, in the file's order.
    pub positions: Vec<[f64; 3]>,
    /// Unit normals, in the file's order.
    pub normals: Vec<[f64; 3]>,
    /// Triangles, polygons as fans.
    pub triangles: Vec<ObjTriangle>,
    /// Names that `usemtl` gave, in the order of their first use by a face.
    pub materials: Vec<String>,
}

/// A triangle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ObjTriangle {
    /// Indices of its corners' positions.
    pub corners: [usize; 3],
    /// Indices of its corners' normals, where the file has them.
    pub normals: Option<[usize; 3]>,
    /// Index into [`Obj::materials`], of the name under which it stands.
    pub material: Option<usize>,
}

/// A mistake in an OBJ file.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub struct ObjError {
    /// Line, from 1; `None` where something is missing from the whole.
    pub line: Option<usize>,
    /// What is wrong.
    pub message: String,
}

impl fmt::Display for ObjError {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.line {
            Some(line) => write!(formatter, "line {line}: {}", self.message),
            None => formatter.write_str(&self.message),
        }
    }
}

impl Obj {
    /// Reads the text of a file that is called `file_name`. Texture
    /// coordinates, groups, smoothing groups, lines and points are passed
    /// over; a material library is not opened.
    ///
    /// # Errors
    /// The first mistake: a statement that OBJ files of polygons don't have, a
    /// coordinate that is no finite number, an index of nothing, a triangle
    /// without an area, too many triangles or none, a library that is the file
    /// itself.
    pub fn read(file_name: &str, text: &str) -> Result<Self, ObjError> {
        let mut reader = Reader::default();
        for (index, line) in text.lines().enumerate() {
            reader
                .statement(file_name, line)
                .map_err(|message| ObjError {
                    line: Some(index + 1),
                    message,
                })?;
        }
        if reader.obj.triangles.is_empty() {
            return Err(ObjError {
                line: None,
                message: "has no face".to_owned(),
            });
        }
        Ok(reader.obj)
    }
}

#[derive(Default)]
struct Reader {
    obj: Obj,
    /// What `usemtl` said last.
    material: Option<String>,
}

impl Reader {
    fn statement(&mut self, file_name: &str, line: &str) -> Result<(), String> {
        let line = line.split('#').next().unwrap_or_default();
        let mut words = line.split_whitespace();
        let Some(kind) = words.next() else {
            return Ok(());
        };
        match kind {
            "v" => {
                let position = triple(words)?;
                self.obj.positions.push(position);
            }
            "vn" => {
                let normal = triple(words)?;
                let length = crate::vector::length(normal);
                if length < LEAST_NORMAL {
                    return Err(format!(
                        "a normal of length {length:e}: must be at least {LEAST_NORMAL:e}"
                    ));
                }
                self.obj.normals.push(normal.map(|c| c / length));
            }
            "f" => self.face(words)?,
            "usemtl" => self.material = words.next().map(str::to_owned),
            "mtllib" if words.any(|name| name == file_name) => {
                return Err("this library is the file itself".to_owned());
            }
            "mtllib" | "vt" | "vp" | "o" | "g" | "s" | "l" | "p" => {}
            other => {
                return Err(format!(
                    "`{}` is no statement of a mesh: must be v, vn, vt, f, usemtl, mtllib, o, g, s, l or p",
                    crate::error::shortened(other)
                ));
            }
        }
        Ok(())
    }

    fn face<'a>(&mut self, words: impl Iterator<Item = &'a str>) -> Result<(), String> {
        let corners = words
            .map(|word| self.corner(word))
            .collect::<Result<Vec<_>, _>>()?;
        let [first, rest @ ..] = &corners[..] else {
            return Err("a face of no corner: must have 3 or more".to_owned());
        };
        if rest.len() < 2 {
            return Err(format!(
                "a face of {} corners: must have 3 or more",
                corners.len()
            ));
        }
        if self.obj.triangles.len() + rest.len() - 1 > GREATEST_COUNT {
            return Err(format!(
                "too many triangles: must be at most {GREATEST_COUNT}"
            ));
        }
        let material = self.material.as_ref().map(|name| {
            let known = self.obj.materials.iter().position(|known| known == name);
            known.unwrap_or_else(|| {
                self.obj.materials.push(name.clone());
                self.obj.materials.len() - 1
            })
        });
        for pair in rest.windows(2) {
            let corners = [first, &pair[0], &pair[1]];
            let normals = match corners.map(|(_, normal)| *normal) {
                [Some(a), Some(b), Some(c)] => Some([a, b, c]),
                [None, None, None] => None,
                _ => return Err("some corners have a normal, others have none".to_owned()),
            };
            let triangle = ObjTriangle {
                corners: corners.map(|(position, _)| *position),
                normals,
                material,
            };
            if self.is_degenerate(triangle.corners) {
                return Err("a triangle whose corners lie on a line".to_owned());
            }
            self.obj.triangles.push(triangle);
        }
        Ok(())
    }

    fn is_degenerate(&self, corners: [usize; 3]) -> bool {
        use crate::vector::{cross, length, sub};
        let [a, b, c] = corners.map(|corner| self.obj.positions[corner]);
        let (ab, ac) = (sub(b, a), sub(c, a));
        let longest = length(ab).max(length(ac)).max(length(sub(c, b)));
        // The area, over that of a square upon the longest side.
        length(cross(ab, ac)) <= LEAST_SINE * longest * longest
    }

    /// `position`, `position/texture`, `position//normal` or all three.
    fn corner(&self, word: &str) -> Result<(usize, Option<usize>), String> {
        let mut parts = word.split('/');
        let position = parts.next().unwrap_or_default();
        let normal = parts.nth(1).filter(|normal| !normal.is_empty());
        if parts.next().is_some() {
            return Err(format!(
                "the corner `{}` has more than three indices",
                crate::error::shortened(word)
            ));
        }
        Ok((
            index(position, self.obj.positions.len(), "vertex")?,
            normal
                .map(|normal| index(normal, self.obj.normals.len(), "normal"))
                .transpose()?,
        ))
    }
}

/// An index from 1, or from −1 backwards, of `count` things.
fn index(word: &str, count: usize, what: &str) -> Result<usize, String> {
    let found = match word.parse::<i64>() {
        Ok(number) if number > 0 => usize::try_from(number - 1).ok(),
        Ok(number) if number < 0 => usize::try_from(number.unsigned_abs())
            .ok()
            .and_then(|back| count.checked_sub(back)),
        _ => None,
    };
    found.filter(|index| *index < count).ok_or_else(|| {
        format!(
            "`{}` is no {what}: there are {count} so far",
            crate::error::shortened(word)
        )
    })
}

fn triple<'a>(mut words: impl Iterator<Item = &'a str>) -> Result<[f64; 3], String> {
    let mut coordinate = || {
        let word = words.next().ok_or("three numbers are needed")?;
        match word.parse::<f64>() {
            Ok(number) if number.abs() <= GREATEST_COORDINATE => Ok(number),
            _ => Err(format!(
                "`{}` is no number from -{GREATEST_COORDINATE} to {GREATEST_COORDINATE}",
                crate::error::shortened(word)
            )),
        }
    };
    Ok([coordinate()?, coordinate()?, coordinate()?])
}
