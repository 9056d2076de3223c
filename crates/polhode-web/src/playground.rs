//! The scene that runs in the page.

use crate::fault::thrown;
use crate::files::Files;
use polhode::spatial::{DVec3, MassProperties};
use polhode_scene::{Override, scene_text_of};
use polhode_study::play::{self, PlayError};
use polhode_view::live;
use wasm_bindgen::JsValue;
use wasm_bindgen::prelude::wasm_bindgen;

/// What errors call the text of the page.
const ORIGIN: &str = "scene";

/// Who sets values from outside the text.
const PAGE: &str = "page";

/// A scene that runs, once one is loaded.
#[wasm_bindgen]
#[derive(Debug, Default)]
pub struct Playground {
    files: Files,
    own: Option<play::Playground>,
}

#[wasm_bindgen]
impl Playground {
    /// Without a scene.
    #[wasm_bindgen(constructor)]
    pub fn new() -> Self {
        Self::default()
    }

    /// Adds a file of a mesh or a robot, which scenes name.
    pub fn add_file(&mut self, name: &str, bytes: Vec<u8>) {
        self.files.add(name, bytes);
    }

    /// The text of the scene that a robot file or a table of boxes stands for, which was added before.
    ///
    /// # Errors
    /// When the file is refused.
    pub fn scene_of(&self, name: &str) -> Result<String, JsValue> {
        scene_text_of(name, self.files.given()).map_err(|error| thrown(&error.into()))
    }

    /// Loads a scene; `changes` holds a line `key=value` for each value that is set from outside. What the page shows
    /// of it, as JSON.
    ///
    /// # Errors
    /// When the scene is refused; the one before goes on.
    pub fn load(&mut self, text: &str, changes: &str) -> Result<String, JsValue> {
        let changes: Vec<Override> = changes.lines().filter_map(|line| Override::parse(PAGE, line)).collect();
        let own = play::Playground::new(ORIGIN, text, self.files.given(), &changes).map_err(|error| thrown(&error))?;
        let loaded = own.loaded();
        let shown = live::scene_json(
            &loaded.scene,
            loaded.appearance(),
            &loaded.title(),
            &loaded.description().unwrap_or_default(),
        );
        self.own = Some(own);
        Ok(shown.to_string())
    }

    /// Makes a step; the time reached, s.
    ///
    /// # Errors
    /// When the engine ends the run.
    pub fn step(&mut self) -> Result<f64, JsValue> {
        self.doing(play::Playground::step)
    }

    /// Time reached, s.
    pub fn time(&self) -> f64 {
        self.own.as_ref().map_or(0.0, play::Playground::time)
    }

    /// Whether the end of the scene's duration has been reached.
    pub fn ended(&self) -> bool {
        self.own.as_ref().is_none_or(play::Playground::has_ended)
    }

    /// Poses of all bodies: `px py pz qw qx qy qz` of each.
    pub fn poses(&self) -> Vec<f64> {
        let bodies = self.own.iter().flat_map(play::Playground::bodies);
        let numbers = bodies.flat_map(|body| {
            let (p, [w, x, y, z]) = (body.pose.translation, body.pose.rotation.to_wxyz());
            [p.x, p.y, p.z, w, x, y, z]
        });
        numbers.collect()
    }

    /// Contacts: `a b px py pz nx ny nz N tx ty tz` of each; n from b to a, N and t the force on a.
    pub fn contacts(&self) -> Vec<f64> {
        let contacts = self.own.iter().flat_map(play::Playground::contacts);
        let numbers = contacts.flat_map(|view| {
            let bodies = [view.body_a.index() as f64, view.body_b.index() as f64].into_iter();
            let vectors = [view.point_m, view.normal].into_iter().flat_map(|v| v.to_array());
            bodies.chain(vectors).chain([view.normal_force_n]).chain(view.friction_n.to_array())
        });
        numbers.collect()
    }

    /// Takes hold of a body at a point of the world, m.
    ///
    /// # Errors
    /// When forces do not move the body.
    pub fn grab(&mut self, body: usize, x: f64, y: f64, z: f64) -> Result<(), JsValue> {
        self.doing(|own| own.grab(body, DVec3::new(x, y, z)))
    }

    /// Moves the hand to a point of the world, m.
    pub fn pull(&mut self, x: f64, y: f64, z: f64) {
        if let Some(own) = &mut self.own {
            own.pull(DVec3::new(x, y, z));
        }
    }

