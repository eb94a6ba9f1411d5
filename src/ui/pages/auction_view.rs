//! The page "Auction": what to buy with the next numbers.

use crate::ui::kit::drag_value;
use std::sync::Arc;

use eframe::egui;
use egui::{Ui, vec2};

use super::{
    PageContext, progress,
    tradeoff_view::{choose, is_now},
};
use crate::{
    app::{
        App, ByAddress, Command, Memo,
        charts::{
            auction::{
                AuctionChart, NAMES, ended_words, error_words, gain_words, goal_within, names,
                purchases_words,
            },
            tradeoff::{self, all_figures, lack},
        },
        last_order_of,
        pages::SPENDABLE,
        studies::{About, AuctionAsk, Stage, take},
    },
    io::many::numbers,
    languages::said,
    study::{Auction, FitVariant, Goal, Reference},
    ui::kit::{Column, Row, headline, named, rolled, table},
};

/// From this width on chart and table stand side by side, points.
const WIDE: f32 = 1080.0;

/// How the auction goes.
const RULES: &str = later!(
    "A wave and a line cost two numbers each; one more number gives all lines their own widths. At \
     every price these are tried: one purchase more for each of the eight best models so far, two \
     more for the best, and every count of waves with none, one, two ... of the heaviest lines. \
     The model of lowest error is sold, or one within a twentieth of it that keeps what was bought \
     before; otherwise something is given back."
);

/// Largest weight of a goal.
const MOST_WEIGHT: f64 = 100.0;

/// Chart and table of one auction.
struct Sheet {
    ask: AuctionAsk,
    auction: Arc<Auction>,
    chart: AuctionChart,
    ended: String,
    columns: Vec<Column>,
    rows: Vec<Row>,
    /// The document's revision whose model is marked.
    marked: Option<u64>,
    /// The step that is the document's present model.
    chosen: Option<usize>,
}

#[derive(Default)]
pub(super) struct AuctionView {
    sheet: Memo<ByAddress<Auction>, Sheet>,
    reference: Memo<About, Option<Reference>>,
}

impl AuctionView {
    pub(super) fn show(&mut self, ui: &mut Ui, context: &mut PageContext<'_>) {
        let app = context.app;
        let goal = goal_within(app, context.pages.auction.goal);
        let ask = AuctionAsk::of(app.document(), goal, context.pages.auction.numbers);
        let job = context.put(&ask);
        let stage = job.stage();
        let answer = job.answer().filter(|_| stage != Stage::Impossible);
        let answer = answer.map(|(key, found)| (key.clone(), found.clone()));
        if answer.is_none() || stage != Stage::Done {
            progress(ui, job, said!("The auction"));
        }
        let Some((key, auction)) = answer else {
            return controls(ui, context, goal);
        };
        let of = ByAddress(auction.clone());
        let sheet = self
            .sheet
            .get(of, |auction| Sheet::of(app, key.clone(), auction.0.clone()));
        let fresh = key == ask;
        if fresh && sheet.marked != Some(app.revision()) {
            let reference = self.reference.get(key.about.clone(), tradeoff::reference);
            sheet.mark(app, reference.as_ref());
        }
        if stage == Stage::Done {
            headline(ui, context.theme, &sheet.ended);
        }
        controls(ui, context, goal);
        if stage == Stage::Done {
            take_last(ui, context, sheet, fresh);
        }
        ui.add_space(14.0);
        lay_out(ui, context, sheet, fresh);
    }
}

impl Sheet {
    fn of(app: &App, ask: AuctionAsk, auction: Arc<Auction>) -> Self {
        let names = names(&ask, &auction, app.element_lines());
        let About {
            subject,
            under,
            band,
            ..
        } = &ask.about;
        let of = subject.0.measured.as_deref().filter(|_| under.is_none());
        let last = of.and_then(|of| last_order_of(of, *band, ask.terms.basis));
        let told = (ask.terms.goal, last);
        let rows = (0..auction.steps.len())
            .map(|i| row(&auction, i, told, &names))
            .collect();
        Self {
            chart: AuctionChart::of(&ask, &auction, &names),
            ended: ended_words(&ask, &auction),
            columns: columns(),
            rows,
            marked: None,
            chosen: None,
            ask,
            auction,
        }
    }

