//! A ring around what a lesson points at: found by the name that it has for screen readers, brought
//! into view, and never in the way of the pointer.

use eframe::egui;
use egui::{
    Align2, Context, FullOutput, Id, LayerId, Order, Plugin, RawInput, Rect, Stroke, StrokeKind,
    accesskit::{Action, ActionRequest, Node, NodeId, Role, TreeId},
};

use super::theme::Theme;
use crate::languages::{said, translated};

/// Thickness of the ring and the room between it and what it is around, points.
const RING: f32 = 3.0;
const ROOM: f32 = 4.0;
/// What screen readers are told before the words beside it.
const HERE: &str = later!("Here: ");
/// Size of the words beside it, points.
const TYPE: f32 = 15.0;

/// Names with something filled in that lessons point at, as they are drawn.
const FILLED: [&str; 5] = [
    later!("Library: {name}"),
    later!("Move down step {number}"),
    later!("Thickness of step {number}"),
    later!("Fader {number}"),
    later!("Channel {number}: {title}"),
];

/// How what a lesson calls a name in English may begin in the language spoken.
fn spoken(wanted: &str) -> Vec<String> {
    let filled = FILLED.into_iter().filter_map(|english| {
        let (head, rest) = english.split_once('{')?;
        let (place, _) = rest.split_once('}')?;
        let value = wanted.strip_prefix(head.trim_end())?.trim();
        let words = match value {
            "" => said(english).to_owned(),
            value => said(english).replace(&format!("{{{place}}}"), value),
        };
        let begins = words.split('{').next().unwrap_or_default().to_owned();
        (!begins.is_empty()).then_some(begins)
    });
    let mut all = vec![wanted.to_owned(), translated(wanted).to_owned()];
    all.extend(filled);
    all
}

/// Finds what is called a name among all that was drawn last.
#[derive(Default)]
struct Finder {
    wanted: Option<String>,
    found: Option<(NodeId, Rect)>,
    /// Where words and controls stand that nothing should be laid over.
    busy: Vec<Rect>,
    /// It was brought into view once; whoever scrolls away afterwards is not held back.
    scrolled: bool,
}

impl Finder {
    /// How well a node fits, the best first: what is called so before what only begins so, and a
    /// control before the words beside it.
    fn fits(wanted: &[String], node: &Node, all: &[(NodeId, Node)]) -> Option<(bool, bool)> {
        // A slider has its name in the words before it.
        let before = node.labelled_by().iter();
        let before = before.filter_map(|by| all.iter().find(|(id, _)| id == by));
        let named = before.map(|(_, words)| words).chain([node]);
        let names = named
            .flat_map(|node| [node.label(), node.value()])
            .flatten();
        let fitting = names.filter(|name| wanted.iter().any(|wanted| name.starts_with(wanted)));
        let is_words = matches!(node.role(), Role::Label | Role::TextRun);
        fitting
            .map(|name| (wanted.iter().all(|wanted| name != wanted), is_words))
            .min()
    }
}

impl Plugin for Finder {
    fn debug_name(&self) -> &'static str {
        "what a lesson points at"
    }

    fn input_hook(&mut self, context: &Context, input: &mut RawInput) {
        let Some((target_node, _)) = self.found.filter(|_| !self.scrolled) else {
            return;
        };
        self.scrolled = true;
        let request = ActionRequest {
            action: Action::ScrollIntoView,
            target_tree: TreeId::ROOT,
            target_node,
            data: None,
        };
        input
            .events
            .push(egui::Event::AccessKitActionRequest(request));
        context.request_repaint();
    }

    fn output_hook(&mut self, context: &Context, output: &mut FullOutput) {
        let Some(update) = &output.platform_output.accesskit_update else {
            return;
        };
        let nodes = update.nodes.iter();
        let wanted = self.wanted.as_deref().map(spoken).unwrap_or_default();
        let fits = |node: &Node| Self::fits(&wanted, node, &update.nodes);
        let fitting = nodes.filter_map(|(id, node)| Some((fits(node)?, *id, rect_of(node)?)));
        // Of several with a name the first from above is meant: a slider, not the number beside it.
        let order = |(fits, id, rect): &((bool, bool), NodeId, Rect)| {
            (*fits, rect.top(), rect.left(), id.0)
        };
        let first = fitting.min_by(|a, b| {
            let order = order(a).partial_cmp(&order(b));
            order.unwrap_or(std::cmp::Ordering::Equal)
        });
        let found = first.map(|(_, id, rect)| (id, rect));
        let around = found.map(|(_, rect)| rect.shrink(ROOM));
        let nodes = update.nodes.iter();
        let busy = nodes.filter(|(_, node)| self.wanted.is_some() && is_busy(node));
        let busy = busy.filter_map(|(_, node)| rect_of(node));
        let busy: Vec<Rect> = busy
            .filter(|rect| !around.is_some_and(|around| around.intersects(*rect)))
            .collect();
        if found != self.found || busy != self.busy {
            (self.found, self.busy) = (found, busy);
            context.request_repaint();
        }
    }
}

