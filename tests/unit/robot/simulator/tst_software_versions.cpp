// SPDX-License-Identifier: MIT
//
// Features of each release of the controller software: RTDE fields, dashboard commands, Robot API, and the
// parts and layouts of primary packages. URScript functions are tested in tst_builtin_table.

#include <QTest>
#include <set>

#include "robot/rtde/fields.h"
#include "robot/simulator/controller/controller_model.h"
#include "robot/simulator/plant/primary_messages.h"
#include "robot/simulator/plant/rtde_values.h"
#include "robot/simulator/programs/program_store.h"
#include "robot/simulator/servers/primary/primary_state.h"
#include "robot/simulator/servers/primary/realtime_record.h"
#include "robot/simulator/servers/rtde/rtde_inputs.h"
#include "robot/simulator/servers/service/dashboard_commands.h"
#include "robot/simulator/servers/service/robot_api.h"

using namespace tiller;
using namespace tiller::simulator;

namespace {

/// e.g. "5.6.1"
SoftwareVersion versionOf(const QString& text) {
    const QStringList parts = text.split('.');
    return {parts[0].toUInt(), parts[1].toUInt(), parts.size() > 2 ? parts[2].toUInt() : 0, 0};
}

/// Returns the last release without a feature; empty for 3.0 and 5.0, which have no predecessor.
std::optional<SoftwareVersion> before(SoftwareVersion first) {
    if (first.bugfix > 0) {
        --first.bugfix;
    } else if (first.minor > 0) {
        first = {first.major, first.minor - 1, 99, 0};
    } else {
        return std::nullopt;
    }
    return first;
}

SimulatorOptions with(SoftwareVersion software, bool isListed = false) {
    SimulatorOptions options;
    options.model = software.isCb3() ? RobotModelId::UR5 : RobotModelId::UR5e;
    options.software = software;
    options.poweredOn = true;
    options.fastTransitions = true;
    if (isListed && !assume(options.assumptions, QStringLiteral("first-versions=latest"))) {
        qFatal("first-versions");
    }
    return options;
}

bool hasOutput(const char* name, SoftwareVersion software, bool isListed) {
    return OutputRecipe({name}, software, isListed).isValid();
}

bool hasInput(const char* name, SoftwareVersion software, bool isListed) {
    ControllerModel plant(with(software, isListed));
    RtdeInputs inputs(plant, software);
    return inputs.claim(1, {name}, rtde::ProtocolVersion::V2).recipe.has_value();
}

std::multiset<int> partsOf(const std::vector<std::uint8_t>& package) {
    std::multiset<int> types;
    for (std::size_t at = 5; at + 5 <= package.size();) {
        const std::size_t length = static_cast<std::size_t>(package[at]) << 24U |
                                   static_cast<std::size_t>(package[at + 1]) << 16U |
                                   static_cast<std::size_t>(package[at + 2]) << 8U | package[at + 3];
        types.insert(package[at + 4]);
        at += length;
    }
    return types;
}

}  // namespace

