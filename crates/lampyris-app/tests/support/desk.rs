//! A desk that runs, and a client of it that is no browser.

use super::{Folder, command};
use serde_json::{Value, json};
use std::io::ErrorKind::{TimedOut, WouldBlock};
use std::io::{BufRead, BufReader, Read, Write};
use std::net::TcpStream;
use std::process::{Child, Command};
use std::time::{Duration, Instant};
use tungstenite::client::IntoClientRequest;
use tungstenite::{Message, WebSocket};

/// The program as a desk.
pub(crate) struct Desk {
    pub(crate) child: Child,
    /// Host and port.
    pub(crate) host: String,
    pub(crate) key: String,
}

impl Desk {
    /// Starts it, and waits for its link.
    pub(crate) fn start(folder: &Folder, args: &str) -> Desk {
        let mut command: Command = command(folder, &format!("view {args} --no-open"));
        command.env("XDG_STATE_HOME", folder.0.join("state"));
        let mut child = command.spawn().unwrap();
        let mut lines = BufReader::new(child.stderr.take().unwrap()).lines();
        let link =
            lines.find_map(|line| line.ok().filter(|line| line.starts_with("http://"))).expect("a link");
        // What is said later must not block it.
        std::thread::spawn(move || lines.for_each(drop));
        let (host, key) = link.trim_start_matches("http://").split_once("/#").unwrap();
        Desk { child, host: host.into(), key: key.into() }
    }

    /// One HTTP request; its status, head and body.
    pub(crate) fn request(&self, head: &str, body: &str) -> (u16, String, String) {
        let mut stream = TcpStream::connect(&self.host).unwrap();
        stream.set_read_timeout(Some(Duration::from_secs(20))).unwrap();
        let length = body.len();
        write!(stream, "{head}\r\nContent-Length: {length}\r\nConnection: close\r\n\r\n{body}").unwrap();
        let mut answer = String::new();
        let _ = stream.read_to_string(&mut answer);
        let (head, body) = answer.split_once("\r\n\r\n").unwrap_or((&answer, ""));
        let status = head.split_whitespace().nth(1).and_then(|n| n.parse().ok()).unwrap_or(0);
        (status, head.into(), body.into())
    }

    /// What a path has for who came in by a cookie: its status and its bytes.
    pub(crate) fn get(&self, path: &str, cookie: &str) -> (u16, Vec<u8>) {
        let mut stream = TcpStream::connect(&self.host).unwrap();
        stream.set_read_timeout(Some(Duration::from_secs(20))).unwrap();
        let host = &self.host;
        write!(
            stream,
            "GET {path} HTTP/1.1\r\nHost: {host}\r\nCookie: {cookie}\r\nConnection: close\r\n\r\n"
        )
        .unwrap();
        let mut answer = Vec::new();
        stream.read_to_end(&mut answer).unwrap();
        let end = answer.windows(4).position(|four| four == b"\r\n\r\n").expect("a head");
        let head = String::from_utf8_lossy(&answer[..end]).into_owned();
        let status = head.split_whitespace().nth(1).and_then(|n| n.parse().ok()).unwrap_or(0);
        (status, answer.split_off(end + 4))
    }

    /// The cookie that a key buys.
    pub(crate) fn cookie(&self, key: &str) -> String {
        let host = &self.host;
        let head = format!("POST /enter HTTP/1.1\r\nHost: {host}\r\nOrigin: http://{host}");
        let (status, head, _) = self.request(&head, &json!({"key": key}).to_string());
        assert_eq!(status, 204, "{head}");
        let line = head.lines().find_map(|l| l.strip_prefix("set-cookie: ")).expect("a cookie");
        line.split(';').next().unwrap().to_owned()
    }

    /// A client that came in by a key.
    pub(crate) fn client(&self, key: &str) -> Client {
        self.client_by(key, &self.host)
    }

    /// The same, its socket by another way.
    pub(crate) fn client_by(&self, key: &str, address: &str) -> Client {
        let cookie = self.cookie(key);
        let stream = TcpStream::connect(address).unwrap();
        stream.set_read_timeout(Some(Duration::from_secs(60))).unwrap();
        let mut request = format!("ws://{}/wire", self.host).into_client_request().unwrap();
        request.headers_mut().insert("origin", format!("http://{}", self.host).parse().unwrap());
        request.headers_mut().insert("cookie", cookie.parse().unwrap());
        let (socket, _) = tungstenite::client(request, stream).expect("a socket");
        Client { socket, seq: 0, frame: None, state: Value::Null, told: 0, you: Value::Null }
    }

    /// Has it killed: it can do nothing about it.
    pub(crate) fn kill(mut self) {
        self.child.kill().unwrap();
        self.child.wait().unwrap();
    }

    /// Ends it as Ctrl-C does, and waits.
    #[cfg(unix)]
    pub(crate) fn end(mut self) -> i32 {
        let pid = self.child.id().to_string();
        assert!(Command::new("kill").args(["-INT", &pid]).status().unwrap().success());
        self.child.wait().unwrap().code().unwrap_or(-1)
    }
}

