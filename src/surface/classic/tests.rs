//! What the classic algorithm does, and where it goes wrong. Robust numerics do not; their own
//! tests say so.
