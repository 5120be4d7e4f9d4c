//! The f64 reference of every model, written from the papers.
