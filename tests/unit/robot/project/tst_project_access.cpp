// SPDX-License-Identifier: MIT
//
// Several windows and programs with one project file. They do not overwrite content that they have not read.

#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>
#include <memory>

#include "robot/project/kept_copies.h"
#include "robot/project/project_access.h"
#include "tests/support/small_disk.h"

#ifdef Q_OS_UNIX
#include <sys/stat.h>
#endif

using namespace tiller;
using namespace tiller::project;
using Outcome = ProjectAccess::Outcome;

namespace {

Project withWaypoints(const QStringList& names) {
    Project project;
    for (const QString& name : names) {
        Waypoint point;
        point.id = QUuid::createUuid();
        point.name = name;
        project.waypoints.append(point);
    }
    return project;
}

QByteArray contentOf(const QString& path) {
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

}  // namespace

class TestProjectAccess : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() {
        directory_ = std::make_unique<QTemporaryDir>();
        path_ = directory_->filePath("cell.tiller");
        QVERIFY(saveProject(path_, withWaypoints({"a"})).ok());
    }

    void theSecondWindowSavesNothingAndReportsTheFirst() {
        ProjectAccess first(path_);
        QVERIFY(first.load().ok());
        ProjectAccess second(path_);
        QCOMPARE(second.load()->waypoints.size(), 1);
        const auto check = second.check();
        QVERIFY(check.owner.has_value());
        QCOMPARE(check.owner->process, QCoreApplication::applicationPid());
        QCOMPARE(check.owner->host, QSysInfo::machineHostName());
        QVERIFY2(check.owner->toString().contains("tst_project_access"), qPrintable(check.owner->toString()));
        const QByteArray before = contentOf(path_);
        QVERIFY(second.save(withWaypoints({"b"}), 1)->outcome == Outcome::OpenElsewhere);
        QCOMPARE(contentOf(path_), before);
        QVERIFY(first.save(withWaypoints({"a", "b"}), 1)->outcome == Outcome::Saved);
        // A link to the project uses the same lock.
        const QString link = directory_->filePath("link.tiller");
        QVERIFY(QFile::link(path_, link));
        ProjectAccess third(link);
        QVERIFY(third.load().ok());
        QVERIFY(third.check().owner.has_value());
    }

    void theLockEndsWithItsWindow() {
        auto first = std::make_unique<ProjectAccess>(path_);
        QVERIFY(first->load().ok());
        ProjectAccess second(path_);
        QVERIFY(second.load().ok());
        QVERIFY(second.check().owner.has_value());
        QVERIFY(first->save(withWaypoints({"a", "b"}), 1)->outcome == Outcome::Saved);
        first.reset();
        const auto check = second.check();
        QVERIFY(!check.owner.has_value());
        QVERIFY(check.changedByOther);
        QVERIFY(second.save(withWaypoints({"a", "c"}), 1)->outcome == Outcome::ChangedByOther);
        QCOMPARE(second.load()->waypoints.size(), 2);
        QVERIFY(second.save(withWaypoints({"a", "b", "c"}), 2)->outcome == Outcome::Saved);
        second.close();
        QCOMPARE(QDir(directory_->path()).entryList({".*lock*"}, QDir::Files | QDir::Hidden), QStringList());
        QVERIFY(second.save(withWaypoints({}), 3)->outcome == Outcome::OpenElsewhere);
    }

    void theFirstWindowDetectsATakeover() {
        ProjectAccess first(path_);
        QVERIFY(first.load().ok());
        ProjectAccess second(path_);
        QVERIFY(second.load().ok());
        QVERIFY(second.takeOver().ok());
        QVERIFY(!second.check().owner.has_value());
        QVERIFY(first.check().owner.has_value());
        QVERIFY(first.save(withWaypoints({"first"}), 1)->outcome == Outcome::OpenElsewhere);
        QVERIFY(second.save(withWaypoints({"second"}), 1)->outcome == Outcome::Saved);
        first.close();
        // The second window still has its lock.
        ProjectAccess third(path_);
        QVERIFY(third.load().ok());
        QVERIFY(third.check().owner.has_value());
    }

