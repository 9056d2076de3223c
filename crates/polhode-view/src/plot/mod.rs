//! Figures as SVG: runs over time, two runs compared, error against cost.
//!
//! One writer draws all figures of the project. The same data gives the same bytes on every machine; no font is read,
//! widths of texts are estimated. Figures are white and become dark where a page asks for it.
//!
//! | module | holds |
//! |---|---|
//! | [`ink`] | colours on white and on dark pages |
//! | [`svg`] | lines, shapes and text |
//! | `text_width` | how wide a text is, about |
//! | [`scale`], `decades`, `axes` | from values to places; labels of marks |
//! | [`mod@label_rows`], `label_spots` | labels that do not overlap: under each other, beside points |
//! | [`marker`], [`method_style`] | markers; one ink for a family of methods, one marker for a member |
//! | [`trace`], `event_times` | quantities and events over time, in bounded memory |
//! | [`time_chart`] | panels that share an axis of time |
//! | [`run_plot`], [`run_plots`], `joint_traces` | what is plotted of a run; its observer; curves of its joints |
//! | [`curves`] | single quantities over time or against each other |
//! | [`compare_plots`] | two trajectories |
//! | [`mechanism_plot`] | the motion that begins in a structure |
//! | [`cost_chart`], [`cost_panels`], [`dot_chart`] | error against cost of a scene; of a few side by side; of many |

pub mod compare_plots;
pub mod cost_chart;
pub mod cost_panels;
pub mod curves;
pub mod dot_chart;
pub mod ink;
pub mod label_rows;
pub mod marker;
pub mod mechanism_plot;
pub mod method_style;
pub mod run_plot;
pub mod run_plots;
pub mod scale;
pub mod svg;
pub mod time_chart;
pub mod trace;

mod axes;
mod decades;
mod event_times;
mod joint_traces;
mod label_spots;
mod text_width;

pub use compare_plots::{ComparePlot, ComparePlots};
pub use cost_chart::CostChart;
pub use cost_panels::CostPanels;
pub use curves::{CurvePanel, Curves};
pub use dot_chart::DotChart;
pub use ink::Ink;
pub use label_rows::label_rows;
pub use marker::Marker;
pub use mechanism_plot::{HingeMark, MechanismPlot};
pub use run_plot::RunPlot;
pub use run_plots::RunPlots;
pub use svg::{Stroke, Svg};
pub use time_chart::TimeChart;
pub use trace::Trace;
