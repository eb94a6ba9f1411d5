//! "Spend 21 numbers for me": the auction in one row.

use eframe::egui;
use egui::Ui;

use super::{
    kit::{Choice, named},
    pages::auction_view::budget,
    theme::Wake,
};
use crate::{
    app::{
        App, Command,
        charts::{
            auction::{
                MEANINGS, MEASURES, NAMES, error_words, goal_error, goal_within, goal_words,
                model_words,
            },
            tradeoff::{lack, reference, verdict_now},
        },
        pages::PageMemory,
        state::Tone,
        studies::{AuctionAsk, Stage, Studies, take},
    },
    io::many::numbers,
    study::{Auction, Goal},
};

/// What the row wants said in the status line.
pub type Outcome = Option<(Tone, String)>;

/// The row and the question that its button started.
#[derive(Default)]
pub struct SpendView {
    /// Answered once, then forgotten.
    waiting: Option<AuctionAsk>,
}

impl SpendView {
    /// Draws the row; when the auction that it started is over, pushes its model.
    pub fn show(
        &mut self,
        ui: &mut Ui,
        app: &App,
        studies: &mut Studies,
        memory: &mut PageMemory,
        wake: &Wake,
        commands: &mut Vec<Command>,
    ) -> Outcome {
        ui.horizontal(|ui| {
            if self.waiting.is_some() {
                under_way(ui, studies);
            } else if row(ui, app, memory) {
                let goal = goal_within(app, memory.spend_goal.unwrap_or(memory.goal));
                let ask = AuctionAsk::of(app.document(), goal, memory.spend_numbers);
                // What was asked for and cancelled before is wanted again.
                studies.spend.retry();
                self.waiting = Some(ask);
            }
        });
        self.settle(app, studies, wake, commands)
    }

    /// Asks what is waiting to be asked, and carries out what was answered.
    fn settle(
        &mut self,
        app: &App,
        studies: &mut Studies,
        wake: &Wake,
        commands: &mut Vec<Command>,
    ) -> Outcome {
        let ask = self.waiting.clone()?;
        let present = AuctionAsk::of(app.document(), ask.terms.goal, ask.terms.numbers);
        if present != ask {
            // The answer would be about something that is no longer shown.
            studies.spend.cancel();
            self.waiting = None;
            let words = "Nothing was spent: spectrum, range, basis or threshold changed meanwhile.";
            return Some((Tone::Info, words.to_owned()));
        }
        let job = &mut studies.spend;
        job.ask_by(&ask, wake, AuctionAsk::answer);
        if let Some(auction) = job.result_for(&ask) {
            self.waiting = None;
            let settings = app.document().settings;
            let command = take(settings, &ask, auction, auction.last());
            let words = words(app, &ask, auction, &command);
            commands.push(command);
            return Some((Tone::Info, words));
        }
        let outcome = match job.stage() {
            Stage::Idle | Stage::Running(_) | Stage::Done => return None,
            Stage::Cancelled => (Tone::Info, "Cancelled: nothing was spent."),
            Stage::Broken => (
                Tone::Problem,
                "Nothing was spent: the computation broke down, a fault of this program.",
            ),
            Stage::Impossible => (
                Tone::Problem,
                "Nothing was spent: there is nothing to measure on this spectrum and range.",
            ),
        };
        self.waiting = None;
        Some((outcome.0, outcome.1.to_owned()))
    }
}

/// The share that is done, and a button to stop it.
fn under_way(ui: &mut Ui, studies: &mut Studies) {
    let share = match studies.spend.stage() {
        Stage::Running(share) => share,
        _ => 0.0,
    };
    let bar = ui.add(
        egui::ProgressBar::new(share)
            .desired_width(140.0)
            .show_percentage(),
    );
    named(&bar, egui::Role::ProgressIndicator, "The auction");
    ui.label("spending");
    if ui
        .button("Cancel")
        .on_hover_text("Stops the auction; the model stays as it is.")
        .clicked()
    {
        studies.spend.cancel();
    }
}

/// Button, count and goal; whether the button was pressed.
fn row(ui: &mut Ui, app: &App, memory: &mut PageMemory) -> bool {
    let lacks = MEASURES.map(|measure| lack(app, measure));
    let possible = lacks.iter().any(Option::is_none);
    let button = ui.add_enabled(possible, egui::Button::new("Spend"));
    let pressed = button.clicked();
    button
        .on_hover_text(
            "Holds the auction and takes what it buys: orders and lines, whichever lower the goal \
             most. Basis and fit stay as they are; one step of undo.",
        )
        .on_disabled_hover_text("The spectrum is zero over the whole range.");
    let count = budget(ui, &mut memory.spend_numbers);
    named(&count, egui::Role::SpinButton, "Numbers to spend");
    count.on_hover_text("Most numbers that the model may take, 1 to 101.");
    ui.label("numbers for me:");
    goals(ui, app, memory, lacks);
    pressed
}

const AS_AUCTION: &str = "Auction page's goal";

/// What is to be made small.
fn goals(ui: &mut Ui, app: &App, memory: &mut PageMemory, lacks: [Option<&'static str>; 4]) {
    let asked = memory.spend_goal;
    let within = asked.map(|goal| goal_within(app, goal));
    let name_of = |goal: Goal| {
        let plain = Goal::PLAIN.iter().position(|(_, plain)| *plain == goal);
        plain.map_or_else(|| goal.words(), |i| NAMES[i].to_owned())
    };
    let shown = within.map_or_else(|| AS_AUCTION.to_owned(), name_of);
    let choice = Choice {
        name: "Goal of spending",
        meaning: "What is to be made small with these numbers.",
        width: (ui.available_width() - 8.0).max(60.0),
    };
    choice.show(ui, shown, |ui| {
        for (i, (_, plain)) in Goal::PLAIN.into_iter().enumerate() {
            let button = egui::Button::selectable(within == Some(plain), NAMES[i]);
            let response = ui.add_enabled(lacks[i].is_none(), button);
            if response.clicked() {
                memory.spend_goal = Some(plain);
            }
            response
                .on_hover_text(MEANINGS[i])
                .on_disabled_hover_text(lacks[i].unwrap_or_default());
        }
        let goal = goal_within(app, memory.goal);
        if ui
            .selectable_label(asked.is_none(), AS_AUCTION)
            .on_hover_text(format!("Now: {}.", goal_words(goal)))
            .clicked()
        {
            memory.spend_goal = None;
        }
    });
}

/// What was bought, in a sentence; both errors are measured on the models themselves.
fn words(app: &App, ask: &AuctionAsk, auction: &Auction, command: &Command) -> String {
    let (goal, last) = (ask.terms.goal, auction.last());
    let mut after = app.clone();
    after.apply(command.clone());
    let reference = reference(&ask.about);
    let error = |app: &App| {
        let verdict = verdict_now(app, reference.as_ref()?)?;
        let error = goal_error(goal, &verdict, &auction.steps[0].verdict)?;
        Some(error_words(goal, error))
    };
    let was = error(app).map_or_else(String::new, |error| format!(" (was {error})"));
    format!(
        "Spent {} of {}: {}; {} {}{was}.",
        after.derived().numbers(),
        numbers(ask.terms.numbers),
        model_words(auction, last),
        goal_words(goal),
        error(&after).unwrap_or_else(|| error_words(goal, last.error)),
    )
}
