// SPDX-License-Identifier: MIT
//
// A file is replaced completely or not at all, even on a full disk.

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QTemporaryDir>
#include <QTest>
#include <memory>

#include "robot/core/atomic_file.h"
#include "robot/core/save_guard.h"
#include "tests/support/small_disk.h"

#ifdef Q_OS_UNIX
#include <grp.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#endif

using namespace tiller;

namespace {

QByteArray contentOf(const QString& path) {
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray("(cannot be read)");
}

QByteArray pattern(qsizetype size, char first) {
    QByteArray bytes(size, '\0');
    for (qsizetype i = 0; i < size; ++i) {
        bytes[i] = static_cast<char>(first + i % 23);
    }
    return bytes;
}

/// Sizes around the block size of file systems and the buffer size of QFile (16384).
QList<qsizetype> sizesAroundBuffers() {
    QList<qsizetype> sizes{0, 1, 100};
    for (const qsizetype buffer : {4096, 8192, 16384, 32768, 49152}) {
        sizes << buffer - 1 << buffer << buffer + 1;
    }
    return sizes;
}

/// Verifies that the file contains either the old or the new content, as reported by the result.
void replaceOnFullDisk(const SmallDisk& disk) {
    const QString path = disk.filePath("cell.tiller");
    int failures = 0;
    for (const int freeBlocks : {0, 1, 3, 5, 13}) {
        for (const qsizetype size : sizesAroundBuffers()) {
            disk.fitToContents();
            const QByteArray before = pattern(700, 'A');
            const QByteArray after = pattern(size, 'a');
            QVERIFY(writeFileAtomically(path, before).ok());
            QVERIFY(disk.fill(freeBlocks));
            const Result<void> written = writeFileAtomically(path, after);
            const QByteArray context = QByteArray::number(size) + " bytes, " +
                                       QByteArray::number(freeBlocks) +
                                       " blocks free: " + written.error().toString().toUtf8();
            QVERIFY2(contentOf(path) == (written ? after : before), context.constData());
            if (!written) {
                ++failures;
                QVERIFY2(written.error().code == ErrorCode::DiskFull, context.constData());
                QVERIFY2(!written.error().controllerMessage.isEmpty(), context.constData());
            }
            QCOMPARE(QDir(disk.filePath(".")).entryList({".tiller-*"}, QDir::Files | QDir::Hidden),
                     QStringList());
        }
    }
    QVERIFY2(failures > 20, "the disk was never full");
}

}  // namespace

class TestAtomicFile : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() {
        directory_ = std::make_unique<QTemporaryDir>();
        path_ = directory_->filePath("file.txt");
    }

    void createsAndReplaces() {
        QVERIFY(writeFileAtomically(path_, "one").ok());
        QCOMPARE(contentOf(path_), QByteArray("one"));
        QVERIFY(writeFileAtomically(path_, "two").ok());
        QCOMPARE(contentOf(path_), QByteArray("two"));
        for (const qsizetype size : sizesAroundBuffers()) {
            QVERIFY(writeFileAtomically(path_, pattern(size, 'a')).ok());
            QCOMPARE(contentOf(path_), pattern(size, 'a'));
        }
        QCOMPARE(everything(), QStringList{"file.txt"});
    }

    void anUncommittedFileLeavesNothing() {
        QVERIFY(writeFileAtomically(path_, "old").ok());
        {
            AtomicFile file(path_);
            QVERIFY(file.open().ok());
            QVERIFY(file.write(QByteArray("new")).ok());
        }
        QCOMPARE(contentOf(path_), QByteArray("old"));
        QCOMPARE(everything(), QStringList{"file.txt"});
    }

#ifdef Q_OS_UNIX
    // A child process that was forked while the guard was held has a copy of the lock's descriptor.
    void aForkedChildDoesNotInheritTheSaveLock() {
        auto guard = SaveGuard::acquire(path_);
        QVERIFY(guard.ok());
        const pid_t child = ::fork();
        if (child == 0) {
            ::pause();
            ::_exit(0);
        }
        *guard = nullptr;
        const auto again = SaveGuard::acquire(path_);
        ::kill(child, SIGKILL);
        QVERIFY(::waitpid(child, nullptr, 0) == child);
        QVERIFY2(again.ok(), again ? "" : qPrintable(again.error().toString()));
    }
#endif

    void severalWritesMakeOneFile() {
        AtomicFile file(path_, "export to file.txt");
        QVERIFY(!file.write(QByteArray("before it is open")).ok());
        QVERIFY(file.open().ok());
        QVERIFY(file.write(QByteArray("one ")).ok());
        QVERIFY(file.write(QByteArray("two")).ok());
        QVERIFY(!QFile::exists(path_));
        QVERIFY(file.commit().ok());
        QCOMPARE(contentOf(path_), QByteArray("one two"));
        QVERIFY(!file.commit().ok());
    }

