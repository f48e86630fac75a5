// SPDX-License-Identifier: MIT
// PolyScope X over HTTP: brings a simulated robot to RUNNING, and handles peers with unexpected replies.
#include <QTest>
#include <vector>

#include "robot/dashboard/recovery.h"
#include "robot/simulator/simulator.h"
#include "tests/support/raw_peer.h"

using namespace tiller;
using namespace tiller::dashboard;
using test::RawPeer;

namespace {

Deadline testTimeout() {
    return Deadline::after(std::chrono::seconds(60));
}

simulator::SimulatorOptions polyScopeX() {
    simulator::SimulatorOptions options;
    options.software = {10, 12, 0, 0};
    options.anyFreePorts = true;
    options.fastTransitions = true;
    return options;
}

struct Robot {
    explicit Robot(const simulator::SimulatorOptions& options = polyScopeX()) : controller(options) {
        const auto started = controller.start();
        if (!started) {
            qFatal("%s", qPrintable(started.error().toString()));
        }
    }
    RobotApiClient client() const {
        return RobotApiClient(controller.listenAddress(), controller.ports().robotApi);
    }
    simulator::Simulator controller;
};

/// Sends these replies to the requests in order, and the last reply to all further requests.
class Web {
public:
    explicit Web(std::vector<QByteArray> replies)
        : replies_(std::move(replies)), peer_([this](RawPeer::Link& link) {
            requests_.push_back(link.readLine());
            while (link.readLine().size() > 1) {
            }
            link.send(replies_[std::min(requests_.size(), replies_.size()) - 1]);
        }) {}
    RobotApiClient client() const { return RobotApiClient(QStringLiteral("127.0.0.1"), peer_.port()); }
    const std::vector<QByteArray>& requests() const { return requests_; }

private:
    std::vector<QByteArray> replies_;
    std::vector<QByteArray> requests_;
    RawPeer peer_;
};

}  // namespace

class TestRobotApiClient : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void bringsAPoweredOffRobotToRunning() {
        Robot robot;
        auto client = robot.client();
        QCOMPARE(client.robotMode(testTimeout()).value(), RobotMode::PowerOff);
        QCOMPARE(client.safetyMode(testTimeout()).value(), SafetyMode::Normal);
        QVERIFY(client.isInRemoteControl(testTimeout()).value());
        QCOMPARE(client.programState(testTimeout()).value(), ProgramState::Run::Stopped);
        RecoveryConsent consent;
        QCOMPARE(recover(client, consent, testTimeout()).error().code, ErrorCode::Rejected);
        QCOMPARE(client.robotMode(testTimeout()).value(), RobotMode::PowerOff);
        consent.powerOn = true;
        consent.releaseBrakes = true;
        std::vector<RecoveryStep> steps;
        const auto done =
            recover(client, consent, testTimeout(), [&](RecoveryStep step) { steps.push_back(step); });
        QVERIFY2(done.ok(), qPrintable(done.error().toString()));
        QCOMPARE(robot.controller.truth().robotMode, RobotMode::Running);
        QVERIFY((steps == std::vector{RecoveryStep::Look, RecoveryStep::PowerOn, RecoveryStep::ReleaseBrakes,
                                      RecoveryStep::Done}));
        QVERIFY(client.powerOff(testTimeout()).ok());
        QTRY_COMPARE_WITH_TIMEOUT(client.robotMode(testTimeout()).value(), RobotMode::PowerOff, 60'000);
    }

