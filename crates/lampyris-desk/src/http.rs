//! The server: the page's files, the way in, and the sockets. Whoever dawdles over a request is let go.

use crate::album::{self, Album};
use crate::client;
use crate::door::{Door, Refusal};
use crate::error::{Error, Result};
use crate::event::Inbox;
use crate::hub::Hub;
use crate::page;
use crate::printer::Printer;
use http_body_util::{BodyExt, Full, Limited};
use hyper::body::{Bytes, Incoming};
use hyper::header::{self, HeaderName, HeaderValue};
use hyper::service::service_fn;
use hyper::{Method, Request, Response, StatusCode};
use hyper_util::rt::{TokioIo, TokioTimer};
use std::convert::Infallible;
use std::net::SocketAddr;
use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering};
use std::time::{Duration, Instant};
use tokio::net::{TcpListener, TcpStream};
use tokio::sync::Semaphore;
use tokio_tungstenite::WebSocketStream;
use tokio_tungstenite::tungstenite::handshake::derive_accept_key;
use tokio_tungstenite::tungstenite::protocol::Role as Side;

/// Connections at once, and how long the head of a request may take.
const CONNECTIONS: usize = 1024;
const HEAD: Duration = Duration::from_secs(5);
const BODY: Duration = Duration::from_secs(5);

/// Bytes of what is posted.
const POSTED: usize = 1024;

/// What the page may load, and from whom: from here alone.
const POLICY: &str = "default-src 'self'; img-src 'self' blob:; style-src 'self'; connect-src 'self'; \
                      base-uri 'none'; form-action 'none'; frame-ancestors 'none'";

/// Where pictures to keep are.
const MADE: &str = "/made/";

type Answer = Response<Full<Bytes>>;

/// What a server needs.
#[derive(Clone)]
pub(crate) struct Server {
    pub(crate) door: Arc<Door>,
    pub(crate) hub: Arc<Hub>,
    pub(crate) inbox: Inbox,
    pub(crate) build: Arc<str>,
    printer: Arc<Printer>,
    album: Arc<Album>,
    clients: Arc<AtomicU64>,
}

/// Listens, before anything else is done: who comes early waits.
pub(crate) fn listen(address: SocketAddr) -> Result<std::net::TcpListener> {
    let cannot = |e: std::io::Error| Error::CannotListen { address, reason: e.to_string() };
    let listener = std::net::TcpListener::bind(address).map_err(cannot)?;
    listener.set_nonblocking(true).map_err(cannot)?;
    Ok(listener)
}

impl Server {
    pub(crate) fn new(
        door: Arc<Door>,
        hub: Arc<Hub>,
        inbox: Inbox,
        printer: Arc<Printer>,
        album: Arc<Album>,
    ) -> Server {
        Server { door, hub, inbox, printer, album, build: page::build().into(), clients: Arc::default() }
    }

    /// Serves on a thread of its own, for good.
    pub(crate) fn start(self, listener: std::net::TcpListener) -> Result<()> {
        let system =
            |e: std::io::Error| Error::System { what: "a thread for the network", reason: e.to_string() };
        let runtime = tokio::runtime::Builder::new_current_thread().enable_all().build().map_err(system)?;
        let run = move || {
            runtime.block_on(async move {
                // Listening was asked for before there was a runtime.
                if let Ok(listener) = TcpListener::from_std(listener) {
                    self.accept(listener).await;
                }
            });
        };
        std::thread::Builder::new().name("network".into()).spawn(run).map_err(system)?;
        Ok(())
    }

    async fn accept(self, listener: TcpListener) {
        let room = Arc::new(Semaphore::new(CONNECTIONS));
        loop {
            let Ok(place) = room.clone().acquire_owned().await else { return };
            let Ok((stream, _)) = listener.accept().await else {
                // No more files may be opened, perhaps: some will be closed.
                tokio::time::sleep(Duration::from_millis(50)).await;
                continue;
            };
            let server = self.clone();
            tokio::spawn(async move {
                server.connection(stream).await;
                drop(place);
            });
        }
    }

