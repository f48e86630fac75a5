// SPDX-License-Identifier: MIT
// The process that moves the arm is killed without warning (SIGKILL), held (SIGSTOP) or cut off, in every way
// of moving: the robot alone comes to a stand, by its own clock within the contract's 250 ms, and stays
// there. Watched through a second RTDE connection. With TILLER_ALL=1 every way is lost in every manner; else
// all are killed.
#include <QProcess>
#include <QTest>
#include <algorithm>
#include <csignal>
#include <vector>

#include "robot/control/registers.h"
#include "robot/rtde/connection.h"
#include "robot/simulator/controller.h"

using namespace tiller;
using control::ScriptState;

namespace {

/// What the robot tells everybody, package by package.
class Watcher {
public:
    explicit Watcher(const simulator::Controller& robot) {
        rtde::ConnectionOptions options;
        options.host = robot.listenAddress();
        options.port = robot.ports().rtde;
        const int first = control::firstRegister(control::ControllerOptions().registers);
        const auto echo = [first](int at) { return "output_int_register_" + std::to_string(first + at); };
        options.request.outputs = {"timestamp", "actual_TCP_speed", "actual_qd", echo(0), echo(2)};
        auto opened = rtde::Connection::open(options, Deadline::after(std::chrono::seconds(20)));
        if (!opened) {
            qFatal("%s", qPrintable(opened.error().toString()));
        }
        connection_ = std::move(*opened);
        values_.resize(connection_->outputs().size());
    }

    bool look() {
        if (connection_->readPackage(values_, std::chrono::seconds(20)) != rtde::Connection::Read::Package) {
            return false;
        }
        time = values_[0];
        speed = Eigen::Vector3d(values_[1], values_[2], values_[3]).norm();
        const auto turning = std::minmax_element(values_.begin() + 7, values_.begin() + 13);
        stands = speed < 0.001 && std::max(-*turning.first, *turning.second) < 0.002;
        const auto echoed = static_cast<std::int32_t>(values_[13]);
        if (echoed != heard_) {
            heard_ = echoed;
            heardAt = time;
        }
        state = static_cast<ScriptState>(static_cast<std::int32_t>(values_[14]));
        return true;
    }

    double time = 0;   ///< of the robot [s]
    double speed = 0;  ///< of the TCP [m/s]
    bool stands = true;
    double heardAt = 0;  ///< when the control program last heard of its PC [s]
    ScriptState state = ScriptState::Ready;

private:
    std::unique_ptr<rtde::Connection> connection_;
    std::vector<double> values_;
    std::int32_t heard_ = 0;
};

enum class Loss { Killed, Stopped, Cut };
constexpr Loss kLosses[] = {Loss::Killed, Loss::Stopped, Loss::Cut};

const char* name(Loss loss) {
    return loss == Loss::Killed ? "kill -9" : loss == Loss::Stopped ? "SIGSTOP" : "cut cable";
}

}  // namespace

