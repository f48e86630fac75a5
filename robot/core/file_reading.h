// SPDX-License-Identifier: MIT
#pragma once

// Opens files that a user chose. Only regular files are read: a pipe, a socket or a device could block the caller or
// never end.

#include <QByteArray>
#include <QFile>
#include <QString>

#include "robot/core/result.h"

namespace tiller {

/// The largest URScript file that is read [bytes].
inline constexpr qint64 kMaxScriptBytes = 16 << 20;

/// Opens `path` for reading into `file`, which must be closed. Never blocks on a pipe or a device. Paths of embedded
/// resources (":/...") are read as well.
/// Errors   FileNotReadable, with the reason in controllerMessage
/// Threads  any. Blocks: for the file system. Real-time: no
Result<void> openForReading(QFile& file, const QString& path);

/// The whole content of the regular file `path`.
/// maxBytes  larger files are refused, whatever size the file system reports for them
/// Errors    FileNotReadable; FileCorrupt when it is larger than maxBytes
/// Threads   any. Blocks: for the file system. Real-time: no
Result<QByteArray> readWholeFile(const QString& path, qint64 maxBytes);

}  // namespace tiller
