//! Broken and unusual mesh files, with the expected results.

use std::time::{Duration, Instant};

use relief_core::mesh::{FramingError, Mesh, MeshError, UvProjection};
use relief_io::{MeshFile, MeshOptions, ReadError, ReadProblem, Source, read_mesh};

/// Memory limit that is enough for every small file.
const LIMIT: u64 = 64 << 20;

/// Expected result of reading a file.
pub enum Right {
    /// A problem of this kind.
    Refused(fn(&ReadProblem) -> bool),
    /// A mesh with numbers of triangles, of degenerate ones and of double ones.
    Mesh(usize, usize, usize),
}

/// File with the expected result.
pub struct Case {
    pub what: &'static str,
    pub name: &'static str,
    pub bytes: Vec<u8>,
    pub right: Right,
}

pub fn case(what: &'static str, name: &'static str, bytes: impl AsRef<[u8]>, right: Right) -> Case {
    Case { what, name, bytes: bytes.as_ref().to_vec(), right }
}

pub fn is_damaged(problem: &ReadProblem) -> bool {
    matches!(problem, ReadProblem::Damaged { .. })
}

pub fn is_unsupported(problem: &ReadProblem) -> bool {
    matches!(problem, ReadProblem::Unsupported { .. })
}

pub fn is_outside(problem: &ReadProblem) -> bool {
    matches!(problem, ReadProblem::OutsideFolder { .. })
}

pub fn is_too_large(problem: &ReadProblem) -> bool {
    matches!(problem, ReadProblem::MeshMemory { .. })
}

pub fn has_no_uv(problem: &ReadProblem) -> bool {
    matches!(problem, ReadProblem::Mesh(FramingError::NoTextureCoordinates { .. }))
}

pub fn has_no_texture_area(problem: &ReadProblem) -> bool {
    matches!(problem, ReadProblem::Mesh(FramingError::NoTextureArea { .. }))
}

pub fn has_short_tiles(problem: &ReadProblem) -> bool {
    matches!(problem, ReadProblem::Mesh(FramingError::Mesh(MeshError::ShortTile(_))))
}

pub fn has_no_triangles(problem: &ReadProblem) -> bool {
    matches!(problem, ReadProblem::Mesh(FramingError::NoTriangles))
}

pub fn has_bad_number(problem: &ReadProblem) -> bool {
    matches!(problem, ReadProblem::Mesh(FramingError::BadNumber { .. }))
}

pub fn read(name: &str, bytes: &[u8]) -> Result<MeshFile, ReadError> {
    let start = Instant::now();
    let options = MeshOptions { max_bytes: LIMIT, colors: true, ..MeshOptions::default() };
    let read = read_mesh(Source::bytes(name, bytes), &options);
    for projection in UvProjection::ALL {
        // Projections supply missing texture coordinates, unless all triangles are seen edge-on.
        let projected = MeshOptions { projection: Some(projection), ..options };
        let projected = read_mesh(Source::bytes(name, bytes), &projected);
        let is_edge = |error: &ReadError| has_no_texture_area(&error.problem);
        assert!(read.is_err() || projected.as_ref().err().is_none_or(is_edge), "{name}: {projected:?}");
        projected.iter().for_each(|file| assert_sound(&file.mesh));
    }
    assert!(start.elapsed() < Duration::from_secs(20), "{name} takes too long");
    if let Ok(file) = &read {
        assert_sound(&file.mesh);
        file.mesh.measures();
    }
    if let Err(error) = &read {
        assert!(error.to_string().starts_with(&format!("{name}: ")), "{error}");
        assert!(error.to_string().len() < 600, "{error}");
        assert!(!matches!(error.problem, ReadProblem::OutOfMemory { .. }), "{error}");
    }
    read
}

/// Fails unless displacement can be computed in all frames. (Constructors of meshes check that
/// numbers are finite and indices are in range.)
fn assert_sound(mesh: &Mesh) {
    assert!(!mesh.triangles().is_empty());
    for vertex in mesh.vertices() {
        assert!((vertex.normal.length() - 1.0).abs() < 1e-5, "{vertex:?}");
        assert!(vertex.tangent.length() > 0.0 && vertex.bitangent.length() > 0.0, "{vertex:?}");
    }
}

pub fn assert_right(cases: Vec<Case>) {
    for Case { what, name, bytes, right } in cases {
        match (read(name, &bytes), right) {
            (Ok(file), Right::Mesh(triangles, degenerate, double)) => {
                let found = (file.mesh.triangles().len(), file.degenerate, file.double);
                assert_eq!(found, (triangles, degenerate, double), "{what}");
            }
            (Err(error), Right::Refused(is_right)) => assert!(is_right(&error.problem), "{what}: {error}"),
            (Ok(_), Right::Refused(_)) => panic!("{what} is read"),
            (Err(error), Right::Mesh(..)) => panic!("{what}: {error}"),
        }
    }
}
