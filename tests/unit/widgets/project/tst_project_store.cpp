// SPDX-License-Identifier: GPL-3.0-or-later
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <QTimer>
#include <memory>

#include "robot/station/document/project_store.h"
#include "widgets/project/undoable_document.h"

using namespace tiller;

namespace {

project::Waypoint named(const QString& name) {
    project::Waypoint point;
    point.id = QUuid::createUuid();
    point.name = name;
    return point;
}

QByteArray contentOf(const QString& path) {
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

}  // namespace

class TestProjectStore : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() {
        directory_ = std::make_unique<QTemporaryDir>();
        path_ = directory_->filePath("cell-7.tiller");
        document_ = std::make_unique<UndoableDocument>();
        store_ = std::make_unique<ProjectStore>(*document_);
    }
    void cleanup() {
        store_.reset();
        document_.reset();
    }

    void changesAreSavedAutomatically() {
        QVERIFY(store_->openOrStart(path_).ok());
        QVERIFY(!QFile::exists(path_));
        QVERIFY2(!store_->statusText().contains("saved"),
                 "the status says “saved” although there is no file");
        QCOMPARE(store_->statusText(), QString("cell-7.tiller — new"));
        document_->insertWaypoints(0, {named("home")}, "Teach");
        QCOMPARE(store_->statusText(), QString("cell-7.tiller — saving…"));
        QTRY_COMPARE_WITH_TIMEOUT(store_->statusText(), QString("cell-7.tiller — saved"), 60'000);
        QCOMPARE(project::loadProject(path_)->waypoints.at(0).name, QString("home"));
    }

    void continuousChangesAreAlsoSaved() {
        QVERIFY(store_->openOrStart(path_).ok());
        QTimer changes;
        connect(&changes, &QTimer::timeout, this, [this] {
            document_->insertWaypoints(0, {named(QString::number(document_->waypoints().size()))}, "Teach");
        });
        changes.start(ProjectStore::kAutosaveMs / 10);
        QTRY_VERIFY_WITH_TIMEOUT(QFile::exists(path_), 60'000);
        QVERIFY(changes.isActive());
    }

    void aCopyHasNoFileUntilItIsSavedToOne() {
        project::Project sample;
        sample.waypoints.append(named("pick"));
        QVERIFY(project::saveProject(path_, sample).ok());
        const QByteArray before = contentOf(path_);
        QSignalSpy other(store_.get(), &ProjectStore::pathChanged);
        QVERIFY(store_->openCopy(path_, "Sample").ok());
        QCOMPARE(document_->waypoints().size(), 1);
        QVERIFY(store_->path().isEmpty() && store_->copyName() == "Sample");
        QVERIFY(!store_->isModified());
        QCOMPARE(other.count(), 1);
        document_->insertWaypoints(1, {named("place")}, "Teach");
        QVERIFY(store_->isModified());
        QVERIFY2(store_->statusText().contains("not saved"), qPrintable(store_->statusText()));
        QVERIFY(!store_->saveNow().ok());
        const QString mine = directory_->filePath("mine.tiller");
        QVERIFY(store_->saveAs(mine).ok());
        QVERIFY(store_->copyName().isEmpty() && !store_->isModified());
        QCOMPARE(store_->statusText(), QString("mine.tiller — saved"));
        QCOMPARE(project::loadProject(mine)->waypoints.size(), 2);
        // From now on, the copy is saved automatically, and the original file is unchanged.
        document_->insertWaypoints(2, {named("home")}, "Teach");
        QTRY_VERIFY_WITH_TIMEOUT(!store_->isModified(), 60'000);
        QCOMPARE(project::loadProject(mine)->waypoints.size(), 3);
        QCOMPARE(contentOf(path_), before);
    }

    void openingACopyLosesNoChangesOfThePreviousProject() {
        const QString sample = directory_->filePath("sample.tiller");
        QVERIFY(project::saveProject(sample, {}).ok());
        QVERIFY(store_->openOrStart(path_).ok());
        document_->insertWaypoints(0, {named("home")}, "Teach");
        QVERIFY(store_->openCopy(sample, "Sample").ok());
        QCOMPARE(project::loadProject(path_)->waypoints.size(), 1);
        // A file that cannot be read changes nothing.
        QVERIFY(!store_->openCopy(directory_->filePath("nothing.tiller"), "Nothing").ok());
        QCOMPARE(store_->copyName(), QString("Sample"));
    }

    void unsavedChangesAreSavedAtExit() {
        QVERIFY(store_->openOrStart(path_).ok());
        document_->insertWaypoints(0, {named("home")}, "Teach");
        store_.reset();
        QCOMPARE(project::loadProject(path_)->waypoints.size(), 1);
    }

    void undoIsSavedToo() {
        QVERIFY(store_->openOrStart(path_).ok());
        document_->insertWaypoints(0, {named("home")}, "Teach");
        QVERIFY(store_->saveNow().ok());
        document_->undoStack().undo();
        QTRY_VERIFY_WITH_TIMEOUT(!store_->isModified(), 60'000);
        QCOMPARE(project::loadProject(path_)->waypoints.size(), 0);
    }

    void openingShowsTheFileAndClearsTheHistory() {
        project::Project cell;
        cell.waypoints.append(named("a"));
        cell.robot = RobotModelId::UR10e;
        QVERIFY(project::saveProject(path_, cell).ok());
        document_->insertWaypoints(0, {named("x")}, "Teach");
        QVERIFY(store_->open(path_).ok());
        QCOMPARE(document_->waypoints().size(), 1);
        QVERIFY(!document_->undoStack().canUndo());
        QVERIFY(!store_->isModified());
        // The file keeps the arm model for which it was taught.
        document_->insertWaypoints(1, {named("b")}, "Teach");
        QVERIFY(store_->saveNow().ok());
        QCOMPARE(project::loadProject(path_)->robot, std::optional(RobotModelId::UR10e));
    }

    void damagedFileChangesNothing() {
        QVERIFY(store_->openOrStart(path_).ok());
        document_->insertWaypoints(0, {named("home")}, "Teach");
        const QString other = directory_->filePath("other.tiller");
        QFile file(other);
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write("{ \"format\": \"tiller-session\", ");
        file.close();
        const QByteArray before = contentOf(other);
        QVERIFY(store_->open(other).error().code == ErrorCode::FileCorrupt);
        QCOMPARE(store_->path(), path_);
        QCOMPARE(document_->waypoints().size(), 1);
        QTRY_VERIFY_WITH_TIMEOUT(!store_->isModified(), 60'000);
        QCOMPARE(contentOf(other), before);
    }

    void aRecoveredFileIsBackedUpAtTheFirstSave() {
        project::Project cell;
        cell.waypoints.append(named("a"));
        cell.waypoints.append(named("b"));
        const QByteArray whole = *project::serializeProject(cell);
        const QByteArray damaged = whole.left(whole.lastIndexOf("\"joints\""));
        QFile file(path_);
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(damaged);
        file.close();

        QSignalSpy kept(store_.get(), &ProjectStore::copyKept);
        const auto recovered = store_->openRecovered(path_);
        QVERIFY(recovered.ok());
        QCOMPARE(recovered->lostWaypoints, 1);
        QCOMPARE(document_->waypoints().size(), 1);
        QCOMPARE(contentOf(path_), damaged);
        QVERIFY(store_->saveNow().ok());
        QCOMPARE(kept.count(), 1);
        QCOMPARE(contentOf(kept[0][0].toString()), damaged);
        QCOMPARE(project::loadProject(path_)->waypoints.size(), 1);
    }

    void failedSaveIsReportedAndRepeated() {
        const QString folder = directory_->filePath("gone");
        QVERIFY(QDir().mkdir(folder));
        QVERIFY(store_->openOrStart(folder + "/x.tiller").ok());
        QVERIFY(QDir(folder).removeRecursively());  // including the lock of the project
        QSignalSpy failed(store_.get(), &ProjectStore::saveFailed);
        document_->insertWaypoints(0, {named("home")}, "Teach");
        QTRY_COMPARE_WITH_TIMEOUT(failed.count(), 1, 60'000);
        QVERIFY2(store_->statusText().startsWith("x.tiller — not saved: "), qPrintable(store_->statusText()));
        QVERIFY(store_->isModified());
        QVERIFY(QDir().mkdir(folder));
        QVERIFY(store_->saveNow().ok());
        QCOMPARE(store_->statusText(), QString("x.tiller — saved"));
    }

    void aFailedSaveAsKeepsTheOldPath() {
        QVERIFY(store_->openOrStart(path_).ok());
        document_->insertWaypoints(0, {named("home")}, "Teach");
        QVERIFY(!store_->saveAs(directory_->filePath("no/such/folder.tiller")).ok());
        QCOMPARE(store_->path(), path_);
        const QString other = directory_->filePath("b.tiller");
        QVERIFY(store_->saveAs(other).ok());
        QCOMPARE(store_->path(), other);
        QVERIFY(QFileInfo::exists(other));
    }

    void aSecondWindowSavesNothingUntilItTakesOver() {
        QVERIFY(store_->openOrStart(path_).ok());
        document_->insertWaypoints(0, {named("first")}, "Teach");
        QVERIFY(store_->saveNow().ok());
        UndoableDocument otherDocument;
        ProjectStore other(otherDocument);
        QSignalSpy elsewhere(&other, &ProjectStore::openElsewhere);
        QVERIFY(other.open(path_).ok());
        QCOMPARE(elsewhere.count(), 1);
        QVERIFY(other.otherOwner().has_value());
        otherDocument.insertWaypoints(1, {named("second")}, "Teach");
        QVERIFY(!other.saveNow().ok());
        QVERIFY2(other.statusText().contains("not saved"), qPrintable(other.statusText()));
        QCOMPARE(project::loadProject(path_)->waypoints.size(), 1);

        QSignalSpy lost(store_.get(), &ProjectStore::openElsewhere);
        QSignalSpy changed(store_.get(), &ProjectStore::changedByOther);
        QVERIFY(other.takeOver().ok());
        QVERIFY(other.obstacle() == ProjectStore::Obstacle::None);
        QTRY_VERIFY_WITH_TIMEOUT(!other.isModified(), 60'000);
        QCOMPARE(project::loadProject(path_)->waypoints.size(), 2);
        // The first window reports this once, is then read-only, and overwrites nothing.
        QTRY_COMPARE_WITH_TIMEOUT(lost.count(), 1, 60'000);
        QTRY_COMPARE_WITH_TIMEOUT(document_->waypoints().size(), 2, 60'000);
        QCOMPARE(changed.count(), 0);
        document_->insertWaypoints(1, {named("lost?")}, "Teach");
        QVERIFY(!store_->saveNow().ok());
        QCOMPARE(project::loadProject(path_)->waypoints.at(1).name, QString("second"));
    }

    void aWindowThatOnlyViewsFollowsTheOwner() {
        QVERIFY(store_->openOrStart(path_).ok());
        document_->insertWaypoints(0, {named("first")}, "Teach");
        QVERIFY(store_->saveNow().ok());
        ProjectDocument otherDocument;
        ProjectStore other(otherDocument);
        QSignalSpy elsewhere(&other, &ProjectStore::openElsewhere);
        QSignalSpy changed(&other, &ProjectStore::changedByOther);
        QVERIFY(other.open(path_).ok());
        for (int saves = 2; saves < 5; ++saves) {
            document_->insertWaypoints(0, {named("another")}, "Teach");
            QVERIFY(store_->saveNow().ok());
            QTRY_COMPARE_WITH_TIMEOUT(otherDocument.waypoints().size(), saves, 60'000);
            QVERIFY(!other.isModified());
            QVERIFY(other.obstacle() == ProjectStore::Obstacle::OpenElsewhere);
        }
        QCOMPARE(changed.count(), 0);
        QCOMPARE(elsewhere.count(), 1);
        // If there are unsaved changes, the other window asks the operator once.
        otherDocument.insertWaypoints(0, {named("mine")}, "Teach");
        for (int saves = 0; saves < 2; ++saves) {
            document_->insertWaypoints(0, {named("another")}, "Teach");
            QVERIFY(store_->saveNow().ok());
            QTest::qWait(600);
        }
        QTRY_COMPARE_WITH_TIMEOUT(changed.count(), 1, 60'000);
        QVERIFY(other.isModified());
    }

    void savingWorksAfterTheOtherWindowCloses() {
        QVERIFY(store_->openOrStart(path_).ok());
        document_->insertWaypoints(0, {named("first")}, "Teach");
        QVERIFY(store_->saveNow().ok());
        UndoableDocument otherDocument;
        ProjectStore other(otherDocument);
        QVERIFY(other.open(path_).ok());
        otherDocument.insertWaypoints(1, {named("second")}, "Teach");
        QSignalSpy free(&other, &ProjectStore::freeAgain);
        store_.reset();
        QTRY_COMPARE_WITH_TIMEOUT(free.count(), 1, 60'000);
        QTRY_VERIFY_WITH_TIMEOUT(!other.isModified(), 60'000);
        QCOMPARE(project::loadProject(path_)->waypoints.size(), 2);
    }

    void anExternalChangeWaitsForTheOperator() {
        QVERIFY(store_->openOrStart(path_).ok());
        document_->insertWaypoints(0, {named("mine")}, "Teach");
        QVERIFY(store_->saveNow().ok());
        QSignalSpy changed(store_.get(), &ProjectStore::changedByOther);
        project::Project foreign;
        foreign.waypoints.append(named("theirs"));
        QVERIFY(project::saveProject(path_, foreign).ok());
        QTRY_COMPARE_WITH_TIMEOUT(changed.count(), 1, 60'000);
        QVERIFY(store_->obstacle() == ProjectStore::Obstacle::ChangedByOther);
        document_->insertWaypoints(1, {named("more")}, "Teach");
        QVERIFY(!store_->saveNow().ok());
        QCOMPARE(project::loadProject(path_)->waypoints.at(0).name, QString("theirs"));
        // Both versions are kept.
        const Result<QString> copy = store_->keepBoth();
        QVERIFY(copy.ok());
        QCOMPARE(*copy, directory_->filePath("cell-7-2.tiller"));
        QCOMPARE(project::loadProject(*copy)->waypoints.size(), 2);
        QCOMPARE(project::loadProject(path_)->waypoints.at(0).name, QString("theirs"));
        QCOMPARE(store_->statusText(), QString("cell-7-2.tiller — saved"));
        // Alternatively, the version of the other window is loaded.
        QVERIFY(project::saveProject(*copy, foreign).ok());
        QTRY_COMPARE_WITH_TIMEOUT(changed.count(), 2, 60'000);
        QVERIFY(store_->reload().ok());
        QCOMPARE(document_->waypoints().at(0).name, QString("theirs"));
        QVERIFY(store_->isSaved());
    }

    void reloadingKeepsUnsavedChangesAsACopy() {
        const QString folder = directory_->filePath("Unsaved");
        store_->setCopyFolder(folder);
        QVERIFY(store_->openOrStart(path_).ok());
        document_->insertWaypoints(0, {named("mine")}, "Teach");
        QVERIFY(store_->saveNow().ok());
        QSignalSpy changed(store_.get(), &ProjectStore::changedByOther);
        project::Project foreign;
        foreign.waypoints.append(named("theirs"));
        QVERIFY(project::saveProject(path_, foreign).ok());
        QTRY_COMPARE_WITH_TIMEOUT(changed.count(), 1, 60'000);
        document_->insertWaypoints(1, {named("more")}, "Teach");
        QVERIFY(store_->reload().ok());
        QCOMPARE(document_->waypoints().at(0).name, QString("theirs"));
        // Later changes are saved to the file and do not remove the copy.
        document_->insertWaypoints(1, {named("later")}, "Teach");
        QVERIFY(store_->saveNow().ok());
        store_.reset();
        const auto copies = project::keptCopies(folder);
        QCOMPARE(copies.size(), 1);
        const auto kept = project::loadKeptCopy(copies[0]);
        QVERIFY(kept.ok());
        QCOMPARE(kept->waypoints.size(), 2);
        QCOMPARE(kept->waypoints.at(1).name, QString("more"));
    }

    // Another window saves a file with the first free name at the same time.
    void aFileCreatedByAnotherWindowIsNotReplaced() {
        QVERIFY(store_->openOrStart(path_).ok());
        document_->insertWaypoints(0, {named("mine")}, "Teach");
        QVERIFY(store_->saveNow().ok());
        QSignalSpy changed(store_.get(), &ProjectStore::changedByOther);
        QVERIFY(project::saveProject(path_, project::Project()).ok());
        QTRY_COMPARE_WITH_TIMEOUT(changed.count(), 1, 60'000);
        project::ProjectAccess other(directory_->filePath("cell-7-2.tiller"));
        other.start();
        const Result<QString> copy = store_->keepBoth();
        QVERIFY2(copy.ok(), qPrintable(copy.error().toString()));
        QCOMPARE(*copy, directory_->filePath("cell-7-3.tiller"));
        QCOMPARE(project::loadProject(*copy)->waypoints.size(), 1);
        const auto theirs = other.save(project::Project(), 1);
        QVERIFY(theirs.ok() && theirs->outcome == project::ProjectAccess::Outcome::Saved);
    }

    void nothingReplacesAGuardedProject() {
        const QString other = directory_->filePath("other.tiller");
        project::Project sample;
        sample.waypoints.append(named("other"));
        QVERIFY(project::saveProject(other, sample).ok());
        QVERIFY(store_->openOrStart(path_).ok());
        document_->insertWaypoints(0, {named("home")}, "Teach");
        QVERIFY(store_->saveNow().ok());
        const QString reason = QStringLiteral("A program is running.");
        store_->setReplaceGuard([&] { return reason; });
        const auto isRefused = [&](const auto& result) {
            return !result && result.error().code == ErrorCode::Cancelled &&
                   result.error().context == reason &&
                   document_->waypoints().at(0).name == QLatin1String("home") && store_->path() == path_;
        };
        QVERIFY(isRefused(store_->open(other)));
        QVERIFY(isRefused(store_->open(path_)));
        QVERIFY(isRefused(store_->openOrStart(directory_->filePath("new.tiller"))));
        QVERIFY(isRefused(store_->openCopy(other, "Sample")));
        QVERIFY(isRefused(store_->openRecovered(other)));
        QVERIFY(isRefused(store_->openKept({})));
        QVERIFY(isRefused(store_->reload()));
        QVERIFY(isRefused(store_->takeOver()));
        QVERIFY2(store_->saveNow().ok(), "the project can no longer be saved");
        store_->setReplaceGuard([] { return QString(); });
        QVERIFY(store_->open(other).ok());
        QCOMPARE(document_->waypoints().at(0).name, QString("other"));
    }

    void ownSavesAreNotExternalChanges() {
        QVERIFY(store_->openOrStart(path_).ok());
        QSignalSpy changed(store_.get(), &ProjectStore::changedByOther);
        for (int i = 0; i < 5; ++i) {
            document_->insertWaypoints(0, {named(QString::number(i))}, "Teach");
            QVERIFY(store_->saveNow().ok());
            QTest::qWait(60);
        }
        store_->checkFile();
        QTest::qWait(300);
        QCOMPARE(changed.count(), 0);
        QVERIFY(store_->isSaved());
    }

    void aChangedCopySurvivesAKilledProgram() {
        project::Project sample;
        sample.waypoints.append(named("pick"));
        QVERIFY(project::saveProject(path_, sample).ok());
        const QString folder = directory_->filePath("Unsaved");
        store_->setCopyFolder(folder);
        QVERIFY(store_->openCopy(path_, "Sample").ok());
        document_->insertWaypoints(1, {named("place")}, "Teach");
        // The content of the disk is the same as after the program was killed.
        QTRY_COMPARE_WITH_TIMEOUT(QDir(folder).entryList({"*.tiller"}, QDir::Files).size(), 1, 60'000);
        const QString kept = QDir(folder).filePath(QDir(folder).entryList({"*.tiller"}, QDir::Files).first());
        QTRY_COMPARE_WITH_TIMEOUT(project::loadProject(kept)->waypoints.size(), 2, 60'000);
        store_.reset();
        const auto copies = project::keptCopies(folder);
        QCOMPARE(copies.size(), 1);

        store_ = std::make_unique<ProjectStore>(*document_);
        store_->setCopyFolder(folder);
        QVERIFY(store_->openKept(copies[0]).ok());
        QCOMPARE(store_->copyName(), QString("Sample"));
        QVERIFY(store_->isModified());
        QCOMPARE(document_->waypoints().at(1).name, QString("place"));
        QVERIFY(store_->saveAs(directory_->filePath("mine.tiller")).ok());
        QVERIFY(project::keptCopies(folder).isEmpty());
        QCOMPARE(QDir(folder).entryList({"*.tiller"}, QDir::Files), QStringList());
    }

    void unsavableWorkIsKeptAtExit() {
        const QString folder = directory_->filePath("Unsaved");
        const QString gone = directory_->filePath("gone");
        QVERIFY(QDir().mkdir(gone));
        store_->setCopyFolder(folder);
        QVERIFY(store_->openOrStart(gone + "/x.tiller").ok());
        QVERIFY(QDir(gone).removeRecursively());
        document_->insertWaypoints(0, {named("home")}, "Teach");
        store_.reset();
        const auto copies = project::keptCopies(folder);
        QCOMPARE(copies.size(), 1);
        QCOMPARE(copies[0].name, QString("x.tiller"));
        QCOMPARE(project::loadKeptCopy(copies[0])->waypoints.at(0).name, QString("home"));
    }

    void reopeningTheOpenFileLosesNoChanges() {
        const QString folder = directory_->filePath("Unsaved");
        store_->setCopyFolder(folder);
        QVERIFY(store_->openOrStart(path_).ok());
        document_->insertWaypoints(0, {named("mine")}, "Teach");
        QVERIFY(store_->saveNow().ok());
        QSignalSpy changed(store_.get(), &ProjectStore::changedByOther);
        project::Project foreign;
        foreign.waypoints.append(named("theirs"));
        QVERIFY(project::saveProject(path_, foreign).ok());
        QTRY_COMPARE_WITH_TIMEOUT(changed.count(), 1, 60'000);
        document_->insertWaypoints(1, {named("more")}, "Teach");
        QVERIFY(store_->open(path_).ok());
        QCOMPARE(document_->waypoints().at(0).name, QString("theirs"));
        const auto copies = project::keptCopies(folder);
        QCOMPARE(copies.size(), 1);
        QCOMPARE(project::loadKeptCopy(copies[0])->waypoints.size(), 2);
    }

    // Unsaved work that was reopened in another window must be saved to disk even without a further change.
    void openedWorkIsKeptAtOnce() {
        const QString folder = directory_->filePath("Unsaved");
        store_->setCopyFolder(folder);
        document_->insertWaypoints(0, {named("home")}, "Teach");
        store_.reset();
        const auto copies = project::keptCopies(folder);
        QCOMPARE(copies.size(), 1);
        UndoableDocument other;
        ProjectStore second(other);
        second.setCopyFolder(folder);
        QVERIFY(second.openKept(copies[0]).ok());
        store_ = std::make_unique<ProjectStore>(*document_);
        store_->setCopyFolder(folder);
        QVERIFY(store_->openKept(copies[0]).ok());
        QTRY_COMPARE_WITH_TIMEOUT(QDir(folder).entryList({"*.tiller"}, QDir::Files).size(), 2, 60'000);
    }

    void discardedWorkIsNotKept() {
        const QString folder = directory_->filePath("Unsaved");
        store_->setCopyFolder(folder);
        document_->insertWaypoints(0, {named("home")}, "Teach");
        QTRY_COMPARE_WITH_TIMEOUT(QDir(folder).entryList({"*.tiller"}, QDir::Files).size(), 1, 60'000);
        store_->discardChanges();
        store_.reset();
        QVERIFY(project::keptCopies(folder).isEmpty());
    }

private:
    std::unique_ptr<QTemporaryDir> directory_;
    QString path_;
    std::unique_ptr<UndoableDocument> document_;
    std::unique_ptr<ProjectStore> store_;
};

QTEST_MAIN(TestProjectStore)
#include "tst_project_store.moc"
