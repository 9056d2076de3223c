//! Colours of manifolds: no two of one colour move the same body, so that four of them can be solved side by side.
//!
//! Each manifold gets the first colour that none before it at the same bodies has (greedy, Welsh and Powell 1967). The
//! colour depends only on the manifolds that are connected with it, so that bodies apart do not change it. Manifolds
//! with an immovable body get their colours from a place of their own: they are solved last, since nothing that they
//! lean on gives way. A body with more manifolds than colours has the others solved one after the other.

/// Colours of manifolds between two movable bodies.
pub(super) const BETWEEN_MOVABLE: u32 = 44;

/// All colours: bits of a word.
const ALL: u32 = 64;

/// The colours of the manifolds between movable bodies.
const MOVABLE_MASK: u64 = (1 << BETWEEN_MOVABLE) - 1;

/// The colour of manifolds that have none: each is a batch of its own.
pub(super) const NO_COLOUR: u32 = ALL;

/// Number of groups of manifolds: the colours, and the one without.
pub(super) const GROUPS: usize = ALL as usize + 1;

/// The colours that the manifolds of each body have so far.
#[derive(Debug, Clone, Default)]
pub(super) struct Colours {
    taken: Vec<u64>,
}

impl Colours {
    /// None taken, for this many bodies.
    pub(super) fn begin(&mut self, bodies: usize) {
        self.taken.clear();
        self.taken.resize(bodies, 0);
    }

    /// The colour of the next manifold of these bodies; `moves` says which of them impulses move.
    pub(super) fn next(&mut self, bodies: [u32; 2], moves: [bool; 2]) -> u32 {
        let [a, b] = bodies.map(|body| body as usize);
        let of = |body: usize, moves: bool| if moves { self.taken[body] } else { 0 };
        let taken = of(a, moves[0]) | of(b, moves[1]);
        let allowed = if moves == [true, true] { MOVABLE_MASK } else { !MOVABLE_MASK };
        let colour = (!taken & allowed).trailing_zeros();
        if colour < ALL {
            for (body, moves) in [(a, moves[0]), (b, moves[1])] {
                if moves {
                    self.taken[body] |= 1 << colour;
                }
            }
        }
        colour
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A chain of bodies needs two colours, a contact with the ground one of the others; a body with a hundred contacts
    /// has no colour left for the last ones.
    #[test]
    fn neighbours_differ() {
        let mut colours = Colours::default();
        colours.begin(200);
        assert_eq!(colours.next([1, 2], [true; 2]), 0);
        assert_eq!(colours.next([2, 3], [true; 2]), 1);
        assert_eq!(colours.next([3, 4], [true; 2]), 0);
        assert_eq!(colours.next([3, 0], [true, false]), BETWEEN_MOVABLE);
        assert_eq!(colours.next([4, 0], [true, false]), BETWEEN_MOVABLE);
        let many: Vec<u32> = (10..110).map(|other| colours.next([5, other], [true; 2])).collect();
        assert_eq!(many[..3], [0, 1, 2]);
        assert_eq!(many[99], NO_COLOUR);
    }
}
