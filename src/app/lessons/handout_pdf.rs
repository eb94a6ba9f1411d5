//! A sheet on A4 pages: its parts laid out from top to bottom.

use std::{collections::HashMap, fmt::Write as _, io::Write as _};

use flate2::{Compression, write::ZlibEncoder};
use svg2pdf::usvg;

use super::handout_parts::{Block, Picture, axis_svg, bare, escaped};
use crate::{
    app::{
        chart::{px, wrap},
        sheet,
    },
    io::{ColourPixels, photo_of},
};

/// A4 in px of 1/96 inch, and the margin around it.
const PAGE: [f64; 2] = [794.0, 1123.0];
const MARGIN: f64 = 64.0;
/// Sizes of a title, a heading, and words.
const SIZES: [f64; 3] = [24.0, 17.0, 13.5];
const LEADING: f64 = 1.4;
/// Height of a picture, and of an axis to sketch on, over the width of the words.
const TALL: f64 = 0.5;
const AXIS: f64 = 0.34;
/// Space between two lines to write on.
const RULED: f64 = 30.0;

/// Pages that are being filled.
struct Pages {
    done: Vec<Page>,
    body: String,
    images: Vec<([f64; 4], Image)>,
    y: f64,
}

/// A page: the elements of its SVG, and its pictures of pixels with their places.
struct Page {
    body: String,
    images: Vec<([f64; 4], Image)>,
}

impl Pages {
    fn turn(&mut self) {
        self.done.push(Page {
            body: std::mem::take(&mut self.body),
            images: std::mem::take(&mut self.images),
        });
        self.y = MARGIN;
    }

    /// Room of some height: on the next page where this one has none.
    fn room(&mut self, height: f64) -> f64 {
        if self.y + height > PAGE[1] - MARGIN && self.y > MARGIN {
            self.turn();
        }
        let top = self.y;
        self.y += height;
        top
    }

    /// Turns the page where this one has no room for what is to stand together, and one has.
    fn keep(&mut self, height: f64) {
        let whole = PAGE[1] - 2.0 * MARGIN;
        if self.y + height > PAGE[1] - MARGIN && self.y > MARGIN && height <= whole {
            self.turn();
        }
    }

    fn words(&mut self, lead: &str, words: &str, indent: f64, size: f64, weight: &str) {
        let whole = format!("{lead} {words}");
        let width = PAGE[0] - 2.0 * MARGIN - indent;
        for (index, line) in wrap(whole.trim(), width, size).iter().enumerate() {
            let y = px(self.room(size * LEADING) + size);
            let bold = match index == 0 && !lead.is_empty() && line.starts_with(lead) {
                true => lead,
                false => "",
            };
            let rest = escaped(&line[bold.len()..]);
            let x = px(MARGIN + indent);
            // Writing to a string cannot fail.
            let _ = writeln!(
                self.body,
                "<text x=\"{x}\" y=\"{y}\" font-size=\"{size}\" font-weight=\"{weight}\" \
                 fill=\"#000000\" xml:space=\"preserve\"><tspan font-weight=\"bold\">{}</tspan>\
                 {rest}</text>",
                escaped(bold)
            );
        }
        self.y += 0.4 * size;
    }

    /// Left, top, width and height of the next picture, so tall over the width of the words, and
    /// no wider than it is over its own height.
    fn place(&mut self, tall: f64, aspect: f64) -> [f64; 4] {
        let width = PAGE[0] - 2.0 * MARGIN;
        let height = tall * width;
        let top = self.room(height + 8.0);
        [MARGIN, top, width.min(aspect * height), height]
    }

    fn svg(&mut self, svg: &str, tall: f64) {
        let [x, y, width, height] = self.place(tall, f64::INFINITY);
        let start = format!("<svg x=\"{x}\" y=\"{y}\" width=\"{width}\" height=\"{height}\"");
        self.body += &framed_svg(bare(svg), &start);
        self.body.push('\n');
    }
}

/// A picture of pixels.
struct Image {
    size: [usize; 2],
    /// Red, green and blue, row by row, deflated with a zlib header.
    deflated: Vec<u8>,
}

impl Image {
    fn of(png: &[u8]) -> Result<Self, String> {
        let photo = photo_of("the page", png).map_err(|why| why.to_string())?;
        let ColourPixels::Eight(pixels) = photo.pixels else {
            return Err("found 16 bits a channel, expected 8".to_owned());
        };
        let mut deflater = ZlibEncoder::new(Vec::new(), Compression::default());
        let written = deflater.write_all(&pixels);
        let deflated = written.and_then(|()| deflater.finish());
        Ok(Self {
            size: photo.size,
            deflated: deflated.map_err(|why| why.to_string())?,
        })
    }
}

