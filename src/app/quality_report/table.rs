//! Many lights as CSV: a row a light, empty cells where there is no figure.

use std::sync::LazyLock;

use crate::{
    app::cells,
    color::quality::{Figures, Light, POINTS},
};

use super::rows::rows;

/// Keys of the columns behind the name: of all rows that a light has whose unit says nothing, but
/// for the one that never has a number.
static COLUMNS: LazyLock<Vec<&str>> = LazyLock::new(|| {
    let dark = Figures::of(&Light::of_nm_values(&[0.0; POINTS]), None);
    let keys = rows(&dark).into_iter().map(|row| row.key);
    keys.filter(|key| *key != "tlci").collect()
});

/// Keys of a light's colour, which stand before the others.
const PLACES: [&str; 4] = ["x", "y", "u_prime", "v_prime"];

/// What the keys of a model's figures begin with.
const OF_MODEL: &str = "model_";

/// The first line: a light's figures, and behind them those of its model.
pub fn csv_head() -> String {
    let keys = || PLACES.into_iter().chain(COLUMNS.iter().copied());
    let of_model = keys().map(|key| format!("{OF_MODEL}{key}"));
    let all = ["name"].into_iter().chain(keys()).map(str::to_owned);
    cells::line(all.chain(of_model).chain(["notes".to_owned()]))
}

/// The line of a light and its model, if there is one.
pub fn csv_line(name: &str, measured: &Figures, model: Option<&Figures>) -> String {
    let mut line = vec![cells::words(name)];
    line.extend(numbers(Some(measured)));
    line.extend(numbers(model));
    line.push(cells::words(&notes(measured)));
    cells::line(line)
}

/// The line of a reading that has no figures, with the reason.
pub fn csv_line_of_none(name: &str, why: &str) -> String {
    let mut line = vec![cells::words(name)];
    line.extend(numbers(None));
    line.extend(numbers(None));
    line.push(cells::words(why));
    cells::line(line)
}

/// The cells of a light's figures, empty ones where there is none.
fn numbers(figures: Option<&Figures>) -> Vec<String> {
    let Some(figures) = figures else {
        return vec![String::new(); PLACES.len() + COLUMNS.len()];
    };
    let pairs = [&figures.xy[0], &figures.uv].map(|pair| pair.as_ref().ok());
    let places = pairs
        .into_iter()
        .flat_map(|pair| [0, 1].map(|k| cells::number(pair.map(|pair| pair[k]))));
    let rows = rows(figures);
    let others = COLUMNS.iter().map(|column| {
        let row = rows.iter().find(|row| row.key == *column);
        cells::number(row.and_then(|row| row.value.clone().ok()))
    });
    places.chain(others).collect()
}

/// Notes, and the first reason for the whole light where there is none.
fn notes(figures: &Figures) -> String {
    let no_light = figures.xyz.as_ref().err().map(ToString::to_string);
    let all: Vec<String> = no_light.into_iter().chain(figures.notes.clone()).collect();
    all.join("; ")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_line_has_as_many_cells_as_the_head_and_no_formula() {
        let figures = Figures::of(&Light::of_nm_values(&[1.0; POINTS]), None);
        let line = csv_line("=1+1", &figures, None);
        // A formula's first sign is guarded, so that no spreadsheet computes it.
        assert!(line.starts_with("'=1+1,"), "{line}");
        let cells = |line: &str| line.matches(',').count();
        assert_eq!(cells(&line), cells(&csv_head()));
        let with_model = csv_line("E", &figures, Some(&figures));
        assert_eq!(cells(&with_model), cells(&csv_head()));
        let dark = Figures::of(&Light::of_nm_values(&[0.0; POINTS]), None);
        let dark = csv_line("a, \"b\"", &dark, None);
        assert!(dark.starts_with("\"a, \"\"b\"\"\",,,"), "{dark}");
        assert!(dark.contains("every value is zero"));
    }

    #[test]
    fn the_columns_are_those_that_tables_made_with_it_are_read_by() {
        let of_light = "x,y,u_prime,v_prime,cct,duv,dominant_nm,purity,ra,r1,r2,r3,r4,r5,r6,r7,r8,r9,\
                        r10,r11,r12,r13,r14,r15,rf,rg,ssi,ler,sp_ratio,s_cone,m_cone,l_cone,rhodopic,\
                        melanopic_der,ppfd_per_100lx,eppfd_per_100lx,lux,melanopic_edi,ppfd,peak_nm,\
                        centroid_nm,fwhm_nm";
        let of_model: Vec<String> = of_light
            .split(',')
            .map(|key| format!("model_{key}"))
            .collect();
        let expected = format!("name,{of_light},{},notes\n", of_model.join(","));
        assert_eq!(csv_head(), expected);
    }
}
