//! The estimated error of a run, by runs beside it ("references") with which it is compared.
//!
//! | kind of reference | what it says |
//! |---|---|
//! | another method | its distance from the run is the error of the run, where the other method is far more accurate |
//! | other steps | its distance is a multiple `1/c` of the error, by the order of the method in the steps |
//! | a start disturbed by rounding | two runs by one method: how the motion amplifies small differences |
//!
//! A reference that began with the run is compared with all that has happened: the error of a body is `c d`, with `d`
//! the distance of the two. Pieces that begin later, at `t_b`, from the states of the run then, add to the error there,
//! which the motion amplifies by `G`:
//!
//! `e(t) = G(t_b, t) e(t_b) + c d(t)`
//!
//! Where none runs, the error is amplified too, and grows by what the last piece that was followed has added per
//! second. It is never below what rounding makes of coordinates and angles, nor above the way that a body has come.
//!
//! References may take a part of the work of the run ([`effort`], [`budget`]). It is counted and not measured
//! (`crate::model::work`), so that the estimate is the same on every machine. `crate::run::accompany` begins and
//! follows them. Nothing that a reference does can change or end the run.
//!
//! The distance of motions that swing passes through zero. That of the past therefore fades within a fifth of the time
//! that a reference has run.
//!
//! How it fails: what happens while no reference runs is seen by its rate alone; a reference with longer steps may take
//! another branch than the run does, and the estimate is too large then. Source: comparison of methods and step
//! doubling (docs/REFERENCES.md, Hairer, Norsett and Wanner).
//!
//! | module | holds |
//! |---|---|
//! | [`effort`] | [`ErrorEstimation`](crate::ErrorEstimation): off, quick or full, and what each may cost |
//! | [`budget`] | what references may take of the work of a run |
//! | `course` | `Course`: what is known of the error so far |
//! | `growth` | how a disturbance has grown, and the horizon |
//! | `references` | `References`: the runs beside a run |

pub(crate) mod budget;
pub(crate) mod course;
pub(crate) mod effort;
pub(crate) mod growth;
pub(crate) mod references;
