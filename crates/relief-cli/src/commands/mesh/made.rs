//! Makes the mesh while it is written.

use std::convert::Infallible;
use std::io;
use std::path::Path;
use std::sync::atomic::{AtomicBool, Ordering};

use relief_io::{MeshCounts, MeshFormat, write_mesh};
use relief_mesh::{Mesher, Stream, StreamError, Streamed};

use crate::failure::Failure;
use crate::interrupt::cancelled;
use crate::progress::Progress;

/// A file to be written.
pub struct Output<'a> {
    /// Its name.
    pub path: &'a Path,
    /// Where it is until it takes that.
    pub aside: &'a Path,
    pub format: MeshFormat,
    pub counts: MeshCounts,
}

impl Output<'_> {
    /// Makes and writes the mesh, as long as `print_m` metres if that is given.
    pub fn write(
        &self,
        mesher: &Mesher,
        print_m: Option<f64>,
        is_quiet: bool,
        cancel: &AtomicBool,
    ) -> Result<Streamed, Failure> {
        let size = match print_m {
            Some(length) => length / self.length(mesher, is_quiet, cancel)?,
            None => 1.0,
        };
        let bar = Progress::bar("meshing", is_quiet);
        let tell = |part: f32| bar.show(part);
        let how = Stream { size, check: true, tell: &tell, cancel };
        let mut made = None;
        let written = write_mesh(self.aside, self.format, self.counts, |sink| {
            match mesher.stream(&how, |block| sink(block)) {
                Ok(streamed) => {
                    made = Some(Ok(streamed));
                    Ok(())
                }
                Err(StreamError::Sink(error)) => Err(error),
                Err(error) => {
                    let text = error.to_string();
                    made = Some(Err(error));
                    Err(io::Error::other(text))
                }
            }
        });
        if cancel.load(Ordering::Relaxed) {
            return Err(cancelled());
        }
        let name = self.path.display();
        match (made, written) {
            (Some(Err(error)), _) => Err(Failure::Work(format!("{name}: {error}: a smaller --scale helps"))),
            (_, Err(error)) => Err(Failure::Work(format!("{name}: {}", error.problem))),
            (Some(Ok(streamed)), Ok(())) => Ok(streamed),
            (None, Ok(())) => Err(Failure::Work(format!("{name}: nothing was written"))),
        }
    }

    /// The longest side of the mesh in metres.
    fn length(&self, mesher: &Mesher, is_quiet: bool, cancel: &AtomicBool) -> Result<f64, Failure> {
        let bar = Progress::bar("measuring", is_quiet);
        let tell = |part: f32| bar.show(part);
        let how = Stream { size: 1.0, check: false, tell: &tell, cancel };
        let measured = mesher.stream(&how, |_| Ok::<(), Infallible>(()));
        let [least, greatest] = match measured {
            Ok(streamed) => streamed.bounds_m,
            Err(StreamError::Cancelled) => return Err(cancelled()),
            Err(error) => return Err(Failure::Work(format!("{}: {error}", self.path.display()))),
        };
        let length = f64::from((greatest - least).max_element());
        if length > 0.0 {
            return Ok(length);
        }
        Err(Failure::Work(format!("{}: the mesh is a point, which has no size", self.path.display())))
    }
}
