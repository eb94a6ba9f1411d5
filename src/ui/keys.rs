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
    /// Hold the light that is followed, or go on.
    Hold,
    /// Keep the spectrum that is shown.
    Capture,
}

/// What a person does with a key, in the order of the list.
pub(super) const GROUPS: [&str; 7] = [
    later!("Go to"),
    later!("Files"),
    later!("The model"),
    later!("The view"),
    later!("Undo and find"),
    later!("Help"),
    later!("A light that is followed"),
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
            Self::Hold | Self::Capture => 6,
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
pub(super) const SHORTCUTS: [Shortcut; 37] = [
    on(CTRL_SHIFT, Key::Z, Act::Redo, later!("Redo")),
    on(
        CTRL_SHIFT,
        Key::O,
        Act::TypePath,
        later!("Open a file or folder by typing its path"),
    ),
    on(
        CTRL_SHIFT,
        Key::F,
        Act::OpenFolder,
        later!("Open all files of a folder"),
    ),
    on(
        CTRL_SHIFT,
        Key::C,
        Act::CopyPicture,
        later!("Copy a picture of the window"),
    ),
    on(
        CTRL_SHIFT,
        Key::K,
        Act::CopyCommand,
        later!("Copy the command line for this view"),
    ),
    on(
        CTRL_SHIFT,
        Key::D,
        Act::Eyes,
        later!("Colours as a colour-blind eye sees them"),
    ),
    on(CTRL, Key::Z, Act::Undo, later!("Undo")),
    on(CTRL, Key::Y, Act::Redo, later!("Redo")),
    on(CTRL, Key::O, Act::Open, later!("Open files")),
    on(CTRL, Key::S, Act::SaveProject, later!("Save the project")),
    on(CTRL, Key::P, Act::Print, later!("Print this page")),
    on(CTRL, Key::F, Act::Search, later!("Search the library")),
    on(CTRL, Key::Plus, Act::ZoomIn, later!("Larger type")),
    on(CTRL, Key::Minus, Act::ZoomOut, later!("Smaller type")),
    on(CTRL, Key::Num0, Act::ZoomReset, later!("Type at 100 %")),
    on(
        CTRL,
        Key::D,
        Act::Theme,
        later!("Dark or light surroundings"),
    ),
    on(
        CTRL,
        Key::L,
        Act::Library,
        later!("Open or close the library"),
    ),
    on(
        CTRL,
        Key::K,
        Act::Palette,
        later!("Search lights, pages and commands"),
    ),
    on(CTRL, Key::Num1, Act::Place(0), later!("Learn")),
    on(CTRL, Key::Num2, Act::Place(1), later!("Look")),
    on(CTRL, Key::Num3, Act::Place(2), later!("Through")),
    on(CTRL, Key::Num4, Act::Place(3), later!("Quality")),
    on(CTRL, Key::Num5, Act::Place(4), later!("Design")),
    on(CTRL, Key::Num6, Act::Place(5), later!("Numbers")),
    on(CTRL, Key::Num7, Act::Place(6), later!("Picture")),
    on(PLAIN, Key::F5, Act::Present, later!("Present this page")),
    on(
        Modifiers::SHIFT,
        Key::R,
        Act::ResetPage,
        later!("This page back to the start"),
    ),
    on(
        PLAIN,
        Key::R,
        Act::Reset,
        later!("Model and layers back to the start"),
    ),
    on(
        PLAIN,
        Key::Home,
        Act::ResetView,
        later!("Fit the view of the plot"),
    ),
    on(
        Modifiers::SHIFT,
        Key::F1,
        Act::Shortcuts,
        later!("Shortcuts"),
    ),
    on(PLAIN, Key::F1, Act::Greeting, later!("The ways to begin")),
    on(
        PLAIN,
        Key::ArrowLeft,
        Act::OrderDown,
        later!("One wave less"),
    ),
    on(
        PLAIN,
        Key::ArrowRight,
        Act::OrderUp,
        later!("One wave more"),
    ),
    on(
        PLAIN,
        Key::PageDown,
        Act::ThresholdDown,
        later!("Keep fainter lines"),
    ),
    on(
        PLAIN,
        Key::PageUp,
        Act::ThresholdUp,
        later!("Keep only stronger lines"),
    ),
    on(PLAIN, Key::Space, Act::Hold, later!("Hold it, or go on")),
    on(
        PLAIN,
        Key::Enter,
        Act::Capture,
        later!("Capture it to My files"),
    ),
];

/// The acts of this frame's keys. Plain keys belong to whatever has the keyboard's focus; those of a
/// light that is followed count while one is.
pub(super) fn pressed(context: &Context, follows: bool) -> Vec<Act> {
    let focused = context.memory(|m| m.focused().is_some());
    // A text field has an undo of its own.
    let writing = context.text_edit_focused();
    let mut acts = Vec::new();
    context.input_mut(|input| {
        for (shortcut, act, _) in &SHORTCUTS {
            let is_function = matches!(shortcut.logical_key, Key::F1 | Key::F5);
            let is_plain = shortcut.modifiers.is_none() && !is_function;
            let is_history = matches!(act, Act::Undo | Act::Redo);
            let is_live = matches!(act, Act::Hold | Act::Capture);
            if (is_plain && focused) || (is_history && writing) || (is_live && !follows) {
                continue;
            }
            if input.consume_shortcut(shortcut) {
                acts.push(*act);
            }
        }
    });
    acts
}
