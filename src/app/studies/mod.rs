//! Long computations about the document: sweep, auction and race, each a job with progress,
//! cancel, and a result that stays while the next is computed.

mod about;
mod field;
mod job;
mod lamps;
pub mod paper;
mod relit;
mod surfaces;
pub mod take;

use about::measures;
pub use about::{About, Patches, reflectances};
pub use field::{CHECK_SET, Class, Field, RaceAsk};
pub use job::{Job, Stage, Wake, Work};
pub use lamps::{EncodeAsk, EncodedLight, most_numbers};
pub use relit::{RelitJobs, RelitShown};
pub use surfaces::{Pairs, PairsAsk, RankAsk, Ranked, Surface, Surfaces, shipped_reflectances};
pub use take::take;

use std::path::PathBuf;

use super::{
    charts::products::bounces::Bounced,
    design::photo::Photo,
    dispersion::{GemFilm, GemPass, NoiseAsk},
    document::Document,
    lessons::{Trial, TrialAsk},
    memo::ByAddress,
    pages::FieldChoice,
    picture::{Raster, RasterAsk, RegionAsk, RegionSpectrum},
    tables::CURVE_ORDER,
};
use crate::{
    design::solve::{FrontPoint, FrontWish},
    lamps::bell,
    optics::Noise,
    spectrum::{Basis, Kind},
    study::{
        Auction, Goal, ManyLights, Progress, Race, Subject, Sweep,
        auction::{self, Terms},
        products::{ProductTime, Sizes, product_times},
        quality::OrderFigures,
        race,
    },
};

/// What a sweep is about.
#[derive(Clone, Debug, PartialEq)]
pub struct SweepAsk {
    /// The spectrum and its measures.
    pub about: About,
    /// Basis of the threshold map.
    pub basis: Basis,
    /// Fit of the threshold map.
    pub colour_exact: bool,
    /// Highest order.
    pub highest_order: usize,
}

impl SweepAsk {
    /// The sweep of a document: to the order curve's end, or to the order in force beyond it.
    pub fn of(document: &Document) -> Self {
        let settings = document.settings;
        Self {
            about: About::of(document),
            basis: settings.basis,
            colour_exact: settings.colour_exact,
            highest_order: CURVE_ORDER.max(settings.effective_order()),
        }
    }

    /// The answer; `None` when there is none or it was cancelled.
    pub fn answer(&self, progress: &Progress) -> Option<Sweep> {
        Sweep::of(
            &self.about.subject(),
            self.highest_order,
            self.basis,
            self.colour_exact,
            progress,
        )
    }
}

/// What error against order of many lights is about: who, and on what, as in a race.
#[derive(Clone, Debug, PartialEq)]
pub struct ManyAsk(pub RaceAsk);

impl ManyAsk {
    /// These lights under a document's settings.
    pub fn of(document: &Document, field: Field) -> Self {
        Self(RaceAsk::of(document, field, Vec::new()))
    }

    /// The answer; `None` when no light shines or it was cancelled.
    pub fn answer(&self, progress: &Progress) -> Option<ManyLights> {
        let Self(of) = self;
        let measures = measures(&of.patch_set, of.band, of.observer);
        ManyLights::of(&measures, of.spikes, &of.lamps(), CURVE_ORDER, progress)
    }
}

/// What an auction is about.
#[derive(Clone, Debug, PartialEq)]
pub struct AuctionAsk {
    /// The spectrum and its measures.
    pub about: About,
    /// Basis, fit, goal and budget.
    pub terms: Terms,
}

impl AuctionAsk {
    /// The auction of a document's subject with its basis and fit.
    pub fn of(document: &Document, goal: Goal, numbers: usize) -> Self {
        let settings = document.settings;
        Self {
            about: About::of(document),
            terms: Terms {
                basis: settings.basis,
                colour_exact: settings.colour_exact,
                goal,
                numbers,
            },
        }
    }

    /// The answer; `None` when there is none or it was cancelled.
    pub fn answer(&self, progress: &Progress) -> Option<Auction> {
        let subject = Subject {
            bell: Some(bell),
            ..self.about.subject()
        };
        auction::hold(&subject, self.terms, progress)
    }
}

