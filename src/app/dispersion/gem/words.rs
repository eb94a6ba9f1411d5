//! What is said of a gem and its film: how light splits in it, what it lacks, how its noise is seen.

use super::GemFilm;
use crate::{
    app::{dispersion::words::listed, pages::GemMemory, state::App, verdicts::Seen},
    color::Observer,
    io::many::capitalised,
    languages::fixed,
    optics::{Light, MOST_LINES, Noise},
};

/// The noise of a picture in words.
pub fn noise_words(noise: &Noise) -> String {
    let delta = noise.delta_e_on_gem.unwrap_or(noise.delta_e_median);
    let (seen, delta) = (Seen::of(delta), fixed(delta, 1));
    match seen {
        Seen::Hardly => tr!(
            "the noise, \u{394}E\u{2080}\u{2080} {delta} in blocks of 8 x 8 pixels, is hard to see",
            delta
        ),
        Seen::SideBySide => tr!(
            "the noise, \u{394}E\u{2080}\u{2080} {delta} in blocks of 8 x 8 pixels, is seen side \
             by side",
            delta
        ),
        Seen::Visible => tr!(
            "the noise, \u{394}E\u{2080}\u{2080} {delta} in blocks of 8 x 8 pixels, is visible",
            delta
        ),
        Seen::Large => tr!(
            "the noise, \u{394}E\u{2080}\u{2080} {delta} in blocks of 8 x 8 pixels, is large",
            delta
        ),
    }
}

/// What the page shows, a sentence.
pub fn sentence(app: &App, memory: &GemMemory, lights: &[Light]) -> String {
    let gem = capitalised(&memory.made_of.in_words(app));
    let figures = memory.made_of.material(app).ok().and_then(|m| m.abbe());
    let fire = figures.map(|figures| fixed(figures.fire, 3));
    let one_colour = |light: &&Light| is_of_one_colour(light);
    let (flat, colourful): (Vec<&Light>, Vec<&Light>) = lights.iter().partition(one_colour);
    let name = |light: &Light| light.name.clone();
    let names = |lights: &[&Light]| {
        let names: Vec<String> = lights.iter().map(|light| name(light)).collect();
        listed(&names)
    };
    match (&colourful[..], &flat[..], fire) {
        ([], flat, Some(fire)) => tr!(
            "{gem} bends violet more than red (n differs by {fire}), but there is no fire \
             under {lights}: a single colour.",
            gem,
            fire,
            lights = names(flat)
        ),
        ([], flat, None) => tr!(
            "{gem}, but there is no fire under {lights}: a single colour.",
            gem,
            lights = names(flat)
        ),
        (colourful, [], Some(fire)) => tr!(
            "{gem} bends violet more than red (n differs by {fire}): it splits {lights} into fire.",
            gem,
            fire,
            lights = names(colourful)
        ),
        (colourful, [], None) => tr!(
            "{gem}: it splits {lights} into fire.",
            gem,
            lights = names(colourful)
        ),
        (colourful, flat, Some(fire)) => tr!(
            "{gem} bends violet more than red (n differs by {fire}): it splits {lights} into \
             fire, but not {others}: a single colour.",
            gem,
            fire,
            lights = names(colourful),
            others = names(flat)
        ),
        (colourful, flat, None) => tr!(
            "{gem}: it splits {lights} into fire, but not {others}: a single colour.",
            gem,
            lights = names(colourful),
            others = names(flat)
        ),
    }
}

/// Most light of a light of one colour that is elsewhere than near its brightest line, and how near,
/// nm.
const ONE_COLOUR: f64 = 0.02;
const NEAR_NM: f64 = 2.0;

/// Whether nearly all that is seen of a light is of one place, as of a sodium lamp.
fn is_of_one_colour(light: &Light) -> bool {
    let y = |light: Option<Light>| light.map_or(0.0, |light| light.white(Observer::default()).y);
    let table = Observer::default().table();
    let lines = || {
        light
            .seen_spikes()
            .map(|line| (line.at_nm, line.weight * table.at(line.at_nm)[1]))
    };
    let brightest = lines().max_by(|a, b| a.1.total_cmp(&b.1));
    let Some((at_nm, _)) = brightest else {
        return false;
    };
    let near = lines().filter(|(nm, _)| (nm - at_nm).abs() < NEAR_NM);
    let [near, all] = [near.map(|l| l.1).sum::<f64>(), lines().map(|l| l.1).sum()];
    let in_lines = y(light.lines_alone()) / y(Some(light.clone()));
    near * in_lines >= (1.0 - ONE_COLOUR) * all
}

/// What of a light is not in the picture as it is, sentences.
pub fn facts_of(film: &GemFilm, light: &Light) -> Vec<String> {
    let mut facts = Vec::new();
    let unseen = light.share_unseen();
    if unseen >= 0.0005 {
        facts.push(tr!(
            "{share} % of the power of {light} lies outside 380 to 780 nm and is not traced.",
            share = fixed(100.0 * unseen, 1),
            light = light.name
        ));
    }
    let missing = film.film.missing_lines(light).len();
    if missing > 0 {
        facts.push(tr!(
            "{n} line of {light} stand in coarse wavelengths until their rays are traced."
                | "{n} lines of {light} stand in coarse wavelengths until their rays are traced."
                    % missing,
            light = light.name
        ));
    }
    let more = light.seen_spikes().count().saturating_sub(MOST_LINES);
    if more > 0 {
        facts.push(tr!(
            "The {most} strongest lines of {light} have rays of their own; {n} other stands in \
             coarse wavelengths."
                | "The {most} strongest lines of {light} have rays of their own; {n} others stand \
                   in coarse wavelengths."
                    % more,
            most = MOST_LINES,
            light = light.name
        ));
    }
    if film.film.studio().absorption().is_floored() {
        facts.push(
            said!(
                "Where the filter lets less than a millionth through, a millionth is reckoned with."
            )
            .into(),
        );
    }
    let cut = film.film.traced().cut;
    if cut > 0 {
        facts.push(tr!("{n} ray was cut at the last of 512 faces."
            | "{n} rays were cut at the last of 512 faces." % cut));
    }
    let material = film.film.studio().material();
    if (380..=780).any(|nm| material.is_extrapolated(f64::from(nm)))
        && let Some([from, to]) = material.published_nm
    {
        facts.push(tr!(
            "The index of {material} was published for {from} to {to} nm; beyond them it is \
             extrapolated.",
            material = crate::languages::translated(&material.name),
            from = fixed(from, 0),
            to = fixed(to, 0)
        ));
    }
    facts
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::app::{
        assert_says,
        dispersion::{Sent, another_light},
    };

    #[test]
    fn a_sodium_lamp_has_one_colour_and_no_fire() {
        let app = App::new();
        let sodium = app.entry("line_tubes/Sodium tube").expect("shipped");
        let mercury = app.entry("line_tubes/Mercury tube").expect("shipped");
        let light = |entry| another_light(&app, entry, Sent::Measured).expect("it shines");
        let memory = GemMemory::default();
        let lights = [light(&mercury), light(&sodium)];
        assert!(is_of_one_colour(&lights[1]) && !is_of_one_colour(&lights[0]));
        let words = sentence(&app, &memory, &lights);
        assert_says(&words, "splits Mercury tube into fire, but not Sodium tube");
        assert_says(&sentence(&app, &memory, &lights[1..]), "no fire");
    }
}