#ifdef Q_OS_UNIX
    void permissionsAndOwnerStay() {
        QVERIFY(writeFileAtomically(path_, "old").ok());
        QVERIFY(::chmod(path_.toLocal8Bit().constData(), 0640) == 0);
        const bool isRoot = ::geteuid() == 0;
        if (isRoot) {
            QVERIFY(::chown(path_.toLocal8Bit().constData(), 1234, 4321) == 0);
        }
        QVERIFY(writeFileAtomically(path_, "new").ok());
        struct stat status {};
        QVERIFY(::stat(path_.toLocal8Bit().constData(), &status) == 0);
        QCOMPARE(status.st_mode & 07777, mode_t(0640));
        if (isRoot) {
            QCOMPARE(status.st_uid, uid_t(1234));
            QCOMPARE(status.st_gid, gid_t(4321));
        }
    }

    // A file of another user, writable for both users through a common group. Only root can change the owner.
    void theGroupIsPreservedWithoutTheOwner_data() {
        QTest::addColumn<int>("group");
        QTest::addColumn<int>("expectedGroup");
        QTest::addColumn<int>("expectedMode");
        QTest::addColumn<int>("mode");
        QTest::newRow("own group") << 4321 << 4321 << 0664 << 0664;
        QTest::newRow("foreign group") << 4322 << 5678 << 0666 << 0676;  // writable for everyone
    }
    void theGroupIsPreservedWithoutTheOwner() {
        QFETCH(int, group);
        QFETCH(int, expectedGroup);
        QFETCH(int, expectedMode);
        QFETCH(int, mode);
        if (::geteuid() != 0) {
            QSKIP("needs root");
        }
        QVERIFY(writeFileAtomically(path_, "old").ok());
        const QByteArray name = path_.toLocal8Bit();
        QVERIFY(::chmod(QFileInfo(path_).absolutePath().toLocal8Bit().constData(), 0777) == 0);
        QVERIFY(::chown(name.constData(), 1234, static_cast<gid_t>(group)) == 0);
        QVERIFY(::chmod(name.constData(), static_cast<mode_t>(mode)) == 0);
        const pid_t child = ::fork();
        if (child == 0) {
            const gid_t groups[] = {4321};
            const bool other = ::setgroups(1, groups) == 0 && ::setgid(5678) == 0 && ::setuid(5679) == 0;
            ::_exit(other && writeFileAtomically(path_, "new").ok() ? 0 : 1);
        }
        int how = -1;
        QVERIFY(::waitpid(child, &how, 0) == child);
        QCOMPARE(how, 0);
        struct stat status {};
        QVERIFY(::stat(name.constData(), &status) == 0);
        QCOMPARE(status.st_gid, static_cast<gid_t>(expectedGroup));
        QCOMPARE(int(status.st_mode & 07777), expectedMode);
    }

    void symbolicLinksAreFollowed() {
        const QString link = directory_->filePath("link.txt");
        QVERIFY(QDir().mkdir(directory_->filePath("folder")));
        const QString target = directory_->filePath("folder/target.txt");
        QVERIFY(QFile::link(target, link));
        QVERIFY(writeFileAtomically(link, "through a link without a target").ok());
        QVERIFY(QFileInfo(link).isSymLink());
        QCOMPARE(contentOf(target), QByteArray("through a link without a target"));
        QVERIFY(writeFileAtomically(link, "again").ok());
        QVERIFY(QFileInfo(link).isSymLink());
        QCOMPARE(contentOf(target), QByteArray("again"));
    }

    void foldersPipesAndDevicesAreRefused() {
        const QString pipe = directory_->filePath("pipe");
        QVERIFY(::mkfifo(pipe.toLocal8Bit().constData(), 0600) == 0);
        for (const QString& path : {directory_->path(), pipe, QString("/dev/null")}) {
            const Result<void> written = writeFileAtomically(path, "text");
            QVERIFY2(!written, qPrintable(path));
            QVERIFY(written.error().code == ErrorCode::FileNotWritable);
            QVERIFY(QFile::exists(path));
        }
        const QString part = directory_->filePath("part");
        QVERIFY(writeFileAtomically(part, "text").ok());
        QVERIFY(!replaceFile(part, pipe).ok());
        QVERIFY(QFile::exists(part));
    }

    void aReadOnlyFileIsNotReplaced() {
        if (::geteuid() == 0) {
            QSKIP("root can write to read-only files");
        }
        QVERIFY(writeFileAtomically(path_, "old").ok());
        QVERIFY(QFile::setPermissions(path_, QFile::ReadOwner));
        QVERIFY(writeFileAtomically(path_, "new").error().code == ErrorCode::FileNotWritable);
        QCOMPARE(contentOf(path_), QByteArray("old"));
    }
#endif

    void aMissingFolderIsReportedWithTheFileName() {
        const Result<void> written = writeFileAtomically(directory_->filePath("no/such/file"), "text");
        QVERIFY(written.error().code == ErrorCode::FileNotWritable);
        QVERIFY(written.error().context.contains("file"));
        QCOMPARE(
            writeFileAtomically(directory_->filePath("no/file"), "text", "export to file").error().context,
            QString("export to file"));
    }

    void anotherFileIsReplacedByAPart() {
        const QString part = path_ + ".part";
        QVERIFY(writeFileAtomically(part, "new").ok());
        QVERIFY(writeFileAtomically(path_, "old").ok());
        QVERIFY(replaceFile(part, path_).ok());
        QCOMPARE(contentOf(path_), QByteArray("new"));
        QVERIFY(!QFile::exists(part));
        QVERIFY(replaceFile(part, path_).error().code == ErrorCode::FileNotWritable);
        QCOMPARE(contentOf(path_), QByteArray("new"));
    }

    void aFullTmpfsKeepsTheOldFile() {
        const SmallDisk disk(SmallDisk::Kind::Tmpfs, 512);
        if (!disk.problem().isEmpty()) {
            QSKIP(qPrintable(disk.problem()));
        }
        replaceOnFullDisk(disk);
    }

    void aFullExt4KeepsTheOldFile() {
        const SmallDisk disk(SmallDisk::Kind::Ext4, 2048);
        if (!disk.problem().isEmpty()) {
            QSKIP(qPrintable(disk.problem()));
        }
        replaceOnFullDisk(disk);
    }

private:
    QStringList everything() const {
        return QDir(directory_->path()).entryList(QDir::AllEntries | QDir::Hidden | QDir::NoDotAndDotDot);
    }
    std::unique_ptr<QTemporaryDir> directory_;
    QString path_;
};

QTEST_GUILESS_MAIN(TestAtomicFile)
#include "tst_atomic_file.moc"
