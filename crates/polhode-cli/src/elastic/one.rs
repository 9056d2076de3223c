//! One drop: what three meshes give, what they tend to, where the energy is, and the rigid laws beside it.

use super::rigid::{self, Rebound, RigidDrop};
use crate::failure::Failure;
use crate::progress::Progress;
use crate::text::{Table, number};
use polhode_elastic::{Cells, DropReport, DropStudy, Extrapolated, Guide, MeshedDrops, Quantity, RectangleDrop};
use serde_json::{Value, json};
use std::fmt::Write as _;
use std::time::Instant;

/// A drop and everything about it.
pub(super) struct Dropped {
    drop: RectangleDrop,
    study: DropStudy,
    /// Computing time of one drop on each mesh, s.
    wall_s: Vec<f64>,
    rigid: Vec<RigidDrop>,
}

impl Dropped {
    /// Drops it on three meshes, the coarsest of about so many elements.
    pub(super) fn of(drop: &RectangleDrop, elements: usize) -> Result<Self, Failure> {
        let progress = Progress::new("dropping the rectangle");
        let (mut meshes, mut wall_s) = (Vec::new(), Vec::new());
        let all = DropStudy::cells(drop.cells(elements))?;
        progress.phase("meshes", all.len());
        for cells in all {
            let start = Instant::now();
            let drops = MeshedDrops::of(drop, cells)?;
            wall_s.push(start.elapsed().as_secs_f64() / drops.reports.len().max(1) as f64);
            meshes.push(drops);
            progress.part_done();
        }
        let study = DropStudy { meshes };
        let mut dropped = Self { drop: *drop, study, wall_s, rigid: Vec::new() };
        let (elastic, watched_s) = (dropped.rebound()?, dropped.watched_s());
        dropped.rigid = rigid::laws(drop, &elastic, watched_s)?;
        Ok(dropped)
    }

    /// The coarsest mesh.
    pub(super) fn coarsest(&self) -> Cells {
        self.study.meshes.first().map_or(Cells { columns: 1, rows: 1 }, |drops| drops.cells)
    }

    /// The rigid laws.
    pub(super) fn rigid(&self) -> &[RigidDrop] {
        &self.rigid
    }

    /// A quantity in the limit of fine meshes.
    pub(super) fn limit(&self, quantity: Quantity) -> Result<Extrapolated, Failure> {
        Ok(self.study.limit(quantity)?)
    }

    /// The rebound in the limit of fine meshes.
    fn rebound(&self) -> Result<Rebound, Failure> {
        let [up, spin] = [Quantity::Velocity, Quantity::AngularVelocity].map(|quantity| self.limit(quantity));
        // Without friction nothing pushes along the floor.
        Ok(Rebound { along: 0.0, up: up?.value, spin: spin?.value })
    }

    /// For how long the drop was watched on the finest mesh, s.
    fn watched_s(&self) -> f64 {
        self.finest().map_or(0.0, |report| report.steps as f64 * report.step_s)
    }

    /// A drop on the finest mesh.
    fn finest(&self) -> Option<&DropReport> {
        self.study.meshes.last().and_then(|drops| drops.reports.last())
    }

    /// Time of a wave up and down, s.
    pub(super) fn wave_s(&self) -> f64 {
        2.0 * self.drop.height() / self.drop.material().dilatational_speed()
    }

    pub(super) fn text(&self) -> Result<String, Failure> {
        let (drop, material) = (&self.drop, self.drop.material());
        let mut page = String::new();
        let confined = if drop.guide() == Guide::Vertical { ", confined" } else { "" };
        let _ = writeln!(
            page,
            "rectangle of {} m x {} m{confined}, tilted by {} degrees, at {} m/s; plane strain, for each metre of \
             depth",
            number(drop.width()),
            number(drop.height()),
            number(drop.tilt_rad().to_degrees()),
            number(drop.speed()),
        );
        let _ = writeln!(
            page,
            "E {} Pa, nu {}, {} kg/m^3: c_p {} m/s, c_s {} m/s, 2 H/c_p {} s\n",
            number(material.young()),
            number(material.poisson()),
            number(material.density()),
            number(material.dilatational_speed()),
            number(material.shear_speed()),
            number(self.wave_s()),
        );
        page.push_str(&self.meshes_text()?);
        page.push_str(&self.energy_text());
        page.push_str(&self.rigid_text());
        Ok(page)
    }

    /// Quantities by mesh.
    fn meshes_text(&self) -> Result<String, Failure> {
        let mut table = Table::default();
        let mut head = vec!["elements".to_owned()];
        head.extend(self.study.meshes.iter().map(|drops| drops.cells.count().to_string()));
        head.extend(["limit", "+-", "order"].map(str::to_owned));
        table.cells(head);
        for (quantity, name) in NAMES {
            let limit = self.limit(quantity)?;
            let mut cells = vec![name.to_owned()];
            cells.extend(self.study.meshes.iter().map(|drops| number(drops.mean(quantity).value)));
            cells.extend([number(limit.value), figure(limit.error), figure(limit.order)]);
            table.cells(cells);
        }
        let mut times = vec!["computing time of one drop, s".to_owned()];
        times.extend(self.wall_s.iter().map(|&seconds| figure(seconds)));
        table.cells(times);
        Ok(format!("{}\n", table.print()))
    }

