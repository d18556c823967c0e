"""Python values as the command line's words."""

import json
import numbers
import os
from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np


def _text(key: str, value: Any, inside: bool = False) -> str:
    """A value as `--set KEY=` takes it; inside a list a text needs quotes."""
    if isinstance(value, os.PathLike):
        value = os.fspath(value)
    if isinstance(value, np.generic):
        value = value.item()
    if isinstance(value, str):
        return json.dumps(value, ensure_ascii=False) if inside else value
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, numbers.Integral):
        return str(int(value))
    if isinstance(value, numbers.Real):
        return repr(float(value))
    if isinstance(value, (Sequence, np.ndarray)) and not isinstance(value, (bytes, bytearray)):
        return "[" + ", ".join(_text(key, one, inside=True) for one in value) + "]"
    raise TypeError(f"{key}: found {type(value).__name__}, expected a text, a number, True or False, or a list of these")


def assignments(settings: Mapping[str, Any] | None, keywords: Mapping[str, Any]) -> list[str]:
    """["rock.edge_length=2 mm"] of {"rock.edge_length": "2 mm"}, and of keywords, where __ stands for the dot."""
    if settings is not None and not isinstance(settings, Mapping):
        raise TypeError(f"set: found {type(settings).__name__}, expected a dictionary of keys and values")
    every = dict(settings or {}) | {name.replace("__", "."): value for name, value in keywords.items()}
    return [f"{key}={_text(key, value)}" for key, value in every.items()]
