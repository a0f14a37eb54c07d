//! Methods beside the truth: where their rays end, what they cost, how they are compared.

mod compare;
mod compare_axes;
mod cost;
mod curved;
mod edges;
mod exact_agreement;
mod exact_robustness;
mod explain;
mod filter_volume;
mod levels;
mod limits;
mod motifs;
mod nearest;
mod procedures;
mod quadric;
mod search_over_a_map;
mod survey;
mod translucent;
mod volumes;
