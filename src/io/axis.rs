//! The unit of a table's wavelength axis: told by a title or the header, else guessed.

use super::units::{WavelengthUnit, names_wavelength};

/// A unit and what told it.
#[derive(Clone, Debug, PartialEq)]
pub struct AxisUnit {
    /// The unit.
    pub unit: WavelengthUnit,
    /// What told it, for the person who may flip it.
    pub because: String,
    /// Whether the file states it.
    pub stated: bool,
}

/// What is known of an axis.
#[derive(Clone, Copy, Debug)]
pub struct Axis<'a> {
    /// Title and unit above it.
    pub title: &'a str,
    /// Lines above the table.
    pub header: &'a [(usize, &'a str)],
    /// Whether its numbers carry "nm".
    pub says_nm: bool,
    /// Whether the file is one of Bruker's `.dpt` tables.
    pub is_dpt: bool,
    /// Smallest and largest number.
    pub range: (f64, f64),
}

/// The unit of an axis. A stated unit that makes nonsense of the numbers (under 1 nm or over
/// 1 mm) is passed over.
pub fn unit(axis: &Axis) -> AxisUnit {
    let told = |unit, because: &str, stated| AxisUnit {
        unit,
        because: because.to_owned(),
        stated,
    };
    let (min, max) = axis.range;
    let makes_sense = |unit: &WavelengthUnit| {
        let (a, b) = (unit.to_nm(min), unit.to_nm(max));
        a.min(b) >= 1.0 && a.max(b) <= 1e6
    };
    if axis.says_nm {
        return told(WavelengthUnit::Nanometre, "the file's own labels", true);
    }
    if let Some(unit) = WavelengthUnit::of_title(axis.title).filter(makes_sense) {
        return told(unit, "the column's title", true);
    }
    let in_header = axis.header.iter().rev().find_map(|(_, line)| {
        let lower = line.trim().to_lowercase();
        let about_axis =
            names_wavelength(&lower) || lower.starts_with("x unit") || lower.starts_with("xunit");
        WavelengthUnit::of_title(&lower).filter(|unit| about_axis && makes_sense(unit))
    });
    if let Some(unit) = in_header {
        return told(unit, "the header", true);
    }
    if axis.is_dpt {
        let because = "Bruker's .dpt tables mostly count wave numbers; flip it if these are nm";
        return told(WavelengthUnit::PerCentimetre, because, false);
    }
    match WavelengthUnit::of_range(min, max) {
        Some(unit) => told(unit, &format!("the range {min} to {max}"), false),
        None => told(
            WavelengthUnit::Nanometre,
            &format!("no unit fits the range {min} to {max} well"),
            false,
        ),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_title_outweighs_the_header_and_the_header_the_range() {
        let header = [(1, "X Units: Wavelength (micrometers)")];
        let mut axis = Axis {
            title: "Wavelength (nm)",
            header: &header,
            says_nm: false,
            is_dpt: false,
            range: (350.0, 2500.0),
        };
        assert_eq!(unit(&axis).unit, WavelengthUnit::Nanometre);
        axis.title = "";
        assert_eq!(
            unit(&axis).unit,
            WavelengthUnit::Nanometre,
            "2500 um is nonsense"
        );
        axis.range = (0.35, 2.5);
        let found = unit(&axis);
        assert_eq!(
            (found.unit, found.stated),
            (WavelengthUnit::Micrometre, true)
        );
        axis.header = &[];
        assert!(!unit(&axis).stated);
    }

    #[test]
    fn brukers_point_tables_count_wave_numbers_unless_they_say_so() {
        let axis = Axis {
            title: "",
            header: &[],
            says_nm: false,
            is_dpt: true,
            range: (800.0, 2500.0),
        };
        assert_eq!(unit(&axis).unit, WavelengthUnit::PerCentimetre);
    }
}
