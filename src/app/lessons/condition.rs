//! When a task is done: figures within bounds, or what is shown.

use serde::Deserialize;
use serde_json::{Map, Value};

use super::{
    figures::{Told, figure, is_known_of},
    names::{PageWord, entry, find},
    scene::Scene,
};
use crate::languages::said;

/// Subject of a condition, under its key in the file.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[serde(
    rename = "figure, light, surface, overlay, chain or page",
    rename_all = "lowercase"
)]
pub enum Wanted {
    /// A figure, by its key, within bounds.
    Figure(String),
    /// This light is shown.
    Light(String),
    /// This surface or filter is shown.
    Surface(String),
    /// This spectrum is laid over it.
    Overlay(String),
    /// The light meets these, in this order.
    Chain(Vec<String>),
    /// This page is shown.
    Page(PageWord),
}

/// One thing that must hold.
#[derive(Clone, Debug, PartialEq, Deserialize)]
pub struct Condition {
    #[serde(flatten)]
    pub wanted: Wanted,
    /// What the figure is of: `model`, or a light; without it what is shown.
    pub of: Option<String>,
    /// More than this.
    pub above: Option<f64>,
    /// Less than this.
    pub below: Option<f64>,
    /// Exactly this.
    pub equals: Option<f64>,
    /// From the first to the second, both allowed.
    pub between: Option<[f64; 2]>,
    /// What a lesson calls its figure.
    pub called: Option<String>,
    #[serde(flatten)]
    rest: Map<String, Value>,
}

/// A figure on its way to what a task wants of it.
#[derive(Clone, Debug, PartialEq)]
pub struct Meter {
    /// The figure, its value and its aim.
    pub words: String,
    /// The part of the way since the step began, 0 to 1.
    pub share: f32,
}

impl Condition {
    /// Its figure, where it is about one.
    fn figure(&self) -> Option<&str> {
        match &self.wanted {
            Wanted::Figure(key) => Some(key),
            _ => None,
        }
    }

    /// Names of the spectra that it wants to be shown.
    fn names(&self) -> &[String] {
        match &self.wanted {
            Wanted::Light(name) | Wanted::Surface(name) | Wanted::Overlay(name) => {
                std::slice::from_ref(name)
            }
            Wanted::Chain(names) => names,
            Wanted::Figure(_) | Wanted::Page(_) => &[],
        }
    }

    pub fn holds(&self, scene: &Scene<'_>) -> bool {
        let document = scene.app.document();
        let is = |shown: &crate::app::Entry, name: &str| {
            entry(scene.app, name).is_ok_and(|wanted| wanted.key == shown.key)
        };
        match &self.wanted {
            Wanted::Figure(key) => {
                let told = figure(scene, key, self.of.as_deref()).ok();
                let value = told.and_then(|told| told.value);
                value.is_some_and(|value| self.is_within(value))
            }
            Wanted::Light(name) => is(&document.light, name),
            Wanted::Surface(name) => {
                !document.is_about_light() && is(document.subject_entry(), name)
            }
            Wanted::Overlay(name) => document.laid_over().any(|overlay| is(overlay, name)),
            Wanted::Chain(names) => {
                let chain = &document.products.chain;
                let mut pairs = chain.iter().zip(names);
                chain.len() == names.len() && pairs.all(|(link, name)| is(&link.entry, name))
            }
            Wanted::Page(page) => page.0 == scene.page,
        }
    }

    /// How far its figure is from its bounds, 0 within them; `None` where it is about none, or has
    /// no value.
    pub fn distance(&self, scene: &Scene<'_>) -> Option<f64> {
        let told = figure(scene, self.figure()?, self.of.as_deref()).ok()?;
        let value = told.value?;
        let between = self.between.unwrap_or([value; 2]);
        let least = [self.above, self.equals, Some(between[0])];
        let most = [self.below, self.equals, Some(between[1])];
        let under = least.into_iter().flatten().map(|least| least - value);
        let over = most.into_iter().flatten().map(|most| value - most);
        Some(under.chain(over).fold(0.0, f64::max))
    }

    /// Its figure on the way from a distance at the beginning; `None` where it is about none.
    pub fn meter(&self, scene: &Scene<'_>, begun: f64) -> Option<Meter> {
        let told = figure(scene, self.figure()?, self.of.as_deref()).ok()?;
        let left = self.distance(scene)?;
        let title = self.called.as_deref().unwrap_or(said(told.title));
        Some(Meter {
            words: tr!(
                "{title}: {value} (aim: {aim})",
                title,
                value = told.words,
                aim = self.bounds(&told)
            ),
            share: match (told.value.is_some_and(|v| self.is_within(v)), begun > 0.0) {
                (true, _) => 1.0,
                // At a bound that is to be passed nothing is left, and it is not met yet.
                (false, true) => (1.0 - left / begun).clamp(0.0, 0.95) as f32,
                (false, false) => 0.0,
            },
        })
    }

    /// What is there and what was wanted instead, in words.
    pub fn unmet(&self, scene: &Scene<'_>) -> String {
        if let Some(key) = self.figure() {
            return match figure(scene, key, self.of.as_deref()) {
                Ok(told) => tr!(
                    "found {title} ({key}) {value}, expected {aim}",
                    title = said(told.title),
                    key,
                    value = told.words,
                    aim = self.bounds(&told)
                ),
                Err(why) => why,
            };
        }
        let names = match &self.wanted {
            Wanted::Page(page) => page.0.word().to_owned(),
            _ => self.names().join(", "),
        };
        tr!("found other things shown, expected {names}", names)
    }

    /// The bounds of its figure in words.
    fn bounds(&self, told: &Told) -> String {
        let at = |value: Option<f64>| value.map(|value| told.bound(value));
        let between = self.between.map(|[least, most]| {
            let [least, most] = [least, most].map(|value| told.bound(value));
            tr!("{least} to {most}", least, most)
        });
        let bounds = [
            at(self.above).map(|least| tr!("above {least}", least)),
            at(self.below).map(|most| tr!("below {most}", most)),
            at(self.equals),
            between,
        ];
        let bounds = bounds.into_iter().flatten();
        let both = bounds.reduce(|one, other| tr!("{one} and {other}", one, other));
        both.unwrap_or_default()
    }

    fn is_within(&self, value: f64) -> bool {
        self.above.is_none_or(|least| value > least)
            && self.below.is_none_or(|most| value < most)
            && self.equals.is_none_or(|wanted| value == wanted)
            && self
                .between
                .is_none_or(|[least, most]| (least..=most).contains(&value))
    }

    /// What is wrong with it; `made` are the names of spectra that the lesson makes.
    ///
    /// # Errors
    /// What was found and what was expected.
    pub fn fault(&self, made: &[&str]) -> Result<(), String> {
        if let Some(key) = self.rest.keys().next() {
            return Err(format!(
                "found the field `{key}` in until, expected one of figure, light, surface, \
                 overlay, chain and page, and with figure of, above, below, equals, between and \
                 called"
            ));
        }
        let bounds = [self.above, self.below, self.equals];
        let has_bounds = bounds.iter().any(Option::is_some) || self.between.is_some();
        if has_bounds != self.figure().is_some() {
            return Err(
                "found until without bounds of its figure, expected above, below, equals \
                        or between beside a figure alone"
                    .to_owned(),
            );
        }
        if let Some(key) = self.figure() {
            is_known_of(key, self.of.as_deref(), made)?;
        }
        self.names().iter().try_for_each(|name| find(name, made))
    }
}
