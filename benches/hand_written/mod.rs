//! The closed form written by hand in C, built by gcc for this machine and loaded.

use std::path::Path;
use std::process::Command;

use libloading::Library;
use sextic_evaluators::closed_form::{ClosedFormSlices, ClosedFormSlicesMut};

type Function = unsafe extern "C" fn(
    usize,
    *const f64,
    *const f64,
    *const f64,
    *const f64,
    *const f64,
    *const f64,
    *const f64,
    *const f64,
    *const f64,
    *const f64,
    *const f64,
    *const f64,
    *const f64,
    *const f64,
    *const f64,
    *const f64,
    *const f64,
    *mut f64,
    *mut f64,
    *mut f64,
);

/// `benches/peers/closed_form.c`, ready to be called.
pub struct HandWritten {
    function: Function,
    // The function lives as long as its library.
    _library: Library,
}

impl HandWritten {
    /// None, with a word about it, where gcc does not run.
    pub fn build(options: &[&str]) -> Option<Self> {
        let source = Path::new(env!("CARGO_MANIFEST_DIR")).join("benches/peers/closed_form.c");
        let name = format!("closed_form{}.so", options.concat());
        let built = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
        let status = Command::new("gcc")
            .args(options)
            .args(["-shared", "-fPIC", "-o"])
            .args([&built, &source])
            .status();
        if !status.is_ok_and(|status| status.success()) {
            println!("gcc does not run here: nothing to compare the closed form with");
            return None;
        }
        // SAFETY: the library was just built from that file, which runs nothing when it is loaded and has
        // this function of this type.
        unsafe {
            let library = Library::new(&built).unwrap();
            let function = *library.get::<Function>(b"closed_form\0").unwrap();
            Some(HandWritten {
                function,
                _library: library,
            })
        }
    }

    /// The closed form at all points.
    pub fn run(&self, inputs: &ClosedFormSlices<'_>, outputs: &mut ClosedFormSlicesMut<'_>) {
        let points = inputs.m.len();
        macro_rules! call {
            ($($input:ident)*; $($output:ident)*) => {{
                $(assert_eq!(inputs.$input.len(), points);)*
                $(assert_eq!(outputs.$output.len(), points);)*
                // SAFETY: all slices have this length, and those that are written are borrowed alone.
                unsafe {
                    (self.function)(
                        points,
                        $(inputs.$input.as_ptr(),)*
                        $(outputs.$output.as_mut_ptr(),)*
                    );
                }
            }};
        }
        call!(m r L_g cos_alpha_g_plus_theta_0 sin_alpha_g_plus_theta_0 rho D U
              S_xx S_xy S_yx S_yy S_xt S_yt S_tx S_ty S_tt; lamda_R1 lamda_R2 lamda_R3);
    }
}
