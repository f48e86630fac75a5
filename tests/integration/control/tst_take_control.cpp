// SPDX-License-Identifier: MIT
// All ways in which taking control can fail, and their error messages.
#include <QDeadlineTimer>
#include <QDir>
#include <QFile>
#include <QTcpServer>
#include <QTcpSocket>
#include <QTest>
#include <QThread>
#include <QTimer>
#include <future>

#ifdef __linux__
#include <sched.h>
#endif

#include "robot/control/arm_queries.h"
#include "robot/control/compliance.h"
#include "robot/control/controller.h"
#include "robot/control/motions.h"
#include "robot/control/programs.h"
#include "robot/control/tool_setup.h"
#include "robot/rtde/connection.h"
#include "robot/script/script_client.h"
#include "robot/simulator/simulator.h"
#include "tests/support/asked_clock.h"
#include "tests/support/raw_peer.h"
#include "tests/support/rtde_peer.h"
#include "tests/unit/robot/script/primary_bytes.h"

using namespace tiller;
using namespace tiller::control;
using namespace tiller::test;
using std::chrono::milliseconds;

namespace {

Deadline soon() {
    return Deadline::after(std::chrono::seconds(30));
}

ControllerOptions to(int primary, int rtde) {
    ControllerOptions options;
    options.primaryPort = primary;
    options.rtdePort = rtde;
    options.priority = 0;
    return options;
}

simulator::SimulatorOptions robotOptions() {
    simulator::SimulatorOptions options;
    options.anyFreePorts = true;
    options.poweredOn = true;
    return options;
}

ControllerOptions to(const simulator::Simulator& robot) {
    return to(robot.ports().primary, robot.ports().rtde);
}

/// A simulated controller that evaluates received data with a delay, and discards them if the sender has
/// disconnected.
class Choosy : public QThread {
public:
    explicit Choosy(int primary) : primary_(primary) {
        start();
        port_ = listening_.get_future().get();
    }
    ~Choosy() override {
        quit();
        wait();
    }
    int port() const { return port_; }

protected:
    void run() override {
        QTcpServer server;
        server.listen(QHostAddress::LocalHost);
        QObject::connect(&server, &QTcpServer::newConnection, &server, [&] {
            QTcpSocket* client = server.nextPendingConnection();
            auto* robot = new QTcpSocket(client);
            robot->connectToHost(QHostAddress::LocalHost, static_cast<quint16>(primary_));
            QObject::connect(robot, &QTcpSocket::readyRead, client,
                             [client, robot] { client->write(robot->readAll()); });
            QObject::connect(client, &QTcpSocket::readyRead, client, [client, robot] {
                constexpr int kMoment = 100;  // [ms]
                QTimer::singleShot(kMoment, client, [client, robot] {
                    if (client->state() == QAbstractSocket::ConnectedState) {
                        robot->write(client->readAll());
                    }
                });
            });
        });
        listening_.set_value(server.serverPort());
        exec();
    }

private:
    int primary_;
    int port_ = 0;
    std::promise<int> listening_;
};

void makeRunning(RtdePeer& peer) {
    peer.set("robot_mode", {7});
    peer.set("safety_mode", {1});
    peer.set("runtime_state", {1});
    for (int i = 1; i <= 20; ++i) {
        peer.send(60 + 0.002 * i);
    }
}

/// Returns the CPUs of the thread with this name, as printed by the system; empty if there is no such thread.
QByteArray cpusOf(const QByteArray& thread) {
    const auto tasks =
        QDir(QStringLiteral("/proc/self/task")).entryInfoList(QDir::Dirs | QDir::NoDotAndDotDot);
    for (const QFileInfo& task : tasks) {
        QFile file(task.filePath() + QStringLiteral("/status"));
        if (!file.open(QIODevice::ReadOnly)) {
            continue;
        }
        const QList<QByteArray> lines = file.readAll().split('\n');
        const auto value = [&](const QByteArray& name) {
            for (const QByteArray& line : lines) {
                if (line.startsWith(name)) {
                    return line.mid(name.size()).trimmed();
                }
            }
            return QByteArray();
        };
        if (value("Name:") == thread) {
            return value("Cpus_allowed_list:");
        }
    }
    return {};
}

}  // namespace

