//! Miniature files of our own, a few for every reader, and words that its files are made of: what
//! mutations and the fuzzer start from.

use exr::prelude::Encoding;
use zip::CompressionMethod;

use super::harness::{BESIDE, workbook, zipped};
use super::open_exr::exr;

/// What one reader is tried with.
pub(crate) struct Seeds {
    /// The reader's name in the list of formats.
    pub format: &'static str,
    /// Its module, which names its seeds.
    pub module: &'static str,
    /// Small files.
    pub files: Vec<Vec<u8>>,
    /// Words of the format.
    pub words: &'static [&'static str],
}

/// A header and the data beside it.
fn beside(first: &str, second: &[u8]) -> Vec<u8> {
    [first.as_bytes(), BESIDE, second].concat()
}

fn texts(texts: &[&str]) -> Vec<Vec<u8>> {
    texts.iter().map(|text| text.as_bytes().to_vec()).collect()
}

/// "380<between>0.5<end>381..." of a few rows.
fn rows(first: f64, step: f64, count: usize, between: &str, end: &str) -> String {
    (0..count)
        .map(|i| {
            let nm = first + step * i as f64;
            format!("{nm}{between}{}{end}", 0.25 * ((i * 7) % 11) as f64)
        })
        .collect()
}

pub(crate) const GDTF: &str = "<?xml version=\"1.0\"?>\n<GDTF DataVersion=\"1.1\">\n\
    <FixtureType Name=\"Spot\">\n<Wheels><Wheel><Slot Name=\"Warm\" Filter=\"CTO\"/></Wheel></Wheels>\n\
    <Emitters><Emitter Name=\"Red\">\n<Measurement Physical=\"100\">\n\
    <MeasurementPoint WaveLength=\"600\" Energy=\"0.5\"/>\n\
    <MeasurementPoint WaveLength=\"610.5\" Energy=\"1\"/></Measurement></Emitter>\n\
    <Emitter Name=\"Blue\"/></Emitters>\n<Filters><Filter Name=\"CTO\"><Measurement Physical=\"1\">\n\
    <MeasurementPoint WaveLength=\"500\" Energy=\"20\"/>\n\
    <MeasurementPoint WaveLength=\"600\" Energy=\"80\"/></Measurement></Filter></Filters>\n\
    </FixtureType></GDTF>";

pub(crate) const PROCSPEC: &str = "<com.oceanoptics.omnidriver.spectra.OmniSpectrum>\n<sourceSpectra>\
    <pixelValues><double>10</double><double>20</double></pixelValues>\n<channelWavelengths>\
    <double>400.1</double><double>400.5</double></channelWavelengths></sourceSpectra>\n\
    <processedPixels><double>50.5</double><double>60.5</double></processedPixels>\n\
    </com.oceanoptics.omnidriver.spectra.OmniSpectrum>";

const ENVI_LIBRARY: &str = "ENVI\n; a comment\nsamples = 4\nlines = 2\nbands = 1\n\
    header offset = 2\nfile type = ENVI Spectral Library\ndata type = 2\ninterleave = bsq\n\
    byte order = 1\nwavelength units = Micrometers\nreflectance scale factor = 1000\n\
    bbl = {1, 1, 0, 1}\nspectra names = {\n red brick,\n tile}\nwavelength = {0.4, 0.5,\n 0.6, 0.7}\n";

fn envi() -> Vec<Vec<u8>> {
    let cube = |interleave: &str, data_type: usize| {
        format!(
            "ENVI\nsamples = 3\nlines = 2\nbands = 3\ndata type = {data_type}\n\
             interleave = {interleave}\nbyte order = 0\ndata ignore value = -1e34\n\
             wavelength = {{700, 600, 500}}\n"
        )
    };
    let floats: Vec<u8> = (0..18_u8)
        .flat_map(|i| (f32::from(i) / 20.0).to_le_bytes())
        .collect();
    vec![
        beside(ENVI_LIBRARY, &[7; 18]),
        beside(&cube("bip", 4), &floats),
        beside(&cube("bil", 1), &[3; 18]),
        beside(&cube("bsq", 5), &[0x3f; 144]),
        ENVI_LIBRARY.as_bytes().to_vec(),
    ]
}

