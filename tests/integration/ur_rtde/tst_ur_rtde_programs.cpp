// SPDX-License-Identifier: MIT
// Typical user programs for ur_rtde, each in a separate process without Qt.
#include <QFileInfo>
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>

#include "tests/integration/ur_rtde/ur_rtde_cell.h"

using namespace tiller;

class TestUrRtdePrograms : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void programsRun_data() {
        QTest::addColumn<QString>("program");
        for (const char* name : {"forward_control", "servoj_example", "speedj_example", "forcemode_example",
                                 "move_async_example", "io_example", "record_data_example", "circle_example",
                                 "move_until_contact_example", "gripper_example", "movel_path_example"}) {
            QTest::newRow(name) << name;
        }
    }
    void programsRun() {
        QFETCH(QString, program);
        const QString path = QStringLiteral(TILLER_PROGRAMS "/ur_rtde_") + program;
        QVERIFY2(QFileInfo(path).isExecutable(), qPrintable(path));
        test::UrRtdeCell cell;
        QTemporaryDir folder;
        QProcess process;
        process.setProcessChannelMode(QProcess::MergedChannels);
        process.start(path, {QString::fromStdString(cell.host()), folder.filePath("record.csv")});
        if (program == "move_until_contact_example") {
            const double z = cell.robot.truth().tcpPose.position.z();
            QVERIFY(cell.until([z](const simulator::SimulatedState& truth) {
                return truth.tcpPose.position.z() < z - 0.01;
            }));
            cell.robot.pressHand(Wrench::fromVector((Vector6() << 0, 0, 150, 0, 0, 0).finished()));
        }
        QVERIFY2(process.waitForFinished(120'000), process.readAll().constData());
        const QByteArray output = process.readAll();
        QVERIFY2(process.exitStatus() == QProcess::NormalExit && process.exitCode() == 0,
                 output + " exit code " + QByteArray::number(process.exitCode()));
        QVERIFY2(!output.contains("QSocketNotifier") && !output.contains("QCoreApplication"),
                 output.constData());
    }
};

QTEST_GUILESS_MAIN(TestUrRtdePrograms)
#include "tst_ur_rtde_programs.moc"
