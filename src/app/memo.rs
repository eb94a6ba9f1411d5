//! One value that is made anew only when what it was made from changes.

use std::sync::Arc;

use crate::languages::{Language, spoken};

/// A value with its key: everything that the value depends on, beside the language spoken, which
/// any value may have words in.
#[derive(Clone, Debug)]
pub struct Memo<K, V>(Option<((Language, K), V)>);

impl<K, V> Default for Memo<K, V> {
    fn default() -> Self {
        Self(None)
    }
}

impl<K: PartialEq, V> Memo<K, V> {
    /// The value of `key`: the one that is held when it is of the same key, otherwise made now.
    pub fn get(&mut self, key: K, make: impl FnOnce(&K) -> V) -> &mut V {
        let held = match self.0.take() {
            Some(held) if held.0.0 == spoken() && held.0.1 == key => held,
            _ => {
                let value = make(&key);
                ((spoken(), key), value)
            }
        };
        &mut self.0.insert(held).1
    }

    /// The value that is held, whatever it was made from.
    pub fn held(&self) -> Option<&V> {
        self.0.as_ref().map(|(_, value)| value)
    }
}

/// Something shared that is the same only as itself: a key for what is too large to compare, and
/// never changed in its place.
#[derive(Debug)]
pub struct ByAddress<T>(pub Arc<T>);

impl<T> Clone for ByAddress<T> {
    fn clone(&self) -> Self {
        Self(self.0.clone())
    }
}

impl<T> PartialEq for ByAddress<T> {
    fn eq(&self, other: &Self) -> bool {
        Arc::ptr_eq(&self.0, &other.0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_value_is_made_once_for_a_key_and_anew_for_another() {
        let mut memo = Memo::default();
        let mut made = 0;
        let mut get = |key: u64| {
            *memo.get(key, |key| {
                made += 1;
                10 * key
            })
        };
        assert_eq!([get(1), get(1), get(2), get(1)], [10, 10, 20, 10]);
        assert_eq!(made, 3);
    }

    #[test]
    fn equal_things_at_two_addresses_are_two() {
        let one = Arc::new(5);
        assert!(ByAddress(one.clone()) == ByAddress(one.clone()));
        assert!(ByAddress(one) != ByAddress(Arc::new(5)));
    }
}