    void aChangeByAnotherProgramIsNotReplaced() {
        ProjectAccess access(path_);
        QVERIFY(access.load().ok());
        QVERIFY(!access.check().changedByOther);
        QVERIFY(saveProject(path_, withWaypoints({"other"})).ok());
        QVERIFY(access.check().changedByOther);
        const QByteArray foreign = contentOf(path_);
        QVERIFY(access.save(withWaypoints({"mine"}), 1)->outcome == Outcome::ChangedByOther);
        QCOMPARE(contentOf(path_), foreign);
        QCOMPARE(access.load()->waypoints.at(0).name, QString("other"));
        QVERIFY(access.save(withWaypoints({"mine"}), 2)->outcome == Outcome::Saved);
        // A change is detected even if timestamp and size are equal.
        QByteArray sneaky = contentOf(path_);
        const QDateTime stamp = QFileInfo(path_).lastModified();
        sneaky.replace("mine", "mime");
        QFile file(path_);
        QVERIFY(file.open(QIODevice::ReadWrite));
        file.write(sneaky);
        file.setFileTime(stamp, QFileDevice::FileModificationTime);
        file.close();
        QVERIFY(access.save(withWaypoints({"again"}), 3)->outcome == Outcome::ChangedByOther);
    }

    // Automatic saving runs in another thread. If the disk is slow, it may finish after the file was
    // reloaded.
    void aPendingSaveDoesNotReplaceAReloadedFile() {
        ProjectAccess access(path_);
        QVERIFY(access.load().ok());
        QVERIFY(access.save(withWaypoints({"mine"}), 5)->outcome == Outcome::Saved);
        QVERIFY(saveProject(path_, withWaypoints({"other"})).ok());
        QVERIFY(access.load(6).ok());
        const QByteArray reloaded = contentOf(path_);
        QVERIFY(access.save(withWaypoints({"old"}), 4).ok());
        QVERIFY(access.save(withWaypoints({"discarded"}), 6).ok());
        QCOMPARE(contentOf(path_), reloaded);
        QVERIFY(access.save(withWaypoints({"new"}), 7)->outcome == Outcome::Saved);
        QCOMPARE(loadProject(path_)->waypoints.at(0).name, QString("new"));
    }

    void aNewlyCreatedFileIsNotReplaced() {
        QVERIFY(QFile::remove(path_));
        ProjectAccess access(path_);
        access.start();
        QVERIFY(saveProject(path_, withWaypoints({"other"})).ok());
        QVERIFY(access.save(withWaypoints({"mine"}), 1)->outcome == Outcome::ChangedByOther);
    }

    void aDeletedFileIsWrittenAgain() {
        ProjectAccess access(path_);
        QVERIFY(access.load().ok());
        QVERIFY(QFile::remove(path_));
        QVERIFY(!access.check().changedByOther);
        QVERIFY(access.save(withWaypoints({"mine"}), 1)->outcome == Outcome::Saved);
        QVERIFY(QFile::exists(path_));
    }

    void anOlderRevisionReplacesNothing() {
        ProjectAccess access(path_);
        QVERIFY(access.load().ok());
        QVERIFY(access.save(withWaypoints({"new"}), 5)->outcome == Outcome::Saved);
        QVERIFY(access.save(withWaypoints({"old"}), 4)->outcome == Outcome::Saved);
        QCOMPARE(loadProject(path_)->waypoints.at(0).name, QString("new"));
    }

#ifdef Q_OS_UNIX
    void aPipeAsProjectIsRefusedAtOnce() {
        const QString pipe = directory_->filePath("pipe.tiller");
        QVERIFY(::mkfifo(pipe.toLocal8Bit().constData(), 0600) == 0);
        QVERIFY(loadProject(pipe).error().code == ErrorCode::FileNotReadable);
        QVERIFY(recoverProject(pipe).error().code == ErrorCode::FileNotReadable);
        QVERIFY(!saveProject(pipe, withWaypoints({"a"})).ok());
        QVERIFY(loadProject("/dev/zero").error().code == ErrorCode::FileNotReadable);
    }
#endif

