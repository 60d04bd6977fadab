"""Columns of numbers."""

from __future__ import annotations

import numbers
import typing

import numpy as np

Array = np.ndarray[typing.Any, np.dtype[np.float64]]


def column_of(key: str, values: typing.Any) -> Array:
    """Real numbers as an array; a TypeError for others."""
    if isinstance(values, np.ma.MaskedArray):
        masked: typing.Any = values.astype(float)
        values = masked.filled(np.nan)
    if hasattr(values, "to_numpy") and getattr(values.dtype, "kind", "") in "iuf":
        column = values.to_numpy(dtype=float, na_value=np.nan)
    else:
        column = np.asarray(values)
    if column.dtype == object and all(isinstance(each, numbers.Real) for each in column.flat):
        column = column.astype(float)
    if column.dtype.kind not in "biuf":
        raise TypeError(f"{key}: needs real numbers, in SI, not {column.dtype}")
    if column.ndim > 1:
        raise ValueError(f"{key}: needs an array of one dimension, not {column.ndim}")
    found: Array = np.atleast_1d(column).astype(float)
    return found
