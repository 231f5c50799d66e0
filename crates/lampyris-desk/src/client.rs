//! One client: what it says goes to the desk, what the desk says comes to it, and pictures as fast as it takes them.

use crate::door::{Door, Pass};
use crate::event::{Event, Inbox};
use crate::hub::Hub;
use crate::wire::Message;
use futures_util::{SinkExt, StreamExt};
use hyper::upgrade::Upgraded;
use hyper_util::rt::TokioIo;
use std::sync::Arc;
use std::time::{Duration, Instant};
use tokio_tungstenite::WebSocketStream;
use tokio_tungstenite::tungstenite::protocol::frame::coding::CloseCode;
use tokio_tungstenite::tungstenite::protocol::{CloseFrame, Message as Frame, WebSocketConfig};

/// Bytes of one message.
const LONGEST: usize = 64 << 10;

/// Messages that are heard in a second, and at once after silence.
const RATE: f64 = 400.0;
const BURST: f64 = 1200.0;

/// Pictures on their way that were not seen to be drawn.
const UNSEEN: u32 = 2;

/// How long a client may let what is sent to it lie, or be silent.
const PATIENCE: Duration = Duration::from_secs(10);
const SILENCE: Duration = Duration::from_secs(25);

type Socket = WebSocketStream<TokioIo<Upgraded>>;

/// What a socket may ask of memory.
pub(crate) fn limits() -> WebSocketConfig {
    WebSocketConfig::default()
        .max_message_size(Some(LONGEST))
        .max_frame_size(Some(LONGEST))
        .read_buffer_size(8 << 10)
        .write_buffer_size(0)
        .max_write_buffer_size(16 << 20)
}

/// Why a client goes.
enum End {
    /// It went.
    Left,
    /// It is sent away, with a code and words.
    Sent(CloseCode, &'static str),
}

/// Serves a client until it goes.
pub(crate) async fn serve(
    mut socket: Socket,
    id: u64,
    pass: Pass,
    door: Arc<Door>,
    hub: Arc<Hub>,
    inbox: Inbox,
) {
    let end = talk(&mut socket, id, pass, &door, &hub, &inbox).await;
    hub.leave(id);
    inbox.put(Event::Left { client: id });
    if let End::Sent(code, why) = end {
        let frame = CloseFrame { code, reason: why.into() };
        let _ = tokio::time::timeout(PATIENCE, socket.close(Some(frame))).await;
    }
}

async fn talk(socket: &mut Socket, id: u64, pass: Pass, door: &Door, hub: &Hub, inbox: &Inbox) -> End {
    let Some((mut mail, mut frames)) = hub.join(id, pass) else {
        return End::Sent(CloseCode::Again, "too many are looking on");
    };
    inbox.put(Event::Joined { client: id, role: pass.role });
    let mut bucket = Bucket { tokens: BURST, at: Instant::now() };
    let mut camera = None;
    let (mut sent, mut seen) = (0_u32, 0_u32);
    let mut heard = Instant::now();
    // Where a client drew nothing of what it was sent.
    let mut waits_since = Instant::now();
    let mut beat = tokio::time::interval(Duration::from_secs(5));
    loop {
        if sent == seen {
            waits_since = Instant::now();
        }
        tokio::select! {
            biased;
            said = socket.next() => {
                let text = match said {
                    Some(Ok(Frame::Text(text))) => text,
                    Some(Ok(Frame::Binary(_))) => return End::Sent(CloseCode::Unsupported, "only text is understood"),
                    Some(Ok(Frame::Close(_)) | Err(_)) | None => return End::Left,
                    Some(Ok(_)) => {
                        heard = Instant::now();
                        continue;
                    }
                };
                heard = Instant::now();
                if !bucket.take() {
                    return End::Sent(CloseCode::Policy, "too many messages");
                }
                match Message::read(&text) {
                    Ok(Message { seq: _, what: crate::wire::Do::Ack }) => seen = sent.min(seen + 1),
                    Ok(message) => inbox.put(Event::Said { client: id, message }),
                    Err((seq, why)) => hub.tell(id, &serde_json::json!({"is": "refused", "seq": seq, "why": why})),
                }
            }
            text = mail.recv() => {
                let Some(text) = text else { return End::Sent(CloseCode::Policy, "this link was revoked, or nothing was read") };
                if !send(socket, Frame::Text(text)).await {
                    return End::Left;
                }
            }
            changed = frames.changed(), if sent - seen < UNSEEN => {
                if changed.is_err() {
                    return End::Sent(CloseCode::Away, "the program ends");
                }
                let Some(shown) = frames.borrow_and_update().clone() else { continue };
                if camera != Some(shown.camera.number) {
                    camera = Some(shown.camera.number);
                    if !send(socket, Frame::Text(shown.camera.text.clone())).await {
                        return End::Left;
                    }
                }
                if !send(socket, Frame::Binary(shown.bytes.clone())).await {
                    return End::Left;
                }
                sent += 1;
            }
            _ = beat.tick() => {
                if !door.still(pass) {
                    return End::Sent(CloseCode::Policy, "this link was revoked");
                }
                if heard.elapsed() > SILENCE || waits_since.elapsed() > SILENCE {
                    return End::Sent(CloseCode::Policy, "nothing was heard for too long");
                }
                if !send(socket, Frame::Ping(Vec::new().into())).await {
                    return End::Left;
                }
            }
        }
    }
}

/// Whether it was taken in time.
async fn send(socket: &mut Socket, frame: Frame) -> bool {
    matches!(tokio::time::timeout(PATIENCE, socket.send(frame)).await, Ok(Ok(())))
}

/// How much may still be said.
struct Bucket {
    tokens: f64,
    at: Instant,
}

impl Bucket {
    fn take(&mut self) -> bool {
        let now = Instant::now();
        self.tokens = (self.tokens + now.duration_since(self.at).as_secs_f64() * RATE).min(BURST);
        self.at = now;
        self.tokens -= 1.0;
        self.tokens >= 0.0
    }
}
