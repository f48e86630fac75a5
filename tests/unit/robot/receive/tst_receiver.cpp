// SPDX-License-Identifier: MIT
#include <QTest>
#include <algorithm>
#include <cmath>
#include <future>
#include <limits>

#include "robot/receive/receiver.h"
#include "robot/receive/robot_state.h"
#include "tests/support/rtde_peer.h"

using namespace tiller;
using namespace tiller::receive;
using namespace std::chrono_literals;
using test::RtdePeer;
using test::ScriptedPeer;

namespace {

// Only a failing test reaches this timeout.
constexpr int kWaitTimeoutMs = 20000;
#define TRY_VERIFY(condition) QTRY_VERIFY_WITH_TIMEOUT(condition, kWaitTimeoutMs)
#define TRY_COMPARE(actual, expected) QTRY_COMPARE_WITH_TIMEOUT(actual, expected, kWaitTimeoutMs)

ReceiverOptions to(std::uint16_t port) {
    ReceiverOptions options;
    options.host = QStringLiteral("127.0.0.1");
    options.port = port;
    options.priority = 0;
    options.reconnectDelays = {1ms};
    // Too long to expire, even if a thread is scheduled late.
    options.connectTimeout = 1h;
    options.silenceLimit = 1h;
    return options;
}

bool fetch(Subscription& subscription, Sample& sample) {
    return QTest::qWaitFor([&] { return subscription.pending() > 0; }, kWaitTimeoutMs) &&
           subscription.next(sample);
}

std::uint16_t portNobodyListensOn() {
    QTcpServer server;
    server.listen(QHostAddress::LocalHost);
    return server.serverPort();
}

}  // namespace

class TestReceiver : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void publishesEveryPackageOnceInOrder();
    void latestIsTheNewest();
    void noDataExistBeforeTheFirstPackage();
    void unknownNamesAreRefused();
    void waitsForData();
    void waitingForDataReportsWhyNoneArrived();
    void waitingForDataRequiresFreshData();
    void waitingForDataSurvivesAControllerRestart();
    void subscribersWaitForTheNextSample();
    void waitingEndsWithTheReceiver();
    void samplesCarryTheClocksTime();
    void backlogSamplesAreNotFresh();
    void dataResumeWithinTwoSeconds();
    void countsSkippedPackages();
    void countsLatePackages();
    void unsupportedFieldsAreAbsent();
    void addsTheTimestamp();
    void worksWithCb3();
    void reconnectsAutomatically();
    void reconnectsAfterGarbage();
    void closesASilentConnection();
    void waitsLongerAfterEveryFailure();
    void countersCanBeReset();
    void aSlowSubscriberLosesOnlyTheOldestSamples();
    void subscriptionOutlivesTheReceiver();
    void startsAgainAfterStop();
    void stopsPromptly_data();
    void stopsPromptly();
};

void TestReceiver::publishesEveryPackageOnceInOrder() {
    RtdePeer peer;
    Receiver receiver(to(peer.port()));
    Subscription first = receiver.subscribe();
    Subscription second = receiver.subscribe();
    QVERIFY(receiver.start().ok());
    for (int i = 1; i <= 500; ++i) {
        peer.send(i * 0.002);
    }
    for (Subscription* subscription : {&first, &second}) {
        Sample sample;
        for (int i = 1; i <= 500; ++i) {
            QVERIFY(fetch(*subscription, sample));
            QCOMPARE(sample.sequence, std::uint64_t(i));
            QCOMPARE(sample.lostBefore, std::uint64_t(0));
            QCOMPARE(sample.connection, std::uint64_t(1));
            QCOMPARE(RobotState(sample).timestamp(), i * 0.002);
        }
        QVERIFY(!subscription->next(sample));
        QCOMPARE(subscription->lost(), std::uint64_t(0));
    }
    TRY_COMPARE(receiver.counters().packets, std::uint64_t(500));
    QCOMPARE(receiver.counters().lost, std::uint64_t(0));
    QCOMPARE(receiver.version().major, 5U);
    QCOMPARE(receiver.period(), 0.002);
    QCOMPARE(receiver.lastError().code, ErrorCode::None);
}