/// A picture with another size and place on its first element.
fn framed_svg(svg: &str, start: &str) -> String {
    let (head, rest) = svg.split_once('>').unwrap_or((svg, ""));
    let kept = head.split(' ').skip(1).collect::<Vec<_>>().join(" ");
    let kept = without(&without(&kept, "width"), "height");
    format!("{start} {kept}>{rest}")
}

/// Attributes without one of them.
fn without(attributes: &str, name: &str) -> String {
    let start = format!("{name}=\"");
    match attributes.find(&start) {
        Some(at) => {
            let end = attributes[at + start.len()..].find('"');
            let end = end.map_or(attributes.len(), |end| at + start.len() + end + 1);
            format!("{}{}", &attributes[..at], &attributes[end..])
        }
        None => attributes.to_owned(),
    }
}

/// Height of a part, px.
fn height(block: &Block) -> f64 {
    let [title, heading, size] = SIZES;
    let width = PAGE[0] - 2.0 * MARGIN;
    let words = |words: &str, width: f64, size: f64| {
        let lines = wrap(words, width, size).len();
        size * (LEADING * lines as f64 + 0.4)
    };
    match block {
        Block::Title(text) => words(text, width, title),
        Block::Heading(text) => words(text, width, heading) + 0.8 * size,
        Block::Words(text) => words(text, width, size),
        Block::Led(lead, text) => words(&format!("{lead} {text}"), width, size),
        Block::Choice(_, text) => words(&format!("☐ A. {text}"), width - 16.0, size),
        Block::Picture(_) => TALL * width + 8.0,
        Block::Axis => AXIS * width + 8.0,
        Block::Lines(count) => RULED * *count as f64 + 8.0,
        Block::NewPage => 0.0,
    }
}

/// Height of a part with those behind it that stand on the same page: words with the picture or the
/// question that they are about, a question with its answers and the lines under it.
fn together(blocks: &[Block]) -> f64 {
    let is = |index: usize, of: fn(&Block) -> bool| blocks.get(index).is_some_and(of);
    let is_words = |block: &Block| matches!(block, Block::Words(_));
    let is_picture = |block: &Block| matches!(block, Block::Picture(_) | Block::Axis);
    let count = match blocks.first() {
        Some(Block::Heading(_) | Block::Words(_)) => {
            let words = (1..).take_while(|index| is(*index, is_words)).count();
            match is(1 + words, is_picture) {
                true => 2 + words,
                false if is(0, is_words) => 1,
                false => 1 + words + answered(&blocks[1 + words..]),
            }
        }
        Some(Block::Led(..)) => answered(blocks),
        _ => 1,
    };
    blocks.iter().take(count).map(height).sum()
}

/// How many parts belong to a question or a task at the beginning: its choices, and what is written
/// under it.
fn answered(blocks: &[Block]) -> usize {
    let is_of_it =
        |block: &&Block| matches!(block, Block::Led(..) | Block::Choice(..) | Block::Lines(_));
    let all = blocks.iter().take_while(is_of_it).count();
    let lines = blocks[..all].iter();
    let lines = lines
        .clone()
        .position(|block| matches!(block, Block::Lines(_)));
    let choices = blocks.iter().skip(1);
    let choices = choices.take_while(|block| matches!(block, Block::Choice(..)));
    lines.map_or(1 + choices.count(), |lines| lines + 1)
}

/// The sheet as PDF.
///
/// # Errors
/// One line where a page cannot be drawn.
pub(super) fn pdf(blocks: &[Block]) -> Result<Vec<u8>, String> {
    let [title, heading, size] = SIZES;
    let mut pages = Pages {
        done: Vec::new(),
        body: String::new(),
        images: Vec::new(),
        y: MARGIN,
    };
    for (index, block) in blocks.iter().enumerate() {
        pages.keep(together(&blocks[index..]));
        match block {
            Block::Title(words) => pages.words("", words, 0.0, title, "bold"),
            Block::Heading(words) => {
                pages.y += 0.8 * size;
                pages.words("", words, 0.0, heading, "bold");
            }
            Block::Words(words) => pages.words("", words, 0.0, size, "normal"),
            Block::Led(lead, words) => pages.words(lead, words, 0.0, size, "normal"),
            Block::Choice(letter, words) => {
                let words = format!("☐ {letter}. {words}");
                pages.words("", &words, 16.0, size, "normal");
            }
            Block::Picture(Picture::Svg(svg)) => pages.svg(svg, TALL),
            Block::Picture(Picture::Png(png)) => {
                let image = Image::of(png)?;
                let [wide, high] = image.size.map(|side| side as f64);
                let place = pages.place(TALL, wide / high);
                pages.images.push((place, image));
            }
            Block::Axis => pages.svg(&axis_svg(), AXIS),
            Block::Lines(count) => {
                for _ in 0..*count {
                    let y = pages.room(RULED) + RULED - 6.0;
                    let (from, to) = (MARGIN, PAGE[0] - MARGIN);
                    let _ = writeln!(
                        pages.body,
                        "<path d=\"M{from} {y}H{to}\" stroke=\"#888888\" fill=\"none\"/>"
                    );
                }
                pages.y += 8.0;
            }
            Block::NewPage => pages.turn(),
        }
    }
    pages.turn();
    bound(&pages.done)
}

