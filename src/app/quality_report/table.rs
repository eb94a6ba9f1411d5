//! Many lights as a table: a row a light, empty cells where there is no figure.

use std::sync::LazyLock;

use crate::{
    app::{
        cells::{Columns, Table, cell},
        figures::{OF_QUALITY, QualityFigure},
    },
    color::quality::{Figures, Light, POINTS},
};

use super::Sheet;

/// The figures that have columns: all with a key that are of a light whose unit says nothing, but
/// for the one that never has a number.
static COLUMNS: LazyLock<Vec<&QualityFigure>> = LazyLock::new(|| {
    let dark = Figures::of(&Light::of_nm_values(&[0.0; POINTS]), None);
    let filed = OF_QUALITY
        .iter()
        .filter(|row| !["", "tlci"].contains(&row.figure.key));
    filed.filter(|row| (row.applies)(&dark)).collect()
});

/// A light by its name, with its figures and those of its model, if there is one; or the reason
/// for no figures at all.
pub type LightRow<'a> = (&'a str, Result<(&'a Figures, Option<&'a Figures>), String>);

/// A row of a sheet.
pub fn light_row(sheet: &Sheet) -> LightRow<'_> {
    (&sheet.name, Ok((&sheet.measured, Some(&sheet.model))))
}

/// Lights with their figures, and behind them those of their models.
pub fn lights_table<'a>(lights: impl IntoIterator<Item = LightRow<'a>>) -> Table {
    let number = |row: &QualityFigure, figures: Option<&Figures>| {
        let figures = figures.filter(|figures| (row.applies)(figures))?;
        row.value(figures).ok()
    };
    let mut columns =
        Columns::<LightRow<'_>>::default().with("name", |(name, _): &LightRow<'_>| cell(*name));
    for row in &*COLUMNS {
        columns.push(row.figure.key, move |(_, found): &LightRow<'_>| {
            let measured = found.as_ref().ok().map(|(measured, _)| *measured);
            cell(number(row, measured))
        });
    }
    for row in &*COLUMNS {
        let key = format!("model_{}", row.figure.key);
        columns.push(key, move |(_, found): &LightRow<'_>| {
            let model = found.as_ref().ok().and_then(|(_, model)| *model);
            cell(number(row, model))
        });
    }
    columns.push("notes", |(_, found)| {
        cell(
            found
                .as_ref()
                .map_or_else(Clone::clone, |(measured, _)| notes(measured)),
        )
    });
    Table::new("", columns, lights)
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
    fn a_name_is_no_formula_and_a_dark_light_says_why_it_has_no_figure() {
        let figures = Figures::of(&Light::of_nm_values(&[1.0; POINTS]), None);
        let dark = Figures::of(&Light::of_nm_values(&[0.0; POINTS]), None);
        let rows = [
            ("=1+1", Ok((&figures, None))),
            ("a, \"b\"", Ok((&dark, Some(&figures)))),
            ("scans", Err("no figures".to_owned())),
        ];
        let csv = lights_table(rows).csv();
        let lines: Vec<&str> = csv.lines().collect();
        // A formula's first sign is guarded, so that no spreadsheet computes it.
        assert!(lines[1].starts_with("'=1+1,"), "{csv}");
        assert!(lines[2].starts_with("\"a, \"\"b\"\"\",,,"), "{csv}");
        assert!(lines[2].contains("every value is zero"));
        assert!(lines[3].starts_with("scans,,,") && lines[3].ends_with(",no figures"));
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
        let expected = format!("name,{of_light},{},notes", of_model.join(","));
        // Further figures may stand between them.
        let head = lights_table([]).csv();
        let mut columns = head.trim_end().split(',');
        for column in expected.split(',') {
            assert!(columns.any(|found| found == column), "{column} in {head}");
        }
    }
}
