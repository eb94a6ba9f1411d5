//! Who works in a browser, where there are no threads: other instances of the program, which take
//! and give bytes, and this one between two frames.

use std::{
    cell::{Cell, RefCell},
    collections::{BTreeMap, VecDeque},
    rc::Rc,
    sync::Arc,
    thread,
};

use crate::study::Progress;

/// How other instances are reached; each question has a number of its own.
#[derive(Clone, Copy)]
pub struct Others {
    /// Puts a question of a kind.
    pub ask: fn(u32, &str, &[u8]),
    /// Has the one that works on a question stop at once.
    pub stop: fn(u32),
}

/// What came of a question.
pub enum Came {
    /// Its answer.
    Bytes(Vec<u8>),
    /// It does not cross, or its answer does not: it is to be answered here.
    Nothing,
    /// The other instance broke down; why stands in the browser's console.
    Broken,
}

type Work = Box<dyn FnOnce()>;
type Take = Box<dyn FnOnce(Came)>;
type Wake = Arc<dyn Fn() + Send + Sync>;

/// A question that another instance works on.
struct Asked {
    take: Take,
    progress: Arc<Progress>,
    wake: Wake,
    broken: Rc<Cell<bool>>,
}

thread_local! {
    static WAITING: RefCell<VecDeque<Work>> = RefCell::default();
    static OTHERS: Cell<Option<Others>> = const { Cell::new(None) };
    static ASKED: RefCell<BTreeMap<u32, Asked>> = const { RefCell::new(BTreeMap::new()) };
    static NEXT: Cell<u32> = const { Cell::new(0) };
}

/// What a worker holds of its work.
pub(super) enum Hand {
    /// It waits for its turn.
    Turn,
    /// Another instance does it.
    Other(u32, Rc<Cell<bool>>),
}

impl Hand {
    /// Waits for the end. Nothing comes from another instance meanwhile: its work is done here.
    pub(super) fn join(self) -> thread::Result<()> {
        if let Self::Other(number, broken) = &self {
            if let Some(asked) = give_up(*number) {
                (asked.take)(Came::Nothing);
            } else if broken.get() {
                return Err(Box::new("another instance broke down"));
            } else {
                return Ok(());
            }
        }
        while take_turn() {}
        Ok(())
    }
}

/// Has work done when its turn comes.
pub(super) fn spawn(work: impl FnOnce() + 'static) -> Hand {
    WAITING.with_borrow_mut(|waiting| waiting.push_back(Box::new(work)));
    Hand::Turn
}

/// Does the work that waits longest; `false` where none waits.
pub fn take_turn() -> bool {
    let work = WAITING.with_borrow_mut(VecDeque::pop_front);
    let is_one = work.is_some();
    if let Some(work) = work {
        work();
    }
    is_one
}

/// From now on others are reached so.
pub fn reach(others: Others) {
    OTHERS.set(Some(others));
}

/// Asks another instance, and takes what comes; where there is none, nothing comes.
pub(super) fn ask(
    (kind, question): (&str, &[u8]),
    (progress, wake): (&Arc<Progress>, &Wake),
    take: Take,
) -> Hand {
    let Some(others) = OTHERS.get() else {
        take(Came::Nothing);
        return Hand::Turn;
    };
    let number = NEXT.replace(NEXT.get().wrapping_add(1));
    let broken = Rc::new(Cell::new(false));
    let asked = Asked {
        take,
        progress: progress.clone(),
        wake: wake.clone(),
        broken: broken.clone(),
    };
    ASKED.with_borrow_mut(|all| all.insert(number, asked));
    (others.ask)(number, kind, question);
    Hand::Other(number, broken)
}

/// Takes what came of a question; nobody waits for what was stopped.
pub fn come(number: u32, came: Came) {
    let asked = ASKED.with_borrow_mut(|all| all.remove(&number));
    if let Some(asked) = asked {
        asked.broken.set(matches!(came, Came::Broken));
        (asked.take)(came);
    }
}

/// Takes in how far the work on a question is.
pub fn follow(number: u32, done: usize, total: usize) {
    ASKED.with_borrow(|all| {
        if let Some(asked) = all.get(&number) {
            asked.progress.follow(done, total);
            (asked.wake)();
        }
    });
}

/// Stops the work that was cancelled.
pub fn stop_cancelled() {
    let cancelled: Vec<u32> = ASKED.with_borrow(|all| {
        let cancelled = all
            .iter()
            .filter(|(_, asked)| asked.progress.is_cancelled());
        cancelled.map(|(number, _)| *number).collect()
    });
    // Whoever is let go tells that nothing comes.
    cancelled
        .into_iter()
        .for_each(|number| drop(give_up(number)));
}

fn give_up(number: u32) -> Option<Asked> {
    let asked = ASKED.with_borrow_mut(|all| all.remove(&number))?;
    if let Some(others) = OTHERS.get() {
        (others.stop)(number);
    }
    Some(asked)
}
