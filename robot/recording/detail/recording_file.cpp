// SPDX-License-Identifier: MIT
#include "robot/recording/detail/recording_file.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <algorithm>
#include <cerrno>

#include "robot/platform/file_system.h"

namespace tiller::recording {

namespace {

Error fileError(const QFile& file, int systemError, const QString& words) {
    const bool full = file_system::isDiskFull(systemError);
    // QFile reports "Unknown error" for a full disk.
    return {full ? ErrorCode::DiskFull : ErrorCode::FileNotWritable,
            QDir::toNativeSeparators(file.fileName()), full ? qt_error_string(systemError) : words};
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
        if (!file_system::lock(file_.handle())) {
            const Error taken =
                fileError(file_, 0, QStringLiteral("another recording is writing to this file"));
            file_.close();
            return taken;
        }
        errno = 0;
        if (file_.size() > 0 && !file_.resize(0)) {
            return fileError(file_, errno, file_.errorString());
        }
        hasLink_ = file_system::linkCount(file_.handle()) > 0;
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
        const int systemError = file_system::flush(file_.handle(), file_system::Flush::Contents);
        if (systemError != 0) {
            return fileError(file_, systemError, qt_error_string(systemError));
        }
        return isDeleted() ? fileError(file_, 0, QStringLiteral("the file was deleted during the recording"))
                           : Result<void>();
    }

    void cut(std::int64_t bytes) override { file_.resize(bytes); }

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
    bool isDeleted() const { return hasLink_ && file_system::linkCount(file_.handle()) == 0; }

    Result<void> syncFolder() {
        const int systemError = file_system::flushFolderOf(file_.fileName());
        return systemError == 0 ? Result<void>()
                                : fileError(file_, systemError, qt_error_string(systemError));
    }

    QFile file_;
    bool hasLink_ = false;  ///< false on file systems without link counts
};

}  // namespace

std::unique_ptr<RecordingFile> systemFile() {
    return std::make_unique<SystemFile>();
}

}  // namespace tiller::recording
