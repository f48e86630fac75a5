// SPDX-License-Identifier: MIT
#pragma once

// The archive created by `generate support file`: a zip file with one text.

#include <QByteArray>

namespace tiller::simulator {

/// A zip archive of one file, not compressed.
QByteArray zipOf(const QByteArray& fileName, const QByteArray& content);

}  // namespace tiller::simulator
