// figure data: written by the helper plot
//! What the thesis' figures show, as curves.
