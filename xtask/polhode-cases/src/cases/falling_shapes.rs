//! Bodies of revolution that fall over on a floor without friction: how long they take.
//!
//! A capsule, a cylinder and a cone that stand tilted beyond their balance, and a ring on its edge, fall in a vertical
//! plane while their centre of mass goes straight down. With `z(u) = r + a cos u` its height (a: distance of the centre
//! of mass from the circle or point that the body rolls off on; u: angle of that arm from the vertical; r: radius of
//! what rolls) and k the radius of gyration about the axis of the fall, energy gives
//!
//! `t = integral du sqrt((k^2 + a^2 sin^2 u) / (2 g a (cos u_0 - cos u)))`,
//!
//! taken here by Simpson's rule after `u = u_0 + s^2`, which removes the root at the start. The body lands when its
//! side meets the floor: that impact is the event measured. Each runs on a half-space, on a box and on a tessellated
//! plane.

use super::bodies::GRAVITY;
use super::{CaseResult, Context};
use crate::row::Row;
use glam::DVec3;
use polhode::contact::Shape;
use polhode::mesh::{Capsule, Cone, Cylinder, Primitive, Torus};
use polhode::spatial::{Mass, Pose, Rotation, UnitVector};
use polhode::{Body, Effects, ErrorEstimation, EventKind, Recorder, Scene, Simulation};
use std::error::Error;
use std::f64::consts::{FRAC_PI_2, PI};

/// Relative error of the time that is accepted: the start lies near an unstable balance, which makes a rounding of the
/// start some hundred times larger.
const TIME_TOLERANCE: f64 = 1e-10;

/// Largest drift sideways of what nothing pushes, and largest movement of what rests, m.
const STILL_M: f64 = 1e-12;

/// Intervals of Simpson's rule: beyond them the sum does not change.
const INTERVALS: u32 = 4096;

/// A body and how it falls.
struct Falling {
    name: &'static str,
    shape: Shape,
    primitive: Primitive,
    /// Turns the body's z axis upright, or for a ring its plane.
    upright: Rotation,
    /// `a` and `r` of the module's description, m.
    arm: f64,
    radius: f64,
    /// Angle of the arm from the vertical while the body stands upright, rad.
    lean: f64,
    /// Tilt at the start and when it lands, rad.
    start: f64,
    end: f64,
}

fn bodies() -> Result<Vec<Falling>, Box<dyn Error>> {
    let upright = Rotation::IDENTITY;
    let (radius, height) = (0.2, 1.0);
    let cylinder_lean = f64::atan2(radius, 0.5 * height);
    let cone_lean = f64::atan2(radius, 0.25 * height);
    Ok(vec![
        Falling {
            name: "capsule",
            shape: Shape::capsule(radius, height)?,
            primitive: Primitive::Capsule(Capsule::new(radius, height)?),
            upright,
            arm: 0.5 * height,
            radius,
            lean: 0.0,
            start: 0.1,
            end: FRAC_PI_2,
        },
        Falling {
            name: "cylinder",
            shape: Shape::cylinder(radius, height)?,
            primitive: Primitive::Cylinder(Cylinder::new(radius, height)?),
            upright,
            arm: radius.hypot(0.5 * height),
            radius: 0.0,
            lean: -cylinder_lean,
            start: cylinder_lean + 0.1,
            end: FRAC_PI_2,
        },
        Falling {
            name: "cone",
            shape: Shape::cone(radius, height)?,
            primitive: Primitive::Cone(Cone::new(radius, height)?),
            upright,
            arm: radius.hypot(0.25 * height),
            radius: 0.0,
            lean: -cone_lean,
            start: cone_lean + 0.1,
            end: FRAC_PI_2 + f64::atan2(radius, height),
        },
        Falling {
            name: "torus",
            shape: Shape::torus(0.5, 0.1)?,
            primitive: Primitive::Torus(Torus::new(0.5, 0.1)?),
            upright: Rotation::from_rotation_vector(DVec3::Y * FRAC_PI_2),
            arm: 0.5,
            radius: 0.1,
            lean: 0.0,
            start: 0.1,
            end: FRAC_PI_2,
        },
    ])
}

impl Falling {
    /// Time to fall, s.
    fn time(&self) -> Result<f64, Box<dyn Error>> {
        let properties = self.primitive.solid(Mass::new(1.0)?)?;
        // The fall turns about the world's y axis, which is the body's own y axis.
        let gyration = properties.inertia().matrix().y_axis.y;
        let start = self.start + self.lean;
        let last = (self.end - self.start).sqrt();
        let rate = |s: f64| {
            if s == 0.0 {
                return 2.0
                    * ((gyration + (self.arm * start.sin()).powi(2)) / (2.0 * GRAVITY * self.arm * start.sin()))
                        .sqrt();
            }
            let u = start + s * s;
            let fallen = 2.0 * (start + 0.5 * s * s).sin() * (0.5 * s * s).sin();
            2.0 * s * ((gyration + (self.arm * u.sin()).powi(2)) / (2.0 * GRAVITY * self.arm * fallen)).sqrt()
        };
        let h = last / f64::from(INTERVALS);
        let sum: f64 = (1..INTERVALS).map(|i| rate(h * f64::from(i)) * if i % 2 == 1 { 4.0 } else { 2.0 }).sum();
        Ok((rate(0.0) + sum + rate(last)) * h / 3.0)
    }

    fn body(&self) -> Result<Body, Box<dyn Error>> {
        let tilt = Rotation::from_rotation_vector(DVec3::Y * self.start);
        let height = self.radius + self.arm * (self.start + self.lean).cos();
        let pose = Pose::new(tilt * self.upright, DVec3::Z * height);
        let properties = self.primitive.solid(Mass::new(1.0)?)?;
        Ok(Body::movable(self.name, properties).geometry(self.shape.clone().into()).pose(pose))
    }
}

