//! Shortcuts: what keys do, and the list that the window shows of them.

use eframe::egui;
use egui::{Context, Key, KeyboardShortcut, Modifiers};

/// What a key asks for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Act {
    /// Open files.
    Open,
    /// Open a folder.
    OpenFolder,
    /// Type a path.
    TypePath,
    /// Save the project.
    SaveProject,
    /// One step back.
    Undo,
    /// One step forward.
    Redo,
    /// One order less.
    OrderDown,
    /// One order more.
    OrderUp,
    /// A lower threshold.
    ThresholdDown,
    /// A higher threshold.
    ThresholdUp,
    /// The whole range into view.
    ResetView,
    /// Dark or light.
    Theme,
    /// Plot, swatch, patches and sliders alone, large.
    Present,
    /// The plot alone.
    PlotAlone,
    /// Into the search field.
    Search,
    /// The library, or the page without it.
    Library,
    /// A place of the window, by its number in the rail.
    Place(usize),
    /// Everything back to the start.
    Reset,
    /// Finds lights, places and acts by a few letters.
    Palette,
    /// The ways to begin.
    Greeting,
    /// Larger.
    ZoomIn,
    /// Smaller.
    ZoomOut,
    /// As it was.
    ZoomReset,
    /// The list of shortcuts.
    Shortcuts,
    /// Copy a picture of the window.
    CopyPicture,
    /// Copy the command line that gives the same.
    CopyCommand,
}

const CTRL: Modifiers = Modifiers::COMMAND;
const CTRL_SHIFT: Modifiers = Modifiers::COMMAND.plus(Modifiers::SHIFT);

/// Every shortcut with what it does; those with more modifiers first, because a shortcut with
/// fewer would swallow them.
pub(super) const SHORTCUTS: [(KeyboardShortcut, Act, &str); 33] = [
    (
        KeyboardShortcut::new(CTRL_SHIFT, Key::Z),
        Act::Redo,
        "Do again",
    ),
    (
        KeyboardShortcut::new(CTRL_SHIFT, Key::O),
        Act::TypePath,
        "Open a file or folder by typing its path",
    ),
    (
        KeyboardShortcut::new(CTRL_SHIFT, Key::F),
        Act::OpenFolder,
        "Open all files of a folder",
    ),
    (
        KeyboardShortcut::new(CTRL_SHIFT, Key::C),
        Act::CopyPicture,
        "Copy a picture of the window",
    ),
    (
        KeyboardShortcut::new(CTRL_SHIFT, Key::K),
        Act::CopyCommand,
        "Copy the command line for this view",
    ),
    (KeyboardShortcut::new(CTRL, Key::Z), Act::Undo, "Undo"),
    (KeyboardShortcut::new(CTRL, Key::Y), Act::Redo, "Do again"),
    (KeyboardShortcut::new(CTRL, Key::O), Act::Open, "Open files"),
    (
        KeyboardShortcut::new(CTRL, Key::S),
        Act::SaveProject,
        "Save the project",
    ),
    (
        KeyboardShortcut::new(CTRL, Key::F),
        Act::Search,
        "Search the library",
    ),
    (
        KeyboardShortcut::new(CTRL, Key::Plus),
        Act::ZoomIn,
        "Larger",
    ),
    (
        KeyboardShortcut::new(CTRL, Key::Minus),
        Act::ZoomOut,
        "Smaller",
    ),
    (
        KeyboardShortcut::new(CTRL, Key::Num0),
        Act::ZoomReset,
        "Zoom 100 %",
    ),
    (
        KeyboardShortcut::new(CTRL, Key::D),
        Act::Theme,
        "Dark or light",
    ),
    (
        KeyboardShortcut::new(CTRL, Key::L),
        Act::Library,
        "Open or close the library",
    ),
    (
        KeyboardShortcut::new(CTRL, Key::K),
        Act::Palette,
        "Find a light, a place or an act",
    ),
    (
        KeyboardShortcut::new(CTRL, Key::Num1),
        Act::Place(0),
        "Learn",
    ),
    (
        KeyboardShortcut::new(CTRL, Key::Num2),
        Act::Place(1),
        "Look",
    ),
    (
        KeyboardShortcut::new(CTRL, Key::Num3),
        Act::Place(2),
        "Through",
    ),
    (
        KeyboardShortcut::new(CTRL, Key::Num4),
        Act::Place(3),
        "Quality",
    ),
    (
        KeyboardShortcut::new(CTRL, Key::Num5),
        Act::Place(4),
        "Design",
    ),
    (
        KeyboardShortcut::new(CTRL, Key::Num6),
        Act::Place(5),
        "Numbers",
    ),
    (
        KeyboardShortcut::new(CTRL, Key::Num7),
        Act::Place(6),
        "Picture",
    ),
    (
        KeyboardShortcut::new(Modifiers::NONE, Key::F5),
        Act::Present,
        "Present",
    ),
    (
        KeyboardShortcut::new(Modifiers::NONE, Key::F11),
        Act::PlotAlone,
        "The plot alone",
    ),
    (
        KeyboardShortcut::new(Modifiers::NONE, Key::R),
        Act::Reset,
        "Everything back to the start",
    ),
    (
        KeyboardShortcut::new(Modifiers::NONE, Key::Home),
        Act::ResetView,
        "The whole range into view",
    ),
    (
        KeyboardShortcut::new(Modifiers::SHIFT, Key::F1),
        Act::Shortcuts,
        "This list",
    ),
    (
        KeyboardShortcut::new(Modifiers::NONE, Key::F1),
        Act::Greeting,
        "The ways to begin",
    ),
    (
        KeyboardShortcut::new(Modifiers::NONE, Key::ArrowLeft),
        Act::OrderDown,
        "Order N less one",
    ),
    (
        KeyboardShortcut::new(Modifiers::NONE, Key::ArrowRight),
        Act::OrderUp,
        "Order N plus one",
    ),
    (
        KeyboardShortcut::new(Modifiers::NONE, Key::PageDown),
        Act::ThresholdDown,
        "Lower spike threshold",
    ),
    (
        KeyboardShortcut::new(Modifiers::NONE, Key::PageUp),
        Act::ThresholdUp,
        "Higher spike threshold",
    ),
];

/// The acts of this frame's keys. Plain keys belong to whatever has the keyboard's focus.
pub(super) fn pressed(context: &Context) -> Vec<Act> {
    let focused = context.memory(|m| m.focused().is_some());
    // A text field has an undo of its own.
    let writing = context.text_edit_focused();
    let mut acts = Vec::new();
    context.input_mut(|input| {
        for (shortcut, act, _) in &SHORTCUTS {
            let is_function = matches!(shortcut.logical_key, Key::F1 | Key::F5 | Key::F11);
            let is_plain = shortcut.modifiers.is_none() && !is_function;
            let is_history = matches!(act, Act::Undo | Act::Redo);
            if (is_plain && focused) || (is_history && writing) {
                continue;
            }
            if input.consume_shortcut(shortcut) {
                acts.push(*act);
            }
        }
    });
    acts
}
