// SPDX-License-Identifier: MIT
//
// Only regular files of limited size are read.

#include <QFile>
#include <QTemporaryDir>
#include <QTest>
#include <atomic>
#include <memory>
#include <thread>

#include "robot/core/file_reading.h"
#include "robot/core/save_guard.h"

#ifdef Q_OS_UNIX
#include <sys/stat.h>
#endif

using namespace tiller;

class TestFileReading : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() {
        directory_ = std::make_unique<QTemporaryDir>();
        path_ = directory_->filePath("file.txt");
    }

    void wholeFilesAreRead() {
        for (const qsizetype size : {0, 1, 16384, 3'000'000}) {
            put(QByteArray(size, 'x'));
            const auto read = readWholeFile(path_, 4'000'000);
            QVERIFY2(read.ok(), qPrintable(read.error().toString()));
            QCOMPARE(read->size(), size);
        }
    }

    void largeFilesAreRefused() {
        put(QByteArray(1001, 'x'));
        QVERIFY(readWholeFile(path_, 1001).ok());
        const auto read = readWholeFile(path_, 1000);
        QVERIFY(read.error().code == ErrorCode::FileCorrupt);
        QVERIFY(read.error().context.contains("file.txt"));
        QFile file(path_);
        QVERIFY(file.resize(qint64(1) << 40));
        QVERIFY(readWholeFile(path_, 1000).error().code == ErrorCode::FileCorrupt);
    }

    void missingFilesAreNamed() {
        const auto read = readWholeFile(path_, 1000);
        QVERIFY(read.error().code == ErrorCode::FileNotReadable);
        QVERIFY(read.error().context.contains("file.txt"));
        QVERIFY(!read.error().controllerMessage.isEmpty());
    }

#ifdef Q_OS_UNIX
    void pipesDevicesAndFoldersAreRefusedAtOnce() {
        const QString pipe = directory_->filePath("pipe");
        QVERIFY(::mkfifo(pipe.toLocal8Bit().constData(), 0600) == 0);
        const QString link = directory_->filePath("link");
        QVERIFY(QFile::link(pipe, link));
        for (const QString& path : {pipe, link, directory_->path(), QString("/dev/zero"), QString("/dev/tty"),
                                    QString("/dev/null")}) {
            const auto read = readWholeFile(path, 1000);
            QVERIFY2(read.error().code == ErrorCode::FileNotReadable, qPrintable(path));
            QFile file;
            QVERIFY(!openForReading(file, path).ok());
            QVERIFY(!file.isOpen());
        }
    }
#endif

    void anotherThreadWaitsForTheLock() {
        auto first = SaveGuard::acquire(path_);
        QVERIFY(first.ok());
        std::atomic<bool> held{false};
        std::thread other([&] {
            const auto second = SaveGuard::acquire(path_);
            held = second.ok();
        });
        QTest::qWait(50);
        QVERIFY(!held);
        first->reset();
        other.join();
        QVERIFY(held);
    }

private:
    void put(const QByteArray& bytes) {
        QFile file(path_);
        QVERIFY(file.open(QIODevice::WriteOnly));
        QCOMPARE(file.write(bytes), bytes.size());
    }
    std::unique_ptr<QTemporaryDir> directory_;
    QString path_;
};

QTEST_GUILESS_MAIN(TestFileReading)
#include "tst_file_reading.moc"