    void aFullDiskKeepsTheProject() {
        const SmallDisk disk(SmallDisk::Kind::Tmpfs, 256);
        if (!disk.problem().isEmpty()) {
            QSKIP(qPrintable(disk.problem()));
        }
        const QString path = disk.filePath("cell.tiller");
        QVERIFY(saveProject(path, withWaypoints({"a"})).ok());
        ProjectAccess access(path);
        QVERIFY(access.load().ok());
        QVERIFY(disk.fill());
        const auto saved = access.save(withWaypoints({"a", "b"}), 1);
        QVERIFY(saved.error().code == ErrorCode::DiskFull);
        QCOMPARE(loadProject(path)->waypoints.size(), 1);
        disk.fitToContents();
        QVERIFY(access.save(withWaypoints({"a", "b"}), 1)->outcome == Outcome::Saved);
        QCOMPARE(loadProject(path)->waypoints.size(), 2);
    }

    void unsavedWorkIsOfferedOnceItsWindowHasEnded() {
        const QString folder = directory_->filePath("Unsaved");
        QVERIFY(keptCopies(folder).isEmpty());
        {
            CopyKeeper keeper(folder);
            QVERIFY(keeper.keep(withWaypoints({"a"}), "Sample", 1).ok());
            QVERIFY(keeper.keep(withWaypoints({"a", "b"}), "Sample", 2).ok());
            QVERIFY(keeper.keep(withWaypoints({}), "Sample", 1).ok());  // an older state
            QVERIFY(keptCopies(folder).isEmpty());
        }
        const QList<KeptCopy> kept = keptCopies(folder);
        QCOMPARE(kept.size(), 1);
        QCOMPARE(kept[0].name, QString("Sample"));
        QVERIFY(kept[0].at.isValid());
        const auto project = loadKeptCopy(kept[0]);
        QCOMPARE(project->waypoints.size(), 2);
        QVERIFY(project->extra.isEmpty());
        {
            CopyKeeper again(folder);
            again.adopt(kept[0]);
            QVERIFY(keptCopies(folder).isEmpty());
            again.remove(3);
            QVERIFY(again.keep(withWaypoints({"late"}), "Sample", 3).ok());
        }
        QVERIFY(keptCopies(folder).isEmpty());
        QCOMPARE(QDir(folder).entryList(QDir::Files | QDir::Hidden), QStringList());
    }

    void twoWindowsThatContinueOneKeptCopyDoNotReplaceEachOther() {
        const QString folder = directory_->filePath("Unsaved");
        {
            CopyKeeper keeper(folder);
            QVERIFY(keeper.keep(withWaypoints({"a"}), "Sample", 1).ok());
        }
        const KeptCopy copy = keptCopies(folder).at(0);
        {
            CopyKeeper first(folder);
            first.adopt(copy);
            CopyKeeper second(folder);
            second.adopt(copy);
            QVERIFY(first.keep(withWaypoints({"a", "first"}), "Sample", 1).ok());
            QVERIFY(second.keep(withWaypoints({"a", "second"}), "Sample", 1).ok());
            QCOMPARE(loadKeptCopy(copy)->waypoints.at(1).name, QString("first"));
            first.remove(2);  // saved
        }
        const QList<KeptCopy> kept = keptCopies(folder);
        QCOMPARE(kept.size(), 1);
        QCOMPARE(loadKeptCopy(kept[0])->waypoints.at(1).name, QString("second"));
    }

    void withoutAFolderNothingIsKept() {
        CopyKeeper keeper{QString()};
        QVERIFY(keeper.keep(withWaypoints({"a"}), "Sample", 1).ok());
        keeper.remove(1);
    }

private:
    std::unique_ptr<QTemporaryDir> directory_;
    QString path_;
};

QTEST_GUILESS_MAIN(TestProjectAccess)
#include "tst_project_access.moc"
