//! The way in: an address of this machine with a secret in it, and nothing else.

use std::net::{Ipv4Addr, TcpListener};

use super::http::Request;
use crate::failure::Failure;

/// Bytes of the secret.
const SECRET_BYTES: usize = 16;

/// A port on this machine's own address.
pub struct Door {
    pub listener: TcpListener,
    port: u16,
    secret: String,
}

/// Why a request is not answered.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Shut {
    /// It was made under another name of this machine, or by a page of another origin.
    Foreign,
    /// Its address has not the secret.
    Unknown,
}

impl Door {
    /// Opens a port; a free one without a number.
    pub fn open(port: Option<u16>) -> Result<Self, Failure> {
        let failed = |error: &dyn std::fmt::Display| match port {
            Some(port) => Failure::Work(format!(
                "port {port} cannot be opened: {error}: give another with --port, or leave it out"
            )),
            None => Failure::Work(format!("no port of this machine can be opened: {error}")),
        };
        let listener = TcpListener::bind((Ipv4Addr::LOCALHOST, port.unwrap_or_default()));
        let listener = listener.map_err(|error| failed(&error))?;
        let port = listener.local_addr().map_err(|error| failed(&error))?.port();
        let mut secret = [0; SECRET_BYTES];
        getrandom::fill(&mut secret)
            .map_err(|error| Failure::Work(format!("the system gives no random numbers: {error}")))?;
        let secret = secret.iter().map(|byte| format!("{byte:02x}")).collect();
        Ok(Self { listener, port, secret })
    }

    /// The address of the page.
    pub fn address(&self) -> String {
        format!("http://127.0.0.1:{}/{}/", self.port, self.secret)
    }

    /// The part of a request's address behind the secret, if it may be answered.
    pub fn admit<'a>(&self, request: &'a Request) -> Result<&'a str, Shut> {
        let Request { url, host, origin, .. } = request;
        admit(url, host.as_deref(), origin.as_deref(), self.port, &self.secret)
    }
}

/// Pages of other sites know no secret; that they are refused by name and origin, too, keeps a secret that
/// was seen from being used there.
fn admit<'a>(
    url: &'a str,
    host: Option<&str>,
    origin: Option<&str>,
    port: u16,
    secret: &str,
) -> Result<&'a str, Shut> {
    let own = ["127.0.0.1", "localhost"].map(|name| format!("{name}:{port}"));
    let is_own = |host: &str| own.iter().any(|own| own == host);
    let of_origin = |origin: &str| origin.strip_prefix("http://").is_some_and(is_own);
    if !host.is_some_and(is_own) || !origin.is_none_or(of_origin) {
        return Err(Shut::Foreign);
    }
    let rest = url.strip_prefix('/').and_then(|url| url.strip_prefix(secret));
    rest.and_then(|rest| rest.strip_prefix('/')).ok_or(Shut::Unknown)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_the_page_of_this_program_comes_in() {
        let ask = |url, host, origin| admit(url, host, origin, 8000, "secret");
        let (here, page) = (Some("127.0.0.1:8000"), Some("http://127.0.0.1:8000"));
        assert_eq!(ask("/secret/", here, None), Ok(""));
        assert_eq!(ask("/secret/state", here, page), Ok("state"));
        assert_eq!(ask("/secret/state", Some("localhost:8000"), Some("http://localhost:8000")), Ok("state"));
        for url in ["/", "/secre/state", "/secret", "/secrets/", "secret/", "//secret/"] {
            assert_eq!(ask(url, here, page), Err(Shut::Unknown), "{url}");
        }
        for host in ["127.0.0.1", "127.0.0.1:80", "relief.example:8000", "127.0.0.1:8000.example", ""] {
            assert_eq!(ask("/secret/", Some(host), None), Err(Shut::Foreign), "{host}");
        }
        for origin in ["null", "https://127.0.0.1:8000", "http://example.org", "http://127.0.0.1:8001", ""] {
            assert_eq!(ask("/secret/", here, Some(origin)), Err(Shut::Foreign), "{origin}");
        }
        assert_eq!(ask("/secret/", None, None), Err(Shut::Foreign));
    }
}
