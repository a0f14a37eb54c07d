//! A plane drawn by a Custom node's code, as a material of Unreal would draw it.

use glam::{Vec2, Vec3};
use relief_export::{ExportedFunctions, unreal_node};
use relief_render::job::JobSurface;
use relief_render::wgpu::{self, TextureFormat, TextureViewDimension};

use super::Device;
use super::bound::{texels_of, view_of};
use super::drawn::picture;
use super::include::{Include, compiled};
use super::numbers::Point;

/// Columns and rows of a picture.
const SIDE: u32 = 64;

/// A plane through the origin, seen from above, with a sun.
#[derive(Clone, Copy, Debug)]
pub struct Plane {
    /// Unit directions along +u and +v, at a right angle.
    pub along: [Vec3; 2],
    /// The side that is seen.
    pub normal: Vec3,
    /// Lengths of a tile.
    pub tile: Vec2,
    /// Place of the camera, which looks at the origin.
    pub eye: Vec3,
    /// Unit direction toward the sun.
    pub sun: Vec3,
}

/// What a pixel of the plane gives.
#[derive(Clone, Copy, Debug)]
pub struct Sight {
    /// Texture coordinates of the hit.
    pub uv: Vec2,
    /// The relief's normal in the world.
    pub bent: Vec3,
    /// 1 where the ray hits.
    pub mask: f32,
    /// How far the hit is behind the mesh along the view axis.
    pub depth_offset: f32,
    /// The part of the sun that arrives.
    pub light: f32,
}

impl Plane {
    /// Right, up, and the unit view axis, which goes through the origin.
    fn camera(&self) -> [Vec3; 3] {
        let forward = -self.eye.normalize();
        let right = forward.cross(Vec3::Z).normalize();
        [right, right.cross(forward), forward]
    }

    /// The points of all pixels, row by row, each with its ray and its depth along the view axis.
    pub fn points(&self) -> Vec<(Point, Vec3, f32)> {
        let [right, up, forward] = self.camera();
        let across = |pixel: u32| (2.0 * pixel as f32 + 1.0) / SIDE as f32 - 1.0;
        let point = |number: u32| {
            let [x, y] = [across(number % SIDE), -across(number / SIDE)];
            let ray = forward + 0.5 * (right * x + up * y);
            let depth = -self.eye.dot(self.normal) / ray.dot(self.normal);
            let way = ray * depth;
            let place = self.eye + way;
            let frame = |v: Vec3| [v.dot(self.along[0]), v.dot(self.along[1]), v.dot(self.normal)];
            let uv = Vec2::from(self.along.map(|along| place.dot(along))) / self.tile;
            let point = Point {
                uv: uv.to_array(),
                view: frame(way.normalize()),
                tile: self.tile.to_array(),
                curvature: [0.0; 3],
                footprint: 0.0,
                toward: frame(self.sun),
            };
            (point, way, depth)
        };
        (0..SIDE * SIDE).map(point).collect()
    }

    /// The vertex shader of a triangle in the plane that covers the picture.
    fn vertices(&self) -> String {
        let [right, up, forward] = self.camera();
        let of = |v: Vec3| format!("vec3f({:?}, {:?}, {:?})", v.x, v.y, v.z);
        let [u, v, n, eye, sun] = [self.along[0], self.along[1], self.normal, self.eye, self.sun].map(of);
        let [right, up, forward] = [2.0 * right, 2.0 * up, forward].map(of);
        let Vec2 { x, y } = self.tile;
        format!(
            "struct Out {{\n    @builtin(position) clip: vec4f,\n    @location(0) uv: vec2f,\n    \
             @location(1) way: vec3f,\n    @location(2) normal: vec3f,\n    @location(3) depth: f32,\n    \
             @location(4) sun: vec3f,\n}}\n\n\
             @vertex\nfn main(@builtin(vertex_index) index: u32) -> Out {{\n    \
             let corner = 40.0 * vec2f(f32(index / 2u), f32(index % 2u)) - 10.0;\n    \
             let way = {u} * corner.x * {x:?} + {v} * corner.y * {y:?} - {eye};\n    \
             let depth = dot(way, {forward});\n    \
             let clip = vec4f(dot(way, {right}), dot(way, {up}), 0.5 * depth, depth);\n    \
             return Out(clip, corner, way, {n}, depth, {sun});\n}}\n"
        )
    }
}