    async fn connection(self, stream: TcpStream) {
        let _ = stream.set_nodelay(true);
        let service = service_fn(move |request| {
            let server = self.clone();
            async move { Ok::<_, Infallible>(server.answer(request).await) }
        });
        let mut http = hyper::server::conn::http1::Builder::new();
        http.timer(TokioTimer::new()).header_read_timeout(HEAD).max_buf_size(16 << 10).keep_alive(true);
        let _ = http.serve_connection(TokioIo::new(stream), service).with_upgrades().await;
    }

    async fn answer(self, request: Request<Incoming>) -> Answer {
        let answer = self.route(request).await;
        let mut answer = answer.unwrap_or_else(|Refusal(status, why)| {
            let mut refused = Response::new(Full::from(why));
            *refused.status_mut() = StatusCode::from_u16(status).unwrap_or(StatusCode::BAD_REQUEST);
            refused
                .headers_mut()
                .insert(header::CONTENT_TYPE, HeaderValue::from_static("text/plain; charset=utf-8"));
            refused
        });
        let always: [(HeaderName, &str); 5] = [
            (header::CONTENT_SECURITY_POLICY, POLICY),
            (header::X_CONTENT_TYPE_OPTIONS, "nosniff"),
            (header::REFERRER_POLICY, "no-referrer"),
            (header::CACHE_CONTROL, "no-cache"),
            (HeaderName::from_static("cross-origin-opener-policy"), "same-origin"),
        ];
        for (name, value) in always {
            answer.headers_mut().insert(name, HeaderValue::from_static(value));
        }
        answer
    }

    async fn route(self, request: Request<Incoming>) -> std::result::Result<Answer, Refusal> {
        let text = |name: HeaderName| request.headers().get(name).and_then(|value| value.to_str().ok());
        let (host, origin) = (text(header::HOST), text(header::ORIGIN));
        let path = request.uri().path().to_owned();
        let upgrades = path == "/wire";
        self.door.check(host, origin, upgrades || request.method() != Method::GET)?;
        match (request.method(), path.as_str()) {
            (&Method::POST, "/enter") => self.enter(request).await,
            (&Method::GET, "/wire") => self.upgrade(request),
            (&Method::GET, path) if path.starts_with(MADE) => self.made(&request),
            (&Method::GET, path) if path.starts_with(album::PLACE) => self.photo(&request),
            (&Method::GET | &Method::HEAD, path) => match page::FILES.iter().find(|file| file.path == path) {
                Some(file) => Ok(self.file(file, &request)),
                None => Err(Refusal(404, "there is no such page")),
            },
            _ => Err(Refusal(405, "that cannot be done here")),
        }
    }

    fn file(&self, file: &page::File, request: &Request<Incoming>) -> Answer {
        let mark = format!("\"{}\"", self.build);
        let known =
            request.headers().get(header::IF_NONE_MATCH).is_some_and(|own| own.as_bytes() == mark.as_bytes());
        let mut answer = Response::new(Full::from(if known { &[][..] } else { file.bytes }));
        if known {
            *answer.status_mut() = StatusCode::NOT_MODIFIED;
        }
        answer.headers_mut().insert(header::CONTENT_TYPE, HeaderValue::from_static(file.kind));
        if let Ok(mark) = HeaderValue::from_str(&mark) {
            answer.headers_mut().insert(header::ETAG, mark);
        }
        answer
    }

    /// A picture that was asked for. Only who came in may have it.
    fn made(&self, request: &Request<Incoming>) -> std::result::Result<Answer, Refusal> {
        self.door.admit(cookies(request))?;
        let name = request.uri().path().trim_start_matches(MADE);
        let none = Refusal(404, "there is no such picture");
        let mut answer = Response::new(Full::from(self.printer.picture(name).ok_or(none)?));
        let kind = if name.ends_with(".png") { "image/png" } else { "image/x-exr" };
        answer.headers_mut().insert(header::CONTENT_TYPE, HeaderValue::from_static(kind));
        answer.headers_mut().insert(header::CONTENT_DISPOSITION, HeaderValue::from_static("attachment"));
        Ok(answer)
    }

