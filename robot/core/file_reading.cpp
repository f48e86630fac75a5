// SPDX-License-Identifier: MIT
#include "robot/core/file_reading.h"

#include <QDir>
#include <QFileInfo>
#include <algorithm>
#include <cerrno>

#ifdef Q_OS_WIN
#include <io.h>
#include <qt_windows.h>
#else
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>
#endif

namespace tiller {
namespace {

Error readFailure(const QString& path, const QString& reason) {
    return {ErrorCode::FileNotReadable, QDir::toNativeSeparators(path), reason};
}

QString notRegular() {
    return QStringLiteral("not a regular file; pipes, sockets, devices and folders cannot be read");
}

}  // namespace

Result<void> openForReading(QFile& file, const QString& path) {
    file.setFileName(path);
#ifndef Q_OS_WIN
    if (!path.startsWith(QLatin1Char(':'))) {
        const QByteArray name = QFile::encodeName(path);
        struct stat status {};
        // Check before opening, because opening a device can have side effects.
        if (::stat(name.constData(), &status) == 0 && !S_ISREG(status.st_mode)) {
            return readFailure(path, notRegular());
        }
        // O_NONBLOCK: a pipe may have replaced the file since the check.
        const int descriptor = ::open(name.constData(), O_RDONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC);
        if (descriptor < 0) {
            return readFailure(path, qt_error_string(errno));
        }
        if (::fstat(descriptor, &status) != 0 || !S_ISREG(status.st_mode)) {
            ::close(descriptor);
            return readFailure(path, notRegular());
        }
        if (!file.open(descriptor, QIODevice::ReadOnly, QFileDevice::AutoCloseHandle)) {
            ::close(descriptor);
            return readFailure(path, file.errorString());
        }
        return {};
    }
#endif
    if (QFileInfo(path).isDir()) {
        return readFailure(path, notRegular());
    }
    if (!file.open(QIODevice::ReadOnly)) {
        return readFailure(path, file.errorString());
    }
#ifdef Q_OS_WIN
    if (file.handle() >= 0 &&
        GetFileType(reinterpret_cast<HANDLE>(_get_osfhandle(file.handle()))) != FILE_TYPE_DISK) {
        file.close();
        return readFailure(path, notRegular());
    }
#endif
    return {};
}

Result<QByteArray> readWholeFile(const QString& path, qint64 maxBytes) {
    QFile file;
    if (const Result<void> opened = openForReading(file, path); !opened) {
        return opened.error();
    }
    QByteArray bytes;
    if (file.size() <= maxBytes) {
        // Read in chunks, up to one byte beyond the limit, because system files report no size and some are
        // endless.
        constexpr qint64 kPiece = 1 << 20;
        bytes.reserve(file.size());
        for (QByteArray piece; bytes.size() <= maxBytes; bytes += piece) {
            piece = file.read(std::min(kPiece, maxBytes + 1 - bytes.size()));
            if (file.error() != QFileDevice::NoError) {
                return readFailure(path, file.errorString());
            }
            if (piece.isEmpty()) {
                break;
            }
        }
    }
    if (file.size() > maxBytes || bytes.size() > maxBytes) {
        constexpr qint64 kMegabyte = 1024 * 1024;
        return Error{ErrorCode::FileCorrupt,
                     QStringLiteral("%1 is larger than %2 MB, the maximum for such a file")
                         .arg(QFileInfo(path).fileName())
                         .arg(static_cast<double>(maxBytes) / static_cast<double>(kMegabyte)),
                     {}};
    }
    return bytes;
}

}  // namespace tiller
