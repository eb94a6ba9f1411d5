//! TUV (Tropospheric Ultraviolet and Visible model) reports with a table of spectral irradiance.

use crate::told::{names, read};

#[test]
fn the_total_comes_first_at_the_middles_of_bands() {
    let text = "\n solar zenith angle =  23.2\n SPECTRAL IRRADIANCE (W m-2 nm-1):\n\n LOWER WVL  UPPER WVL  DIRECT     DIFFUSE DOWN  TOTAL DOWNWELLING\n 280.00     281.00     1E-17  2E-17     3E-17\n 281.00     282.00     1  2     3\n\n rest 1 2\n";
    let reading = read("q.txt", text);
    assert_eq!(reading.format, "TUV report");
    let all = ["q, total downwelling", "q, direct", "q, diffuse down"];
    assert_eq!(names(&reading), all);
    assert_eq!(reading.spectra[0].samples.nm(), [280.5, 281.5]);
    assert_eq!(reading.spectra[0].samples.values(), [3e-17, 3.0]);
    assert_eq!(reading.spectra[0].unit, "W m-2 nm-1");
}