class TestSoftwareVersions : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void everyFieldExistsFromItsVersionOn_data() {
        QTest::addColumn<const rtde::Field*>("field");
        for (const auto& fields : {rtde::outputFields(), rtde::inputFields()}) {
            for (const rtde::Field& field : fields) {
                QTest::addRow("%s %s", field.direction == rtde::Direction::Output ? "output" : "input",
                              field.name)
                    << &field;
            }
        }
    }
    void everyFieldExistsFromItsVersionOn() {
        QFETCH(const rtde::Field*, field);
        const auto has = [&](SoftwareVersion software, bool isListed = false) {
            return field->direction == rtde::Direction::Output ? hasOutput(field->name, software, isListed)
                                                               : hasInput(field->name, software, isListed);
        };
        const auto verify = [&](SoftwareVersion first, unsigned series, SoftwareVersion newest) {
            if (first.major == rtde::Since::kNever || first.major > newest.major) {
                QVERIFY(!has(newest));
                return;
            }
            const SoftwareVersion from = first.major == series ? first : SoftwareVersion{series, 0, 0, 0};
            QVERIFY(has(from));
            if (const auto older = before(from)) {
                QVERIFY(!has(*older));
            }
        };
        verify(field->since.cb3, 3, {3, 15, 8, 0});
        verify(field->since.eSeries, 5, {5, 25, 0, 0});
        QVERIFY(has({10, 15, 0, 0}));
        // If no source states the first version, the version of the tables that list the feature is used (the
        // latest possible version).
        QVERIFY(has({5, 25, 0, 0}, true) == has({5, 25, 0, 0}));
        QCOMPARE(has({5, 22, 0, 0}, true), has({5, 22, 0, 0}) && field->since.confirmed);
        QCOMPARE(has({3, 15, 0, 0}, true), has({3, 15, 0, 0}) && field->since.confirmed);
    }

    // Source: dashboard guide and client tables. Where they disagree, the "latest" columns apply.
    void everyDashboardCommandExistsFromItsVersionOn_data() {
        QTest::addColumn<QString>("cb3");  // "-": never
        QTest::addColumn<QString>("eSeries");
        QTest::addColumn<QString>("latestCb3");
        QTest::addColumn<QString>("latestESeries");
        const auto row = [](const char* command, const char* cb3, const char* eSeries,
                            const char* latestCb3 = nullptr, const char* latestESeries = nullptr) {
            QTest::newRow(command) << QString(cb3) << QString(eSeries) << QString(latestCb3 ? latestCb3 : cb3)
                                   << QString(latestESeries ? latestESeries : eSeries);
        };
        for (const char* always : {"load x.urp", "play", "stop", "pause", "running", "robotmode",
                                   "get loaded program", "popup hello", "close popup", "addToLog hello",
                                   "isProgramSaved", "programState", "PolyscopeVersion", "power on",
                                   "power off", "brake release", "safetymode", "quit", "shutdown"}) {
            row(always, "3.0", "5.0");
        }
        row("unlock protective stop", "3.1", "5.0");
        row("close safety popup", "3.1", "5.0");
        row("restart safety", "3.7", "5.1");
        row("safetystatus", "3.11", "5.4", "3.11", "5.5");
        row("saveLog", "3.13", "5.8");
        row("setUserRole none", "3.0", "-", "3.1", "-");
        row("getUserRole", "3.1", "-");
        row("version", "-", "5.0", "-", "5.13");
        row("get serial number", "3.12", "5.6");
        row("get robot model", "3.12", "5.6");
        row("is in remote control", "-", "5.6");
        row("set operational mode manual", "-", "5.0");
        row("get operational mode", "-", "5.6");
        row("clear operational mode", "-", "5.0");
        row("generate flight report", "3.13", "5.8");
        row("generate support file .", "3.13", "5.8");
    }
    void everyDashboardCommandExistsFromItsVersionOn() {
        const auto knows = [](const SoftwareVersion& software, bool isListed) {
            ControllerModel plant(with(software, isListed));
            ProgramStore store(QString(), [] { return pendant::PendantSource(); });
            DashboardCommands dashboard(plant, store);
            const std::string line = QTest::currentDataTag();
            return dashboard.run(line, dashboard.rightsOfNewClient()).line !=
                   "could not understand: '" + line + "'";
        };
        const auto verify = [&](const QString& first, const SoftwareVersion& newest, bool isListed) {
            QCOMPARE(knows(newest, isListed), first != QLatin1String("-"));
            if (first != QLatin1String("-")) {
                QVERIFY(knows(versionOf(first), isListed));
                if (const auto older = before(versionOf(first))) {
                    QVERIFY(!knows(*older, isListed));
                }
            }
        };
        QFETCH(QString, cb3);
        QFETCH(QString, eSeries);
        QFETCH(QString, latestCb3);
        QFETCH(QString, latestESeries);
        verify(cb3, {3, 15, 8, 0}, false);
        verify(eSeries, {5, 25, 0, 0}, false);
        verify(latestCb3, {3, 15, 8, 0}, true);
        verify(latestESeries, {5, 25, 0, 0}, true);
    }

    // In older versions, the rest of the line is a program name.
    void installationsAreLoadedSince32() {
        for (const bool knows : {false, true}) {
            ControllerModel plant(with({3, knows ? 2U : 1U, 0, 0}));
            ProgramStore store(QString(), [] { return pendant::PendantSource(); });
            DashboardCommands dashboard(plant, store);
            QCOMPARE(dashboard.run("load installation x", dashboard.rightsOfNewClient()).line,
                     std::string(knows ? "File not found: x" : "File not found: installation x"));
        }
    }

    // Source: dashboard guide. From 3.4 on, play, stop and pause report a failure.
    void softwareBefore34DoesNotReportFailures() {
        for (const bool reports : {false, true}) {
            ControllerModel plant(with({3, reports ? 4U : 3U, 0, 0}));
            ProgramStore store(QString(), [] { return pendant::PendantSource(); });
            DashboardCommands dashboard(plant, store);
            const auto ask = [&](const char* line) {
                return dashboard.run(line, dashboard.rightsOfNewClient()).line;
            };
            QCOMPARE(ask("play"), std::string(reports ? "Failed to execute: play" : "Starting program"));
            QCOMPARE(ask("pause"), std::string(reports ? "Failed to execute: pause" : "Pausing program"));
        }
    }

    void everyRobotApiCallExistsFromItsVersionOn_data() {
        QTest::addColumn<QByteArray>("method");
        QTest::addColumn<bool>("in11");
        QTest::addColumn<bool>("in12");
        const auto row = [](const char* method, const char* path, bool in11, bool in12) {
            QTest::newRow(path) << QByteArray(method) << in11 << in12;
        };
        row("GET", "/openapi.json", true, true);
        row("PUT", "/robotstate/v1/state", true, true);
        row("PUT", "/program/v1/load", true, false);
        row("GET", "/program/v1/state", true, true);
        row("GET", "/program/v1/loaded", false, true);
        row("GET", "/robotstate/v1/robotmode", false, true);
        row("GET", "/robotstate/v1/safetymode", false, true);
        row("GET", "/system/v1/controlmode", false, true);
        row("GET", "/system/v1/operationalmode", false, true);
        row("GET", "/programs/v1/", false, true);
        row("POST", "/programs/v1/", false, true);
    }
    void everyRobotApiCallExistsFromItsVersionOn() {
        QFETCH(QByteArray, method);
        const auto knows = [&](unsigned minor) {
            ControllerModel plant(with({10, minor, 0, 0}));
            ProgramStore store(QString(), [] { return pendant::PendantSource(); });
            RobotApi api(plant, store);
            HttpRequest request;
            request.method = method.toStdString();
            request.path = std::string("/universal-robots/robot-api") + QTest::currentDataTag();
            const int status = api.run(request).status;
            return status != 404 && status != 405;
        };
        QTEST(knows(11), "in11");
        QTEST(knows(12), "in12");
    }

    void robotStateHasThePartsOfItsSoftware() {
        const auto parts = [](const SoftwareVersion& software) {
            ControllerModel plant(with(software));
            plant.step();
            return partsOf(primary::robotState(plant.telemetry(), true));
        };
        using Types = std::multiset<int>;
        // Kinematics (5) from 3.6 on, tool communication and outputs (11, 12) from 5.0 on, singularity (13)
        // from 5.10 on.
        QCOMPARE(parts({3, 5, 0, 0}), (Types{0, 1, 2, 3, 4, 6, 7, 8, 9, 10}));
        QCOMPARE(parts({3, 6, 0, 0}), (Types{0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10}));
        QCOMPARE(parts({3, 15, 0, 0}), (Types{0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10}));
        QCOMPARE(parts({5, 0, 0, 0}), (Types{0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12}));
        QCOMPARE(parts({5, 9, 0, 0}), (Types{0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12}));
        QCOMPARE(parts({5, 10, 0, 0}), (Types{0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13}));
    }

    void robotStateReportsTheModesOfTheToolOutputs() {
        ControllerModel plant(with({5, 22, 0, 0}));
        plant.pins().toolOutputMode = 1;
        plant.pins().toolDigitalOutputModes = {2, 3};
        plant.step();
        const std::vector<std::uint8_t> package = primary::robotState(plant.telemetry(), false);
        const std::array<std::uint8_t, 8> wanted{0, 0, 0, 8, 12, 1, 2, 3};
        QVERIFY(std::search(package.begin(), package.end(), wanted.begin(), wanted.end()) != package.end());
    }

    void popupsHaveTheLayoutOfTheirSoftware() {
        const auto body = [](const SoftwareVersion& software) {
            const primary::Bytes bytes = primary::popup(0, {7, true, false, true, "T", "text"}, software);
            return QByteArray(reinterpret_cast<const char*>(bytes.data()) + 15,
                              static_cast<qsizetype>(bytes.size()) - 15);
        };
        const QByteArray older("\1\0\1Ttext", 8);
        const QByteArray newer("\0\0\0\7\0\0\0\10\1\0\1\1Ttext", 17);
        QCOMPARE(body({3, 11, 0, 0}), older);
        QCOMPARE(body({3, 12, 0, 0}), newer);
        QCOMPARE(body({5, 5, 0, 0}), older);
        QCOMPARE(body({5, 6, 0, 0}), newer);
    }

    void theRealtimeRecordHasTheSizeOfItsSoftware_data() {
        QTest::addColumn<QString>("software");
        QTest::addColumn<int>("size");
        const auto row = [](const char* software, int size) {
            QTest::newRow(software) << QString(software) << size;
        };
        row("3.1", 1044);
        row("3.2", 1060);
        row("3.4", 1060);
        row("3.5", 1108);
        row("3.9", 1108);
        row("3.10", 1116);
        row("3.13", 1116);
        row("3.14", 1140);
        row("3.15", 1140);
        row("5.0", 1108);
        row("5.3", 1108);
        row("5.4", 1116);
        row("5.8", 1116);
        row("5.9", 1140);
        row("5.10", 1220);
        row("10.12", 1220);
    }
    void theRealtimeRecordHasTheSizeOfItsSoftware() {
        QFETCH(QString, software);
        QTEST(static_cast<int>(realtimeRecordSize(versionOf(software))), "size");
    }
};

QTEST_GUILESS_MAIN(TestSoftwareVersions)
#include "tst_software_versions.moc"
