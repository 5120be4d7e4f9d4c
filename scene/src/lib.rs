//! Scene and material files, and what they become: constants for the core.
