// SPDX-License-Identifier: MIT
#include "robot/core/save_guard.h"

#include <QCryptographicHash>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <cerrno>
#include <chrono>
#include <thread>

#ifdef Q_OS_WIN
#include <qt_windows.h>
#else
#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>
#endif

namespace tiller {
namespace {

constexpr std::chrono::milliseconds kGuardTimeout{3000};

Error busy(const QString& path) {
    return {ErrorCode::FileNotWritable, QDir::toNativeSeparators(path),
            QStringLiteral("another program has been writing to this folder for %1 s")
                .arg(kGuardTimeout.count() / 1000)};
}

QString folderOf(const QString& path) {
    const QString folder = QFileInfo(path).absolutePath();
    const QString canonical = QFileInfo(folder).canonicalFilePath();
    return canonical.isEmpty() ? folder : canonical;
}

}  // namespace

#ifdef Q_OS_WIN

struct SaveGuard::Handle {
    HANDLE mutex = nullptr;
    ~Handle() {
        if (mutex != nullptr) {
            ReleaseMutex(mutex);
            CloseHandle(mutex);
        }
    }
};

Result<std::unique_ptr<SaveGuard>> SaveGuard::acquire(const QString& path) {
    const QByteArray key =
        QCryptographicHash::hash(folderOf(path).toLower().toUtf8(), QCryptographicHash::Sha1).toHex();
    const QString name = QStringLiteral("Local\\tiller-save-") + QString::fromLatin1(key);
    auto handle = std::make_unique<Handle>();
    handle->mutex = CreateMutexW(nullptr, FALSE, reinterpret_cast<const wchar_t*>(name.utf16()));
    if (handle->mutex != nullptr &&
        WaitForSingleObject(handle->mutex, static_cast<DWORD>(kGuardTimeout.count())) == WAIT_TIMEOUT) {
        CloseHandle(handle->mutex);
        handle->mutex = nullptr;
        return busy(path);
    }
    return std::unique_ptr<SaveGuard>(new SaveGuard(std::move(handle)));
}

#else

struct SaveGuard::Handle {
    int descriptor = -1;
    ~Handle() {
        if (descriptor >= 0) {
            // Unlock explicitly: after a fork, the child's copy of the descriptor would keep the lock.
            ::flock(descriptor, LOCK_UN);
            ::close(descriptor);
        }
    }
};

Result<std::unique_ptr<SaveGuard>> SaveGuard::acquire(const QString& path) {
    auto handle = std::make_unique<Handle>();
    handle->descriptor =
        ::open(QFile::encodeName(folderOf(path)).constData(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    const auto end = std::chrono::steady_clock::now() + kGuardTimeout;
    while (handle->descriptor >= 0 && ::flock(handle->descriptor, LOCK_EX | LOCK_NB) != 0 &&
           (errno == EWOULDBLOCK || errno == EINTR)) {
        if (std::chrono::steady_clock::now() >= end) {
            return busy(path);
        }
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
    return std::unique_ptr<SaveGuard>(new SaveGuard(std::move(handle)));
}

#endif

SaveGuard::SaveGuard(std::unique_ptr<Handle> handle) : handle_(std::move(handle)) {}

SaveGuard::~SaveGuard() = default;

}  // namespace tiller
