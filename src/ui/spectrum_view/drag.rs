//! Dragging spikes: a press on a stem or its tip takes hold of it, moving it sets place and weight.

use eframe::egui;
use egui::{Pos2, Ui, Vec2};

use super::{
    super::chart_view::{ChartResponse, Screen},
    Wishes,
};
use crate::{
    app::{App, SpikeAct},
    spectrum::Line,
};

/// How near the pointer must come to a spike's tip, points.
const GRAB: f32 = 10.0;
/// How near to its stem.
const GRAB_STEM: f32 = 5.0;
/// How far the pointer must move before a press becomes a drag, points.
const DEAD_ZONE: f32 = 3.0;

/// What the pointer holds.
#[derive(Default)]
pub(super) struct Dragging {
    held: Option<Drag>,
}

/// The stems as they are drawn: their tips, and the heights that they stand on.
#[derive(Default)]
pub(super) struct Stems<'a> {
    pub tips: &'a [[f64; 2]],
    pub feet: &'a [f64],
}

/// A spike under the pointer's button.
#[derive(Clone, Copy, Debug)]
struct Drag {
    index: usize,
    /// Its place among the hand edits once it was moved.
    hand: Option<usize>,
    start: Pos2,
    /// From the pointer to the tip.
    to_tip: Vec2,
}

impl Dragging {
    /// Whether the pointer holds a line.
    pub(super) fn holds(&self) -> bool {
        self.held.is_some()
    }

    /// The spike whose tip, or else whose stem, is under the pointer.
    pub(super) fn nearest(
        screen: &Screen,
        pointer: Option<Pos2>,
        stems: &Stems<'_>,
    ) -> Option<usize> {
        let pointer = pointer.filter(|at| screen.frame().contains(*at))?;
        let distances = stems.tips.iter().enumerate().filter_map(|(i, tip)| {
            let top = screen.pos(*tip)?;
            let foot = screen.pos([tip[0], stems.feet.get(i).copied().unwrap_or(0.0)]);
            let foot = foot.unwrap_or(Pos2::new(top.x, screen.frame().bottom()));
            let (low, high) = (top.y.min(foot.y), top.y.max(foot.y));
            let on_stem = Pos2::new(top.x, pointer.y.clamp(low, high)).distance(pointer);
            let from_tip = top.distance(pointer);
            match (from_tip <= GRAB, on_stem <= GRAB_STEM) {
                (true, _) => Some((from_tip, i)),
                // A tip nearby goes before a stem.
                (false, true) => Some((GRAB + on_stem, i)),
                (false, false) => None,
            }
        });
        let nearest = distances.min_by(|a, b| a.0.total_cmp(&b.0));
        nearest.map(|(_, i)| i)
    }

    /// Takes hold, moves, lets go; beside all tips a double click with Shift sets a line, and a click
    /// where that was asked for.
    pub(super) fn interact(
        &mut self,
        ui: &Ui,
        app: &App,
        plot: &ChartResponse,
        tips: &[[f64; 2]],
        (adds_line, near): (&mut bool, Option<usize>),
        wishes: &mut Wishes,
    ) {
        let response = &plot.response;
        let at = |pointer: Pos2| {
            let [nm, height] = plot.main.values(pointer);
            (nm, height / app.scale_factor())
        };
        let (pointer, pressed, released) = ui.input(|i| {
            (
                i.pointer.interact_pos(),
                i.pointer.primary_pressed(),
                i.pointer.primary_released(),
            )
        });
        let inside = response.contains_pointer();
        if near.is_some() && inside {
            ui.ctx().set_cursor_icon(egui::CursorIcon::Grab);
        }
        let derived = app.derived();
        let base_at = |nm: f64| derived.band.interpolate(&derived.smooth, nm);
        if let (Some(index), Some(start), true) = (near, pointer, pressed && inside) {
            let hand = derived.parts.spikes.get(index).and_then(|s| s.hand);
            let tip = tips.get(index).and_then(|tip| plot.main.pos(*tip));
            self.held = Some(Drag {
                index,
                hand,
                start,
                to_tip: tip.map_or(Vec2::ZERO, |tip| tip - start),
            });
        }
        if let (Some(drag), Some(pointer)) = (self.held, pointer)
            && (drag.start.distance(pointer) > DEAD_ZONE || drag.hand_moved(app))
        {
            ui.ctx().set_cursor_icon(egui::CursorIcon::Grabbing);
            let (at_nm, height) = at(pointer + drag.to_tip);
            let at_nm = at_nm.clamp(derived.band.min_nm(), derived.band.max_nm());
            let height = height - base_at(at_nm);
            let hands = app.document().subject_edits().hand.len();
            let hand = drag.hand.unwrap_or(hands);
            let index = derived
                .parts
                .spikes
                .iter()
                .position(|s| s.hand == Some(hand))
                .unwrap_or(drag.index);
            let width = derived.parts.stem_width_nm(index);
            let weight = Line::weight_from_stem(height, width);
            wishes.acts.push(SpikeAct::Set {
                index,
                at_nm,
                weight,
            });
            self.held = Some(Drag {
                hand: Some(hand),
                ..drag
            });
        }
        if released && self.held.take().is_some() {
            wishes.gesture_ended = true;
        }
        if *adds_line && inside {
            ui.ctx().set_cursor_icon(egui::CursorIcon::Crosshair);
        }
        let asked = *adds_line && response.clicked();
        let with_shift = response.double_clicked() && ui.input(|i| i.modifiers.shift);
        if (asked || with_shift)
            && near.is_none()
            && let Some(pointer) = pointer
        {
            *adds_line = false;
            let (at_nm, height) = at(pointer);
            if derived.band.contains(at_nm) {
                let height = height - base_at(at_nm);
                wishes.acts.push(SpikeAct::Add {
                    at_nm,
                    weight: Line::weight_from_stem(height, derived.parts.stem_width_nm(usize::MAX)),
                });
            }
        }
    }
}

impl Drag {
    /// Whether the spike was moved already: then every further move counts.
    fn hand_moved(self, app: &App) -> bool {
        self.hand
            .is_some_and(|h| h < app.document().subject_edits().hand.len())
            && app
                .derived()
                .parts
                .spikes
                .get(self.index)
                .is_none_or(|s| s.hand != self.hand)
    }
}
