//! `polhode elastic`: the closed form of the confined rectangle, the rigid laws beside a drop, the picture, and bad
//! input.

use crate::Place;

#[test]
fn the_confined_rectangle_has_its_closed_form() {
    let report = Place::new().expect(0, &["elastic", "--confined", "--elements", "50", "--json"]).json();
    let limit = |key: &str| report["quantities"][key]["limit"].as_f64().unwrap();
    assert!((limit("contact_time_s") / report["wave_time_s"].as_f64().unwrap() - 1.0).abs() < 1e-9);
    assert!((limit("impulse_n_s") - 4000.0).abs() < 1e-6);
}

#[test]
fn rigid_laws_stand_beside_a_flat_drop() {
    let place = Place::new();
    let report = place.expect(0, &["elastic", "--elements", "8", "--json"]).json();
    let rigid = report["rigid"].as_array().unwrap();
    let law = |k: usize, key: &str| rigid[k][key].as_f64().unwrap();
    assert_eq!(rigid.len(), 4);
    assert!((law(1, "velocity_up_m_s") - 1.0).abs() < 1e-9, "{report}");
    assert!(law(3, "error") < 0.01 && law(3, "restitution") < 0.95, "{report}");
    let text = place.expect(0, &["elastic", "--elements", "8", "--tilt", "20"]).stdout;
    assert!(text.contains("energy of vibration") && text.contains("simultaneous, best e"), "{text}");
}

#[test]
fn the_picture_has_an_element_a_polygon() {
    let place = Place::new();
    place.expect(0, &["elastic", "--elements", "18", "--tilt", "30", "--picture", "a.svg"]);
    let svg = place.read("a.svg");
    assert_eq!(svg.matches("<polygon").count(), 18, "{svg}");
    assert!(!svg.contains("NaN"));
    let refused = place.expect(2, &["elastic", "--elements", "8", "--picture", "a.png"]);
    assert!(refused.stderr.contains("accepted: .svg"), "{}", refused.stderr);
}

#[test]
fn bad_input_says_what_is_accepted() {
    let place = Place::new();
    for (arguments, says) in [
        (["--width", "nan"], "positive"),
        (["--height", "0"], "positive"),
        (["--height", "1000"], "times as long"),
        (["--speed", "1e-200"], "energy"),
        (["--poisson", "0.5"], "between -1 and 0.5"),
        (["--poisson", "-1"], "between -1 and 0.5"),
        (["--tilt", "91"], "right angle"),
        (["--tilt", "nan"], "finite"),
        (["--step", "1"], "beyond the limit"),
        (["--elements", "0"], "from 1 to"),
        (["--elements", "300000"], "from 1 to"),
        (["--speed", "60"], "fold"),
    ] {
        let run = place.expect(2, &[&["elastic"], &arguments[..]].concat());
        assert!(run.stderr.contains(says), "{arguments:?}: {}", run.stderr);
    }
    let run = place.expect(2, &["elastic", "--tilt", "5", "--confined"]);
    assert!(run.stderr.contains("drop it flat"), "{}", run.stderr);
}