void TestReceiver::latestIsTheNewest() {
    RtdePeer peer;
    peer.set("actual_q", {1, 2, 3, 4, 5, 6});
    Receiver receiver(to(peer.port()));
    QVERIFY(receiver.start().ok());
    peer.send(1.0);
    TRY_COMPARE(receiver.latest().sequence, std::uint64_t(1));
    peer.set("actual_q", {6, 5, 4, 3, 2, 1});
    peer.send(1.002);
    TRY_COMPARE(receiver.latest().sequence, std::uint64_t(2));
    const Sample sample = receiver.latest();
    QCOMPARE(RobotState(sample).q()[0], 6.0);
}

void TestReceiver::noDataExistBeforeTheFirstPackage() {
    Receiver receiver(to(1));
    QCOMPARE(receiver.state(), ReceiverState::Stopped);
    const Sample sample = receiver.latest();
    QVERIFY(sample.isEmpty());
    QVERIFY(!RobotState(sample).has("actual_q"));
    QVERIFY(std::isnan(RobotState(sample).q()[0]));
    QCOMPARE(receiver.ageNs(), std::numeric_limits<std::int64_t>::max());
    QVERIFY(!receiver.isFresh(1h));
    QCOMPARE(receiver.counters().rateHz, 0.0);
}

void TestReceiver::unknownNamesAreRefused() {
    RtdePeer peer;
    ReceiverOptions options = to(peer.port());
    options.fields = {"timestamp", "actual_qq", "actual_q", "target_Q_"};
    Receiver receiver(options);
    const auto started = receiver.start();
    QCOMPARE(started.error().code, ErrorCode::FieldUnknown);
    QVERIFY(started.error().toString().contains("\"actual_qq\": did you mean \"actual_q\"?"));
    QVERIFY(started.error().toString().contains("\"target_Q_\": did you mean \"target_q\"?"));
    QCOMPARE(receiver.state(), ReceiverState::Stopped);
    QCOMPARE(receiver.lastError().code, ErrorCode::FieldUnknown);
    QCOMPARE(receiver.waitForData(Deadline::after(1h)).error().code, ErrorCode::NotConnected);
    QCOMPARE(Receiver({}).start().error().code, ErrorCode::InvalidArgument);  // no host
}

void TestReceiver::waitsForData() {
    RtdePeer peer;
    peer.set("actual_q", {1, 2, 3, 4, 5, 6});
    Receiver receiver(to(peer.port()));
    QCOMPARE(receiver.waitForData(Deadline::after(1h)).error().code, ErrorCode::NotConnected);
    QVERIFY(receiver.start().ok());
    auto waiting = std::async(std::launch::async, [&] { return receiver.waitForData(Deadline::after(60s)); });
    peer.send(1.0);
    const auto sample = waiting.get();
    QVERIFY2(sample.ok(), qPrintable(sample.error().toString()));
    QCOMPARE(sample->sequence, std::uint64_t(1));
    QCOMPARE(RobotState(*sample).q()[5], 6.0);
}

