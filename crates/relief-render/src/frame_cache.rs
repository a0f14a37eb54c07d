//! A cache from one frame to the next: what follows from an input is made once, as long as frames use it.

use std::sync::Arc;

/// Returns the value that belongs to `of`: from this frame, else from the frame before, else a new one by
/// `make`. Inputs are compared by their address.
pub fn cached<K: ?Sized, T: ?Sized>(
    now: &mut Vec<(Arc<K>, Arc<T>)>,
    before: &[(Arc<K>, Arc<T>)],
    of: &Arc<K>,
    make: impl FnOnce() -> Arc<T>,
) -> Arc<T> {
    cached_where(now, before, of, |_| true, make)
}

/// Does what [`cached`] does, but makes the value anew unless `fits` accepts the cached one.
pub fn cached_where<K: ?Sized, T: ?Sized>(
    now: &mut Vec<(Arc<K>, Arc<T>)>,
    before: &[(Arc<K>, Arc<T>)],
    of: &Arc<K>,
    fits: impl Fn(&T) -> bool,
    make: impl FnOnce() -> Arc<T>,
) -> Arc<T> {
    let find = |list: &[(Arc<K>, Arc<T>)]| {
        let known = list.iter().find(|(key, value)| Arc::ptr_eq(key, of) && fits(value));
        known.map(|(_, value)| Arc::clone(value))
    };
    find(now).unwrap_or_else(|| {
        let value = find(before).unwrap_or_else(make);
        now.push((Arc::clone(of), Arc::clone(&value)));
        value
    })
}
