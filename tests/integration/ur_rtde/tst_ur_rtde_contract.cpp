// SPDX-License-Identifier: MIT
// The stop contract of the ur_rtde interface. Every type of motion runs in a separate process that ignores
// return values, and is tested with every event that must end it. The arm must stop within 250 ms of robot
// time, and only a new command may move it again. The test runs in real time if the process is killed or
// suspended or the cable is cut; otherwise in virtual time.
//
//     tst_ur_rtde_contract --assume NAME=VALUE    with another assumption about real controllers
//     tst_ur_rtde_contract --all                  with each of these assumptions, one after the other
#include <ur_rtde/dashboard_client.h>

#include <QTest>

#include "tests/integration/ur_rtde/ur_rtde_cell.h"
#include "tests/support/moving_process.h"

using namespace tiller;

namespace {

constexpr double kContractMs = 250;
constexpr double kLooksOnFor = 0.6;  // [s] robot time during which no motion may resume
constexpr double kNothing = 0.0003;  // [m] remaining motion of one or two steps, and noise
constexpr double kTestTimeout = 20;  // [s] robot time within which the motion must begin
constexpr int kAttempts = 3;

struct Way {
    const char* name;
    double fast;  ///< TCP speed at which the motion is ended [m/s]
    bool hand;    ///< true if an external force moves the arm
    /// True if the motion continues when disconnect() is called with the option to let it finish.
    bool finishes;
    bool yields = false;  ///< true if the arm yields to forces
};

constexpr Way kWays[] = {
    {"moveJ", 0.05, false, true},
    {"moveJ_IK", 0.03, false, true},
    {"moveL", 0.05, false, true},
    {"moveL_FK", 0.05, false, true},
    {"path", 0.05, false, true},
    {"speedJ", 0.05, false, false},
    {"speedJ once", 0.05, false, false},
    {"speedL", 0.05, false, false},
    {"servoJ", 0.05, false, false},
    {"servoL", 0.04, false, false},
    {"servoC", 0.05, false, false},
    {"jog", 0.05, false, false},
    {"jog in the tool's frame", 0.05, false, false},
    {"move until contact", 0.05, false, false},
    {"force mode", 0.02, false, false, true},
    // The external force continues, so if the arm stops, it has left freedrive.
    {"freedrive", 0.03, true, false, true},
    {"teach mode", 0.03, true, false, true},
};

constexpr const char* kEnds[] = {
    "release",   "disconnect",  "leave",          "kill -9",         "kill -9 after a silence", "suspended",
    "cut cable", "silent link", "debugger pause", "protective stop", "safeguard stop",          "pause"};

// The servo targets of the mover follow the clock of that process, so these motions also need real time.
bool isInRealTime(const QByteArray& end, const QByteArray& way) {
    return end.startsWith("kill -9") || end == "suspended" || end == "cut cable" || end == "debugger pause" ||
           way == "servoJ" || way == "servoL";
}

/// Returns true if the robot has no built-in function for this motion.
bool isMissing(const simulator::BehaviourOptions& assumptions, const QByteArray& way) {
    using Builtin = simulator::BehaviourOptions::Builtin;
    return (way == "teach mode" && assumptions.teachMode == Builtin::Missing) ||
           (way == "servoC" && assumptions.servoc == Builtin::Missing);
}

QStringList assumed;  ///< assumptions that apply to every row
bool runsAll = false;

simulator::BehaviourOptions assumptionsOf(const QString& more) {
    simulator::BehaviourOptions assumptions;
    QStringList words = assumed;
    if (!more.isEmpty()) {
        words.append(more);
    }
    for (const QString& word : words) {
        if (const auto taken = simulator::assume(assumptions, word); !taken) {
            qFatal("%s", qPrintable(taken.error().toString()));
        }
    }
    return assumptions;
}

}  // namespace