    /// Marks the present model in chart and table.
    fn mark(&mut self, app: &App, reference: Option<&Reference>) {
        self.marked = Some(app.revision());
        let now = reference.and_then(|reference| tradeoff::verdict_now(app, reference));
        self.chart.mark(app, &self.ask, &self.auction, now.as_ref());
        let numbers = app.derived().numbers();
        let mut steps = self.auction.steps.iter();
        let step = steps.position(|step| step.numbers == numbers);
        self.chosen = step.filter(|step| is_now(app, self.taking(app, *step)));
    }

    /// What takes the model of a step.
    fn taking(&self, app: &App, step: usize) -> Command {
        let settings = app.document().settings;
        let step = &self.auction.steps[step];
        take(settings, &self.ask, &self.auction, step)
    }
}

/// Goal and budget.
fn controls(ui: &mut Ui, context: &mut PageContext<'_>, goal: Goal) {
    ui.horizontal_wrapped(|ui| {
        ui.label(said!("Lower the error of"))
            .on_hover_text(said!("The error that each purchase lowers most."));
        for (i, (_, plain)) in Goal::PLAIN.into_iter().enumerate() {
            let named = (Goal::MEASURES[i], said(NAMES[i]));
            if choose(ui, context.app, named, goal == plain) {
                context.pages.auction.goal = plain;
            }
        }
    });
    ui.horizontal_wrapped(|ui| {
        ui.label(said!("or a mix of")).on_hover_text(said!(
            "Weights of the four errors. In a mix each error is divided by its value without \
             waves, so that they can be added."
        ));
        weights(ui, context, goal);
    });
    ui.horizontal_wrapped(|ui| {
        let label = ui.label(said!("Spend up to"));
        let numbers = drag_value(&mut context.pages.auction.numbers)
            .range(SPENDABLE)
            .speed(0.1);
        ui.add(numbers).labelled_by(label.id).on_hover_text(said!(
            "Most numbers that may be spent, 1 to 101; a wave and a line cost two."
        ));
        let settings = context.app.document().settings;
        let way = FitVariant::new(settings.basis, false, settings.colour_exact);
        ui.label(said!("numbers"));
        ui.weak(tr!(
            "{way}, as in the model.",
            way = crate::languages::said(way.title())
        ))
        .on_hover_text(said!(
            "Basis, fit and threshold are the document's; change them there."
        ));
        if goal.plain_measure().is_none() {
            ui.weak(said!("Each error over its value without waves."));
        }
    });
}

/// The weights of a mixed goal.
fn weights(ui: &mut Ui, context: &mut PageContext<'_>, goal: Goal) {
    let lacks = Goal::MEASURES.map(|measure| lack(context.app, measure));
    let mut weights = goal.weights();
    let mut changed = false;
    for (i, weight) in weights.iter_mut().enumerate() {
        let value = drag_value(weight)
            .speed(0.02)
            .range(0.0..=MOST_WEIGHT)
            .max_decimals(2);
        let response = ui.add_enabled(lacks[i].is_none(), value);
        let name = tr!("Weight of {error}", error = said(NAMES[i]));
        named(&response, egui::Role::SpinButton, &name);
        changed |= response.changed();
        let meaning = Goal::MEASURES[i].figure().meaning();
        response
            .on_hover_text(format!("{meaning} {}", said!("Its weight in the mix.")))
            .on_disabled_hover_text(lacks[i].unwrap_or_default());
        ui.weak(said(NAMES[i]));
    }
    if changed && weights.iter().any(|weight| *weight > 0.0) {
        let [own, patches, spectrum, filters] = weights;
        context.pages.auction.goal = Goal {
            own,
            patches,
            spectrum,
            filters,
        };
    }
}

fn columns() -> Vec<Column> {
    vec![
        Column::numbers(said!("numbers"), said!("Spent so far."), 1.15),
        Column::words(
            said!("bought"),
            said!("The use of two more numbers, or four."),
            3.6,
        ),
        Column::words(
            said!("given back"),
            said!("Parts that the better model at this price does without."),
            3.0,
        ),
        Column::numbers(
            said!("error"),
            said!(
                "The goal: CIEDE2000, or percent; of a mix the weighted mean of the errors, each \
                 over its value at N = 0."
            ),
            1.2,
        ),
        Column::numbers(
            said!("lower by"),
            said!("Than the step before, percent."),
            1.2,
        ),
    ]
}

