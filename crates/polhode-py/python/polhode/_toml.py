"""A scene document as the text of a scene file."""

from __future__ import annotations

import os
import re
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from collections.abc import Iterator, Mapping

_BARE = re.compile(r"[A-Za-z0-9_-]+\Z")
#: What is quoted, or a number in brackets.
_NUMBER = re.compile(r'"[^"]*"|\[(\d+)\]')


def plain(value: Any, where: str = "scene") -> Any:
    """The value in dictionaries, lists, strings and numbers alone; arrays of numpy become lists."""
    if value is None:
        raise TypeError(f"{where}: None is no value of a scene: leave the key out")
    if isinstance(value, (bool, int, float, str)):
        return value
    if hasattr(value, "items"):
        return {_key(key, where): plain(own, f"{where}.{key}") for key, own in value.items()}
    if hasattr(value, "tolist"):
        return plain(value.tolist(), where)
    if isinstance(value, os.PathLike):
        return os.fspath(value)
    if hasattr(value, "name") and isinstance(value.name, str):
        return value.name
    if isinstance(value, (list, tuple)):
        return [plain(own, f"{where}[{number}]") for number, own in enumerate(value)]
    if hasattr(value, "__index__"):
        return int(value)
    if hasattr(value, "__float__"):
        return float(value)
    kind = type(value).__name__
    raise TypeError(f"{where}: {kind} is no value of a scene: numbers, strings, lists and dictionaries are")


def _key(key: object, where: str) -> str:
    if isinstance(key, str):
        return key
    raise TypeError(f"{where}: the key {key!r} is no string")


def path(key: str) -> str:
    """A key with numbers in brackets as a dotted path: ``position[2]`` is ``position.2``."""
    return _NUMBER.sub(lambda found: f".{found[1]}" if found[1] else found[0], key)


def value(given: Any) -> str:
    """A plain value as TOML."""
    if isinstance(given, bool):
        return "true" if given else "false"
    # Kinds of their own, as those of numpy, show themselves otherwise.
    if isinstance(given, int):
        return int.__repr__(given)
    if isinstance(given, float):
        return float.__repr__(given)
    if isinstance(given, str):
        return _text(given)
    if isinstance(given, dict):
        return "{ " + ", ".join(f"{key} = {value(own)}" for key, own in _flat(given)) + " }" if given else "{}"
    return "[" + ", ".join(value(own) for own in given) + "]"


def _text(text: str) -> str:
    import json

    return json.dumps(text, ensure_ascii=False).replace("\x7f", "\\u007f")


def _name(key: str) -> str:
    return key if _BARE.match(key) else _text(key)


def _flat(table: Mapping[str, Any], before: str = "") -> Iterator[tuple[str, Any]]:
    """The values of a table by dotted keys."""
    for key, own in table.items():
        path = before + _name(key)
        if isinstance(own, dict) and own:
            yield from _flat(own, path + ".")
        else:
            yield path, own


def _lines(table: Mapping[str, Any]) -> Iterator[str]:
    for key, own in _flat(table):
        yield f"{key} = {value(own)}"


def document(given: Mapping[str, Any]) -> str:
    """A document as the text of a scene file."""
    tables = plain(given)
    lines: list[str] = []
    sections: list[str] = []
    for key, own in tables.items():
        if isinstance(own, list) and own and all(isinstance(element, dict) for element in own):
            for element in own:
                sections += ["", f"[[{_name(key)}]]", *_lines(element)]
        elif isinstance(own, dict):
            inner = {name: element for name, element in own.items() if isinstance(element, dict)}
            if inner and len(inner) == len(own):
                for name, element in inner.items():
                    sections += ["", f"[{_name(key)}.{_name(name)}]", *_lines(element)]
            else:
                sections += ["", f"[{_name(key)}]", *_lines(own)]
        else:
            lines.append(f"{_name(key)} = {value(own)}")
    return "\n".join([*lines, *sections]) + "\n"
