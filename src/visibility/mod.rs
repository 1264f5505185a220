//! Visibility: the nearest hit of a ray, and the occluders between a surface and a light.
//!
//! A light is a point or a lamp; both are [`LightView`]s, and a point is a lamp whose hull has one
//! point. An *occluder* is a surface that can cast a shadow, a *receiver* one that a shadow can
//! fall on, and *transmittance* is the share of light that passes all occluders.

mod accelerator;
mod border_planes;
mod carriers;
mod light_cone;
mod light_view;
mod node;
mod occluder_bound;
mod occluder_distance;
mod occluder_tree;
mod occlusion;
mod overlaps;
mod padded_bounds;
mod primitive;
mod ray_slabs;
mod screen_bounds;
mod separating_plane;
mod shadow_rect;
mod silhouette;
mod split;
mod surface_list;
mod transmittance;
mod tree;

pub use accelerator::Accelerator;
pub use carriers::carriers;
pub use light_view::{Emitter, LightView, MOST_LISTS, Receiver};
pub use occlusion::{Occluders, Occlusion};
pub use overlaps::Overlaps;
pub use padded_bounds::shared_border_error;
pub use primitive::Primitive;
pub use screen_bounds::{ScreenBounds, Visible};
pub use silhouette::{Silhouette, Silhouettes};
pub use surface_list::SurfaceList;
