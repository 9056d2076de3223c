//! What a factorisation in the velocities of bodies costs: counts of blocks, which no clock can disturb.
//!
//! Contacts do not enter: only bodies that touch. A chain is eliminated without a new coupling, a wall of one height
//! at a cost that is linear in its length, and a pyramid, which is as high as it is wide, at somewhat more.

use super::body_scenes::{BodyScene, chain, pyramid, tower, wall};
use polhode_response::sparse::Elimination;

fn elimination(scene: &BodyScene) -> Elimination {
    Elimination::of(&scene.problem())
}

#[test]
fn a_chain_is_eliminated_without_a_new_coupling() {
    for links in [10, 1000] {
        let elimination = elimination(&chain(links));
        assert_eq!(elimination.factor_blocks(), 2 * links - 1);
        assert_eq!(elimination.block_products(), links - 1);
    }
}

#[test]
fn more_contacts_between_the_same_bodies_cost_no_block() {
    let few = tower(20, 0.5);
    let mut many = few.clone();
    many.contacts = few.contacts.iter().flat_map(|contact| vec![*contact; 50]).collect();
    assert_eq!(elimination(&few).factor_blocks(), elimination(&many).factor_blocks());
}

#[test]
fn a_long_wall_costs_in_proportion_to_its_length() {
    let (short, long) = (elimination(&wall(40, 6, 0.5)), elimination(&wall(400, 6, 0.5)));
    assert!(long.block_products() < 11 * short.block_products());
    assert!(long.factor_blocks() < 11 * short.factor_blocks());
}

/// A pyramid four times as large is twice as high: blocks grow a little more than four times, products by eight times
/// or less, which is the power 3/2 of nested dissection, the least that is possible for a plane graph.
#[test]
fn a_large_pyramid_costs_what_nested_dissection_promises() {
    let (small, large) = (elimination(&pyramid(80, 0.5)), elimination(&pyramid(160, 0.5)));
    let ratio = |f: fn(&Elimination) -> usize| f(&large) as f64 / f(&small) as f64;
    assert!(ratio(Elimination::factor_blocks) < 6.0, "{}", ratio(Elimination::factor_blocks));
    assert!(ratio(Elimination::block_products) < 9.0, "{}", ratio(Elimination::block_products));
}
