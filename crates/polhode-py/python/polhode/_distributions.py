"""Distributions that a sweep draws from."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from collections.abc import Sequence

#: Bits of a share: with half of its last place added it is a float exactly, and neither 0 nor 1.
_BITS = 52


class Distribution:
    """What a value is drawn from. ``at`` is all that one of your own needs; what it has is shown, and never changed."""

    def at(self, share: float) -> Any:
        """The value that this share of all draws lies below; ``share`` is between 0 and 1, without both."""
        raise NotImplementedError

    def draw(self, seed: int, run: int, key: str) -> Any:
        """The value of a run: it depends on nothing but seed, run and key."""
        from hashlib import blake2b

        digest = blake2b(f"{seed}\n{run}\n{key}".encode(), digest_size=8).digest()
        return self.at(((int.from_bytes(digest, "big") >> (64 - _BITS)) + 0.5) / 2**_BITS)

    def __repr__(self) -> str:
        return f"{type(self).__name__}({', '.join(f'{name}={value!r}' for name, value in vars(self).items())})"

    def __eq__(self, other: object) -> bool:
        return type(other) is type(self) and vars(other) == vars(self)

    def __hash__(self) -> int:
        return hash(repr(self))


class Normal(Distribution):
    """The normal distribution.

    >>> import polhode as ph
    >>> ph.Normal(1, 0.01).at(0.5)
    1.0
    """

    mean: float
    deviation: float

    def __init__(self, mean: float, deviation: float) -> None:
        self.mean = _finite("Normal: mean", mean)
        self.deviation = _finite("Normal: deviation", deviation)
        if self.deviation < 0:
            raise ValueError(
                f"{self}: deviation = {self.deviation} is below 0, its limit: give what the draws differ by"
            )

    def at(self, share: float) -> float:
        from statistics import NormalDist

        return self.mean + self.deviation * NormalDist().inv_cdf(share)


class LogNormal(Distribution):
    """A quantity whose logarithm is normal: half of the draws lie below ``median``, most within a factor of 1 +
    ``spread``.

    ``spread`` is the deviation of the natural logarithm.

    >>> import polhode as ph
    >>> ph.LogNormal(0.4, 0.1).at(0.5)
    0.4
    """

    median: float
    spread: float

    def __init__(self, median: float, spread: float) -> None:
        self.median = _finite("LogNormal: median", median)
        self.spread = _finite("LogNormal: spread", spread)
        if self.median <= 0 or self.spread < 0:
            raise ValueError(f"{self}: median is above 0, and spread not below it")

    def at(self, share: float) -> float:
        return self.median * math.exp(Normal(0.0, self.spread).at(share))


class Uniform(Distribution):
    """All values between two are as probable as each other.

    >>> import polhode as ph
    >>> ph.Uniform(0.2, 0.6).at(0.25)
    0.3
    """

    low: float
    high: float

    def __init__(self, low: float, high: float) -> None:
        self.low = _finite("Uniform: low", low)
        self.high = _finite("Uniform: high", high)
        if self.low > self.high:
            raise ValueError(f"{self}: low = {self.low} is above high = {self.high}, its limit: exchange them")

    def at(self, share: float) -> float:
        return self.low + (self.high - self.low) * share


class Choice(Distribution):
    """Each of some values is as probable as the others.

    >>> import polhode as ph
    >>> ph.Choice(("newton", "poisson")).at(0.7)
    'poisson'
    """

    values: tuple[Any, ...]

    def __init__(self, values: Sequence[Any]) -> None:
        if isinstance(values, str) or len(values) == 0:
            raise ValueError(f"Choice of {values!r}: give a tuple of at least one value")
        self.values = tuple(values)

    def at(self, share: float) -> Any:
        return self.values[int(share * len(self.values))]


def _finite(what: str, value: float) -> float:
    if isinstance(value, bool) or not hasattr(value, "__float__"):
        raise TypeError(f"{what} = {value!r} is no number")
    if not math.isfinite(value):
        raise ValueError(f"{what} = {value} is not finite, and it has to be: give a number")
    return float(value)
