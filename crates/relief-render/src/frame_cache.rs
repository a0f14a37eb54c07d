//! Cache from one frame to the next. A value made from an input is kept as long as frames use that
//! input.

use std::sync::Arc;

/// Returns the value that belongs to `of`: from this frame, else from the frame before, else a new
/// one from `make`. Inputs are compared by address.
pub fn cached<K: ?Sized, T: ?Sized>(
    now: &mut Vec<(Arc<K>, Arc<T>)>,
    before: &[(Arc<K>, Arc<T>)],
    of: &Arc<K>,
    make: impl FnOnce() -> Arc<T>,
) -> Arc<T> {
    cached_where(now, before, of, |_| true, make)
}

/// Returns the value of [`cached`] if `fits` accepts it, else a new one from `make`.
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