/// Floors through the origin: a half-space, a box and a plane of triangles, none of whose edges the fall follows.
fn floors() -> Result<Vec<(&'static str, Body)>, Box<dyn Error>> {
    let slab = DVec3::new(8.0, 8.0, 1.0);
    let (mut vertices, mut triangles) = (Vec::new(), Vec::new());
    let count = 9_u32;
    for i in 0..=count {
        for j in 0..=count {
            let place = |k: u32| f64::from(k) - 0.5 * f64::from(count) + 0.1;
            vertices.push(DVec3::new(place(i), place(j), 0.0));
            if i < count && j < count {
                let [a, b, c, d] = [(i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1)].map(|(i, j)| i * (count + 1) + j);
                triangles.extend([[a, b, c], [a, c, d]]);
            }
        }
    }
    Ok(vec![
        ("half-space", Body::fixed("floor").geometry(Shape::half_space(UnitVector::Z).into())),
        (
            "box",
            Body::fixed("floor")
                .geometry(Shape::cuboid(slab)?.into())
                .pose(Pose::from_translation(DVec3::Z * (-0.5 * slab.z))),
        ),
        ("triangles", Body::fixed("floor").geometry(Shape::triangle_mesh(vertices, triangles)?.into())),
    ])
}

/// Times to fall over, and how far the centre of mass has gone sideways, which nothing pushes.
pub(super) fn times(_: &Context) -> CaseResult {
    let mut rows = Vec::new();
    for falling in bodies()? {
        let expected = falling.time()?;
        for (name, floor) in floors()? {
            let case = "falling shapes";
            let scene = Scene::builder("fall").body(floor).body(falling.body()?).duration_s(1.02 * expected).build()?;
            let mut record = Recorder::default();
            let report = match Simulation::new(&scene)?.estimating(ErrorEstimation::Off).run_observed(&mut record) {
                Ok(report) => report,
                Err(error) => {
                    rows.push(Row::broken(case, &format!("{} on {name}: runs", falling.name), error.to_string()));
                    continue;
                }
            };
            let landing =
                record.events.iter().find(|event| event.kind == EventKind::Impact).map_or(f64::NAN, |e| e.t_s);
            let quantity = format!("{} on {name}: time to fall, relative error", falling.name);
            rows.push(Row::at_most(case, &quantity, TIME_TOLERANCE, (landing / expected - 1.0).abs()));
            let sideways = report.bodies[1].state.pose.translation.truncate().length();
            rows.push(Row::at_most(case, &format!("{} on {name}: drift sideways, m", falling.name), STILL_M, sideways));
        }
    }
    Ok(rows)
}

/// Shapes that lie or stand in balance on the floors for ten seconds.
pub(super) fn rest(_: &Context) -> CaseResult {
    let side = |shape: Shape, primitive: Primitive, name: &'static str, turn: DVec3, height: f64| {
        (name, shape, primitive, Rotation::from_rotation_vector(turn), height)
    };
    let cone_half_angle = f64::atan2(0.2, 1.0);
    let cylinder = || -> Result<_, Box<dyn Error>> {
        Ok((Shape::cylinder(0.2, 1.0)?, Primitive::Cylinder(Cylinder::new(0.2, 1.0)?)))
    };
    let cone = || -> Result<_, Box<dyn Error>> { Ok((Shape::cone(0.2, 1.0)?, Primitive::Cone(Cone::new(0.2, 1.0)?))) };
    let (standing, lying, upright, leaning) = (cylinder()?, cylinder()?, cone()?, cone()?);
    let torus = (Shape::torus(0.5, 0.1)?, Primitive::Torus(Torus::new(0.5, 0.1)?));
    let capsule = (Shape::capsule(0.2, 1.0)?, Primitive::Capsule(Capsule::new(0.2, 1.0)?));
    let bodies = [
        side(standing.0, standing.1, "standing cylinder", DVec3::Z * 0.3, 0.5),
        side(lying.0, lying.1, "lying cylinder", DVec3::Y * FRAC_PI_2, 0.2),
        side(upright.0, upright.1, "standing cone", DVec3::Z * 0.3, 0.25),
        side(
            leaning.0,
            leaning.1,
            "lying cone",
            DVec3::Y * (FRAC_PI_2 + cone_half_angle),
            0.75 * cone_half_angle.sin(),
        ),
        side(torus.0, torus.1, "lying torus", DVec3::Z * (PI / 7.0), 0.1),
        side(capsule.0, capsule.1, "lying capsule", DVec3::Y * FRAC_PI_2, 0.2),
    ];
    let mut rows = Vec::new();
    for (name, shape, primitive, rotation, height) in bodies {
        let properties = primitive.solid(Mass::new(1.0)?)?;
        for (floor_name, floor) in floors()? {
            let body = Body::movable(name, properties)
                .geometry(shape.clone().into())
                .pose(Pose::new(rotation, DVec3::new(0.03, 0.02, height)));
            let scene = Scene::builder("rest").body(floor).body(body).duration_s(10.0).build()?;
            let quantity = format!("{name} on {floor_name}: moved in 10 s, m");
            rows.push(match super::Run::of(&scene, Effects::Planned) {
                Ok(run) => Row::at_most("resting shapes", &quantity, STILL_M, run.largest_movement_m()),
                Err(error) => Row::broken("resting shapes", &quantity, error.to_string()),
            });
        }
    }
    Ok(rows)
}