const SPDX: &str = "<?xml version=\"1.0\"?>\n<x:IESTM2714 xmlns:x=\"http://www.ies.org/iestm2714\">\n\
    <x:Header><x:Description>A &amp; B</x:Description><x:ReportDate>Unknown</x:ReportDate>\
    </x:Header>\n<x:SpectralDistribution><x:SpectralQuantity>irradiance</x:SpectralQuantity>\
    <x:BandwidthFWHM>Unknown</x:BandwidthFWHM>\n\
    <x:SpectralData wavelength=\"400.5\">0.47</x:SpectralData>\n\
    <x:SpectralData wavelength=\"410\"> 0.51 </x:SpectralData>\n\
    </x:SpectralDistribution></x:IESTM2714>";

const CXF: &str = "<?xml version=\"1.0\"?>\n\
    <cc:CxF xmlns:cc=\"http://colorexchangeformat.com/CxF3-core\">\n\
    <cc:Resources><cc:ObjectCollection>\n<cc:Object Name=\"Sky\" Id=\"c1\"><cc:ColorValues>\n\
    <cc:ReflectanceSpectrum ColorSpecification=\"CS1\" StartWL=\"400\">0.1 0.2\n0.3\
    </cc:ReflectanceSpectrum>\n</cc:ColorValues></cc:Object>\n<cc:Object Name=\"Lamp\">\
    <cc:ColorValues>\n<cc:EmissiveSpectrum ColorSpecification=\"CS2\">5 6</cc:EmissiveSpectrum>\n\
    </cc:ColorValues></cc:Object></cc:ObjectCollection>\n<cc:ColorSpecificationCollection>\n\
    <cc:ColorSpecification Id=\"CS2\"><cc:MeasurementSpec>\
    <cc:WavelengthRange StartWL=\"380\" Increment=\"5\"/>\n</cc:MeasurementSpec>\
    </cc:ColorSpecification></cc:ColorSpecificationCollection></cc:Resources></cc:CxF>";

fn jcamp() -> Vec<Vec<u8>> {
    let file = |head: &str, data: &str| {
        format!(
            "##TITLE= a lamp\n##JCAMP-DX= 4.24 $$ by hand\n##DATA TYPE= UV/VIS SPECTRUM\n\
             ##XUNITS= NANOMETERS\n##YUNITS= ABSORBANCE\n{head}\n{data}\n##END=\n"
        )
    };
    let head = "##FIRSTX= 400\n##LASTX= 414\n##NPOINTS= 8\n##XFACTOR= 1\n##YFACTOR= 1";
    let packed = |data: &str| file(head, &format!("##XYDATA= (X++(Y..Y))\n{data}"));
    let inner = packed("400 0 10 10 10 28\n410 -3 3 3");
    let wave_numbers = file(
        "##FIRSTX= 20000\n##LASTX= 25000\n##NPOINTS= 3",
        "##XYDATA= (X++(Y..Y))\n20000 1 2 3",
    );
    texts(&[
        &inner,
        &packed("400@A0UB8\n410cCT"),
        &packed("400@J0%TJ8\n408B8l1O%\n414C"),
        &file(
            "##NPOINTS= 3",
            "##XYPOINTS= (XY..XY)\n400.5 0.1; 401 0.2; 401.5 0.3",
        ),
        &format!(
            "##TITLE= all\n##DATA TYPE= LINK\n##BLOCKS= 2\n{inner}{}##END=\n",
            inner.replace("ABSORBANCE", "%T")
        ),
        &wave_numbers.replace("NANOMETERS", "1/CM"),
    ])
}

fn yaml() -> Vec<Vec<u8>> {
    let mut files = texts(&[
        "REFERENCES: |\n    A. Author.\nCOMMENTS: |\n    Warm\nDATA:\n  - type: tabulated nk\n    \
         data: |\n        0.5 1.5 0\n        0.6 1.0 2.0\n",
        "DATA:\n  - type: tabulated n\n    data: |\n        0.5 1.5\n        0.6 1.0\n  \
         - type: tabulated k\n    data: |\n        0.5 0\n        0.7 1\n",
    ]);
    for formula in 1..=9 {
        // The eighth is of metals' salts, whose index is only real where the ratio is below 1.
        let coefficients = match formula {
            8 => "0.5 0.1 0.01 -0.01",
            _ => "0 1.04 0.077 0.23 0.14 1.01 10.2 2 1 3 0.5",
        };
        files.push(
            format!(
                "DATA:\n  - type: formula {formula}\n    wavelength_range: 0.4 0.7\n    \
                 coefficients: {coefficients}\n"
            )
            .into_bytes(),
        );
    }
    files
}

