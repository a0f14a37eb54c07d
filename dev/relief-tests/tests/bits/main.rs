//! Both backends and all lanes give the same bits.

mod lane_pixels;
mod lane_stages;
mod lanes;
mod one_source;
mod packets;
mod same_bits;
