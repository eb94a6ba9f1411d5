//! When a task is done: figures within bounds, or what is shown.

use serde::Deserialize;

use super::{
    figures::{Scene, Told, figure, is_known_of},
    names::{entry, find},
};
use crate::app::pages::Page;

/// One thing that must hold. Exactly one of `figure`, `light`, `surface`, `overlay`, `chain`
/// and `page` says what it is about.
#[derive(Clone, Debug, Default, PartialEq, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct Condition {
    /// A figure, by its key.
    pub figure: Option<String>,
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
    /// This light is shown.
    pub light: Option<String>,
    /// This surface or filter is shown.
    pub surface: Option<String>,
    /// This spectrum is laid over it.
    pub overlay: Option<String>,
    /// The light meets these, in this order.
    pub chain: Option<Vec<String>>,
    /// This page is shown.
    pub page: Option<String>,
    /// What a lesson calls its figure.
    pub called: Option<String>,
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
    pub fn holds(&self, scene: &Scene<'_>) -> bool {
        let document = scene.app.document();
        let is = |shown: &crate::app::Entry, name: &str| {
            entry(scene.app, name).is_ok_and(|wanted| wanted.key == shown.key)
        };
        if let Some(key) = &self.figure {
            let told = figure(scene, key, self.of.as_deref());
            return told
                .ok()
                .and_then(|told| told.value)
                .is_some_and(|v| self.is_within(v));
        }
        if let Some(name) = &self.light {
            return is(&document.light, name);
        }
        if let Some(name) = &self.surface {
            return !document.is_about_light() && is(document.subject_entry(), name);
        }
        if let Some(name) = &self.overlay {
            return document.laid_over().any(|overlay| is(overlay, name));
        }
        if let Some(names) = &self.chain {
            let chain = &document.products.chain;
            let mut pairs = chain.iter().zip(names);
            return chain.len() == names.len() && pairs.all(|(link, name)| is(&link.entry, name));
        }
        let page = self.page.as_deref().and_then(Page::of_word);
        page == Some(scene.page)
    }

    /// How far its figure is from its bounds, 0 within them; `None` where it is about none, or has
    /// no value.
    pub fn distance(&self, scene: &Scene<'_>) -> Option<f64> {
        let told = figure(scene, self.figure.as_ref()?, self.of.as_deref()).ok()?;
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
        let told = figure(scene, self.figure.as_ref()?, self.of.as_deref()).ok()?;
        let left = self.distance(scene)?;
        let title = self.called.as_deref().unwrap_or(told.title);
        Some(Meter {
            words: format!("{title}: {} (aim: {})", told.words, self.bounds(&told)),
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
        if let Some(key) = &self.figure {
            return match figure(scene, key, self.of.as_deref()) {
                Ok(told) => format!(
                    "found {} ({key}) {}, expected {}",
                    told.title,
                    told.words,
                    self.bounds(&told)
                ),
                Err(why) => why,
            };
        }
        let names = [&self.light, &self.surface, &self.overlay, &self.page];
        let names = names
            .into_iter()
            .flatten()
            .chain(self.chain.iter().flatten());
        let names: Vec<&str> = names.map(String::as_str).collect();
        format!("found other things shown, expected {}", names.join(", "))
    }

    /// The bounds of its figure in words.
    fn bounds(&self, told: &Told) -> String {
        let at = |value: Option<f64>, word: &str| {
            value.map(|value| format!("{word}{}", told.bound(value)))
        };
        let between = self
            .between
            .map(|[least, most]| format!("{} to {}", told.bound(least), told.bound(most)));
        let bounds = [
            at(self.above, "above "),
            at(self.below, "below "),
            at(self.equals, ""),
            between,
        ];
        let bounds: Vec<String> = bounds.into_iter().flatten().collect();
        bounds.join(" and ")
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
        let names = [&self.light, &self.surface, &self.overlay];
        let count = names.into_iter().flatten().count()
            + usize::from(self.figure.is_some())
            + usize::from(self.chain.is_some())
            + usize::from(self.page.is_some());
        if count != 1 {
            return Err(format!(
                "found {count} of figure, light, surface, overlay, chain and page in until, expected one"
            ));
        }
        let has_bounds = self.above.is_some()
            || self.below.is_some()
            || self.equals.is_some()
            || self.between.is_some();
        if has_bounds != self.figure.is_some() {
            return Err(
                "found until without bounds of its figure, expected above, below, equals \
                        or between beside a figure alone"
                    .to_owned(),
            );
        }
        if let Some(key) = &self.figure {
            is_known_of(key, self.of.as_deref(), made)?;
        }
        let chain = self.chain.iter().flatten();
        for name in names.into_iter().flatten().chain(chain) {
            find(name, made)?;
        }
        match self.page.as_deref().map(|word| (word, Page::of_word(word))) {
            Some((word, None)) => Err(format!("found the page {word}, expected a page's word")),
            _ => Ok(()),
        }
    }
}
