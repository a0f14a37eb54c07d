//! Writer of records as comma-separated values.

use crate::columns::{COLUMNS, Cell, Row};
use crate::record::Records;

/// Formats records as comma-separated values (RFC 4180): a row for each record and a column for
/// each field, empty if a record has no such figure. The column `kind` is `rays` or `picture`.
pub fn csv(records: &Records) -> String {
    let line = |cells: Vec<String>| cells.join(",") + "\r\n";
    let mut text = line(COLUMNS.iter().map(|column| column.key.to_owned()).collect());
    for row in Row::all(records) {
        text += &line(COLUMNS.iter().map(|column| quoted(&(column.cell)(&row))).collect());
    }
    text
}

fn quoted(cell: &Cell) -> String {
    match cell {
        Cell::Empty => String::new(),
        Cell::Number(number) => number.to_string(),
        Cell::Text(text) if text.contains([',', '"', '\r', '\n']) => {
            format!("\"{}\"", text.replace('"', "\"\""))
        }
        Cell::Text(text) => text.clone(),
    }
}

#[cfg(test)]
mod tests {
    use serde_json::{Value, to_value};

    use super::*;
    use crate::record::{PictureRecord, RayRecord, TimeRecord};

    fn records() -> Records {
        let mut records = Records::default();
        records.rays.push(RayRecord { angle_deg: 60.5, ..RayRecord::default() });
        records.rays[0].method.method = "a,\"b\"".to_owned();
        let flicker = Some(0.25);
        let picture =
            PictureRecord { size: [3, 2], flicker_rms: flicker, flicker_flip: flicker, ..Default::default() };
        records.pictures.push(PictureRecord {
            psnr_db: Some(30.0),
            cost: Some(Default::default()),
            wave_reads: Some(1.0),
            distance_m: Some(2.0),
            error: Some(Default::default()),
            times: Some(TimeRecord { trace_pass_ms: flicker, shade_pass_ms: flicker, ..Default::default() }),
            ..picture
        });
        records
    }

    #[test]
    fn every_record_is_a_row_and_text_with_commas_is_quoted() {
        let text = csv(&records());
        let lines: Vec<&str> = text.split_terminator("\r\n").collect();
        assert_eq!(lines.len(), 3);
        let at = |key: &str| COLUMNS.iter().position(|column| column.key == key).expect("a column");
        assert!(lines[1].starts_with("rays,\"a,\"\"b\"\"\",") && lines[1].contains(",60.5,"), "{}", lines[1]);
        assert_eq!(lines[2].split(',').nth(at("size")), Some("3x2"));
        assert_eq!(lines[2].split(',').nth(at("angle_deg")), Some(""));
    }

    /// A field that is missing in one of the two would be hidden from its readers.
    #[test]
    fn columns_are_the_fields_of_records() {
        let records = records();
        let keys = |record: Value| record.as_object().expect("fields").keys().cloned().collect::<Vec<_>>();
        let fields = [
            keys(to_value(&records.rays[0]).expect("JSON")),
            keys(to_value(&records.pictures[0]).expect("JSON")),
        ];
        for (row, mut fields) in Row::all(&records).zip(fields) {
            let has = |column: &&crate::columns::Column| (column.cell)(&row) != Cell::Empty;
            let mut columns: Vec<String> =
                COLUMNS.iter().filter(has).map(|column| column.key.to_owned()).collect();
            // The kind is not a field. The settings by which methods are compared are only present
            // if they are set.
            columns.retain(|key| key != "kind");
            let is_of_some =
                |key: &String| key.starts_with("steps") || ["map_format", "shadow"].contains(&key.as_str());
            fields.retain(|key| !is_of_some(key));
            columns.sort();
            fields.sort();
            assert_eq!(columns, fields);
        }
    }
}
