"""How a walk ends: the outcomes, and what each of them means."""

from enum import StrEnum


class Outcome(StrEnum):
    """How a walk, or one swing phase of it, ended.

    Ahead is where the walker walks to, the direction of the x-axis. The region of the model's touchdown says
    where a touchdown counts; elsewhere, both feet on the ground mean a foot behind.
    """

    WALKED = "walked"
    """All steps were walked; the swing phase ended with a touchdown."""
    ROCKS_BACK = "rocks_back"
    """The walker turned back and came onto the foot behind again. A step back is not part of a model, so that
    the walk ends there."""
    STOPS = "stops"
    """The walker is at rest: it stands on both feet without moving, or its rates have died out in between."""
    GOES_UPHILL = "goes_uphill"
    """The walk begins with a walker that moves back, up the slope, and it comes onto the foot behind."""
    GOES_BACKWARD = "goes_backward"
    """The same where back is not uphill: on level ground, or where the ground rises ahead."""
    FALLS_FORWARD = "falls_forward"
    """The stance leg went beyond the horizontal ahead."""
    FALLS_BACKWARD = "falls_backward"
    """The stance leg went beyond the horizontal behind."""
    NO_TOUCHDOWN = "no_touchdown"
    """Nothing of all this happened within the time limit."""
    FAILED = "failed"
    """The integrator gave up: the motion leaves the range of numbers."""

    @property
    def words(self) -> str:
        """The outcome as it is printed."""
        return self.value.replace("_", " ")

    @property
    def sentence(self) -> str:
        """What it means, in a sentence; empty where the word says it all."""
        return _SENTENCES.get(self, "")


_SENTENCES = {
    Outcome.ROCKS_BACK: "The walker lacked the energy to pass over its stance foot and came back onto the "
    "foot behind.",
    Outcome.STOPS: "The walker is at rest.",
    Outcome.GOES_UPHILL: "The walker moves back, up the slope, onto the foot behind.",
    Outcome.GOES_BACKWARD: "The walker moves back, onto the foot behind.",
    Outcome.FALLS_FORWARD: "The stance leg went beyond the horizontal ahead.",
    Outcome.FALLS_BACKWARD: "The stance leg went beyond the horizontal behind.",
    Outcome.NO_TOUCHDOWN: "The swing foot did not touch down within the time limit.",
    Outcome.FAILED: "The motion leaves the range of numbers.",
}
