//! XML of others, read so that a small file cannot unfold or stall.
//!
//! Document types and entities are refused by the parser; elements are counted against the memory
//! that a file of its size may take; an element may have 256 attributes, since the parser compares
//! each with each.

use roxmltree::{Document, Node, ParsingOptions};

use crate::io::text::number;
use crate::io::{Input, ReadError, budget, quoted};

/// Memory that the parser takes for an element or a piece of text, in bytes.
const NODE_BYTES: usize = 120;

/// Most equals signs in one tag.
const MOST_ATTRIBUTES: usize = 256;

/// Parses a text that came out of a file.
///
/// # Errors
/// [`ReadError`] with the line at fault.
pub(crate) fn parse<'a>(input: &Input, text: &'a str) -> Result<Document<'a>, ReadError> {
    if let Some(at) = crowded_tag(text) {
        let line = 1 + text[..at].bytes().filter(|b| *b == b'\n').count();
        let found = said!("an element with hundreds of attributes");
        return Err(input.error_at(line, found, said!("at most 256")));
    }
    let nodes = budget::of_text(input.bytes.len()) / 2 / NODE_BYTES;
    let options = ParsingOptions {
        nodes_limit: u32::try_from(nodes).unwrap_or(u32::MAX),
        ..ParsingOptions::default()
    };
    Document::parse_with_options(text, options).map_err(|error| match error {
        roxmltree::Error::DtdDetected => input.error(
            said!("an XML document with a DTD (entities)"),
            said!("one without: such documents are not read"),
        ),
        _ => input.error_at(
            error.pos().row as usize,
            tr!("broken XML ({error})", error),
            said!("well-formed XML"),
        ),
    })
}

/// The start of a tag with too many equals signs outside quotation marks.
fn crowded_tag(text: &str) -> Option<usize> {
    let bytes = text.as_bytes();
    let mut at = 0;
    while let Some(skip) = bytes[at..].iter().position(|b| *b == b'<') {
        let start = at + skip;
        let special = [("<!--", "-->"), ("<![CDATA[", "]]>"), ("<?", "?>")];
        let end = special
            .iter()
            .find(|(open, _)| bytes[start..].starts_with(open.as_bytes()));
        if let Some((open, close)) = end {
            let from = start + open.len();
            at = from + text[from..].find(close)? + close.len();
            continue;
        }
        let (mut quote, mut count) = (None, 0);
        at = start + 1;
        while let Some(byte) = bytes.get(at) {
            match (quote, byte) {
                (Some(mark), _) if mark == byte => quote = None,
                (Some(_), _) => {}
                (None, b'"' | b'\'') => quote = Some(byte),
                (None, b'=') => count += 1,
                (None, b'>') => break,
                (None, _) => {}
            }
            if count > MOST_ATTRIBUTES {
                return Some(start);
            }
            at += 1;
        }
    }
    None
}

/// The line of a node, from 1: counted from the file's start, so only where there is trouble.
pub(crate) fn line(node: Node) -> usize {
    node.document().text_pos_at(node.range().start).row as usize
}

/// The finite number that a text of a node is.
///
/// # Errors
/// [`ReadError`] at the line of the node.
pub(crate) fn number(
    input: &Input,
    node: Node,
    text: &str,
    expected: &str,
) -> Result<f64, ReadError> {
    let number = number::number(text.trim(), false).filter(|x| x.is_finite());
    number.ok_or_else(|| input.error_at(line(node), quoted(text), expected))
}

/// Descendants of a local name, whatever its case and namespace.
pub(crate) fn named<'a, 'i: 'a>(
    node: Node<'a, 'i>,
    name: &str,
) -> impl Iterator<Item = Node<'a, 'i>> {
    node.descendants().filter(move |n| is_named(*n, name))
}

/// Children of a local name, whatever its case and namespace.
pub(crate) fn children<'a, 'i: 'a>(
    node: Node<'a, 'i>,
    name: &str,
) -> impl Iterator<Item = Node<'a, 'i>> {
    node.children().filter(move |n| is_named(*n, name))
}

fn is_named(node: Node, name: &str) -> bool {
    node.is_element() && node.tag_name().name().eq_ignore_ascii_case(name)
}

/// An attribute by its local name, whatever its case.
pub(crate) fn attribute<'a>(node: Node<'a, '_>, name: &str) -> Option<&'a str> {
    let found = node
        .attributes()
        .find(|a| a.name().eq_ignore_ascii_case(name));
    found
        .map(|a| a.value().trim())
        .filter(|text| !text.is_empty())
}
