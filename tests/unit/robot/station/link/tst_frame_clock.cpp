// SPDX-License-Identifier: GPL-3.0-or-later
//
// One clock for the whole user interface. Each frame fetches the samples since the previous frame once, and
// all parts of the window show the latest sample.
#include <QElapsedTimer>
#include <QTest>
#include <vector>

#include "tests/support/virtual_cell.h"

using namespace tiller;
using tiller::test::VirtualCell;

namespace {

/// Records the signals that a part of the window receives from a session.
struct Listener {
    std::vector<std::uint64_t> sequences;  ///< sequence numbers of all samples, in order of arrival
    std::uint64_t lost = 0;
    int links = 0;
    int batches = 0;
    int frames = 0;
    int framesBehind = 0;  ///< number of frames whose state does not belong to the latest sample
    QObject context;       ///< destroying it disconnects the listener

    explicit Listener(RobotSession& session) {
        QObject::connect(&session, &RobotSession::linkBegan, &context, [this] {
            ++links;
            sequences.clear();
        });
        QObject::connect(&session, &RobotSession::samplesReceived, &context,
                         [this](const SampleBatch& batch) {
                             ++batches;
                             lost += batch.lost;
                             for (const receive::Sample& sample : batch.samples) {
                                 sequences.push_back(sample.sequence);
                             }
                         });
        QObject::connect(&session, &RobotSession::stateChanged, &context, [this](const SessionState& state) {
            ++frames;
            framesBehind += !sequences.empty() && state.sequence != sequences.back() ? 1 : 0;
        });
    }
    /// True if every sample arrived exactly once and in order.
    bool isWhole() const {
        for (std::size_t i = 1; i < sequences.size(); ++i) {
            if (sequences[i] != sequences[i - 1] + 1) {
                return false;
            }
        }
        return lost == 0;
    }
};

struct Bench {
    VirtualClock clock;
    RobotSession session{clock};
    VirtualCell cell{clock, session};
};

}  // namespace

class TestFrameClock : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void everySampleIsDeliveredOnceAndTheLastIsShown() {
        Bench bench;
        Listener first(bench.session);
        Listener second(bench.session);
        QVERIFY2(bench.cell.connect(), qPrintable(bench.cell.what()));
        bench.cell.advanceMs(400);
        QCOMPARE(first.links, 1);
        QVERIFY(first.sequences.size() >= 150);  // 500 per second
        QVERIFY(first.isWhole());
        QCOMPARE(first.framesBehind, 0);
        QVERIFY2(first.batches * 2 < static_cast<int>(first.sequences.size()),
                 "fewer than two samples per frame");
        QVERIFY(second.sequences == first.sequences);
    }

    // Late samples are delivered with the next frame. Samples that did not fit into the ring are counted.
    void aFrozenInterfaceReceivesAllSamplesAfterwards() {
        Bench bench;
        Listener listener(bench.session);
        QVERIFY2(bench.cell.connect(), qPrintable(bench.cell.what()));
        bench.cell.advanceMs(100);
        const int batches = listener.batches;
        const std::size_t before = listener.sequences.size();
        bench.cell.advanceWithFrozenInterface(300);
        QCOMPARE(listener.batches, batches);
        bench.session.refresh();
        QCOMPARE(listener.batches, batches + 1);
        QVERIFY(listener.sequences.size() >= before + 140);
        QVERIFY(listener.isWhole());
        QCOMPARE(listener.framesBehind, 0);
    }

    void aNewLinkIsReportedAndRestartsTheSequence() {
        Bench bench;
        Listener listener(bench.session);
        QVERIFY2(bench.cell.connect(), qPrintable(bench.cell.what()));
        bench.cell.advanceMs(100);
        bench.session.disconnectFromRobot();
        const std::size_t before = listener.sequences.size();
        bench.session.refresh();
        QCOMPARE(listener.sequences.size(), before);
        QCOMPARE(listener.links, 1);
        QVERIFY2(bench.cell.connect(), qPrintable(bench.cell.what()));
        bench.cell.advanceMs(100);
        QCOMPARE(listener.links, 2);
        QVERIFY(!listener.sequences.empty());
        QVERIFY(listener.isWhole());
    }

    // A motion that was active when disconnecting has no effect on the next robot.
    void aNewLinkDoesNotReportAnEarlierMotion() {
        Bench bench;
        QVERIFY2(bench.cell.bringUp(), qPrintable(bench.cell.what()));
        control::JogTarget up;
        up.twist.linear.z() = 0.05;
        const auto jog = bench.session.beginJog(up);
        QVERIFY(jog.ok());
        bench.cell.everyRefresh = [&] { bench.session.hold(*jog); };
        QVERIFY(bench.cell.advanceUntil([&] { return bench.session.state().moving; }, 1000));
        bench.cell.advanceMs(100);
        QVERIFY(bench.session.state().moving);
        const RobotAddress address = bench.session.address();
        bench.session.disconnectFromRobot();
        bench.session.connectTo(address);
        QVERIFY(bench.session.state().link != LinkState::Live);
        QVERIFY(bench.session.state().lastStopSeen);
    }

    // The connected() signal is emitted again, so clients need not compare the connection with the earlier
    // state.
    void aReconnectingRobotIsTheSameLink() {
        constexpr int kWaitTimeoutMs = 20'000;
        Bench bench;
        Listener listener(bench.session);
        int connections = 0;
        QObject::connect(&bench.session, &RobotSession::connected, &listener.context, [&] { ++connections; });
        QVERIFY2(bench.cell.connect(), qPrintable(bench.cell.what()));
        bench.cell.advanceMs(100);
        QCOMPARE(connections, 1);
        bench.cell.robot.closeClients();
        QElapsedTimer waited;
        waited.start();
        while (connections < 2 && waited.elapsed() < kWaitTimeoutMs) {
            bench.clock.advanceNs(2 * kNsPerMs);
            bench.cell.robot.step();
            bench.session.refresh();
            QTest::qWait(1);
        }
        QCOMPARE(connections, 2);
        QCOMPARE(listener.links, 1);
        QVERIFY(bench.session.state().hasData());
        bench.cell.advanceMs(100);
        QCOMPARE(connections, 2);
    }

    // A slot that receives a frame may process events and thus start another frame.
    void aNestedFrameDoesNotChangeTheOuterOne() {
        bool nested = false;
        Bench bench;
        Listener outer(bench.session);
        QObject::connect(&bench.session, &RobotSession::samplesReceived, &bench.session,
                         [&](const SampleBatch& batch) {
                             if (nested || batch.samples.empty()) {
                                 return;
                             }
                             nested = true;
                             const std::uint64_t last = batch.samples.back().sequence;
                             bench.cell.advanceWithFrozenInterface(40);
                             bench.session.refresh();
                             QCOMPARE(batch.samples.back().sequence, last);
                         });
        QVERIFY2(bench.cell.connect(), qPrintable(bench.cell.what()));
        bench.cell.advanceMs(100);
        QVERIFY(nested);
        QVERIFY(outer.isWhole());
    }
};

QTEST_MAIN(TestFrameClock)
#include "tst_frame_clock.moc"
