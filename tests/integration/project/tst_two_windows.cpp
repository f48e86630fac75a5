// SPDX-License-Identifier: GPL-3.0-or-later
//
// Two windows in separate processes edit one project on a small disk. They are killed at random times, and
// the disk is sometimes full. The file must always be complete and contain every edit that a window reported
// as saved. A window with an unsaved edit must report it.
//
// TILLER_TEST_KILLS is the number of kills and full-disk events. 500 of them take several minutes.

#include <QCoreApplication>
#include <QDeadlineTimer>
#include <QDir>
#include <QElapsedTimer>
#include <QProcess>
#include <QRandomGenerator>
#include <QSocketNotifier>
#include <QTemporaryDir>
#include <QTest>
#include <QTimer>
#include <algorithm>
#include <array>
#include <cstdio>
#include <memory>

#include "robot/station/document/project_document.h"
#include "robot/station/document/project_store.h"
#include "tests/support/small_disk.h"

using namespace tiller;

namespace {

constexpr int kUsualRounds = 25;
constexpr char kWindow[] = "--window";

int numberOf(const project::Project& project, const QString& side) {
    for (const project::Waypoint& point : project.waypoints) {
        if (point.name == side) {
            return point.note.section(u' ', 0, 0).toInt();
        }
    }
    return 0;
}

/// One window. It increments the count in its waypoint. Its actions are random, like those of an operator.
class Window : public QObject {
public:
    Window(const QString& file, const QString& side, const QString& copies, quint32 seed)
        : file_(file), side_(side), random_(seed), store_(document_) {
        store_.setCopyFolder(copies);
        connect(&store_, &ProjectStore::statusChanged, this, [this] { reportSaved(); });
        if (!store_.openOrStart(file)) {
            say("broken");
        }
        connect(&timer_, &QTimer::timeout, this, [this] { act(); });
        timer_.start(15);
        connect(&input_, &QSocketNotifier::activated, this, [this] { quit(); });
        say("open");
    }

private:
    void say(const QString& line) {
        std::fputs(qPrintable(line + u'\n'), stdout);
        std::fflush(stdout);
    }

    void act() {
        using Obstacle = ProjectStore::Obstacle;
        if (store_.path() != file_) {
            // The edit was saved as a copy next to the file.
            if (store_.isSaved()) {
                (void)store_.open(file_);
            }
        } else if (store_.obstacle() == Obstacle::ChangedByOther && random_.bounded(4) == 0) {
            if (random_.bounded(2) == 0) {
                pending_ = 0;  // the operator discarded the edit
                (void)store_.reload();
            } else if (store_.keepBoth()) {
                pending_ = 0;
            }
        } else if (store_.obstacle() == Obstacle::OpenElsewhere && random_.bounded(12) == 0) {
            (void)store_.takeOver();
        } else if (random_.bounded(pending_ == 0 ? 2 : 12) == 0) {
            edit();
        }
    }

