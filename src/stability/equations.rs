//! The equations of motion of a section, M q̈ + (C_s + C_a) q̇ + (K + K_a) q = 0, as they were derived and compiled.

use sextic_codegen::arithmetic::Arithmetic as Numbers;
use sextic_evaluators::aerodynamic_damping::aerodynamic_damping_body;
use sextic_evaluators::arithmetic::Arithmetic;
use sextic_evaluators::no_wind_modes::no_wind_modes_body;
use sextic_evaluators::section_matrices::section_matrices_body;
use sextic_evaluators::turn_stiffness::turn_stiffness_body;

use super::forces::{Forces, Matrix};
use super::given::Given;
use super::recorded::{self, Recorded};

/// The matrices of a section over its mass m, for x, y and rθ (`derivations/exact-modes.md`).
#[derive(Clone, Debug)]
pub(super) struct Equations<T> {
    /// M/m, Eq. (9).
    pub mass: Matrix<T>,
    /// C_s/m, Eq. (9).
    pub structural_damping: Matrix<T>,
    /// C_a/m, Eqs. (12), (17) and (18).
    pub aerodynamic_damping: Matrix<T>,
    /// K/m, Eq. (9).
    pub stiffness: Matrix<T>,
    /// K_a/m (`derivations/extensions.md`, section 3): 0 unless the parameters ask for it, since the paper leaves it
    /// out.
    pub aerodynamic_stiffness: Matrix<T>,
}

impl<T: Arithmetic> Given<T> {
    /// The matrices.
    pub fn equations(&self) -> Equations<T> {
        let own = section_matrices_body(&self.section_matrices_inputs(&self.scaled_damping()));
        let [k_x, k_y, k_t] = self.turn_stiffness();
        let zero = T::constant(0.0);
        Equations {
            mass: [
                [own.M_11, own.M_12, own.M_13],
                [own.M_21, own.M_22, own.M_23],
                [own.M_31, own.M_32, own.M_33],
            ],
            structural_damping: [
                [own.C_s_11, own.C_s_12, own.C_s_13],
                [own.C_s_21, own.C_s_22, own.C_s_23],
                [own.C_s_31, own.C_s_32, own.C_s_33],
            ],
            aerodynamic_damping: [
                [own.C_a_11, own.C_a_12, own.C_a_13],
                [own.C_a_21, own.C_a_22, own.C_a_23],
                [own.C_a_31, own.C_a_32, own.C_a_33],
            ],
            stiffness: [
                [own.K_11, own.K_12, own.K_13],
                [own.K_21, own.K_22, own.K_23],
                [own.K_31, own.K_32, own.K_33],
            ],
            aerodynamic_stiffness: [k_x, k_y, k_t].map(|turn| [zero, zero, turn]),
        }
    }

    /// The squares of the circular frequencies without wind if ω_n is the natural frequency of all motions, Eq. (15).
    pub fn squares_without_wind(&self, omega_n: T) -> [T; 3] {
        let own = no_wind_modes_body(&self.no_wind_modes_inputs(omega_n));
        [own.Omega_1, own.Omega_2, own.Omega_3]
    }

    /// S_a, Eq. (18): as it is given, or from the coefficients.
    pub fn scaled_damping(&self) -> Matrix<T> {
        let c = match &self.parameters.forces {
            Forces::ScaledDamping(rows) => return *rows,
            Forces::Coefficients(c) => c,
        };
        let own = aerodynamic_damping_body(&self.aerodynamic_damping_inputs(c));
        [
            [own.S_xx, own.S_xy, own.S_xt],
            [own.S_yx, own.S_yy, own.S_yt],
            [own.S_tx, own.S_ty, own.S_tt],
        ]
    }

    /// The column of the turn in K_a over the mass.
    fn turn_stiffness(&self) -> [T; 3] {
        let p = &self.parameters;
        let (Forces::Coefficients(c), true) = (&p.forces, p.aerodynamic_stiffness) else {
            return [T::constant(0.0); 3];
        };
        let own = turn_stiffness_body(&self.turn_stiffness_inputs(c));
        [own.K_xtheta, own.K_ytheta, own.K_thetatheta]
    }
}

