// SPDX-License-Identifier: MIT
#include <QTest>
#include <initializer_list>
#include <map>
#include <utility>

#include "robot/dashboard/detail/dashboard_commands.h"
#include "tests/support/raw_peer.h"

using namespace tiller;
using namespace tiller::dashboard;
using test::RawPeer;

namespace {

Deadline soon() {
    return Deadline::after(std::chrono::seconds(20));
}

RawPeer::Script answering(std::map<QByteArray, QByteArray> replies) {
    return [replies = std::move(replies)](RawPeer::Link& link) {
        link.send("Connected: Universal Robots Dashboard Server\n");
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

struct Bench {
    explicit Bench(std::initializer_list<std::pair<const QByteArray, QByteArray>> replies)
        : peer(answering(replies)), client(QStringLiteral("127.0.0.1"), peer.port()) {
        if (!client.connect(soon())) {
            qFatal("no connection");
        }
    }
    RawPeer peer;
    DashboardClient client;
};

}  // namespace

class TestDashboardCommands : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void programsAndInstallationAreParsed() {
        Bench b({{"running", "Program running: true"},
                 {"get loaded program", "Loaded program: /programs/a b.urp"},
                 {"isProgramSaved", "false a b.urp"},
                 {"load installation x.installation", "Loading installation: x.installation"},
                 {"load installation y.installation", "File not found: y.installation"}});
        QCOMPARE(isRunning(b.client, soon()).value(), true);
        QCOMPARE(loadedProgram(b.client, soon()).value(), QStringLiteral("/programs/a b.urp"));
        const SavedState saved = isProgramSaved(b.client, soon()).value();
        QVERIFY(!saved.saved);
        QCOMPARE(saved.program, QStringLiteral("a b.urp"));
        QVERIFY(loadInstallation(b.client, QStringLiteral("x.installation"), soon()).ok());
        QCOMPARE(loadInstallation(b.client, QStringLiteral("y.installation"), soon()).error().code,
                 ErrorCode::Rejected);
    }

    void anEmptyProgramNameIsNotAnError() {
        Bench b({{"running", "Robot running: False"}, {"get loaded program", "No program loaded"}});
        QCOMPARE(isRunning(b.client, soon()).value(), false);
        QVERIFY(loadedProgram(b.client, soon()).value().isEmpty());
    }

    void safetyStatusReportsTheCause() {
        Bench b({{"safetystatus", "Safetystatus: AUTOMATIC_MODE_SAFEGUARD_STOP"}});
        QCOMPARE(safetyStatus(b.client, soon()).value(), SafetyMode::AutomaticModeSafeguardStop);
    }

    void rolesModesAndIdentityAreParsed() {
        Bench b({{"setUserRole operator", "Setting user role: operator"},
                 {"getUserRole", "LOCKED"},
                 {"version", "5.12.0.1101319"},
                 {"set operational mode automatic", "Operational mode AUTOMATIC is set"},
                 {"set operational mode manual", "Setting operational mode: manual"},
                 {"get operational mode", "NONE"},
                 {"clear operational mode", "No longer controlling the operational mode. Current: NONE"}});
        QVERIFY(setUserRole(b.client, UserRole::Operator, soon()).ok());
        QCOMPARE(userRole(b.client, soon()).value(), UserRole::Locked);
        QCOMPARE(version(b.client, soon()).value(), QStringLiteral("5.12.0.1101319"));
        QVERIFY(setOperationalMode(b.client, OperationalMode::Automatic, soon()).ok());
        QVERIFY(setOperationalMode(b.client, OperationalMode::Manual, soon()).ok());
        QCOMPARE(operationalMode(b.client, soon()).value(), OperationalMode::None);
        QVERIFY(clearOperationalMode(b.client, soon()).ok());
    }

    void theOlderWordingOfClearIsAccepted() {
        Bench b({{"clear operational mode", "operational mode is no longer controlled by Dashboard Server"}});
        QVERIFY(clearOperationalMode(b.client, soon()).ok());
    }

    void reportsAndLogsAreRequested() {
        Bench b({{"saveLog", "Log saved to disk"},
                 {"generate flight report system", "Flight Report generated with id:42"},
                 {"generate support file .", "Completed successfully:ur_1.zip"},
                 {"generate support file x", "Error: no such directory"}});
        QVERIFY(saveLog(b.client, soon()).ok());
        QCOMPARE(generateFlightReport(b.client, FlightReport::System, soon()).value(), QStringLiteral("42"));
        QCOMPARE(generateSupportFile(b.client, QStringLiteral("."), soon()).value(),
                 QStringLiteral("ur_1.zip"));
        const Error error = generateSupportFile(b.client, QStringLiteral("x"), soon()).error();
        QCOMPARE(error.code, ErrorCode::Rejected);
        QVERIFY(error.controllerMessage.contains(QStringLiteral("no such directory")));
    }

    void theLastCommandsCloseTheConnection() {
        Bench b({{"quit", "Disconnected"}});
        QVERIFY(quit(b.client, soon()).ok());
        QVERIFY(!b.client.isConnected());
        Bench c({{"shutdown", "Shutting down"}});
        QVERIFY(shutdown(c.client, soon()).ok());
        QVERIFY(!c.client.isConnected());
        QCOMPARE(isRunning(c.client, soon()).error().code, ErrorCode::NotConnected);
    }

    void anUnexpectedReplyIsRejected() {
        Bench b({});
        QCOMPARE(isRunning(b.client, soon()).error().code, ErrorCode::Rejected);
        QCOMPARE(version(b.client, soon()).error().code, ErrorCode::Rejected);
        QCOMPARE(userRole(b.client, soon()).error().code, ErrorCode::Rejected);
        QCOMPARE(safetyStatus(b.client, soon()).error().code, ErrorCode::Rejected);
        QCOMPARE(isProgramSaved(b.client, soon()).error().code, ErrorCode::Rejected);
        QCOMPARE(loadedProgram(b.client, soon()).error().code, ErrorCode::Rejected);
        QCOMPARE(setOperationalMode(b.client, OperationalMode::Manual, soon()).error().code,
                 ErrorCode::Rejected);
    }
};

QTEST_GUILESS_MAIN(TestDashboardCommands)
#include "tst_dashboard_commands.moc"
