//! Shortcuts: what keys do, and the list that the window shows of them.

use eframe::egui;
use egui::{Context, Key, KeyboardShortcut, Modifiers};

/// What a key asks for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Act {
    Open,
    OpenFolder,
    TypePath,
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
    /// As other eyes see the window.
    Eyes,
    /// Targets for fingers, or for a pointer.
    Touch,
    /// Plot, swatch, patches and sliders alone, large.
    Present,
    /// Into the search field.
    Search,
    /// The library, or the page without it.
    Library,
    /// A place of the window, by its number in the rail.
    Place(usize),
    /// Everything back to the start.
    Reset,
    /// What the page in force keeps back to the start.
    ResetPage,
    /// Finds lights, places and acts by a few letters.
    Palette,
    /// The ways to begin.
    Greeting,
    /// Larger.
    ZoomIn,
    /// Smaller.
    ZoomOut,
    ZoomReset,
    /// The list of shortcuts.
    Shortcuts,
    /// Copy a picture of the window.
    CopyPicture,
    /// Copy the command line that gives the same.
    CopyCommand,
    /// Print the page.
    Print,
}

/// What a person does with a key, in the order of the list.
pub(super) const GROUPS: [&str; 6] = [
    "Go to",
    "Files",
    "The model",
    "The view",
    "Undo and find",
    "Help",
];

impl Act {
    /// Its group, one of [`GROUPS`].
    pub(super) fn group(self) -> &'static str {
        GROUPS[match self {
            Self::Place(_) | Self::Library => 0,
            Self::Open
            | Self::OpenFolder
            | Self::TypePath
            | Self::SaveProject
            | Self::CopyPicture
            | Self::CopyCommand
            | Self::Print => 1,
            Self::OrderDown
            | Self::OrderUp
            | Self::ThresholdDown
            | Self::ThresholdUp
            | Self::Reset
            | Self::ResetPage => 2,
            Self::ResetView
            | Self::Theme
            | Self::Eyes
            | Self::Touch
            | Self::Present
            | Self::ZoomIn
            | Self::ZoomOut
            | Self::ZoomReset => 3,
            Self::Undo | Self::Redo | Self::Search | Self::Palette => 4,
            Self::Greeting | Self::Shortcuts => 5,
        }]
    }
}

const PLAIN: Modifiers = Modifiers::NONE;
const CTRL: Modifiers = Modifiers::COMMAND;
const CTRL_SHIFT: Modifiers = Modifiers::COMMAND.plus(Modifiers::SHIFT);

/// Keys, what they do, and that in words.
type Shortcut = (KeyboardShortcut, Act, &'static str);

const fn on(modifiers: Modifiers, key: Key, act: Act, words: &'static str) -> Shortcut {
    (KeyboardShortcut::new(modifiers, key), act, words)
}

/// Every shortcut with what it does; those with more modifiers first, because a shortcut with
/// fewer would swallow them.
pub(super) const SHORTCUTS: [Shortcut; 35] = [
    on(CTRL_SHIFT, Key::Z, Act::Redo, "Redo"),
    on(
        CTRL_SHIFT,
        Key::O,
        Act::TypePath,
        "Open a file or folder by typing its path",
    ),
    on(
        CTRL_SHIFT,
        Key::F,
        Act::OpenFolder,
        "Open all files of a folder",
    ),
    on(
        CTRL_SHIFT,
        Key::C,
        Act::CopyPicture,
        "Copy a picture of the window",
    ),
    on(
        CTRL_SHIFT,
        Key::K,
        Act::CopyCommand,
        "Copy the command line for this view",
    ),
    on(
        CTRL_SHIFT,
        Key::D,
        Act::Eyes,
        "Colours as a colour-blind eye sees them",
    ),
    on(CTRL, Key::Z, Act::Undo, "Undo"),
    on(CTRL, Key::Y, Act::Redo, "Redo"),
    on(CTRL, Key::O, Act::Open, "Open files"),
    on(CTRL, Key::S, Act::SaveProject, "Save the project"),
    on(CTRL, Key::P, Act::Print, "Print this page"),
    on(CTRL, Key::F, Act::Search, "Search the library"),
    on(CTRL, Key::Plus, Act::ZoomIn, "Larger type"),
    on(CTRL, Key::Minus, Act::ZoomOut, "Smaller type"),
    on(CTRL, Key::Num0, Act::ZoomReset, "Type at 100 %"),
    on(CTRL, Key::D, Act::Theme, "Dark or light surroundings"),
    on(CTRL, Key::L, Act::Library, "Open or close the library"),
    on(
        CTRL,
        Key::K,
        Act::Palette,
        "Search lights, pages and commands",
    ),
    on(CTRL, Key::Num1, Act::Place(0), "Learn"),
    on(CTRL, Key::Num2, Act::Place(1), "Look"),
    on(CTRL, Key::Num3, Act::Place(2), "Through"),
    on(CTRL, Key::Num4, Act::Place(3), "Quality"),
    on(CTRL, Key::Num5, Act::Place(4), "Design"),
    on(CTRL, Key::Num6, Act::Place(5), "Numbers"),
    on(CTRL, Key::Num7, Act::Place(6), "Picture"),
    on(PLAIN, Key::F5, Act::Present, "Present this page"),
    on(
        Modifiers::SHIFT,
        Key::R,
        Act::ResetPage,
        "This page back to the start",
    ),
    on(
        PLAIN,
        Key::R,
        Act::Reset,
        "Model and layers back to the start",
    ),
    on(PLAIN, Key::Home, Act::ResetView, "Fit the view of the plot"),
    on(Modifiers::SHIFT, Key::F1, Act::Shortcuts, "Shortcuts"),
    on(PLAIN, Key::F1, Act::Greeting, "The ways to begin"),
    on(PLAIN, Key::ArrowLeft, Act::OrderDown, "One wave less"),
    on(PLAIN, Key::ArrowRight, Act::OrderUp, "One wave more"),
    on(
        PLAIN,
        Key::PageDown,
        Act::ThresholdDown,
        "Keep fainter lines",
    ),
    on(
        PLAIN,
        Key::PageUp,
        Act::ThresholdUp,
        "Keep only stronger lines",
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
            let is_function = matches!(shortcut.logical_key, Key::F1 | Key::F5);
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