impl<T: Clone> Given<T> {
    /// The matrices in an arithmetic that emitted functions do not know.
    ///
    /// # Errors
    ///
    /// Those of the arithmetic.
    pub fn equations_in<A: Numbers<Value = T>>(
        &self,
        arithmetic: &mut A,
    ) -> Result<Equations<T>, A::Error> {
        let entries = self.run(arithmetic, |given| given.equations().into_entries())?;
        Ok(Equations::from_entries(entries))
    }

    /// K and K_a over the mass, in such an arithmetic: nothing is computed of the damping.
    ///
    /// # Errors
    ///
    /// Those of the arithmetic.
    pub fn stiffness_in<A: Numbers<Value = T>>(
        &self,
        arithmetic: &mut A,
    ) -> Result<[Matrix<T>; 2], A::Error> {
        let entries = self.run(arithmetic, |given| {
            let own = given.equations();
            [own.stiffness, own.aerodynamic_stiffness]
                .into_iter()
                .flatten()
                .flatten()
                .collect()
        })?;
        let mut entries = entries.into_iter();
        Ok([(); 2].map(|()| matrix(&mut entries)))
    }

    /// The squares of the frequencies without wind if all motions had one of the natural frequencies, Eq. (15).
    ///
    /// # Errors
    ///
    /// Those of the arithmetic.
    pub fn squares_without_wind_in<A: Numbers<Value = T>>(
        &self,
        arithmetic: &mut A,
    ) -> Result<Vec<T>, A::Error> {
        self.run(arithmetic, |given| {
            let frequencies = given.parameters.free.as_slice().iter();
            let own = frequencies.map(|free| given.parameters.natural_frequencies[free.index()]);
            own.flat_map(|omega| given.squares_without_wind(omega))
                .collect()
        })
    }

    fn run<A: Numbers<Value = T>>(
        &self,
        arithmetic: &mut A,
        functions: impl FnOnce(&Given<Recorded>) -> Vec<Recorded>,
    ) -> Result<Vec<T>, A::Error> {
        let (places, values) = self.flattened();
        recorded::run(arithmetic, &values, |inputs| {
            functions(&places.map(|place| inputs[*place]))
        })
    }
}

impl<T> Equations<T> {
    /// The same in other numbers.
    pub fn map<U>(&self, number: impl Fn(&T) -> U) -> Equations<U> {
        let matrix = |own: &Matrix<T>| own.each_ref().map(|row| row.each_ref().map(&number));
        Equations {
            mass: matrix(&self.mass),
            structural_damping: matrix(&self.structural_damping),
            aerodynamic_damping: matrix(&self.aerodynamic_damping),
            stiffness: matrix(&self.stiffness),
            aerodynamic_stiffness: matrix(&self.aerodynamic_stiffness),
        }
    }

    /// All entries, matrix by matrix and row by row.
    pub fn into_entries(self) -> Vec<T> {
        let matrices = [
            self.mass,
            self.structural_damping,
            self.aerodynamic_damping,
            self.stiffness,
            self.aerodynamic_stiffness,
        ];
        matrices.into_iter().flatten().flatten().collect()
    }

    fn from_entries(entries: Vec<T>) -> Self {
        let mut entries = entries.into_iter();
        let mut next = || matrix(&mut entries);
        Equations {
            mass: next(),
            structural_damping: next(),
            aerodynamic_damping: next(),
            stiffness: next(),
            aerodynamic_stiffness: next(),
        }
    }
}

/// The next nine entries, row by row: as many as were asked for.
fn matrix<T>(entries: &mut impl Iterator<Item = T>) -> Matrix<T> {
    [(); 3].map(|()| [(); 3].map(|()| entries.next().expect("an entry for each place")))
}
