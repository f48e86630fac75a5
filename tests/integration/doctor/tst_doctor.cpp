// SPDX-License-Identifier: MIT
//
// A healthy simulated robot, and the same robot with one fault at a time. Every fault must have a distinct
// cause and no other findings. `tiller-cli doctor` must report the same findings.

#include <QJsonArray>
#include <QJsonDocument>
#include <QProcess>
#include <QSet>
#include <QTcpServer>
#include <QTcpSocket>
#include <QTest>
#include <array>
#include <memory>
#ifndef _WIN32
#include <arpa/inet.h>
#include <sys/socket.h>
#include <unistd.h>
#endif

#include "robot/doctor/examination.h"
#include "robot/rtde/connection.h"
#include "robot/simulator/simulator.h"
#include "tests/support/raw_peer.h"
#include "tests/support/rtde_peer.h"

using namespace tiller;
using namespace tiller::doctor;
using namespace std::chrono_literals;

namespace {

/// A loopback port without a listener.
int closedPort() {
    QTcpServer server;
    server.listen(QHostAddress::LocalHost);
    return server.serverPort();
}

QSet<QString> causesOf(const Report& report) {
    QSet<QString> causes;
    for (const Finding& finding : report) {
        if (!finding.cause.isEmpty()) {
            causes.insert(finding.cause);
        }
    }
    return causes;
}

const Finding& findingOf(const Report& report, const QString& cause) {
    for (const Finding& finding : report) {
        if (finding.cause == cause) {
            return finding;
        }
    }
    return report.front();
}

#ifndef _WIN32
/// A port with a full connection queue. A connection attempt neither succeeds nor fails.
class BlackHole {
public:
    BlackHole() {
        listener_ = ::socket(AF_INET, SOCK_STREAM, 0);
        sockaddr_in at{};
        at.sin_family = AF_INET;
        at.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
        ::bind(listener_, reinterpret_cast<sockaddr*>(&at), sizeof at);
        ::listen(listener_, 0);
        socklen_t size = sizeof at;
        ::getsockname(listener_, reinterpret_cast<sockaddr*>(&at), &size);
        port_ = ntohs(at.sin_port);
        for (auto& plug : plugs_) {
            plug = ::socket(AF_INET, SOCK_STREAM | SOCK_NONBLOCK, 0);
            static_cast<void>(::connect(plug, reinterpret_cast<sockaddr*>(&at), sizeof at));
        }
    }
    ~BlackHole() {
        for (const int plug : plugs_) {
            ::close(plug);
        }
        ::close(listener_);
    }
    BlackHole(const BlackHole&) = delete;
    BlackHole& operator=(const BlackHole&) = delete;
    int port() const { return port_; }

private:
    int listener_ = -1;
    int port_ = 0;
    std::array<int, 4> plugs_{};
};
#endif

}  // namespace

class TestDoctor : public QObject {
    Q_OBJECT

private:
    std::unique_ptr<simulator::Simulator> robot_;
    Patient patient_;
    QSet<QString> usual_;  ///< findings on a healthy robot: missing privileges on this PC, no payload

    static simulator::SimulatorOptions options() {
        simulator::SimulatorOptions options;
        options.anyFreePorts = true;
        options.poweredOn = true;
        options.fastTransitions = true;
        return options;
    }
    void begin(const simulator::SimulatorOptions& wanted) {
        robot_ = std::make_unique<simulator::Simulator>(wanted);
        QVERIFY(robot_->start().ok());
        const simulator::Ports ports = robot_->ports();
        patient_.host = QStringLiteral("127.0.0.1");
        patient_.ports = {ports.rtde,     ports.primary,   ports.secondary,
                          ports.realtime, ports.dashboard, closedPort()};
    }
    /// Expects exactly these findings in addition to those of a healthy robot.
    void expectOnly(const QString& cause, Verdict verdict = Verdict::Bad) {
        const Report report = examine(patient_, Deadline::after(30s));
        QCOMPARE(report.size(), std::size_t(kConditionCount));
        QSet<QString> found = causesOf(report) - usual_;
        QVERIFY2(found == QSet<QString>{cause}, qPrintable(QStringLiteral("%1\n%2").arg(
                                                    QStringList(found.values()).join(", "), toText(report))));
        const Finding& finding = findingOf(report, cause);
        QCOMPARE(finding.verdict, verdict);
        QVERIFY(!finding.detail.isEmpty());
        QVERIFY(!finding.fix.isEmpty());
        seen_.insert(cause);
    }
    static inline QSet<QString> seen_;

private Q_SLOTS:
    void init() {
        begin(options());
        if (usual_.isEmpty()) {
            usual_ = {"privilege.none", "latency.none", "payload.unset"};
        }
    }
    void cleanup() { robot_.reset(); }

