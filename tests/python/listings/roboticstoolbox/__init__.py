# SPDX-License-Identifier: MIT
"""As much of the Robotics Toolbox for Python as listing 5 uses."""
from . import tools
