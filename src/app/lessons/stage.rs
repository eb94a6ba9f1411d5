//! What a step sets: light, surfaces, settings, view, what the light meets, page. A stage begins
//! with a fresh document; what a task shows goes on with what is there.

use serde::{Deserialize, Serialize, de::DeserializeOwned};
use serde_json::{Map, Value};

use super::{
    making::Making,
    names::{PageWord, entry, light},
    parsed::parsed,
};
use crate::app::{
    App, Command,
    design::mix::{FULL, MOST_CHANNELS, Mix, MixChannel},
    document::{Document, MOST_OVERLAYS, Subject},
    library::Library,
    pages::Page,
    photograph::Staged,
    products::{Link, MOST_LINKS, Products},
    recipe::Times,
    workspace::earlier::by_page,
};
use crate::design::mixture::{Source, Spec};

/// What is set.
#[derive(Clone, Debug, Default, PartialEq, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct Stage {
    /// Spectra that are made first, and found by their names.
    pub make: Vec<Making>,
    /// The light, by its name.
    pub light: Option<String>,
    /// The surface or filter that is looked at under the light.
    pub surface: Option<String>,
    /// What is laid over it; an empty list takes all away.
    pub overlays: Option<Vec<String>>,
    /// Knobs of the model, by their names in projects.
    pub settings: Map<String, Value>,
    /// What the plot shows, by the names in projects.
    pub view: Map<String, Value>,
    /// The set of surfaces.
    pub patches: Option<String>,
    /// The surface whose product is drawn, by its number from 1; 0 for none.
    pub patch: Option<usize>,
    /// What the light meets, in its order.
    pub chain: Option<Vec<Met>>,
    /// Channels of the mixing desk, in their order; those that were there go.
    pub desk: Option<Vec<Fader>>,
    /// The light that the own one is compared with.
    pub other_light: Option<String>,
    /// The page, by its word.
    pub page: Option<PageWord>,
    /// The picture on the page `photograph`; without it a person's own stays.
    pub photograph: Option<Staged>,
    /// What the pages remember, by the names in a workspace.
    pub remember: Map<String, Value>,
}

/// A channel of the mixing desk.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Fader {
    /// What it is, as the command line has it: `line:450`, `gauss:540,30`.
    pub channel: String,
    /// Its power, 0 to 100 per cent of the most it can give.
    pub level: f64,
}

impl Fader {
    fn channel(&self) -> Result<MixChannel, String> {
        let spec: Spec = self.channel.parse().map_err(|why| format!("found {why}"))?;
        if matches!(spec.source, Source::Named(_)) || spec.fixed.is_some() {
            return Err(format!(
                "found the channel {}, expected one such as line:450 or gauss:540,30",
                self.channel
            ));
        }
        if !(0.0..=FULL).contains(&self.level) {
            let level = self.level;
            return Err(format!(
                "found the level {level} in desk, expected 0 to 100"
            ));
        }
        Ok(MixChannel {
            level: self.level,
            ..MixChannel::new(spec.source)
        })
    }
}

/// Something that the light meets.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Met {
    pub name: String,
    /// How thick it is, as a multiple of what was measured.
    #[serde(default = "one")]
    pub thickness: f64,
    /// How often it is met in a row.
    #[serde(default = "once")]
    pub times: u32,
}

fn one() -> f64 {
    1.0
}

fn once() -> u32 {
    1
}

/// A value with some of its fields changed, by their names in files, at any depth.
fn changed<T: Serialize + DeserializeOwned>(
    value: &T,
    changes: &Map<String, Value>,
    what: &str,
) -> Result<T, String> {
    let mut whole = serde_json::to_value(value).map_err(|why| why.to_string())?;
    merge(&mut whole, changes, what)?;
    parsed(whole).map_err(|why| format!("{what}: {why}"))
}

fn merge(whole: &mut Value, changes: &Map<String, Value>, what: &str) -> Result<(), String> {
    let Value::Object(fields) = whole else {
        return Err(format!("found fields of {what}, expected a value"));
    };
    for (key, change) in changes {
        let known: Vec<&str> = fields.keys().map(String::as_str).collect();
        let known = known.join(", ");
        let Some(field) = fields.get_mut(key) else {
            return Err(format!("found {key} in {what}, expected one of {known}"));
        };
        match change {
            Value::Object(inner) if field.is_object() => merge(field, inner, key)?,
            other => field.clone_from(other),
        }
    }
    Ok(())
}

