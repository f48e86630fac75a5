// SPDX-License-Identifier: MIT
#include <QTest>
#include <array>
#include <atomic>
#include <thread>

#include "robot/realtime/ring.h"

using tiller::realtime::BroadcastRing;

namespace {

using Record = std::array<std::uint64_t, 2>;

void push(BroadcastRing& ring, std::uint64_t value) {
    ring.push(Record{value, ~value});
}

}  // namespace

class TestRing : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void capacityIsRoundedUp();
    void comesOutInOrder();
    void everyConsumerGetsEverything();
    void cursorAtEndSeesOnlyWhatFollows();
    void oldestAreLostAndCounted();
    void nothingIsTornOrReorderedUnderContention();
};

void TestRing::capacityIsRoundedUp() {
    QCOMPARE(BroadcastRing(1, 5).capacity(), std::size_t(8));
    QCOMPARE(BroadcastRing(1, 8).capacity(), std::size_t(8));
    QCOMPARE(BroadcastRing(1, 0).capacity(), std::size_t(2));
}

void TestRing::comesOutInOrder() {
    BroadcastRing ring(2, 4);
    auto cursor = ring.atBegin();
    Record got{};
    QVERIFY(!ring.pop(cursor, got));
    // More than once around, never more than the capacity behind.
    for (std::uint64_t i = 0; i < 20; i += 4) {
        for (std::uint64_t k = 0; k < 4; ++k) {
            push(ring, i + k);
        }
        QCOMPARE(ring.pending(cursor), std::uint64_t(4));
        for (std::uint64_t k = 0; k < 4; ++k) {
            QVERIFY(ring.pop(cursor, got));
            QVERIFY((got == Record{i + k, ~(i + k)}));
        }
        QVERIFY(!ring.pop(cursor, got));
    }
    QCOMPARE(cursor.lost, std::uint64_t(0));
}

void TestRing::everyConsumerGetsEverything() {
    BroadcastRing ring(2, 8);
    auto first = ring.atEnd();
    auto second = ring.atEnd();
    push(ring, 1);
    push(ring, 2);
    Record got{};
    for (auto* cursor : {&first, &second}) {
        QVERIFY(ring.pop(*cursor, got));
        QCOMPARE(got[0], std::uint64_t(1));
        QVERIFY(ring.pop(*cursor, got));
        QCOMPARE(got[0], std::uint64_t(2));
        QVERIFY(!ring.pop(*cursor, got));
    }
}

void TestRing::cursorAtEndSeesOnlyWhatFollows() {
    BroadcastRing ring(2, 8);
    push(ring, 1);
    auto cursor = ring.atEnd();
    Record got{};
    QVERIFY(!ring.pop(cursor, got));
    push(ring, 2);
    QVERIFY(ring.pop(cursor, got));
    QCOMPARE(got[0], std::uint64_t(2));
}

void TestRing::oldestAreLostAndCounted() {
    BroadcastRing ring(2, 4);
    auto cursor = ring.atBegin();
    for (std::uint64_t i = 0; i < 11; ++i) {
        push(ring, i);
    }
    Record got{};
    for (std::uint64_t i = 7; i < 11; ++i) {
        QVERIFY(ring.pop(cursor, got));
        QCOMPARE(got[0], i);
    }
    QCOMPARE(cursor.lost, std::uint64_t(7));
    QVERIFY(!ring.pop(cursor, got));
    QCOMPARE(ring.atBegin().next, std::uint64_t(7));
}

void TestRing::nothingIsTornOrReorderedUnderContention() {
    BroadcastRing ring(2, 16);
    constexpr std::uint64_t kCount = 200000;
    std::atomic<bool> ready{false};
    std::uint64_t taken = 0;
    std::uint64_t lost = 0;
    int wrong = 0;
    std::thread consumer([&] {
        auto cursor = ring.atBegin();
        ready = true;
        Record got{};
        std::uint64_t next = 0;
        while (cursor.next < kCount) {
            if (!ring.pop(cursor, got)) {
                std::this_thread::yield();
                continue;
            }
            ++taken;
            wrong += got[1] != ~got[0] || got[0] < next ? 1 : 0;
            next = got[0] + 1;
        }
        lost = cursor.lost;
    });
    while (!ready) {
        std::this_thread::yield();
    }
    for (std::uint64_t i = 0; i < kCount; ++i) {
        push(ring, i);
        if (i % 64 == 0) {
            std::this_thread::yield();  // lets the consumer catch up now and then
        }
    }
    consumer.join();
    QCOMPARE(wrong, 0);
    // Every record was either read or counted as lost.
    QCOMPARE(taken + lost, kCount);
    QVERIFY(taken > 0);
}

QTEST_GUILESS_MAIN(TestRing)
#include "tst_ring.moc"
