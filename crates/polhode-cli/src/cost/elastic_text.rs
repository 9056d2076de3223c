//! The elastic body and the rigid laws as text and JSON: whole boxes, not slices.

use super::elastic_drop::{ElasticBeside, ElasticRow};
use crate::elastic::rigid::RigidDrop;
use crate::text::{Table, number};
use polhode_elastic::Extrapolated;
use serde_json::{Value, json};

impl ElasticBeside {
    /// The table, and what the elastic body is without.
    pub(super) fn text(&self) -> String {
        let drop = &self.drop;
        let mut table = Table::default();
        table.row(["", "contact time, s", "impulse, N s", "effective restitution", "computing, s"]);
        for row in &self.meshes {
            let [time, impulse, restitution] = self.whole(row);
            let name = format!("elastic, {} elements", row.elements);
            table.cells(vec![name, number(time), number(impulse), number(restitution), seconds(row.wall_s)]);
        }
        let [time, impulse, restitution] = self.limits();
        let [time, impulse, restitution] = [time, impulse, restitution].map(|limit| with_error(&limit));
        table.cells(vec!["elastic, limit of fine meshes".to_owned(), time, impulse, restitution, String::new()]);
        for law in &self.rigid {
            let name = format!("{}, e {}", law.law.name(), number(law.restitution));
            let [impulse, restitution] = self.struck(law);
            table.cells(vec![name, "0".to_owned(), number(impulse), number(restitution), seconds(law.wall_s)]);
        }
        format!(
            "\nthe same drop of an elastic body: {} m x {} m, {} m deep, tilted by {} degrees, at {} m/s (plane \
             strain)\n{}  {} of its energy is left as vibration; it has no gravity, which in its contact adds {} of \
             its speed\n",
            number(drop.slice.width()),
            number(drop.slice.height()),
            number(drop.depth_m),
            number(drop.slice.tilt_rad().to_degrees()),
            number(drop.slice.speed()),
            table.print(),
            with_error(&self.vibration),
            number(self.gravity_part()),
        )
    }

    /// Everything as JSON.
    pub(super) fn json(&self) -> Value {
        let drop = &self.drop;
        let named = |[time, impulse, restitution]: [f64; 3]| {
            json!({
                "contact_time_s": time, "impulse_n_s": impulse, "restitution": restitution
            })
        };
        let meshes = self.meshes.iter().map(|row| {
            let mut value = named(self.whole(row));
            value["elements"] = json!(row.elements);
            value["wall_s"] = json!(row.wall_s);
            value
        });
        let laws = self.rigid.iter().map(|law| {
            let [impulse, restitution] = self.struck(law);
            let mut value = named([0.0, impulse, restitution]);
            value["law"] = json!(law.law.name());
            value["wall_s"] = json!(law.wall_s);
            value
        });
        let limits = self.limits();
        json!({
            "width_m": drop.slice.width(), "height_m": drop.slice.height(), "depth_m": drop.depth_m,
            "tilt_rad": drop.slice.tilt_rad(), "speed_m_s": drop.slice.speed(), "given_restitution": drop.restitution,
            "meshes": meshes.collect::<Vec<_>>(), "limit": named(limits.map(|limit| limit.value)),
            "limit_error": named(limits.map(|limit| limit.error)), "vibration_part": self.vibration.value,
            "gravity_part": self.gravity_part(), "laws": laws.collect::<Vec<_>>(),
        })
    }

    /// What a mesh gives for the whole box.
    fn whole(&self, row: &ElasticRow) -> [f64; 3] {
        let [time, impulse, restitution] = row.values;
        [time, impulse * self.drop.depth_m, restitution]
    }

    /// The limits for the whole box.
    fn limits(&self) -> [Extrapolated; 3] {
        let [time, impulse, restitution] = self.limits;
        let depth_m = self.drop.depth_m;
        let impulse = Extrapolated { value: impulse.value * depth_m, error: impulse.error * depth_m, ..impulse };
        [time, impulse, restitution]
    }

    /// Impulse and effective restitution of a rigid law.
    fn struck(&self, law: &RigidDrop) -> [f64; 2] {
        let speed = self.drop.slice.speed();
        [self.drop.mass_kg * (speed + law.rebound.up), law.rebound.up / speed]
    }

    /// What gravity would add within the contact, of the speed.
    fn gravity_part(&self) -> f64 {
        self.drop.gravity * self.limits[0].value / self.drop.slice.speed()
    }
}

fn with_error(limit: &Extrapolated) -> String {
    format!("{} +- {:.1e}", number(limit.value), limit.error)
}

fn seconds(time_s: f64) -> String {
    format!("{time_s:.1e}")
}