    /// The thumbnail of a look. Only who came in may have it.
    fn photo(&self, request: &Request<Incoming>) -> std::result::Result<Answer, Refusal> {
        self.door.admit(cookies(request))?;
        let none = Refusal(404, "there is no such look");
        let photo = self.album.photo(request.uri().path()).ok_or(none)?;
        let mut answer = Response::new(Full::from(photo.to_vec()));
        answer.headers_mut().insert(header::CONTENT_TYPE, HeaderValue::from_static("image/jpeg"));
        Ok(answer)
    }

    async fn enter(self, request: Request<Incoming>) -> std::result::Result<Answer, Refusal> {
        #[derive(serde::Deserialize)]
        struct Key {
            key: String,
        }
        let unread = Refusal(400, "need {\"key\": \"…\"}");
        let body = Limited::new(request.into_body(), POSTED).collect();
        let body = tokio::time::timeout(BODY, body).await.map_err(|_| Refusal(408, "too slow"))?;
        let body = body.map_err(|_| unread)?.to_bytes();
        let Key { key } = serde_json::from_slice(&body).map_err(|_| unread)?;
        let token = self.door.enter(&key, Instant::now())?;
        let cookie = format!("{}={token}; Path=/; HttpOnly; SameSite=Strict", self.door.cookie_name());
        let mut answer = Response::new(Full::default());
        *answer.status_mut() = StatusCode::NO_CONTENT;
        let cookie = HeaderValue::from_str(&cookie).map_err(|_| Refusal(500, "no cookie"))?;
        answer.headers_mut().insert(header::SET_COOKIE, cookie);
        Ok(answer)
    }

    fn upgrade(self, mut request: Request<Incoming>) -> std::result::Result<Answer, Refusal> {
        let headers = request.headers();
        let pass = self.door.admit(cookies(&request))?;
        let says = |name: HeaderName, word: &str| {
            let value = headers.get(name).and_then(|value| value.to_str().ok()).unwrap_or_default();
            value.split(',').any(|part| part.trim().eq_ignore_ascii_case(word))
        };
        let asked = says(header::UPGRADE, "websocket")
            && says(header::CONNECTION, "upgrade")
            && says(header::SEC_WEBSOCKET_VERSION, "13");
        let key = headers.get(header::SEC_WEBSOCKET_KEY).filter(|_| asked);
        let accept = derive_accept_key(key.ok_or(Refusal(426, "this is a WebSocket"))?.as_bytes());
        let accept = HeaderValue::from_str(&accept).map_err(|_| Refusal(400, "no key"))?;
        let id = self.clients.fetch_add(1, Ordering::Relaxed) + 1;
        tokio::spawn(async move {
            let Ok(upgraded) = hyper::upgrade::on(&mut request).await else { return };
            let limits = Some(client::limits());
            let socket = WebSocketStream::from_raw_socket(TokioIo::new(upgraded), Side::Server, limits).await;
            client::serve(socket, id, pass, self.door, self.hub, self.inbox).await;
        });
        let mut answer = Response::new(Full::default());
        *answer.status_mut() = StatusCode::SWITCHING_PROTOCOLS;
        let own = [
            (header::UPGRADE, HeaderValue::from_static("websocket")),
            (header::CONNECTION, HeaderValue::from_static("Upgrade")),
            (header::SEC_WEBSOCKET_ACCEPT, accept),
        ];
        own.into_iter().for_each(|(name, value)| drop(answer.headers_mut().insert(name, value)));
        Ok(answer)
    }
}

fn cookies(request: &Request<Incoming>) -> Option<&str> {
    request.headers().get(header::COOKIE).and_then(|value| value.to_str().ok())
}