    void aHealthyRobotPassesAllChecks() {
        QStringList order;
        const Report report = examine(patient_, Deadline::after(30s),
                                      [&order](const Finding& f) { order << conditionId(f.condition); });
        QVERIFY2(causesOf(report).subtract(usual_).isEmpty(), qPrintable(toText(report)));
        QVERIFY(overall(report) != Verdict::Bad);
        QCOMPARE(order.size(), kConditionCount);
        QVERIFY(toText(report).contains("UR5e"));
        QCOMPARE(toJson(report)["findings"].toArray().size(), kConditionCount);
        for (const Finding& finding : report) {
            QVERIFY2(finding.verdict != Verdict::Skipped, qPrintable(conditionId(finding.condition)));
        }
    }

    void anUnknownNameIsReported() {
        patient_.host = QStringLiteral("no-such-robot.invalid");
        expectOnly("address.unresolved");
    }
    void aHostWithoutRobotServicesIsReported() {
        patient_.ports = {closedPort(), closedPort(), closedPort(), closedPort(), closedPort(), closedPort()};
        expectOnly("host.no-robot");
    }
#ifndef _WIN32
    void aSilentHostIsReported() {
        BlackHole holes[5];
        patient_.ports = {holes[0].port(), holes[1].port(), holes[2].port(),
                          holes[3].port(), holes[4].port(), 80};
        expectOnly("host.silent");
    }
    void aFirewallOnOnePortIsReported() {
        const BlackHole hole;
        patient_.ports.primary = hole.port();
        expectOnly("port.primary.silent");
    }
#endif
    void theRtdePortIsClosed() {
        patient_.ports.rtde = closedPort();
        expectOnly("port.rtde.refused");
    }
    void thePrimaryPortIsClosed() {
        patient_.ports.primary = closedPort();
        expectOnly("port.primary.refused");
    }
    void theDashboardIsOff() {
        patient_.ports.dashboard = closedPort();
        expectOnly("port.service.refused");
    }
    void theDashboardDoesNotReply() {
        test::RawPeer mute([](test::RawPeer::Link& link) { link.readAll(); });
        patient_.ports.dashboard = mute.port();
        expectOnly("service.mute");
    }
    void somethingElseAnswersOnTheDashboardPort() {
        test::RawPeer other([](test::RawPeer::Link& link) {
            link.send("220 mail.example\r\n");
            while (!link.isOver()) {
                link.readLine();
                link.send("500 what?\r\n");
            }
        });
        patient_.ports.dashboard = other.port();
        expectOnly("service.not-dashboard");
    }
    void theRtdePortDoesNotReply() {
        test::RawPeer mute([](test::RawPeer::Link& link) { link.readAll(); });
        patient_.ports.rtde = mute.port();
        expectOnly("rtde.mute");
    }
    void somethingElseAnswersOnTheRtdePort() {
        test::RawPeer other([](test::RawPeer::Link& link) {
            link.send("HTTP/1.1 400 Bad Request\r\nContent-Length: 0\r\n\r\n");
            link.readAll();
        });
        patient_.ports.rtde = other.port();
        expectOnly("rtde.not-rtde");
    }
    void theRobotIsInLocalControl() {
        QVERIFY(robot_->inject("remote off").ok());
        expectOnly("control.local");
    }
    void theRobotIsInAProtectiveStop() {
        robot_->protectiveStop();
        QTRY_COMPARE_WITH_TIMEOUT(robot_->truth().safetyMode, SafetyMode::ProtectiveStop, 60'000);
        expectOnly("safety.stopped");
    }
    void theArmIsOff() {
        simulator::SimulatorOptions off = options();
        off.poweredOn = false;
        begin(off);
        expectOnly("power.not-running", Verdict::Attention);
    }
    void anotherProgramHoldsTheUpperRegisters() {
        rtde::ConnectionOptions other;
        other.host = patient_.host;
        other.port = static_cast<std::uint16_t>(patient_.ports.rtde);
        other.request.inputs = {{{"input_double_register_41"}, true}};
        const auto held = rtde::Connection::open(other, Deadline::after(10s));
        QVERIFY(held.ok());
        expectOnly("registers.upper.taken");
    }
    void aFieldbusHoldsTheLowerRegisters() {
        rtde::ConnectionOptions other;
        other.host = patient_.host;
        other.port = static_cast<std::uint16_t>(patient_.ports.rtde);
        other.request.inputs = {{{"input_int_register_0", "input_double_register_3"}, true}};
        const auto held = rtde::Connection::open(other, Deadline::after(10s));
        QVERIFY(held.ok());
        expectOnly("registers.lower.taken", Verdict::Attention);
    }
    void packagesAreMissing() {
        test::RtdePeer slow;
        slow.set("safety_mode", {1});
        slow.set("robot_mode", {7});
        patient_.ports.rtde = slow.port();
        for (int i = 0; i < 100; ++i) {
            slow.send(10 + i * 0.016);
        }
        expectOnly("rate.low");
    }
    void missingDataAreReported() {
        test::RtdePeer still;
        patient_.ports.rtde = still.port();
        expectOnly("rate.none");
    }
    void theSoftwareIsTooOld() {
        test::RtdePeerOptions old;
        old.version = {3, 3, 4, 0};
        old.highestProtocol = 1;
        test::RtdePeer peer(old);
        peer.set("safety_mode", {1});
        peer.set("robot_mode", {7});
        patient_.ports.rtde = peer.port();
        for (int i = 0; i < 100; ++i) {
            peer.send(10 + i * 0.008);
        }
        expectOnly("software.unsupported");
    }

    void atLeastTwelveCausesAreDistinguished() {
        QVERIFY2(seen_.size() >= 12, qPrintable(QString::number(seen_.size())));
    }

    void cancellingTheCheckGivesACompleteReport() {
        const CancelToken token;
        token.cancel();
        const Report report = examine(patient_, Deadline::after(30s, token));
        QCOMPARE(report.size(), std::size_t(kConditionCount));
    }

    void commandLineReportsTheSame() {
        if (QByteArray(TILLER_CLI).isEmpty()) {
            QSKIP("built without the application");
        }
        simulator::SimulatorOptions here;
        here.listenAddress = QStringLiteral("127.77.%1.1").arg(QCoreApplication::applicationPid() % 250);
        here.poweredOn = true;
        here.fastTransitions = true;
        begin(here);
        const auto run = [&here](const QStringList& more) {
            QProcess process;
            process.start(QStringLiteral(TILLER_CLI), QStringList{"doctor", here.listenAddress} + more);
            process.waitForFinished(60'000);
            return std::pair{process.exitCode(), process.readAllStandardOutput()};
        };
        const auto [healthy, text] = run({});
        QVERIFY2(healthy == 0, text.constData());
        QVERIFY(text.contains("RTDE port"));
        QVERIFY(robot_->inject("remote off").ok());
        const auto [sick, json] = run({"--json"});
        QCOMPARE(sick, 1);
        const QJsonObject report = QJsonDocument::fromJson(json).object();
        QCOMPARE(report["verdict"].toString(), QStringLiteral("bad"));
        QStringList bad;
        for (const QJsonValue& finding : report["findings"].toArray()) {
            if (finding["verdict"].toString() == "bad") {
                bad << finding["cause"].toString();
            }
        }
        QCOMPARE(bad, QStringList{"control.local"});
    }
    void wrongArgumentsAreNamed() {
        if (QByteArray(TILLER_CLI).isEmpty()) {
            QSKIP("built without the application");
        }
        QProcess process;
        process.start(QStringLiteral(TILLER_CLI), {"doctor"});
        QVERIFY(process.waitForFinished(60'000));
        QCOMPARE(process.exitCode(), 2);
        QVERIFY(process.readAllStandardError().contains("address"));
    }
};

QTEST_GUILESS_MAIN(TestDoctor)
#include "tst_doctor.moc"
