//! What a view makes once and shows for many frames.

use eframe::egui::{Context, Id};

use crate::languages::{Language, spoken};

/// What was made of a key, made again when the key is another one or another language is spoken.
pub fn kept<K, V>(context: &Context, id: Id, key: K, make: impl FnOnce() -> V) -> V
where
    K: PartialEq + Clone + Send + Sync + 'static,
    V: Clone + Send + Sync + 'static,
{
    if let Some((language, of, value)) = context.data(|data| data.get_temp::<(Language, K, V)>(id))
        && (language, &of) == (spoken(), &key)
    {
        return value;
    }
    let value = make();
    context.data_mut(|data| data.insert_temp(id, (spoken(), key, value.clone())));
    value
}
