// SPDX-License-Identifier: GPL-3.0-or-later
//
// Messages about project files: damaged files, files of another version, and the folder for files that are
// created.

#include <QApplication>
#include <QDir>
#include <QFile>
#include <QFileDialog>
#include <QJsonDocument>
#include <QJsonObject>
#include <QMessageBox>
#include <QPushButton>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <QTimer>
#include <memory>
#include <optional>

#include "tests/support/event_spy.h"
#include "widgets/project/project_files.h"
#include "widgets/project/undoable_document.h"

using namespace tiller;

namespace {

/// Clicks this button in the next message box.
class Answer {
public:
    explicit Answer(const char* key) {
        QObject::connect(&timer_, &QTimer::timeout, &timer_, [this, key] {
            auto* question = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
            if (question == nullptr) {
                return;
            }
            asked_ = true;
            timer_.stop();
            if (auto* button = question->findChild<QPushButton*>(QLatin1String(key))) {
                button->click();
            } else {
                question->reject();
            }
        });
        timer_.start(10);
    }
    bool wasAsked() const { return asked_; }

private:
    QTimer timer_;
    bool asked_ = false;
};

}  // namespace

class TestProjectFiles : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() {
        directory_ = std::make_unique<QTemporaryDir>();
        path_ = directory_->filePath("cell-7.tiller");
        document_ = std::make_unique<UndoableDocument>();
        store_ = std::make_unique<ProjectStore>(*document_);
        files_ = std::make_unique<ProjectFiles>(*store_, journal_);
        notice_.reset();
        connect(files_.get(), &ProjectFiles::noticeWanted, this,
                [this](const Notice& notice) { notice_ = notice; });
    }
    void cleanup() {
        files_.reset();
        store_.reset();
        document_.reset();
    }

    void aFileOfANewerVersionAsksForAnUpdate() {
        QFile file(path_);
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(R"({"format": "tiller-session", "version": 99, "frames": [], "waypoints": []})");
        file.close();
        const QByteArray before = content();
        const test::EventSpy said(journal_);
        files_->open(path_);
        QVERIFY(notice_.has_value());
        QVERIFY2(notice_->text.contains("Update Tiller"), qPrintable(notice_->text));
        QVERIFY2(!notice_->text.contains("robot", Qt::CaseInsensitive), qPrintable(notice_->text));
        QCOMPARE(said.count(), 1);
        QCOMPARE(said.front().text, notice_->text);
        QVERIFY(files_->store().path().isEmpty());
        QCOMPARE(content(), before);
    }

    void aFileOfAnEarlierVersionIsSavedAsAProject() {
        document_->insertWaypoints(0, {named("home")}, "Teach");
        files_->saveAs(path_);
        QByteArray old = content();
        QVERIFY(old.contains("\"tiller-project\""));
        old.replace("\"tiller-project\"", "\"tiller-session\"");
        QFile file(path_);
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(old);
        file.close();

        files_->open(path_);
        QVERIFY(!notice_.has_value());
        QCOMPARE(document_->waypoints().at(0).name, QString("home"));
        QCOMPARE(content(), old);  // viewing does not modify the file
        document_->insertWaypoints(1, {named("pick")}, "Teach");
        QVERIFY(files_->store().saveNow().ok());
        QVERIFY(content().contains("\"tiller-project\""));
        QCOMPARE(project::loadProject(path_)->waypoints.size(), 2);
        QVERIFY2(!QFile::exists(path_ + ".damaged-1"), "an intact file was kept as damaged");
    }

    void replacedProjectFileIsReported() {
        QSignalSpy other(&files_->store(), &ProjectStore::pathChanged);
        files_->open(path_);
        QCOMPARE(other.count(), 1);
        document_->insertWaypoints(0, {named("home")}, "Teach");
        QVERIFY(files_->store().saveNow().ok());
        QCOMPARE(other.count(), 1);
        files_->saveAs(directory_->filePath("cell-8"));
        QCOMPARE(other.count(), 2);
        QCOMPARE(other[1][0].toString(), directory_->filePath("cell-8.tiller"));
        files_->saveAs(directory_->filePath("no/such/folder.tiller"));
        QCOMPARE(other.count(), 2);
        QVERIFY(notice_.has_value());
        QCOMPARE(files_->store().path(), directory_->filePath("cell-8.tiller"));
    }

    void aDamagedFileOffersTheReadablePart() {
        document_->insertWaypoints(0, {named("a"), named("b"), named("c")}, "Teach");
        files_->saveAs(path_);
        QFile file(path_);
        QVERIFY(file.resize(content().lastIndexOf("\"joints\"")));
        files_->open(path_);
        QVERIFY(notice_ && notice_->accepted);
        QVERIFY2(notice_->text.contains("line "), qPrintable(notice_->text));
        QCOMPARE(document_->waypoints().size(), 3);
        notice_->accepted();
        QCOMPARE(document_->waypoints().size(), 2);
    }

    // A kept copy is named after its file, so its name already has the suffix.
    void saveAsProposesOneSuffix_data() {
        QTest::addColumn<QString>("name");
        QTest::addColumn<QString>("proposed");
        QTest::newRow("sample") << QStringLiteral("Sample 1.5") << QStringLiteral("Sample 1.5.tiller");
        QTest::newRow("kept copy") << QStringLiteral("cell.tiller") << QStringLiteral("cell.tiller");
    }
    void saveAsProposesOneSuffix() {
        QFETCH(const QString, name);
        QFETCH(const QString, proposed);
        const QString sample = directory_->filePath("sample.tiller");
        QVERIFY(project::saveProject(sample, {}).ok());
        files_->openCopy(sample, name);
        QString seen;
        QTimer timer;
        connect(&timer, &QTimer::timeout, this, [&seen] {
            if (auto* dialog = qobject_cast<QFileDialog*>(QApplication::activeModalWidget())) {
                seen = dialog->selectedFiles().value(0);
                dialog->reject();
            }
        });
        timer.start(20);
        files_->askToSave(nullptr);
        QCOMPARE(QFileInfo(seen).fileName(), proposed);
        files_->store().discardChanges();
    }

    // The notice remains while a sample is opened and changed.
    void readingADamagedFileKeepsUnsavedCopies() {
        document_->insertWaypoints(0, {named("a"), named("b"), named("c")}, "Teach");
        const QString sample = directory_->filePath("sample.tiller");
        files_->saveAs(sample);
        files_->saveAs(path_);
        QFile file(path_);
        QVERIFY(file.resize(content().lastIndexOf("\"joints\"")));
        files_->open(path_);
        QVERIFY(notice_ && notice_->accepted);
        files_->openCopy(sample, "Sample");
        document_->insertWaypoints(3, {named("mine")}, "Teach");
        QVERIFY(files_->store().isModified());
        {
            const Answer answer("unsavedCopy.stay");
            notice_->accepted();
            QVERIFY(answer.wasAsked());
        }
        QCOMPARE(files_->store().copyName(), QString("Sample"));
        QCOMPARE(document_->waypoints().size(), 4);
        QCOMPARE(document_->waypoints().at(3).name, QString("mine"));

        const Answer answer("unsavedCopy.drop");
        notice_->accepted();
        QVERIFY(answer.wasAsked());
        QCOMPARE(document_->waypoints().size(), 2);
    }

    void nonProjectFileOffersNoRecovery() {
        QFile file(path_);
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write("hello");
        file.close();
        files_->open(path_);
        QVERIFY(notice_.has_value());
        QVERIFY(notice_->accept.isEmpty() && !notice_->accepted);
    }

    // The state after starting with a damaged file: there is no file to save the work in.
    void closingWithoutAFileAsksForConfirmation() {
        QVERIFY(files_->mayLeave(nullptr));
        document_->insertWaypoints(0, {named("a")}, "Teach");
        {
            const Answer answer("unsavedCopy.stay");
            QVERIFY(!files_->mayLeave(nullptr));
            QVERIFY(answer.wasAsked());
        }
        const Answer answer("unsavedCopy.drop");
        QVERIFY(files_->mayLeave(nullptr));
        QVERIFY(answer.wasAsked());
        QVERIFY(!files_->store().isModified());
    }

    void closingWithAFailedSaveAsksForConfirmation() {
        const QString folder = directory_->filePath("gone");
        QVERIFY(QDir().mkdir(folder));
        files_->open(folder + "/x.tiller");
        QVERIFY(QDir(folder).removeRecursively());
        document_->insertWaypoints(0, {named("a")}, "Teach");
        {
            const Answer answer("unsavedCopy.stay");
            QVERIFY(!files_->mayLeave(nullptr));
            QVERIFY(answer.wasAsked());
        }
        // When saving is possible again, no question is shown.
        QVERIFY(QDir().mkdir(folder));
        QVERIFY(files_->mayLeave(nullptr));
        QVERIFY(QFile::exists(folder + "/x.tiller"));
    }

    void anotherProjectResolvesTheNoticeOfADamagedFile() {
        QSignalSpy resolved(files_.get(), &ProjectFiles::noticeResolved);
        QFile file(path_);
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write("hello");
        file.close();
        files_->open(path_);
        QVERIFY(notice_.has_value() && !notice_->cause.isEmpty());
        QVERIFY(resolved.isEmpty());
        files_->open(directory_->filePath("other.tiller"));
        const auto isOfDamage = [this](const QList<QVariant>& signal) { return signal[0] == notice_->cause; };
        QVERIFY(std::any_of(resolved.begin(), resolved.end(), isOfDamage));
    }

    void aProjectOpenInAnotherWindowOffersTakeoverAndCopy() {
        document_->insertWaypoints(0, {named("a")}, "Teach");
        files_->saveAs(path_);
        UndoableDocument otherDocument;
        ProjectStore otherStore(otherDocument);
        ProjectFiles other(otherStore, journal_);
        std::optional<Notice> asked;
        connect(&other, &ProjectFiles::noticeWanted, this, [&](const Notice& notice) { asked = notice; });
        other.open(path_);
        QVERIFY(asked && asked->accepted && asked->otherAccepted);
        QVERIFY2(asked->text.contains("tst_project_files"), qPrintable(asked->text));
        QCOMPARE(otherDocument.waypoints().size(), 1);
        asked->otherAccepted();
        QCOMPARE(other.store().path(), directory_->filePath("cell-7-2.tiller"));
        other.open(path_);
        asked->accepted();
        QVERIFY(other.store().obstacle() == ProjectStore::Obstacle::None);
        QTRY_VERIFY_WITH_TIMEOUT(files_->store().obstacle() == ProjectStore::Obstacle::OpenElsewhere, 60'000);
    }

    // The notice may appear under the pointer of a user who is about to click another notice.
    void theDefaultAnswerToAnExternalChangeKeepsBothVersions() {
        files_->open(path_);
        document_->insertWaypoints(0, {named("mine")}, "Teach");
        QVERIFY(files_->store().saveNow().ok());
        QVERIFY(project::saveProject(path_, project::Project()).ok());
        QTRY_VERIFY_WITH_TIMEOUT(files_->store().obstacle() == ProjectStore::Obstacle::ChangedByOther,
                                 60'000);
        QVERIFY(notice_ && notice_->accepted);
        notice_->accepted();
        QCOMPARE(files_->store().path(), directory_->filePath("cell-7-2.tiller"));
        QCOMPARE(document_->waypoints().size(), 1);
    }

    void aRevertedExternalChangeClosesItsNotice() {
        files_->open(path_);
        document_->insertWaypoints(0, {named("mine")}, "Teach");
        QVERIFY(files_->store().saveNow().ok());
        QFile file(path_);
        QVERIFY(file.open(QIODevice::ReadOnly));
        const QByteArray own = file.readAll();
        file.close();
        QSignalSpy resolved(files_.get(), &ProjectFiles::noticeResolved);
        QVERIFY(project::saveProject(path_, project::Project{}).ok());
        QTRY_VERIFY_WITH_TIMEOUT(notice_.has_value(), 60'000);
        const QString cause = notice_->cause;
        resolved.clear();
        QVERIFY(file.open(QIODevice::WriteOnly | QIODevice::Truncate));
        file.write(own);
        file.close();
        QTRY_VERIFY_WITH_TIMEOUT(files_->store().obstacle() == ProjectStore::Obstacle::None, 60'000);
        QCOMPARE(resolved.count(), 1);
        QCOMPARE(resolved[0][0].toString(), cause);
    }

    void aFileThatBecomesUnreadableIsReported() {
        files_->open(path_);
        document_->insertWaypoints(0, {named("mine")}, "Teach");
        QVERIFY(files_->store().saveNow().ok());
        QVERIFY(QFile::remove(path_) && QDir().mkdir(path_));
        QTRY_VERIFY_WITH_TIMEOUT(files_->store().obstacle() == ProjectStore::Obstacle::ChangedByOther,
                                 60'000);
        QVERIFY(notice_.has_value());
    }

    void recoveredWorkIsOfferedAndOpened() {
        const QString folder = directory_->filePath("Unsaved");
        {
            project::CopyKeeper keeper(folder);
            project::Project project;
            project.waypoints.append(named("kept"));
            QVERIFY(keeper.keep(project, "Sample", 1).ok());
        }
        files_->offerKept();
        QVERIFY(!notice_.has_value());
        files_->store().setCopyFolder(folder);
        files_->offerKept();
        QVERIFY(notice_ && notice_->accepted);
        QVERIFY(notice_->text.contains("Sample"));
        notice_->accepted();
        QCOMPARE(document_->waypoints().at(0).name, QString("kept"));
        const Answer answer("unsavedCopy.drop");
        QVERIFY(files_->mayLeave(nullptr));
        QVERIFY(project::keptCopies(folder).isEmpty());
    }

    void aNewProjectIsEmptyAndReplacesNoFile() {
        document_->insertWaypoints(0, {named("a")}, "Teach");
        files_->saveAs(path_);
        QStringList messages;
        QObject listener;
        test::onMessage(journal_, &listener, [&](Severity, const QString& text) { messages << text; });
        files_->startNew(path_, nullptr);
        QCOMPARE(messages.filter("already exists").size(), 1);
        QCOMPARE(document_->waypoints().size(), 1);
        const QString fresh = directory_->filePath("fresh.tiller");
        files_->startNew(fresh, nullptr);
        QCOMPARE(files_->store().path(), fresh);
        QVERIFY(document_->waypoints().isEmpty());
        document_->insertWaypoints(0, {named("b")}, "Teach");
        QVERIFY(files_->mayLeave(nullptr));
        QVERIFY(QFileInfo::exists(fresh));
        files_->open(path_);
        QCOMPARE(document_->waypoints().at(0).name, QString("a"));
    }

    void anExistingFileForANewProjectDiscardsNothing() {
        document_->insertWaypoints(0, {named("a")}, "Teach");
        QFile other(path_);
        QVERIFY(other.open(QIODevice::WriteOnly));
        other.close();
        files_->startNew(path_, nullptr);
        QCOMPARE(document_->waypoints().size(), 1);
        QVERIFY(files_->store().isModified());
    }

    void recoveredWorkIsDiscardedOnRequest() {
        const QString folder = directory_->filePath("Unsaved");
        for (const char* name : {"first", "second"}) {
            project::CopyKeeper keeper(folder);
            project::Project project;
            project.waypoints.append(named("kept"));
            QVERIFY(keeper.keep(project, QString::fromLatin1(name), 1).ok());
        }
        files_->store().setCopyFolder(folder);
        files_->offerKept();
        QVERIFY(notice_ && notice_->otherAccepted);
        QVERIFY(!notice_->other.isEmpty());
        const QString offered = project::keptCopies(folder).first().name;
        {
            const Answer answer("discardKept.keep");
            const auto discard = notice_->otherAccepted;
            discard();
            QVERIFY2(answer.wasAsked(), "the only copy was deleted without a question");
            QCOMPARE(project::keptCopies(folder).size(), 2);
        }
        {
            const Answer answer("discardKept.drop");
            const auto discard = notice_->otherAccepted;
            discard();
        }
        QCOMPARE(project::keptCopies(folder).size(), 1);
        QVERIFY2(project::keptCopies(folder).first().name != offered, "the other copy was removed");
        QVERIFY2(notice_->text.contains(project::keptCopies(folder).first().name), qPrintable(notice_->text));
        const Answer answer("discardKept.drop");
        const auto discardOther = notice_->otherAccepted;
        discardOther();
        QVERIFY(project::keptCopies(folder).isEmpty());
        QVERIFY2(document_->waypoints().isEmpty(), "a project was opened");
    }

    void aRefusedProjectLosesNoUnsavedWork() {
        files_->store().setReplaceGuard([] { return QStringLiteral("A program is running."); });
        document_->insertWaypoints(0, {named("home")}, "Teach");
        const Answer answer("unsavedCopy.drop");
        QVERIFY(!files_->mayReplace(nullptr));
        files_->askToOpen(nullptr);
        files_->askForNew(nullptr);
        files_->open(path_);
        files_->startNew(path_, nullptr);
        QVERIFY2(!answer.wasAsked(), "the user was asked about unsaved work although no project is opened");
        QCOMPARE(document_->waypoints().size(), 1);
        QVERIFY(notice_);
        QCOMPARE(notice_->text, QStringLiteral("A program is running."));
        QSignalSpy resolved(files_.get(), &ProjectFiles::noticeResolved);
        files_->store().setReplaceGuard([] { return QString(); });
        files_->endRefusal();
        QCOMPARE(resolved.value(0).value(0).toString(), notice_->cause);
    }

    // The question is repeated after a refused reload. Otherwise, the user could not load the changed file.
    void aRefusedReloadIsAskedAgain() {
        files_->open(path_);
        document_->insertWaypoints(0, {named("mine")}, "Teach");
        QVERIFY(files_->store().saveNow().ok());
        QVERIFY(project::saveProject(path_, project::Project()).ok());
        QTRY_VERIFY_WITH_TIMEOUT(files_->store().obstacle() == ProjectStore::Obstacle::ChangedByOther,
                                 60'000);
        QVERIFY(notice_ && notice_->otherAccepted);
        files_->store().setReplaceGuard([] { return QStringLiteral("A program is running."); });
        const auto reload = notice_->otherAccepted;
        reload();
        QCOMPARE(notice_->text, QStringLiteral("A program is running."));
        files_->store().setReplaceGuard([] { return QString(); });
        files_->endRefusal();
        QVERIFY(notice_->otherAccepted);
        const auto again = notice_->otherAccepted;
        again();
        QVERIFY(document_->waypoints().isEmpty());
    }

    void savingAsksAgainAfterDecideLater() {
        files_->open(path_);
        document_->insertWaypoints(0, {named("mine")}, "Teach");
        QVERIFY(files_->store().saveNow().ok());
        QVERIFY(project::saveProject(path_, project::Project()).ok());
        QTRY_VERIFY_WITH_TIMEOUT(notice_ && notice_->otherAccepted, 60'000);
        notice_.reset();  // "Decide later"
        files_->save(nullptr);
        QVERIFY(notice_ && notice_->otherAccepted);
        const auto reload = notice_->otherAccepted;
        reload();
        QVERIFY(document_->waypoints().isEmpty());
        // If no question is pending, the project is saved.
        document_->insertWaypoints(0, {named("new")}, "Teach");
        files_->save(nullptr);
        QVERIFY(!files_->store().isModified());
        QVERIFY(content().contains("new"));
    }

    void newProjectsAreSavedInTheDocumentsFolder() {
        QVERIFY2(projectFolder().endsWith("/Tiller"), qPrintable(projectFolder()));
        QVERIFY2(!projectFolder().contains("/."), qPrintable(projectFolder()));
    }

private:
    static project::Waypoint named(const QString& name) {
        project::Waypoint point;
        point.id = QUuid::createUuid();
        point.name = name;
        return point;
    }
    QByteArray content() const {
        QFile file(path_);
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
    }

    std::unique_ptr<QTemporaryDir> directory_;
    QString path_;
    Journal journal_;
    std::unique_ptr<UndoableDocument> document_;
    std::unique_ptr<ProjectStore> store_;
    std::unique_ptr<ProjectFiles> files_;
    std::optional<Notice> notice_;
};

QTEST_MAIN(TestProjectFiles)
#include "tst_project_files.moc"
