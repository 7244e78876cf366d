"""Kerf: a broad phase for numpy, and what sees through it. See docs/PYTHON.md."""

from kerf._kerf import BroadPhase, __version__

__all__ = ["BroadPhase", "__version__"]
