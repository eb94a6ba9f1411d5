//! What a view makes once and shows for many frames.

use eframe::egui::{Id, Ui};

/// What was made of a key, made again when the key is another one.
pub fn kept<K, V>(ui: &Ui, id: Id, key: K, make: impl FnOnce() -> V) -> V
where
    K: PartialEq + Clone + Send + Sync + 'static,
    V: Clone + Send + Sync + 'static,
{
    if let Some((of, value)) = ui.data(|data| data.get_temp::<(K, V)>(id))
        && of == key
    {
        return value;
    }
    let value = make();
    ui.data_mut(|data| data.insert_temp(id, (key, value.clone())));
    value
}
