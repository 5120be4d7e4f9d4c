//! `report.json`: what came over the line, and how it compares.

use serde_json::{Map, Value, json};

use crate::board::Board;

/// Version of the fields' meaning.
pub const SCHEMA: u32 = 1;

/// Fields that the receiver counts.
const OF_RECEIVER: [&str; 7] = [
    "width",
    "height",
    "rows_received",
    "rows_missing",
    "crc_errors",
    "bytes_on_wire",
    "frame_crc_ok",
];

/// Fields by which the device says what it is, and which must be what was asked for.
const OF_DEVICE: [&str; 3] = ["board", "core", "arithmetic"];

/// Fields that the comparison with host and reference brings.
const OF_COMPARISON: [&str; 9] = [
    "exposure",
    "device_equals_host",
    "lsb_error_max",
    "code_error_max",
    "code_error_share",
    "code_error_over_one_share",
    "class_flips",
    "delta_e_p95",
    "delta_e_max",
];

/// Puts the report together. What a source does not say is null: never a made-up value.
pub fn assemble(
    board: &Board,
    compiler: &str,
    arithmetic: &str,
    received: &Value,
    compared: &Value,
    panel_equals_host: Option<bool>,
) -> Value {
    let mut report = Map::new();
    report.insert("schema".into(), json!(SCHEMA));
    report.insert("board".into(), json!(board.name));
    report.insert("core".into(), json!(board.core));
    report.insert("compiler".into(), json!(compiler));
    report.insert("arithmetic".into(), json!(arithmetic));
    for field in OF_RECEIVER {
        report.insert(
            field.into(),
            received.get(field).cloned().unwrap_or_default(),
        );
    }
    // What the device said of itself, where that is something else.
    for field in OF_DEVICE {
        if received[field] != report[field] {
            report.insert(format!("device_{field}"), received[field].clone());
        }
    }
    for field in OF_COMPARISON {
        report.insert(
            field.into(),
            compared.get(field).cloned().unwrap_or_default(),
        );
    }
    // Without a comparison the device's picture equals nothing.
    if report["device_equals_host"].is_null() {
        report.insert("device_equals_host".into(), json!(false));
    }
    if let Some(equal) = panel_equals_host {
        report.insert("panel_equals_host".into(), json!(equal));
    }
    Value::Object(report)
}

/// Why a report is not that of a whole frame that equals the host's; empty where it is.
pub fn faults(report: &Value) -> Vec<String> {
    let mut faults = Vec::new();
    for (field, what) in [
        ("rows_missing", "rows missing"),
        ("crc_errors", "CRC errors"),
    ] {
        match report[field].as_u64() {
            Some(0) => {}
            Some(count) => faults.push(format!("{count} {what}")),
            None => faults.push(format!("{what}: not known")),
        }
    }
    if report["rows_received"].is_null() || report["rows_received"] != report["height"] {
        faults.push(format!(
            "{} of {} rows received",
            report["rows_received"], report["height"]
        ));
    }
    if report["frame_crc_ok"] != true {
        faults.push("the checksum of the whole frame is wrong or did not come".into());
    }
    for field in OF_DEVICE {
        if let Some(said) = report.get(format!("device_{field}")) {
            faults.push(format!(
                "the device's {field} is {said}, not {}",
                report[field]
            ));
        }
    }
    if report["device_equals_host"] != true {
        faults.push("the device's picture differs from the host's".into());
    }
    if report
        .get("panel_equals_host")
        .is_some_and(|equal| equal != true)
    {
        faults.push("the panel differs from what the host predicts".into());
    }
    faults
}

