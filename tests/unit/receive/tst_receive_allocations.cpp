// SPDX-License-Identifier: MIT
// The receive loop allocates nothing once it runs. This program counts every allocation of every thread, so
// its own threads are careful not to make any while it counts.
#include <QTest>
#include <atomic>
#include <cstdlib>
#include <new>
#include <thread>

#include "robot/receive/receiver.h"
#include "robot/rtde/big_endian.h"
#include "robot/rtde/fields.h"
#include "tests/support/scripted_peer.h"

namespace {

std::atomic<bool> counting{false};
std::atomic<long> allocations{0};

void* counted(std::size_t size) {
    if (counting.load(std::memory_order_relaxed)) {
        allocations.fetch_add(1, std::memory_order_relaxed);
    }
    void* memory = std::malloc(size == 0 ? 1 : size);
    if (memory == nullptr) {
        throw std::bad_alloc();
    }
    return memory;
}

}  // namespace

void* operator new(std::size_t size) {
    return counted(size);
}
void* operator new[](std::size_t size) {
    return counted(size);
}
void operator delete(void* memory) noexcept {
    std::free(memory);
}
void operator delete[](void* memory) noexcept {
    std::free(memory);
}
void operator delete(void* memory, std::size_t) noexcept {
    std::free(memory);
}
void operator delete[](void* memory, std::size_t) noexcept {
    std::free(memory);
}

using namespace tiller;
using namespace tiller::receive;
using test::ScriptedPeer;

namespace {

/// Answers the handshake, then sends as many packages as `wanted` says, without allocating.
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
                // The time stamp comes first in the default fields.
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
    counting = true;
    const auto before = allocations.load();
    auto* volatile thing = new int(1);
    delete thing;
    counting = false;
    QCOMPARE(allocations.load() - before, 1L);
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
    receiver.start();

    constexpr std::uint64_t kWarmUp = 50;
    feeder.wanted = static_cast<int>(kWarmUp);
    QTRY_COMPARE_WITH_TIMEOUT(receiver.counters().packets, kWarmUp, 20000);
    std::uint64_t taken = 0;
    while (subscription.next(fromRing)) {
        ++taken;
    }

    constexpr std::uint64_t kAll = 3000;
    allocations = 0;
    counting = true;
    feeder.wanted = static_cast<int>(kAll);
    // The subscriber's side is under the same rule. Ended by the test's time limit if packages stay away.
    while (taken < kAll) {
        if (subscription.next(fromRing)) {
            ++taken;
        } else {
            std::this_thread::yield();
        }
        receiver.latest(newest);
    }
    counting = false;
    QCOMPARE(allocations.load(), 0L);
    QCOMPARE(fromRing.sequence, kAll);
    QCOMPARE(receiver.counters().lost, std::uint64_t(0));
    QCOMPARE(subscription.lost(), std::uint64_t(0));
}

QTEST_GUILESS_MAIN(TestReceiveAllocations)
#include "tst_receive_allocations.moc"