/// A step in words; waves beyond `last` draw the noise of the readings.
fn row(
    auction: &Auction,
    index: usize,
    (goal, last): (Goal, Option<usize>),
    names: &[crate::app::LineName],
) -> Row {
    let step = &auction.steps[index];
    let previous = index.checked_sub(1).map(|i| &auction.steps[i]);
    let before = previous.map(|previous| previous.error);
    let is_wave = previous.is_some_and(|previous| step.order > previous.order);
    let bought = match step.bought.is_empty() {
        true => said!("the mean").to_owned(),
        false => purchases_words(&step.bought, auction, names),
    };
    let bought = match last.is_some_and(|last| is_wave && step.order > last) {
        true => tr!("{bought} (noise)", bought),
        false => bought,
    };
    let gave_back = purchases_words(&step.gave_back, auction, names);
    let error = error_words(goal, step.error);
    let gain = before.map_or(String::new(), |before| gain_words(before, step.error));
    let cells = vec![
        step.numbers.to_string(),
        bought.clone(),
        gave_back.clone(),
        error.clone(),
        gain,
    ];
    Row {
        cells,
        name: tr!(
            "Step {step}: {numbers}, {bought}, error {error}",
            step = index + 1,
            numbers = numbers(step.numbers),
            bought,
            error
        ),
        note: [
            match gave_back.is_empty() {
                true => tr!("Bought {bought}.", bought),
                false => tr!("Bought {bought}; gave back {gave_back}.", bought, gave_back),
            },
            all_figures(&step.verdict),
            said!("Click to take this model.").to_owned(),
        ]
        .join("\n"),
        ..Row::default()
    }
}

/// Chart and table in the room there is.
fn lay_out(ui: &mut Ui, context: &mut PageContext<'_>, sheet: &Sheet, fresh: bool) {
    let room = ui.available_size();
    let scale = context.theme.scale;
    if room.x >= WIDE * scale {
        ui.columns(2, |columns| {
            let size = vec2(columns[0].available_width(), room.y);
            chart(&mut columns[0], context, sheet, size, fresh);
            rolled(&mut columns[1], |ui| steps(ui, context, sheet, fresh));
        });
    } else {
        rolled(ui, |ui| {
            let height = (0.52 * room.y).clamp(260.0 * scale, 420.0 * scale);
            let size = vec2(ui.available_width(), height);
            chart(ui, context, sheet, size, fresh);
            ui.add_space(4.0);
            steps(ui, context, sheet, fresh);
        });
    }
}

/// A button to take what was bought.
fn take_last(ui: &mut Ui, context: &mut PageContext<'_>, sheet: &Sheet, fresh: bool) {
    let last = sheet.auction.steps.len() - 1;
    let taken = sheet.chosen == Some(last);
    let button = ui.add_enabled(fresh && !taken, egui::Button::new(said!("Take this model")));
    if button.clicked() {
        act(context, sheet, last);
    }
    button
        .on_hover_text(said!(
            "Makes the model that was bought in the end the document's, in one step of undo."
        ))
        .on_disabled_hover_text(if taken {
            said!("It is the model in force.")
        } else {
            said!("The auction is still running.")
        });
}

fn chart(ui: &mut Ui, context: &mut PageContext<'_>, sheet: &Sheet, size: egui::Vec2, fresh: bool) {
    let shown = context.chart(ui, &sheet.chart.chart, "auction", size);
    let step = shown
        .clicked
        .and_then(|hit| sheet.chart.step(hit.series, hit.point));
    if fresh && let Some(step) = step {
        act(context, sheet, step);
    }
}

fn steps(ui: &mut Ui, context: &mut PageContext<'_>, sheet: &Sheet, fresh: bool) {
    let (columns, rows) = (&sheet.columns, &sheet.rows);
    if let Some(step) = table(ui, columns, rows, sheet.chosen, fresh, context.theme) {
        act(context, sheet, step);
    }
    ui.add_space(8.0);
    ui.weak(said(RULES));
}

/// Takes the model of a step.
fn act(context: &mut PageContext<'_>, sheet: &Sheet, step: usize) {
    if step < sheet.auction.steps.len() {
        context.commands.push(sheet.taking(context.app, step));
    }
}
