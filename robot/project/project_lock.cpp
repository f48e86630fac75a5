// SPDX-License-Identifier: MIT
#include "robot/project/project_lock.h"

#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QJsonDocument>
#include <QJsonObject>
#include <QSysInfo>
#include <QUuid>
#include <cerrno>

#include "robot/core/file_reading.h"

#ifdef Q_OS_WIN
#include <io.h>
#include <qt_windows.h>
#else
#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>
#endif

namespace tiller::project {
namespace {

constexpr qint64 kMaxLockBytes = 4096;

QString lockPathFor(const QString& path) {
    const QFileInfo info(path);
    const QString canonical = info.canonicalFilePath();
    const QFileInfo file(canonical.isEmpty() ? info.absoluteFilePath() : canonical);
    return file.absoluteDir().filePath(QStringLiteral(".%1.lock").arg(file.fileName()));
}

QByteArray describeThisProcess() {
    const QByteArray user = qEnvironmentVariableIsSet("USER") ? qgetenv("USER") : qgetenv("USERNAME");
    const QJsonObject owner{
        {QStringLiteral("user"), QString::fromLocal8Bit(user)},
        {QStringLiteral("host"), QSysInfo::machineHostName()},
        {QStringLiteral("program"), QFileInfo(QCoreApplication::applicationFilePath()).fileName()},
        {QStringLiteral("process"), QCoreApplication::applicationPid()},
        {QStringLiteral("since"), QDateTime::currentDateTimeUtc().toString(Qt::ISODate)}};
    return QJsonDocument(owner).toJson(QJsonDocument::Compact) + '\n';
}

}  // namespace

QString LockOwner::toString() const {
    QStringList words;
    if (!user.isEmpty() || !host.isEmpty()) {
        words << (user.isEmpty() ? host
                                 : QCoreApplication::translate("ProjectLock", "%1 on %2").arg(user, host));
    }
    if (!program.isEmpty()) {
        words << program;
    }
    if (process > 0) {
        words << QCoreApplication::translate("ProjectLock", "process %1").arg(process);
    }
    return words.isEmpty() ? QCoreApplication::translate("ProjectLock", "another program")
                           : words.join(QStringLiteral(", "));
}

std::optional<LockOwner> ProjectLock::readOwner() const {
    LockOwner owner;
    if (const auto bytes = readWholeFile(lockPath_, kMaxLockBytes)) {
        const QJsonObject read = QJsonDocument::fromJson(*bytes).object();
        const auto word = [&read](const char* key) {
            return read.value(QLatin1String(key)).toString().left(100);
        };
        owner.user = word("user").isEmpty() ? QFileInfo(lockPath_).owner() : word("user");
        owner.host = word("host");
        owner.program = word("program");
        owner.process = read.value(QLatin1String("process")).toInteger();
        owner.since = QDateTime::fromString(word("since"), Qt::ISODate);
    }
    return owner;
}

#ifdef Q_OS_WIN

// An open file without FILE_SHARE_DELETE cannot be replaced. FILE_FLAG_DELETE_ON_CLOSE removes the file when
// its process ends.
struct ProjectLock::Handle {
    HANDLE file = INVALID_HANDLE_VALUE;
    ~Handle() { CloseHandle(file); }
};

std::optional<LockOwner> ProjectLock::acquire() {
    if (isHeld()) {
        return std::nullopt;
    }
    handle_.reset();
    const HANDLE file =
        CreateFileW(reinterpret_cast<const wchar_t*>(lockPath_.utf16()),
                    GENERIC_READ | GENERIC_WRITE | DELETE, FILE_SHARE_READ | FILE_SHARE_DELETE, nullptr,
                    CREATE_NEW, FILE_ATTRIBUTE_HIDDEN | FILE_FLAG_DELETE_ON_CLOSE, nullptr);
    if (file == INVALID_HANDLE_VALUE) {
        return GetLastError() == ERROR_FILE_EXISTS ? readOwner() : std::nullopt;
    }
    handle_ = std::make_unique<Handle>();
    handle_->file = file;
    const QByteArray bytes = describeThisProcess();
    DWORD written = 0;
    WriteFile(file, bytes.constData(), static_cast<DWORD>(bytes.size()), &written, nullptr);
    return std::nullopt;
}

Result<void> ProjectLock::takeOver() {
    // When the other owner's lock file has been renamed, its handle no longer refers to the lock.
    const QString aside = lockPath_ + QLatin1Char('.') + QUuid::createUuid().toString(QUuid::Id128);
    MoveFileExW(reinterpret_cast<const wchar_t*>(lockPath_.utf16()),
                reinterpret_cast<const wchar_t*>(aside.utf16()), MOVEFILE_REPLACE_EXISTING);
    if (acquire() || !isHeld()) {
        return Error{ErrorCode::FileNotWritable, lockPath_, {}};
    }
    return {};
}

bool ProjectLock::isHeld() const {
    if (handle_ == nullptr) {
        return false;
    }
    BY_HANDLE_FILE_INFORMATION own{};
    BY_HANDLE_FILE_INFORMATION there{};
    const HANDLE file = CreateFileW(reinterpret_cast<const wchar_t*>(lockPath_.utf16()), GENERIC_READ,
                                    FILE_SHARE_READ | FILE_SHARE_WRITE | FILE_SHARE_DELETE, nullptr,
                                    OPEN_EXISTING, 0, nullptr);
    if (file == INVALID_HANDLE_VALUE) {
        return false;
    }
    const bool same = GetFileInformationByHandle(handle_->file, &own) != 0 &&
                      GetFileInformationByHandle(file, &there) != 0 &&
                      own.nFileIndexHigh == there.nFileIndexHigh && own.nFileIndexLow == there.nFileIndexLow;
    CloseHandle(file);
    return same;
}

void ProjectLock::release() {
    handle_.reset();
}

#else

struct ProjectLock::Handle {
    int descriptor = -1;
    ~Handle() { ::close(descriptor); }
    /// True if `path` still refers to this file.
    bool isAt(const QByteArray& path) const {
        struct stat own {};
        struct stat there {};
        return ::fstat(descriptor, &own) == 0 && ::stat(path.constData(), &there) == 0 &&
               own.st_ino == there.st_ino && own.st_dev == there.st_dev;
    }
    /// If the disk is full, the lock file does not name its owner, but the lock works.
    void writeOwner() const {
        const QByteArray bytes = describeThisProcess();
        if (::ftruncate(descriptor, 0) != 0 ||
            ::pwrite(descriptor, bytes.constData(), static_cast<std::size_t>(bytes.size()), 0) < 0) {
            errno = 0;
        }
    }
};

std::optional<LockOwner> ProjectLock::acquire() {
    const QByteArray name = QFile::encodeName(lockPath_);
    constexpr int kAttempts = 20;
    for (int attempt = 0; attempt < kAttempts && !isHeld(); ++attempt) {
        handle_.reset();
        int descriptor =
            ::open(name.constData(), O_RDWR | O_CREAT | O_CLOEXEC | O_NONBLOCK | O_NOFOLLOW, 0666);
        if (descriptor < 0 && errno == EACCES) {
            // A lock file of another user can be locked without write access.
            descriptor = ::open(name.constData(), O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOFOLLOW);
        }
        if (descriptor < 0) {
            return std::nullopt;
        }
        auto handle = std::make_unique<Handle>();
        handle->descriptor = descriptor;
        if (::flock(descriptor, LOCK_EX | LOCK_NB) != 0) {
            return errno == EWOULDBLOCK ? readOwner() : std::nullopt;
        }
        // The previous owner may have removed the file between open() and flock(). The open file is then not
        // the lock file.
        if (handle->isAt(name)) {
            handle->writeOwner();
            handle_ = std::move(handle);
        }
    }
    return std::nullopt;
}

Result<void> ProjectLock::takeOver() {
    if (isHeld()) {
        return {};
    }
    handle_.reset();
    const QString temporary = lockPath_ + QLatin1Char('.') + QUuid::createUuid().toString(QUuid::Id128);
    const QByteArray name = QFile::encodeName(temporary);
    const auto failure = [this] {
        const int systemError = errno;
        return Error{systemError == ENOSPC ? ErrorCode::DiskFull : ErrorCode::FileNotWritable, lockPath_,
                     qt_error_string(systemError)};
    };
    auto handle = std::make_unique<Handle>();
    handle->descriptor = ::open(name.constData(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (handle->descriptor < 0) {
        return failure();
    }
    // Lock the file before renaming it, so that no other process can lock it in between.
    ::flock(handle->descriptor, LOCK_EX | LOCK_NB);
    handle->writeOwner();
    if (::rename(name.constData(), QFile::encodeName(lockPath_).constData()) != 0) {
        const Error error = failure();
        ::unlink(name.constData());
        return error;
    }
    handle_ = std::move(handle);
    return {};
}

bool ProjectLock::isHeld() const {
    return handle_ != nullptr && handle_->isAt(QFile::encodeName(lockPath_));
}

void ProjectLock::release() {
    if (isHeld()) {
        ::unlink(QFile::encodeName(lockPath_).constData());
    }
    handle_.reset();
}

#endif

ProjectLock::ProjectLock(const QString& path) : lockPath_(lockPathFor(path)) {}

ProjectLock::~ProjectLock() {
    release();
}

}  // namespace tiller::project
