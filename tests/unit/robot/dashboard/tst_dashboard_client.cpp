// SPDX-License-Identifier: MIT
#include <QTest>
#include <map>

#include "robot/dashboard/dashboard_client.h"
#include "tests/support/raw_peer.h"

using namespace tiller;
using namespace tiller::dashboard;
using std::chrono::milliseconds;
using test::RawPeer;

namespace {

const QByteArray kGreeting = "Connected: Universal Robots Dashboard Server\n";

// Answers the commands in the table. Other commands are answered as unknown, as on a controller.
RawPeer::Script answering(std::map<QByteArray, QByteArray> replies) {
    return [replies = std::move(replies)](RawPeer::Link& link) {
        link.send(kGreeting);
        while (!link.isOver()) {
            const QByteArray line = link.readLine();
            if (line.isNull()) {
                return;
            }
            const auto found = replies.find(line);
            link.send((found == replies.end() ? "could not understand: '" + line + "'" : found->second) +
                      "\n");
        }
    };
}

Deadline soon() {
    return Deadline::after(milliseconds(20000));
}

Deadline brief() {
    return Deadline::after(milliseconds(50));
}

}  // namespace

class TestDashboardClient : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void documentedRepliesAreSuccess() {
        RawPeer peer(answering({{"power on", "Powering on"},
                                {"power off", "Powering off"},
                                {"brake release", "Brake releasing"},
                                {"unlock protective stop", "Protective stop releasing"},
                                {"close safety popup", "closing safety popup"},
                                {"restart safety", "Restarting safety"},
                                {"play", "Starting program"},
                                {"pause", "Pausing program"},
                                {"stop", "Stopped"},
                                {"load a/b.urp", "Loading program: a/b.urp"},
                                {"popup hello", "showing popup"},
                                {"close popup", "closing popup"},
                                {"addToLog hello", "Added log message"}}));
        DashboardClient client(QStringLiteral("127.0.0.1"), peer.port());
        QVERIFY(client.connect(soon()).ok());
        QVERIFY(client.powerOn(soon()).ok());
        QVERIFY(client.powerOff(soon()).ok());
        QVERIFY(client.brakeRelease(soon()).ok());
        QVERIFY(client.unlockProtectiveStop(soon()).ok());
        QVERIFY(client.closeSafetyPopup(soon()).ok());
        QVERIFY(client.restartSafety(soon()).ok());
        QVERIFY(client.play(soon()).ok());
        QVERIFY(client.pause(soon()).ok());
        QVERIFY(client.stop(soon()).ok());
        QVERIFY(client.loadProgram(QStringLiteral("a/b.urp"), soon()).ok());
        QVERIFY(client.popup(QStringLiteral("hello"), soon()).ok());
        QVERIFY(client.closePopup(soon()).ok());
        QVERIFY(client.addToLog(QStringLiteral("hello"), soon()).ok());
    }

    void valuesAreRead() {
        RawPeer peer(answering({{"robotmode", "Robotmode: POWER_OFF"},
                                {"safetymode", "Safetymode: PROTECTIVE_STOP"},
                                {"is in remote control", "true"},
                                {"PolyscopeVersion", "URSoftware 5.12.0.1101319 (Mar 22 2022)"},
                                {"get serial number", "20175599999"},
                                {"get robot model", "UR5"},
                                {"programState", "PLAYING wait program.urp"}}));
        DashboardClient client(QStringLiteral("127.0.0.1"), peer.port());
        QVERIFY(client.connect(soon()).ok());
        QCOMPARE(client.robotMode(soon()).value(), RobotMode::PowerOff);
        QCOMPARE(client.safetyMode(soon()).value(), SafetyMode::ProtectiveStop);
        QCOMPARE(client.isInRemoteControl(soon()).value(), true);
        const bool sameVersion =
            client.polyscopeVersion(soon()).value() == SoftwareVersion{5, 12, 0, 1101319};
        QVERIFY(sameVersion);
        QCOMPARE(client.serialNumber(soon()).value(), QStringLiteral("20175599999"));
        QCOMPARE(client.robotModel(soon()).value(), QStringLiteral("UR5"));
        const ProgramState state = client.programState(soon()).value();
        QCOMPARE(state.run, ProgramState::Run::Playing);
        QCOMPARE(state.program, QStringLiteral("wait program.urp"));
    }

    void aStoppedProgramNeedsNoName() {
        RawPeer peer(answering({{"programState", "STOPPED"}}));
        DashboardClient client(QStringLiteral("127.0.0.1"), peer.port());
        QVERIFY(client.connect(soon()).ok());
        const ProgramState state = client.programState(soon()).value();
        QCOMPARE(state.run, ProgramState::Run::Stopped);
        QVERIFY(state.program.isEmpty());
    }

    void anUnexpectedReplyIsARejectionWithTheReply() {
        const QByteArray reply =
            "Cannot unlock protective stop until 5s after occurrence. Always inspect cause of protective "
            "stop "
            "before unlocking";
        RawPeer peer(answering({{"unlock protective stop", reply}, {"robotmode", "Robotmode: DANCING"}}));
        DashboardClient client(QStringLiteral("127.0.0.1"), peer.port());
        QVERIFY(client.connect(soon()).ok());
        const Error error = client.unlockProtectiveStop(soon()).error();
        QCOMPARE(error.code, ErrorCode::Rejected);
        QCOMPARE(error.controllerMessage, QString::fromLatin1(reply));
        QVERIFY(error.context.contains(QStringLiteral("unlock protective stop")));
        QVERIFY(error.context.contains(QStringLiteral("127.0.0.1:%1").arg(peer.port())));
        QCOMPARE(client.robotMode(soon()).error().code, ErrorCode::Rejected);
        QCOMPARE(client.serialNumber(soon()).error().code, ErrorCode::Rejected);
        QVERIFY(client.isConnected());
    }

    void localControlIsReported() {
        RawPeer peer(
            answering({{"power on",
                        "Command is not allowed due to safety reasons, please switch robot to Remote "
                        "Control mode and reconnect to port 29999"}}));
        DashboardClient client(QStringLiteral("127.0.0.1"), peer.port());
        QVERIFY(client.connect(soon()).ok());
        const Error error = client.powerOn(soon()).error();
        QCOMPARE(error.code, ErrorCode::RemoteControlRequired);
        QVERIFY(error.controllerMessage.startsWith(QStringLiteral("Command is not allowed")));
        QVERIFY(!client.isConnected());
    }

    void aSilentServerTimesOutAndIsNotWaitedForAgain() {
        RawPeer peer([](RawPeer::Link& link) {
            link.send(kGreeting);
            link.beMute();
        });
        DashboardClient client(QStringLiteral("127.0.0.1"), peer.port());
        QVERIFY(client.connect(soon()).ok());
        QCOMPARE(client.powerOn(brief()).error().code, ErrorCode::Timeout);
        QCOMPARE(client.powerOn(brief()).error().code, ErrorCode::NotConnected);
    }

    void connectingRequiresAGreeting() {
        RawPeer peer([](RawPeer::Link& link) { link.beMute(); });
        DashboardClient client(QStringLiteral("127.0.0.1"), peer.port());
        const Error error = client.connect(brief()).error();
        QCOMPARE(error.code, ErrorCode::Timeout);
        QVERIFY(error.context.contains(QStringLiteral("greeting")));
    }

    void aRefusedPortIsReported() {
        const int port = RawPeer::deadPort();
        DashboardClient client(QStringLiteral("127.0.0.1"), port);
        const Error error = client.connect(soon()).error();
        QCOMPARE(error.code, ErrorCode::ConnectionRefused);
        QVERIFY(error.context.contains(QString::number(port)));
    }

    void aDisconnectByTheServerIsReported() {
        RawPeer peer([](RawPeer::Link& link) {
            link.send(kGreeting);
            link.readLine();
            link.send("Power");  // half a reply
        });
        DashboardClient client(QStringLiteral("127.0.0.1"), peer.port());
        QVERIFY(client.connect(soon()).ok());
        QCOMPARE(client.powerOn(soon()).error().code, ErrorCode::ConnectionClosed);
        QVERIFY(!client.isConnected());
    }

    void aCancelledWaitEndsAtOnce() {
        RawPeer peer([](RawPeer::Link& link) {
            link.send(kGreeting);
            link.beMute();
        });
        DashboardClient client(QStringLiteral("127.0.0.1"), peer.port());
        QVERIFY(client.connect(soon()).ok());
        const CancelToken token;
        token.cancel();
        QCOMPARE(client.powerOn(Deadline::after(milliseconds(60000), token)).error().code,
                 ErrorCode::Cancelled);
    }

    void anUnterminatedReplyIsBounded() {
        RawPeer peer([](RawPeer::Link& link) {
            link.send(kGreeting);
            link.readLine();
            link.send(QByteArray(200'000, 'x'));
            link.beMute();
        });
        DashboardClient client(QStringLiteral("127.0.0.1"), peer.port());
        QVERIFY(client.connect(soon()).ok());
        QCOMPARE(client.powerOn(soon()).error().code, ErrorCode::ProtocolError);
    }

    void aLineBreakCannotInjectASecondCommand() {
        RawPeer peer(answering({}));
        DashboardClient client(QStringLiteral("127.0.0.1"), peer.port());
        QVERIFY(client.connect(soon()).ok());
        QCOMPARE(client.popup(QStringLiteral("x\npower off"), soon()).error().code,
                 ErrorCode::InvalidArgument);
    }
};

QTEST_GUILESS_MAIN(TestDashboardClient)
#include "tst_dashboard_client.moc"
