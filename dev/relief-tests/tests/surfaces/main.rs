//! Surfaces and objects beside the truth: shells, slices, silhouettes.

mod depth_objects;
mod impostors;
mod object_slices;
mod objects;
mod quadric_pictures;
mod shells;
mod slices;
mod surfaces_of_both;
mod vertex_family;