    void edit() {
        const project::WaypointList& points = document_.waypoints();
        const int number = numberOf(document_.project(), side_) + 1;
        // Write files of all sizes around the buffer sizes.
        const QString note =
            QStringLiteral("%1 %2").arg(number).arg(QString(random_.bounded(40'000), QLatin1Char('x')));
        pending_ = number;
        for (int row = 0; row < points.size(); ++row) {
            if (points.at(row).name == side_) {
                project::Waypoint point = points.at(row);
                point.note = note;
                point.history = {};
                document_.replaceRaw({point});
                return;
            }
        }
        project::Waypoint point;
        point.id = QUuid::createUuid();
        point.name = side_;
        point.note = note;
        document_.insertWaypoints(0, {point}, "Teach");
    }

    void reportSaved() {
        if (store_.isSaved() && pending_ > 0) {
            if (store_.path() == file_) {
                say(QStringLiteral("saved %1").arg(pending_));
            }
            pending_ = 0;
        }
    }

    void quit() {
        timer_.stop();
        input_.setEnabled(false);
        QElapsedTimer since;
        since.start();
        const auto isClear = [this] { return pending_ == 0 || store_.statusText().contains("not saved"); };
        while (!isClear() && since.elapsed() < 20'000) {
            QCoreApplication::processEvents(QEventLoop::AllEvents, 20);
        }
        say(isClear() ? QStringLiteral("end") : QStringLiteral("silent: ") + store_.statusText());
        QCoreApplication::quit();
    }

    QString file_;
    QString side_;
    QRandomGenerator random_;
    ProjectDocument document_;
    ProjectStore store_;
    QTimer timer_;
    QSocketNotifier input_{0, QSocketNotifier::Read};
    int pending_ = 0;  ///< number of the unsaved edit; 0 if there is none
};

/// The controlling side of a window.
class WindowProcess {
public:
    WindowProcess(const QString& side, const QString& file, const QString& copies)
        : side_(side), file_(file), copies_(copies) {}

    void start(quint32 seed) {
        open_ = false;
        process_ = std::make_unique<QProcess>();
        process_->setProcessChannelMode(QProcess::ForwardedErrorChannel);
        process_->start(QCoreApplication::applicationFilePath(),
                        {kWindow, file_, side_, copies_, QString::number(seed)});
        QVERIFY(process_->waitForStarted());
    }

    void kill() {
        process_->kill();
        QVERIFY(process_->waitForFinished());
        read();
        process_.reset();
    }

    void read() {
        if (process_ == nullptr) {
            return;
        }
        process_->waitForReadyRead(0);
        rest_ += process_->readAllStandardOutput();
        for (qsizetype end = rest_.indexOf('\n'); end >= 0; end = rest_.indexOf('\n')) {
            const QByteArray line = rest_.left(end);
            rest_.remove(0, end + 1);
            if (line.startsWith("saved ")) {
                saved_ = std::max(saved_, line.mid(6).toInt());
                ++saves_;
            } else if (line == "open") {
                open_ = true;
            } else if (line == "end") {
                ended_ = true;
            } else {
                complaints_ << QString::fromUtf8(line);
            }
        }
        if (process_->state() == QProcess::NotRunning) {
            rest_.clear();
        }
    }

    void quit() {
        process_->write("q\n");
        process_->closeWriteChannel();
        QVERIFY(process_->waitForFinished(60'000));
        read();
        process_.reset();
        QVERIFY2(ended_, qPrintable(side_ + ": " + complaints_.join("; ")));
    }

    bool isRunning() const { return process_ != nullptr; }
    bool isOpen() {
        read();
        return open_;
    }
    const QString& side() const { return side_; }
    int saved() const { return saved_; }
    int saves() const { return saves_; }
    const QStringList& complaints() const { return complaints_; }

private:
    QString side_;
    QString file_;
    QString copies_;
    std::unique_ptr<QProcess> process_;
    QByteArray rest_;
    int saved_ = 0;
    int saves_ = 0;
    bool open_ = false;
    bool ended_ = false;
    QStringList complaints_;
};

}  // namespace

class TestTwoWindows : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void noKillAndNoFullDiskLosesASavedEdit() {
        const int asked = qEnvironmentVariableIntValue("TILLER_TEST_KILLS");
        const int rounds = asked > 0 ? asked : kUsualRounds;
        const quint32 seed = qEnvironmentVariableIsSet("TILLER_TEST_SEED")
                                 ? static_cast<quint32>(qEnvironmentVariableIntValue("TILLER_TEST_SEED"))
                                 : QRandomGenerator::global()->generate();
        qInfo("seed %u, %d kills and full-disk events", seed, rounds);
        QRandomGenerator random(seed);
        const SmallDisk disk(SmallDisk::Kind::Tmpfs, 1024);
        const bool canFill = disk.problem().isEmpty();
        if (!canFill) {
            qInfo("no full-disk events: %s", qPrintable(disk.problem()));
        }
        const QTemporaryDir folder;
        file_ = canFill ? disk.filePath("cell.tiller") : folder.filePath("cell.tiller");
        std::array<WindowProcess, 2> windows{WindowProcess("A", file_, folder.filePath("Unsaved")),
                                             WindowProcess("B", file_, folder.filePath("Unsaved"))};
        int kills = 0;
        int full = 0;
        const auto saves = [&windows] { return windows[0].saves() + windows[1].saves(); };
        const QDeadlineTimer timeLimit(std::chrono::minutes(5));
        // On a busy computer, a round may end before a window has saved anything. More rounds then follow.
        for (int round = 0; round < rounds || (saves() <= rounds / 5 && !timeLimit.hasExpired()); ++round) {
            for (WindowProcess& window : windows) {
                if (!window.isRunning()) {
                    window.start(random.generate());
                }
            }
            // Wait until both windows are open, because a kill while a process is being loaded tests nothing.
            QTRY_VERIFY_WITH_TIMEOUT(windows[0].isOpen() && windows[1].isOpen(), 60'000);
            QTest::qWait(random.bounded(30, 900));
            if (canFill && random.bounded(3) == 0) {
                QVERIFY(disk.fill(random.bounded(12)));
                ++full;
                QTest::qWait(random.bounded(20, 900));
                check(windows);
                if (random.bounded(2) == 0) {
                    windows[random.bounded(2)].kill();
                    ++kills;
                }
                disk.fitToContents();
            } else {
                windows[random.bounded(2)].kill();
                ++kills;
                if (random.bounded(5) == 0) {
                    for (WindowProcess& window : windows) {
                        if (window.isRunning()) {
                            window.kill();
                            ++kills;
                        }
                    }
                }
            }
            check(windows);
            if (QTest::currentTestFailed()) {
                return;
            }
            // Include the copies that the windows keep next to the file.
            for (const QString& copy : QFileInfo(file_).dir().entryList({"cell-*.tiller"}, QDir::Files)) {
                QVERIFY(project::loadProject(QFileInfo(file_).dir().filePath(copy)).ok());
                QFile::remove(QFileInfo(file_).dir().filePath(copy));
            }
        }
        for (WindowProcess& window : windows) {
            if (window.isRunning()) {
                window.quit();
            }
        }
        check(windows);
        qInfo("%d kills, %d full-disk events, %d saves reported; A %d, B %d", kills, full, saves(),
              windows[0].saved(), windows[1].saved());
        QVERIFY2(saves() > rounds / 5, "the windows saved too rarely for a meaningful test");
    }

private:
    void check(std::array<WindowProcess, 2>& windows) {
        // Read the reports of the windows before the file, so that the content of the file is at least as
        // new.
        for (WindowProcess& window : windows) {
            window.read();
            QVERIFY2(window.complaints().isEmpty(),
                     qPrintable(window.side() + ": " + window.complaints().join("; ")));
        }
        if (!QFile::exists(file_)) {
            QVERIFY(windows[0].saved() == 0 && windows[1].saved() == 0);
            return;
        }
        const auto loaded = project::loadProject(file_);
        QVERIFY2(loaded.ok(), qPrintable(loaded.error().toString()));
        for (const WindowProcess& window : windows) {
            const int there = numberOf(*loaded, window.side());
            QVERIFY2(there >= window.saved(),
                     qPrintable(QStringLiteral("%1 reported %2 as saved, the file has %3")
                                    .arg(window.side())
                                    .arg(window.saved())
                                    .arg(there)));
        }
    }

    QString file_;
};

int main(int argc, char** argv) {
    QCoreApplication application(argc, argv);
    if (const QStringList words = QCoreApplication::arguments(); words.value(1) == QLatin1String(kWindow)) {
        Window window(words.value(2), words.value(3), words.value(4), words.value(5).toUInt());
        return QCoreApplication::exec();
    }
    TestTwoWindows test;
    return QTest::qExec(&test, argc, argv);
}

#include "tst_two_windows.moc"
