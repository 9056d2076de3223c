//! What a simulation tells of the present: plain values, with the names and units of the library.

use pyo3::prelude::*;
use pyo3::types::PyTuple;

/// A class of plain values: each field is a number, a name, or a tuple of numbers.
macro_rules! view {
    ($(#[$doc:meta])* $name:ident { $($(#[$of:meta])* $field:ident: $kind:ty,)* }) => {
        $(#[$doc])*
        #[pyclass(frozen, module = "polhode._polhode")]
        #[derive(Debug, Clone)]
        pub(crate) struct $name { $(pub(crate) $field: $kind,)* }

        #[pymethods]
        impl $name {
            $($(#[$of])* #[getter] fn $field<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
                self.$field.given(py)
            })*

            fn __repr__(&self, py: Python<'_>) -> PyResult<String> {
                let fields = [$((stringify!($field), self.$field.given(py)?.repr()?.to_string())),*];
                let fields: Vec<String> = fields.iter().map(|(name, value)| format!("{name}={value}")).collect();
                Ok(format!("{}({})", stringify!($name), fields.join(", ")))
            }
        }
    };
}

/// What Python is given of a field.
trait Given {
    fn given<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>>;
}

impl<const N: usize> Given for [f64; N] {
    fn given<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        Ok(PyTuple::new(py, self)?.into_any())
    }
}

/// What Python is given as it is.
macro_rules! as_it_is {
    ($($kind:ty),*) => {
        $(impl Given for $kind {
            fn given<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
                Ok(self.into_pyobject(py)?.to_owned().into_any())
            }
        })*
    };
}

as_it_is!(f64, usize, bool, String);

view! {
    /// Where a body is, and how it moves.
    BodyState {
        /// Position of its own origin, world, m.
        position: [f64; 3],
        /// Orientation, a quaternion body to world: w, x, y, z.
        orientation: [f64; 4],
        /// Velocity of its centre of mass, world, m/s.
        velocity: [f64; 3],
        /// Angular velocity, world, rad/s.
        angular_velocity: [f64; 3],
    }
}

view! {
    /// A step that has been made.
    StepOutcome {
        /// Time reached, s.
        t: f64,
        /// Whether the step ended at an event.
        is_event: bool,
    }
}

view! {
    /// A contact that touches. Single forces may not be unique: those of least norm are given.
    Contact {
        /// Body A.
        body_a: String,
        /// Body B.
        body_b: String,
        /// Contact point, world, m.
        point: [f64; 3],
        /// Unit normal from B to A, world.
        normal: [f64; 3],
        /// Distance along the normal, m; negative when the bodies overlap.
        separation: f64,
        /// Force on A along the normal, N.
        normal_force: f64,
        /// Force of friction on A, world, N.
        friction: [f64; 3],
    }
}

view! {
    /// What a joint does to its first body, and the opposite of what it does to the second one.
    JointLoad {
        /// The joint.
        joint: String,
        /// Its anchor on the first body, world, m.
        point: [f64; 3],
        /// Force at the anchor, world, N.
        force: [f64; 3],
        /// Moment about the anchor, world, N m.
        torque: [f64; 3],
    }
}

view! {
    /// A coordinate of a joint.
    Coordinate {
        /// Its value, rad or m.
        value: f64,
        /// Its rate, rad/s or m/s.
        rate: f64,
    }
}

view! {
    /// Energies, J.
    Energy {
        /// Kinetic energy.
        kinetic: f64,
        /// Potential energy.
        potential: f64,
        /// Their sum.
        total: f64,
        /// The sum at t = 0.
        initial: f64,
    }
}

view! {
    /// Momentum.
    Momentum {
        /// Linear momentum, world, N s.
        linear: [f64; 3],
        /// Angular momentum about the point of the ledger of momentum, world, N m s.
        angular: [f64; 3],
    }
}

view! {
    /// What was found in the file of a robot.
    Finding {
        /// The file.
        file: String,
        /// Line, from 1.
        line: usize,
        /// Column, from 1.
        column: usize,
        /// error, warning or ignored.
        severity: String,
        /// What it is about: a link, a joint.
        subject: String,
        /// What is wrong, with its size.
        what: String,
        /// The edit that mends it; empty where there is none.
        cure: String,
    }
}
