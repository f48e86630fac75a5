// SPDX-License-Identifier: MIT
#include <QDir>
#include <QFile>
#include <QTest>
#include <atomic>
#include <memory>
#include <mutex>
#include <stdexcept>
#include <thread>

#include "robot/publish/publisher.h"
#include "tests/support/rtde_peer.h"

using namespace tiller;
using namespace tiller::publish;
using namespace std::chrono_literals;
using test::RtdePeer;

namespace {

constexpr int kWaitTimeoutMs = 60'000;
#define TRY_VERIFY(condition) QTRY_VERIFY_WITH_TIMEOUT(condition, kWaitTimeoutMs)
#define TRY_COMPARE(actual, expected) QTRY_COMPARE_WITH_TIMEOUT(actual, expected, kWaitTimeoutMs)

receive::ReceiverOptions to(std::uint16_t port) {
    receive::ReceiverOptions options;
    options.host = QStringLiteral("127.0.0.1");
    options.port = port;
    options.priority = 0;
    options.connectTimeout = 1h;
    options.silenceLimit = 1h;
    options.ringCapacity = 64;
    return options;
}

/// A sink whose behaviour the test selects.
struct FakeSink : SampleSink {
    bool mayBlock() const override { return blocks; }
    Result<void> open() override {
        ++opened;
        if (throwsWhenOpened) {
            throw std::runtime_error("no server");
        }
        return openError.code == ErrorCode::None ? Result<void>() : Result<void>(openError);
    }
    Next take(const receive::Sample& sample, std::uint64_t missing) override {
        while (isStuck) {
            std::this_thread::sleep_for(1ms);
        }
        {
            const std::lock_guard lock(mutex);
            sequences.push_back(sample.sequence);
            lastThread = std::this_thread::get_id();
        }
        lost += missing;
        if (throws) {
            throw std::runtime_error("no server");
        }
        return ++taken == endAfter ? Next::End : (taken % newTurnEvery == 0 ? Next::NewTurn : Next::Continue);
    }
    bool endTurn(bool last) override {
        ++turns;
        return !last && !fails;
    }
    void close() override { ++closed; }
    std::thread::id thread() const {
        const std::lock_guard lock(mutex);
        return lastThread;
    }

    bool blocks = false;
    bool throwsWhenOpened = false;
    std::atomic<bool> throws{false};
    Error openError;
    int endAfter = -1;
    int newTurnEvery = 1'000'000;
    std::atomic<bool> isStuck{false};
    std::atomic<bool> fails{false};
    std::atomic<int> opened{0};
    std::atomic<int> taken{0};
    std::atomic<int> turns{0};
    std::atomic<int> closed{0};
    std::atomic<std::uint64_t> lost{0};
    mutable std::mutex mutex;
    std::vector<std::uint64_t> sequences;
    std::thread::id lastThread;
};

/// The threads of this process with this name.
int threadsNamed(const QByteArray& name) {
    int count = 0;
    for (const QString& id :
         QDir(QStringLiteral("/proc/self/task")).entryList(QDir::Dirs | QDir::NoDotAndDotDot)) {
        QFile file(QStringLiteral("/proc/self/task/%1/comm").arg(id));
        count += file.open(QIODevice::ReadOnly) && file.readAll().trimmed() == name ? 1 : 0;
    }
    return count;
}

/// A receiver connected to a peer, with a small ring buffer.
struct Bench {
    Bench() : receiver(to(peer.port())) { receiver.start().value(); }

    std::shared_ptr<FakeSink> sink() const { return std::make_shared<FakeSink>(); }
    Result<Publication> add(const std::shared_ptr<FakeSink>& to) {
        return publisher.add({to, receiver.subscribe(), receiver.layout(), 5ms});
    }
    void send(int count) {
        for (int i = 0; i < count; ++i) {
            peer.send(++sent * 0.002);
        }
        TRY_COMPARE(receiver.counters().packets, static_cast<std::uint64_t>(sent));
    }

    RtdePeer peer;
    receive::Receiver receiver;
    Publisher publisher;
    int sent = 0;
};

}  // namespace

