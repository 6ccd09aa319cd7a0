"""What tests of several rooms of the solver compare with."""

import os

import pytest


@pytest.fixture(scope="session")
def heyoka():
    """heyoka, which CI must have."""
    if os.environ.get("CI"):
        import heyoka

        return heyoka
    return pytest.importorskip(
        "heyoka", reason="heyoka is not installed: no Taylor integrator to compare with"
    )