/// Refuses values that the program would move to the nearest that can be.
fn within<T: Serialize>(wished: &T, nearest: &T) -> Result<(), String> {
    let [wished, nearest] = [wished, nearest].map(serde_json::to_value);
    let (Ok(Value::Object(wished)), Ok(Value::Object(nearest))) = (wished, nearest) else {
        return Ok(());
    };
    match wished
        .iter()
        .find(|(key, value)| nearest.get(*key) != Some(value))
    {
        Some((key, value)) => Err(format!(
            "found {key} {value}, expected {} as the nearest that can be",
            nearest[key]
        )),
        None => Ok(()),
    }
}

/// Refuses what pages would remember otherwise, at any depth.
fn moved(wished: &Value, nearest: &Value) -> Result<(), String> {
    let (Value::Object(wished), Value::Object(nearest)) = (wished, nearest) else {
        return Ok(());
    };
    for (key, value) in wished {
        match nearest.get(key) {
            Some(near) if near == value => {}
            Some(near) if near.is_object() && value.is_object() => moved(value, near)?,
            near => {
                let near = near.map_or_else(|| "nothing".to_owned(), Value::to_string);
                return Err(format!("found {key} {value} in remember, expected {near}"));
            }
        }
    }
    Ok(())
}

impl Stage {
    /// Sets everything anew: what is not named is as at the first start. One step of undo; the
    /// person's own spectra stay, but those that the lesson `made` before.
    ///
    /// # Errors
    /// What was found and what was expected.
    pub fn set(
        &self,
        app: &mut App,
        page: &mut Page,
        made: &mut Vec<String>,
    ) -> Result<(), String> {
        let now = app.document();
        let mut fresh = Document::about(crate::app::document::first_light(app.bundled()));
        fresh.own.clone_from(&now.own);
        fresh.own.retain(|own| !made.contains(&own.key));
        fresh.images = now.images.clone();
        // The very ones of the library: to set them again is no step.
        for held in fresh.products.entries_mut() {
            if let Some(same) = app.entry(&held.key) {
                *held = same;
            }
        }
        fresh.next_own = now.next_own;
        fresh.pages.image = now.pages.image.clone();
        let mut shown = Page::Spectrum;
        let mut scratch = app.clone();
        scratch.apply(Command::Replace(Box::new(fresh)));
        scratch.stage_photograph(None);
        made.clear();
        self.change_in(&mut scratch, &mut shown, made)?;
        app.apply(Command::Replace(Box::new(scratch.document().clone())));
        app.stage_photograph(scratch.staged_photograph());
        app.end_gesture();
        *page = shown;
        Ok(())
    }

    /// Changes what is named and leaves the rest. One step of undo.
    ///
    /// # Errors
    /// What was found and what was expected.
    pub fn change(
        &self,
        app: &mut App,
        page: &mut Page,
        made: &mut Vec<String>,
    ) -> Result<(), String> {
        let (mut scratch, mut shown) = (app.clone(), *page);
        self.change_in(&mut scratch, &mut shown, made)?;
        app.apply(Command::Replace(Box::new(scratch.document().clone())));
        app.stage_photograph(scratch.staged_photograph());
        app.end_gesture();
        *page = shown;
        Ok(())
    }

