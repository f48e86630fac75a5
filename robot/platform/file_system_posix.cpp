// SPDX-License-Identifier: MIT
#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <QFileInfo>
#include <cerrno>
#include <cstdio>

#include "robot/platform/file_system.h"

namespace tiller::file_system {

int flush(int descriptor, Flush what) {
    int result = 0;
    do {
#ifdef __APPLE__
        Q_UNUSED(what)
        result = ::fsync(descriptor);
#else
        result = what == Flush::All ? ::fsync(descriptor) : ::fdatasync(descriptor);
#endif
    } while (result != 0 && errno == EINTR);
    const bool isUnsupported = errno == EINVAL || errno == ENOTSUP || errno == EROFS;
    return result == 0 || isUnsupported ? 0 : errno;
}

int flushFolderOf(const QString& path) {
    const QByteArray folder = QFile::encodeName(QFileInfo(path).absolutePath());
    const int descriptor = ::open(folder.constData(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (descriptor < 0) {
        return 0;  // the user may have only write permission for the folder
    }
    const int error = flush(descriptor, Flush::All);
    ::close(descriptor);
    return error;
}

int replace(const QString& from, const QString& to) {
    return ::rename(QFile::encodeName(from).constData(), QFile::encodeName(to).constData()) == 0 ? 0 : errno;
}

bool isDiskFull(int error) {
    return error == ENOSPC || error == EDQUOT;
}

bool lock(int descriptor) {
    return ::flock(descriptor, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK;
}

int linkCount(int descriptor) {
    struct stat status {};
    return ::fstat(descriptor, &status) == 0 ? static_cast<int>(status.st_nlink) : 0;
}

}  // namespace tiller::file_system