/// Whether a person reads or works it: words about the ring itself apart.
fn is_busy(node: &Node) -> bool {
    let is_ring = |name: &str| name.starts_with(said(HERE));
    match node.role() {
        Role::Label => !node.label().or(node.value()).is_some_and(is_ring),
        Role::Button
        | Role::CheckBox
        | Role::ComboBox
        | Role::Link
        | Role::RadioButton
        | Role::Slider
        | Role::SpinButton
        | Role::TextInput => true,
        _ => false,
    }
}

fn rect_of(node: &Node) -> Option<Rect> {
    let bounds = node.bounds()?;
    let corner = |x: f64, y: f64| egui::pos2(x as f32, y as f32);
    let rect = Rect::from_min_max(corner(bounds.x0, bounds.y0), corner(bounds.x1, bounds.y1));
    rect.is_positive().then_some(rect)
}

/// Where the thing of a name stands, as of the last frame, and what stands around it; it is brought
/// into view once it is wanted.
pub(super) fn find(context: &Context, name: Option<&str>) -> (Option<Rect>, Vec<Rect>) {
    let finder = context.plugin_or_default::<Finder>();
    let mut finder = finder.lock();
    if finder.wanted.as_deref() != name {
        *finder = Finder {
            wanted: name.map(str::to_owned),
            ..Finder::default()
        };
    }
    if name.is_some() {
        // Names are told to screen readers alone, unless they are asked for.
        context.enable_accesskit();
    }
    (finder.found.map(|(_, rect)| rect), finder.busy.clone())
}

/// Draws the ring around a place, and the words beside it where they cover least of what is busy;
/// never over the lesson's column, which ends at `column`, where the ring stands beside it.
pub(super) fn ring(
    context: &Context,
    (around, busy): (Rect, &[Rect]),
    (label, column): (&str, f32),
    theme: Theme,
) {
    let mut screen = context.content_rect();
    if around.left() >= column {
        screen.min.x = column;
    }
    let rect = around.expand(ROOM + RING / 2.0);
    if !screen.intersects(around) {
        return;
    }
    // Over the pages, below lists and windows; it is painted and takes no click.
    let id = Id::unique("ring of a lesson");
    let painter = context.layer_painter(LayerId::new(Order::Middle, id));
    painter.rect_stroke(
        rect,
        6.0,
        Stroke::new(RING, theme.warning),
        StrokeKind::Middle,
    );
    let font = egui::FontId::proportional(TYPE * theme.scale);
    let words = painter.layout_no_wrap(label.to_owned(), font, theme.ground);
    let size = words.size() + egui::vec2(12.0, 6.0);
    let card = Rect::from_min_size(beside(rect, size, (screen, busy)), size);
    if gap_between(card, rect) > 2.0 * RING {
        let line = [rect.clamp(card.center()), card.clamp(rect.center())];
        painter.line_segment(line, Stroke::new(RING, theme.warning));
    }
    painter.rect_filled(card, 4.0, theme.warning);
    let at = Align2::CENTER_CENTER.align_size_within_rect(words.size(), card);
    painter.galley(at.min, words, theme.ground);
    context.accesskit_node_builder(id, |node| {
        node.set_role(Role::Label);
        node.set_label(format!("{}{label}", said(HERE)));
        node.set_bounds(egui::accesskit::Rect {
            x0: rect.left().into(),
            y0: rect.top().into(),
            x1: rect.right().into(),
            y1: rect.bottom().into(),
        });
    });
}

/// How far two places are from one another.
fn gap_between(a: Rect, b: Rect) -> f32 {
    let x = (a.left() - b.right()).max(b.left() - a.right()).max(0.0);
    let y = (a.top() - b.bottom()).max(b.top() - a.bottom()).max(0.0);
    x.hypot(y)
}