    /// Where the energy is on the finest mesh.
    fn energy_text(&self) -> String {
        let Some(report) = self.finest() else { return String::new() };
        let energy = &report.energy;
        let mut table = Table::default();
        let part = |value: f64| figure(value / energy.before_j);
        table.row(["energy on the finest mesh", "part of that before"]);
        table.row(["before, J", &number(energy.before_j)]);
        table.row(["translation", &part(energy.translation_j)]);
        table.row(["rotation", &part(energy.rotation_j)]);
        table.row(["vibration", &part(energy.vibration_j)]);
        table.row(["lost in contacts", &part(energy.contact_loss_j)]);
        table.row(["added by the steps", &part(energy.numerical_j)]);
        table.row(["left unexplained", &part(energy.residual_j)]);
        table.row(["momentum left unexplained", &figure(report.momentum_residual)]);
        let steps = format!("{} of {}", number(report.step_s), number(report.longest_step_s));
        table.row(["step of the limit of stability, s", &steps]);
        format!("{}\n", table.print())
    }

    /// The laws of rigid bodies.
    fn rigid_text(&self) -> String {
        let mut table = Table::default();
        table.row(["rigid law", "e", "velocity up, m/s", "angular velocity, rad/s", "off, of the speed", "time, s"]);
        for (number_of, rigid) in self.rigid.iter().enumerate() {
            let best = if number_of + 1 == self.rigid.len() { ", best e" } else { "" };
            table.cells(vec![
                format!("{}{best}", rigid.law.name()),
                number(rigid.restitution),
                number(rigid.rebound.up),
                number(rigid.rebound.spin),
                figure(rigid.error),
                figure(rigid.wall_s),
            ]);
        }
        table.print()
    }

    pub(super) fn json(&self) -> Result<Value, Failure> {
        let (drop, material) = (&self.drop, self.drop.material());
        let mut quantities = serde_json::Map::new();
        for (quantity, _) in NAMES {
            let limit = self.limit(quantity)?;
            let means: Vec<Value> = self.study.meshes.iter().map(|drops| json!(drops.mean(quantity).value)).collect();
            let errors: Vec<Value> = self.study.meshes.iter().map(|drops| json!(drops.mean(quantity).error)).collect();
            let value = json!({
                "meshes": means,
                "standard_errors": errors,
                "limit": limit.value,
                "error": limit.error,
                "order": limit.order
            });
            quantities.insert(key(quantity).to_owned(), value);
        }
        let cells: Vec<Value> =
            self.study.meshes.iter().map(|drops| json!([drops.cells.columns, drops.cells.rows])).collect();
        let rigid: Vec<Value> = self.rigid.iter().map(rigid_json).collect();
        Ok(json!({
            "width_m": drop.width(), "height_m": drop.height(), "tilt_rad": drop.tilt_rad(), "speed_m_s": drop.speed(),
            "confined": drop.guide() == Guide::Vertical,
            "young_pa": material.young(), "poisson": material.poisson(), "density_kg_m3": material.density(),
            "dilatational_speed_m_s": material.dilatational_speed(), "shear_speed_m_s": material.shear_speed(),
            "wave_time_s": self.wave_s(),
            "cells": cells, "wall_s": self.wall_s, "quantities": quantities,
            "energy": self.finest().map(energy_json), "rigid": rigid,
        }))
    }
}

/// What is shown of a drop, and under which name.
const NAMES: [(Quantity, &str); 8] = [
    (Quantity::ContactTime, "first to last touch, s"),
    (Quantity::Impulse, "impulse, N s"),
    (Quantity::Velocity, "velocity up, m/s"),
    (Quantity::AngularVelocity, "angular velocity, rad/s"),
    (Quantity::Restitution, "restitution, of translation"),
    (Quantity::CornerRestitution, "restitution, of the corner"),
    (Quantity::EnergyRestitution, "restitution, of energy"),
    (Quantity::Vibration, "energy of vibration, part"),
];

/// The name in JSON.
const fn key(quantity: Quantity) -> &'static str {
    match quantity {
        Quantity::ContactTime => "contact_time_s",
        Quantity::Impulse => "impulse_n_s",
        Quantity::Velocity => "velocity_up_m_s",
        Quantity::AngularVelocity => "angular_velocity_rad_s",
        Quantity::Restitution => "restitution",
        Quantity::CornerRestitution => "corner_restitution",
        Quantity::EnergyRestitution => "energy_restitution",
        Quantity::Vibration => "vibration_part",
    }
}

fn energy_json(report: &DropReport) -> Value {
    let energy = &report.energy;
    json!({
        "elements": report.cells.count(), "step_s": report.step_s, "longest_step_s": report.longest_step_s,
        "steps": report.steps, "before_j": energy.before_j, "translation_j": energy.translation_j,
        "rotation_j": energy.rotation_j, "vibration_j": energy.vibration_j, "contact_loss_j": energy.contact_loss_j,
        "numerical_j": energy.numerical_j, "residual_j": energy.residual_j,
        "momentum_residual": report.momentum_residual,
    })
}

/// A law of rigid bodies as JSON.
fn rigid_json(rigid: &RigidDrop) -> Value {
    json!({
        "law": rigid.law.name(), "restitution": rigid.restitution, "velocity_up_m_s": rigid.rebound.up,
        "angular_velocity_rad_s": rigid.rebound.spin, "error": rigid.error, "wall_s": rigid.wall_s,
    })
}

/// An error or a time in two digits.
pub(super) fn figure(value: f64) -> String {
    /// Magnitudes that are written without an exponent.
    const PLAIN: std::ops::Range<f64> = 0.01..100.0;
    if value == 0.0 {
        "0".to_owned()
    } else if PLAIN.contains(&value.abs()) {
        format!("{value:.3}")
    } else {
        format!("{value:.1e}")
    }
}