const XML_WORDS: &[&str] = &[
    "<?xml",
    "<!DOCTYPE",
    "<!ENTITY",
    "<![CDATA[",
    "]]>",
    "&#x0;",
    "xmlns:",
];
const NUMBERS: &[&str] = &[
    "NaN", "inf", "-inf", "1e308", "-1e308", "1e999", "5e-324", "-0",
];

/// What every reader is tried with, in the order of the list of formats.
#[expect(clippy::too_many_lines, reason = "a table: one row a reader")]
pub(crate) fn all() -> Vec<Seeds> {
    let seeds = |format, module, files, words| Seeds {
        format,
        module,
        files,
        words,
    };
    let stored = CompressionMethod::Stored;
    let packed = CompressionMethod::Deflated;
    let zips = |name: &str, text: &str| {
        vec![
            text.as_bytes().to_vec(),
            zipped(&[(name, text.as_bytes())], stored),
            zipped(&[("x", b"y"), (name, text.as_bytes())], packed),
        ]
    };
    let cells = "<worksheet xmlns=\"http://schemas.openxmlformats.org/spreadsheetml/2006/main\">\
        <sheetData><row r=\"1\"><c r=\"A1\" t=\"inlineStr\"><is><t>nm</t></is></c>\
        <c r=\"B1\" t=\"inlineStr\"><is><t>% T</t></is></c></row>\
        <row r=\"2\"><c r=\"A2\"><v>500</v></c><c r=\"B2\"><v>2.5</v></c></row>\
        <row r=\"3\"><c r=\"A3\"><v>600.5</v></c><c r=\"B3\"><v>80</v></c></row></sheetData></worksheet>";
    let shared = "<sst><si><t>Wavelength</t></si><si><r><t>% </t></r><r><t>R</t></r></si></sst>";
    let by_number = cells.replace("t=\"inlineStr\"><is><t>nm</t></is>", "t=\"s\"><v>0</v>");
    let li180 = "Model Name\tLI-180\nPPFD\t5.5\nR:B\t1.48\nIRR\t0.03\n380nm\t1\n390nm\t1.5\n\
        400nm\t2\nCCT\t5465.0\nu'\t0.2037\n";
    let uprtek = "Model Name\tMK350\nMemo\t\nLUX\t12.5\nCCT\t3000.0\nx\t0.44\nCRI\t92.0\nR9\t50.5\n\
        IRR\t0.03\n380nm\t1.0\n390nm\t2.0\n400nm\t-0.5\n";
    let sekonic = format!(
        "Date Saved,1/1/2020\nTitle,Desk 2°\n\nTcp [K],3262\nIlluminance [lx],30.1\nCRI Ra,87.5\n\n{}\n{}",
        rows(380.0, 5.0, 5, "[nm],", "\nSpectral Data ").replacen("380", "Spectral Data 380", 1),
        rows(380.0, 1.0, 9, "[nm],", "\nSpectral Data ").replacen("380", "Spectral Data 380", 1),
    );
    let li1800 = "\"FILE:FL2\"\n\"REM: TLD 36W       (QNTM)\"\n\"LIMS: 300- 302NM\"\n\"INT:  1NM\"\n\
        \"MAX:  301NM  7.5E-01\"\n 300  1.5E-04\n 301  7.5E-01\n 302 -1E-04\n";
    let svc = format!(
        "/*** Spectra Vista SIG Data ***/\nname= leaf.sig\nunits= Radiance, Radiance\ndata= \n{}",
        rows(400.0, 1.5, 8, "  100.0  10.0  ", "\n")
    );
    let usgs = " splib07a Record=7: Alunite X   BECKa AREF\r\n 0.1\r\n -1.23e34\r\n 0.3\r\n";
    let usgs_beside =
        b" splib07a Record=7: Wavelengths BECK 0.4-0.6 microns\r\n 0.4\r\n 0.5\r\n 0.6\r\n";
    let perkin = "PE UV   SPECTRUM    ASCII       PEDS   1.60\r\n -1\r\nx\r\n#HDR\r\n-1\r\n#GR\r\nNM\r\n\
        %T\r\n1.0\r\n#DATA\r\n500.0\t20.5  \r\n499.0\t10.5\r\n";
    let tuv = "\n solar zenith angle =  23.2\n SPECTRAL IRRADIANCE (W m-2 nm-1):\n\n \
        LOWER WVL  UPPER WVL  DIRECT     DIFFUSE DOWN  TOTAL DOWNWELLING\n \
        280.00     281.00     1E-17  2E-17     3E-17\n 281.00     282.00     1  2     3\n\n rest 1 2\n";
    let macam = "@1/5/1997\n@17:44\n#Lamp 3\n 2.5E+02\n 0.0\n 2.51E+02\n 0.5\n 2.52E+02\n 1.0\n \
        2.53E+02\n 0.5\n 2.54E+02\n 0.25\n";
    let wasatch = "{\"metadata\":{\"ENLIGHTEN Version\":\"2\",\"Label\":\"lamp\",\"Technique\":\"Scope\",\"ROI Pixel Start\":1},\
        \"spectrometerSettings\":{\"eeprom\":{\"wavelength_coeffs\":[400,2,0.5]},\
        \"wavelengths\":[400.5,401.0,401.5,402.0]},\
        \"spectrum\":{\"Dark\":[1,1,1],\"Processed\":[2.5,null,-1],\"Raw\":[9,9,9]}}";
    let spotread = "Spectrum from 380.000000 to 400.000000 nm in 3 steps\n 0.5, 1.5,\n 2.5\n \
        Result is XYZ: 1.0 2.0 3.0, D50 Lab: 1 2 3\n Ambient = 44632.4 Lux, CCT = 5528K (Duv 0.0031)\n \
        Color Rendering Index (Ra) = 99.0 [ R9 = 95.4 ]\n";
    let raman = format!(
        "Laser wavelength: 785 nm\nRaman shift (cm-1)\tIntensity\n{}",
        rows(100.5, 100.0, 4, "\t", "\n")
    );
    let sp = "SPECT   \n\nORIGINATOR \"Argyll CMS\"\nMEAS_TYPE \"REFLECTIVE\"\n\
        SPECTRAL_NORM \"100.0\"\nSPECTRAL_BANDS \"3\"\nSPECTRAL_START_NM \"380.0\"\n\
        SPECTRAL_END_NM \"400.0\"\nBEGIN_DATA_FORMAT\nSPEC_380 SPEC_390 SPEC_400\n\
        END_DATA_FORMAT\n\nBEGIN_DATA\n3.5 4.5 5.5\nEND_DATA\n";
    let ti3 = "CGATS.17\nNUMBER_OF_FIELDS 4\nBEGIN_DATA_FORMAT\nSAMPLE_ID nm380 nm390 nm400\n\
        END_DATA_FORMAT\nNUMBER_OF_SETS 2\nBEGIN_DATA\nA1 1 2 3\n\"A 2\" 4 5 6\nEND_DATA\n";
    let own_json = "{\"format\":\"spectral-explorer-spectrum\",\"version\":1,\"name\":\"a\",\
        \"kind\":\"light\",\"unit\":\"W\",\"wavelengths_nm\":[400,500],\"values\":[1,2.5]}";
    let composite = "{\"format\":\"composite-spectrum\",\"version\":1,\"range_nm\":[380,780],\
        \"basis\":\"fourier\",\"coefficients\":{\"a\":[2,0.5],\"b\":[-0.25]},\
        \"spikes\":[{\"at_nm\":404.87,\"weight\":2.39}],\"unit\":\"W\",\"source\":\"\"}";
    let colorimetry = "{\"schema_version\":\"1.0.0\",\"spectra\":[{\"id\":\"a\",\"metadata\":\
        {\"title\":\"Tile\",\"measurement_type\":\"reflectance\"},\"wavelength_axis\":{\"range_nm\":\
        {\"start\":400,\"end\":420,\"interval\":10}},\"spectral_data\":{\"scale\":\"percent\",\
        \"values\":[10,20,30]}},{\"id\":\"b\",\"wavelength_axis\":{\"values_nm\":[400,405.5]},\
        \"spectral_data\":{\"values\":[1,2]}}]}";
    let rawtoaces = "{\"header\":{\"description\":\"Tungsten\"},\"spectral_data\":{\"units\":\
        \"relative\",\"index\":{\"main\":[\"power\"]},\"data\":{\"main\":{\"1000\":[3.0],\
        \"380\":[1.0],\"400\":[2.0]}}}}";
    let plain = rows(380.0, 5.0, 6, "\t", "\n");
    let columns = [
        plain.clone(),
        format!(
            "Wavelength [nm];Lamp A;Lamp B\r\n{}",
            rows(380.0, 5.0, 5, ";1,5;", "\r\n").replace('.', ",")
        ),
        "Wavelength,380,385,390,395,400,405\na,1,2,3,4,5,6\nb,5,6,7,8,9,9\n".to_owned(),
        format!(
            "# kind: reflectance\n# unit: %\nwavelength_um,\"a, b\"\n{}",
            rows(0.38, 0.01, 5, ",", "\n")
        ),
        format!(
            ">>>>>Begin Processed Spectral Data<<<<<\n{}>>>>>End Processed Spectral Data<<<<<\n",
            plain
        ),
        format!(
            "Instrument: x\nDate: y\n\nwavenumber (1/cm) value\n{}",
            rows(20000.0, 500.0, 5, " ", "\n")
        ),
    ];
    let own_csv = format!(
        "# name: a lamp\n# kind: light\n# unit: W m-2 nm-1\n# written by: Spectral Explorer 1.0.0\n\
         wavelength_nm,measured,\"FL11, 0.5\"\n{}",
        rows(380.0, 5.0, 12, ",", ",0.25\n")
    );
    let refs: Vec<&str> = columns.iter().map(String::as_str).collect();
    vec![
        seeds(
            "ENVI",
            "envi",
            envi(),
            &[
                "ENVI",
                "samples = ",
                "lines = ",
                "bands = ",
                "data type = ",
                "interleave = ",
                "bsq",
                "bil",
                "bip",
                "byte order = ",
                "wavelength = {",
                "bbl = {",
                "header offset = ",
                "spectra names = {",
                "data ignore value = ",
                "\n=== BESIDE ===\n",
            ],
        ),
        seeds(
            "spectral OpenEXR",
            "spectral_exr",
            vec![
                exr((3, 2), &["T.400,0nm", "T.500,0nm"], Encoding::UNCOMPRESSED),
                exr(
                    (3, 2),
                    &["S0.400,0nm", "S0.500,0nm", "S1.400,0nm"],
                    Encoding::FAST_LOSSLESS,
                ),
                exr(
                    (9, 9),
                    &["S0.400,0nm", "S0.500,0nm"],
                    Encoding::SMALL_LOSSLESS,
                ),
            ],
            &[
                "channels\0chlist\0",
                "compression\0compression\0",
                "dataWindow\0box2i\0",
                "displayWindow\0box2i\0",
                "lineOrder\0lineOrder\0",
                "tiles\0tiledesc\0",
                "S0.400,0nm",
                "T.380,0nm.400,0nm",
            ],
        ),
        seeds(
            "GDTF",
            "gdtf",
            zips("description.xml", GDTF),
            &[
                "description.xml",
                "PK\x03\x04",
                "PK\x01\x02",
                "PK\x05\x06",
                "<Emitter",
                "<Filter",
                "<Measurement",
                "<MeasurementPoint",
                "WaveLength=\"",
                "Energy=\"",
            ],
        ),
        seeds(
            "Excel workbook",
            "xlsx",
            vec![
                cells.as_bytes().to_vec(),
                beside(&by_number, shared.as_bytes()),
                workbook(cells.as_bytes(), b"", stored),
                workbook(cells.as_bytes(), shared.as_bytes(), packed),
            ],
            &[
                "PK\x03\x04",
                "PK\x01\x02",
                "PK\x05\x06",
                "xl/workbook.xml",
                "<c r=\"A1\"",
                "t=\"s\"",
                "t=\"inlineStr\"",
                "<v>",
                "<dimension ref=\"A1:XFD1048576\"/>",
                "t=\"d\"",
                "t=\"e\"",
            ],
        ),
        seeds(
            "Ocean Optics ProcSpec",
            "procspec",
            zips("ps_0.xml", PROCSPEC),
            &[
                "PK\x03\x04",
                "PK\x01\x02",
                "PK\x05\x06",
                "ps_0.xml",
                "<double>",
                "</double>",
                "<channelWavelengths>",
                "<processedPixels>",
            ],
        ),
        seeds(
            "JCAMP-DX",
            "jcamp",
            jcamp(),
            &[
                "##TITLE=",
                "##END=",
                "##XYDATA= (X++(Y..Y))",
                "##XYPOINTS= (XY..XY)",
                "##NPOINTS=",
                "##FIRSTX=",
                "##LASTX=",
                "##XFACTOR=",
                "##YFACTOR=",
                "##DELTAX=",
                "##DATA TYPE= LINK",
                "$$",
                "%%",
                "S999999999",
            ],
        ),
        seeds(
            "CxF3",
            "cxf",
            texts(&[CXF]),
            &[
                "<CxF",
                "ReflectanceSpectrum",
                "StartWL=\"",
                "Increment=\"",
                "ColorSpecification",
                "<!DOCTYPE",
                "<![CDATA[",
            ],
        ),
        seeds(
            "refractiveindex.info YAML",
            "refractive_yaml",
            yaml(),
            &[
                "DATA:",
                "type: tabulated nk",
                "type: formula ",
                "wavelength_range: ",
                "coefficients: ",
                "&a",
                "*a",
                "<<:",
                "!!binary",
            ],
        ),
        seeds(
            "a format that is not read",
            "unreadable",
            vec![
                b"%PDF-1.7".to_vec(),
                b"\x89PNG\r\n\x1a\n".to_vec(),
                b"\x1f\x8b\x08\0".to_vec(),
                b"<html>".to_vec(),
                b"\0\x4b\x01\x02".to_vec(),
                b"SPDXVersion: SPDX-2.3\n".to_vec(),
            ],
            &["PK\x03\x04", "%PDF", "<html", "SQLite format 3"],
        ),
        seeds(
            "composite JSON",
            "composite_json",
            texts(&[
                composite,
                &composite
                    .replace("{\"a\":[2,0.5],\"b\":[-0.25]}", "{\"c\":[1,2,3]}")
                    .replace("fourier", "cosine"),
            ]),
            &[
                "composite-spectrum",
                "range_nm",
                "coefficients",
                "spikes",
                "\"at_nm\":",
                "1e308",
            ],
        ),
        seeds(
            "composite line",
            "composite_line",
            texts(&[
                "cs1;fourier;380:780;2 0.5 -0.25;404.87*2.39 435.84*5.94",
                "cs1; cosine;380:780;\n1 2\n3;\n",
            ]),
            &["cs1;", "fourier;", "cosine;", "380:780;", "*", "1e308"],
        ),
        seeds(
            "spectrum JSON",
            "spectrum_json",
            texts(&[own_json]),
            &[
                "spectral-explorer-spectrum",
                "wavelengths_nm",
                "values",
                "scale",
                "null",
                "1e308",
                "1e999",
            ],
        ),
        seeds(
            "JSON of another program",
            "foreign_json",
            texts(&[
                colorimetry,
                rawtoaces,
                "{\"status\":\"normal\",\"spd\":{\"340\":0.0,\"1000\":0.5}}",
                "{\"wavelengths\":[380,390,400],\"samples\":[{\"name\":\"A\",\"r\":[1,null,2]}]}",
                "[{\"wavelength\":380,\"v\":1},{\"wavelength\":390,\"v\":\"2.5\"}]",
                "{\"lamp\":{\"390nm\":2.5,\"380nm\":1}}",
                "[[380,1],[390,2]]",
            ]),
            &[
                "wavelength_axis",
                "wavelengths",
                "samples",
                "range_nm",
                "values_nm",
                "spectral_data",
                "interval",
                "percent",
                "spd",
                "null",
                "1e308",
            ],
        ),
        seeds("IES TM-27 .spdx", "spdx", texts(&[SPDX]), XML_WORDS),
        seeds(
            "pbrt .spd",
            "spd",
            texts(&[
                "# a lamp\n400 0.5 # first\n\n500\t1.5\n",
                "# kind: transmittance\n0.4 1\n0.5 2\n",
            ]),
            NUMBERS,
        ),
        seeds(
            "CGATS",
            "cgats",
            texts(&[sp, ti3]),
            &[
                "BEGIN_DATA_FORMAT",
                "END_DATA_FORMAT",
                "BEGIN_DATA",
                "END_DATA",
                "SPECTRAL_BANDS",
                "SPECTRAL_START_NM",
                "SPECTRAL_END_NM",
                "SPECTRAL_NORM",
                "SPEC_380",
                "SPECTRAL_NM380",
                "NUMBER_OF_SETS",
                "NUMBER_OF_FIELDS",
            ],
        ),
        seeds(
            "UPRtek",
            "uprtek",
            texts(&[uprtek, &uprtek.replace('.', ",")]),
            &["380nm\t", "Model Name\t", "CCT\t", "NaN", "1e308"],
        ),
        seeds(
            "LI-COR LI-180",
            "licor_li180",
            texts(&[li180]),
            &["380nm\t", "Model Name\t", "PPFD\t", "NaN", "1e308"],
        ),
        seeds(
            "Sekonic CSV",
            "sekonic",
            texts(&[&sekonic]),
            &["Spectral Data 380[nm],", "Tcp [K],", "NaN", "1e308"],
        ),
        seeds(
            "LI-COR LI-1800",
            "licor_1800",
            texts(&[li1800]),
            &[
                "\"FILE:", "\"REM:", "\"LIMS:", "\"INT:", "\"MAX:", "(QNTM)", "1E+308",
            ],
        ),
        seeds(
            "SVC .sig",
            "svc",
            texts(&[&svc]),
            &[
                "/*** Spectra Vista SIG Data ***/",
                "data= ",
                "units= ",
                "1e308",
            ],
        ),
        seeds(
            "USGS splib07",
            "usgs",
            vec![beside(usgs, usgs_beside), usgs.as_bytes().to_vec()],
            &[
                "splib07a Record=",
                "Wavelengths",
                "BECK",
                "ASD",
                "-1.23e34",
                "\n=== BESIDE ===\n",
            ],
        ),
        seeds(
            "PerkinElmer PEDS ASCII",
            "perkin_elmer",
            texts(&[perkin]),
            &["PEDS", "#HDR", "#GR", "#DATA", "%T", "NM"],
        ),
        seeds(
            "TUV report",
            "tuv",
            texts(&[tuv]),
            &[
                "LOWER WVL",
                "UPPER WVL",
                "SPECTRAL IRRADIANCE",
                "TOTAL",
                "1E+308",
            ],
        ),
        seeds(
            "Macam",
            "macam",
            texts(&[macam, &macam.replace('.', ",")]),
            &["@1/5/1997", "#", "1E+308", "NaN"],
        ),
        seeds(
            "Wasatch ENLIGHTEN JSON",
            "wasatch",
            texts(&[wasatch]),
            &[
                "ENLIGHTEN Version",
                "wavelength_coeffs",
                "ROI Pixel Start",
                "18446744073709551615",
                "Processed",
                "Reference",
                "null",
                "1e308",
            ],
        ),
        seeds(
            "Argyll spotread output",
            "spotread",
            texts(&[spotread]),
            &[
                "Spectrum from ",
                " nm in ",
                " steps",
                "Result is XYZ:",
                "999999999",
            ],
        ),
        seeds(
            "Raman text",
            "raman",
            texts(&[&raman]),
            &["Laser wavelength: ", "Raman shift", "785", "cm-1", "1e308"],
        ),
        seeds(
            "Spectral Explorer CSV",
            "own_csv",
            texts(&[&own_csv, &own_csv.replace("FL11", "[nm], \"std\"")]),
            &[
                "# kind: reflectance",
                "# unit: %",
                "# name: ",
                "# notes: ",
                "wavelength_nm",
                "measured",
                "1e308",
            ],
        ),
        seeds(
            "plain columns",
            "columns",
            texts(&refs),
            &[
                "wavelength",
                "nm",
                ";",
                "\t",
                "%",
                "# kind: ",
                "# unit: ",
                "NaN",
                "inf",
                "1e308",
                "-1e308",
                "1/cm",
                "Begin",
            ],
        ),
    ]
}
