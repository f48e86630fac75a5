// SPDX-License-Identifier: MIT
#include <QDir>
#include <QTemporaryDir>
#include <QTest>
#include <cerrno>

#include "robot/platform/file_system.h"

using namespace tiller;

namespace {

void writeFile(const QString& path, const QByteArray& bytes) {
    QFile file(path);
    QVERIFY(file.open(QIODevice::WriteOnly));
    QCOMPARE(file.write(bytes), bytes.size());
    QCOMPARE(file_system::flush(file.handle(), file_system::Flush::All), 0);
}

QByteArray contents(const QString& path) {
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray("not readable");
}

}  // namespace

class TestFileSystem : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void replacesAFile_data() {
        QTest::addColumn<QString>("folder");
        QTest::newRow("plain") << "a";
        QTest::newRow("accents") << QString::fromUtf8("Käse 溶接");
        QTest::newRow("long") << QString(100, 'a') + "/" + QString(100, 'b') + "/" + QString(100, 'c');
    }

    void replacesAFile() {
        QFETCH(QString, folder);
        const QString place = folder_.filePath(folder);
        QVERIFY(QDir().mkpath(place));
        const QString target = place + "/target.txt";
        for (const QByteArray bytes : {"first", "second"}) {
            writeFile(place + "/new.txt", bytes);
            QCOMPARE(file_system::replace(place + "/new.txt", target), 0);
            QCOMPARE(file_system::flushFolderOf(target), 0);
            QCOMPARE(contents(target), bytes);
            QVERIFY(!QFile::exists(place + "/new.txt"));
        }
        QVERIFY(file_system::replace(place + "/absent.txt", target) != 0);
        QCOMPARE(contents(target), QByteArray("second"));
    }

    void aLockKeepsOthersOut() {
        const QString path = folder_.filePath("locked");
        QFile first(path);
        QFile second(path);
        QVERIFY(first.open(QIODevice::ReadWrite) && second.open(QIODevice::ReadWrite));
        QVERIFY(file_system::lock(first.handle()));
        QVERIFY(!file_system::lock(second.handle()));
        // Other processes can read the written data.
        QCOMPARE(first.write("rows"), 4);
        QVERIFY(first.flush());
        QCOMPARE(second.readAll(), QByteArray("rows"));
        first.close();
        QVERIFY(file_system::lock(second.handle()));
    }

    void countsTheNamesOfAFile() {
        QFile file(folder_.filePath("counted"));
        QVERIFY(file.open(QIODevice::ReadWrite));
        QCOMPARE(file_system::linkCount(file.handle()), 1);
        QCOMPARE(file_system::linkCount(-1), 0);
    }

    void knowsAFullDisk() {
        QVERIFY(file_system::isDiskFull(ENOSPC));
        QVERIFY(!file_system::isDiskFull(EACCES));
    }

private:
    QTemporaryDir folder_;
};

QTEST_GUILESS_MAIN(TestFileSystem)
#include "tst_file_system.moc"