/// Drawn pages as one document.
fn bound(pages: &[Page]) -> Result<Vec<u8>, String> {
    use pdf_writer::{Content, Filter, Finish as _, Name, Pdf, Rect, Ref};
    /// Points of 1/72 inch in a px of 1/96.
    const POINTS: f64 = 0.75;
    let options = sheet::svg_options();
    let [width, height] = PAGE;
    let mut next = Ref::new(1);
    let (catalog, tree) = (next.bump(), next.bump());
    let mut pdf = Pdf::new();
    let ids: Vec<Ref> = pages.iter().map(|_| next.bump()).collect();
    pdf.catalog(catalog).pages(tree);
    pdf.pages(tree)
        .kids(ids.iter().copied())
        .count(ids.len() as i32);
    for (id, Page { body, images }) in ids.into_iter().zip(pages) {
        let svg = format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{width}\" height=\"{height}\" \
             viewBox=\"0 0 {width} {height}\" font-family=\"DejaVu Sans, sans-serif\">{body}</svg>"
        );
        let drawn = usvg::Tree::from_str(&svg, &options).map_err(|why| why.to_string())?;
        let chunk = svg2pdf::to_chunk(&drawn, svg2pdf::ConversionOptions::default());
        let (chunk, picture) = chunk.map_err(|why| why.to_string())?;
        let mut renumbered = HashMap::new();
        let chunk = chunk.renumber(|old| *renumbered.entry(old).or_insert_with(|| next.bump()));
        let picture = renumbered[&picture];
        let content_id = next.bump();
        let (w, h) = ((width * POINTS) as f32, (height * POINTS) as f32);
        let mut page = pdf.page(id);
        page.media_box(Rect::new(0.0, 0.0, w, h))
            .parent(tree)
            .contents(content_id);
        let mut resources = page.resources();
        let mut objects = resources.x_objects();
        objects.pair(Name(b"S"), picture);
        let named: Vec<(String, Ref)> = (0..images.len())
            .map(|index| (format!("I{index}"), next.bump()))
            .collect();
        for (name, id) in &named {
            objects.pair(Name(name.as_bytes()), *id);
        }
        objects.finish();
        resources.finish();
        page.finish();
        let mut content = Content::new();
        content.save_state();
        content
            .transform([w, 0.0, 0.0, h, 0.0, 0.0])
            .x_object(Name(b"S"));
        content.restore_state();
        for ((name, id), (place, image)) in named.iter().zip(images) {
            let [x, y, wide, high] = place.map(|px| (px * POINTS) as f32);
            content.save_state();
            content.transform([wide, 0.0, 0.0, high, x, h - y - high]);
            content.x_object(Name(name.as_bytes())).restore_state();
            let mut object = pdf.image_xobject(*id, &image.deflated);
            object.filter(Filter::FlateDecode);
            object.bits_per_component(8);
            object
                .width(image.size[0] as i32)
                .height(image.size[1] as i32);
            object.color_space().device_rgb();
        }
        pdf.stream(content_id, &content.finish());
        pdf.extend(&chunk);
    }
    let mut bytes = pdf.finish();
    bytes.extend_from_slice(sheet::PDF_TAIL.as_bytes());
    Ok(bytes)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_question_stands_on_one_page_with_its_answers_and_the_lines_under_it() {
        let led = |lead| Block::Led(lead, "Words.".to_owned());
        let choice = |letter| Block::Choice(letter, "An answer".to_owned());
        let blocks = [
            Block::Heading("Step 2".to_owned()),
            Block::Words("What is said.".to_owned()),
            led("Predict."),
            choice('A'),
            choice('B'),
            led("Because"),
            Block::Lines(2),
            led("Do."),
            led("What I saw"),
            Block::Lines(2),
            Block::Heading("Step 3".to_owned()),
            Block::Words("What is said.".to_owned()),
            Block::Axis,
        ];
        let whole = |part: &[Block]| part.iter().map(height).sum::<f64>();
        for (from, to) in [(0, 7), (2, 7), (5, 7), (7, 10), (10, 13)] {
            assert_eq!(
                together(&blocks[from..]),
                whole(&blocks[from..to]),
                "{from}"
            );
        }
        // A teacher's answers go on behind their reasons, which may stand on the next page.
        let answered = [
            led("Predict."),
            choice('A'),
            Block::Words("A: why.".to_owned()),
        ];
        assert_eq!(together(&answered), whole(&answered[..2]));
    }
}