/// Where words of a size stand beside a ring: below it or above it, and at the side of a tall one,
/// whose ends are at the edges of a plot, and of one in the top bar, below which there is text.
/// Where they would cover something there, as near as they cover least.
fn beside(ring: Rect, size: egui::Vec2, (screen, busy): (Rect, &[Rect])) -> egui::Pos2 {
    const TALL: f32 = 160.0;
    const BAR: f32 = 48.0;
    let gap = RING + 1.0;
    let is_tall = ring.height() > TALL;
    let at_side = is_tall || ring.center().y < screen.top() + BAR;
    let middle = match is_tall {
        true => ring.top() + size.y,
        false => ring.center().y - size.y / 2.0,
    };
    let (over, under) = (ring.top() - gap - size.y, ring.bottom() + gap);
    let flush = ring.right() - size.x;
    let right = egui::pos2(ring.right() + gap, middle);
    let left = egui::pos2(ring.left() - gap - size.x, middle);
    let below = [ring.left(), flush].map(|x| egui::pos2(x, under));
    let above = [ring.left(), flush].map(|x| egui::pos2(x, over));
    let ways = match at_side {
        true => [right, left, below[0], below[1], above[0], above[1]],
        false => [below[0], above[0], right, left, below[1], above[1]],
    };
    let inside = screen.shrink(ROOM);
    let least = inside.min;
    let most = (inside.max - size).max(least);
    let covered = |at: egui::Pos2| -> f32 {
        let card = Rect::from_min_size(at, size);
        let all = busy.iter().chain([&ring]);
        let common = all.map(|rect| card.intersect(*rect));
        let common = common.filter(|common| common.is_positive());
        common.map(|common| common.area()).sum()
    };
    let ways = ways.map(|at| at.clamp(least, most));
    const STEP: f32 = 24.0;
    const STEPS: i32 = 14;
    let further = (-STEPS..=STEPS).flat_map(|across| {
        let x = ring.left() + STEP * across as f32;
        let rows = [-3.0, -2.0, -1.0, 0.0, 1.0, 2.0, 3.0];
        let y = ring.center().y - size.y / 2.0;
        let row = (ring.height() + size.y) / 2.0 + gap;
        rows.map(|down: f32| egui::pos2(x, y + down * row).clamp(least, most))
    });
    let card = |at: egui::Pos2| Rect::from_min_size(at, size);
    let cost = |at: egui::Pos2| (covered(at), gap_between(card(at), ring));
    let best = ways.into_iter().chain(further).min_by(|a, b| {
        let order = cost(*a).partial_cmp(&cost(*b));
        order.unwrap_or(std::cmp::Ordering::Equal)
    });
    best.unwrap_or(ways[0])
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::languages::{Language, in_language};

    #[test]
    fn what_lessons_point_at_is_known_in_every_language() {
        // Charts have one name everywhere.
        const SAME: [&str; 2] = ["Straightened strip", "Profile of the strip"];
        for lesson in crate::app::lessons::shelf::shipped() {
            let points = lesson.steps.iter().filter_map(|step| step.point.as_ref());
            for control in points.filter_map(|point| point.control()) {
                let words = in_language(Language::German, || spoken(control));
                // A name with something filled in, or one that is another word.
                let is_spoken = words.len() > 2 || words[1] != control;
                assert!(
                    is_spoken || SAME.contains(&control),
                    "{}: {control}",
                    lesson.name
                );
            }
        }
    }

    #[test]
    fn words_beside_a_ring_cover_nothing_where_there_is_room() {
        let screen = Rect::from_min_size(egui::Pos2::ZERO, egui::vec2(1000.0, 700.0));
        let ring = Rect::from_min_size(egui::pos2(400.0, 300.0), egui::vec2(200.0, 30.0));
        let size = egui::vec2(150.0, 24.0);
        let card = |busy: &[Rect]| Rect::from_min_size(beside(ring, size, (screen, busy)), size);
        let free = card(&[]);
        assert!(free.top() > ring.bottom() && free.left() == ring.left());
        let mut busy = vec![free];
        // Below, above, right, left: what is taken is left alone.
        for _ in 0..3 {
            let next = card(&busy);
            assert!(!busy.iter().any(|rect| rect.intersects(next)), "{next}");
            assert!(!ring.intersects(next) && screen.contains_rect(next));
            busy.push(next.shrink(1.0));
        }
    }
}
