//! `picture --relight`: a picture of few numbers under another light, as PNG.

use std::{ffi::OsStr, io::Write, path::Path};

use super::{
    arguments::Picture as Options,
    inputs::Inputs,
    picture_input::{WALL, about, is_wall, light_of},
    print, print_json,
    refusal::Refusal,
    target::Target,
    words::extension,
};
use crate::{
    color::{Adaptation, Srgb, Swatch, Xyz},
    io::{png, shown, stream::bytes_of_file},
    pictures::{Between, CompactFile, Illuminant, Operator, Picture, Relit, read_full, relit_into},
    study::Progress,
};

/// Carries the command out.
///
/// # Errors
/// [`Refusal`] for a file that holds no picture of few numbers, and a light that it cannot be seen
/// under.
pub(super) fn run(
    options: &Options,
    light: &OsStr,
    target: &Target,
    out: &mut dyn Write,
    inputs: &mut Inputs,
) -> Result<(), Refusal> {
    if extension(target.path) != "png" {
        return Err(Refusal::Usage(format!(
            "--out: found {}, expected a file that ends in .png",
            shown(target.path)
        )));
    }
    let refused = about(&options.input);
    let new = light_of("--relight", light, inputs)?;
    let known = match &options.light {
        Some(word) => Some(light_of("--light", word, inputs)?),
        None => None,
    };
    let picture = opened(&options.input)?;
    let operator = picture.header.operator().map_err(&refused)?;
    let is_factor = operator.bands().is_factor();
    if is_factor && known.is_some() {
        inputs.note("--light is not used: the picture is of surfaces, which no light lit");
    }
    let known = known.filter(|_| !is_factor);
    let relit = operator
        .relit(&new, known.as_ref(), Between::Bands)
        .map_err(&refused)?;
    say_trust(&operator, &picture, &relit, &new, known.as_ref(), inputs);
    let size = [picture.header.width, picture.header.height];
    let file = png(size, pixels(&picture, &relit).as_flattened());
    let file =
        file.ok_or_else(|| Refusal::File(format!("{}: found no pixels", shown(&options.input))))?;
    target.save(&file)?;
    if options.json {
        let json = serde_json::json!({
            "width": size[0], "height": size[1], "light": relit.light,
            "white": relit.white.to_array(),
        });
        return print_json(out, &json);
    }
    let [width, height] = size;
    print(
        out,
        &format!(
            "Wrote {}, {width} x {height} px, under {}.\n",
            shown(target.path),
            relit.light
        ),
    )
}

/// A picture in the full or the compact form.
fn opened(path: &Path) -> Result<Picture, Refusal> {
    if is_wall(path) {
        return Err(Refusal::File(format!(
            "{WALL}: found the wall of paints, which has every wavelength, expected a picture \
             of few numbers (picture {WALL} --out {WALL}.exr writes one)"
        )));
    }
    let bytes = bytes_of_file(path, u64::MAX - 1).map_err(|(found, expected)| {
        Refusal::File(format!(
            "{}: found {found}, expected {expected}",
            shown(path)
        ))
    })?;
    let picture = if bytes.starts_with(b"\x89PNG") {
        CompactFile::open(bytes).and_then(|file| file.picture(&Progress::default()))
    } else {
        read_full(&bytes)
    };
    picture.map_err(about(path))
}

fn say_trust(
    operator: &Operator,
    picture: &Picture,
    relit: &Relit,
    new: &Illuminant,
    known: Option<&Illuminant>,
    inputs: &mut Inputs,
) {
    let plan = operator.plan();
    let lit = known.and_then(|light| light.on_bands(operator.bands()).ok());
    let is_lit = plan.reference.kind == crate::pictures::ReferenceKind::Light;
    let old = lit.or_else(|| is_lit.then(|| plan.reference.values.clone()));
    let noise = vec![picture.header.noise; operator.bands().len()];
    let trust = operator.trust(relit, new, old.as_deref(), &noise);
    inputs.note(trust.words());
}

/// What a screen shows of every pixel, adapted to the light; black where nothing was measured.
fn pixels(picture: &Picture, relit: &Relit) -> Vec<[u8; 3]> {
    let count = picture.header.width * picture.header.height;
    let mut xyz = vec![0.0_f32; 3 * count];
    relit_into(&picture.planes, count, relit, &mut xyz);
    let shown = |i: usize| {
        let of = |k: usize| f64::from(xyz[k * count + i]);
        let xyz = Xyz::new(of(0), of(1), of(2));
        if xyz.is_finite() {
            Swatch::of_patch(xyz, relit.white, Adaptation::ToLight).rgb8
        } else {
            Srgb([0; 3])
        }
    };
    (0..count).map(|i| shown(i).0).collect()
}
