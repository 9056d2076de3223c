//! A scene file in other units: lengths, times and masses multiplied by powers of two.
//!
//! With lengths larger by `4^k` and times by `2^k` accelerations are the same numbers, and every number of the scene is
//! scaled without rounding; square roots too, so masses grow by powers of 4 as lengths do. The table says the unit of
//! every key of the format that has one; keys without one (names, coefficients, attitudes, choices) stay.

use std::error::Error;
use toml::{Table, Value};

/// Factors of units.
#[derive(Debug, Clone, Copy)]
pub struct Units {
    /// Of lengths.
    pub length: f64,
    /// Of times.
    pub time: f64,
    /// Of masses.
    pub mass: f64,
}

impl Units {
    /// Lengths larger by `4^power`, times by `2^power`, masses by `4^mass_power`.
    pub fn of_powers(power: i32, mass_power: i32) -> Self {
        Self { length: 4.0_f64.powi(power), time: 2.0_f64.powi(power), mass: 4.0_f64.powi(mass_power) }
    }

    /// The factor of the numbers of a key, in the table `beside` it; none for a key without a unit.
    fn factor(self, key: &str, beside: &Table) -> Option<f64> {
        let Self { length, time, mass } = self;
        let speed = length / time;
        let is_quadratic = beside.get("law").and_then(Value::as_str) == Some("quadratic");
        Some(match key {
            "position" | "positions" | "polygon" | "size" | "radius" | "inner_radius" | "outer_radius" | "width"
            | "height" | "major" | "minor" | "pivot" | "anchor" | "lead" | "anchors" | "length" | "point"
            | "points" | "center" | "center_of_mass" | "rest_length" | "start" | "lowest" | "advance"
            | "wavelength" | "reach" | "coefficients" | "amplitude" | "rolling_friction" | "spinning_friction"
            | "scale" | "separate" | "collision_envelope" | "penetration_m" => length,
            "curvature" => 1.0 / length,
            "duration" | "step" | "interval" | "times" => time,
            "gravity" => length / (time * time),
            "velocity" | "surface_velocity" | "wind" | "restitution_yield_speed" | "slip_speed_m_s" => speed,
            "restitution_slope" => 1.0 / speed,
            "angular_velocity" | "frequency" => 1.0 / time,
            "mass" => mass,
            "density" => mass / (length * length * length),
            "inertia" => mass * length * length,
            "stiffness" | "stiffness_n_m" => mass / (time * time),
            "youngs_modulus_pa" => mass / (length * time * time),
            "mu" => length * length * length / (time * time),
            "force" => mass * length / (time * time),
            "torque" | "moment" => mass * length * length / (time * time),
            "impulse" => mass * length / time,
            "translational" if is_quadratic => mass / length,
            "damping" | "translational" => mass / time,
            "rotational" if is_quadratic => mass * length * length,
            "rotational" => mass * length * length / time,
            _ => return None,
        })
    }

    /// A table of a scene file in these units.
    fn table(self, table: &mut Table) {
        let beside = table.clone();
        if beside.contains_key("file") && !beside.contains_key("scale") {
            table.insert("scale".to_owned(), Value::Float(1.0));
        }
        for (key, value) in table.iter_mut() {
            match self.factor(key, &beside) {
                // The type of a force bears the name of what it gives.
                Some(factor) if !value.is_table() => multiply(value, factor),
                _ if key == "signal" => self.signal(value),
                _ if key == "layout" => self.layout(value),
                _ if key == "angle" => self.freedom(value, Freedom { coordinate: 1.0, arm: self.length }),
                _ if key == "displacement" => self.freedom(value, Freedom { coordinate: self.length, arm: 1.0 }),
                _ => self.value(value),
            }
        }
    }

    fn value(self, value: &mut Value) {
        match value {
            Value::Table(table) => self.table(table),
            Value::Array(values) => values.iter_mut().for_each(|value| self.value(value)),
            _ => {}
        }
    }

    /// Of a signal over time only the times have a unit.
    fn signal(self, value: &mut Value) {
        let samples = value.get_mut("table").and_then(Value::as_array_mut);
        for time in samples.into_iter().flatten().filter_map(|sample| sample.get_mut(0)) {
            multiply(time, self.time);
        }
    }

    /// Of the layout of an array spacing, size of the region and measures of an arch have a unit; all else are counts.
    fn layout(self, value: &mut Value) {
        for kind in value.as_table_mut().into_iter().flatten().map(|(_, kind)| kind) {
            for (key, value) in kind.as_table_mut().into_iter().flatten() {
                if ["spacing", "size", "radius", "thickness", "width"].contains(&key.as_str()) {
                    multiply(value, self.length);
                }
            }
        }
    }

    /// What acts along a coordinate of a joint.
    fn freedom(self, value: &mut Value, of: Freedom) {
        let Self { length, time, mass } = self;
        let effort = mass * length / (time * time) * of.arm;
        for (key, value) in value.as_table_mut().into_iter().flatten() {
            match key.as_str() {
                "range" | "rest" | "position" | "amplitude" | "values" => multiply(value, of.coordinate),
                "velocity" | "rate" => multiply(value, of.coordinate / time),
                "stiffness" => multiply(value, effort / of.coordinate),
                "damping" | "gain" => multiply(value, effort * time / of.coordinate),
                "radius" => multiply(value, length),
                "effort" | "most" | "breakaway" => multiply(value, effort),
                "frequency" => multiply(value, 1.0 / time),
                "times" => multiply(value, time),
                "motor" | "friction" | "motion" | "sine" | "table" => self.freedom(value, of),
                _ => {}
            }
        }
    }

