//! What is made of a thing once and kept as long as the thing is used.

use std::sync::Arc;

/// What was made of a thing for this frame or the one before, or is made of it. Things are told apart by
/// their address.
pub fn kept<K: ?Sized, T: ?Sized>(
    now: &mut Vec<(Arc<K>, Arc<T>)>,
    before: &[(Arc<K>, Arc<T>)],
    of: &Arc<K>,
    make: impl FnOnce() -> Arc<T>,
) -> Arc<T> {
    kept_where(now, before, of, |_| true, make)
}

/// The same, where what was made may not fit any more.
pub fn kept_where<K: ?Sized, T: ?Sized>(
    now: &mut Vec<(Arc<K>, Arc<T>)>,
    before: &[(Arc<K>, Arc<T>)],
    of: &Arc<K>,
    fits: impl Fn(&T) -> bool,
    make: impl FnOnce() -> Arc<T>,
) -> Arc<T> {
    let find = |list: &[(Arc<K>, Arc<T>)]| {
        let known = list.iter().find(|(key, made)| Arc::ptr_eq(key, of) && fits(made));
        known.map(|(_, made)| Arc::clone(made))
    };
    find(now).unwrap_or_else(|| {
        let made = find(before).unwrap_or_else(make);
        now.push((Arc::clone(of), Arc::clone(&made)));
        made
    })
}
