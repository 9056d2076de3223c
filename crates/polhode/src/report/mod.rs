//! What a run tells: plain values, for programs, files and viewers.
//!
//! | module | holds |
//! |---|---|
//! | [`run_report`] | [`RunReport`](crate::RunReport), [`Outcome`](crate::Outcome), `Certificate` |
//! | `run_error` | [`RunError`](crate::RunError): the estimated error of a run |
//! | `broken_promise` | [`BrokenPromise`](crate::BrokenPromise): a limit that a run has exceeded |
//! | [`ledger`], [`momentum_ledger`] | [`Ledger`](crate::Ledger), [`MomentumLedger`](crate::MomentumLedger), by cause |
//! | `energy` | [`Energy`](crate::Energy) of a scene |
//! | [`event`] | [`Event`](crate::Event), [`EventKind`](crate::EventKind) |
//! | [`observer`] | [`Observer`](crate::Observer), [`Recorder`](crate::Recorder): who receives samples and events |
//! | [`frame`] | [`Frame`](crate::Frame): poses, contacts, forces and islands at one time |
//! | `body_sample`, `acceleration` | a body at one time |
//! | `contact_sample` | a contact at one time, and what of its forces is not unique |
//! | `joint_sample`, `joint_efforts` | a joint at one time; what acts along its coordinates, by cause |
//! | `run_hash` | [`RunHash`](crate::RunHash): the strict hash of a run, taken while it goes on |
//! | `springs` | [`SpringReport`](crate::SpringReport): the springs of a run by tier `penalty` |

pub(crate) mod acceleration;
pub(crate) mod body_sample;
pub(crate) mod broken_promise;
pub(crate) mod contact_sample;
pub(crate) mod energy;
pub mod event;
pub mod frame;
pub(crate) mod joint_efforts;
pub(crate) mod joint_sample;
pub mod ledger;
pub mod momentum_ledger;
pub mod observer;
pub mod run_error;
pub(crate) mod run_hash;
pub mod run_report;
pub(crate) mod springs;