    /// Of a gear the ratio has the unit of its first coordinate over that of its second one.
    fn gears(self, scene: &mut Table) {
        let joints = scene.get("joints").and_then(Value::as_array).cloned().unwrap_or_default();
        let length = |name: Option<&Value>, coordinate: Option<&Value>| {
            let joint = joints.iter().find(|joint| joint.get("name") == name)?.get("type")?.as_table()?;
            let is_angle = coordinate.map_or(joint.contains_key("hinge") || joint.contains_key("screw"), |named| {
                named.as_str() == Some("angle")
            });
            Some(if is_angle { 1.0 } else { self.length })
        };
        for gear in scene.get_mut("gears").and_then(Value::as_array_mut).into_iter().flatten() {
            let of = |place: usize| {
                length(gear.get("joints")?.get(place), gear.get("coordinates").and_then(|named| named.get(place)))
            };
            let (first, second) = (of(0).unwrap_or(1.0), of(1).unwrap_or(1.0));
            if let Some(ratio) = gear.get_mut("ratio") {
                multiply(ratio, first / second);
            }
        }
    }

    /// The text of a scene file in these units, which lasts for at most `most_s` seconds of the original.
    ///
    /// # Errors
    /// When it is not TOML.
    pub fn text(self, original: &str, most_s: f64) -> Result<String, Box<dyn Error>> {
        let mut scene: Table = toml::from_str(original)?;
        if let Some(duration) = scene.get_mut("duration") {
            let given = duration.as_float().or_else(|| duration.as_integer().map(|whole| whole as f64));
            *duration = Value::Float(given.unwrap_or(most_s).min(most_s));
        }
        // The defaults of the format have units.
        scene.entry("gravity").or_insert_with(|| Value::Array(GRAVITY.map(Value::Float).to_vec()));
        for (table, key) in [("method", "step"), ("output", "interval")] {
            let table = scene.entry(table).or_insert_with(|| Value::Table(Table::new()));
            if let Some(table) = table.as_table_mut() {
                table.entry(key).or_insert(Value::Float(STEP_S));
            }
        }
        self.gears(&mut scene);
        self.table(&mut scene);
        Ok(toml::to_string(&scene)?)
    }
}

/// Factors of a coordinate of a joint.
#[derive(Debug, Clone, Copy)]
struct Freedom {
    /// Of its values.
    coordinate: f64,
    /// Of the arm that makes an effort of a force.
    arm: f64,
}

/// Gravity (m/s^2), and step and interval of output (s), of a scene that names none.
const GRAVITY: [f64; 3] = [0.0, 0.0, -9.81];
const STEP_S: f64 = 0.01;

/// Multiplies all numbers of a value.
fn multiply(value: &mut Value, factor: f64) {
    match value {
        Value::Float(number) => *number *= factor,
        Value::Integer(number) => *value = Value::Float(*number as f64 * factor),
        Value::Array(values) => values.iter_mut().for_each(|value| multiply(value, factor)),
        _ => {}
    }
}

#[cfg(test)]
mod tests {
    //! Every number is in the other unit, and what has none stays.
    #![allow(clippy::unwrap_used, reason = "a test that cannot go on has failed")]
    use super::*;

    #[test]
    fn a_scene_in_units_of_a_quarter_metre() {
        let scene = "duration = 3\n[[bodies]]\nshape.sphere.radius = 0.5\nposition = [1, 2.0, 3]\nmass = 3\n\
                     orientation = [1, 0, 0, 0]\nshape.mesh.file = \"a.obj\"\n[[forces]]\n\
                     type.torque.torque = [1, 0, 0]\n\
                     type.torque.signal.table = [[1, 5]]";
        let text = Units::of_powers(1, 1).text(scene, 2.0).unwrap();
        let scaled: Table = toml::from_str(&text).unwrap();
        assert_eq!(scaled["duration"].as_float(), Some(4.0));
        assert_eq!(scaled["gravity"][2].as_float(), Some(-9.81));
        assert_eq!(scaled["method"]["step"].as_float(), Some(0.02));
        let body = &scaled["bodies"][0];
        assert_eq!(body["shape"]["sphere"]["radius"].as_float(), Some(2.0));
        assert_eq!(body["shape"]["mesh"]["scale"].as_float(), Some(4.0));
        assert_eq!(body["position"][1].as_float(), Some(8.0));
        assert_eq!(body["mass"].as_float(), Some(12.0));
        assert_eq!(body["orientation"][0].as_integer(), Some(1));
        let torque = &scaled["forces"][0]["type"]["torque"];
        assert_eq!(torque["torque"][0].as_float(), Some(16.0));
        assert_eq!(torque["signal"]["table"][0][0].as_float(), Some(2.0));
        assert_eq!(torque["signal"]["table"][0][1].as_integer(), Some(5));
    }
}
