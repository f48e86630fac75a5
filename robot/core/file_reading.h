// SPDX-License-Identifier: MIT
#pragma once

// Opens files that a user has selected. Only regular files are read, because a pipe, a socket or a device
// could block the caller or never end.

#include <QByteArray>
#include <QFile>
#include <QString>

#include "robot/core/result.h"

namespace tiller {

/// Maximum size of a URScript file that is read [bytes].
inline constexpr qint64 kMaxScriptBytes = 16 << 20;

/// Opens `path` for reading into `file`, which must be closed. Never blocks on a pipe or a device. Embedded
/// resources (":/...") are supported.
/// Errors   FileNotReadable, with the reason in controllerMessage
/// Threads  any. Blocks: for the file system. Real-time: no
Result<void> openForReading(QFile& file, const QString& path);

/// Reads the regular file `path` completely.
/// maxBytes  larger files are refused, even if the file system reports a smaller size
/// Errors    FileNotReadable; FileCorrupt if the file is larger than maxBytes
/// Threads   any. Blocks: for the file system. Real-time: no
Result<QByteArray> readWholeFile(const QString& path, qint64 maxBytes);

}  // namespace tiller
