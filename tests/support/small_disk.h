// SPDX-License-Identifier: MIT
#pragma once

// A small file system that a test can fill completely. Mounting requires privileges. Without them, tests are
// skipped with problem().

#include <QDir>
#include <QFile>
#include <QProcess>
#include <QTemporaryDir>

#ifdef __linux__
#include <fcntl.h>
#include <sched.h>
#include <sys/mount.h>
#include <unistd.h>
#endif

namespace tiller {

class SmallDisk {
public:
    enum class Kind { Tmpfs, Ext4 };

    /// The mount is visible to this thread, and to threads and processes that it starts afterwards.
    SmallDisk(Kind kind, int kilobytes) {
#ifdef __linux__
        mountPoint_ = directory_.filePath("disk");
        QDir().mkpath(mountPoint_);
        if (::unshare(CLONE_NEWNS) != 0 || ::mount("none", "/", nullptr, MS_REC | MS_PRIVATE, nullptr) != 0) {
            problem_ =
                QStringLiteral("mounting is not permitted: ") + QString::fromLocal8Bit(strerror(errno));
            return;
        }
        const QByteArray at = mountPoint_.toLocal8Bit();
        if (kind == Kind::Tmpfs) {
            const QByteArray options = "size=" + QByteArray::number(kilobytes) + "k";
            if (::mount("tmpfs", at.constData(), "tmpfs", 0, options.constData()) != 0) {
                problem_ =
                    QStringLiteral("no tmpfs can be mounted: ") + QString::fromLocal8Bit(strerror(errno));
                return;
            }
        } else {
            const QString image = directory_.filePath("image");
            QFile file(image);
            if (!file.open(QIODevice::WriteOnly) || !file.resize(qint64(kilobytes) * 1024)) {
                problem_ = QStringLiteral("the image file cannot be created");
                return;
            }
            file.close();
            for (const QStringList& command :
                 {QStringList{"mkfs.ext4", "-q", "-F", "-m", "0", "-O", "^has_journal", image},
                  QStringList{"mount", "-o", "loop", image, mountPoint_}}) {
                QProcess process;
                process.start(command.first(), command.mid(1));
                if (!process.waitForStarted() || !process.waitForFinished() || process.exitCode() != 0) {
                    problem_ =
                        QStringLiteral("%1 is not possible here: %2")
                            .arg(command.first(), QString::fromLocal8Bit(process.readAllStandardError()));
                    return;
                }
            }
        }
        mounted_ = true;
#else
        Q_UNUSED(kind)
        Q_UNUSED(kilobytes)
        problem_ = QStringLiteral("small disks are available only on Linux");
#endif
    }
    ~SmallDisk() {
#ifdef __linux__
        if (mounted_) {
            ::umount2(mountPoint_.toLocal8Bit().constData(), MNT_DETACH);
        }
#endif
    }
    SmallDisk(const SmallDisk&) = delete;
    SmallDisk& operator=(const SmallDisk&) = delete;

    /// The reason for a failure; empty on success.
    const QString& problem() const {
        return problem_;
    }
    QString filePath(const QString& name) const {
        return QDir(mountPoint_).filePath(name);
    }

    /// Fills the disk except for this number of blocks of 4096 bytes.
    bool fill(int freeBlocks = 0) const {
#ifdef __linux__
        const int file = ::open(ballast().constData(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0600);
        const QByteArray block(4096, 'x');
        qint64 size = 0;
        for (;;) {
            const auto got = ::write(file, block.constData(), static_cast<std::size_t>(block.size()));
            if (got <= 0) {
                break;
            }
        }
        size = ::lseek(file, 0, SEEK_END);
        const bool ok = ::ftruncate(file, std::max<qint64>(0, (size / 4096 - freeBlocks) * 4096)) == 0;
        ::close(file);
        return ok;
#else
        Q_UNUSED(freeBlocks)
        return false;
#endif
    }
    void fitToContents() const {
        QFile::remove(QString::fromLocal8Bit(ballast()));
    }

private:
    QByteArray ballast() const {
        return filePath(QStringLiteral("ballast")).toLocal8Bit();
    }

    QTemporaryDir directory_;
    QString mountPoint_;
    QString problem_;
    bool mounted_ = false;
};

}  // namespace tiller
