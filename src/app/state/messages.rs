//! What the program says in the status line.

use super::{App, Kept};

/// How weighty a message is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Tone {
    /// Something was done.
    Info,
    /// Something was refused or went wrong.
    Problem,
}

/// A sentence for the status line.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Message {
    /// How weighty it is.
    pub tone: Tone,
    /// One line.
    pub text: String,
    /// The revision of the document that it was said about.
    pub revision: u64,
    /// Whether it is history once the document has changed.
    pub is_passing: bool,
    /// How many steps had been taken when it was said.
    steps: u64,
}

/// A problem is history after so many further steps.
const NOTICED: u64 = 3;

impl App {
    /// Makes anew what has words in it: another language is spoken from now on.
    pub fn say_anew(&mut self) {
        self.told = None;
        self.recompute(Kept::AllOrders);
    }

    /// The newest message.
    pub fn message(&self) -> Option<&Message> {
        self.messages.last()
    }

    /// The newest message, as long as it is about what is shown: what was told of a document that
    /// has changed since is history. A problem stays for some steps more, unless it is about what
    /// was opened.
    pub fn current_message(&self) -> Option<&Message> {
        self.message()
            .filter(|m| !m.is_passing || m.revision == self.revision)
            .filter(|m| self.steps < m.steps + NOTICED)
    }

    /// All messages, oldest first.
    pub fn messages(&self) -> &[Message] {
        &self.messages
    }

    /// Says something in the status line: what was done is history with the next change, a
    /// problem stays for some steps.
    pub fn say(&mut self, tone: Tone, text: impl Into<String>) {
        self.push_message(tone, text.into(), tone == Tone::Info);
    }

    /// Says something about the document as it is now: an undo takes it away.
    pub fn say_for_now(&mut self, tone: Tone, text: impl Into<String>) {
        self.push_message(tone, text.into(), true);
    }

    fn push_message(&mut self, tone: Tone, text: String, is_passing: bool) {
        const MOST: usize = 200;
        if self.messages.len() == MOST {
            self.messages.remove(0);
        }
        self.messages.push(Message {
            tone,
            text,
            revision: self.revision,
            is_passing,
            steps: self.steps,
        });
    }
}
