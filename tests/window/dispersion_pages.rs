//! The pages Prism, Rainbow and Gem in the real window, driven without a display.

use crate::driver::{Ui, app, at_rest, no_files, words};
use eframe::egui::{Role, vec2};
use egui_kittest::kittest::Queryable as _;
use spectral_explorer::{
    app::{
        App,
        dispersion::Sent,
        pages::Page,
        pages::{GemColour, Handle, PrismMemory},
        workspace::Preferences,
    },
    color::Adaptation,
    ui::{Window, pages::gem_view::names},
};

fn page(page: Page) -> Ui {
    let preferences = Preferences {
        page,
        greeted: true,
        ..Preferences::default()
    };
    let mut app = App::new();
    app.pages_follow(|pages| (pages.gem.size, pages.gem.rays) = (240, 8));
    let mut ui = at_rest(Window::new(app, preferences, no_files(), None));
    settle(&mut ui);
    ui
}

fn settle(ui: &mut Ui) {
    for _ in 0..6 {
        ui.step();
        ui.state_mut().0.studies.finish();
    }
    ui.step();
}

fn drag(ui: &mut Ui, name: &str, by: [f32; 2]) {
    let from = ui.get_by_label(name).rect().center();
    let to = from + vec2(by[0], by[1]);
    ui.hover_at(from);
    ui.step();
    ui.drag_at(from);
    ui.step();
    ui.hover_at(to);
    ui.step();
    ui.drop_at(to);
    settle(ui);
}

fn prism(ui: &Ui) -> PrismMemory {
    ui.state().0.app.document().pages.prism.clone()
}

#[test]
fn the_handles_of_the_bench_are_dragged() {
    let mut ui = page(Page::Prism);
    let usual = PrismMemory::default();
    for handle in Handle::ALL {
        let name = format!("{}, drawn", handle.title());
        // Outwards: the corner, at the left of the apex, against the clock; the jaw to the left.
        let by = match handle {
            Handle::Apex => [0.0, 12.0],
            Handle::Slit => [-9.0, 0.0],
        };
        drag(&mut ui, &name, by);
    }
    let found = prism(&ui);
    assert!(found.apex_deg > usual.apex_deg, "{found:?}");
    assert!(found.slit_mm > usual.slit_mm, "{found:?}");
    assert!(found.at_minimum, "no handle turns the prism");
    drag(&mut ui, "Drawing of the prism and the light", [30.0, 0.0]);
    assert!(!prism(&ui).at_minimum);
}

#[test]
fn the_light_is_measured_until_a_switch_sends_the_model_whose_order_then_counts() {
    for at in [Page::Prism, Page::Rainbow, Page::Gem] {
        let mut ui = page(at);
        let has = |ui: &Ui, name: &str| ui.query_by_role_and_label(Role::Slider, name).is_some();
        let sent = |ui: &Ui| {
            let memory = &ui.state().0.app.document().pages;
            match at {
                Page::Prism => memory.prism.sent,
                Page::Rainbow => memory.rainbow.sent,
                _ => memory.gem.sent,
            }
        };
        assert_eq!(sent(&ui), Sent::Measured, "{at:?}");
        assert!(!has(&ui, "Waves"), "{at:?}: it decides nothing");
        assert!(has(&ui, "Lines above"), "{at:?}");
        ui.get_by_role_and_label(Role::CheckBox, "as the model has it")
            .click();
        settle(&mut ui);
        assert_eq!(sent(&ui), Sent::Model, "{at:?}");
        assert!(has(&ui, "Waves"), "{at:?}");
    }
}

#[test]
fn a_gem_is_coloured_and_says_how_it_is_seen() {
    let mut ui = page(Page::Gem);
    let said = |ui: &Ui, part: &str| words(ui).join("\n").contains(part);
    assert!(said(&ui, Adaptation::ToLight.words()));
    ui.get_by_label("Colour and picture").scroll_to_me();
    settle(&mut ui);
    ui.get_by_label("Colour and picture").click();
    settle(&mut ui);
    // What a fold shows may lie below the edge.
    ui.get_by_role_and_label(Role::ComboBox, names::COLOUR)
        .scroll_to_me();
    settle(&mut ui);
    ui.get_by_role_and_label(Role::ComboBox, names::COLOUR)
        .click();
    settle(&mut ui);
    ui.get_by_label(GemColour::Filter.title()).click();
    settle(&mut ui);
    let memory = &ui.state().0.app.document().pages.gem;
    assert_eq!(memory.colour, GemColour::Filter);
    ui.get_by_label(names::SEEN).scroll_to_me();
    settle(&mut ui);
    ui.get_by_label(names::SEEN).click();
    settle(&mut ui);
    ui.get_by_label(Adaptation::None.words()).click();
    settle(&mut ui);
    assert!(!app(&ui).document().view.adapt_patches);
    assert!(said(&ui, Adaptation::None.words()) && !said(&ui, Adaptation::ToLight.words()));
}

#[test]
fn the_rays_of_the_drop_are_dragged() {
    let mut ui = page(Page::Rainbow);
    let impact = |ui: &Ui| ui.state().0.app.document().pages.rainbow.impact;
    let before = impact(&ui);
    drag(&mut ui, "A drop with rays of the light", [0.0, 20.0]);
    assert!(impact(&ui) < before, "{} {before}", impact(&ui));
    let told = format!("Met at {:.2} of its radius", impact(&ui));
    assert!(words(&ui).join("\n").contains(&told), "{told}");
}
