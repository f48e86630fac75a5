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
    void recordsAreReadInOrder();
    void everyConsumerReadsEveryRecord();
    void aCursorAtTheEndReadsOnlyNewRecords();
    void overwrittenRecordsAreCounted();
    void readingTheNewestConsumesNothing();
    void aRecordIsWrittenInAnyOrder();
    void nothingIsTornOrReorderedUnderContention();
    void theNewestRecordIsConsistentUnderContention();
};

void TestRing::capacityIsRoundedUp() {
    QCOMPARE(BroadcastRing(1, 5).capacity(), std::size_t(8));
    QCOMPARE(BroadcastRing(1, 8).capacity(), std::size_t(8));
    QCOMPARE(BroadcastRing(1, 0).capacity(), std::size_t(2));
}

void TestRing::recordsAreReadInOrder() {
    BroadcastRing ring(2, 4);
    auto cursor = ring.atBegin();
    Record got{};
    QVERIFY(!ring.pop(cursor, got));
    // The writer wraps around more than once, but the reader never lags by more than the capacity.
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

void TestRing::everyConsumerReadsEveryRecord() {
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

void TestRing::aCursorAtTheEndReadsOnlyNewRecords() {
    BroadcastRing ring(2, 8);
    push(ring, 1);
    auto cursor = ring.atEnd();
    Record got{};
    QVERIFY(!ring.pop(cursor, got));
    push(ring, 2);
    QVERIFY(ring.pop(cursor, got));
    QCOMPARE(got[0], std::uint64_t(2));
}

void TestRing::overwrittenRecordsAreCounted() {
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

void TestRing::readingTheNewestConsumesNothing() {
    BroadcastRing ring(2, 4);
    Record got{7, 7};
    const auto into = [&](std::size_t i, std::uint64_t word) { got.at(i) = word; };
    QVERIFY(!ring.newest(into));
    QVERIFY((got == Record{7, 7}));
    auto cursor = ring.atBegin();
    for (std::uint64_t i = 0; i < 9; ++i) {
        push(ring, i);
        QVERIFY(ring.newest(into));
        QVERIFY((got == Record{i, ~i}));
    }
    QCOMPARE(ring.pending(cursor), std::uint64_t(9));
    QVERIFY(ring.pop(cursor, got));
    QCOMPARE(got[0], std::uint64_t(5));
}

void TestRing::aRecordIsWrittenInAnyOrder() {
    BroadcastRing ring(3, 2);
    auto cursor = ring.atEnd();
    ring.pushWith([](BroadcastRing::Slot slot) {
        slot.set(2, 30);
        slot.set(0, 10);
        slot.set(1, slot.get(0) + slot.get(2));
    });
    std::array<std::uint64_t, 3> got{};
    QVERIFY(ring.pop(cursor, got));
    QVERIFY((got == std::array<std::uint64_t, 3>{10, 40, 30}));
}

void TestRing::theNewestRecordIsConsistentUnderContention() {
    BroadcastRing ring(2, 2);
    constexpr std::uint64_t kCount = 100000;
    std::atomic<bool> over{false};
    std::thread producer([&] {
        for (std::uint64_t i = 0; i < kCount; ++i) {
            push(ring, i);
        }
        over = true;
    });
    Record got{};
    std::uint64_t before = 0;
    int wrong = 0;
    while (!over) {
        if (ring.newest([&](std::size_t i, std::uint64_t word) { got.at(i) = word; })) {
            wrong += got[1] != ~got[0] || got[0] < before ? 1 : 0;
            before = got[0];
        }
    }
    producer.join();
    QCOMPARE(wrong, 0);
    QVERIFY(ring.newest([&](std::size_t i, std::uint64_t word) { got.at(i) = word; }));
    QCOMPARE(got[0], kCount - 1);
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
            std::this_thread::yield();  // lets the consumer catch up occasionally
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
