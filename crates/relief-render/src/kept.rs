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
    let find = |list: &[(Arc<K>, Arc<T>)]| {
        list.iter().find(|(key, _)| Arc::ptr_eq(key, of)).map(|(_, made)| Arc::clone(made))
    };
    find(now).unwrap_or_else(|| {
        let made = find(before).unwrap_or_else(make);
        now.push((Arc::clone(of), Arc::clone(&made)));
        made
    })
}
