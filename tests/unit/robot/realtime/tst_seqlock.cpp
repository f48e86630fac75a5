// SPDX-License-Identifier: MIT
#include <QTest>
#include <array>
#include <atomic>
#include <thread>

#include "robot/realtime/seqlock.h"

using namespace tiller::realtime;

class TestSeqlock : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void readsWhatWasWritten();
    void startsWithZeros();
    void versionCountsWrites();
    void readersNeverSeeATornValue();
    void holdsAnyTrivialType();
};

void TestSeqlock::readsWhatWasWritten() {
    WordSeqlock lock(3);
    lock.write(std::array<std::uint64_t, 3>{1, 2, ~0ULL});
    std::array<std::uint64_t, 3> got{};
    QCOMPARE(lock.read(got), std::uint64_t(1));
    QVERIFY((got == std::array<std::uint64_t, 3>{1, 2, ~0ULL}));
}

void TestSeqlock::startsWithZeros() {
    const WordSeqlock lock(2);
    std::array<std::uint64_t, 2> got{7, 7};
    QCOMPARE(lock.read(got), std::uint64_t(0));
    QVERIFY((got == std::array<std::uint64_t, 2>{0, 0}));
}

void TestSeqlock::versionCountsWrites() {
    WordSeqlock lock(1);
    for (std::uint64_t i = 1; i <= 5; ++i) {
        lock.write(std::array{i});
        QCOMPARE(lock.version(), i);
    }
}

void TestSeqlock::readersNeverSeeATornValue() {
    constexpr std::size_t kWords = 64;
    WordSeqlock lock(kWords);
    std::atomic<bool> done{false};
    std::atomic<int> mixtures{0};
    std::atomic<int> backward{0};
    std::atomic<int> running{0};
    const auto reader = [&] {
        std::array<std::uint64_t, kWords> got{};
        std::uint64_t last = 0;
        ++running;
        while (!done) {
            lock.read(got);
            for (const std::uint64_t word : got) {
                mixtures += word != got[0] ? 1 : 0;
            }
            backward += got[0] < last ? 1 : 0;
            last = got[0];
        }
    };
    std::thread first(reader);
    std::thread second(reader);
    while (running < 2) {
        std::this_thread::yield();
    }
    std::array<std::uint64_t, kWords> values{};
    for (std::uint64_t i = 1; i <= 50000; ++i) {
        values.fill(i);
        lock.write(values);
    }
    done = true;
    first.join();
    second.join();
    QCOMPARE(mixtures.load(), 0);
    QCOMPARE(backward.load(), 0);
}

void TestSeqlock::holdsAnyTrivialType() {
    struct Odd {
        double a = 0;
        char b = 0;
        int c[3] = {};
    };
    Seqlock<Odd> lock({1.5, 'x', {1, 2, 3}});
    QCOMPARE(lock.load().b, 'x');
    lock.store({2.5, 'y', {4, 5, 6}});
    const Odd got = lock.load();
    QCOMPARE(got.a, 2.5);
    QCOMPARE(got.c[2], 6);
}

QTEST_GUILESS_MAIN(TestSeqlock)
#include "tst_seqlock.moc"