    fn change_in(
        &self,
        app: &mut App,
        page: &mut Page,
        made: &mut Vec<String>,
    ) -> Result<(), String> {
        if self.photograph.is_some() {
            app.stage_photograph(self.photograph);
        }
        for making in &self.make {
            made.push(making.make(app)?);
        }
        // Another lamp over a surface that is looked at: the surface is still looked at.
        let of_surface = !app.document().is_about_light();
        if let Some(name) = &self.light {
            app.apply(Command::Show(light(app, name)?));
        }
        if let Some(name) = &self.surface {
            let surface = entry(app, name)?;
            if !surface.kind().is_factor() {
                return Err(format!(
                    "found {name} ({}), expected a surface",
                    surface.kind()
                ));
            }
            app.apply(Command::Show(surface));
        } else if self.light.is_some() {
            app.apply(Command::About(match of_surface {
                true => Subject::Factor,
                false => Subject::Light,
            }));
        }
        if let Some(names) = &self.overlays {
            if names.len() > MOST_OVERLAYS {
                return Err(format!(
                    "found {} overlays, expected at most {MOST_OVERLAYS}",
                    names.len()
                ));
            }
            app.apply(Command::ClearOverlays);
            for name in names {
                let overlay = entry(app, name)?;
                app.apply(Command::ToggleOverlay(overlay));
            }
        }
        let document = app.document();
        let settings = changed(&document.settings, &self.settings, "settings")?;
        within(&settings, &settings.clamped())?;
        let view = changed(&document.view, &self.view, "view")?;
        app.apply(Command::Edit(settings));
        app.apply(Command::View(view));
        if let Some(group) = &self.patches {
            if Library::bundled().group(group).is_none() {
                return Err(format!("found no group {group}, expected one of surfaces"));
            }
            app.apply(Command::PatchSet(group.clone()));
        }
        if let Some(number) = self.patch {
            app.apply(Command::Patch(number.checked_sub(1)));
            if app.document().patch != number.checked_sub(1) {
                let set = &app.document().patch_set;
                return Err(format!(
                    "found the patch {number}, expected the number of one of {set}"
                ));
            }
        }
        self.products(app)?;
        if let Some(faders) = &self.desk {
            if faders.len() > MOST_CHANNELS {
                let count = faders.len();
                return Err(format!(
                    "found {count} channels in desk, expected at most {MOST_CHANNELS}"
                ));
            }
            let channels = faders.iter().map(Fader::channel);
            let mix = Mix {
                channels: channels.collect::<Result<_, _>>()?,
                gels: Vec::new(),
            };
            app.edit_pages(|pages| pages.mix.desk = mix);
        }
        self.keep(app)?;
        if let Some(word) = self.page {
            *page = word.0;
        }
        Ok(())
    }

    /// Sets what pages keep.
    fn keep(&self, app: &mut App) -> Result<(), String> {
        let mut unknown = self.remember.clone();
        let wished = by_page(&mut unknown);
        if let Some((key, value)) = unknown.iter().next() {
            let fields = value.as_object().and_then(|fields| fields.iter().next());
            return Err(match fields {
                Some((field, _)) => format!("found {field} in {key}, expected a field of a page"),
                None => format!("found {key} in remember, expected a page's word"),
            });
        }
        let pages = changed(&app.document().pages, &wished, "remember")?;
        let nearest = serde_json::to_value(pages.clone().in_reach());
        let wished = serde_json::to_value(&pages).map_err(|why| why.to_string())?;
        moved(&wished, &nearest.map_err(|why| why.to_string())?)?;
        app.apply(Command::Page(Box::new(pages)));
        Ok(())
    }

