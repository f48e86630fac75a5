// SPDX-License-Identifier: MIT
#pragma once

// The archive that `generate support file` leaves: a zip with one text in it.

#include <QByteArray>

namespace tiller::simulator {

/// A zip archive of one file, not compressed.
QByteArray zipOf(const QByteArray& fileName, const QByteArray& content);

}  // namespace tiller::simulator
