//! Springs and wind in balance: the formulas of `derivations/extensions.md`, section 5, with bounds of all rounding.

use sextic_evaluators::bounded::Bounded;
use sextic_evaluators::mean_twist::{MeanTwistOutputs, mean_twist_body};

use crate::stability::parameters::Parameters;

/// The balance of a section in its wind.
#[derive(Clone, Copy, Debug)]
pub(super) struct Balance(Parameters<Bounded>);

impl Balance {
    pub fn of(parameters: &Parameters) -> Self {
        Balance(parameters.map(|own| Bounded::exact(*own)))
    }

    /// By how much a twist is too much for C_M: 0 in balance.
    pub fn excess(&self, twist: Bounded, moment: Bounded) -> Bounded {
        self.run(twist, moment, Bounded::exact(0.0)).excess
    }

    /// The stiffness of the turn, that of the wind included, over that of its springs.
    pub fn stiffness(&self, slope: Bounded) -> Bounded {
        let nothing = Bounded::exact(0.0);
        self.run(nothing, nothing, slope).stiffness
    }

    /// Of the sign of C_M where the twist grows with the wind.
    pub fn growth(&self, twist: Bounded, moment: Bounded, slope: Bounded) -> Bounded {
        self.run(twist, moment, slope).growth
    }

    /// No twist is larger in balance with a moment coefficient up to this size.
    pub fn largest_twist(&self, moment: f64) -> f64 {
        let own = self.excess(Bounded::exact(0.0), Bounded::exact(moment));
        (own.value.abs() + own.error).next_up()
    }

    fn run(&self, twist: Bounded, moment: Bounded, slope: Bounded) -> MeanTwistOutputs<Bounded> {
        mean_twist_body(&self.0.mean_twist_inputs(twist, moment, slope))
    }
}
