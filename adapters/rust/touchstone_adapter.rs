//! Speaks Touchstone's protocol (docs/protocol.md) for an adapter, which supplies a card and one function a query.
//! A function gets a scene (docs/scene.schema.json) and returns the result (docs/protocol.schema.json), or Err(No): this
//! scene is not answered, or the engine failed. A panic counts as a failure of the engine. Needs no other crate.
#![allow(dead_code)]
use std::{fs::File, io::{BufRead, Write}, os::fd::FromRawFd, panic};
#[derive(Clone, Debug, PartialEq)]
pub enum Json { Null, Bool(bool), Number(f64), Text(String), List(Vec<Json>), Object(Vec<(String, Json)>) }
use Json::*;
/// The adapter abstains; the engine failed; it says that it does not take this scene; a number is not finite, and where.
pub enum No { Abstains(String), Breaks(String), Refuses(String), NotFinite(String) }
pub type Query = fn(&Json) -> Result<Json, No>;
pub type Snippet = fn(&Json) -> String; // a program in the engine's own API that asks it the same about the scene

pub fn text(s: &str) -> Json { Text(s.into()) }
pub fn vector(v: &[f64]) -> Json { List(v.iter().map(|x| Number(*x)).collect()) }
pub fn object(members: Vec<(&str, Json)>) -> Json { Object(members.into_iter().map(|(k, v)| (k.into(), v)).collect()) }
pub fn abstains<T>(why: &str) -> Result<T, No> { Err(No::Abstains(why.into())) }
fn quoted(s: &str) -> String {
    let escaped = |c: char| if c < ' ' || c == '"' || c == '\\' { format!("\\u{:04x}", c as u32) } else { c.to_string() };
    format!("\"{}\"", s.chars().map(escaped).collect::<String>())
}

/// A member that is not there is Null; a number, text or list that is not one panics, which the judge is told.
impl Json {
    pub fn get(&self, key: &str) -> &Json {
        let Object(members) = self else { return &Null };
        members.iter().find(|(k, _)| k == key).map_or(&Null, |(_, v)| v)
    }
    pub fn number(&self) -> f64 { if let Number(x) = self { *x } else { panic!("expected a number: {self:?}") } }
    pub fn text(&self) -> &str { if let Text(s) = self { s } else { panic!("expected a text: {self:?}") } }
    pub fn list(&self) -> &[Json] { if let List(l) = self { l } else { panic!("expected a list: {self:?}") } }
    pub fn vec3(&self) -> [f64; 3] { std::array::from_fn(|i| self.list()[i].number()) }
    fn json(&self, place: &str) -> Result<String, No> {
        let joined = |parts: Result<Vec<String>, No>| parts.map(|parts| parts.join(","));
        Ok(match self {
            Null => "null".into(),
            Bool(b) => b.to_string(),
            Text(s) => quoted(s),
            Number(x) if x.is_finite() => format!("{x:?}"), // the shortest digits that read back bit for bit
            Number(x) => return Err(No::NotFinite(format!("{place} is {x}"))),
            List(l) => format!("[{}]", joined(l.iter().enumerate().map(|(i, v)| v.json(&format!("{place}[{i}]"))).collect())?),
            Object(m) => format!("{{{}}}", joined(m.iter().map(|(k, v)| {
                Ok(format!("{}:{}", quoted(k), v.json(&format!("{place}.{k}"))?))
            }).collect())?),
        })
    }
}
struct Reader<'a> { bytes: &'a [u8], at: usize }
impl Reader<'_> {
    fn peek(&mut self) -> u8 {
        while self.bytes.get(self.at).is_some_and(u8::is_ascii_whitespace) { self.at += 1; }
        *self.bytes.get(self.at).unwrap_or_else(|| panic!("the line ends early"))
    }
    fn take(&mut self, c: u8) -> bool { let is = self.peek() == c; self.at += is as usize; is }
    fn expect(&mut self, c: u8) { assert!(self.take(c), "expected {:?} at byte {}", c as char, self.at) }
    fn string(&mut self) -> String { // escapes are kept as they are: they occur only in names, which are for people
        self.expect(b'"');
        let start = self.at;
        while self.bytes[self.at] != b'"' { self.at += if self.bytes[self.at] == b'\\' { 2 } else { 1 }; }
        self.at += 1;
        String::from_utf8_lossy(&self.bytes[start..self.at - 1]).into_owned()
    }
    fn value(&mut self) -> Json {
        let open = self.peek();
        if open == b'"' { return Text(self.string()); }
        if !b"[{".contains(&open) {
            let start = self.at;
            while self.bytes.get(self.at).is_some_and(|c| !b",]} \t".contains(c)) { self.at += 1; }
            return match std::str::from_utf8(&self.bytes[start..self.at]).unwrap() {
                "null" => Null, "true" => Bool(true), "false" => Bool(false), word => Number(word.parse().expect(word)),
            };
        }
        let (mut list, mut members) = (vec![], vec![]);
        self.at += 1;
        while !self.take(open + 2) {
            if list.len() + members.len() > 0 { self.expect(b','); }
            if open == b'[' { list.push(self.value()); continue; }
            members.push(((self.string(), self.expect(b':')).0, self.value()));
        }
        if open == b'[' { List(list) } else { Object(members) }
    }
}

