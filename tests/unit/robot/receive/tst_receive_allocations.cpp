// SPDX-License-Identifier: MIT
// Neither the receive loop nor the reader of its samples allocates memory while running.
#include <QTest>
#include <atomic>
#include <thread>

#include "robot/receive/receiver.h"
#include "robot/rtde/big_endian.h"
#include "robot/rtde/fields.h"
#include "robot/rtde/values.h"
#include "tests/support/hot_threads.h"
#include "tests/support/scripted_peer.h"

using namespace tiller;
using namespace tiller::receive;
using test::ScriptedPeer;

namespace {

/// Answers the handshake, then sends `wanted` packages without allocating memory.
class Feeder {
public:
    void operator()(ScriptedPeer::Link& link) {
        rtde::Bytes package;
        while (!link.isOver()) {
            if (!package.empty()) {
                stream(link, package);
                continue;
            }
            const auto request = link.nextPackage();
            if (!request) {
                continue;
            }
            rtde::Bytes out;
            switch (request->type) {
                case rtde::PackageType::RequestProtocolVersion:
                    rtde::writeProtocolReply(out, true);
                    break;
                case rtde::PackageType::GetUrControlVersion:
                    rtde::writeVersionReply(out, {5, 22, 1, 0});
                    break;
                case rtde::PackageType::SetupOutputs: {
                    const auto asked =
                        rtde::readSetupOutputsRequest(request->payload, rtde::ProtocolVersion::V2).value();
                    types_.clear();
                    std::vector<rtde::FieldAnswer> answers;
                    for (const std::string& name : asked.names) {
                        types_.push_back(rtde::findOutput(name)->type);
                        answers.push_back(rtde::FieldAnswer::of(types_.back()));
                    }
                    rtde::writeSetupOutputsReply(out, rtde::ProtocolVersion::V2, 1, answers);
                    break;
                }
                default: {
                    rtde::writeStartReply(out, true);
                    const rtde::ValueLayout layout(types_);
                    package.resize(rtde::dataPackageSize(layout.wireBytes(), true));
                    const std::vector<double> values(layout.components(), 1.0);
                    rtde::writeDataPackage(package, 1, layout, values);
                }
            }
            link.send(out);
        }
    }

    std::atomic<int> wanted{0};

private:
    void stream(ScriptedPeer::Link& link, rtde::Bytes& package) {
        while (!link.isOver()) {
            if (sent_ < wanted) {
                ++sent_;
                // The timestamp is the first of the default fields.
                rtde::big_endian::writeDouble(&package[rtde::kHeaderSize + 1], 1.0 + sent_ * 0.002);
                link.send(package);
            } else {
                std::this_thread::yield();
            }
        }
    }

    int sent_ = 0;
    std::vector<rtde::DataType> types_;
};

}  // namespace

class TestReceiveAllocations : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void theCounterCounts();
    void receivingAllocatesNothing();
};

void TestReceiveAllocations::theCounterCounts() {
    test::watchThisThread();
    const auto before = test::hotCounts().allocations;
    test::countHotThreads(true);
    ::operator delete(::operator new(16));
    test::countHotThreads(false);
    QCOMPARE(test::hotCounts().allocations - before, 1U);
}

void TestReceiveAllocations::receivingAllocatesNothing() {
    Feeder feeder;
    ScriptedPeer peer([&](ScriptedPeer::Link& link) { feeder(link); });
    ReceiverOptions options;
    options.host = QStringLiteral("127.0.0.1");
    options.port = peer.port();
    options.priority = 0;
    Receiver receiver(options);
    Subscription subscription = receiver.subscribe();
    Sample fromRing(receiver.layout());
    Sample newest(receiver.layout());
    QVERIFY(receiver.start().ok());

    constexpr std::uint64_t kWarmUp = 50;
    feeder.wanted = static_cast<int>(kWarmUp);
    QTRY_COMPARE_WITH_TIMEOUT(receiver.counters().packets, kWarmUp, 20000);
    std::uint64_t taken = 0;
    while (subscription.next(fromRing)) {
        ++taken;
    }

    constexpr std::uint64_t kAll = 3000;
    QVERIFY(test::hotThreads() >= 1);
    const auto before = test::hotCounts().allocations;
    test::countHotThreads(true);
    feeder.wanted = static_cast<int>(kAll);
    // The subscriber must not allocate either. If packages do not arrive, the time limit of the test ends the
    // loop.
    while (taken < kAll) {
        if (subscription.next(fromRing)) {
            ++taken;
        } else {
            std::this_thread::yield();
        }
        receiver.latest(newest);
    }
    test::countHotThreads(false);
    QCOMPARE(test::hotCounts().allocations - before, 0U);
    QCOMPARE(fromRing.sequence, kAll);
    QCOMPARE(receiver.counters().lost, std::uint64_t(0));
    QCOMPARE(subscription.lost(), std::uint64_t(0));
}

QTEST_GUILESS_MAIN(TestReceiveAllocations)
#include "tst_receive_allocations.moc"
