# SPDX-License-Identifier: MIT
"""The part of the Robotics Toolbox for Python that listing 5 uses."""
from . import tools