fn found<T: Copy>(all: &[(&str, T)], name: &str, no: String) -> Result<T, No> {
    all.iter().find(|(known, _)| *known == name).map(|(_, it)| *it).ok_or(No::Abstains(no))
}
fn answer(message: &Json, card: &Json, queries: &[(&str, Query)], snippets: &[(&str, Snippet)]) -> Result<String, No> {
    let (op, scene) = (message.get("op").text(), message.get("scene"));
    if op == "start" { return Ok(format!("\"protocol\":1,\"card\":{}", card.json("card")?)); }
    let name = message.get("query").text();
    let snippet = || Ok(format!("\"snippet\":{}", quoted(&found(snippets, name, format!("no snippets of {name}"))?(scene))));
    if op == "reproduce" { return snippet(); }
    Ok(format!("\"result\":{}", found(queries, name, format!("no {name} query"))?(scene)?.json("result")?))
}
extern "C" { fn dup(fd: i32) -> i32; fn dup2(from: i32, to: i32) -> i32; }

/// Answers until `stop` or the end of stdin. `card`: name, version, precision and what else docs/protocol.md lists; the
/// queries that it answers are added. What the engine prints goes to stderr, and spoils no answer.
pub fn serve(mut card: Vec<(&str, Json)>, queries: &[(&str, Query)], snippets: &[(&str, Snippet)]) {
    card.push(("answers", List(queries.iter().map(|q| text(q.0)).collect())));
    card.push(("reproduces", List(snippets.iter().map(|s| text(s.0)).collect())));
    let card = object(card);
    let mut out = unsafe { let out = File::from_raw_fd(dup(1)); dup2(2, 1); out };
    for line in std::io::stdin().lock().lines().map_while(Result::ok) {
        let message = panic::catch_unwind(|| Reader { bytes: line.as_bytes(), at: 0 }.value()).unwrap_or(Null);
        let seq = if let Number(seq) = message.get("seq") { *seq as i64 } else { 0 };
        if *message.get("op") == text("stop") { break; }
        let said = panic::catch_unwind(|| answer(&message, &card, queries, snippets)).unwrap_or_else(|panic| {
            let text = panic.downcast_ref::<&str>().map(|s| s.to_string());
            Err(No::Breaks(text.or(panic.downcast_ref::<String>().cloned()).unwrap_or("panicked".into())))
        });
        let breaks = |kind: &str, how: &str| format!("\"breaks\":{{\"kind\":\"{kind}\",\"how\":{}}}", quoted(how));
        let member = said.unwrap_or_else(|no| match no {
            No::Abstains(why) => format!("\"abstains\":{}", quoted(&why)), No::Breaks(how) => breaks("threw", &how),
            No::Refuses(why) => breaks("refused", &why), No::NotFinite(place) => breaks("garbage", &place),
        });
        writeln!(out, "{{\"seq\":{seq},{member}}}").expect("stdout is closed");
    }
}
