//! What people and tests call the controls of the page Gem.

pub const MATERIAL: &str = later!("Made of");
pub const COLOUR: &str = later!("Colour");
pub const FILTER: &str = later!("Filter");
pub const THICKNESS: &str = later!("as thick as");
pub const ABSORBS: &str = later!("Takes away");
pub const SEEN: &str = later!("How gems are seen");
pub const PART: &str = later!("Under");
pub const SIZE: &str = later!("Picture");
pub const RAYS: &str = later!("Rays a pixel");
pub const UNDER: &str = later!("Also under");
pub const NO_OTHER: &str = later!("one light");
pub const USUAL_CUT: &str = later!("usual cut");
pub const FRONT: &str = later!("from the front");
pub const PNG: &str = later!("Save PNG…");
pub const EXR: &str = later!("Save OpenEXR…");
