//! QEMU's machine protocol: one JSON object a line, over QEMU's own standard input and output.

use std::io::{BufRead, BufReader, Read, Write};

use serde_json::{Value, json};

use crate::failure::{During, Failure, Outcome};

/// A connection to QEMU's monitor.
pub struct Qmp<R: Read, W: Write> {
    from: BufReader<R>,
    to: W,
}

impl<R: Read, W: Write> Qmp<R, W> {
    /// Waits for the greeting and leaves negotiation mode.
    pub fn connect(from: R, to: W) -> Outcome<Self> {
        let mut qmp = Self {
            from: BufReader::new(from),
            to,
        };
        let greeting = qmp.message()?;
        if greeting.get("QMP").is_none() {
            return Err(Failure::incomplete(format!("QEMU greeted with {greeting}")));
        }
        qmp.execute("qmp_capabilities", json!({}))?;
        Ok(qmp)
    }

    /// Runs a command and returns its result; events in between are skipped.
    pub fn execute(&mut self, name: &str, arguments: Value) -> Outcome<Value> {
        let request = json!({ "execute": name, "arguments": arguments });
        writeln!(self.to, "{request}")
            .and_then(|()| self.to.flush())
            .during(|| format!("asking QEMU for {name}"))?;
        loop {
            let mut message = self.message()?;
            if let Some(result) = message.get_mut("return") {
                return Ok(result.take());
            }
            if let Some(error) = message.get("error") {
                let words = error
                    .get("desc")
                    .and_then(Value::as_str)
                    .unwrap_or("no reason given");
                return Err(Failure::incomplete(format!("QEMU refused {name}: {words}")));
            }
        }
    }

    fn message(&mut self) -> Outcome<Value> {
        let mut line = String::new();
        let length = self
            .from
            .read_line(&mut line)
            .during(|| "listening to QEMU".to_string())?;
        if length == 0 {
            return Err(Failure::incomplete("QEMU ended"));
        }
        serde_json::from_str(&line).during(|| format!("reading what QEMU said, {line:?}"))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const GREETING: &str = "{\"QMP\": {\"version\": {}, \"capabilities\": []}}\n{\"return\": {}}\n";

    #[test]
    fn skips_events_and_returns_results() {
        let answers = format!(
            "{GREETING}{{\"event\": \"RESUME\", \"timestamp\": {{}}}}\n{{\"return\": {{\"running\": true}}}}\n"
        );
        let mut asked = Vec::new();
        let mut qmp = Qmp::connect(answers.as_bytes(), &mut asked).unwrap();
        assert_eq!(
            qmp.execute("query-status", json!({})).unwrap(),
            json!({ "running": true })
        );
        let asked = String::from_utf8(asked).unwrap();
        let names: Vec<Value> = asked
            .lines()
            .map(|line| serde_json::from_str::<Value>(line).unwrap()["execute"].clone())
            .collect();
        assert_eq!(names, ["qmp_capabilities", "query-status"]);
    }

    #[test]
    fn a_refusal_is_told_in_qemus_words() {
        let answers = format!(
            "{GREETING}{{\"error\": {{\"class\": \"GenericError\", \"desc\": \"no such console\"}}}}\n"
        );
        let mut qmp = Qmp::connect(answers.as_bytes(), Vec::new()).unwrap();
        let failure = qmp.execute("screendump", json!({})).unwrap_err();
        assert!(failure.message.contains("no such console"), "{failure}");
    }

    #[test]
    fn an_end_is_an_error() {
        assert!(Qmp::connect("".as_bytes(), Vec::new()).is_err());
        let mut qmp = Qmp::connect(GREETING.as_bytes(), Vec::new()).unwrap();
        assert!(qmp.execute("cont", json!({})).is_err());
    }
}