/// The figures, in a few whole lines.
pub fn lines(report: &Value) -> String {
    let r = |field: &str| report[field].to_string().trim_matches('"').to_string();
    let real = |field: &str, digits: usize| match report[field].as_f64() {
        Some(value) => format!("{value:.digits$}"),
        None => "?".to_string(),
    };
    let percent = |field: &str| match report[field].as_f64() {
        Some(share) => format!("{:.3} %", share * 100.0),
        None => "?".to_string(),
    };
    let same = |field: &str| {
        if report[field] == true {
            "equals"
        } else {
            "DIFFERS from"
        }
    };
    let mut text = format!(
        "frame      {} x {} from {} ({}), {}: {} rows, {} missing, {} CRC errors, {} bytes on the wire\n\
         device     {} the host's picture\n",
        r("width"),
        r("height"),
        r("board"),
        r("core"),
        r("arithmetic"),
        r("rows_received"),
        r("rows_missing"),
        r("crc_errors"),
        r("bytes_on_wire"),
        same("device_equals_host"),
    );
    if report.get("panel_equals_host").is_some() {
        text += &format!(
            "panel      {} the host's prediction\n",
            same("panel_equals_host")
        );
    }
    text += &format!(
        "reference  error at most {} LSB, code error at most {}; {} of codes off by one, {} by more; {} class flips; \
         \u{394}E00 {} (95th percentile), {} (greatest)\n",
        real("lsb_error_max", 2),
        r("code_error_max"),
        percent("code_error_share"),
        percent("code_error_over_one_share"),
        r("class_flips"),
        real("delta_e_p95", 3),
        real("delta_e_max", 3),
    );
    if !report["stack_bytes"].is_null() {
        text += &format!(
            "memory     {} bytes of flash, {} of RAM, {} of stack\n",
            r("flash_bytes"),
            r("ram_bytes"),
            r("stack_bytes")
        );
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::board::BOARDS;

    fn received() -> Value {
        json!({ "width": 256, "height": 128, "rows_received": 128, "rows_missing": 0,
                "crc_errors": 0, "bytes_on_wire": 100_000, "frame_crc_ok": true,
                "board": "lm3s6965evb", "core": "cortex-m3", "arithmetic": "q31" })
    }

    fn compared() -> Value {
        json!({ "exposure": 0.5, "device_equals_host": true, "lsb_error_max": 0.9, "code_error_max": 1,
                "code_error_share": 0.002, "code_error_over_one_share": 0.0, "class_flips": 3,
                "delta_e_p95": 0.01, "delta_e_max": 0.4 })
    }

    fn report(received: &Value, compared: &Value, panel: Option<bool>) -> Value {
        assemble(&BOARDS[0], "rustc 1.0", "q31", received, compared, panel)
    }

    #[test]
    fn a_whole_and_equal_frame_has_no_fault() {
        let report = report(&received(), &compared(), Some(true));
        assert_eq!(faults(&report), Vec::<String>::new());
        for field in OF_RECEIVER.iter().chain(&OF_COMPARISON) {
            assert!(!report[*field].is_null(), "{field}");
        }
        assert_eq!(report["core"], "cortex-m3");
    }

    #[test]
    fn every_fault_is_found() {
        for (field, value) in [
            ("rows_received", json!(127)),
            ("rows_received", Value::Null),
            ("rows_missing", json!(1)),
            ("crc_errors", json!(2)),
            ("crc_errors", Value::Null),
            ("frame_crc_ok", json!(false)),
            ("frame_crc_ok", Value::Null),
            ("board", json!("microbit")),
            ("core", Value::Null),
            ("arithmetic", json!("f32")),
        ] {
            let mut broken = received();
            broken[field] = value.clone();
            assert!(
                !faults(&report(&broken, &compared(), None)).is_empty(),
                "{field} {value}"
            );
        }
        let mut broken = compared();
        broken["device_equals_host"] = json!(false);
        assert_eq!(faults(&report(&received(), &broken, None)).len(), 1);
        assert_eq!(
            faults(&report(&received(), &compared(), Some(false))).len(),
            1
        );
    }

    #[test]
    fn nothing_received_is_no_success() {
        let report = report(&Value::Null, &Value::Null, None);
        assert!(faults(&report).len() >= 4);
        assert_eq!(report["device_equals_host"], false);
        assert!(report["lsb_error_max"].is_null());
    }

    #[test]
    fn boards_without_a_panel_say_nothing_of_it() {
        assert!(
            report(&received(), &compared(), None)
                .get("panel_equals_host")
                .is_none()
        );
    }
}
