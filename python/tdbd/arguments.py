"""Converts Python values to arguments of the command line."""

import json
import numbers
import os
from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np


def _text(key: str, value: Any, inside: bool = False) -> str:
    """Returns a value in the form of `--set KEY=VALUE`. Inside a list, a text needs quotes."""
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
    """Converts {"rock.edge_length": "2 mm"} and keywords (__ represents the dot) to ["rock.edge_length=2 mm"]."""
    if settings is not None and not isinstance(settings, Mapping):
        raise TypeError(f"set: found {type(settings).__name__}, expected a dictionary of keys and values")
    every = dict(settings or {}) | {name.replace("__", "."): value for name, value in keywords.items()}
    return [f"{key}={_text(key, value)}" for key, value in every.items()]
