// SPDX-License-Identifier: GPL-3.0-or-later
//
// All sockets of the robot accept data and send nothing. The user triggers every function of the window. The
// event loop must never block.

#include <QAbstractButton>
#include <QAbstractEventDispatcher>
#include <QDialog>
#include <QFile>
#include <QMap>
#include <QPointer>
#include <QTest>
#include <algorithm>
#include <cmath>

#include "app/action_table.h"
#include "resources/resources.h"
#include "tests/support/window_bench.h"
#include "tests/ui/jog_fixture.h"
#include "widgets/waypoints/waypoints_tab.h"

using namespace tiller;
using namespace tiller::test;

namespace {

constexpr double kMaxWaitMs = 50;
/// A hypervisor or a busy disk can delay single steps. A step that waits for the robot would be slow in every
/// attempt.
constexpr int kAttempts = 3;

/// Divides the time of a thread into computing, waiting for a CPU, and being blocked. The first two depend on
/// the computer. Blocking is caused by sockets, locks or disks.
class Stretch {
public:
    Stretch() { restart(); }
    void restart() {
        wall_ = now();
        busy_ = schedule();
    }
    double blockedMs() const { return (now() - wall_ - (schedule() - busy_)) / 1e6; }

    static bool isMeasurable() { return QFile::exists(QStringLiteral("/proc/thread-self/schedstat")); }

private:
    static double now() { return static_cast<double>(SteadyClock::shared().nowNs()); }
    /// Returns CPU time and time waiting for a CPU [ns].
    static double schedule() {
        QFile file(QStringLiteral("/proc/thread-self/schedstat"));
        if (!file.open(QIODevice::ReadOnly)) {
            return 0;
        }
        const QList<QByteArray> numbers = file.readAll().split(' ');
        return numbers.value(0).toDouble() + numbers.value(1).toDouble();
    }
    double wall_ = 0;
    double busy_ = 0;
};

/// Measures the longest time that the event loop was blocked inside one iteration. Waiting between
/// iterations, e.g. in the event loop of a dialog, does not count.
class TurnWatch : public QObject {
public:
    TurnWatch() {
        auto* loop = QAbstractEventDispatcher::instance();
        connect(loop, &QAbstractEventDispatcher::aboutToBlock, this, &TurnWatch::endTurn);
        connect(loop, &QAbstractEventDispatcher::awake, this, [this] { turn_.restart(); });
    }
    double longestMs() {
        endTurn();
        return longest_;
    }

private:
    void endTurn() {
        longest_ = std::max(longest_, turn_.blockedMs());
        turn_.restart();
    }
    Stretch turn_;
    double longest_ = 0;
};

using Bench = WindowBench;
/// Blocking time of each step [ms].
using Waits = QMap<QString, double>;

void closeWhatOpened(const QWidget& window) {
    // Closing one dialog may close others.
    const QWidgetList all = QApplication::topLevelWidgets();
    const QList<QPointer<QWidget>> still(all.begin(), all.end());
    for (const QPointer<QWidget>& top : still) {
        if (top && top != &window && top->isVisible()) {
            top->close();
        }
    }
}

}  // namespace

class TestBlackHole : public QObject {
    Q_OBJECT

private:
    static void askForEverything(Waits& waits);

private Q_SLOTS:
    void initTestCase() {
        initResources();
        if (!Stretch::isMeasurable()) {
            QSKIP("this system does not report how long a thread was blocked");
        }
    }

    void theCheckDetectsABlockedThread() {
        const Stretch asleep;
        QTest::qSleep(120);
        QVERIFY2(asleep.blockedMs() > 60, "sleeping does not count as blocked");
        double least = 1e9;
        for (int attempt = 0; attempt < kAttempts && least >= 20; ++attempt) {
            const Stretch busy;
            double sum = 0;
            for (int i = 0; i < 3'000'000; ++i) {
                sum += std::sin(i);
            }
            QVERIFY(sum != 0.5);
            least = std::min(least, busy.blockedMs());
        }
        QVERIFY2(least < 20, "computing counts as blocked");
    }