class TestKilledProcess : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void aLostProcessEndsInStandstill_data() {
        QTest::addColumn<QString>("way");
        QTest::addColumn<int>("loss");
        QTest::addColumn<double>("fast");
        QTest::addColumn<bool>("hand");
        QTest::addColumn<ScriptState>("end");
        // fast  the speed at which it is lost [m/s]
        const auto row = [](const char* way, double fast, bool hand = false,
                            ScriptState end = ScriptState::Expired) {
            for (const Loss loss : kLosses) {
                // Each way is killed; of the others a run of all does each, and one that is not does some.
                static int count = 0;
                if (loss == Loss::Killed || qEnvironmentVariableIsSet("TILLER_ALL") || count++ % 7 == 0) {
                    QTest::addRow("%s, %s", way, name(loss))
                        << QString::fromLatin1(way) << static_cast<int>(loss) << fast << hand << end;
                }
            }
        };
        constexpr double kFast = 0.095;
        row("jog", kFast);
        row("jog a joint", kFast);
        row("jog until contact", kFast);
        row("move until contact", kFast);
        row("moveJ", kFast);
        row("moveL", kFast);
        row("path", kFast);
        row("servoJ", kFast);
        row("servoL", kFast);
        row("servoC", kFast);
        row("speedJ", kFast);
        row("speedL", kFast);
        // The hand goes on pushing: an arm that stands has left freedrive.
        row("freedrive", 0.05, true);
        row("teach mode", 0.05, true);
        // No motion that could expire: force mode ends beside it.
        row("force mode", 0.03, false, ScriptState::Ready);
        row("jog in force mode", kFast);
        row("section", kFast);
        row("section with a thread", kFast);
        row("section on a conveyor", kFast);
        row("section in force mode", 0.03);
        row("section in freedrive", 0.05, true);
    }
    void aLostProcessEndsInStandstill() {
        QFETCH(QString, way);
        QFETCH(int, loss);
        QFETCH(double, fast);
        QFETCH(bool, hand);
        QFETCH(ScriptState, end);
        simulator::ControllerOptions options;
        options.anyFreePorts = true;
        options.poweredOn = true;
        options.startJoints = JointPositions(-1.57, -1.2, -2.3, -1.2, 1.57, 0);
        simulator::Controller robot(options);
        QVERIFY(robot.start().ok());
        robot.changeWorld([](simulator::arm::Environment& world) { world.setConveyorSpeed(0, 1000); });
        Watcher watcher(robot);

        QProcess helper;
        helper.setProcessChannelMode(QProcess::ForwardedErrorChannel);
        helper.start(QStringLiteral(MOVING_HELPER),
                     {robot.listenAddress(), QString::number(robot.ports().primary),
                      QString::number(robot.ports().rtde), way});
        QVERIFY(helper.waitForStarted(20'000));
        const double patience = 60;  // [s] of robot time
        QVERIFY(watcher.look());
        const double begin = watcher.time;
        while (watcher.speed < fast) {
            QVERIFY(watcher.look());
            QVERIFY2(watcher.time - begin < patience, "the helper never moved the arm");
            // Not before: who is pushed when freedrive begins gets a protective stop.
            if (hand && watcher.state == ScriptState::Executing) {
                robot.pressHand({{0, 0, 12}, {0, 0, 0}});
            }
        }
        const double killedAt = robot.truth().timestamp;
        switch (static_cast<Loss>(loss)) {
            case Loss::Killed:
                helper.kill();  // SIGKILL
                QVERIFY(helper.waitForFinished(20'000));
                break;
            case Loss::Stopped:
                ::kill(static_cast<pid_t>(helper.processId()), SIGSTOP);
                break;
            case Loss::Cut:
                // The watcher hears nothing either: the robot itself is asked.
                QVERIFY(robot.inject(QStringLiteral("link lost")).ok());
                break;
        }
        if (static_cast<Loss>(loss) == Loss::Cut) {
            double moved = killedAt;
            while (robot.truth().timestamp < killedAt + 1.0) {
                const simulator::Truth now = robot.truth();
                const bool stands =
                    now.tcpSpeed.linear.norm() < 0.001 && now.qd.values.cwiseAbs().maxCoeff() < 0.002;
                moved = stands ? moved : now.timestamp;
                QTest::qSleep(1);
            }
            const double ms = (moved - killedAt) * 1000;
            qInfo("%s: to standstill: %.0f ms", QTest::currentDataTag(), ms);
            QVERIFY2(ms <= 250, qPrintable(QString::number(ms)));
            helper.kill();
            QVERIFY(helper.waitForFinished(20'000));
            return;
        }
        double lastMoved = killedAt;
        while (watcher.time < killedAt + 1.0) {
            QVERIFY(watcher.look());
            if (!watcher.stands) {
                lastMoved = watcher.time;
            }
        }
        // On a busy machine the signal may take its time: what counts then is the last the robot heard.
        const double ms = (lastMoved - std::max(killedAt, watcher.heardAt)) * 1000;
        qInfo("%s: to standstill: %.0f ms", QTest::currentDataTag(), ms);
        QVERIFY2(ms <= 250, qPrintable(QString::number(ms)));
        QVERIFY(watcher.stands);
        QCOMPARE(watcher.state, end);
        QCOMPARE(robot.truth().safetyMode, SafetyMode::Normal);
        helper.kill();
        QVERIFY(helper.state() == QProcess::NotRunning || helper.waitForFinished(20'000));
    }
};

QTEST_GUILESS_MAIN(TestKilledProcess)
#include "tst_killed_process.moc"
