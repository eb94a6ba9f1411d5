//! Files made to fill the memory or to take for ever, each read by a process of its own.

use std::fs::{self, File};
use std::io::{BufWriter, Write};
use std::path::{Path, PathBuf};
use std::process::Command as Process;

use exr::prelude::Encoding;
use spectral_explorer::io::read_path;
use zip::CompressionMethod;

use super::{harness, seeds};

/// Tells the child which file to read.
const FILE: &str = "SPECTRAL_EXPLORER_TEST_HOSTILE_FILE";

const HUNDRED_MB: usize = 100_000_000;

/// Makes the bytes of a file.
type Bytes = fn() -> Vec<u8>;

/// What a file holds, and the end of its name.
struct Case {
    /// Its name, which tells what it is.
    name: &'static str,
    /// Its bytes, made when they are needed.
    bytes: Bytes,
    /// What the answer must contain; empty where anything will do.
    said: &'static str,
    /// A file beside it.
    beside: Option<(&'static str, Bytes)>,
}

const fn case(name: &'static str, said: &'static str, bytes: fn() -> Vec<u8>) -> Case {
    Case {
        name,
        bytes,
        said,
        beside: None,
    }
}

/// A piece again and again, up to a size.
fn filled(piece: &str, size: usize) -> Vec<u8> {
    piece.as_bytes().repeat(size / piece.len())
}

fn noise(size: usize) -> Vec<u8> {
    let mut state = 88_172_645_463_325_252_u64;
    let mut bytes = Vec::with_capacity(size + 8);
    while bytes.len() < size {
        state ^= state << 13;
        state ^= state >> 7;
        state ^= state << 17;
        bytes.extend(state.to_le_bytes());
    }
    bytes
}

/// A bomb: 1 GiB of blanks, a thousand times the file's size.
fn bomb(member: &str) -> Vec<u8> {
    let blanks = vec![b' '; 1 << 30];
    harness::zipped(&[(member, &blanks)], CompressionMethod::Deflated)
}

/// The most memory that a file may take, as docs/formats.md has it, and what the program itself does.
pub(crate) fn most_memory(size: usize) -> usize {
    (512 << 20).max(20 * size) + (16 << 20)
}

fn laughs() -> String {
    let mut text = "<?xml version=\"1.0\"?>\n<!DOCTYPE lolz [<!ENTITY l0 \"lol\">\n".to_owned();
    for depth in 1..=9 {
        let inner = format!("&l{};", depth - 1).repeat(10);
        text += &format!("<!ENTITY l{depth} \"{inner}\">\n");
    }
    text + "]>\n<IESTM2714>&l9;</IESTM2714>"
}

/// An archive with one name a thousand times, names that climb, and one of a spectrum.
fn crooked() -> Vec<u8> {
    let mut bytes = harness::zipped(
        &[
            ("../../../../tmp/description.xml", b"<GDTF/>".as_slice()),
            ("/description.xml", b"<GDTF/>"),
            ("description.xml", seeds::GDTF.as_bytes()),
            ("descriptiom.xml", b"<GDTF/>"),
        ],
        CompressionMethod::Stored,
    );
    // The writer takes no double names: the last is made one by hand.
    while let Some(at) = bytes.windows(15).position(|w| w == b"descriptiom.xml") {
        bytes[at..at + 15].copy_from_slice(b"description.xml");
    }
    bytes
}

/// An image whose header speaks of a million times a million pixels.
fn vast_image() -> Vec<u8> {
    let mut bytes =
        crate::open_exr::exr((3, 2), &["T.400,0nm", "T.500,0nm"], Encoding::UNCOMPRESSED);
    let window: Vec<u8> = [0_i32, 0, 2, 1]
        .iter()
        .flat_map(|n| n.to_le_bytes())
        .collect();
    let vast: Vec<u8> = [0_i32, 0, 999_999, 999_999]
        .iter()
        .flat_map(|n| n.to_le_bytes())
        .collect();
    while let Some(at) = bytes.windows(16).position(|w| w == window) {
        bytes[at..at + 16].copy_from_slice(&vast);
    }
    bytes
}

fn jcamp(data: &str) -> Vec<u8> {
    format!(
        "##TITLE= a\n##JCAMP-DX= 4.24\n##DATA TYPE= UV/VIS SPECTRUM\n##XUNITS= NANOMETERS\n\
         ##YUNITS= ABSORBANCE\n##FIRSTX= 400\n##LASTX= 500\n##NPOINTS= 1000000000\n\
         ##XFACTOR= 1\n##YFACTOR= 1\n##XYDATA= (X++(Y..Y))\n{data}\n##END=\n"
    )
    .into_bytes()
}

fn aliases() -> Vec<u8> {
    let mut text = "DATA: &a0\n  - type: tabulated nk\n    data: lol\n".to_owned();
    for depth in 1..=9 {
        let inner = format!("*a{}, ", depth - 1).repeat(10);
        text += &format!("X{depth}: &a{depth} [{inner}]\n");
    }
    text.into_bytes()
}

fn table(size: usize, columns: usize) -> Vec<u8> {
    let mut text = Vec::with_capacity(size + 1000);
    let mut row = 0_u32;
    while text.len() < size {
        write!(text, "{}", 200.0 + 0.001 * f64::from(row)).expect("memory");
        for column in 0..columns {
            write!(text, ",0.{}", (row as usize * 7 + column) % 9973).expect("memory");
        }
        text.push(b'\n');
        row += 1;
    }
    text
}

/// As many lines as are kept above a table, each of a thousand characters.
fn long_header() -> String {
    format!("# {}\n", "Some words ".repeat(91)).repeat(190)
}

const ENVI: &str = "ENVI\nsamples = 1000000000\nlines = 1000000000\nbands = 1000000000\n\
    data type = 4\ninterleave = bsq\nbyte order = 0\nwavelength = {400, 500}\n";

const CASES: &[Case] = &[
    case("empty.csv", "an empty file", Vec::new),
    case("one_byte.csv", "expected", || vec![b'4']),
    case("noise.bin", "binary", || noise(HUNDRED_MB)),
    case("noise.csv", "expected", || {
        // Noise that passes for text: no control characters.
        let mut bytes = noise(HUNDRED_MB / 4);
        bytes
            .iter_mut()
            .filter(|b| **b < 32 || **b == 127)
            .for_each(|b| *b = b' ');
        bytes
    }),
    case("one_line_of_columns.txt", "expected", || {
        filled("1 ", HUNDRED_MB)
    }),
    case("million_columns.txt", "", || {
        let line = "1 ".repeat(1_000_000) + "\n";
        filled(&line, HUNDRED_MB)
    }),
    case("million_spectra.csv", "", || {
        let line = |nm: usize| format!("{nm}{}\n", ",0.5".repeat(1_000_000));
        (380..383).map(line).collect::<String>().into_bytes()
    }),
    case("million_titles.csv", "", || {
        let titles: String = (0..1_000_000).map(|i| format!(",a{i}")).collect();
        let line = |nm: usize| format!("{nm}{}\n", ",0.5".repeat(1_000_000));
        (format!("nm{titles}\n") + &line(380) + &line(381) + &line(382)).into_bytes()
    }),
    case("million_wavelengths_in_a_row.csv", "", || {
        let titles: String = (0..1_000_000)
            .map(|i| format!(",{}", 400.0 + 0.001 * f64::from(i)))
            .collect();
        (format!("name{titles}\na{}\n", ",0.5".repeat(1_000_000))).into_bytes()
    }),
    case("table_of_20_columns.csv", "20 spectra", || {
        table(HUNDRED_MB, 20)
    }),
    case("table_of_1_column.csv", "1 spectra", || {
        table(HUNDRED_MB / 2, 1)
    }),
    case("long_header_over_many_columns.csv", "2000 spectra", || {
        let row = |nm: usize| format!("{nm}{}\n", ",0.5".repeat(2000));
        let titles: String = (0..2000).map(|i| format!(",lamp {i}")).collect();
        let rows = (400..404).map(row).collect::<String>();
        (long_header() + &format!("nm{titles}\n") + &rows).into_bytes()
    }),
    case("long_header_over_many_rows.csv", "3000 spectra", || {
        let rows: String = (0..3000)
            .map(|i| format!("lamp {i},0.1,0.2,0.3,0.2,0.1\n"))
            .collect();
        (long_header() + "name,400,410,420,430,440\n" + &rows).into_bytes()
    }),
    case("long_source_over_many_columns.csv", "2000 spectra", || {
        let row = |nm: usize| format!("{nm}{}\n", ",0.5".repeat(2000));
        let rows = (400..404).map(row).collect::<String>();
        format!("# source: {}\n{rows}", "a book ".repeat(20_000)).into_bytes()
    }),
    case("single_rows_among_comments.txt", "expected", || {
        let comments = "#\n".repeat(200);
        filled(
            &format!("1 2\n{comments}1 2 3\n{comments}"),
            HUNDRED_MB / 10,
        )
    }),
    case("numbers_of_any_size.txt", "", || {
        let lines = (1..200_000).map(|i| {
            format!(
                "{i} {}\n",
                ["NaN", "inf", "1e308", "-1e308", "1e999", "5e-324"][i % 6]
            )
        });
        lines.collect::<String>().into_bytes()
    }),
    case("bands.txt", "", || filled("380nm\t1\n", HUNDRED_MB / 4)),
    case("sekonic.csv", "", || {
        let lines = (0..1_000_000).map(|i| format!("Spectral Data {}[nm],1\n", 380 + i));
        ("Tcp [K],1\n".to_owned() + &lines.collect::<String>()).into_bytes()
    }),
    case("entities.spdx", "with a DTD", || laughs().into_bytes()),
    case("entities.cxf", "with a DTD", || {
        laughs().replace("IESTM2714", "CxF").into_bytes()
    }),
    case("entities.gdtf", "with a DTD", || {
        let text = laughs().replace("IESTM2714", "GDTF");
        harness::zipped(
            &[("description.xml", text.as_bytes())],
            CompressionMethod::Deflated,
        )
    }),
    case("nested.spdx", "expected", || {
        ("<IESTM2714>".to_owned() + &"<a>".repeat(1_000_000)).into_bytes()
    }),
    case("nested_and_closed.spdx", "expected", || {
        let (open, close) = ("<a>".repeat(1_000_000), "</a>".repeat(1_000_000));
        format!("<IESTM2714>{open}{close}</IESTM2714>").into_bytes()
    }),
    case("nested_and_closed.cxf", "expected", || {
        let (open, close) = ("<a>".repeat(1_000_000), "</a>".repeat(1_000_000));
        format!("<CxF>{open}{close}</CxF>").into_bytes()
    }),
    case("nested.gdtf", "expected", || {
        let (open, close) = ("<a>".repeat(1_000_000), "</a>".repeat(1_000_000));
        let text = format!("<GDTF>{open}{close}</GDTF>");
        harness::zipped(
            &[("description.xml", text.as_bytes())],
            CompressionMethod::Deflated,
        )
    }),
    case("crowded.spdx", "attributes", || {
        let attributes: String = (0..1_000_000).map(|i| format!(" a{i}=''")).collect();
        format!("<IESTM2714{attributes}/>").into_bytes()
    }),
    case("siblings.spdx", "expected", || {
        ("<IESTM2714>".to_owned() + &"<a/>".repeat(2_000_000) + "</IESTM2714>").into_bytes()
    }),
    case("objects.cxf", "10 spectra", || {
        let open = "<Object Name='a'>".repeat(100_000);
        let spectrum = "<ReflectanceSpectrum StartWL='400'>1 2</ReflectanceSpectrum>";
        let close = "</Object>".repeat(100_000);
        format!("<CxF>{open}{}{close}</CxF>", spectrum.repeat(10)).into_bytes()
    }),
    case("spectra.cxf", "", || {
        let spectrum = "<ReflectanceSpectrum StartWL='400'>1 2 3 4 5</ReflectanceSpectrum>\n";
        format!("<CxF><Object>{}</Object></CxF>", spectrum.repeat(20_000)).into_bytes()
    }),
    case("emitters.gdtf", "", || {
        let point = "<MeasurementPoint WaveLength='400' Energy='1'/><MeasurementPoint WaveLength='500' Energy='1'/>";
        let one = format!("<Emitter Name='a'><Measurement>{point}</Measurement></Emitter>\n");
        let text = format!("<GDTF>{}</GDTF>", one.repeat(20_000));
        harness::zipped(
            &[("description.xml", text.as_bytes())],
            CompressionMethod::Stored,
        )
    }),
    case("points.spdx", "", || {
        let points = (0..300_000).map(|i| {
            format!(
                "<SpectralData wavelength=\"{}\">1</SpectralData>\n",
                200.0 + 0.01 * f64::from(i)
            )
        });
        format!(
            "<IESTM2714><SpectralDistribution>{}</SpectralDistribution></IESTM2714>",
            points.collect::<String>()
        )
        .into_bytes()
    }),
    case("bomb.gdtf", "unfolds", || bomb("description.xml")),
    case("bomb.procspec", "unfolds", || bomb("ps_0.xml")),
    case("bomb.xlsx", "unfolds", || bomb("xl/worksheets/sheet1.xml")),
    case("bomb_of_texts.xlsx", "unfolds", || {
        let texts = vec![b' '; 600 << 20];
        harness::workbook(b"<worksheet/>", &texts, CompressionMethod::Deflated)
    }),
    case("bomb_of_cells.xlsx", "expected", || {
        let cells = "<c r=\"A1\"><v>1</v></c>".repeat(500_000);
        let sheet = format!("<worksheet><sheetData><row>{cells}</row></sheetData></worksheet>");
        harness::workbook(sheet.as_bytes(), b"", CompressionMethod::Deflated)
    }),
    case("rows_far_away.xlsx", "", || {
        let cells: String = (1..1000)
            .map(|i| {
                format!(
                    "<row r=\"{0}\"><c r=\"XFD{0}\"><v>1</v></c><c r=\"A{0}\"><v>{0}</v></c></row>",
                    i * 1000
                )
            })
            .collect();
        let sheet = format!(
            "<worksheet><dimension ref=\"A1:XFD1048576\"/><sheetData>{cells}</sheetData></worksheet>"
        );
        harness::workbook(sheet.as_bytes(), b"", CompressionMethod::Deflated)
    }),
    case("crooked_names.gdtf", "", crooked),
    case("many_members.gdtf", "members", || {
        let names: Vec<String> = (0..20_000).map(|i| format!("{i}")).collect();
        let mut members: Vec<(&str, &[u8])> = names
            .iter()
            .map(|name| (name.as_str(), b"".as_slice()))
            .collect();
        members.push(("description.xml", b"<GDTF/>"));
        harness::zipped(&members, CompressionMethod::Stored)
    }),
    case("vast.exr", "expected", vast_image),
    Case {
        beside: Some(("vast.sli", || vec![0; 1000])),
        ..case("vast.hdr", "at most 512 MiB", || ENVI.as_bytes().to_vec())
    },
    Case {
        beside: Some(("many.sli", || vec![7; 10_000_000])),
        ..case("many.hdr", "expected", || {
            b"ENVI\nsamples = 2\nlines = 5000000\nbands = 1\ndata type = 1\n\
              file type = ENVI Spectral Library\nwavelength = {500, 600}\n"
                .to_vec()
        })
    },
    Case {
        beside: Some(("cube.img", || vec![7; 25_000_000])),
        ..case("cube.hdr", "1 images", || {
            b"ENVI\nsamples = 5000\nlines = 500\nbands = 10\ndata type = 1\ninterleave = bip\n\
              wavelength = {400,410,420,430,440,450,460,470,480,490}\n"
                .to_vec()
        })
    },
    case("braces.hdr", "expected", || {
        ("ENVI\nwavelength = {".to_owned() + &"1,".repeat(5_000_000)).into_bytes()
    }),
    case("keys.hdr", "expected", || {
        let lines: String = (0..1_000_000).map(|i| format!("key {i} = {i}\n")).collect();
        format!("ENVI\n{lines}").into_bytes()
    }),
    case("again.jdx", "expected", || jcamp("400@J0S999999999")),
    case("again_and_again.jdx", "expected", || {
        jcamp(&"400J0S99999\n".repeat(1000))
    }),
    case("packed_garbage.jdx", "expected", || {
        jcamp(&"@%S9sj".repeat(2_000_000))
    }),
    case("packed_lines.jdx", "", || {
        jcamp(&"400@%%%%%%%%%%%%\n".repeat(500_000))
    }),
    case("blocks.jdx", "expected", || {
        let mut text = "##TITLE= all\n##JCAMP-DX= 5\n##DATA TYPE= LINK\n".to_owned();
        text += &"##TITLE= a\n##DATA TYPE= LINK\n".repeat(200_000);
        text.into_bytes()
    }),
    case("labels.jdx", "expected", || {
        let labels: String = (0..1_000_000).map(|i| format!("##L{i}= 1\n")).collect();
        format!("##TITLE= a\n##JCAMP-DX= 5\n{labels}").into_bytes()
    }),
    case("aliases.yml", "expected", aliases),
    case("aliases_of_text.yml", "expected", || {
        let text = "9 ".repeat(50_000);
        let uses = "  - type: tabulated n\n    data: *a\n".repeat(1000);
        format!("REFERENCES: &a |\n    {text}\nDATA:\n  - type: tabulated n\n    data: 1\n{uses}")
            .into_bytes()
    }),
    case("nested.yml", "expected", || {
        let mut text = "DATA:\n  - type: tabulated n\n    data: ".to_owned();
        text += &"[".repeat(1_000_000);
        text.into_bytes()
    }),
    case("rows.yml", "", || {
        let rows: String = (0..500_000)
            .map(|i| format!("        {} 1.5 0\n", 0.2 + 1e-6 * f64::from(i)))
            .collect();
        format!("DATA:\n  - type: tabulated nk\n    data: |\n{rows}").into_bytes()
    }),
    case("formula_without_end.yml", "", || {
        b"DATA:\n  - type: formula 1\n    wavelength_range: 1e-300 1e300\n    coefficients: 0 1 1\n"
            .to_vec()
    }),
    case("nested.json", "expected", || {
        "[".repeat(100_000).into_bytes()
    }),
    case("nested_spd.json", "expected", || {
        "{\"spd\":".repeat(1_000_000).into_bytes()
    }),
    case("too_large.json", "expected", || {
        b"{\"spd\":{\"400\":1e999,\"500\":1}}".to_vec()
    }),
    case("list.json", "expected", || {
        format!("{{\"spd\":[{}1]}}", "1,".repeat(20_000_000)).into_bytes()
    }),
    case("keys.json", "", || {
        let keys: String = (0..1_000_000)
            .map(|i| format!("\"{}\":1,", 200 + i))
            .collect();
        format!("{{\"spd\":{{{keys}\"9999999\":1}}}}").into_bytes()
    }),
    case("own.json", "", || {
        let list: String = (0..500_000).map(|i| format!("{},", 200 + i)).collect();
        format!(
            "{{\"format\":\"spectral-explorer-spectrum\",\"version\":1,\"kind\":\"light\",\
             \"wavelengths_nm\":[{list}9999999],\"values\":[{}1]}}",
            "1,".repeat(500_000)
        )
        .into_bytes()
    }),
    case("range.json", "10000000 wavelengths", || {
        b"{\"schema_version\":\"1.0.0\",\"spectra\":[{\"id\":\"a\",\"wavelength_axis\":{\"range_nm\":\
          {\"start\":1,\"end\":10000000,\"interval\":1}},\"spectral_data\":{\"values\":[1,2]}}]}"
            .to_vec()
    }),
    case("long_name_of_columns.csv", "", || {
        let row = |nm: usize| format!("{nm}{}\n", ",1".repeat(5_000));
        let name = "x".repeat(300_000);
        let rows: String = (400..405).map(row).collect();
        format!("# name: {name}\n# source: {name}\n{rows}").into_bytes()
    }),
    case("many_short_columns.csv", "20000 spectra", || {
        let row = |nm: usize| format!("{nm}{}\n", ",1".repeat(20_000));
        let rows: String = (400..405).map(row).collect();
        format!("# name: {}\n{rows}", "x".repeat(300_000)).into_bytes()
    }),
    case("many_short_rows.csv", "40000 spectra", || {
        let rows: String = (0..40_000)
            .map(|i| format!("leaf {i},.1,.2,.3,.2,.1\n"))
            .collect();
        format!("name,400,410,420,430,440\n{rows}").into_bytes()
    }),
    case("most_spectra.csv", "99999 spectra", || {
        let titles: String = (400..431).map(|nm| format!(",{nm}")).collect();
        let values = ",1".repeat(31);
        let rows: String = (0..99_999).map(|i| format!("leaf {i}{values}\n")).collect();
        format!("name{titles}\n{rows}").into_bytes()
    }),
    case("zeros.json", "1000 spectra", || {
        let nm: Vec<String> = (0..2201).map(|i| format!("{}", 350 + i)).collect();
        let values = ["0"; 2201].join(",");
        let one = |i| format!("{{\"name\":\"lamp {i}\",\"values\":[{values}]}}");
        let all: Vec<String> = (0..1000).map(one).collect();
        let (nm, all) = (nm.join(","), all.join(","));
        format!("{{\"wavelengths\":[{nm}],\"samples\":[{all}]}}").into_bytes()
    }),
    case("channels.json", "100 channels", || {
        let row = format!("[{}1]", "1,".repeat(60_000));
        let empty: String = (1000..20_000).map(|nm| format!(",\"{nm}\":[]")).collect();
        let main = format!("{{\"400\":{row},\"401\":{row}{empty}}}");
        format!("{{\"spectral_data\":{{\"data\":{{\"main\":{main}}}}}}}").into_bytes()
    }),
    case("long_title.json", "100 spectra", || {
        let row = format!("[{}1]", "1,".repeat(99));
        let main = format!("{{\"400\":{row},\"401\":{row}}}");
        let title = "x".repeat(500_000);
        let data = format!("{{\"data\":{{\"main\":{main}}}}}");
        format!("{{\"header\":{{\"description\":\"{title}\"}},\"spectral_data\":{data}}}")
            .into_bytes()
    }),
    case("long_fixture.gdtf", "3000 spectra", || {
        let point = "<MeasurementPoint WaveLength='400' Energy='1'/><MeasurementPoint WaveLength='500' Energy='1'/>";
        let one = format!("<Emitter Name='a'><Measurement>{point}</Measurement></Emitter>\n");
        let name = "x".repeat(300_000);
        let text = format!(
            "<GDTF><FixtureType Name='{name}'/>{}</GDTF>",
            one.repeat(3_000)
        );
        harness::zipped(
            &[("description.xml", text.as_bytes())],
            CompressionMethod::Stored,
        )
    }),
    case("row_far_away.xlsx", "far larger", || {
        let cells = "<row><c r='A1'><v>400</v></c></row><row><c r='B1'><v>1</v></c></row>\
            <row><c r='A4294967295'><v>500</v></c><c r='B4294967295'><v>2</v></c></row>";
        let sheet = format!("<worksheet><sheetData>{cells}</sheetData></worksheet>");
        harness::workbook(sheet.as_bytes(), b"", CompressionMethod::Stored)
    }),
    case("interval.json", "expected", || {
        b"{\"schema_version\":\"1.0.0\",\"spectra\":[{\"id\":\"a\",\"wavelength_axis\":{\"range_nm\":\
          {\"start\":1e-300,\"end\":1e300,\"interval\":1e-300}},\"spectral_data\":{\"values\":[1,2]}}]}".to_vec()
    }),
    case("coefficients.txt", "", || {
        format!("cs1;cosine;380:780;{};", "1 ".repeat(5_000_000)).into_bytes()
    }),
    case("spikes.txt", "", || {
        format!("cs1;cosine;380:780;1;{}", "400*1 ".repeat(2_000_000)).into_bytes()
    }),
    case("fields.sp", "expected", || {
        let fields: String = (0..500_000).map(|i| format!("SPEC_{} ", 380 + i)).collect();
        format!(
            "CGATS.17\nBEGIN_DATA_FORMAT\n{fields}\nEND_DATA_FORMAT\nBEGIN_DATA\n1 2\nEND_DATA\n"
        )
        .into_bytes()
    }),
    case("sets.sp", "", || {
        let mut text =
            "CGATS.17\nBEGIN_DATA_FORMAT\nSAMPLE_ID nm380 nm390\nEND_DATA_FORMAT\nBEGIN_DATA\n"
                .to_owned();
        text += &"1 2 3\n".repeat(500_000);
        text += "END_DATA\n";
        text.into_bytes()
    }),
    case("tables.sp", "", || {
        "CGATS.17\nBEGIN_DATA_FORMAT\nnm380 nm390\nEND_DATA_FORMAT\nBEGIN_DATA\n2 3\nEND_DATA\n"
            .repeat(50_000)
            .into_bytes()
    }),
    case("bands.sp", "expected", || {
        b"SPECT\nSPECTRAL_BANDS \"999999999\"\nSPECTRAL_START_NM \"380\"\nSPECTRAL_END_NM \"780\"\n\
          BEGIN_DATA_FORMAT\nSPEC_380 SPEC_390\nEND_DATA_FORMAT\nBEGIN_DATA\n1 2\nEND_DATA\n"
            .to_vec()
    }),
    case("steps.txt", "expected", || {
        b"Spectrum from 380.000000 to 730.000000 nm in 999999999 steps\n 0.5, 1.5\n Result is XYZ: 1 2 3\n".to_vec()
    }),
    case("columns.sig", "expected", || {
        format!(
            "/*** Spectra Vista SIG Data ***/\ndata=\n{}",
            "1 ".repeat(5_000_000)
        )
        .into_bytes()
    }),
    case("packed.csv.gz", "expected", || {
        let mut bytes = b"\x1f\x8b\x08\0\0\0\0\0\0\x03".to_vec();
        bytes.extend(noise(1_000_000));
        bytes
    }),
];

/// The child: reads one file and tells what came of it, how long it took and how much memory.
/// Does nothing unless it is told which.
#[test]
fn child_that_reads_one_file() {
    let Some(path) = std::env::var_os(FILE).map(PathBuf::from) else {
        return;
    };
    let before = peak_bytes();
    let ticks = processor_ticks();
    let answer = read_path(&path);
    let peak = peak_bytes();
    let said = match &answer {
        Ok(reading) => format!(
            "{}: {} spectra, {} images, {} composites",
            reading.format,
            reading.spectra.len(),
            reading.images.len(),
            reading.composites.len()
        ),
        Err(why) => why.to_string(),
    };
    let ticks = processor_ticks() - ticks;
    println!("ANSWER\t{before}\t{peak}\t{ticks}\t{said}");
    // What it takes to clear away is of no interest.
    std::process::exit(0);
}

/// The most memory that this process ever had, in bytes.
fn peak_bytes() -> usize {
    let status = fs::read_to_string("/proc/self/status").expect("a system that tells");
    let line = status.lines().find_map(|line| line.strip_prefix("VmHWM:"));
    let kib = line.and_then(|text| text.trim().strip_suffix(" kB"));
    let kib: usize = kib
        .and_then(|text| text.trim().parse().ok())
        .expect("a peak");
    kib << 10
}

/// Hundredths of a second that the processor gave this process.
fn processor_ticks() -> usize {
    let line = fs::read_to_string("/proc/self/stat").expect("a system that tells");
    // The program's name stands in brackets before the numbers.
    let (_, numbers) = line.rsplit_once(')').expect("a name");
    let of_user_and_system = numbers.split_whitespace().skip(11).take(2);
    of_user_and_system
        .map(|ticks| ticks.parse::<usize>().expect("a number"))
        .sum()
}

/// What a child said.
pub(crate) struct Told {
    /// What the processor gave it.
    pub seconds: f64,
    /// Bytes that it took for the file.
    pub memory: usize,
    /// What the file was read as, or why it was refused.
    pub answer: String,
    /// What it wrote besides.
    aside: String,
}

/// Has a child read a file, with a limit that saves the machine.
pub(crate) fn told_of(path: &Path, bytes: usize) -> Result<Told, String> {
    let program = std::env::current_exe().expect("this test's own program");
    let limit_kib = (2_usize << 20) + ((bytes * 40) >> 10);
    let output = Process::new("sh")
        .arg("-c")
        .arg(format!("ulimit -v {limit_kib}; exec \"$0\" \"$@\""))
        .arg(program)
        .args([
            "--exact",
            "large::child_that_reads_one_file",
            "--nocapture",
            "--test-threads=1",
        ])
        .env(FILE, path)
        .output()
        .expect("a child");
    let text = String::from_utf8_lossy(&output.stdout);
    let aside = String::from_utf8_lossy(&output.stderr).trim().to_owned();
    let line = text.lines().find_map(|line| line.split_once("ANSWER\t"));
    let fields: Vec<&str> = line.map_or("", |l| l.1).splitn(4, '\t').collect();
    let [before, peak, ticks, answer] = fields[..] else {
        return Err(format!("no answer: {} {aside}", output.status));
    };
    let number = |text: &str| text.parse::<usize>().expect("a number");
    Ok(Told {
        seconds: number(ticks) as f64 / 100.0,
        memory: number(peak) - number(before),
        answer: answer.to_owned(),
        aside,
    })
}

#[test]
#[cfg(target_os = "linux")]
fn large_and_evil_files_stay_within_time_and_memory() {
    let folder = tempfile::tempdir().expect("a folder");
    let mut wrong = Vec::new();
    let only = std::env::var("SPECTRAL_EXPLORER_HOSTILE_FILE").unwrap_or_default();
    // Seconds of the processor for each MiB, however busy the machine is: the densest files, 40,000
    // spectra in one MiB, take half of it.
    let patience = 3.0;
    println!("file, bytes, ms, peak MiB, times its size, answer");
    for case in CASES.iter().filter(|case| case.name.contains(&only)) {
        let put = |name: &str, bytes: &[u8]| {
            let path = folder.path().join(name);
            let mut file = BufWriter::new(File::create(&path).expect("a file"));
            file.write_all(bytes).expect("room on the disk");
            file.flush().expect("room on the disk");
            path
        };
        let bytes = (case.bytes)();
        let mut size = bytes.len();
        let mut paths = vec![put(case.name, &bytes)];
        drop(bytes);
        if let Some((name, bytes)) = case.beside {
            let bytes = bytes();
            size += bytes.len();
            paths.push(put(name, &bytes));
        }
        let mib = size as f64 / f64::from(1 << 20);
        match told_of(&paths[0], size) {
            Err(why) => wrong.push(format!("{}: {why}", case.name)),
            Ok(told) => {
                println!(
                    "{}, {size}, {:.1}, {:.1}, {:.1}, {}",
                    case.name,
                    told.seconds * 1e3,
                    told.memory as f64 / f64::from(1 << 20),
                    told.memory as f64 / size.max(1) as f64,
                    told.answer
                );
                if told.memory > most_memory(size) {
                    wrong.push(format!(
                        "{}: {} bytes of memory for {size}",
                        case.name, told.memory
                    ));
                }
                if told.seconds > patience * (0.25 + mib) {
                    wrong.push(format!(
                        "{}: {} s for {mib:.2} MiB",
                        case.name, told.seconds
                    ));
                }
                if !told.answer.contains(case.said) {
                    wrong.push(format!("{}: {}", case.name, told.answer));
                }
                if !told.aside.is_empty() {
                    wrong.push(format!("{} wrote: {}", case.name, told.aside));
                }
            }
        }
        for path in paths {
            fs::remove_file(path).expect("a file to remove");
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}
