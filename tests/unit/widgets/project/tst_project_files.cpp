// SPDX-License-Identifier: GPL-3.0-or-later
//
// What an operator is told about project files: damaged ones, those of another version, and where new ones
// go.

#include <QFile>
#include <QJsonDocument>
#include <QJsonObject>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <memory>
#include <optional>

#include "widgets/project/project_document.h"
#include "widgets/project/project_files.h"

using namespace tiller;

class TestProjectFiles : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() {
        directory_ = std::make_unique<QTemporaryDir>();
        path_ = directory_->filePath("cell-7.tiller");
        document_ = std::make_unique<ProjectDocument>();
        files_ = std::make_unique<ProjectFiles>(*document_);
        notice_.reset();
        connect(files_.get(), &ProjectFiles::noticeWanted, this,
                [this](const ProjectNotice& notice) { notice_ = notice; });
    }
    void cleanup() {
        files_.reset();
        document_.reset();
    }

    void aFileOfANewerTillerAsksForAnUpdateAndBlamesNoRobot() {
        QFile file(path_);
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(R"({"format": "tiller-session", "version": 99, "frames": [], "waypoints": []})");
        file.close();
        const QByteArray before = content();
        QSignalSpy said(files_.get(), &ProjectFiles::message);
        files_->open(path_);
        QVERIFY(notice_.has_value());
        QVERIFY2(notice_->text.contains("Update Tiller"), qPrintable(notice_->text));
        QVERIFY2(!notice_->text.contains("robot", Qt::CaseInsensitive), qPrintable(notice_->text));
        QCOMPARE(said.count(), 1);
        QCOMPARE(said[0][1].toString(), notice_->text);
        QVERIFY(files_->store().path().isEmpty());
        QCOMPARE(content(), before);
    }

    void aFileOfAnEarlierTillerIsOpenedAndSavedAsAProject() {
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
        QCOMPARE(content(), old);  // looking at it changes nothing
        document_->insertWaypoints(1, {named("pick")}, "Teach");
        QVERIFY(files_->store().saveNow().ok());
        QVERIFY(content().contains("\"tiller-project\""));
        QCOMPARE(project::loadProject(path_)->waypoints.size(), 2);
        QVERIFY2(!QFile::exists(path_ + ".damaged-1"), "the old file was whole");
    }

    void anotherFileBehindTheProjectIsTold() {
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

    void aDamagedFileOffersWhatCanBeRead() {
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

    void aFileThatIsNoProjectOffersNothing() {
        QFile file(path_);
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write("hello");
        file.close();
        files_->open(path_);
        QVERIFY(notice_.has_value());
        QVERIFY(notice_->accept.isEmpty() && !notice_->accepted);
    }

    void newProjectsGoToTheDocuments() {
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
    std::unique_ptr<ProjectDocument> document_;
    std::unique_ptr<ProjectFiles> files_;
    std::optional<ProjectNotice> notice_;
};

QTEST_MAIN(TestProjectFiles)
#include "tst_project_files.moc"