impl Device {
    /// Draws a plane by the code of a node. The second file of the export is the include.
    ///
    /// # Panics
    ///
    /// When the code does not compile.
    pub fn seen_by_node(
        &self,
        exported: &ExportedFunctions,
        surface: &JobSurface,
        plane: &Plane,
    ) -> Vec<Sight> {
        let include = String::from_utf8(exported.files[1].bytes.clone()).expect("a text");
        let include = Include::new(&include);
        let code = unreal_node(&exported.manifest, [1.0, 1.0]);
        let shown = ["float4(at, offset, mask)", "float4(bent, light)"].map(|shown| {
            let text = include.in_node(&code, surface.settings.scale_m, shown);
            let words = compiled(&text, "frag").unwrap_or_else(|error| panic!("{error}"));
            self.drawn_plane(exported, surface, plane, &words)
        });
        let sight = |(at, bent): (&[f32; 4], &[f32; 4])| Sight {
            uv: Vec2::new(at[0], at[1]),
            bent: Vec3::new(bent[0], bent[1], bent[2]),
            mask: at[3],
            depth_offset: at[2],
            light: bent[3],
        };
        shown[0].iter().zip(&shown[1]).map(sight).collect()
    }

    fn drawn_plane(
        &self,
        exported: &ExportedFunctions,
        surface: &JobSurface,
        plane: &Plane,
        words: &[u8],
    ) -> Vec<[f32; 4]> {
        let Self { device, queue } = self;
        let view = |name: &str| {
            let name = name.trim_start_matches("relief_");
            view_of(device, queue, &texels_of(name, surface), TextureViewDimension::D2)
        };
        let bindings = &exported.manifest.bindings;
        let views: Vec<_> = bindings.iter().map(|bound| (bound.binding, view(&bound.name))).collect();
        let laid_out = |(binding, _): &(u32, wgpu::TextureView)| wgpu::BindGroupLayoutEntry {
            binding: *binding,
            visibility: wgpu::ShaderStages::FRAGMENT,
            ty: wgpu::BindingType::Texture {
                sample_type: wgpu::TextureSampleType::Float { filterable: false },
                view_dimension: TextureViewDimension::D2,
                multisampled: false,
            },
            count: None,
        };
        let entries: Vec<_> = views.iter().map(laid_out).collect();
        let group = device
            .create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor { label: None, entries: &entries });
        let entries = views.iter().map(|(binding, view)| wgpu::BindGroupEntry {
            binding: *binding,
            resource: wgpu::BindingResource::TextureView(view),
        });
        let entries: Vec<_> = entries.collect();
        let bound = device.create_bind_group(&wgpu::BindGroupDescriptor {
            label: None,
            layout: &group,
            entries: &entries,
        });
        let layout = device.create_pipeline_layout(&wgpu::PipelineLayoutDescriptor {
            label: None,
            bind_group_layouts: &[Some(&group)],
            immediate_size: 0,
        });
        let [vertex, fragment] = [self.wgsl(plane.vertices().as_bytes()), self.spirv(words, "main")];
        let pipeline = device.create_render_pipeline(&wgpu::RenderPipelineDescriptor {
            label: None,
            layout: Some(&layout),
            vertex: wgpu::VertexState {
                module: &vertex,
                entry_point: Some("main"),
                compilation_options: Default::default(),
                buffers: &[],
            },
            primitive: wgpu::PrimitiveState::default(),
            depth_stencil: Some(wgpu::DepthStencilState {
                format: TextureFormat::Depth32Float,
                depth_write_enabled: Some(true),
                depth_compare: Some(wgpu::CompareFunction::Less),
                stencil: Default::default(),
                bias: Default::default(),
            }),
            multisample: Default::default(),
            fragment: Some(wgpu::FragmentState {
                module: &fragment,
                entry_point: Some("main"),
                compilation_options: Default::default(),
                targets: &[Some(TextureFormat::Rgba32Float.into())],
            }),
            multiview_mask: None,
            cache: None,
        });
        picture(self, &pipeline, &[bound], [3, 1], [SIDE, SIDE])
    }
}
