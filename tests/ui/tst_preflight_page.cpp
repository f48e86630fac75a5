// SPDX-License-Identifier: GPL-3.0-or-later
//
// The page before the first connection. Every fault of the connection to a robot has a separate line with its
// cause and a suggested action, and `tiller-cli doctor` reports the same findings.

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QLabel>
#include <QProcess>
#include <QPushButton>
#include <QSet>
#include <QSignalSpy>
#include <QTcpServer>
#include <QTest>
#include <memory>
#include <optional>

#include "robot/rtde/connection.h"
#include "robot/simulator/simulator.h"
#include "tests/support/raw_peer.h"
#include "widgets/common/theme.h"
#include "widgets/status/preflight_page.h"

using namespace tiller;
using namespace std::chrono_literals;

namespace {

/// A loopback port without a listener.
int closedPort() {
    QTcpServer server;
    server.listen(QHostAddress::LocalHost);
    return server.serverPort();
}

/// A robot with its connection and possible faults.
struct Cell {
    simulator::SimulatorOptions options;
    std::unique_ptr<simulator::Simulator> robot;
    std::unique_ptr<test::RawPeer> other;
    std::optional<Result<std::unique_ptr<rtde::Connection>>> rival;
    doctor::Patient patient;

    Cell() {
        options.anyFreePorts = true;
        options.poweredOn = true;
        options.fastTransitions = true;
    }
    bool begin() {
        robot = std::make_unique<simulator::Simulator>(options);
        if (!robot->start().ok()) {
            return false;
        }
        const simulator::Ports ports = robot->ports();
        patient.host = QStringLiteral("127.0.0.1");
        patient.ports = {ports.rtde,     ports.primary,   ports.secondary,
                         ports.realtime, ports.dashboard, closedPort()};
        return true;
    }
    int peer(test::RawPeer::Script script) {
        other = std::make_unique<test::RawPeer>(std::move(script));
        return other->port();
    }
    /// Connects another client that uses these inputs.
    void hold(const std::vector<std::string>& registers) {
        rtde::ConnectionOptions client;
        client.host = patient.host;
        client.port = static_cast<std::uint16_t>(patient.ports.rtde);
        client.request.inputs = {{registers, true}};
        rival.emplace(rtde::Connection::open(client, Deadline::after(10s)));
    }
};

struct Fault {
    const char* cause;
    std::function<void(Cell&)> inject;
};

const std::vector<Fault>& faults() {
    using Link = test::RawPeer::Link;
    static const std::vector<Fault> all = {
        {"address.unresolved", [](Cell& c) { c.patient.host = QStringLiteral("no-such-robot.invalid"); }},
        {"host.no-robot",
         [](Cell& c) {
             c.patient.ports = {closedPort(), closedPort(), closedPort(),
                                closedPort(), closedPort(), closedPort()};
         }},
        {"port.rtde.refused", [](Cell& c) { c.patient.ports.rtde = closedPort(); }},
        {"port.primary.refused", [](Cell& c) { c.patient.ports.primary = closedPort(); }},
        {"port.secondary.refused", [](Cell& c) { c.patient.ports.secondary = closedPort(); }},
        {"port.service.refused", [](Cell& c) { c.patient.ports.dashboard = closedPort(); }},
        {"service.mute",
         [](Cell& c) { c.patient.ports.dashboard = c.peer([](Link& link) { link.beMute(); }); }},
        {"rtde.mute", [](Cell& c) { c.patient.ports.rtde = c.peer([](Link& link) { link.beMute(); }); }},
        {"rtde.not-rtde",
         [](Cell& c) {
             c.patient.ports.rtde = c.peer([](Link& link) {
                 link.send("HTTP/1.1 400 Bad Request\r\nContent-Length: 0\r\n\r\n");
                 link.readAll();
             });
         }},
        {"control.local", [](Cell& c) { c.robot->setRemoteControl(false); }},
        {"safety.stopped",
         [](Cell& c) {
             c.robot->protectiveStop();
             QTRY_COMPARE_WITH_TIMEOUT(c.robot->truth().safetyMode, SafetyMode::ProtectiveStop, 60'000);
         }},
        {"power.not-running",
         [](Cell& c) {
             c.options.poweredOn = false;
             QVERIFY(c.begin());
         }},
        {"registers.upper.taken",
         [](Cell& c) {
             c.hold({"input_int_register_24", "input_double_register_24"});
         }},
        {"registers.lower.taken",
         [](Cell& c) {
             c.hold({"input_int_register_0", "input_double_register_3"});
         }},
    };
    return all;
}

/// Findings that are normal on this PC with a new simulated robot.
const QSet<QString> kUsual = {"privilege.none", "latency.none", "payload.unset"};

QSet<QString> causesOf(const doctor::Report& report) {
    QSet<QString> causes;
    for (const doctor::Finding& finding : report) {
        if (!finding.cause.isEmpty() && !kUsual.contains(finding.cause)) {
            causes.insert(finding.cause);
        }
    }
    return causes;
}

QString textOf(const QWidget& row) {
    QStringList text;
    for (const QLabel* label : row.findChildren<QLabel*>()) {
        if (!label->isHidden()) {
            text << label->text();
        }
    }
    return text.join(QLatin1Char('\n'));
}

}  // namespace

class TestPreflightPage : public QObject {
    Q_OBJECT

private:
    QSet<QString> seen_;