void TestReceiver::waitingForDataReportsWhyNoneArrived() {
    Receiver refused(to(portNobodyListensOn()));
    QVERIFY(refused.start().ok());
    TRY_VERIFY(refused.state() == ReceiverState::Waiting);
    // No server has ever listened on this port. waitForData() fails immediately unless OnRefusal::Wait is
    // given.
    QCOMPARE(refused.waitForData(Deadline::never()).error().code, ErrorCode::ConnectionRefused);
    QCOMPARE(refused.waitForData(Deadline::after(1ms), OnRefusal::Wait).error().code,
             ErrorCode::ConnectionRefused);
    const CancelToken whileWaiting;
    auto waiting = std::async(std::launch::async, [&] {
        return refused.waitForData(Deadline::after(1h, whileWaiting), OnRefusal::Wait);
    });
    QVERIFY(waiting.wait_for(50ms) == std::future_status::timeout);
    whileWaiting.cancel();
    QCOMPARE(waiting.get().error().code, ErrorCode::Cancelled);
    ReceiverOptions nowhere;
    nowhere.host = QStringLiteral("no host");
    Receiver unresolved(nowhere);
    QVERIFY(unresolved.start().ok());
    QCOMPARE(unresolved.waitForData(Deadline::never()).error().code, ErrorCode::AddressInvalid);
    Subscription subscription = refused.subscribe();
    const Error error = subscription.next(Deadline::after(1ms)).error();
    QCOMPARE(error.code, ErrorCode::Timeout);
    QVERIFY(error.toString().contains("ConnectionRefused"));

    RtdePeer silent;
    Receiver receiver(to(silent.port()));
    QVERIFY(receiver.start().ok());
    TRY_VERIFY(silent.isStarted());
    QCOMPARE(receiver.waitForData(Deadline::after(1ms)).error().code, ErrorCode::Timeout);
    const CancelToken token;
    token.cancel();
    QCOMPARE(receiver.waitForData(Deadline::after(1h, token)).error().code, ErrorCode::Cancelled);
}

void TestReceiver::waitingForDataRequiresFreshData() {
    VirtualClock clock;
    RtdePeer peer;
    ReceiverOptions options = to(peer.port());
    options.clock = &clock;
    Receiver receiver(options);
    QVERIFY(receiver.start().ok());
    peer.send(1.0);
    QVERIFY(receiver.waitForData(Deadline::after(60s)).ok());
    clock.advanceNs(101 * kNsPerMs);
    QCOMPARE(receiver.waitForData(Deadline::after(1ms)).error().code, ErrorCode::Timeout);
    peer.send(1.101);
    const auto sample = receiver.waitForData(Deadline::after(60s));
    QVERIFY(sample.ok());
    QCOMPARE(sample->sequence, std::uint64_t(2));
    // A sample of a closed connection does not describe the current state, even if it is recent.
    peer.closeConnection();
    TRY_VERIFY(receiver.state() == ReceiverState::Waiting);
    QVERIFY(!receiver.waitForData(Deadline::after(1ms)).ok());
}

void TestReceiver::waitingForDataSurvivesAControllerRestart() {
    auto peer = std::make_unique<RtdePeer>();
    ReceiverOptions options = to(peer->port());
    options.reconnectDelays = {1ms};
    Receiver receiver(options);
    QVERIFY(receiver.start().ok());
    peer->send(1.0);
    QVERIFY(receiver.waitForData(Deadline::after(60s)).ok());
    peer.reset();
    TRY_VERIFY(receiver.lastError().code == ErrorCode::ConnectionRefused);
    QVERIFY(receiver.waitForData(Deadline::after(50ms)).error().code == ErrorCode::ConnectionRefused);
    const CancelToken token;
    auto waiting =
        std::async(std::launch::async, [&] { return receiver.waitForData(Deadline::after(1h, token)); });
    QVERIFY(waiting.wait_for(50ms) == std::future_status::timeout);
    token.cancel();
    QCOMPARE(waiting.get().error().code, ErrorCode::Cancelled);
}

void TestReceiver::subscribersWaitForTheNextSample() {
    constexpr int kPackages = 200;
    RtdePeer peer;
    Receiver receiver(to(peer.port()));
    Subscription first = receiver.subscribe();
    Subscription second = receiver.subscribe();
    QVERIFY(receiver.start().ok());
    const auto count = [](Subscription& subscription) {
        Sample sample;
        for (std::uint64_t i = 1; i <= kPackages; ++i) {
            if (!subscription.next(sample, Deadline::after(60s)) || sample.sequence != i) {
                return i;
            }
        }
        return std::uint64_t(0);
    };
    auto one = std::async(std::launch::async, [&] { return count(first); });
    auto other = std::async(std::launch::async, [&] { return count(second); });
    for (int i = 1; i <= kPackages; ++i) {
        peer.send(i * 0.002);
        std::this_thread::yield();
    }
    QCOMPARE(one.get(), std::uint64_t(0));
    QCOMPARE(other.get(), std::uint64_t(0));
    QCOMPARE(first.next(Deadline::after(1ms)).error().code, ErrorCode::Timeout);
}

