//! The other side of a crossing: questions that came as bytes are answered as bytes.

use serde::{Serialize, de::DeserializeOwned};

use super::{AuctionAsk, LightsQualityAsk, ManyAsk, Question, RaceAsk, SweepAsk};
use crate::{
    design::solve::FrontProblem,
    languages::{Language, in_language},
    study::Progress,
};

/// Answers a question of a kind; `None` where it is of another kind, or where it or its answer does
/// not cross unchanged.
type Answering = fn(&str, &[u8], &Progress) -> Option<Vec<u8>>;

/// What takes long and whose question and answer are small beside it. Pictures are neither.
const KINDS: [Answering; 6] = [
    far::<SweepAsk>,
    far::<ManyAsk>,
    far::<AuctionAsk>,
    far::<RaceAsk>,
    far::<LightsQualityAsk>,
    far::<FrontProblem>,
];

/// The answer to a question that came as bytes; `None` where it has to be answered where it was
/// asked.
pub fn answered(kind: &str, question: &[u8], progress: &Progress) -> Option<Vec<u8>> {
    KINDS.iter().find_map(|of| of(kind, question, progress))
}

fn far<Q>(kind: &str, question: &[u8], progress: &Progress) -> Option<Vec<u8>>
where
    Q: Question<Answer: Serialize + DeserializeOwned + PartialEq> + DeserializeOwned,
{
    let crossing = Q::crossing().filter(|crossing| crossing.kind == kind)?;
    let (language, question): (Language, Q) = serde_json::from_slice(question).ok()?;
    let answer = in_language(language, || question.answer(progress));
    let bytes = serde_json::to_vec(&answer).ok()?;
    // JSON has no word for a number that is none.
    ((crossing.found)(&bytes)? == answer).then_some(bytes)
}

#[cfg(test)]
mod tests {
    use std::fmt::Debug;

    use super::*;
    use crate::{
        app::{
            App, Command,
            design::{front::front_ask, wish::MixWish},
            memo::ByAddress,
            studies::Field,
        },
        study::Goal,
    };

    /// A light of one's own, so that it crosses by its numbers.
    fn own_light() -> App {
        let mut app = App::new();
        let mut light = app.document().light.spectrum.clone();
        light.name = "Mine".to_owned();
        app.apply(Command::Adopt(vec![light]));
        let mine = app.document().own[0].clone();
        app.apply(Command::Show(mine));
        app
    }

    fn across<Q: Question>(question: &Q) -> Q::Answer {
        let crossing = Q::crossing().expect("a kind that crosses");
        let bytes = (crossing.asked)(question).expect("JSON");
        let answer = answered(crossing.kind, &bytes, &Progress::default());
        let found = (crossing.found)(&answer.expect("of a kind that is known"));
        found.expect("JSON").expect("an answer")
    }

    fn is_answered_alike<Q: Question<Answer: PartialEq + Debug>>(question: &Q) {
        let here = question.answer(&Progress::default()).expect("an answer");
        assert_eq!(across(question), here);
    }

    #[test]
    fn what_crosses_is_answered_as_it_is_here() {
        let app = own_light();
        let document = app.document();
        is_answered_alike(&SweepAsk {
            highest_order: 6,
            ..SweepAsk::of(document)
        });
        is_answered_alike(&AuctionAsk::of(document, Goal::PATCHES, 9));
        let one = || Field::These(document.own.iter().cloned().map(ByAddress).collect());
        is_answered_alike(&ManyAsk::of(document, one()));
        let keys = [document.light.key.clone(), app.bundled()[0].key.clone()];
        is_answered_alike(&LightsQualityAsk::of(&app, &keys));
        let front = front_ask(&MixWish::default(), document).expect("a colour");
        is_answered_alike(&FrontProblem { points: 2, ..front });

        // What takes how long is measured anew each time.
        let race = RaceAsk::of(document, one(), vec![9]);
        let here = race.answer(&Progress::default()).expect("an answer");
        let found = across(&race);
        assert_eq!((&found.lamps, &found.racers), (&here.lamps, &here.racers));
        for racer in 0..here.racers.len() {
            assert_eq!(found.run(0, 0, racer), here.run(0, 0, racer));
        }
    }

    #[test]
    fn what_is_no_question_of_a_kind_is_left_to_who_asked() {
        assert_eq!(answered("sweep", b"{}", &Progress::default()), None);
        assert_eq!(answered("poem", b"null", &Progress::default()), None);
    }
}
