//! Impact laws: impulses that stop touching bodies from approaching.
//!
//! All laws work on row velocities `u = J v` (m/s, negative while approaching), impulses `p >= 0` (N s) and the
//! Delassus matrix: `u+ = u- + G p`. A row with restitution `e` leaves with `u+ = -e u-` when it is struck alone
//! (Newton; [`single_contact_impulse`], thesis equation 14). With several rows at once rigid bodies leave the answer
//! open (thesis, Figure 16), so the law is a choice:
//!
//! | law | several rows | symmetric | ends |
//! |---|---|---|---|
//! | `propagation` | one at a time, in order (thesis 3.3) | no | not always |
//! | `simultaneous` | all at once (Moreau; thesis 3.4, end) | yes | yes |
//! | `reflection` | those that approach, repeated (Smith et al. 2012) | yes | yes |
//! | `poisson` | all at once, compression and expansion (Glocker and Pfeiffer 1995) | yes | yes |
//! | `energetic` | all at once, each gives back a part of its work (Stronge 1990) | yes | yes |
//! | `pulse` | as springs, along the impulse (Liu, Zhao and Brogliato 2008) | yes | yes |
//!
//! At a bilateral row, a joint, `u+ = 0` after every application, whatever its restitution and whatever it was before:
//! the joints take part in each solve, with impulses of either sign.
//!
//! Energy: for any impulse `dT = p.(u- + u+)/2` exactly (thesis, Appendix B, for any number of rows), which is how
//! every outcome is booked. No law raises the energy; none leaves a row approaching.
//!
//! | module | holds |
//! |---|---|
//! | `law` | the choice of a law: [`ImpactLaw`] |
//! | `propagation`, `simultaneous`, `reflection`, `poisson`, `energetic`, `pulse` | the laws, one file each |
//! | `single_contact` | equation (14): one row struck alone |
//! | `impact_problem` | what a law resolves, and its check: [`ImpactProblem`] |
//! | `finish` | what all laws share: inelastic solves, the end of an impact, its energy |
//! | `unequal` | restitutions that contradict each other: one lower one for all |
//! | [`friction`] | impacts with friction, at one contact and at several |
//! | `settings` | tolerances and limits: [`ImpactSettings`] |
//! | `outcome` | what a law did: [`ImpactOutcome`] |

mod energetic;
mod finish;
pub mod friction;
mod impact_problem;
mod law;
mod outcome;
mod poisson;
mod propagation;
mod pulse;
mod reflection;
mod settings;
mod simultaneous;
mod single_contact;
mod unequal;

pub use friction::PulseExponent;
pub use impact_problem::ImpactProblem;
pub use law::ImpactLaw;
pub use outcome::{Application, ImpactOutcome, ImpactStatus};
pub use settings::ImpactSettings;
pub use single_contact::single_contact_impulse;
