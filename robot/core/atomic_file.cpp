// SPDX-License-Identifier: MIT
#include "robot/core/atomic_file.h"

#include <QDir>
#include <QFileInfo>
#include <QUuid>
#include <cerrno>

#include "robot/platform/file_system.h"

#ifndef Q_OS_WIN
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>
#endif

namespace tiller {

namespace {

/// Follows symbolic links, including links to files that do not exist yet.
QString resolved(const QString& path) {
    QFileInfo info(path);
    constexpr int kMaxLinks = 40;
    for (int links = 0; info.isSymLink() && links < kMaxLinks; ++links) {
        info.setFile(info.symLinkTarget());
    }
    return info.absoluteFilePath();
}

QString temporaryNameFor(const QString& path) {
    // Independent of the file name, which may already have the maximum length.
    return QFileInfo(path).absoluteDir().filePath(
        QStringLiteral(".tiller-%1.tmp").arg(QUuid::createUuid().toString(QUuid::Id128)));
}

QString contextOf(const QString& what, const QString& path) {
    return what.isEmpty() ? QDir::toNativeSeparators(path) : what;
}

Error writeFailure(const QString& what, int systemError, const QString& reason) {
    return {file_system::isDiskFull(systemError) ? ErrorCode::DiskFull : ErrorCode::FileNotWritable, what,
            reason};
}

#ifdef Q_OS_LINUX
/// Opens a file without a directory entry, so that a killed process leaves no file behind.
int openUnnamed(const QString& folder) {
    return ::open(QFile::encodeName(folder).constData(), O_TMPFILE | O_WRONLY | O_CLOEXEC, 0666);
}

bool giveName(int descriptor, const QString& path) {
    const QByteArray link = "/proc/self/fd/" + QByteArray::number(descriptor);
    return ::linkat(AT_FDCWD, link.constData(), AT_FDCWD, QFile::encodeName(path).constData(),
                    AT_SYMLINK_FOLLOW) == 0;
}

/// True if giveName() works, which needs /proc.
bool canGiveNames() {
    return ::access("/proc/self/fd", X_OK) == 0;
}
#endif

}  // namespace

AtomicFile::AtomicFile(const QString& path, const QString& what)
    : path_(resolved(path)), what_(contextOf(what, path)) {}

AtomicFile::~AtomicFile() {
    discard();
}

void AtomicFile::discard() {
    file_.close();
    if (!temporary_.isEmpty()) {
        QFile::remove(temporary_);
        temporary_.clear();
    }
}

Result<void> AtomicFile::fail(int systemError, const QString& reason) {
    error_ = writeFailure(what_, systemError, reason);
    discard();
    return error_;
}

Result<void> AtomicFile::open() {
    error_ = {};
    const QFileInfo old(path_);
    if (old.exists() && !old.isFile()) {
        return fail(EISDIR, QStringLiteral("not a regular file"));
    }
    if (old.exists() && !old.isWritable()) {
        return fail(EACCES, qt_error_string(EACCES));
    }
#ifdef Q_OS_WIN
    temporary_ = temporaryNameFor(path_);
    file_.setFileName(temporary_);
    if (!file_.open(QIODevice::WriteOnly | QIODevice::NewOnly | QIODevice::Unbuffered)) {
        temporary_.clear();
        return fail(EACCES, file_.errorString());
    }
#else
    int descriptor = -1;
#ifdef Q_OS_LINUX
    if (canGiveNames()) {
        descriptor = openUnnamed(old.absolutePath());
    }
#endif
    if (descriptor < 0) {
        temporary_ = temporaryNameFor(path_);
        descriptor =
            ::open(QFile::encodeName(temporary_).constData(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
        if (descriptor < 0) {
            const int systemError = errno;
            temporary_.clear();
            return fail(systemError, qt_error_string(systemError));
        }
    }
    file_.open(descriptor, QIODevice::WriteOnly | QIODevice::Unbuffered, QFileDevice::AutoCloseHandle);
    struct stat status {};
    if (::stat(QFile::encodeName(path_).constData(), &status) == 0) {
        // Only privileged users may change the owner, but a user may set the group to another of the user's
        // groups. Both changes clear mode bits, so set the mode last.
        mode_t mode = status.st_mode & 07777;
        if (::fchown(descriptor, status.st_uid, status.st_gid) != 0 &&
            ::fchown(descriptor, static_cast<uid_t>(-1), status.st_gid) != 0) {
            // The file keeps the user's current group, which gets only the permissions of others.
            mode &= ~static_cast<mode_t>(070) | (mode & 07) << 3;
            errno = 0;
        }
        if (::fchmod(descriptor, mode) != 0) {
            return fail(errno, qt_error_string(errno));
        }
    }
#endif
    return {};
}

Result<void> AtomicFile::write(std::string_view bytes) {
    if (!file_.isOpen()) {
        return error_.code != ErrorCode::None ? error_
                                              : writeFailure(what_, EBADF, QStringLiteral("not open"));
    }
    errno = 0;
    const auto size = static_cast<qint64>(bytes.size());
    if (file_.write(bytes.data(), size) != size) {
        return fail(errno, file_.errorString());
    }
    return {};
}

Result<void> AtomicFile::write(const QByteArray& bytes) {
    return write(std::string_view(bytes.constData(), static_cast<std::size_t>(bytes.size())));
}

Result<void> AtomicFile::commit() {
    if (!file_.isOpen()) {
        return error_.code != ErrorCode::None ? error_
                                              : writeFailure(what_, EBADF, QStringLiteral("not open"));
    }
    if (const int systemError = file_system::flush(file_.handle(), file_system::Flush::All);
        systemError != 0) {
        return fail(systemError, qt_error_string(systemError));
    }
#ifdef Q_OS_LINUX
    if (temporary_.isEmpty()) {
        const QString name = temporaryNameFor(path_);
        if (!giveName(file_.handle(), name)) {
            const int systemError = errno;
            return fail(systemError, qt_error_string(systemError));
        }
        temporary_ = name;
    }
#endif
    file_.unsetError();
    errno = 0;
    file_.close();
    if (file_.error() != QFileDevice::NoError) {
        return fail(errno, file_.errorString());
    }
    if (const int systemError = file_system::replace(temporary_, path_); systemError != 0) {
        return fail(systemError, qt_error_string(systemError));
    }
    temporary_.clear();
    if (const int systemError = file_system::flushFolderOf(path_); systemError != 0) {
        return fail(systemError, qt_error_string(systemError));
    }
    return {};
}

Result<void> writeFileAtomically(const QString& path, const QByteArray& content, const QString& what) {
    AtomicFile file(path, what);
    if (const Result<void> opened = file.open(); !opened) {
        return opened;
    }
    if (const Result<void> written = file.write(content); !written) {
        return written;
    }
    return file.commit();
}

Result<void> replaceFile(const QString& part, const QString& path, const QString& what) {
    const QString context = contextOf(what, path);
    if (const QFileInfo old(resolved(path)); old.exists() && !old.isFile()) {
        return writeFailure(context, EISDIR, QStringLiteral("not a regular file"));
    }
    const auto failure = [&context](int systemError) {
        return writeFailure(context, systemError, qt_error_string(systemError));
    };
    QFile written(part);
    errno = 0;
    if (!written.open(QIODevice::ReadWrite | QIODevice::ExistingOnly)) {
        return writeFailure(context, errno, written.errorString());
    }
    const int syncError = file_system::flush(written.handle(), file_system::Flush::All);
    written.close();
    if (syncError != 0) {
        return failure(syncError);
    }
    if (const int systemError = file_system::replace(part, resolved(path)); systemError != 0) {
        return failure(systemError);
    }
    if (const int systemError = file_system::flushFolderOf(resolved(path)); systemError != 0) {
        return failure(systemError);
    }
    return {};
}

}  // namespace tiller
