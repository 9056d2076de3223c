"""Arrays that a program gives, checked: kind, shape and finite numbers."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import ArrayLike, NDArray


def floats(what: str, given: ArrayLike, shape: str, dimensions: int) -> NDArray[np.float64]:
    """Numbers as an array of so many dimensions; ``shape`` is how an error names the shape that is needed."""
    import numpy as np

    needed = f"an array of numbers of shape {shape} is needed"
    try:
        array: NDArray[Any] = np.asarray(given)
    except (TypeError, ValueError) as error:
        raise ValueError(f"{what}: {needed}: {error}") from None
    if array.dtype.kind not in "fiu":
        raise TypeError(f"{what}: {needed}, found numbers of the kind {array.dtype}")
    if array.ndim != dimensions:
        raise ValueError(f"{what}: {needed}, found {array.shape}")
    found = array.astype(np.float64)
    is_finite = np.isfinite(found)
    if not is_finite.all():
        place = np.argwhere(~is_finite)[0]
        raise ValueError(f"{what}: finite numbers are needed, found {found[tuple(place)]} at {place.tolist()}")
    return found


def floats_of_each(what: str, given: ArrayLike, count: int) -> NDArray[np.float64]:
    """One number for each of so many contacts, or one for all of them."""
    import numpy as np

    if np.ndim(given) == 0:
        return np.full(count, floats(what, given, f"({count},)", 0)[()])
    found = floats(what, given, f"({count},)", 1)
    if len(found) != count:
        raise ValueError(f"{what}: a number or an array of shape ({count},) is needed, found {found.shape}")
    return found
