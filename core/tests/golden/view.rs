//! Pictures whose view was made beforehand: tables that hold what they say, and
//! tables that contradict themselves.

use microbrdf::geometry::Direction;
use microbrdf::shade::{
    FourSamples, MeshView, NoDepths, Octahedral, OneSample, Shadowed, Span, StoredDepths,
    Unshadowed,
};
use microbrdf_bits::Checksum;

use crate::Sums;
use crate::given::{Viewed, Words};
use crate::scene::{behind, camera, directions, lamps, planes};

/// Columns of the pictures.
const WIDTH: u16 = 20;
/// Rows.
const HEIGHT: u16 = 28;

/// A view of normals `N`.
struct Table<N> {
    rows: Vec<u32>,
    spans: Vec<Span>,
    normals: Vec<N>,
    codes: Vec<u16>,
}

/// Adds a sum for each picture, and one for the normals alone.
pub fn add<A: Viewed>(sums: &mut Sums) {
    let level = camera::<A>([0.0, 1.0, 0.0], WIDTH, HEIGHT, 0.05);
    let above = camera::<A>([0.0, 0.6, -0.8], WIDTH, HEIGHT, 0.05);
    let (planes, lights, lamps) = (planes::<A>(), directions::<A>(), lamps::<A>());

    let (three, four) = (whole::<[u8; 3]>(), whole::<[i16; 2]>());
    sums.push(
        "view, three bytes",
        behind(
            three.without_depths(),
            level,
            &planes,
            &lights,
            Unshadowed,
            OneSample,
        ),
    );
    sums.push(
        "view, four bytes, four samples",
        behind(
            four.without_depths(),
            above,
            &planes,
            &lights,
            Unshadowed,
            FourSamples,
        ),
    );
    sums.push(
        "view, three bytes, points in shadow",
        behind(
            three.with_depths::<A>(),
            above,
            &planes,
            &lamps,
            Shadowed,
            OneSample,
        ),
    );
    sums.push(
        "view, four bytes, points",
        behind(
            four.with_depths::<A>(),
            level,
            &planes,
            &lamps,
            Unshadowed,
            OneSample,
        ),
    );

    let (three, four) = (contradictory::<[u8; 3]>(), contradictory::<[i16; 2]>());
    sums.push(
        "view that contradicts itself, three bytes",
        behind(
            three.without_depths(),
            level,
            &planes,
            &lights,
            Unshadowed,
            OneSample,
        ),
    );
    sums.push(
        "view that contradicts itself, four bytes, points in shadow",
        behind(
            four.with_depths::<A>(),
            level,
            &planes,
            &lamps,
            Shadowed,
            OneSample,
        ),
    );

    let mut words = Words::new(0x0C7A);
    let mut sum = Checksum::new();
    for _ in 0..4_000 {
        let [a, b, c, _] = words.word().to_le_bytes();
        let word = words.word();
        for normal in [
            [a, b, c].normal::<A>(),
            [word as i16, (word >> 16) as i16].normal::<A>(),
        ] {
            let Direction { x, y, z, .. } = normal;
            for component in [x, y, z] {
                sum.feed(A::bits(component));
            }
        }
    }
    sums.push("view, normals", sum.value());
}

impl<N> Table<N> {
    fn without_depths(&self) -> MeshView<'_, N> {
        MeshView {
            rows: &self.rows,
            spans: &self.spans,
            normals: &self.normals,
            depths: NoDepths,
        }
    }

    fn with_depths<A: Viewed>(&self) -> MeshView<'_, N, StoredDepths<'_, A>> {
        MeshView {
            rows: &self.rows,
            spans: &self.spans,
            normals: &self.normals,
            depths: StoredDepths {
                near: A::length(1.5),
                range: A::length(7.25),
                codes: &self.codes,
            },
        }
    }
}

/// Two spans in most rows, one of them of no material that the scene has.
fn whole<N: Octahedral>() -> Table<N> {
    let mut table = Table {
        rows: vec![0],
        spans: Vec::new(),
        normals: Vec::new(),
        codes: Vec::new(),
    };
    let mut words = Words::new(0x0E55);
    for y in 0..HEIGHT {
        let [left, right] = [1 + y % 4, 9 + y % 3];
        let spans = [(left, 7), (right, WIDTH - y % 2)];
        for (start, end) in spans.into_iter().skip(usize::from(y % 5 == 3)) {
            let material = words.word() % 4;
            let first = table.normals.len() as u32;
            table
                .spans
                .push(Span::new(start, end, first, material as u8));
            for _ in start..end {
                let coordinate = |word: u32| word as i32 % (N::GREATEST + 1);
                let coordinates = [coordinate(words.word()), coordinate(words.word())];
                table.normals.push(N::from_coordinates(coordinates));
                table.codes.push(words.word() as u16);
            }
        }
        table.rows.push(table.spans.len() as u32);
    }
    table
}

/// Spans that overlap, end before they start, or name normals that are not
/// there; rows that end before they start, name spans that are not there, or are
/// missing; depths for some of the normals.
fn contradictory<N: Octahedral>() -> Table<N> {
    let Table {
        mut rows,
        mut spans,
        mut normals,
        mut codes,
    } = whole::<N>();
    rows[5] = rows[4] + 3;
    rows[8] = u32::MAX;
    rows[12] = spans.len() as u32 + 1;
    rows.truncate(26);
    spans[4] = Span::new(9, 3, 7, 0);
    spans[5] = Span::new(4, 12, u32::MAX, 1);
    spans[6] = Span::new(0, u16::MAX, 0x00FF_FFFF, 2);
    spans[20] = Span::new(3, 15, normals.len() as u32 - 5, 1);
    normals.truncate(normals.len() - 60);
    codes.truncate(normals.len() - 90);
    Table {
        rows,
        spans,
        normals,
        codes,
    }
}