void TestReceiver::waitingEndsWithTheReceiver() {
    RtdePeer peer;
    auto receiver = std::make_unique<Receiver>(to(peer.port()));
    QVERIFY(receiver->start().ok());
    Subscription subscription = receiver->subscribe();
    auto waiting =
        std::async(std::launch::async, [&] { return subscription.next(Deadline::never()).error().code; });
    receiver.reset();
    QCOMPARE(waiting.get(), ErrorCode::NotConnected);
    QCOMPARE(Subscription().next(Deadline::never()).error().code, ErrorCode::NotConnected);
}

void TestReceiver::samplesCarryTheClocksTime() {
    VirtualClock clock(5 * kNsPerSecond);
    RtdePeer peer;
    ReceiverOptions options = to(peer.port());
    options.clock = &clock;
    Receiver receiver(options);
    QVERIFY(receiver.start().ok());
    peer.send(1.0);
    TRY_COMPARE(receiver.latest().sequence, std::uint64_t(1));
    QCOMPARE(receiver.latest().hostTimeNs, 5 * kNsPerSecond);
    TRY_COMPARE(receiver.ageNs(), std::int64_t(0));
    QVERIFY(receiver.isFresh(0ns));
    clock.advanceNs(300 * kNsPerMs);
    QCOMPARE(receiver.ageNs(), 300 * kNsPerMs);
    QVERIFY(receiver.isFresh(300ms));
    QVERIFY(!receiver.isFresh(299ms));
}

// After the host was suspended or the connection was blocked, the age of a sample counts from its controller
// time, not from its arrival.
void TestReceiver::backlogSamplesAreNotFresh() {
    VirtualClock clock;
    RtdePeer peer;
    ReceiverOptions options = to(peer.port());
    options.clock = &clock;
    Receiver receiver(options);
    QVERIFY(receiver.start().ok());
    std::uint64_t sent = 0;
    const auto send = [&](double timestamp) {
        peer.send(timestamp);
        ++sent;
        TRY_COMPARE(receiver.latest().sequence, sent);
    };
    for (int i = 0; i < 10; ++i) {
        send(1 + 0.002 * i);
        TRY_COMPARE(receiver.ageNs(), std::int64_t(0));
        clock.advanceNs(2 * kNsPerMs);
    }
    clock.advanceNs(1000 * kNsPerMs);
    send(1.02);  // sent one second late
    TRY_VERIFY(std::llabs(receiver.ageNs() - 1000 * kNsPerMs) < kNsPerMs);
    QVERIFY(!receiver.isFresh(100ms));
    send(1.92);
    TRY_VERIFY(std::llabs(receiver.ageNs() - 100 * kNsPerMs) < kNsPerMs);
    send(2.02);
    TRY_VERIFY(receiver.isFresh(1ms));
}

// The connection can become available again at any time during an attempt or during the wait after it. The
// worst case is one failed attempt, one wait and the next attempt.
void TestReceiver::dataResumeWithinTwoSeconds() {
    const ReceiverOptions options;
    const auto longest = *std::max_element(options.reconnectDelays.begin(), options.reconnectDelays.end());
    QVERIFY(options.connectTimeout + longest < 2s);
}

