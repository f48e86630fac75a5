// SPDX-License-Identifier: MIT
#pragma once

// Flushing, locking and replacing files. Functions that return an int return 0, or an error number of errno.h.

#include <QFile>
#include <QString>

namespace tiller::file_system {

enum class Flush {
    Contents,  ///< the contents, and the size if it has changed
    All,       ///< also times and access rights
};

/// Flushes an open file to the storage device. Devices, pipes and file systems that do not support flushing are
/// not an error.
int flush(int descriptor, Flush what);
/// Flushes the directory entry of a file. Otherwise, the file may have no directory entry after a power failure.
int flushFolderOf(const QString& path);
/// Renames a file, and replaces the file with the new name. Call flushFolderOf() afterwards to flush the new
/// name.
int replace(const QString& from, const QString& to);
/// True for the errors of a full disk and of an exhausted quota.
bool isDiskFull(int error);

/// Locks an open file until it is closed.
/// Returns  false if this or another process has locked it; true if the file system does not support locks
bool lock(int descriptor);
/// Number of directory entries of an open file; 0 if it was deleted or if the file system does not count them.
int linkCount(int descriptor);

}  // namespace tiller::file_system
