# SPDX-License-Identifier: MIT
from . import trajectory
