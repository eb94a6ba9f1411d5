//! A picture in few numbers under a light, as a chain of jobs: look, fit, turn, and beside it what
//! it takes on disk and what others make of it.

use super::{Fit, FitAsk, LookAsk, Looked, Outcome, PeersAsk, StoreAsk, Stored, TurnAsk, Turned};
use crate::{
    app::{
        memo::ByAddress,
        pages::{ImageMemory, Look, RelitMemory},
        state::App,
        studies::{Studies, Wake},
    },
    pictures::{Between, Peer},
};

/// What there is of it now; each part waits for the one before.
#[derive(Clone, Debug, Default)]
pub struct RelitShown {
    /// The picture.
    pub looked: Option<ByAddress<Looked>>,
    /// The last one in few numbers that was turned, and how it looks.
    pub turned: Option<(ByAddress<Fit>, ByAddress<Turned>)>,
    /// What that takes on disk.
    pub stored: Option<ByAddress<Stored>>,
    /// Other ways than that.
    pub peers: Option<ByAddress<Vec<Peer>>>,
    /// Why there is nothing, a sentence.
    pub trouble: Option<String>,
}

impl RelitShown {
    /// What was found; what was not is told.
    fn found<T>(&mut self, outcome: &Outcome<T>) -> Option<ByAddress<T>> {
        match outcome {
            Ok(found) => Some(found.clone()),
            Err(why) => {
                self.trouble = Some(why.clone());
                None
            }
        }
    }
}

/// Asks for what the page shows, and tells what is there of it. A light that moves asks for a turn
/// alone, a count of numbers for a fit and a turn.
pub fn relit_shown(
    studies: &mut Studies,
    app: &App,
    (memory, image): (&RelitMemory, &ImageMemory),
    wake: &Wake,
) -> RelitShown {
    let mut shown = RelitShown::default();
    let ask = LookAsk::of(app, memory, image);
    let job = studies.job();
    job.put(&ask, wake);
    // The last look stays, but not that at another picture.
    let Some((_, looked)) = job.answer().filter(|(k, _)| k.subject == ask.subject) else {
        return shown;
    };
    let Some(looked) = shown.found(looked) else {
        return shown;
    };
    shown.looked = Some(looked.clone());
    let wanted = FitAsk {
        looked: looked.clone(),
        numbers: memory.numbers,
    };
    let job = studies.job();
    job.put(&wanted, wake);
    let fit = job.answer().filter(|(k, _)| k.looked == looked);
    let fit = fit.and_then(|(_, fit)| shown.found(fit));
    if shown.trouble.is_some() {
        return shown;
    }
    if let Some(fit) = &fit {
        turn_to(studies, app, memory, fit, wake);
    }
    // Until there is a new one the last stays, so that what a hand is on stays where it is.
    let of = |k: &TurnAsk| k.fit.0.looked.0.ask.subject == ask.subject;
    let turned = studies.of::<TurnAsk>().answer().filter(|(k, _)| of(k));
    if let Some((key, turned)) = turned
        && let Some(turned) = shown.found(turned)
    {
        shown.turned = Some((key.fit.clone(), turned));
    }
    if let Some(fit) = &fit {
        beside(studies, fit, memory.look, wake, &mut shown);
    }
    shown
}

/// Asks for a picture in few numbers under the document's light.
fn turn_to(
    studies: &mut Studies,
    app: &App,
    memory: &RelitMemory,
    fit: &ByAddress<Fit>,
    wake: &Wake,
) {
    let second = memory.second.as_deref().and_then(|key| app.entry(key));
    let ask = TurnAsk {
        fit: fit.clone(),
        light: ByAddress(app.document().light.clone()),
        second: second.map(|entry| (ByAddress(entry), memory.second_percent)),
        to_light: app.document().view.adapt_patches,
        between: match memory.between_series {
            true => Between::Series,
            false => Between::Bands,
        },
    };
    studies.job().put(&ask, wake);
}

/// What is told beside the picture.
fn beside(
    studies: &mut Studies,
    fit: &ByAddress<Fit>,
    look: Look,
    wake: &Wake,
    shown: &mut RelitShown,
) {
    let job = studies.job();
    job.put(&StoreAsk(fit.clone()), wake);
    let of = shown.turned.as_ref().map(|(fit, _)| fit.clone());
    let stored = job.answer().filter(|(k, _)| Some(&k.0) == of.as_ref());
    shown.stored = stored.and_then(|(_, stored)| shown.found(stored));
    if look == Look::Others {
        let job = studies.job();
        job.put(&PeersAsk(fit.clone()), wake);
        let peers = job.answer().filter(|(k, _)| Some(&k.0) == of.as_ref());
        shown.peers = peers.and_then(|(_, peers)| shown.found(peers));
    }
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use super::*;
    use crate::app::Command;

    fn all(studies: &mut Studies, app: &App, memory: &RelitMemory) -> RelitShown {
        let mut shown = RelitShown::default();
        for _ in 0..4 {
            shown = once(studies, app, memory);
            studies.finish();
        }
        shown
    }

    fn once(studies: &mut Studies, app: &App, memory: &RelitMemory) -> RelitShown {
        let wake: Wake = Arc::new(|| {});
        relit_shown(studies, app, (memory, &ImageMemory::default()), &wake)
    }

    #[test]
    fn the_last_picture_stays_while_another_is_made_of_the_same() {
        let (app, mut studies) = (App::new(), Studies::default());
        let mut memory = RelitMemory {
            numbers: Some(6),
            ..RelitMemory::default()
        };
        let first = all(&mut studies, &app, &memory);
        memory.weighted = false;
        // Asked for, not yet there.
        let between = once(&mut studies, &app, &memory);
        assert!(between.turned.is_some() && between.turned == first.turned);
        let second = all(&mut studies, &app, &memory);
        assert!(second.turned.is_some() && second.turned != first.turned);
    }

    #[test]
    fn another_light_turns_the_picture_without_another_fit() {
        let (mut app, mut studies) = (App::new(), Studies::default());
        let memory = RelitMemory {
            numbers: Some(8),
            ..RelitMemory::default()
        };
        let first = all(&mut studies, &app, &memory);
        let (fit, turned) = first.turned.expect("the wall is there");
        assert_eq!(fit.0.operator.numbers(), 8);
        assert!(turned.0.spread.p95 > 0.1 && turned.0.spread.max >= turned.0.spread.p95);
        let stored = first.stored.expect("it was written");
        let bytes = stored.0.bytes;
        assert!(bytes.compact < bytes.full && bytes.full < bytes.exact);
        app.apply(Command::Show(
            app.entry("cie_illuminants/CIE A").expect("shipped"),
        ));
        let second = all(&mut studies, &app, &memory);
        let (same, other) = second.turned.expect("it was there before");
        assert!(same == fit && other != turned);
        assert_ne!(other.0.sides[1].pixels, turned.0.sides[1].pixels);
        assert_eq!(other.0.light, app.document().light.name());
    }
}