    void unlocksOnlyOnceTheCauseWasInspected() {
        auto options = polyScopeX();
        options.poweredOn = true;
        Robot robot(options);
        robot.controller.protectiveStop();
        auto client = robot.client();
        QTRY_COMPARE_WITH_TIMEOUT(client.safetyMode(testTimeout()).value(), SafetyMode::ProtectiveStop,
                                  60'000);
        QCOMPARE(recover(client, {}, testTimeout()).error().code, ErrorCode::Rejected);
        RecoveryConsent consent;
        consent.causeInspected = true;
        const auto done = recover(client, consent, testTimeout());
        QVERIFY2(done.ok(), qPrintable(done.error().toString()));
        QCOMPARE(robot.controller.truth().safetyMode, SafetyMode::Normal);
    }

    void localControlIsReported() {
        auto options = polyScopeX();
        options.remoteControl = false;
        options.gateLocalControl = true;
        options.gateLoopbackClients = true;
        Robot robot(options);
        auto client = robot.client();
        QVERIFY(!client.isInRemoteControl(testTimeout()).value());
        const auto refused = client.powerOn(testTimeout());
        QCOMPARE(refused.error().code, ErrorCode::RemoteControlRequired);
        QVERIFY(refused.error().controllerMessage.contains(QStringLiteral("403")));
    }

    void redirectsAndChunkedRepliesAreParsed() {
        const Web web(
            {"HTTP/1.1 307 Temporary Redirect\r\nLocation: http://other/elsewhere/mode\r\n"
             "Content-Length: 0\r\n\r\n",
             "HTTP/1.1 200 OK\r\nTransfer-Encoding: chunked\r\n\r\n"
             "a\r\n{\"mode\": \"\r\n9\r\nRUNNING\"}\r\n0\r\n\r\n"});
        QCOMPARE(web.client().robotMode(testTimeout()).value(), RobotMode::Running);
        QVERIFY(
            web.requests()[0].startsWith("GET /universal-robots/robot-api/robotstate/v1/robotmode HTTP/1.1"));
        QVERIFY(web.requests()[1].startsWith("GET /elsewhere/mode HTTP/1.1"));
    }

    void otherRepliesAreErrors_data() {
        QTest::addColumn<QByteArray>("reply");
        QTest::addColumn<int>("code");
        QTest::newRow("not HTTP") << QByteArray("hello\n") << int(ErrorCode::ProtocolError);
        QTest::newRow("nothing") << QByteArray() << int(ErrorCode::ConnectionClosed);
        QTest::newRow("no mode") << QByteArray("HTTP/1.1 200 OK\r\nContent-Length: 2\r\n\r\n{}")
                                 << int(ErrorCode::ProtocolError);
        QTest::newRow("cut off") << QByteArray("HTTP/1.1 200 OK\r\nContent-Length: 99\r\n\r\n{}")
                                 << int(ErrorCode::ProtocolError);
        QTest::newRow("unknown mode")
            << QByteArray("HTTP/1.1 200 OK\r\nContent-Length: 15\r\n\r\n{\"mode\":\"ODD\"} ")
            << int(ErrorCode::ProtocolError);
        QTest::newRow("too old") << QByteArray("HTTP/1.1 404 Not Found\r\nContent-Length: 0\r\n\r\n")
                                 << int(ErrorCode::VersionUnsupported);
        QTest::newRow("not now")
            << QByteArray("HTTP/1.1 409 Conflict\r\nContent-Length: 17\r\n\r\n{\"message\":\"busy\"}")
            << int(ErrorCode::Rejected);
        QTest::newRow("in circles")
            << QByteArray("HTTP/1.1 302 Found\r\nLocation: /again\r\nContent-Length: 0\r\n\r\n")
            << int(ErrorCode::ProtocolError);
    }
    void otherRepliesAreErrors() {
        QFETCH(QByteArray, reply);
        QFETCH(int, code);
        const Web web({reply});
        const auto mode = web.client().robotMode(testTimeout());
        QVERIFY2(int(mode.error().code) == code, qPrintable(mode.error().toString()));
    }

    void silentPeerBlocksNoCaller() {
        RawPeer mute([](RawPeer::Link& link) { link.beMute(); });
        RobotApiClient client(QStringLiteral("127.0.0.1"), mute.port());
        QCOMPARE(client.powerOn(Deadline::after(std::chrono::milliseconds(40))).error().code,
                 ErrorCode::Timeout);
        const CancelToken token;
        token.cancel();
        QCOMPARE(client.powerOn(Deadline::never(token)).error().code, ErrorCode::Cancelled);
    }
};

QTEST_GUILESS_MAIN(TestRobotApiClient)
#include "tst_robot_api_client.moc"
