"""Events as an array."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray


def structured(
    body_names: list[str], kinds: list[str], bodies: NDArray[np.int64], numbers: NDArray[np.float64]
) -> NDArray[np.void]:
    """Events in order of time: a structured array, which cannot be written to."""
    import numpy as np

    names = np.array([*body_names, ""])
    fields: list[Any] = [("t", "f8"), ("kind", "U13"), ("body_a", names.dtype), ("body_b", names.dtype)]
    fields += [("point", "f8", 3), ("normal", "f8", 3), ("impulse", "f8"), ("energy_change", "f8")]
    events = np.zeros(len(kinds), dtype=fields)
    events["t"], events["kind"] = numbers[:, 0], kinds
    events["body_a"], events["body_b"] = names[bodies[:, 0]], names[bodies[:, 1]]
    events["point"], events["normal"] = numbers[:, 1:4], numbers[:, 4:7]
    events["impulse"], events["energy_change"] = numbers[:, 7], numbers[:, 8]
    events.flags.writeable = False
    # Who owns an array may make it writeable again; who has a view of one that is not may not.
    view: NDArray[np.void] = events.view()
    return view