    fn products(&self, app: &mut App) -> Result<(), String> {
        let mut products: Products = app.document().products.clone();
        if let Some(met) = &self.chain {
            let link = |met: &Met| {
                let times = Times {
                    thickness: met.thickness,
                    bounces: met.times,
                };
                entry(app, &met.name).map(|entry| Link::new(entry, times))
            };
            products.chain = met.iter().map(link).collect::<Result<_, _>>()?;
            let nearest = products.clone().clamped().chain;
            if nearest.len() != products.chain.len() {
                return Err(format!(
                    "found {} things in the chain, expected at most {MOST_LINKS}, all of them \
                     reflectances and transmittances",
                    products.chain.len()
                ));
            }
            for (wished, nearest) in products.chain.iter().zip(&nearest) {
                let [wished, nearest] = [wished, nearest].map(Link::times);
                within(&wished, &nearest)?;
            }
        }
        app.apply(Command::Products(products));
        if let Some(name) = &self.other_light {
            let second = light(app, name)?;
            app.apply(Command::Compare(Some(second)));
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::json;

    fn stage(json: Value) -> Stage {
        parsed(json).expect("a stage")
    }

    #[test]
    fn a_surface_is_no_light_of_a_stage() {
        let (mut app, mut page) = (App::new(), Page::Spectrum);
        let stage = stage(json!({"light": "colorchecker_ohta/red"}));
        let refused = stage.set(&mut app, &mut page, &mut Vec::new());
        let why = refused.expect_err("no light");
        assert!(why.contains("expected a light"), "{why}");
        assert!(app.undo_words().is_none(), "nothing was changed");
    }

    #[test]
    fn a_stage_is_one_step_of_undo_and_begins_afresh() {
        let (mut app, mut page) = (App::new(), Page::Spectrum);
        let before = app.document().clone();
        let stage = stage(
            json!({"light": "CIE D65", "settings": {"order": 2, "spikes": false},
            "view": {"residual": true}, "page": "chain", "chain": [{"name": "colorchecker_ohta/red", "times": 2}],
            "remember": {"products": {"narrow": {"centre_nm": 500.0}}}}),
        );
        let set = stage.set(&mut app, &mut page, &mut Vec::new());
        set.expect("it is right");
        let document = app.document();
        assert_eq!(
            (document.light.name(), document.settings.order),
            ("CIE D65", 2)
        );
        assert!(document.view.residual && document.products.chain[0].bounces == 2);
        assert_eq!(
            (page, app.document().pages.narrow.centre_nm),
            (Page::Chain, 500.0)
        );
        app.apply(Command::Undo);
        assert!(*app.document() == before);
        let set = Stage::default().set(&mut app, &mut page, &mut Vec::new());
        set.expect("it is right");
        assert_eq!(page, Page::Spectrum);
    }

    #[test]
    fn what_is_wrong_in_a_stage_is_said_and_nothing_is_changed() {
        let (mut app, mut page) = (App::new(), Page::Spectrum);
        let revision = app.revision();
        for (json, words) in [
            (json!({"light": "FL99"}), "FL99"),
            (
                json!({"settings": {"ordr": 3}}),
                "found ordr in settings, expected one of",
            ),
            (json!({"settings": {"order": "x"}}), "found string"),
            (
                json!({"settings": {"order": 10_000}}),
                "found order 10000, expected 100 as the nearest that can be",
            ),
            (
                json!({"chain": [{"name": "red", "times": 4_000_000_000_u32}]}),
                "found bounces 4000000000, expected 16 as the nearest that can be",
            ),
            (
                json!({"chain": [{"name": "red", "thickness": -5.0}]}),
                "found thickness -5.0, expected",
            ),
            (
                json!({"chain": vec![json!({"name": "red"}); 1000]}),
                "found 1000 things in the chain, expected at most 16",
            ),
            (
                json!({"patch": 100_000_000_000_u64}),
                "found the patch 100000000000",
            ),
            (
                json!({"overlays": vec!["FL2"; 500]}),
                "found 500 overlays, expected at most 100",
            ),
            (
                json!({"page": "nowhere"}),
                "found the page nowhere, expected one of lessons, ",
            ),
            (json!({"surface": "FL2"}), "expected a surface"),
            (
                json!({"remember": {"products": {"narrow": {"width_nm": 5000.0}}}}),
                "found width_nm 5000.0 in remember, expected",
            ),
            (
                json!({"remember": {"products": {"narow": 1}}}),
                "found narow in products",
            ),
        ] {
            let set = parsed::<Stage>(json)
                .and_then(|stage| stage.set(&mut app, &mut page, &mut Vec::new()));
            let why = set.expect_err("it is wrong");
            assert!(why.contains(words), "{why}");
        }
        assert_eq!(app.revision(), revision);
    }

    #[test]
    fn what_a_lesson_made_goes_with_the_next_stage_and_the_own_spectra_stay() {
        let (mut app, mut page) = (App::new(), Page::Spectrum);
        let mix = json!({"make": [{"mix": {"name": "Three lines", "like": "CIE D65",
            "channels": ["line:450", "line:540", "line:610"]}}], "light": "Three lines",
            "overlays": ["CIE D65"]});
        let mut made = Vec::new();
        for _ in 0..2 {
            let set = stage(mix.clone()).set(&mut app, &mut page, &mut made);
            set.expect("it is right");
            assert_eq!((app.document().own.len(), made.len()), (1, 1));
        }
        let scene = super::super::figures::Scene { app: &app, page };
        let told = super::super::figures::figure(&scene, "delta_e_overlay", None);
        assert!(told.expect("known").value.is_some_and(|e| e < 0.1));
    }
}
