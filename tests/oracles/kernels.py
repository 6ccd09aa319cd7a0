"""What the tests of the backends share: points to compute at, and the comparison to the last bit."""

import re
import shutil

import numpy as np
import pytest

from stridemap.solver.kernels import catalogue

needs_compiler = pytest.mark.skipif(
    not any(map(shutil.which, ("cc", "gcc", "clang"))),
    reason="there is no C compiler to compile kernels with",
)

KERNELS = (
    catalogue.search(12),
    catalogue.limit_cycle(24),
    catalogue.residual(24),
    catalogue.jacobian(24),
    catalogue.trace(48),
)
"""One of each kind that takes section points with periods, and parameters."""


def cases(model, n, seed=3):
    """Guesses near cycles, far from any, and impossible ones, with parameters."""
    rng = np.random.default_rng(seed)
    nz = len(model.section)
    params = np.tile(model.point({}), (n, 1)) * rng.uniform(0.8, 1.2, (n, len(model.parameters)))
    u = np.hstack([rng.uniform(-0.2, 0.2, (n, nz)), rng.uniform(0.3, 3.0, (n, 1))])
    cycle = np.array([*(0.094, -0.146, -0.0026, 0.0029, 0.152)[:nz], 1.18])
    u[::2] = cycle * rng.uniform(0.98, 1.02, (len(u[::2]), nz + 1))
    bad = [np.nan, np.inf, -np.inf, 0.0, 1e200, 1e7]
    u[3 : 3 + 4 * len(bad) : 4] = np.array(bad)[:, None]
    return u, params


def assert_same_bits(one, other):
    """Two lists of arrays are the same to the last bit, but for which NaN a NaN is."""
    for a, b in zip(one, other, strict=True):
        assert a.shape == b.shape
        np.testing.assert_array_equal(np.isnan(a), np.isnan(b))
        numbers = ~np.isnan(a)
        np.testing.assert_array_equal(a[numbers].view(np.int64), b[numbers].view(np.int64))


def script(path, text):
    """A shell script that can be run; returns its path."""
    path.write_text(f"#!/bin/sh\n{text}\n")
    path.chmod(0o755)
    return str(path)


def one_sentence(caught):
    """The message of an exception that pytest caught."""
    message = str(caught.value)
    assert "\n" not in message
    return message


def few(source):
    """C++ of lanes of which a residual and a trace can be called; what nothing calls is hardly compiled."""
    return re.sub(r"^KERNEL\((?!\w+_(residual_12|trace_48)\)).*$", "", source, flags=re.M)
