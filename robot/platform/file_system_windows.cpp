// SPDX-License-Identifier: MIT
#include <io.h>
#include <qt_windows.h>

#include <QDir>
#include <cerrno>
#include <string>

#include "robot/platform/file_system.h"

namespace tiller::file_system {

namespace {

HANDLE handleOf(int descriptor) {
    return reinterpret_cast<HANDLE>(_get_osfhandle(descriptor));
}

/// The prefix permits paths of more than 260 characters.
std::wstring nativePath(const QString& path) {
    const QString native = QDir::toNativeSeparators(QDir::cleanPath(QDir(path).absolutePath()));
    const QString prefix =
        native.startsWith(QLatin1String("\\\\")) ? QStringLiteral("\\\\?\\UNC") : QStringLiteral("\\\\?\\");
    return (prefix + (native.startsWith(QLatin1String("\\\\")) ? native.mid(1) : native)).toStdWString();
}

}  // namespace

int flush(int descriptor, Flush /*what*/) {
    const HANDLE file = handleOf(descriptor);
    if (FlushFileBuffers(file) != 0 || GetFileType(file) != FILE_TYPE_DISK) {
        return 0;
    }
    const DWORD error = GetLastError();
    return error == ERROR_DISK_FULL || error == ERROR_HANDLE_DISK_FULL ? ENOSPC : EIO;
}

int flushFolderOf(const QString& /*path*/) {
    return 0;  // replace() has flushed it, and NTFS logs new entries
}

int replace(const QString& from, const QString& to) {
    const std::wstring source = nativePath(from);
    const std::wstring target = nativePath(to);
    // ReplaceFile() keeps the access rights of the existing file, but fails if there is no file.
    if (ReplaceFileW(target.c_str(), source.c_str(), nullptr, REPLACEFILE_IGNORE_MERGE_ERRORS, nullptr,
                     nullptr) != 0 ||
        MoveFileExW(source.c_str(), target.c_str(), MOVEFILE_REPLACE_EXISTING | MOVEFILE_WRITE_THROUGH) !=
            0) {
        return 0;
    }
    const DWORD error = GetLastError();
    return error == ERROR_DISK_FULL || error == ERROR_HANDLE_DISK_FULL ? ENOSPC : EACCES;
}

bool isDiskFull(int error) {
    return error == ENOSPC;
}

bool lock(int descriptor) {
    // A lock prevents others from reading the locked byte, so this byte is far behind the end of the file.
    OVERLAPPED place{};
    place.OffsetHigh = 0x7fffffff;
    return LockFileEx(handleOf(descriptor), LOCKFILE_EXCLUSIVE_LOCK | LOCKFILE_FAIL_IMMEDIATELY, 0, 1, 0,
                      &place) != 0 ||
           GetLastError() != ERROR_LOCK_VIOLATION;
}

int linkCount(int descriptor) {
    BY_HANDLE_FILE_INFORMATION information{};
    return GetFileInformationByHandle(handleOf(descriptor), &information) != 0
               ? static_cast<int>(information.nNumberOfLinks)
               : 0;
}

}  // namespace tiller::file_system
