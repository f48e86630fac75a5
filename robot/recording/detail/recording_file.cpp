// SPDX-License-Identifier: MIT
#include "robot/recording/detail/recording_file.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <algorithm>
#include <cerrno>

#ifdef _WIN32
#include <io.h>
#else
#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>
#endif

namespace tiller::recording {

namespace {

Error fileError(const QFile& file, int systemError, const QString& words) {
    const bool full = systemError == ENOSPC || systemError == EDQUOT;
    // QFile reports "Unknown error" for a full disk.
    return {full ? ErrorCode::DiskFull : ErrorCode::FileNotWritable,
            QDir::toNativeSeparators(file.fileName()), full ? qt_error_string(systemError) : words};
}

/// True for errors from devices, pipes and file systems that do not support syncing.
bool isMeaningless(int systemError) {
    return systemError == EINVAL || systemError == ENOTSUP || systemError == EROFS;
}

int writeBack(int descriptor) {
#ifdef _WIN32
    return _commit(descriptor);
#elif defined(__APPLE__)
    return ::fsync(descriptor);
#else
    return ::fdatasync(descriptor);
#endif
}

class SystemFile : public RecordingFile {
public:
    Result<void> open(const QString& path) override {
        file_.setFileName(path);
        errno = 0;
        // Truncate only after taking the lock.
        if (!file_.open(QIODevice::WriteOnly | QIODevice::Append | QIODevice::Unbuffered)) {
            return fileError(file_, errno, file_.errorString());
        }
        if (!claim()) {
            const Error taken =
                fileError(file_, 0, QStringLiteral("another recording is writing to this file"));
            file_.close();
            return taken;
        }
        errno = 0;
        if (file_.size() > 0 && !file_.resize(0)) {
            return fileError(file_, errno, file_.errorString());
        }
#ifndef _WIN32
        struct stat status {};
        hasLink_ = ::fstat(file_.handle(), &status) == 0 && status.st_nlink > 0;
#endif
        return syncFolder();
    }

    Result<void> write(std::string_view text, std::size_t& written) override {
        errno = 0;
        const qint64 got = file_.write(text.data(), static_cast<qint64>(text.size()));
        const int systemError = errno;
        written = static_cast<std::size_t>(std::max<qint64>(got, 0));
        return written == text.size() ? Result<void>() : fileError(file_, systemError, file_.errorString());
    }

    Result<void> sync() override {
        errno = 0;
        if (writeBack(file_.handle()) != 0 && !isMeaningless(errno)) {
            const int systemError = errno;
            return fileError(file_, systemError, qt_error_string(systemError));
        }
        return isDeleted() ? fileError(file_, 0, QStringLiteral("the file was deleted during the recording"))
                           : Result<void>();
    }

    void cut(std::int64_t bytes) override {
        file_.resize(bytes);
    }

    Result<void> close() override {
        if (!file_.isOpen()) {
            return {};
        }
        file_.unsetError();
        errno = 0;
        file_.close();
        const int systemError = errno;
        return file_.error() == QFileDevice::NoError ? Result<void>()
                                                     : fileError(file_, systemError, file_.errorString());
    }

private:
    /// Writing to a deleted file succeeds, but its contents are lost when it is closed.
    bool isDeleted() const {
#ifdef _WIN32
        return false;  // an open file cannot be deleted
#else
        struct stat status {};
        return hasLink_ && ::fstat(file_.handle(), &status) == 0 && status.st_nlink == 0;
#endif
    }

    /// Locks the file until it is closed. Returns false if another recording of this or another process uses
    /// the file.
    bool claim() {
#ifdef _WIN32
        return true;
#else
        return ::flock(file_.handle(), LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK;
#endif
    }

    /// Syncs the directory entry. Otherwise, after a power failure, the disk may contain the rows without a
    /// directory entry.
    Result<void> syncFolder() {
#ifndef _WIN32
        const QByteArray folder = QFile::encodeName(QFileInfo(file_.fileName()).absolutePath());
        const int descriptor = ::open(folder.constData(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
        if (descriptor < 0) {
            return {};  // the user may have only write permission for the folder
        }
        errno = 0;
        const bool failed = ::fsync(descriptor) != 0 && !isMeaningless(errno);
        const int systemError = errno;
        ::close(descriptor);
        if (failed) {
            return fileError(file_, systemError, qt_error_string(systemError));
        }
#endif
        return {};
    }

    QFile file_;
    bool hasLink_ = false;  ///< false on file systems without link counts
};

}  // namespace

std::unique_ptr<RecordingFile> systemFile() {
    return std::make_unique<SystemFile>();
}

}  // namespace tiller::recording