class TestUrRtdeContract : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void everyEndLeavesTheArmAtStandstill_data() {
        QTest::addColumn<int>("way");
        QTest::addColumn<QByteArray>("end");
        QTest::addColumn<QString>("assumption");
        const auto row = [](const QString& assumption, const char* end, int way) {
            const QString name = QStringLiteral("%1, %2").arg(QLatin1String(end), kWays[way].name);
            QTest::newRow(qPrintable(assumption.isEmpty() ? name : assumption + ", " + name))
                << way << QByteArray(end) << assumption;
        };
        constexpr int kWayCount = static_cast<int>(std::size(kWays));
        QStringList assumptions{QString()};
        for (const auto& info : simulator::assumptionTable()) {
            for (const QString& reading : runsAll ? info.readings.mid(1) : QStringList()) {
                assumptions.append(info.name + '=' + reading);
            }
        }
        for (const QString& assumption : assumptions) {
            for (const char* end : kEnds) {
                for (int way = 0; way < kWayCount; ++way) {
                    row(assumption, end, way);
                }
            }
        }
        // While a program is paused, it cannot end these motions. The client must end them.
        for (int way = 0; way < kWayCount && !runsAll && assumed.isEmpty(); ++way) {
            if (kWays[way].yields) {
                row("pause=frees", "pause", way);
                row("pause=frees", "safeguard stop", way);
            }
        }
    }
    void everyEndLeavesTheArmAtStandstill() {
        QFETCH(int, way);
        QFETCH(QByteArray, end);
        QFETCH(QString, assumption);
        const Way& moving = kWays[way];
        test::UrRtdeCell cell([&](simulator::SimulatorOptions& options) {
            options.time = isInRealTime(end, moving.name) ? simulator::Time::Real : simulator::Time::Virtual;
            options.assumptions = assumptionsOf(assumption);
            options.startJoints = JointPositions(-1.57, -1.2, -2.3, -1.2, 1.57, 0);
        });
        test::ArmWatcher watcher(cell.robot, control::RegisterRange::Lower);
        test::MovingProcess mover(QStringLiteral(UR_RTDE_MOVER),
                                  {QString::fromStdString(cell.host()), QString::fromLatin1(moving.name)});
        const auto during = [&](auto isOver) {
            while (!isOver()) {
                if (!mover.isRunning() || !watcher.look()) {
                    return false;
                }
            }
            return true;
        };
        QVERIFY(during([&] { return mover.hasSaid("ready"); }));
        if (end == "kill -9 after a silence") {
            mover.suspend();
            QVERIFY(watcher.lookUntil(cell.robot.truth().timestamp + 0.4));
            mover.resume();
        }
        mover.tell("begin");
        if (isMissing(cell.robot.options().assumptions, moving.name)) {
            QVERIFY(during([&] { return mover.hasSaid("begin done"); }));
            QVERIFY(watcher.lookUntil(cell.robot.truth().timestamp + 0.3));
            QVERIFY(watcher.stands && watcher.lastMoved == 0);
            return;
        }
        double begin = watcher.time;
        int attempts = 1;
        while (watcher.speed < moving.fast) {
            QVERIFY(watcher.look());
            if (watcher.time - begin > kTestTimeout) {
                // On a busy computer, the mover may have missed its heartbeat and been stopped.
                QVERIFY2(++attempts <= kAttempts, "the arm never moved");
                mover.tell("again");
                begin = watcher.time;
            }
            // Apply the force only now, because a force at the start of freedrive causes a protective stop.
            if (moving.hand && watcher.time > begin + 0.2) {
                cell.robot.pressHand({{0, 0, 12}, {0, 0, 0}});
            }
        }
        ur_rtde::DashboardClient pendant(cell.host());
        pendant.connect();

        const double endedAt = cell.robot.truth().timestamp;
        double obeyedAt = endedAt + 0.5;  // latest possible time
        if (end == "release" || end == "disconnect" || end == "leave") {
            mover.tell(end.constData());
            QVERIFY(during([&] { return mover.hasSaid(end + " done"); }));
            obeyedAt = cell.robot.truth().timestamp;
        } else if (end.startsWith("kill -9")) {
            mover.kill();
        } else if (end == "suspended" || end == "debugger pause") {
            mover.suspend();
        } else if (end == "cut cable") {
            QVERIFY(cell.robot.inject("link lost").ok());
        } else if (end == "silent link") {
            cell.robot.silence(true);
        } else if (end == "protective stop") {
            cell.robot.protectiveStop();
        } else if (end == "safeguard stop") {
            cell.robot.safeguardStop(true);
        } else if (end == "pause") {
            pendant.pause();
        }
        if (end == "leave" && moving.finishes) {
            QVERIFY(watcher.lookUntil(endedAt + 0.5));
            QVERIFY2(!watcher.stands, "the unattended move did not continue");
            cell.robot.pressHand({});
            return;
        }
        if (end == "cut cable" || end == "silent link") {
            // No client receives data, so query the robot itself.
            const double ms = test::movesOn(cell.robot, endedAt, endedAt + 0.7) * 1000;
            qInfo("%s: %.0f ms", QTest::currentDataTag(), ms);
            QVERIFY2(ms <= kContractMs, qPrintable(QString::number(ms)));
            if (end == "cut cable") {
                QVERIFY(cell.robot.inject("link back").ok());
            } else {
                cell.robot.silence(false);
            }
            const auto q = cell.robot.truth().q;
            QVERIFY(cell.pass(kLooksOnFor));
            QVERIFY((cell.robot.truth().q.values - q.values).norm() < 1e-3);
            cell.robot.pressHand({});
            return;
        }
        QVERIFY(watcher.lookUntil(obeyedAt + 0.3));
        // On a busy computer, the signal may be delayed, so measure from the last packet received by the
        // robot.
        const bool isSilent = end.startsWith("kill -9") || end == "disconnect" || end == "leave" ||
                              end == "suspended" || end == "debugger pause";
        const double from = isSilent ? std::clamp(watcher.heardAt, endedAt, obeyedAt) : endedAt;
        const double ms = (watcher.lastMoved - from) * 1000;
        qInfo("%s: %.0f ms", QTest::currentDataTag(), ms);
        QVERIFY(watcher.stands);
        if (end != "release") {  // a release uses the requested deceleration
            QVERIFY2(ms <= kContractMs, qPrintable(QString::number(ms)));
        }

        // The motion must not resume.
        if (end == "debugger pause") {
            mover.resume();
        } else if (end == "protective stop") {
            const double over = endedAt + 6;  // minimum duration of a protective stop
            QVERIFY(cell.hurried([&] { return watcher.lookUntil(over); }));
            pendant.unlockProtectiveStop();
        } else if (end == "safeguard stop") {
            cell.robot.safeguardStop(false);
        } else if (end == "pause") {
            QVERIFY(cell.pass(0.2));
            try {
                pendant.play();
            } catch (const std::runtime_error&) {
                QVERIFY(moving.yields);  // the program was stopped because of the pause
            }
        }
        QVERIFY(watcher.look());
        const double back = cell.robot.truth().timestamp;
        QVERIFY(watcher.lookUntil(back));
        const Eigen::Vector3d rest = watcher.position;
        double furthest = 0;
        while (watcher.time < back + kLooksOnFor) {
            QVERIFY(watcher.look());
            furthest = std::max(furthest, (watcher.position - rest).norm());
        }
        cell.robot.pressHand({});
        QVERIFY2(watcher.stands && furthest < kNothing,
                 qPrintable(QStringLiteral("it moved again, by %1 mm").arg(furthest * 1000)));
    }
};

int main(int argc, char** argv) {
    std::vector<char*> rest;
    for (int i = 0; i < argc; ++i) {
        if (qstrcmp(argv[i], "--all") == 0) {
            runsAll = true;
        } else if (qstrcmp(argv[i], "--assume") == 0 && i + 1 < argc) {
            assumed.append(QString::fromLocal8Bit(argv[++i]));
        } else {
            rest.push_back(argv[i]);
        }
    }
    int count = static_cast<int>(rest.size());
    QCoreApplication app(count, rest.data());
    TestUrRtdeContract test;
    return QTest::qExec(&test, count, rest.data());
}
#include "tst_ur_rtde_contract.moc"