void TestReceiver::countsSkippedPackages() {
    RtdePeer peer;
    Receiver receiver(to(peer.port()));
    Subscription subscription = receiver.subscribe();
    QVERIFY(receiver.start().ok());
    for (const double timestamp : {1.000, 1.002, 1.010, 1.012, 1.016}) {
        peer.send(timestamp);
    }
    TRY_COMPARE(receiver.counters().packets, std::uint64_t(5));
    TRY_COMPARE(receiver.counters().lost, std::uint64_t(4));
    const std::uint64_t expected[] = {0, 0, 3, 0, 1};
    Sample sample;
    for (const std::uint64_t lost : expected) {
        QVERIFY(fetch(subscription, sample));
        QCOMPARE(sample.lostBefore, lost);
    }
}

void TestReceiver::countsLatePackages() {
    VirtualClock clock;
    RtdePeer peer;
    ReceiverOptions options = to(peer.port());
    options.clock = &clock;
    Receiver receiver(options);
    QVERIFY(receiver.start().ok());
    const auto sendAfter = [&](std::int64_t ns, double timestamp, std::uint64_t number) {
        clock.advanceNs(ns);
        peer.send(timestamp);
        TRY_COMPARE(receiver.counters().packets, number);
    };
    sendAfter(0, 1.000, 1);
    sendAfter(2 * kNsPerMs, 1.002, 2);
    QCOMPARE(receiver.counters().late, std::uint64_t(0));
    sendAfter(4 * kNsPerMs, 1.004, 3);
    TRY_COMPARE(receiver.counters().late, std::uint64_t(1));
    sendAfter(0, 1.006, 4);
    QCOMPARE(receiver.counters().late, std::uint64_t(1));
    receiver.stop();
    QCOMPARE(receiver.intervals().count(), std::uint64_t(3));
    QCOMPARE(receiver.intervals().maxNs(), 4 * kNsPerMs);
}

void TestReceiver::unsupportedFieldsAreAbsent() {
    test::RtdePeerOptions robot;
    robot.missing = {"ft_raw_wrench", "payload", "output_int_register_36"};
    RtdePeer peer(robot);
    peer.set("actual_qd", {1, 1, 1, 1, 1, 1});
    peer.set("payload_cog", {7, 8, 9});
    Receiver receiver(to(peer.port()));
    QVERIFY(receiver.start().ok());
    peer.send(1.0);
    TRY_COMPARE(receiver.latest().sequence, std::uint64_t(1));
    const Sample sample = receiver.latest();
    const RobotState state(sample);
    QVERIFY(!state.has("ft_raw_wrench"));
    QVERIFY(!state.has("payload"));
    QVERIFY(state.has("actual_q"));
    // The fields after the gaps keep their positions.
    QCOMPARE(state.payloadCentreOfGravity().z(), 9.0);
    QCOMPARE(state.qd()[5], 1.0);
    QCOMPARE(receiver.absentFields().size(), std::size_t(3));
}

void TestReceiver::addsTheTimestamp() {
    RtdePeer peer;
    ReceiverOptions options = to(peer.port());
    options.fields = {"actual_q"};
    Receiver receiver(options);
    QVERIFY(receiver.start().ok());
    peer.send(2.5);
    TRY_COMPARE(receiver.latest().sequence, std::uint64_t(1));
    QCOMPARE(peer.outputs().names, (std::vector<std::string>{"timestamp", "actual_q"}));
    const Sample sample = receiver.latest();
    QCOMPARE(RobotState(sample).timestamp(), 2.5);
}

void TestReceiver::worksWithCb3() {
    for (const int protocol : {1, 2}) {
        test::RtdePeerOptions robot;
        robot.version = {3, 15, 8, 0};
        robot.highestProtocol = protocol;
        RtdePeer peer(robot);
        Receiver receiver(to(peer.port()));
        QVERIFY(receiver.start().ok());
        for (const double timestamp : {1.0, 1.008, 1.024}) {
            peer.send(timestamp);
        }
        TRY_COMPARE(receiver.counters().packets, std::uint64_t(3));
        QCOMPARE(receiver.period(), 0.008);
        TRY_COMPARE(receiver.counters().lost, std::uint64_t(1));
    }
}

