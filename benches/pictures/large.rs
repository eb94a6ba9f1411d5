//! A compact file of 4096 x 4096 pixels.

use criterion::Criterion;
use spectral_explorer::pictures::*;
use spectral_explorer::study::Progress;

use super::nm;

/// Some rows again and again: a picture as large as it is asked for.
struct Repeated {
    rows: InMemory,
    height: usize,
}

impl Pixels for Repeated {
    fn size(&self) -> (usize, usize) {
        (self.rows.size().0, self.height)
    }

    fn bands(&self) -> &Bands {
        self.rows.bands()
    }

    fn rows(&self, first: usize, count: usize, into: &mut [f32]) -> Result<(), PictureError> {
        let (width, height) = self.rows.size();
        let bands = self.bands().len();
        for (j, band) in into.chunks_exact_mut(count * width).take(bands).enumerate() {
            for (y, row) in band.chunks_exact_mut(width).enumerate() {
                let from = (j * height + (first + y) % height) * width;
                row.copy_from_slice(&self.rows.values()[from..from + width]);
            }
        }
        Ok(())
    }
}

/// A compact file of 4096 x 4096 pixels: its preview, and one tile.
pub(crate) fn large(c: &mut Criterion) {
    let quiet = Progress::default();
    let rows = Scene::reflectance(4096, 64, nm(400.0, 700.0, 31)).unwrap();
    let pixels = Repeated {
        rows: InMemory::of(&rows).unwrap(),
        height: 4096,
    };
    let operator = Operator::new(pixels.bands(), &Plan::new(pixels.bands(), 15)).unwrap();
    let survey = Survey::of(&pixels, &quiet).unwrap();
    let sample: Vec<Vec<f64>> = survey
        .sample
        .iter()
        .map(|p| operator.numbers_of(p))
        .collect();
    let plan = CompactPlan {
        quantiser: Quantiser::new(&operator, &sample, 1.0, None).unwrap(),
        error: Errors::default(),
    };
    let mut file = Vec::new();
    let (about, coder) = (About::default(), Coder::Fitted);
    write_compact(&mut file, &pixels, &operator, &plan, &about, coder, &quiet).unwrap();
    let mut group = c.benchmark_group("compact file of 4096 x 4096, 15 numbers");
    group.sample_size(10);
    group.bench_function("opened, with its preview", |b| {
        b.iter(|| {
            let opened = CompactFile::open(file.clone()).unwrap();
            let png = png::Decoder::new(std::io::Cursor::new(&file));
            let mut reader = png.read_info().unwrap();
            let mut preview = vec![0; reader.output_buffer_size().unwrap()];
            reader.next_frame(&mut preview).unwrap();
            (opened, preview)
        })
    });
    let opened = CompactFile::open(file.clone()).unwrap();
    group.bench_function("one tile of 256 x 256", |b| {
        b.iter(|| opened.tile(3, 5).unwrap())
    });
}
