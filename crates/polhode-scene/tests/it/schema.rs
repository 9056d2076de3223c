//! The JSON Schema lists what is accepted, and nothing that is not yet available.

use polhode::scene::Integrator;
use polhode_scene::schema;
use serde_json::Value;

/// All keys of all `properties`, and all words of all enumerations.
fn collect(value: &Value, words: &mut Vec<String>) {
    match value {
        Value::Object(map) => {
            for (key, value) in map {
                match (key.as_str(), value) {
                    ("properties", Value::Object(properties)) => words.extend(properties.keys().cloned()),
                    ("const", Value::String(word)) => words.push(word.clone()),
                    ("enum", Value::Array(members)) => {
                        words.extend(members.iter().filter_map(|word| word.as_str().map(str::to_owned)));
                    }
                    _ => {}
                }
                collect(value, words);
            }
        }
        Value::Array(values) => values.iter().for_each(|value| collect(value, words)),
        _ => {}
    }
}

/// Every key and word of the format is there.
#[test]
fn lists_what_is_accepted() {
    let schema = schema();
    assert_eq!(serde_json::from_str::<Value>(&schema.to_string()).unwrap(), schema);
    assert!(schema["$schema"].as_str().is_some_and(|draft| draft.contains("json-schema.org")));
    let mut words = Vec::new();
    collect(&schema, &mut words);
    let accepted = "format name duration gravity method output materials pairs bodies forces no_contact interval \
        friction restitution tier step substeps integrator orientation rotation_rate impact contact response \
        broad_phase tolerance coordinates max_events_per_step crowding crowding_tolerance error fixed shape mass \
        density inertia center_of_mass hollow position rotation_vector velocity angular_velocity material pivot motion \
        sine frequency axis angle times orientations rotation_vectors box sphere half_space \
        points convex mesh size radius normal positions file thesis stepped fast accurate quaternion \
        quaternion-unnormalized quaternion-three-numbers matrix matrix-unorthogonalized euler-angles angular-momentum \
        angular-velocity type point_gravity mutual_gravity force torque drag spring center mu constant body frame \
        point signal world sinusoid table polynomial amplitude frequency_hz phase law linear quadratic translational \
        rotational wind points anchor stiffness rest_length damping propagation simultaneous reflection poisson \
        energetic pulse micro-collisions collision_envelope propagation_order key depth random pulse_exponent hertz \
        restitution_yield_speed restitution_slope least-force active-set sequential-impulses nncg heuristic guesses \
        constraint impulse impulse-projection rotational wind points anchor stiffness rest_length damping propagation \
        simultaneous reflection least-force active-set sequential-impulses nncg constraint impulse impulse-projection \
        impulse-unconditional title description static_friction rolling_friction spinning_friction along across \
        surface_velocity restitution_law approximate parts joints ball hinge universal fixed slider cylindrical planar \
        anchor axis axes normal breakaway coefficient screw lead tracks track curve line circle helix path spline wave \
        cycloid closed start heading up curvature coefficients advance turns wavelength lowest side springs follows \
        tangent reach ends free stops straight gears breaks_at moment ratio coordinates rate values distance \
        tangential_restitution arrays layout grid pyramid wall drop counts spacing base length height turn count seed \
        stronge poisson newton whittaker chatterjee-ruina penalty hertz hunt-crossley plain mindlin regularised \
        off quick full penetration_m stiffness_n_m slip_speed_m_s youngs_modulus_pa poisson_ratio";
    let integrators = Integrator::ALL.map(Integrator::name);
    for word in accepted.split_whitespace().chain(integrators) {
        assert!(words.iter().any(|known| known == word), "{word} is missing");
    }
    let planned = "interior-point";
    for word in planned.split_whitespace() {
        assert!(!words.iter().any(|known| known == word), "{word} is not yet available");
    }
}

/// Tables are closed, so that editors mark spelling mistakes.
#[test]
fn refuses_unknown_keys() {
    let schema = schema();
    assert_eq!(schema["additionalProperties"], false);
    assert_eq!(schema["$defs"]["BodyEntry"]["additionalProperties"], false);
    for (name, definition) in schema["$defs"].as_object().unwrap() {
        if definition["type"] == "object" {
            assert_eq!(definition["additionalProperties"], false, "{name}");
        }
    }
    assert_eq!(schema["required"], serde_json::json!(["format"]));
}