void TestReceiver::reconnectsAutomatically() {
    RtdePeer peer;
    Receiver receiver(to(peer.port()));
    Subscription subscription = receiver.subscribe();
    QVERIFY(receiver.start().ok());
    peer.send(1.000);
    TRY_COMPARE(receiver.counters().packets, std::uint64_t(1));
    peer.closeConnection();
    TRY_COMPARE(peer.connections(), 2);
    TRY_VERIFY(peer.isStarted());
    peer.send(2.000);
    TRY_COMPARE(receiver.counters().packets, std::uint64_t(2));
    QCOMPARE(receiver.counters().reconnects, std::uint64_t(1));
    QCOMPARE(receiver.state(), ReceiverState::Receiving);
    QCOMPARE(receiver.lastError().code, ErrorCode::None);
    Sample sample;
    QVERIFY(fetch(subscription, sample));
    QVERIFY(fetch(subscription, sample));
    QCOMPARE(sample.connection, std::uint64_t(2));
    QCOMPARE(sample.sequence, std::uint64_t(2));
    // The timestamps show how many samples were lost in the interruption. The controller did not skip any.
    QCOMPARE(sample.lostBefore, std::uint64_t(499));
    QCOMPARE(receiver.counters().lost, std::uint64_t(0));
}

void TestReceiver::reconnectsAfterGarbage() {
    RtdePeer peer;
    Receiver receiver(to(peer.port()));
    QVERIFY(receiver.start().ok());
    peer.send(1.000);
    TRY_COMPARE(receiver.counters().packets, std::uint64_t(1));
    peer.sendRaw({0, 2, 0});
    TRY_COMPARE(receiver.counters().reconnects, std::uint64_t(1));
    TRY_VERIFY(peer.isStarted());
    peer.send(1.002);
    TRY_COMPARE(receiver.counters().packets, std::uint64_t(2));
}

void TestReceiver::closesASilentConnection() {
    VirtualClock clock;
    RtdePeer peer;
    ReceiverOptions options = to(peer.port());
    options.clock = &clock;
    options.silenceLimit = 2500ms;
    Receiver receiver(options);
    QVERIFY(receiver.start().ok());
    peer.send(1.0);
    TRY_COMPARE(receiver.counters().packets, std::uint64_t(1));
    // While the clock is stopped, no connection times out, even if the test takes long.
    clock.advanceNs(2400 * kNsPerMs);
    QTest::qWait(120);
    QCOMPARE(peer.connections(), 1);
    clock.advanceNs(200 * kNsPerMs);
    TRY_COMPARE(receiver.state(), ReceiverState::Waiting);
    // Advances the clock repeatedly, because the start of the receiver's 1 ms wait is unknown.
    TRY_VERIFY((clock.advanceNs(kNsPerMs), peer.connections() == 2));
}

void TestReceiver::waitsLongerAfterEveryFailure() {
    ReceiverOptions options = to(portNobodyListensOn());
    // The second wait does not expire within the test; stop() ends it.
    options.reconnectDelays = {1ms, 1h};
    Receiver receiver(options);
    QVERIFY(receiver.start().ok());
    TRY_COMPARE(receiver.state(), ReceiverState::Waiting);
    TRY_COMPARE(receiver.lastError().code, ErrorCode::ConnectionRefused);
    QVERIFY(receiver.lastError().context.contains(QString::number(options.port)));
    receiver.stop();
    QCOMPARE(receiver.state(), ReceiverState::Stopped);
}

void TestReceiver::countersCanBeReset() {
    RtdePeer peer;
    Receiver receiver(to(peer.port()));
    QVERIFY(receiver.start().ok());
    peer.send(1.000);
    peer.send(1.100);
    TRY_COMPARE(receiver.counters().packets, std::uint64_t(2));
    TRY_VERIFY(receiver.counters().lost > 0);
    receiver.resetCounters();
    peer.send(1.102);
    TRY_COMPARE(receiver.latest().sequence, std::uint64_t(3));
    TRY_COMPARE(receiver.counters().packets, std::uint64_t(1));
    QCOMPARE(receiver.counters().lost, std::uint64_t(0));
}