class TestPublisher : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void everySinkTakesEverySample() {
        Bench bench;
        const auto first = bench.sink();
        const auto second = bench.sink();
        second->blocks = true;
        second->newTurnEvery = 7;
        auto one = bench.add(first).value();
        auto two = bench.add(second).value();
        bench.send(50);
        one.stop();
        two.stop();
        for (const auto& sink : {first, second}) {
            QCOMPARE(sink->taken.load(), 50);
            QCOMPARE(sink->lost.load(), std::uint64_t(0));
            QCOMPARE(sink->opened.load(), 1);
            QCOMPARE(sink->closed.load(), 1);
            for (std::size_t i = 1; i < sink->sequences.size(); ++i) {
                QCOMPARE(sink->sequences[i], sink->sequences[i - 1] + 1);
            }
        }
        QCOMPARE(one.packets(), std::uint64_t(50));
        QCOMPARE(one.missed(), std::uint64_t(0));
    }

    void aBlockedSinkLosesOnlyItsOwnSamples() {
        Bench bench;
        const auto stuck = bench.sink();
        const auto file = bench.sink();
        const auto live = bench.sink();
        stuck->blocks = file->blocks = true;
        auto first = bench.add(stuck).value();
        auto second = bench.add(file).value();
        auto third = bench.add(live).value();
        bench.send(1);
        TRY_COMPARE(stuck->taken.load(), 1);
        stuck->isStuck = true;
        // Four times the ring buffer, in parts that the other sinks can take.
        for (int sent = 1; sent < 257; sent += 32) {
            bench.send(32);
            TRY_COMPARE(file->taken.load(), sent + 32);
            TRY_COMPARE(live->taken.load(), sent + 32);
        }
        QCOMPARE(stuck->taken.load(), 1);
        stuck->isStuck = false;
        bench.send(1);
        TRY_VERIFY(stuck->taken > 2);
        first.stop();
        QVERIFY(stuck->lost > 100);
        QCOMPARE(first.missed(), stuck->lost.load());
        QCOMPARE(static_cast<std::uint64_t>(stuck->taken) + stuck->lost, std::uint64_t(258));
        second.stop();
        third.stop();
        for (const auto& sink : {file, live}) {
            QCOMPARE(sink->taken.load(), 258);
            QCOMPARE(sink->lost.load(), std::uint64_t(0));
        }
    }

    void aFailedSinkEndsAlone() {
        Bench bench;
        const auto failing = bench.sink();
        const auto done = bench.sink();
        const auto other = bench.sink();
        done->endAfter = 3;
        auto first = bench.add(failing).value();
        auto second = bench.add(done).value();
        auto third = bench.add(other).value();
        failing->fails = true;
        TRY_COMPARE(failing->closed.load(), 1);
        bench.send(10);
        TRY_COMPARE(other->taken.load(), 10);
        TRY_COMPARE(done->closed.load(), 1);
        QCOMPARE(done->taken.load(), 3);
        QCOMPARE(failing->taken.load(), 0);
        first.stop();
        second.stop();
        QCOMPARE(failing->closed.load(), 1);
        QCOMPARE(done->closed.load(), 1);
    }

    // Sinks written by users may throw exceptions.
    void anExceptionEndsOnlyItsSink() {
        Bench bench;
        const auto failing = bench.sink();
        const auto blocking = bench.sink();
        const auto other = bench.sink();
        blocking->blocks = true;
        failing->throws = blocking->throws = true;
        auto first = bench.add(failing).value();
        auto second = bench.add(blocking).value();
        auto third = bench.add(other).value();
        bench.send(10);
        TRY_COMPARE(other->taken.load(), 10);
        first.stop();
        second.stop();
        QCOMPARE(failing->sequences.size(), std::size_t(1));
        QCOMPARE(blocking->sequences.size(), std::size_t(1));
        const auto unopened = bench.sink();
        unopened->throwsWhenOpened = true;
        const auto added = bench.add(unopened);
        QVERIFY(!added);
        QVERIFY(added.error().toString().contains("no server"));
    }

    void aSinkThatCannotOpenIsRefused() {
        Bench bench;
        const auto sink = bench.sink();
        sink->openError = {ErrorCode::AddressInvalid, QStringLiteral("listen"), {}};
        const auto added = bench.add(sink);
        QVERIFY(!added);
        QCOMPARE(added.error().code, ErrorCode::AddressInvalid);
        QCOMPARE(sink->turns.load(), 0);
        QCOMPARE(sink->closed.load(), 0);
    }

    void sinksShareThreads() {
#ifndef Q_OS_LINUX
        QSKIP("requires /proc to count threads");
#endif
        Bench bench;
        QCOMPARE(threadsNamed("tiller-publish"), 0);
        std::vector<std::shared_ptr<FakeSink>> sinks;
        std::vector<Publication> publications;
        for (int i = 0; i < 8; ++i) {
            sinks.push_back(bench.sink());
            sinks.back()->blocks = i >= 4;
            publications.push_back(bench.add(sinks.back()).value());
        }
        bench.send(20);
        for (const auto& sink : sinks) {
            TRY_COMPARE(sink->taken.load(), 20);
        }
        for (int i = 0; i < 4; ++i) {
            QVERIFY(sinks[static_cast<std::size_t>(i)]->thread() == sinks.front()->thread());
            QVERIFY(sinks[static_cast<std::size_t>(i + 4)]->thread() != sinks.front()->thread());
        }
        QCOMPARE(threadsNamed("tiller-publish"), 1);
        // On a busy machine, there may temporarily be more file threads. Idle threads end.
        TRY_COMPARE(threadsNamed("tiller-files"), 1);
    }

    void aPublisherOfOneSinkNeedsOneThread() {
#ifndef Q_OS_LINUX
        QSKIP("requires /proc to count threads");
#endif
        Bench bench;
        Publisher publisher(Publisher::Sinks::One);
        const auto sink = bench.sink();
        sink->blocks = true;
        auto publication =
            publisher.add({sink, bench.receiver.subscribe(), bench.receiver.layout(), 5ms}).value();
        bench.send(5);
        TRY_COMPARE(sink->taken.load(), 5);
        QCOMPARE(threadsNamed("tiller-publish"), 1);
        QCOMPARE(threadsNamed("tiller-files"), 0);
    }

    void endingThePublisherEndsItsSinks() {
        Bench bench;
        const auto sink = bench.sink();
        const auto file = bench.sink();
        file->blocks = true;
        Publication publication, other;
        {
            Publisher publisher;
            publication = publisher.add({sink, bench.receiver.subscribe(), bench.receiver.layout()}).value();
            other = publisher.add({file, bench.receiver.subscribe(), bench.receiver.layout()}).value();
            bench.send(5);
        }
        QCOMPARE(sink->taken.load(), 5);
        QCOMPARE(sink->closed.load(), 1);
        QCOMPARE(file->taken.load(), 5);
        QCOMPARE(file->closed.load(), 1);
        publication.stop();
        QCOMPARE(publication.packets(), std::uint64_t(5));
    }
};

QTEST_GUILESS_MAIN(TestPublisher)
#include "tst_publisher.moc"
