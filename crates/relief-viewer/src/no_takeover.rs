//! What stands in the places of a takeover by the GPU in builds without it: nothing ever takes over.

use relief_maps::Maps;
use relief_render::{RenderError, RenderInfo, Renderer};
use relief_scene::Scene;

#[derive(Clone, Debug, Default)]
pub struct Device(());

#[derive(Debug)]
pub struct Takeover;

#[derive(Debug)]
pub enum Taken {}

/// Work in the background, of which there is none in this build.
#[derive(Debug)]
pub enum Warming {}

impl Takeover {
    pub fn new(_: Device) -> Self {
        Self
    }

    pub fn draws(&self, _: &Scene) -> bool {
        false
    }

    pub fn take(&self, _: &Scene) -> Option<Taken> {
        None
    }

    pub fn give_back(&self, taken: Taken, _: &Scene, _: Option<&RenderInfo>) {
        match taken {}
    }

    pub fn fail(&self, taken: Taken, _: &RenderError) {
        match taken {}
    }

    pub fn cpu_drew(&mut self, _: &Scene, _: &RenderInfo) {}

    pub fn warming(&self, _: &Scene, _: &Maps) -> Option<Warming> {
        None
    }
}

impl Taken {
    pub fn renderer(&mut self) -> &mut Renderer {
        match *self {}
    }
}

impl Warming {
    /// Does the work.
    pub async fn run(self) {
        match self {}
    }
}