impl Drop for Desk {
    fn drop(&mut self) {
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}

/// What a frame's head says.
#[derive(Clone, Debug)]
pub(crate) struct Frame {
    pub(crate) number: u32,
    pub(crate) seq: u32,
    pub(crate) size: [u32; 2],
    pub(crate) kind: u8,
    pub(crate) false_color: bool,
    pub(crate) batches: u32,
    pub(crate) picture: Vec<u8>,
}

/// A client.
pub(crate) struct Client {
    socket: WebSocket<TcpStream>,
    pub(crate) seq: u32,
    /// The last frame.
    pub(crate) frame: Option<Frame>,
    /// The state, patched.
    pub(crate) state: Value,
    /// The last number that was no acknowledgement's.
    pub(crate) told: u32,
    /// Its number.
    you: Value,
}

/// What was heard.
pub(crate) enum Heard {
    Text(Value),
    Frame,
    /// Nothing for as long as it was waited for.
    Silence,
    Closed,
}

impl Client {
    /// Says something; returns its number.
    pub(crate) fn say(&mut self, mut message: Value) -> u32 {
        self.seq += 1;
        if message["do"] != "ack" {
            self.told = self.seq;
        }
        message["seq"] = self.seq.into();
        // Who was hung up on hears so.
        let _ = self.socket.send(Message::text(message.to_string()));
        self.seq
    }

    /// Puts bytes on the line that need not be a message.
    pub(crate) fn push(&mut self, bytes: &[u8]) {
        // Who was hung up on hears so.
        let _ = self.socket.get_mut().write_all(bytes);
    }

    /// How long it is waited for what comes next.
    pub(crate) fn wait(&mut self, time: Duration) {
        self.socket.get_ref().set_read_timeout(Some(time)).unwrap();
    }

    /// Waits for what comes next; frames are acknowledged, the state follows.
    pub(crate) fn hear(&mut self) -> Heard {
        match self.socket.read() {
            Ok(Message::Text(text)) => {
                let value: Value = serde_json::from_str(&text).unwrap();
                match value["is"].as_str() {
                    Some("hello") => self.you = value["you"].clone(),
                    Some("state") => self.state = value["state"].clone(),
                    Some("patch") => patch(&mut self.state, &value["patch"]),
                    _ => {}
                }
                Heard::Text(value)
            }
            Ok(Message::Binary(bytes)) => {
                let long = |at: usize| u32::from_le_bytes(bytes[at..at + 4].try_into().unwrap());
                let short = |at: usize| u32::from(u16::from_le_bytes(bytes[at..at + 2].try_into().unwrap()));
                let number = long(0);
                self.frame = Some(Frame {
                    number,
                    seq: long(4),
                    size: [short(12), short(14)],
                    kind: bytes[16],
                    false_color: bytes[18] != 0,
                    batches: long(20),
                    picture: bytes[32..].to_vec(),
                });
                self.say(json!({"do": "ack", "frame": number}));
                Heard::Frame
            }
            Err(tungstenite::Error::Io(e)) if matches!(e.kind(), WouldBlock | TimedOut) => Heard::Silence,
            Ok(Message::Close(_)) | Err(_) => Heard::Closed,
            Ok(_) => self.hear(),
        }
    }

    /// Waits for a text that is looked for.
    pub(crate) fn until(&mut self, wanted: impl Fn(&Value) -> bool) -> Value {
        let start = Instant::now();
        while start.elapsed() < Duration::from_secs(120) {
            match self.hear() {
                Heard::Text(value) if wanted(&value) => return value,
                Heard::Closed => panic!("the desk hung up"),
                _ => {}
            }
        }
        panic!("nothing came of it")
    }

    /// Waits for a frame that is looked for.
    pub(crate) fn until_frame(&mut self, wanted: impl Fn(&Frame) -> bool) -> Frame {
        let start = Instant::now();
        while start.elapsed() < Duration::from_secs(240) {
            match self.hear() {
                Heard::Frame if self.frame.as_ref().is_some_and(&wanted) => {
                    return self.frame.clone().unwrap();
                }
                Heard::Closed => panic!("the desk hung up"),
                _ => {}
            }
        }
        panic!("no such frame came")
    }

    /// Says something and waits until it was applied, or why it was not.
    pub(crate) fn ask(&mut self, message: Value) -> Result<Value, String> {
        let seq = self.say(message);
        let you = self.you.clone();
        // Patches bear the number of their editor's message, who may be somebody else.
        let own = |value: &Value| value["is"] == "refused" || value["is"] == "patch" && value["by"] == you;
        let answer = self.until(|value| value["seq"] == seq && own(value));
        match answer["why"].as_str() {
            Some(why) => Err(why.into()),
            None => Ok(answer["patch"].clone()),
        }
    }
}

/// Entries of what is kept by number are replaced one by one, anything else whole.
fn patch(state: &mut Value, patch: &Value) {
    const KEYED: [&str; 8] = ["lamps", "groups", "things", "materials", "views", "looks", "meters", "grids"];
    for (name, value) in patch.as_object().into_iter().flatten() {
        match value.as_object().filter(|_| KEYED.contains(&name.as_str())) {
            Some(entries) => entries.iter().for_each(|(id, entry)| match entry.is_null() {
                true => drop(state[name].as_object_mut().and_then(|all| all.remove(id))),
                false => state[name][id] = entry.clone(),
            }),
            None => state[name] = value.clone(),
        }
    }
}