    void noActionWaitsForTheRobot() {
        Waits slow;
        for (int attempt = 0; attempt < kAttempts && (attempt == 0 || !slow.isEmpty()); ++attempt) {
            Waits waits;
            askForEverything(waits);
            if (QTest::currentTestFailed()) {
                return;
            }
            const QStringList suspects = attempt == 0 ? waits.keys() : slow.keys();
            slow.clear();
            for (const QString& step : suspects) {
                if (waits.value(step) > kMaxWaitMs) {
                    slow[step] = waits.value(step);
                }
            }
        }
        QStringList reported;
        for (auto step = slow.cbegin(); step != slow.cend(); ++step) {
            reported << QStringLiteral("%1: blocked for %2 ms").arg(step.key()).arg(step.value(), 0, 'f', 1);
        }
        QVERIFY2(reported.isEmpty(), qPrintable(reported.join('\n')));
    }
};

/// Calls all functions of the window, with a robot that does not respond.
void TestBlackHole::askForEverything(Waits& waits) {
    Bench bench;
    bench.window.resize(1280, 720);
    bench.window.show();
    QVERIFY(QTest::qWaitForWindowExposed(&bench.window));
    bench.window.openProject(bench.folder.filePath("cell.tiller"));
    QVERIFY2(bench.cell.bringUp(), qPrintable(bench.cell.what()));
    bench.window.waypoints().teach();
    bench.window.session().recording().start(bench.folder.filePath("recording.csv"));
    bench.cell.advanceMs(100);
    bench.cell.robot.silence(true);

    const auto measure = [&](const QString& what, const std::function<void()>& action) {
        TurnWatch watch;
        action();
        for (int turn = 0; turn < 5; ++turn) {
            QCoreApplication::processEvents();
            bench.window.session().refresh();
            bench.clock.advanceNs(16 * kNsPerMs);
        }
        waits[what] = std::max(waits.value(what), watch.longestMs());
    };
    // A file dialog has its own event loop, so it must be closed from inside that loop.
    QTimer closer;
    connect(&closer, &QTimer::timeout, &bench.window, [&bench] {
        if (QApplication::activeModalWidget() != nullptr) {
            closeWhatOpened(bench.window);
        }
    });
    closer.start(5);
    int actions = 0;
    for (QAction* action : bench.window.actions().all()) {
        // These actions close the window, end the connection, or start another robot. They are tested below.
        if (QStringList{"app.quit", "robot.disconnect", "robot.simulator"}.contains(action->objectName())) {
            continue;
        }
        measure(action->objectName(), [action] {
            // Also trigger disabled actions, because no action may wait for the robot.
            action->setEnabled(true);
            action->trigger();
        });
        measure(action->objectName() + " closed", [&bench] { closeWhatOpened(bench.window); });
        ++actions;
    }
    QVERIFY(actions > 30);
    for (HoldToRunButton* key : bench.window.jogColumn().holdKeys()) {
        measure("press " + key->objectName(), [key] { press(*key); });
        measure("release " + key->objectName(), [key] { release(*key); });
    }
    RobotSession& session = bench.window.session();
    measure("take control", [&session] { session.takeControl(); });
    measure("set an output", [&session] { session.outputs().setDigitalOutput(3, true); });
    measure("speed slider", [&session] { session.outputs().setSpeedSlider(0.5); });
    measure("record", [&] { session.recording().start(bench.folder.filePath("second.csv")); });
    measure("stop recording", [&session] { session.recording().stop(); });
    measure("teach and save by itself", [&bench] {
        bench.window.waypoints().teach();
        QTest::qWait(1);
    });
    for (const RobotCommand command :
         {RobotCommand::PowerOn, RobotCommand::ReleaseBrakes, RobotCommand::PowerOff,
          RobotCommand::RestartSafety, RobotCommand::ClosePopups, RobotCommand::Play, RobotCommand::Pause,
          RobotCommand::StopProgram}) {
        measure(commandText(command), [&session, command] { session.services().perform(command); });
    }
    measure("stop", [&session] { session.stop(control::StopCause::StopButton); });
    measure("disconnect", [&session] { session.disconnectFromRobot(); });
    measure("connect to nobody", [&bench] {
        bench.window.connectRobot({"Mute", bench.cell.robot.listenAddress(), 0, false});
    });
    measure("disconnect again", [&session] { session.disconnectFromRobot(); });

    QList<double> sorted = waits.values();
    std::sort(sorted.begin(), sorted.end());
    qInfo("%lld steps; blocked: median %.2f ms, p99 %.2f ms, maximum %.2f ms",
          static_cast<long long>(sorted.size()), sorted[sorted.size() / 2], sorted[sorted.size() * 99 / 100],
          sorted.last());
}

QTEST_MAIN(TestBlackHole)
#include "tst_black_hole.moc"
