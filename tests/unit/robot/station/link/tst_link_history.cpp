// SPDX-License-Identifier: GPL-3.0-or-later
// Late and lost packets in the last ten seconds.
#include <QTest>

#include "robot/core/clock.h"
#include "robot/station/link/detail/link_history.h"

using namespace tiller;

class TestLinkHistory : public QObject {
    Q_OBJECT

private:
    /// One second with 500 packets in frames of 20 ms. Some of the packets are late or lost.
    PacketCounts second(std::uint64_t late, std::uint64_t lost) {
        PacketCounts recent;
        for (int frame = 1; frame <= 50; ++frame) {
            ns_ += 20 * kNsPerMs;
            counts_.packets += 10;
            if (frame == 25) {
                counts_.late += late;
                counts_.lost += lost;
            }
            recent = history_.add(ns_, counts_);
        }
        return recent;
    }
    LinkHistory history_;
    PacketCounts counts_;
    std::int64_t ns_ = 0;

private Q_SLOTS:
    void init() {
        history_.clear();
        counts_ = {};
    }
    void entriesOlderThanTenSecondsAreDropped() {
        QCOMPARE(second(300, 2).late, std::uint64_t(300));
        PacketCounts recent;
        for (int s = 0; s < 8; ++s) {
            recent = second(1, 0);
        }
        QCOMPARE(recent.late, std::uint64_t(308));
        QCOMPARE(recent.lost, std::uint64_t(2));
        for (int s = 0; s < 4; ++s) {
            recent = second(0, 0);
        }
        QVERIFY(recent.late <= 8);
        QCOMPARE(recent.lost, std::uint64_t(0));
        QVERIFY(recent.packets >= 4900 && recent.packets <= 5250);
    }
    void resetCountersAreNotCountedAsLoss() {
        second(5, 5);
        counts_ = {};
        const PacketCounts recent = second(0, 0);
        QCOMPARE(recent.late, std::uint64_t(0));
        QCOMPARE(recent.lost, std::uint64_t(0));
        QVERIFY(recent.packets <= 500);
    }
};

QTEST_GUILESS_MAIN(TestLinkHistory)
#include "tst_link_history.moc"