    /// The spring: `hx hy hz px py pz fx fy fz`, hand, point that is held, force on the body; empty while none is held.
    pub fn held(&self) -> Vec<f64> {
        let Some((own, (grab, force_n))) = self.own.as_ref().and_then(|own| Some((own, own.held()?))) else {
            return Vec::new();
        };
        let bodies = own.bodies();
        let held_m = bodies.get(grab.body.index()).map_or(grab.hand_m, |body| grab.held_m(&body.pose));
        [grab.hand_m, held_m, force_n].into_iter().flat_map(|v| v.to_array()).collect()
    }

    /// Lets go.
    ///
    /// # Errors
    /// When the engine refuses it.
    pub fn release(&mut self) -> Result<(), JsValue> {
        self.doing(play::Playground::release)
    }

    /// Pushes a body at a point (m) by its mass times a change of velocity (m/s).
    ///
    /// # Errors
    /// When forces do not move the body.
    pub fn push(&mut self, body: usize, point: &[f64], speed: &[f64]) -> Result<(), JsValue> {
        self.doing(|own| {
            let pushed = own.scene().bodies().get(body);
            let mass = pushed.and_then(polhode::Body::mass_properties).map_or(1.0, MassProperties::mass);
            own.push(body, vector(point), vector(speed) * mass)
        })
    }

    /// Moves a body by so much in x, m.
    ///
    /// # Errors
    /// When the body cannot be moved.
    pub fn shift(&mut self, body: usize, by_m: f64) -> Result<(), JsValue> {
        self.doing(|own| own.shift(body, DVec3::X * by_m))
    }

    /// Gives all materials this friction.
    ///
    /// # Errors
    /// When it is refused.
    pub fn set_friction(&mut self, friction: f64) -> Result<(), JsValue> {
        self.doing(|own| own.set_friction(friction))
    }

    /// Gives all materials this restitution.
    ///
    /// # Errors
    /// When it is refused.
    pub fn set_restitution(&mut self, restitution: f64) -> Result<(), JsValue> {
        self.doing(|own| own.set_restitution(restitution))
    }

    /// Friction and restitution of the materials: the largest of each; empty without materials.
    pub fn surface(&self) -> Vec<f64> {
        let materials = self.own.as_ref().map(play::Playground::materials).unwrap_or_default();
        let largest = |value: fn(&polhode::scene::Material) -> f64| materials.iter().map(value).fold(0.0, f64::max);
        vec![largest(polhode::scene::Material::friction), largest(polhode::scene::Material::restitution)]
    }

    /// Goes back to the end of the last step before a time, s; the time reached.
    ///
    /// # Errors
    /// When it lies in the future.
    pub fn rewind(&mut self, t_s: f64) -> Result<f64, JsValue> {
        self.doing(|own| own.rewind(t_s))
    }

    /// As `rewind`, and on to the time within a long step.
    ///
    /// # Errors
    /// When it lies in the future.
    pub fn rewind_to(&mut self, t_s: f64) -> Result<f64, JsValue> {
        self.doing(|own| own.rewind_to(t_s))
    }

    /// How many steps have been made.
    pub fn steps(&self) -> f64 {
        self.own.as_ref().map_or(0.0, |own| own.steps() as f64)
    }

    /// Energies, promise, horizon and hash, as JSON.
    ///
    /// # Errors
    /// When what holds at present cannot be measured.
    pub fn told(&mut self) -> Result<String, JsValue> {
        self.doing(|own| Ok(own.told_json()?.to_string()))
    }

    /// The forces on a body, as JSON.
    ///
    /// # Errors
    /// When forces do not move it.
    pub fn why(&mut self, body: usize) -> Result<String, JsValue> {
        self.doing(|own| Ok(own.why_json(body)?.to_string()))
    }

    /// How far the bodies at rest are from moving, as JSON.
    ///
    /// # Errors
    /// When rows cannot be made of the contacts.
    pub fn margins(&mut self) -> Result<String, JsValue> {
        self.doing(|own| Ok(own.margins_json()?.to_string()))
    }

    /// The strict hash of the run so far, and of how many samples it is, with a space between them.
    pub fn hash(&self) -> String {
        self.own
            .as_ref()
            .map_or_else(String::new, |own| format!("{:016x} {}", own.hash().value(), own.hash().samples()))
    }
}

impl Playground {
    fn doing<T>(&mut self, what: impl FnOnce(&mut play::Playground) -> Result<T, PlayError>) -> Result<T, JsValue> {
        let own =
            self.own.as_mut().ok_or_else(|| JsValue::from_str("{\"message\":\"no scene is loaded\",\"places\":[]}"))?;
        what(own).map_err(|error| thrown(&error))
    }
}

fn vector(numbers: &[f64]) -> DVec3 {
    let at = |k: usize| numbers.get(k).copied().unwrap_or_default();
    DVec3::new(at(0), at(1), at(2))
}