impl FieldChoice {
    /// The lights of the choice in a document.
    pub fn field(self, document: &Document) -> Field {
        match self {
            Self::ThisLight => Field::One(ByAddress(document.light.clone())),
            Self::Shipped => Field::Shipped,
            Self::Smooth => Field::Class(Class::Smooth),
            Self::Led => Field::Class(Class::Led),
            Self::Fluorescent => Field::Class(Class::Fluorescent),
            Self::Discharge => Field::Class(Class::Discharge),
            Self::Own => Field::These(
                document
                    .own
                    .iter()
                    .filter(|entry| entry.kind() == Kind::Light)
                    .map(|entry| ByAddress(entry.clone()))
                    .collect(),
            ),
        }
    }
}

impl RaceAsk {
    /// The answer; `None` when no light shines or it was cancelled.
    pub fn answer(&self, progress: &Progress) -> Option<Race> {
        race::run(&self.course(), &self.lamps(), progress)
    }
}

/// What the times of products are about.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TimingAsk {
    /// How large the products are.
    pub sizes: Sizes,
    /// Which measurement it is: asking again is another one.
    pub turn: u32,
}

impl TimingAsk {
    /// The answer; `None` when it was cancelled.
    pub fn answer(&self, progress: &Progress) -> Option<Vec<ProductTime>> {
        product_times(self.sizes, progress)
    }
}

/// All jobs of a window.
#[derive(Default)]
pub struct Studies {
    /// Error against numbers.
    pub sweep: Job<SweepAsk, Sweep>,
    /// Error against order of many lights.
    pub many: Job<ManyAsk, ManyLights>,
    /// The auction's page.
    pub auction: Job<AuctionAsk, Auction>,
    /// The race.
    pub race: Job<RaceAsk, Race>,
    /// The light in few words, or why there are none.
    pub encoded: Job<EncodeAsk, Result<EncodedLight, String>>,
    /// Searches of the library's surfaces.
    pub surfaces: Surfaces,
    /// What one product takes.
    pub timing: Job<TimingAsk, Vec<ProductTime>>,
    /// Error against bounces, by the program's revision.
    pub bounces: Job<u64, Bounced>,
    /// Light quality against the order, by the program's revision.
    pub quality: Job<u64, OrderFigures>,
    /// What lines reach at best.
    pub front: Job<FrontWish, Result<Vec<FrontPoint>, String>>,
    /// A picture of colours.
    pub photo: Job<PathBuf, Result<Photo, String>>,
    /// The picture of a spectral image.
    pub raster: Job<RasterAsk, Raster>,
    /// The chosen spectrum of it with its model.
    pub region: Job<RegionAsk, RegionSpectrum>,
    /// The film of a gem.
    pub gem: Job<GemPass, GemFilm>,
    /// How noisy its picture is.
    pub gem_noise: Job<NoiseAsk, Noise>,
    /// A picture in few numbers, under a light.
    pub relit: RelitJobs,
    /// A lesson tried on another light.
    pub trial: Job<TrialAsk, Trial>,
}

impl Studies {
    fn all(&mut self) -> Vec<&mut dyn Work> {
        let Self {
            sweep,
            many,
            auction,
            race,
            encoded,
            surfaces,
            timing,
            bounces,
            quality,
            front,
            photo,
            raster,
            region,
            gem,
            gem_noise,
            relit,
            trial,
        } = self;
        let Surfaces { pairs, ranking } = surfaces;
        let RelitJobs {
            look,
            fit,
            turn,
            store,
            peers,
        } = relit;
        vec![
            sweep, many, auction, race, encoded, pairs, ranking, timing, bounces, quality, raster,
            region, gem, gem_noise, look, fit, turn, store, peers, front, trial, photo,
        ]
    }

    /// Takes in what is finished.
    pub fn take_in(&mut self) {
        self.all().into_iter().for_each(|job| job.take_in());
    }

    /// Whether anything is being computed.
    pub fn is_running(&mut self) -> bool {
        self.all().into_iter().any(|job| job.is_running())
    }

    /// Waits for everything.
    pub fn finish(&mut self) {
        self.all().into_iter().for_each(|job| job.finish());
    }
}
