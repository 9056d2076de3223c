"""Distributions that a sweep draws from."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

#: Bits of a share: with half of its last place added it is a float exactly, and neither 0 nor 1.
_BITS = 52


@dataclass(frozen=True)
class Distribution:
    """What a value is drawn from. ``at`` is all that one of your own needs."""

    def at(self, share: float) -> Any:
        """The value that this share of all draws lies below; ``share`` is between 0 and 1, without both."""
        raise NotImplementedError

    def draw(self, seed: int, run: int, key: str) -> Any:
        """The value of a run: it depends on nothing but seed, run and key."""
        from hashlib import blake2b

        digest = blake2b(f"{seed}\n{run}\n{key}".encode(), digest_size=8).digest()
        return self.at(((int.from_bytes(digest, "big") >> (64 - _BITS)) + 0.5) / 2**_BITS)


@dataclass(frozen=True)
class Normal(Distribution):
    """The normal distribution.

    >>> import polhode as ph
    >>> ph.Normal(1, 0.01).at(0.5)
    1.0
    """

    mean: float
    deviation: float

    def __post_init__(self) -> None:
        _finite(self, mean=self.mean, deviation=self.deviation)
        if self.deviation < 0:
            raise ValueError(
                f"{self}: deviation = {self.deviation} is below 0, its limit: give what the draws differ by"
            )

    def at(self, share: float) -> float:
        from statistics import NormalDist

        return self.mean + self.deviation * NormalDist().inv_cdf(share)


@dataclass(frozen=True)
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

    def __post_init__(self) -> None:
        _finite(self, median=self.median, spread=self.spread)
        if self.median <= 0 or self.spread < 0:
            raise ValueError(f"{self}: median is above 0, and spread not below it")

    def at(self, share: float) -> float:
        return self.median * math.exp(Normal(0.0, self.spread).at(share))


@dataclass(frozen=True)
class Uniform(Distribution):
    """All values between two are as probable as each other.

    >>> import polhode as ph
    >>> ph.Uniform(0.2, 0.6).at(0.25)
    0.3
    """

    low: float
    high: float

    def __post_init__(self) -> None:
        _finite(self, low=self.low, high=self.high)
        if self.low > self.high:
            raise ValueError(f"{self}: low = {self.low} is above high = {self.high}, its limit: exchange them")

    def at(self, share: float) -> float:
        return self.low + (self.high - self.low) * share


@dataclass(frozen=True)
class Choice(Distribution):
    """Each of some values is as probable as the others.

    >>> import polhode as ph
    >>> ph.Choice(("newton", "poisson")).at(0.7)
    'poisson'
    """

    values: tuple[Any, ...]

    def __post_init__(self) -> None:
        if isinstance(self.values, str) or len(self.values) == 0:
            raise ValueError(f"Choice of {self.values!r}: give a tuple of at least one value")
        object.__setattr__(self, "values", tuple(self.values))

    def at(self, share: float) -> Any:
        return self.values[int(share * len(self.values))]


def _finite(distribution: Distribution, **given: Any) -> None:
    for name, value in given.items():
        if isinstance(value, bool) or not isinstance(value, (int, float)) and not hasattr(value, "__float__"):
            raise TypeError(f"{type(distribution).__name__}: {name} = {value!r} is no number")
        if not math.isfinite(value):
            raise ValueError(f"{type(distribution).__name__}: {name} = {value} is not finite")
        object.__setattr__(distribution, name, float(value))
