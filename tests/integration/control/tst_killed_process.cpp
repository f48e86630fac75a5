// SPDX-License-Identifier: MIT
// The process that jogs is killed without warning: the robot alone comes to a stand, by its own clock within
// the contract's 250 ms. Watched through a second RTDE connection.
#include <QProcess>
#include <QTest>
#include <vector>

#include "robot/rtde/connection.h"
#include "robot/simulator/controller.h"

using namespace tiller;

class TestKilledProcess : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void killMinusNineEndsInStandstill() {
        simulator::ControllerOptions options;
        options.anyFreePorts = true;
        options.poweredOn = true;
        options.startJoints = JointPositions(-1.57, -1.2, -2.3, -1.2, 1.57, 0);
        simulator::Controller robot(options);
        QVERIFY(robot.start().ok());

        rtde::ConnectionOptions watching;
        watching.host = robot.listenAddress();
        watching.port = robot.ports().rtde;
        watching.request.outputs = {"timestamp", "actual_TCP_speed", "actual_qd"};
        auto watcher = rtde::Connection::open(watching, Deadline::after(std::chrono::seconds(20)));
        QVERIFY2(watcher.ok(), qPrintable(watcher.error().toString()));
        std::vector<double> values((*watcher)->outputs().size());
        double timestamp = 0;
        double speed = 0;
        const auto look = [&] {
            if ((*watcher)->readPackage(values, std::chrono::seconds(10)) !=
                rtde::Connection::Read::Package) {
                return false;
            }
            timestamp = values[0];
            speed = Eigen::Vector3d(values[1], values[2], values[3]).norm();
            return true;
        };

        QProcess helper;
        helper.setProcessChannelMode(QProcess::ForwardedErrorChannel);
        helper.start(QStringLiteral(JOG_HELPER),
                     {robot.listenAddress(), QString::number(robot.ports().primary),
                      QString::number(robot.ports().rtde)});
        QVERIFY(helper.waitForStarted(20000));
        const double patience = 60;  // [s] of robot time
        QVERIFY(look());
        const double begin = timestamp;
        while (speed < 0.095) {
            QVERIFY(look());
            QVERIFY2(timestamp - begin < patience, "the helper never moved the arm");
        }
        const double killedAt = robot.truth().timestamp;
        helper.kill();  // SIGKILL
        QVERIFY(helper.waitForFinished(20000));
        double stoodAt = 0;
        double lastMoved = killedAt;
        while (timestamp < killedAt + 1.0) {
            QVERIFY(look());
            if (speed > 0.001) {
                lastMoved = timestamp;
            } else if (stoodAt < lastMoved) {
                stoodAt = timestamp;
            }
        }
        const double ms = (lastMoved - killedAt) * 1000;
        qInfo("kill -9 to standstill: %.0f ms", ms);
        QVERIFY2(ms <= 250, qPrintable(QString::number(ms)));
    }
};

QTEST_GUILESS_MAIN(TestKilledProcess)
#include "tst_killed_process.moc"
