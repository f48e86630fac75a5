// SPDX-License-Identifier: MIT
// Placeholder until the first file of this room exists; remove it then.
