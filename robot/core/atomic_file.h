// SPDX-License-Identifier: MIT
#pragma once

// Writes a file completely or not at all. QSaveFile reports success even if its last flush fails, so that on
// a full disk an empty file can replace a small file. This class checks every step: writing, flushing to the
// storage device, replacing the old file and flushing the folder. After a crash, a full disk or a power
// failure, either the old or the new file exists.

#include <QByteArray>
#include <QFile>
#include <QString>
#include <string_view>

#include "robot/core/result.h"

namespace tiller {

/// A file that replaces `path` when commit() succeeds. Until then, the old file is unchanged. An object that
/// is destroyed before commit() leaves no new file.
/// Errors   of every call: DiskFull, FileNotWritable; the context is the path or the given text,
///          controllerMessage contains the system's reason
/// Threads  one at a time. Blocks: for the file system. Real-time: no
class AtomicFile {
public:
    /// path  target file; a symbolic link is followed. The permissions and the owner of an existing file are kept.
    /// what  context of errors, e.g. "export to plot.csv"; empty: the path
    explicit AtomicFile(const QString& path, const QString& what = {});
    ~AtomicFile();
    AtomicFile(const AtomicFile&) = delete;
    AtomicFile& operator=(const AtomicFile&) = delete;

    /// Creates the temporary file in the folder of `path`.
    Result<void> open();
    /// Appends to the temporary file.
    Result<void> write(std::string_view bytes);
    Result<void> write(const QByteArray& bytes);  ///< Appends to the temporary file.
    /// Replaces the old file and closes the object.
    Result<void> commit();

private:
    Result<void> fail(int systemError, const QString& reason);
    void discard();

    QString path_;       ///< path of the target file, with symbolic links resolved
    QString what_;       ///< context of errors
    QString temporary_;  ///< name of the temporary file; empty if it has no name
    QFile file_;
    Error error_;  ///< error of the first failed step
};

/// Replaces the content of the file `path` in one step.
/// what     context of errors, e.g. "export to plot.csv"; empty: the path
/// Errors   DiskFull, FileNotWritable
/// Threads  any. Blocks: for the file system. Real-time: no
Result<void> writeFileAtomically(const QString& path, const QByteArray& content, const QString& what = {});

/// Flushes the closed file `part` (written by a library) and renames it to `path` in the same folder.
/// Replaces an existing file. After an error, `part` still exists.
/// what     context of errors; empty: the path
/// Errors   DiskFull, FileNotWritable
/// Threads  any. Blocks: for the file system. Real-time: no
Result<void> replaceFile(const QString& part, const QString& path, const QString& what = {});

}  // namespace tiller
