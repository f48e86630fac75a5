// SPDX-License-Identifier: MIT
#pragma once

// The archive created by `generate support file`: a zip file with one text file.

#include <QByteArray>

namespace tiller::simulator {

/// Creates an uncompressed zip archive of one file.
QByteArray zipOf(const QByteArray& fileName, const QByteArray& content);

}  // namespace tiller::simulator
