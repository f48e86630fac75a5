// SPDX-License-Identifier: MIT
//
// Model, software version and serial number are configured once and are consistent on all interfaces.

#include <QJsonDocument>
#include <QJsonObject>
#include <QSet>
#include <QTest>

#include "robot/simulator/plant/personality.h"
#include "tests/support/raw_client.h"

using namespace tiller;
using namespace tiller::test;

class TestPersonalities : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void allInterfacesReportTheSame_data() {
        QTest::addColumn<QString>("model");
        QTest::addColumn<QString>("software");
        QTest::addColumn<int>("robotType");
        QTest::addColumn<QByteArray>("dashboardModel");
        QTest::newRow("CB3") << "ur5"
                             << "3.15" << 1 << QByteArray("UR5");
        QTest::newRow("CB3, large") << "ur10"
                                    << "3.15" << 2 << QByteArray("UR10");
        QTest::newRow("e-Series 5.11") << "ur3e"
                                       << "5.11" << 3 << QByteArray("UR3");
        QTest::newRow("e-Series 5.22") << "ur5e"
                                       << "5.22" << 1 << QByteArray("UR5");
        QTest::newRow("e-Series 5.25") << "ur16e"
                                       << "5.25" << 4 << QByteArray("UR16");
        QTest::newRow("UR series 5.25") << "ur20"
                                        << "5.25" << 7 << QByteArray("UR20");
        QTest::newRow("in full") << "ur30"
                                 << "5.16.2.77" << 8 << QByteArray("UR30");
        QTest::newRow("PolyScope X") << "ur5e"
                                     << "10.12" << 1 << QByteArray();
    }
    void allInterfacesReportTheSame() {
        QFETCH(QString, model);
        QFETCH(QString, software);
        QFETCH(int, robotType);
        QFETCH(QByteArray, dashboardModel);
        auto options = VirtualRobot::options();
        options.model = *robotModelByName(model);
        const Result<SoftwareVersion> version = simulator::parseSoftware(software);
        QVERIFY(version.ok());
        options.software = *version;
        QVERIFY(simulator::checkSoftware(options.model, options.software).ok());
        VirtualRobot robot(options);
        QVERIFY(robot.started);
        const QByteArray number = QByteArray::fromStdString(simulator::versionText(*version));
        QVERIFY(number.startsWith(software.toUtf8()));

        RawRtde rtde = robot.rtde();
        QVERIFY(rtde.useVersion());
        const QByteArray reported = rtde.request('v').payload;
        QCOMPARE(QByteArray::number(wordAt(reported, 0)) + '.' + QByteArray::number(wordAt(reported, 4)) +
                     '.' + QByteArray::number(wordAt(reported, 8)) + '.' +
                     QByteArray::number(wordAt(reported, 12)),
                 number);
        // Check the control period.
        rtde.setupOutputs(1000, "timestamp");
        QVERIFY(rtde.start());
        robot.controller.step(2);
        const double first = doubleAt(rtde.next().payload, 1);
        QVERIFY(std::abs(doubleAt(rtde.next().payload, 1) - first - (version->major == 3 ? 0.008 : 0.002)) <
                1e-9);

        RawPrimary primary = robot.primary();
        const QByteArray message = primary.next();
        QCOMPARE(QByteArray::number(int(message[25])) + '.' + QByteArray::number(int(message[26])) + '.' +
                     QByteArray::number(wordAt(message, 27)) + '.' + QByteArray::number(wordAt(message, 31)),
                 number);
        robot.controller.stepSeconds(0.21);
        const QByteArray state = primary.next();
        int type = 0;
        int subType = 0;
        for (qsizetype at = 5; at + 5 <= state.size(); at += intAt(state, at)) {
            if (state[at + 4] == 6) {
                type = intAt(state, at + 437);
                subType = intAt(state, at + 441);
            }
        }
        QCOMPARE(type, robotType);
        QCOMPARE(subType, version->major == 3 ? 2 : 3);

        if (version->isPolyScopeX()) {
            RawClient web(robot.host(), robot.controller.ports().robotApi);
            web.send("GET /universal-robots/robot-api/openapi.json HTTP/1.0\r\n\r\n");
            QVERIFY(web.waitClosed());
            QVERIFY(web.takeAll().startsWith("HTTP/1.1 200"));
            QCOMPARE(robot.controller.ports().dashboard, quint16(0));
            return;
        }
        QCOMPARE(robot.controller.ports().robotApi, quint16(0));
        RawDashboard dashboard = robot.dashboard();
        const QByteArray polyscope = dashboard.ask("PolyscopeVersion");
        QVERIFY2(polyscope.startsWith("URSoftware " + number + " ("), polyscope);
        // The same date appears in both formats.
        const QByteArray year = polyscope.mid(polyscope.indexOf(')') - 4, 4);
        QVERIFY2(message.mid(35).contains(year), message.mid(35));
        if (version->major == 5) {
            QCOMPARE(dashboard.ask("version"), number + '\n');
        }
        QCOMPARE(dashboard.ask("get robot model"), dashboardModel + '\n');
        QCOMPARE(dashboard.ask("get serial number"), robot.controller.options().serialNumber.toUtf8() + '\n');
    }

    void everyModelHasItsOwnSerialNumber() {
        QSet<QString> seen;
        for (const RobotModel& model : robotModels()) {
            const QString serial = simulator::serialNumber(model.id, simulator::defaultSoftware(model.id));
            QVERIFY(serial.startsWith("20"));
            bool ok = false;
            serial.toULongLong(&ok);
            QVERIFY(ok);
            seen << serial;
            QVERIFY(simulator::checkSoftware(model.id, simulator::defaultSoftware(model.id)).ok());
        }
        QCOMPARE(seen.size(), qsizetype(robotModels().size()));
    }

    void unsuitableValuesAreRefused() {
        for (const char* wrong :
             {"", "5", "new", "5.x", "4.2", "6.0", "5.1.2.3.4", "5.300", "-5.1", "10.12."}) {
            QVERIFY2(!simulator::parseSoftware(QString::fromLatin1(wrong)).ok(), wrong);
        }
        QVERIFY(!simulator::checkSoftware(RobotModelId::UR5, {5, 22, 0, 0}).ok());
        QVERIFY(!simulator::checkSoftware(RobotModelId::UR5e, {3, 15, 0, 0}).ok());
        QVERIFY(!simulator::checkSoftware(RobotModelId::UR5, {10, 12, 0, 0}).ok());
        QVERIFY(!simulator::checkSoftware(RobotModelId::UR15, {5, 21, 0, 0}).ok());
        QVERIFY(!simulator::checkSoftware(RobotModelId::UR18, {10, 10, 0, 0}).ok());
        auto options = VirtualRobot::options();
        options.model = RobotModelId::UR10;
        simulator::Simulator controller(options);
        const Result<void> refused = controller.start();
        QVERIFY(!refused.ok());
        QVERIFY(refused.error().context.contains("UR10"));
        QVERIFY(!controller.isRunning());
    }
};

QTEST_GUILESS_MAIN(TestPersonalities)
#include "tst_personalities.moc"