class TestTakeControl : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void sendingTheProgramWaitsForItsReply() {
        simulator::Simulator robot(robotOptions());
        QVERIFY(robot.start().ok());
        const Choosy choosy(robot.ports().primary);
        Controller controller(to(choosy.port(), robot.ports().rtde));
        const auto taken = controller.takeControl(soon());
        QVERIFY2(taken.ok(), qPrintable(taken.ok() ? QString() : taken.error().toString()));
    }

    // A single deprecated function that a controller does not have would make the whole program fail.
    void unsupportedFunctionsAreLeftOutOfTheProgram() {
        simulator::SimulatorOptions options = robotOptions();
        for (const char* name : {"teach_mode", "servoc", "is_within_safety_limits", "set_payload_mass",
                                 "enable_external_ft_sensor"}) {
            QVERIFY(simulator::assume(options.assumptions, QString::fromLatin1(name) + "=missing").ok());
        }
        simulator::Simulator robot(options);
        QVERIFY(robot.start().ok());
        Controller controller(to(robot));
        const auto taken = controller.takeControl(soon());
        QVERIFY2(taken.ok(), qPrintable(taken.ok() ? QString() : taken.error().toString()));
        const auto is = [](const auto& result, const char* name) {
            return result.error().code == ErrorCode::VersionUnsupported &&
                   result.error().controllerMessage.contains(QLatin1String(name));
        };
        QVERIFY(is(Compliance(controller).startTeachMode(), "teach_mode"));
        QVERIFY(is(Motions(controller).startServoC(), "servoc"));
        QVERIFY(is(ArmQueries(controller).isWithinSafetyLimits(Pose(), soon()), "is_within_safety_limits"));
        QVERIFY(is(ArmQueries(controller).isWithinSafetyLimits(JointPositions(), soon()),
                   "is_within_safety_limits"));
        QVERIFY(is(ToolSetup(controller).useExternalSensorLegacy({}, soon()), "enable_external_ft_sensor"));
        QVERIFY(ArmQueries(controller).stepTime(soon()).ok());
        QVERIFY(Compliance(controller).startFreedrive().ok());
        // A section uploads the program again. The uploaded program must not contain these functions from the
        // start.
        QVERIFY(Programs(controller)
                    .startFunction(QStringLiteral("wait"), QStringLiteral("sleep(0.01)"), soon())
                    .ok());
        controller.release();
    }

    void theControlThreadStaysOnItsCpus() {
#ifndef __linux__
        QSKIP("the CPU affinity of a thread can be read only on Linux");
#else
        const int cpu = ::sched_getcpu();
        QVERIFY(cpu >= 0);
        simulator::Simulator robot(robotOptions());
        QVERIFY(robot.start().ok());
        ControllerOptions options = to(robot);
        options.cpus = {cpu};
        {
            Controller controller(options);
            QVERIFY(controller.takeControl(soon()).ok());
            QVERIFY(controller.status().cpusGranted);
            QCOMPARE(cpusOf("control"), QByteArray::number(cpu));
        }
        // An invalid CPU must not prevent control, but must be reported.
        options.cpus = {1000};
        Controller controller(options);
        QVERIFY(controller.takeControl(soon()).ok());
        QVERIFY(!controller.status().cpusGranted);
#endif
    }

    void controlOfARunningRobotIsTakenInRealTime() {
        simulator::Simulator robot(robotOptions());
        QVERIFY(robot.start().ok());
        Controller controller(to(robot));
        QCOMPARE(controller.status().loss, ControlLoss::NotTaken);
        const auto taken = controller.takeControl(soon());
        QVERIFY2(taken.ok(), qPrintable(taken.error().toString()));
        // If the computer is blocked for 100 ms, control is lost again, so try several times.
        QTRY_VERIFY_WITH_TIMEOUT(controller.takeControl(soon()).ok() && controller.status().roundTripMs > 0 &&
                                     controller.status().inControl,
                                 60'000);
        const bool sameVersion = controller.version() == robot.options().software;
        QVERIFY(sameVersion);
        controller.release();
        // If release() could not end the program, the program ends after 5 s without a heartbeat.
        QTRY_COMPARE_WITH_TIMEOUT(robot.truth().runtimeState, RuntimeState::Stopped, 20'000);
    }

    // A controller may send no data while it compiles. This is accepted for the duration of compiling, but at
    // most for 2 s.
    void aSlowCompilationIsNotALostConnection_data() {
        QTest::addColumn<int>("quietMs");
        QTest::addColumn<bool>("survives");
        QTest::newRow("above the usual timeout") << 460 << true;
        QTest::newRow("at the limit") << 2000 << true;
        QTest::newRow("above the limit") << 2010 << false;
    }
    void aSlowCompilationIsNotALostConnection() {
        QFETCH(int, quietMs);
        QFETCH(bool, survives);
        simulator::Simulator robot(robotOptions());
        QVERIFY(robot.start().ok());
        // Time advances for the controller only when this test advances it.
        VirtualClock time;
        const AskedClock clock(time);
        ControllerOptions options = to(robot);
        options.clock = &clock;
        const Controller* taking = nullptr;
        bool quiet = false;
        const auto waitFor = [](const auto& condition) {
            const QDeadlineTimer hangs(std::chrono::minutes(1));
            while (!condition() && !hangs.hasExpired()) {
                QThread::msleep(1);
            }
        };
        options.deliver = [&](const QString& program, const Deadline& deadline) -> Result<void> {
            if (quiet) {
                robot.silence(true);
                // Wait until the earlier data have been read. The control thread reads the clock in every
                // poll.
                const std::uint64_t asked = clock.asked();
                waitFor([&] { return clock.asked() > asked + 20; });
                time.advanceNs(quietMs * kNsPerMs);
                if (survives) {
                    // The control thread polls every 4 ms and gives up after ten polls.
                    QThread::msleep(150);
                } else {
                    waitFor([&] { return !taking->isConnected(); });
                }
                robot.silence(false);
            }
            script::ScriptClient client(QStringLiteral("127.0.0.1"), robot.ports().primary);
            auto sent = client.connect(deadline);
            return sent ? client.send(program, deadline) : sent;
        };
        for (const bool path : {false, true}) {
            Controller controller(options);
            taking = &controller;
            quiet = !path;
            auto result = controller.takeControl(soon());
            if (path) {
                QVERIFY2(result.ok(), qPrintable(result.error().toString()));
                quiet = true;
                const PathEntry entry{PathEntry::Kind::MoveJ, robot.truth().q, {}, 0.5, 1.4, 0};
                const auto motion = Motions(controller).movePath({entry}, soon());
                result = motion ? Result<void>() : Result<void>(motion.error());
            }
            QVERIFY2(result.ok() == survives,
                     qPrintable(path ? "path: " + result.error().toString() : result.error().toString()));
            if (!survives) {
                QCOMPARE(result.error().code, ErrorCode::LinkLost);
            }
        }
    }

    void registersInUseAreExplainedAndTheOtherRangeWorks() {
        simulator::Simulator robot(robotOptions());
        QVERIFY(robot.start().ok());
        rtde::ConnectionOptions owner;
        owner.host = robot.listenAddress();
        owner.port = robot.ports().rtde;
        owner.request.inputs = {{{"input_int_register_25"}, true}};
        const auto owned = rtde::Connection::open(owner, soon());
        QVERIFY(owned.ok());

        Controller controller(to(robot));
        const Error error = controller.takeControl(soon()).error();
        QCOMPARE(error.code, ErrorCode::RegisterInUse);
        QVERIFY2(error.controllerMessage.contains(QStringLiteral("input_int_register_25")),
                 qPrintable(error.toString()));
        QVERIFY(error.controllerMessage.contains(QStringLiteral("lower (0-23)")));
        QVERIFY(!controller.status().inControl);

        ControllerOptions lower = to(robot);
        lower.registers = RegisterRange::Lower;
        Controller second(lower);
        const auto taken = second.takeControl(soon());
        QVERIFY2(taken.ok(), qPrintable(taken.error().toString()));
    }

    void twoControllersCannotHoldTheSameRegisters() {
        simulator::Simulator robot(robotOptions());
        QVERIFY(robot.start().ok());
        Controller first(to(robot));
        QVERIFY(first.takeControl(soon()).ok());
        Controller second(to(robot));
        QCOMPARE(second.takeControl(soon()).error().code, ErrorCode::RegisterInUse);
        QVERIFY(first.status().inControl);
        first.release();
        // Control is free again, and the same object may retry.
        const auto taken = second.takeControl(soon());
        QVERIFY2(taken.ok(), qPrintable(taken.error().toString()));
    }

    void softwareWithoutTheUpperRegistersIsExplained() {
        RtdePeerOptions options;
        options.version = {5, 2, 0, 0};
        for (int i = 24; i < 48; ++i) {
            for (const char* kind : {"input_int", "input_double", "output_int", "output_double"}) {
                options.missing.insert(std::string(kind) + "_register_" + std::to_string(i));
            }
        }
        RtdePeer peer(options);
        RawPeer primary([](RawPeer::Link& link) { link.beMute(); });
        Controller controller(to(primary.port(), peer.port()));
        const Error error = controller.takeControl(soon()).error();
        QCOMPARE(error.code, ErrorCode::FieldUnknown);
        QVERIFY2(error.controllerMessage.contains(QStringLiteral("lower (0-23)")),
                 qPrintable(error.toString()));
    }

    void controlOfAPoweredOffArmIsRefused() {
        simulator::SimulatorOptions options = robotOptions();
        options.poweredOn = false;
        simulator::Simulator robot(options);
        QVERIFY(robot.start().ok());
        Controller controller(to(robot));
        const Error error = controller.takeControl(soon()).error();
        QCOMPARE(error.code, ErrorCode::UnsafeState);
        QVERIFY(error.controllerMessage.contains(QStringLiteral("POWER_OFF")));
        QCOMPARE(robot.truth().runtimeState, RuntimeState::Stopped);
    }

    void localControlIsReported() {
        simulator::SimulatorOptions options = robotOptions();
        options.remoteControl = false;
        options.gateLocalControl = true;
        simulator::Simulator robot(options);
        QVERIFY(robot.start().ok());
        Controller controller(to(robot));
        const Error error = controller.takeControl(soon()).error();
        QVERIFY2(error.code == ErrorCode::RemoteControlRequired, qPrintable(error.toString()));
    }

    void refusedPortIsNamed() {
        RawPeer primary([](RawPeer::Link& link) { link.beMute(); });
        const int dead = RawPeer::deadPort();
        Controller noRtde(to(primary.port(), dead));
        const Error rtde = noRtde.takeControl(soon()).error();
        QCOMPARE(rtde.code, ErrorCode::ConnectionRefused);
        QVERIFY(rtde.context.contains(QString::number(dead)));

        RtdePeer peer;
        makeRunning(peer);
        Controller noPrimary(to(dead, peer.port()));
        const Error script = noPrimary.takeControl(soon()).error();
        QCOMPARE(script.code, ErrorCode::ConnectionRefused);
        QVERIFY(script.context.contains(QString::number(dead)));
    }

    void silentServersCauseATimeout() {
        RawPeer mute([](RawPeer::Link& link) { link.beMute(); });
        Controller muteRtde(to(mute.port(), mute.port()));
        QCOMPARE(muteRtde.takeControl(Deadline::after(milliseconds(200))).error().code, ErrorCode::Timeout);

        RtdePeer peer;
        makeRunning(peer);
        Controller mutePrimary(to(mute.port(), peer.port()));
        QCOMPARE(mutePrimary.takeControl(Deadline::after(milliseconds(500))).error().code,
                 ErrorCode::Timeout);
    }

    void compileErrorIsReportedWithItsPosition() {
        RtdePeer peer;
        makeRunning(peer);
        RawPeer primary([](RawPeer::Link& link) {
            link.send(versionMessage() + robotState(robotModeData(7, false)));
            while (!link.isOver()) {
                link.send(
                    message(10, Wire().i32(12).i32(5).text("compile_error_name_not_found:speedl:").bytes()));
                std::this_thread::sleep_for(milliseconds(5));
            }
        });
        Controller controller(to(primary.port(), peer.port()));
        const Error error = controller.takeControl(soon()).error();
        QCOMPARE(error.code, ErrorCode::ScriptError);
        QVERIFY2(error.controllerMessage.contains(QStringLiteral("compile_error_name_not_found:speedl:")),
                 qPrintable(error.toString()));
        QVERIFY(error.controllerMessage.contains(QStringLiteral("line 13, column 5")));
    }

    void anUnresponsiveProgramTimesOutWithAHint() {
        RtdePeer peer;
        makeRunning(peer);
        RawPeer primary([](RawPeer::Link& link) {
            link.send(versionMessage() + robotState(robotModeData(7, false)));
            link.beMute();
        });
        ControllerOptions options = to(primary.port(), peer.port());
        options.connectionTimeout = milliseconds(0);  // the peer sends only one package
        Controller controller(options);
        // The deadline is long enough to reach the upload of the program.
        const Error error = controller.takeControl(Deadline::after(std::chrono::seconds(5))).error();
        QCOMPARE(error.code, ErrorCode::Timeout);
        QVERIFY(error.controllerMessage.contains(QStringLiteral("Remote control")));
    }

    void cancellingEndsTheAttemptAtOnce() {
        RawPeer mute([](RawPeer::Link& link) { link.beMute(); });
        Controller controller(to(mute.port(), mute.port()));
        const CancelToken token;
        std::thread impatient([&] {
            std::this_thread::sleep_for(milliseconds(20));
            token.cancel();
        });
        const auto result = controller.takeControl(Deadline::after(std::chrono::minutes(10), token));
        impatient.join();
        QCOMPARE(result.error().code, ErrorCode::Cancelled);
    }

    void aDisconnectByTheControllerIsALostLink() {
        simulator::Simulator robot(robotOptions());
        QVERIFY(robot.start().ok());
        Controller controller(to(robot));
        QVERIFY(controller.takeControl(soon()).ok());
        // Starting a jog is refused while the data are outdated, e.g. because a thread is late.
        Result<Jog> jog = Error{};
        QTRY_VERIFY_WITH_TIMEOUT(jog.ok() || (jog = Motions(controller).startJog(JogTarget{})).ok(), 20'000);
        robot.closeClients();
        QTRY_VERIFY_WITH_TIMEOUT(!controller.status().inControl, 60'000);
        QCOMPARE(controller.status().loss, ControlLoss::LinkLost);
        QCOMPARE(jog->state().phase, MotionPhase::Ended);
        QCOMPARE(Motions(controller).startJog(JogTarget{}).error().code, ErrorCode::NotInControl);
        const auto again = controller.takeControl(soon());
        QVERIFY2(again.ok(), qPrintable(again.error().toString()));
    }

    void withoutControlMotionsCanOnlyBeStopped() {
        Controller controller(to(1, 1));
        QCOMPARE(Motions(controller).startJog(JogTarget{}).error().code, ErrorCode::NotInControl);
        QCOMPARE(Motions(controller).moveJ(JointPositions{}, {0.5, 1}).error().code, ErrorCode::NotInControl);
        controller.stop(StopCause::Escape);
        QVERIFY(!controller.end(1, StopCause::Escape));
        controller.release();
    }
};

QTEST_GUILESS_MAIN(TestTakeControl)
#include "tst_take_control.moc"
