//! Which methods of a chain were tried.
//!
//! A chain tries one method after the other until one gives an answer that is accepted. Its report names the method
//! that answered, and the set of those that were tried.

use std::fmt;
use std::marker::PhantomData;

/// A method of a chain.
pub trait ChainMethod: Copy + PartialEq + 'static {
    /// All methods, each at the place that [`place`](Self::place) gives; at most 16.
    const ALL: &'static [Self];

    /// The name of the method in words.
    fn name(self) -> &'static str;

    /// Its place in [`ALL`](Self::ALL).
    fn place(self) -> usize {
        Self::ALL.iter().position(|method| *method == self).unwrap_or(Self::ALL.len())
    }
}

/// A set of methods of one chain.
///
/// ```
/// use polhode_response::MethodSet;
/// use polhode_response::friction::FrictionMethod;
/// let mut tried = MethodSet::default();
/// tried.insert(FrictionMethod::WarmNewton);
/// assert!(tried.contains(FrictionMethod::WarmNewton) && !tried.contains(FrictionMethod::Newton));
/// assert_eq!(tried.to_string(), "warm-newton");
/// ```
pub struct MethodSet<M> {
    bits: u16,
    of: PhantomData<M>,
}

impl<M> MethodSet<M> {
    /// No method.
    pub const NONE: Self = Self { bits: 0, of: PhantomData };
}

impl<M: ChainMethod> MethodSet<M> {
    /// Adds a method.
    pub fn insert(&mut self, method: M) {
        self.bits |= Self::bit(method);
    }

    /// Whether a method is in the set.
    pub fn contains(self, method: M) -> bool {
        self.bits & Self::bit(method) != 0
    }

    /// Whether no method is in the set.
    pub const fn is_empty(self) -> bool {
        self.bits == 0
    }

    /// How many methods are in the set.
    pub const fn len(self) -> usize {
        self.bits.count_ones() as usize
    }

    /// Adds all methods of another set.
    pub fn extend(&mut self, other: Self) {
        self.bits |= other.bits;
    }

    /// The methods, in the order of [`ChainMethod::ALL`].
    pub fn iter(self) -> impl Iterator<Item = M> {
        M::ALL.iter().copied().filter(move |method| self.contains(*method))
    }

    /// The methods of these names.
    #[cfg(feature = "census")]
    pub(crate) fn of_names(names: &[&str]) -> Self {
        M::ALL.iter().copied().filter(|method| names.contains(&method.name())).collect()
    }

    fn bit(method: M) -> u16 {
        1_u16.checked_shl(method.place() as u32).unwrap_or(0)
    }
}

// Derived, these would ask the same of the methods.
impl<M> Clone for MethodSet<M> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<M> Copy for MethodSet<M> {}

impl<M> Default for MethodSet<M> {
    fn default() -> Self {
        Self::NONE
    }
}

impl<M> PartialEq for MethodSet<M> {
    fn eq(&self, other: &Self) -> bool {
        self.bits == other.bits
    }
}

impl<M> Eq for MethodSet<M> {}

impl<M: ChainMethod> fmt::Display for MethodSet<M> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (place, method) in self.iter().enumerate() {
            write!(f, "{}{}", if place == 0 { "" } else { ", " }, method.name())?;
        }
        Ok(())
    }
}

impl<M: ChainMethod> fmt::Debug for MethodSet<M> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{{{self}}}")
    }
}

impl<M: ChainMethod> FromIterator<M> for MethodSet<M> {
    fn from_iter<I: IntoIterator<Item = M>>(methods: I) -> Self {
        let mut set = Self::default();
        methods.into_iter().for_each(|method| set.insert(method));
        set
    }
}
