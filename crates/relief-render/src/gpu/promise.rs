//! Futures of what callbacks give.

use std::future::Future;
use std::pin::Pin;
use std::sync::{Arc, Mutex, PoisonError};
use std::task::{Context, Poll, Waker};

/// Value of a callback, once it has given it.
struct Promise<T> {
    given: Option<T>,
    waker: Option<Waker>,
}

/// Sender of the value, for the callback.
pub struct Sender<T>(Arc<Mutex<Promise<T>>>);

/// Future of the value. It never ends if the callback is never called.
pub struct Receiver<T>(Arc<Mutex<Promise<T>>>);

/// Creates the sender and the future of a value.
pub fn promise<T>() -> (Sender<T>, Receiver<T>) {
    let promise = Arc::new(Mutex::new(Promise { given: None, waker: None }));
    (Sender(Arc::clone(&promise)), Receiver(promise))
}

impl<T> Sender<T> {
    /// Sends the value and wakes the future.
    pub fn send(self, value: T) {
        let mut promise = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        promise.given = Some(value);
        if let Some(waker) = promise.waker.take() {
            waker.wake();
        }
    }
}

impl<T> Future for Receiver<T> {
    type Output = T;

    fn poll(self: Pin<&mut Self>, context: &mut Context<'_>) -> Poll<T> {
        let mut promise = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        match promise.given.take() {
            Some(value) => Poll::Ready(value),
            None => {
                promise.waker = Some(context.waker().clone());
                Poll::Pending
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use std::thread;

    use super::*;
    use crate::block_on;

    #[test]
    fn a_value_from_another_thread_is_waited_for() {
        let (sender, receiver) = promise();
        let other = thread::spawn(move || sender.send(7));
        assert_eq!(block_on(receiver), 7);
        other.join().expect("it ends");
        let (sender, receiver) = promise();
        sender.send("before");
        assert_eq!(block_on(receiver), "before");
    }
}
