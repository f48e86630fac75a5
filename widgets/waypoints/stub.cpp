// SPDX-License-Identifier: GPL-3.0-or-later
// Placeholder until the first file of this room exists; remove it then.
