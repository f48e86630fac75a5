// SPDX-License-Identifier: MIT
// Data that the primary and realtime ports send without a request: version, state, variables and realtime
// record.
#include <QTest>

#include "tests/support/primary_listener.h"

using namespace tiller;
using namespace tiller::test;

namespace {

/// Returns the sub-packages of a RobotState by type.
QMap<int, QByteArray> partsOf(const QByteArray& state) {
    QMap<int, QByteArray> parts;
    for (qsizetype at = 5; at + 5 <= state.size();) {
        const qsizetype length = wordAt(state, at);
        if (length < 5 || at + length > state.size()) {
            return {};
        }
        parts.insert(state[at + 4], state.mid(at, length));
        at += length;
    }
    return parts;
}

/// Received variable messages, without frame and time.
QList<QByteArray> variablesOf(RawPrimary& primary) {
    QList<QByteArray> found;
    for (const QByteArray& package : primary.packages()) {
        if (package[4] == 25) {
            found << package.mid(13);
        }
    }
    return found;
}

}  // namespace

class TestPrimaryData : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void theVersionIsSentFirst() {
        VirtualRobot robot;
        RawPrimary primary = robot.primary();
        const QByteArray message = primary.next();
        QCOMPARE(message.size(), 55);
        QCOMPARE(int(message[4]), 20);
        QCOMPARE(message.mid(5, 8), QByteArray(8, '\xff'));  // the message has no time
        QCOMPARE(int(message[13]), -2);
        QCOMPARE(int(message[14]), int(kVersion));
        QCOMPARE(message.mid(15, 10), QByteArray("\x09URControl"));
        QCOMPARE(int(message[25]), 5);
        QCOMPARE(int(message[26]), 22);
        QCOMPARE(intAt(message, 27), 1);
    }

    void onlyTheFirstStateDescribesTheArm() {
        auto options = VirtualRobot::options();
        options.software = {5, 8, 0, 0};  // software version of the recorded data
        VirtualRobot robot(options);
        RawPrimary primary = robot.primary();
        primary.next();
        robot.controller.stepSeconds(0.21);
        const QByteArray first = primary.next();
        QCOMPARE(first.size(), 1386);
        const auto parts = partsOf(first);
        QCOMPARE(parts.keys(), (QList<int>{0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12}));
        const int sizes[] = {47, 251, 37, 75, 101, 225, 445, 61, 9, 53, 43, 26, 8};
        for (int type = 0; type <= 12; ++type) {
            QCOMPARE(parts[type].size(), sizes[type]);
        }
        // The order is that of the vendor's simulator.
        QCOMPARE(int(first[5 + 4]), 0);
        QCOMPARE(int(first[52 + 4]), 1);
        QCOMPARE(int(first[303 + 4]), 4);
        QCOMPARE(int(first[404 + 4]), 5);
        QCOMPARE(int(first[629 + 4]), 9);
        QCOMPARE(int(first[682 + 4]), 3);
        QCOMPARE(int(first[757 + 4]), 2);
        QCOMPARE(int(first[794 + 4]), 6);

        const QByteArray mode = parts[0];
        QCOMPARE(mode.mid(13, 7), QByteArray("\1\1\1\0\0\0\0", 7));
        QCOMPARE(int(mode[20]), 7);
        QCOMPARE(doubleAt(mode, 22), 1.0);
        QCOMPARE(doubleAt(mode, 38), 1.0);
        QVERIFY(std::abs(doubleAt(parts[1], 5) - -1.6007) < 1e-3);
        QCOMPARE(int(parts[1][5 + 40]), int(char(253)));
        QCOMPARE(doubleAt(parts[5], 77 + 8), -0.425);
        QCOMPARE(intAt(parts[6], 437), 1);
        QCOMPARE(intAt(parts[6], 441), 3);
        QCOMPARE(int(parts[3][65]), 1);

        QCOMPARE(primary.next().size(), 716);
    }

    void statesAreSentTenTimesPerSecond() {
        VirtualRobot robot;
        RawPrimary primary = robot.primary();
        primary.next();
        robot.controller.drainSockets();
        robot.controller.stepSeconds(2.0);
        QCOMPARE(Heard(primary).states, 20);
    }

    void newerSoftwareAddsToTheState() {
        VirtualRobot robot;
        RawPrimary primary = robot.primary();
        primary.next();
        robot.controller.stepSeconds(0.21);
        const auto parts = partsOf(primary.next());
        QCOMPARE(parts[6].size(), 449);
        QCOMPARE(parts[13].size(), 7);
    }

    // Clients read the sub-package to its last byte and fail if a byte is missing.
    void theMasterboardHasTheLengthOfItsSoftware_data() {
        QTest::addColumn<int>("major");
        QTest::addColumn<int>("minor");
        QTest::addColumn<int>("size");
        QTest::newRow("3.1") << 3 << 1 << 72;
        QTest::newRow("3.2") << 3 << 2 << 74;
        QTest::newRow("3.9") << 3 << 9 << 74;
        QTest::newRow("3.10") << 3 << 10 << 75;
        QTest::newRow("3.15") << 3 << 15 << 75;
        QTest::newRow("5.3") << 5 << 3 << 74;
        QTest::newRow("5.4") << 5 << 4 << 75;
        QTest::newRow("10.12") << 10 << 12 << 75;
    }
    void theMasterboardHasTheLengthOfItsSoftware() {
        QFETCH(int, major);
        QFETCH(int, minor);
        QFETCH(int, size);
        auto options = VirtualRobot::options();
        options.model = major == 3 ? RobotModelId::UR5 : RobotModelId::UR5e;
        options.software = {static_cast<quint32>(major), static_cast<quint32>(minor), 0, 0};
        VirtualRobot robot(options);
        RawPrimary primary = robot.primary();
        primary.next();
        robot.controller.stepSeconds(0.21);
        QCOMPARE(int(partsOf(primary.next())[3].size()), size);
    }

    void variablesAreReportedOnceAndOnChange() {
        VirtualRobot robot;
        RawPrimary primary = robot.primary();
        primary.send(
            "def p():\n  global n = 1\n  global where = p[1,0,0,0,0,0]\n  global words = \"hi\"\n"
            "  global all = [True, False]\n  global table = [[1.0,2.0],[3.0,4.0]]\n  sleep(0.5)\n  n = 7\n"
            "  sleep(100)\nend\n");
        robot.controller.drainSockets();
        robot.controller.stepSeconds(0.4);
        const QList<QByteArray> first = variablesOf(primary);
        QVERIFY(first.size() >= 2);
        QCOMPARE(first[0], QByteArray("\0\0\0", 3) + "n\nwhere\nwords\nall\ntable\n");
        QByteArray expected("\1\0\0", 3);
        expected += QByteArray("\17\0\0\0\1\n", 6);
        expected += QByteArray("\14\x3f\x80\0\0", 5) + QByteArray(20, '\0') + '\n';
        expected += QByteArray("\3\0\2hi\n", 6);
        expected += QByteArray("\21\0\2\15\1\15\0\n", 8);
        expected += QByteArray("\22\0\2\0\2", 5) + QByteArray("\20\x3f\x80\0\0", 5) +
                    QByteArray("\20\x40\0\0\0", 5) + QByteArray("\20\x40\x40\0\0", 5) +
                    QByteArray("\20\x40\x80\0\0", 5) + '\n';
        QCOMPARE(first.back(), expected);
        robot.controller.stepSeconds(0.5);
        const QList<QByteArray> changed = variablesOf(primary);
        QCOMPARE(changed.size(), qsizetype(1));
        QCOMPARE(changed[0].mid(3, 6), QByteArray("\17\0\0\0\7\n", 6));
        robot.controller.stepSeconds(0.5);
        QVERIFY(variablesOf(primary).isEmpty());
    }

    void olderSoftwareUsesOtherVariableTypeNumbers() {
        auto options = VirtualRobot::options();
        options.model = RobotModelId::UR5;
        options.software = {3, 13, 0, 0};
        VirtualRobot robot(options);
        RawPrimary primary = robot.primary();
        primary.send(
            "def p():\n  global n = 1\n  global half = 0.5\n  global yes = True\n  global words = \"hi\"\n"
            "  global all = [1, 2]\n  global where = p[0,0,0,0,0,0]\n  sleep(100)\nend\n");
        robot.controller.drainSockets();
        robot.controller.stepSeconds(0.4);
        const QByteArray expected = QByteArray("\1\0\0", 3) + QByteArray("\16\0\0\0\1\n", 6) +
                                    QByteArray("\17\x3f\0\0\0\n", 6) + QByteArray("\14\1\n", 3) +
                                    QByteArray("\3\0\2hi\n", 6) +
                                    QByteArray("\5\0\2\16\0\0\0\1\16\0\0\0\2\n", 14) + QByteArray("\12", 1) +
                                    QByteArray(24, '\0') + '\n';
        const QList<QByteArray> reported = variablesOf(primary);
        QVERIFY(!reported.isEmpty());
        QCOMPARE(reported.back(), expected);
    }

    void aValueTooLongForAPackageIsTruncatedCleanly() {
        VirtualRobot robot;
        RawPrimary primary = robot.primary();
        primary.send(
            "def p():\n  global long = make_list(1000, 1.5, 1000)\n  global after = 5\n  sleep(100)\nend\n");
        robot.controller.drainSockets();
        robot.controller.stepSeconds(0.4);
        const QList<QByteArray> reported = variablesOf(primary);
        QVERIFY(reported.size() >= 2);
        const QByteArray& values = reported.back();
        QVERIFY(values.size() < 4000);
        QCOMPARE(values.left(4), QByteArray("\1\0\0\21", 4));
        const auto shown = qFromBigEndian<quint16>(values.constData() + 4);
        QVERIFY(shown > 500 && shown < 1000);
        QCOMPARE(values.mid(6 + 5 * shown), '\n' + QByteArray("\17\0\0\0\5\n", 6));
    }

    void theRealtimeRecordHasTheSizeOfItsSoftware_data() {
        QTest::addColumn<int>("major");
        QTest::addColumn<int>("minor");
        QTest::addColumn<int>("size");
        QTest::newRow("3.0") << 3 << 0 << 1044;
        QTest::newRow("3.2") << 3 << 2 << 1060;
        QTest::newRow("3.5") << 3 << 5 << 1108;
        QTest::newRow("3.10") << 3 << 10 << 1116;
        QTest::newRow("3.15") << 3 << 15 << 1140;
        QTest::newRow("5.3") << 5 << 3 << 1108;
        QTest::newRow("5.8") << 5 << 8 << 1116;
        QTest::newRow("5.9") << 5 << 9 << 1140;
        QTest::newRow("5.22") << 5 << 22 << 1220;
    }
    void theRealtimeRecordHasTheSizeOfItsSoftware() {
        QFETCH(int, major);
        QFETCH(int, minor);
        QFETCH(int, size);
        auto options = VirtualRobot::options();
        options.software = {static_cast<quint32>(major), static_cast<quint32>(minor), 0, 0};
        options.model = major == 3 ? RobotModelId::UR5 : RobotModelId::UR5e;
        VirtualRobot robot(options);
        RawPrimary realtime(robot.host(), robot.controller.ports().realtime);
        robot.controller.drainSockets();
        robot.controller.step(2);
        const QByteArray first = realtime.next();
        QCOMPARE(first.size(), size);
        const QByteArray second = realtime.next();
        QVERIFY(std::abs(doubleAt(second, 4) - doubleAt(first, 4) - robot.controller.stepTime()) < 1e-9);
        QVERIFY(std::abs(doubleAt(first, 252) - -1.6007) < 1e-3);  // actual joint position q
        QCOMPARE(doubleAt(first, 756), 7.0);                       // robot mode
        QCOMPARE(doubleAt(first, 812), 1.0);                       // safety mode
    }

    void aRealtimeClientThatNeverReadsKeepsItsConnection() {
        VirtualRobot robot;
        RawClient unresponsive(robot.host(), robot.controller.ports().realtime);
        unresponsive.socket().setReadBufferSize(64);
        RawRtde rtde = robot.rtde();
        QVERIFY(rtde.useVersion());
        rtde.setupOutputs(10, "timestamp");
        QVERIFY(rtde.start());
        robot.controller.step(10'000);  // about twelve megabytes
        QCOMPARE(rtde.packages().size(), std::size_t(200));
        unresponsive.send("def p():\n  set_standard_digital_out(0, True)\nend\n");
        robot.controller.drainSockets();
        robot.controller.step(5);
        QCOMPARE(robot.controller.truth().digitalOutputs, 1ULL);
    }
};

QTEST_GUILESS_MAIN(TestPrimaryData)
#include "tst_primary_data.moc"
