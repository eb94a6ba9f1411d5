//! What people and tests call the controls of the page Gem.

pub const MATERIAL: &str = "Made of";
pub const COLOUR: &str = "Colour";
pub const FILTER: &str = "Filter";
pub const THICKNESS: &str = "as thick as";
pub const ABSORBS: &str = "Takes away";
pub const SEEN: &str = "How gems are seen";
pub const PART: &str = "Under";
pub const SIZE: &str = "Picture";
pub const RAYS: &str = "Rays a pixel";
pub const UNDER: &str = "Also under";
pub const NO_OTHER: &str = "one light";
pub const USUAL_CUT: &str = "usual cut";
pub const FRONT: &str = "from the front";
pub const PNG: &str = "Save PNG\u{2026}";
pub const EXR: &str = "Save OpenEXR\u{2026}";