void TestReceiver::aSlowSubscriberLosesOnlyTheOldestSamples() {
    RtdePeer peer;
    ReceiverOptions options = to(peer.port());
    options.ringCapacity = 64;
    Receiver receiver(options);
    Subscription subscription = receiver.subscribe();
    QVERIFY(receiver.start().ok());
    for (int i = 1; i <= 200; ++i) {
        peer.send(i * 0.002);
    }
    TRY_COMPARE(subscription.pending(), std::uint64_t(200));
    Sample sample;
    for (std::uint64_t i = 137; i <= 200; ++i) {
        QVERIFY(subscription.next(sample));
        QCOMPARE(sample.sequence, i);
    }
    QVERIFY(!subscription.next(sample));
    QCOMPARE(subscription.lost(), std::uint64_t(136));
}

void TestReceiver::subscriptionOutlivesTheReceiver() {
    Subscription subscription;
    Sample sample;
    QVERIFY(!subscription.next(sample));
    QVERIFY(!subscription.isValid());
    {
        RtdePeer peer;
        Receiver receiver(to(peer.port()));
        subscription = receiver.subscribe();
        QVERIFY(receiver.start().ok());
        peer.send(1.0);
        TRY_COMPARE(receiver.counters().packets, std::uint64_t(1));
    }
    QVERIFY(subscription.next(sample));
    QCOMPARE(sample.sequence, std::uint64_t(1));
}

void TestReceiver::startsAgainAfterStop() {
    RtdePeer peer;
    Receiver receiver(to(peer.port()));
    for (std::uint64_t round = 1; round <= 3; ++round) {
        QVERIFY(receiver.start().ok());
        QVERIFY(receiver.start().ok());  // a single start is sufficient
        peer.send(static_cast<double>(round));
        TRY_COMPARE(receiver.counters().packets, round);
        receiver.stop();
        receiver.stop();
        QCOMPARE(receiver.state(), ReceiverState::Stopped);
        TRY_VERIFY(!peer.isStarted());
    }
}

void TestReceiver::stopsPromptly_data() {
    QTest::addColumn<QString>("situation");
    for (const char* situation : {"mute peer", "silent stream", "nobody there", "waiting"}) {
        QTest::newRow(situation) << QString::fromLatin1(situation);
    }
}

void TestReceiver::stopsPromptly() {
    QFETCH(QString, situation);
    ScriptedPeer mute([](ScriptedPeer::Link& link) { link.beMute(); });
    RtdePeer silent;
    ReceiverOptions options = to(situation == QLatin1String("mute peer") ? mute.port() : silent.port());
    options.connectTimeout = 1h;
    options.silenceLimit = 1h;
    options.reconnectDelays = {1h};
    if (situation == QLatin1String("nobody there")) {
        // An address reserved for documentation: no response, or no route if there is no network.
        options.host = QStringLiteral("192.0.2.1");
    } else if (situation == QLatin1String("waiting")) {
        options.port = portNobodyListensOn();
    }
    Receiver receiver(options);
    QVERIFY(receiver.start().ok());
    if (situation == QLatin1String("mute peer")) {
        TRY_COMPARE(mute.connections(), 1);
    } else if (situation == QLatin1String("silent stream")) {
        TRY_VERIFY(silent.isStarted());
    } else if (situation == QLatin1String("waiting")) {
        TRY_COMPARE(receiver.state(), ReceiverState::Waiting);
    }
    // All these waits would last one hour. The test passes if stop() returns in less time; benchmarks measure
    // the actual time.
    receiver.stop();
    QCOMPARE(receiver.state(), ReceiverState::Stopped);
}

QTEST_GUILESS_MAIN(TestReceiver)
#include "tst_receiver.moc"