    static std::unique_ptr<PreflightPage> open(const doctor::Patient& patient) {
        auto page = std::make_unique<PreflightPage>(patient);
        page->setAttribute(Qt::WA_DeleteOnClose, false);
        page->show();
        return page;
    }
    static void keepPicture(QWidget& page, const QString& name) {
        const QString to = qEnvironmentVariable("TILLER_SCREENSHOTS");
        if (!to.isEmpty()) {
            QVERIFY(page.grab().save(to + QStringLiteral("/preflight-") + name + QStringLiteral(".png")));
        }
    }

private Q_SLOTS:
    void initTestCase() { applyTheme(*qApp, Theme::light()); }

    void aHealthyRobotIsReadyAndConnectsOnOneClick() {
        Cell cell;
        QVERIFY(cell.begin());
        const auto page = open(cell.patient);
        QTRY_VERIFY_WITH_TIMEOUT(page->isFinished(), 30'000);
        QVERIFY2(causesOf(page->report()).isEmpty(), qPrintable(doctor::toText(page->report())));
        QVERIFY(page->findChild<QLabel*>("safetyNote")->text().count('\n') + 1 == 5);
        QSignalSpy connects(page.get(), &PreflightPage::connectRequested);
        auto* key = page->findChild<QPushButton*>("preflightConnect");
        QCOMPARE(key->text(), QStringLiteral("Connect"));
        keepPicture(*page, "healthy");
        QTest::mouseClick(key, Qt::LeftButton);
        QCOMPARE(connects.size(), 1);
    }

    void everyFaultHasALineWithCauseAndFix_data() {
        QTest::addColumn<int>("index");
        for (std::size_t i = 0; i < faults().size(); ++i) {
            QTest::newRow(faults()[i].cause) << static_cast<int>(i);
        }
    }
    void everyFaultHasALineWithCauseAndFix() {
        QFETCH(int, index);
        const Fault& fault = faults()[static_cast<std::size_t>(index)];
        Cell cell;
        QVERIFY(cell.begin());
        fault.inject(cell);
        const auto page = open(cell.patient);
        QTRY_VERIFY_WITH_TIMEOUT(page->isFinished(), 60'000);
        const QString all = doctor::toText(page->report());
        QVERIFY2(causesOf(page->report()) == QSet<QString>{QLatin1String(fault.cause)}, qPrintable(all));
        // Only the line of this condition shows a problem and a suggested action.
        int bad = 0;
        for (const FindingRow* row : page->findChildren<FindingRow*>()) {
            const doctor::Finding& shown = row->finding();
            const doctor::Finding& found = page->report()[static_cast<std::size_t>(shown.condition)];
            QCOMPARE(shown.cause, found.cause);
            const QString text = textOf(*row);
            QVERIFY2(text.contains(doctor::conditionTitle(found.condition)), qPrintable(text));
            QVERIFY2(found.detail.isEmpty() || text.contains(found.detail), qPrintable(text));
            QVERIFY2(found.fix.isEmpty() || text.contains(found.fix), qPrintable(text));
            QVERIFY2(row->accessibleName().contains(found.detail), qPrintable(row->accessibleName()));
            if (shown.cause == QLatin1String(fault.cause)) {
                ++bad;
                QVERIFY(!found.fix.isEmpty());
            }
        }
        QCOMPARE(bad, 1);
        seen_.insert(QLatin1String(fault.cause));
        keepPicture(*page, QLatin1String(fault.cause));
    }
    void atLeastTwelveCausesAreDistinguished() { QVERIFY(seen_.size() >= 12); }

    void polyScopeXIsReachedThroughItsRobotApi() {
        Cell cell;
        cell.options.software = {10, 12, 0, 0};
        QVERIFY(cell.begin());
        cell.patient.ports.dashboard = closedPort();
        cell.patient.ports.robotApi = cell.robot->ports().robotApi;
        const auto page = open(cell.patient);
        QTRY_VERIFY_WITH_TIMEOUT(page->isFinished(), 30'000);
        QVERIFY2(causesOf(page->report()).isEmpty(), qPrintable(doctor::toText(page->report())));
        const auto line = [&page](doctor::Condition condition) {
            return textOf(*page->findChild<FindingRow*>("finding." + doctor::conditionId(condition)));
        };
        QVERIFY2(line(doctor::Condition::ServicePort).contains("Robot API 3.1.4"),
                 qPrintable(line(doctor::Condition::ServicePort)));
        QVERIFY2(line(doctor::Condition::ServicePort).contains("teach pendant"),
                 "the line does not name the functions that require the teach pendant");
        QVERIFY(line(doctor::Condition::RemoteControl).contains("Remote"));
        keepPicture(*page, "polyscope-x");

        QVERIFY(cell.robot->inject("remote off").ok());
        QTest::mouseClick(page->findChild<QPushButton*>("preflightAgain"), Qt::LeftButton);
        QTRY_VERIFY_WITH_TIMEOUT(page->isFinished(), 30'000);
        QCOMPARE(causesOf(page->report()), QSet<QString>{"control.local"});
    }

    void repeatedCheckFindsFixedProblems() {
        Cell cell;
        QVERIFY(cell.begin());
        QVERIFY(cell.robot->inject("remote off").ok());
        const auto page = open(cell.patient);
        QTRY_VERIFY_WITH_TIMEOUT(page->isFinished(), 30'000);
        QCOMPARE(causesOf(page->report()), QSet<QString>{"control.local"});
        QCOMPARE(page->findChild<QPushButton*>("preflightConnect")->text(), QStringLiteral("Connect anyway"));
        QVERIFY(cell.robot->inject("remote on").ok());
        QTest::mouseClick(page->findChild<QPushButton*>("preflightAgain"), Qt::LeftButton);
        QVERIFY(!page->isFinished());
        QTRY_VERIFY_WITH_TIMEOUT(page->isFinished(), 30'000);
        QVERIFY(causesOf(page->report()).isEmpty());
        QCOMPARE(page->findChild<QPushButton*>("preflightConnect")->text(), QStringLiteral("Connect"));
    }

    void checkAgainIsTheDefaultActionAfterAFailure() {
        Cell cell;
        QVERIFY(cell.begin());
        cell.robot->protectiveStop();
        QTRY_COMPARE_WITH_TIMEOUT(cell.robot->truth().safetyMode, SafetyMode::ProtectiveStop, 60'000);
        const auto page = open(cell.patient);
        QTRY_VERIFY_WITH_TIMEOUT(page->isFinished(), 30'000);
        auto* again = page->findChild<QPushButton*>("preflightAgain");
        auto* key = page->findChild<QPushButton*>("preflightConnect");
        QCOMPARE(doctor::overall(page->report()), doctor::Verdict::Bad);
        QVERIFY(again->property("primary").toBool() && again->isDefault());
        QVERIFY(!key->property("primary").toBool() && !key->isDefault());
        QVERIFY(page->findChild<QLabel*>("preflightConsequence")->isVisible());

        // Red and amber lines are above all good lines, and visible without scrolling.
        const auto outOfPlace = [&page]() -> QString {
            bool wellSeen = false;
            QList<FindingRow*> rows = page->findChildren<FindingRow*>();
            std::sort(rows.begin(), rows.end(), [](auto* a, auto* b) { return a->y() < b->y(); });
            for (const FindingRow* row : std::as_const(rows)) {
                const bool well = row->finding().verdict == doctor::Verdict::Good ||
                                  row->finding().verdict == doctor::Verdict::Skipped;
                if (!well && (wellSeen || row->visibleRegion().isEmpty())) {
                    return row->objectName();
                }
                wellSeen = wellSeen || well;
            }
            return {};
        };
        QTRY_VERIFY2_WITH_TIMEOUT(outOfPlace().isEmpty(), qPrintable(outOfPlace()), 60'000);

        // Return repeats the check. It does not connect.
        QSignalSpy connected(page.get(), &PreflightPage::connectRequested);
        QSignalSpy finished(page.get(), &PreflightPage::finished);
        keepPicture(*page, "protective_stop");
        QTest::keyClick(page.get(), Qt::Key_Return);
        QVERIFY(finished.wait(30'000));
        QCOMPARE(connected.size(), 0);
    }

    void closingTheDialogEndsTheCheck() {
        Cell cell;
        QVERIFY(cell.begin());
        cell.patient.ports.rtde = cell.peer([](test::RawPeer::Link& link) { link.beMute(); });
        auto page = open(cell.patient);
        QTest::qWait(20);
        page.reset();  // waits for the thread; without cancelling the deadline, the test would hang
        QVERIFY(cell.robot->isRunning());
    }

    void commandLineReportsTheSame() {
        Cell cell;
        cell.options.anyFreePorts = false;
        cell.options.listenAddress =
            QStringLiteral("127.78.%1.1").arg(QCoreApplication::applicationPid() % 250);
        QVERIFY(cell.begin());
        QVERIFY(cell.robot->inject("remote off").ok());
        cell.robot->protectiveStop();
        const auto page = open(doctor::patientAt(cell.options.listenAddress));
        QTRY_VERIFY_WITH_TIMEOUT(page->isFinished(), 30'000);
        QProcess cli;
        cli.start(QStringLiteral(TILLER_CLI), {"doctor", cell.options.listenAddress, "--json"});
        QVERIFY(cli.waitForFinished(60'000));
        QCOMPARE(cli.exitCode(), 1);
        const QJsonObject said = QJsonDocument::fromJson(cli.readAllStandardOutput()).object();
        const QJsonObject shown = doctor::toJson(page->report());
        QCOMPARE(said["verdict"], shown["verdict"]);
        const QJsonArray a = said["findings"].toArray();
        const QJsonArray b = shown["findings"].toArray();
        QCOMPARE(a.size(), b.size());
        for (int i = 0; i < a.size(); ++i) {
            for (const char* field : {"condition", "cause", "fix"}) {
                QCOMPARE(a[i][QLatin1String(field)], b[i][QLatin1String(field)]);
            }
        }
    }
};

QTEST_MAIN(TestPreflightPage)
#include "tst_preflight_page.moc"
