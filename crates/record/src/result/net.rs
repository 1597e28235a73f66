use plateau::MAX_DEGREE;
use serde::de::value::{MapAccessDeserializer, SeqAccessDeserializer};
use serde::de::{MapAccess, SeqAccess, Visitor};
use serde::{Deserialize, Deserializer, Serialize};
use surfaces::{Net, Point, TriangleNet};

use super::unfit::{Unfit, unfit};

/// `rows[i][j]` of a rectangular net.
pub(super) type Rows = Vec<Vec<[f64; 3]>>;

/// `net[i][j]` for rectangular nets, a list of points with their indices for triangular ones.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(super) struct NetEntry(Vec<NetItem>);

#[derive(Debug, Clone, PartialEq, Serialize)]
#[serde(untagged)]
enum NetItem {
    Row(Vec<[f64; 3]>),
    Indexed(IndexedPoint),
}

#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
struct IndexedPoint {
    index: [usize; 3],
    point: [f64; 3],
}

/// Told apart by the first bracket, so that an error names the number within: serde's untagged enums forget the place.
impl<'de> Deserialize<'de> for NetItem {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct Item;
        impl<'de> Visitor<'de> for Item {
            type Value = NetItem;

            fn expecting(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
                f.write_str("a row of points, or a point with its index")
            }

            fn visit_seq<A: SeqAccess<'de>>(self, row: A) -> Result<NetItem, A::Error> {
                Vec::deserialize(SeqAccessDeserializer::new(row)).map(NetItem::Row)
            }

            fn visit_map<A: MapAccess<'de>>(self, point: A) -> Result<NetItem, A::Error> {
                IndexedPoint::deserialize(MapAccessDeserializer::new(point)).map(NetItem::Indexed)
            }
        }
        deserializer.deserialize_any(Item)
    }
}

impl NetEntry {
    pub(super) fn of_rows(rows: Rows) -> Self {
        Self(rows.into_iter().map(NetItem::Row).collect())
    }

    pub(super) fn of_triangle(net: &TriangleNet) -> Self {
        let indexed = |(index, &p): (_, &Point)| NetItem::Indexed(IndexedPoint { index, point: p.into() });
        Self(net.indices().zip(net.points()).map(indexed).collect())
    }

    /// The rectangular net; `key` is where it stands.
    pub(super) fn into_rows(self, key: &str) -> Result<Rows, Unfit> {
        let row = |(k, item)| match item {
            NetItem::Row(row) => Ok(row),
            NetItem::Indexed(_) => {
                Err(unfit(&format!("{key}[{k}]"), "is a point with its index; rows of points make this net"))
            }
        };
        self.0.into_iter().enumerate().map(row).collect()
    }

    /// The triangular net; `key` is where it stands.
    pub(super) fn into_triangle(self, key: &str) -> Result<TriangleNet, Unfit> {
        let count = self.0.len();
        let size = |n: usize| (n + 1) * (n + 2) / 2;
        let degree = (1..=MAX_DEGREE).find(|&n| size(n) == count).ok_or_else(|| {
            unfit(key, format!("has {count} points, no triangular net of degree 1 to {MAX_DEGREE}"))
        })?;
        let blank = TriangleNet::new(degree, vec![Point::ZERO; count]).map_err(|error| unfit(key, error))?;
        let mut ordered = vec![None; count];
        for (k, item) in self.0.into_iter().enumerate() {
            let here = format!("{key}[{k}]");
            let NetItem::Indexed(IndexedPoint { index, point }) = item else {
                return Err(unfit(&here, "is a row; points with their indices make a triangular net"));
            };
            let here = format!("{here}.index");
            let [i, j, l] = index;
            if i > degree || j > degree || l > degree || i + j + l != degree {
                return Err(unfit(&here, format!("{index:?} does not add up to the degree {degree}")));
            }
            if ordered[blank.position(i, j)].replace(Point::from(point)).is_some() {
                return Err(unfit(&here, format!("{index:?} stands there twice")));
            }
        }
        let points: Vec<Point> = ordered.into_iter().flatten().collect();
        TriangleNet::new(degree, points).map_err(|error| unfit(key, error))
    }
}

/// The points of a net, row by row.
pub(super) fn rows(net: &Net) -> Rows {
    net.points()
        .chunks_exact(net.cols())
        .map(|row| row.iter().copied().map(<[f64; 3]>::from).collect())
        .collect()
}

/// The net of rows; `key` is where they stand.
pub(super) fn net(rows: &Rows, key: &str) -> Result<Net, Unfit> {
    let cols = rows.first().map_or(0, Vec::len);
    if let Some(row) = rows.iter().position(|row| row.len() != cols) {
        let found = rows[row].len();
        return Err(unfit(&format!("{key}[{row}]"), format!("has {found} points, the first row {cols}")));
    }
    let most = MAX_DEGREE + 1;
    if !((2..=most).contains(&rows.len()) && (2..=most).contains(&cols)) {
        return Err(unfit(key, format!("has {} x {cols} points; 2 to {most} are possible", rows.len())));
    }
    let points = rows.iter().flatten().copied().map(Point::from).collect();
    Net::new(rows.len(), cols, points).map_err(|error| unfit(key, error))
}
