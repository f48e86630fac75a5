// SPDX-License-Identifier: GPL-3.0-or-later
// Distinguishes one stop that continues from two stops after an interruption of the data.
#include <QSignalSpy>
#include <QTest>
#include <algorithm>
#include <cmath>

#include "robot/station/capture/stop_record.h"
#include "robot/station/link/robot_session.h"
#include "tests/support/sample_stream.h"

using namespace tiller;

namespace {

struct Bench {
    RobotSession session;
    StopRecorder stops{session};
    test::SampleStream stream;
    std::uint64_t sequence = 0;
    std::uint64_t connection = 1;
    double time = 100;
    double base = 0.3;  ///< position of the base joint [rad]
    SafetyMode safety = SafetyMode::Normal;

    Bench() {
        session.shutDown();  // disables automatic frames; the test triggers them
        stream.layout = std::make_shared<const receive::SampleLayout>(
            std::vector<std::string>{"timestamp", "actual_q", "actual_current", "target_current",
                                     "actual_TCP_force", "actual_TCP_speed", "safety_mode"});
    }
    /// Adds this number of packets at 500 Hz, in one frame.
    void run(int packets) {
        for (int i = 0; i < packets; ++i) {
            time += 0.002;
            receive::Sample& sample = stream.add(time, ++sequence);
            std::fill(sample.values.begin(), sample.values.end(), 0.0);
            sample.connection = connection;
            stream.set(sample, "timestamp", time);
            stream.set(sample, "actual_q_0", base);
            stream.set(sample, "safety_mode", static_cast<double>(safety));
        }
        stream.frame([this](const SampleBatch& batch) { Q_EMIT session.samplesReceived(batch); });
    }
    double stoppedAt() const { return stops.last() ? stops.last()->stoppedAt : -1; }
    void stop() {
        run(100);
        safety = SafetyMode::ProtectiveStop;
        run(100);
    }
};

}  // namespace

class TestStopRecord : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void aStopIsRecordedOnce() {
        Bench bench;
        QSignalSpy changed(&bench.stops, &StopRecorder::changed);
        bench.stop();
        QVERIFY(std::abs(bench.stoppedAt() - 100.202) < 1e-6);
        bench.base += 0.1;  // the arm coasts or is pushed, and the data have no gap
        bench.run(1000);
        QCOMPARE(changed.count(), 1);
    }

    void anArmThatMovedDuringAGapCountsAsANewStop_data() {
        QTest::addColumn<int>("connections");
        QTest::addColumn<double>("gap");
        QTest::addColumn<double>("turned");
        QTest::addColumn<bool>("isNew");
        QTest::newRow("another connection, elsewhere") << 1 << 3.0 << 0.01 << true;
        QTest::newRow("another connection, the other way") << 1 << 3.0 << -0.01 << true;
        QTest::newRow("another connection at once, elsewhere") << 1 << 0.01 << 0.01 << true;
        QTest::newRow("the same connection, elsewhere") << 0 << 0.6 << 0.01 << true;
        QTest::newRow("the controller restarted, elsewhere") << 1 << -90.0 << 0.01 << true;
        QTest::newRow("another connection, same place") << 1 << 3.0 << 0.001 << false;
        QTest::newRow("the same connection, same place") << 0 << 0.9 << 0.001 << false;
        QTest::newRow("the controller restarted, same place") << 1 << -90.0 << 0.0 << false;
        QTest::newRow("some packets late") << 0 << 0.3 << 0.01 << false;
    }
    void anArmThatMovedDuringAGapCountsAsANewStop() {
        QFETCH(int, connections);
        QFETCH(double, gap);
        QFETCH(double, turned);
        QFETCH(bool, isNew);
        Bench bench;
        bench.stop();
        const double first = bench.stoppedAt();
        QVERIFY(first > 0);
        QSignalSpy changed(&bench.stops, &StopRecorder::changed);
        bench.connection += static_cast<std::uint64_t>(connections);
        bench.time += gap;
        bench.base += turned;
        bench.run(10);
        QCOMPARE(bench.stoppedAt() != first, isNew);
        QCOMPARE(changed.count(), isNew ? 1 : 0);
        if (isNew) {
            QCOMPARE(bench.stops.last()->q[0], bench.base);
        }
        // The stop is reported once, because the following data belong to the same stop.
        bench.run(1000);
        QCOMPARE(changed.count(), isNew ? 1 : 0);
    }

    void aGapWithoutAStopIsNotRecorded() {
        Bench bench;
        bench.run(100);
        bench.connection += 1;
        bench.time += 3;
        bench.base += 0.5;
        bench.run(100);
        QVERIFY(!bench.stops.last());
        bench.stop();
        QVERIFY(bench.stops.last());
    }
};

QTEST_MAIN(TestStopRecord)
#include "tst_stop_record.moc"
