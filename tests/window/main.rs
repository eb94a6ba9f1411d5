//! The window driven without a display. One file a subject.

#[path = "../common/window.rs"]
mod driver;
#[path = "../common/full.rs"]
mod full;
#[path = "../common/own_time.rs"]
mod own_time;
#[path = "../common/plain.rs"]
mod plain;
#[path = "../common/root.rs"]
mod root;
#[path = "../common/soft_renderer.rs"]
mod soft_renderer;

mod batch;
mod chart_view;
mod clicks;
mod combine_page;
mod compare;
mod design_pages;
mod dispersion_pages;
mod ends;
mod handling;
mod image_page;
mod import;
mod lessons;
mod lessons_by_hand;
mod many_page;
mod narrow;
mod pages_paper;
mod pages_tradeoff;
mod photograph_page;
mod products_chain_page;
mod products_forming;
mod products_surfaces;
mod readme;
mod relit_page;
mod sizes;
mod touch;
mod ui;
mod ui_race;
