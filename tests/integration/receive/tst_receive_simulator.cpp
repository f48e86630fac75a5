// SPDX-License-Identifier: MIT
// Receiver, recorder and outputs with the simulated controller, over real sockets. Robot and clocks advance
// in lock-step, so that the tests do not depend on the speed of the computer.
#include <QTemporaryDir>
#include <QTest>
#include <algorithm>
#include <cmath>
#include <future>
#include <thread>

#include "robot/io/outputs.h"
#include "robot/receive/receiver.h"
#include "robot/receive/robot_state.h"
#include "robot/recording/csv_reader.h"
#include "robot/recording/recorder.h"
#include "robot/rtde/connection.h"
#include "robot/rtde/fields.h"
#include "robot/simulator/simulator.h"

using namespace tiller;
using namespace std::chrono_literals;

namespace {

// Only a failing test reaches this timeout.
constexpr auto kTestTimeout = 60s;

template <class Condition>
bool eventually(Condition condition) {
    const Deadline deadline = Deadline::after(kTestTimeout);
    while (!condition()) {
        if (deadline.hasExpired()) {
            return false;
        }
        std::this_thread::yield();
    }
    return true;
}

simulator::SimulatorOptions standingStill(simulator::Time time = simulator::Time::Virtual) {
    simulator::SimulatorOptions options;
    options.anyFreePorts = true;
    options.time = time;
    options.poweredOn = true;
    return options;
}

/// A simulated robot and a receiver with a common virtual time.
struct Cell {
    explicit Cell(const simulator::SimulatorOptions& options = standingStill()) : robot(options) {
        if (!robot.start().ok()) {
            qFatal("the simulated controller does not start");
        }
        receive::ReceiverOptions to;
        to.host = options.listenAddress;
        to.port = robot.ports().rtde;
        to.clock = &clock;
        to.priority = 0;
        receiver = std::make_unique<receive::Receiver>(to);
        receiver->start().value();
    }
    bool connect() {
        return eventually([&] { return receiver->state() == receive::ReceiverState::Receiving; });
    }
    /// Advances robot and clock by one control period, and waits for the package.
    bool tick() {
        // Check all places where the package becomes visible, because they are updated one after the other.
        const receive::Subscription ring = receiver->subscribe();
        const auto newest = receiver->latest().sequence;
        const auto counted = receiver->counters().packets;
        clock.advanceNs(static_cast<std::int64_t>(std::llround(robot.stepTime() * 1e9)));
        robot.step();
        return eventually([&] {
            return ring.pending() > 0 && receiver->latest().sequence > newest &&
                   receiver->counters().packets > counted;
        });
    }

    VirtualClock clock;
    simulator::Simulator robot;
    std::unique_ptr<receive::Receiver> receiver;
};

}  // namespace

class TestReceiveSimulator : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void everyCatalogueFieldIsAnsweredWithItsType();
    void streamsWithoutLossAt500Hz();
    void streamsWithoutLossAt125Hz();
    void realTimeStreamHasNoMissingSamples();
    void refusedCpusAreReported();
    void stateMatchesTheRobot();
    void recordsFiveSecondsRowByRow();
    void outputsAreSetAndConfirmed();
    void secondOwnerLearnsWhichInputsAreInUse();
    void reconnectsWhenTheControllerClosesItsClients();
    void aSilentControllerIsStaleThenDisconnected();
};

void TestReceiveSimulator::everyCatalogueFieldIsAnsweredWithItsType() {
    auto newest = standingStill();
    newest.software = {10, 15, 0, 0};
    Cell cell(newest);
    for (const auto direction : {rtde::Direction::Output, rtde::Direction::Input}) {
        const auto fields = direction == rtde::Direction::Output ? rtde::outputFields() : rtde::inputFields();
        for (std::size_t from = 0; from < fields.size(); from += 40) {
            std::vector<std::string> names;
            for (const auto& field : fields.subspan(from, std::min<std::size_t>(40, fields.size() - from))) {
                names.emplace_back(field.name);
            }
            rtde::ConnectionOptions options;
            options.host = QStringLiteral("127.0.0.1");
            options.port = cell.robot.ports().rtde;
            if (direction == rtde::Direction::Output) {
                options.request.outputs = names;
            } else {
                options.request.inputs.push_back({names, true});
            }
            const auto connection = rtde::Connection::open(options, Deadline::after(kTestTimeout));
            QVERIFY2(connection.ok(), qPrintable(connection.error().toString()));
            const rtde::Recipe& recipe =
                direction == rtde::Direction::Output ? (*connection)->outputs() : (*connection)->inputs()[0];
            QVERIFY2(recipe.absent().empty(),
                     qPrintable(QString::fromStdString(rtde::joinNames(recipe.absent()))));
            for (std::size_t i = 0; i < names.size(); ++i) {
                const auto* known = direction == rtde::Direction::Output ? rtde::findOutput(names[i])
                                                                         : rtde::findInput(names[i]);
                QCOMPARE(recipe.fields()[i].name, names[i]);
                QCOMPARE(recipe.fields()[i].type, known->type);
            }
        }
    }
}

void TestReceiveSimulator::streamsWithoutLossAt500Hz() {
    Cell cell;
    QVERIFY(cell.connect());
    receive::Subscription subscription = cell.receiver->subscribe();
    QCOMPARE(cell.receiver->period(), 0.002);
    QVERIFY(cell.receiver->absentFields().empty());
    receive::Sample sample;
    double previous = 0;
    std::uint64_t first = 0;
    for (int i = 0; i < 1000; ++i) {
        QVERIFY(cell.tick());
        QVERIFY(subscription.next(sample));
        QVERIFY(!subscription.next(sample));
        const double timestamp = receive::RobotState(sample).timestamp();
        if (i == 0) {
            first = sample.sequence;
        } else {
            QVERIFY(std::abs(timestamp - previous - 0.002) < 1e-6);
        }
        QCOMPARE(sample.sequence, first + static_cast<std::uint64_t>(i));
        previous = timestamp;
    }
    const auto counters = cell.receiver->counters();
    QCOMPARE(counters.lost, std::uint64_t(0));
    QCOMPARE(counters.late, std::uint64_t(0));
    QVERIFY(std::abs(counters.rateHz - 500) < 1);
    QCOMPARE(subscription.lost(), std::uint64_t(0));
}

void TestReceiveSimulator::streamsWithoutLossAt125Hz() {
    auto options = standingStill();
    options.model = RobotModelId::UR5;
    options.software = {3, 15, 8, 106339};
    Cell cell(options);
    QVERIFY(cell.connect());
    QCOMPARE(cell.receiver->period(), 0.008);
    for (int i = 0; i < 100; ++i) {
        QVERIFY(cell.tick());
    }
    QCOMPARE(cell.receiver->counters().lost, std::uint64_t(0));
    // Fields that CB3 does not have are absent without an error.
    const auto absent = cell.receiver->absentFields();
    QVERIFY(std::find(absent.begin(), absent.end(), "ft_raw_wrench") != absent.end());
    QVERIFY(!cell.receiver->latest().field("actual_q").empty());
}

void TestReceiveSimulator::refusedCpusAreReported() {
    simulator::Simulator robot(standingStill(simulator::Time::Real));
    QVERIFY(robot.start().ok());
    receive::ReceiverOptions to;
    to.host = QStringLiteral("127.0.0.1");
    to.port = robot.ports().rtde;
    to.priority = 0;
    to.cpus = {1000};
    receive::Receiver receiver(to);
    QVERIFY(receiver.start().ok());
    // Data are received although the CPU does not exist.
    QVERIFY(eventually([&] { return receiver.counters().packets >= 10; }));
    QVERIFY2(receiver.priority().advice.contains(QStringLiteral("CPU")),
             qPrintable(receiver.priority().advice));
}

void TestReceiveSimulator::realTimeStreamHasNoMissingSamples() {
    simulator::Simulator robot(standingStill(simulator::Time::Real));
    QVERIFY(robot.start().ok());
    receive::ReceiverOptions to;
    to.host = QStringLiteral("127.0.0.1");
    to.port = robot.ports().rtde;
    to.priority = 0;
    receive::Receiver receiver(to);
    receive::Subscription subscription = receiver.subscribe();
    QVERIFY(receiver.start().ok());
    QVERIFY(eventually([&] { return receiver.counters().packets >= 500; }));
    receiver.stop();
    // Independent of the load of the computer, the numbers of received and lost packages add up to the
    // controller's time.
    receive::Sample sample;
    double first = 0;
    double last = 0;
    std::uint64_t steps = 0;
    while (subscription.next(sample)) {
        last = receive::RobotState(sample).timestamp();
        if (first == 0) {
            first = last;
        } else {
            steps += 1 + sample.lostBefore;
        }
    }
    QCOMPARE(static_cast<std::uint64_t>(std::llround((last - first) / 0.002)), steps);
    QCOMPARE(receiver.counters().packets + receiver.counters().lost, steps + 1);
}

void TestReceiveSimulator::stateMatchesTheRobot() {
    Cell cell;
    QVERIFY(cell.connect());
    cell.robot.setDigitalInput(3, true);
    for (int i = 0; i < 3; ++i) {
        QVERIFY(cell.tick());
    }
    const receive::Sample sample = cell.receiver->latest();
    const receive::RobotState state(sample);
    const simulator::SimulatedState truth = cell.robot.truth();
    QCOMPARE(state.robotMode(), RobotMode::Running);
    QCOMPARE(state.safetyMode(), SafetyMode::Normal);
    QVERIFY(state.is(receive::RobotStatusBit::PowerOn));
    QVERIFY(state.is(receive::SafetyStatusBit::Normal));
    QVERIFY((state.q().values - truth.q.values).norm() < 1e-3);
    QVERIFY((state.tcpPose().position - truth.tcpPose.position).norm() < 1e-3);
    QCOMPARE(state.digitalInputs().value(), std::uint64_t(8));
    QCOMPARE(state.speedSlider(), 1.0);
    QVERIFY(std::abs(state.timestamp() - truth.timestamp) < 0.0021);
}

void TestReceiveSimulator::recordsFiveSecondsRowByRow() {
    Cell cell;
    QVERIFY(cell.connect());
    QVERIFY(cell.tick());
    const QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("recording.csv"));
    recording::Recorder recorder;
    recording::RecorderOptions options;
    options.path = path;
    QVERIFY(recorder.start(options, *cell.receiver).ok());
    for (int i = 0; i < 2500; ++i) {
        QVERIFY(cell.tick());
    }
    recorder.stop();
    QCOMPARE(recorder.progress().rows, std::uint64_t(2500));
    QCOMPARE(recorder.progress().lost, std::uint64_t(0));
    QVERIFY(std::abs(recorder.progress().seconds - 4.998) < 1e-6);
    const auto table = recording::readCsv(path);
    QVERIFY2(table.ok(), qPrintable(table.error().toString()));
    QCOMPARE(table->rows(), std::size_t(2500));
    const auto& timestamps = *table->column("timestamp");
    for (std::size_t i = 1; i < timestamps.size(); ++i) {
        QVERIFY(std::abs(timestamps[i] - timestamps[i - 1] - 0.002) < 1e-6);
    }
    QVERIFY(std::abs(table->column("actual_q_0")->back() - cell.robot.truth().q[0]) < 1e-3);
}

void TestReceiveSimulator::outputsAreSetAndConfirmed() {
    Cell cell;
    QVERIFY(cell.connect());
    io::OutputsOptions to;
    to.host = QStringLiteral("127.0.0.1");
    to.port = cell.robot.ports().rtde;
    io::Outputs outputs(to, io::OutputFeedback::fromReceiver(*cell.receiver));
    QVERIFY(outputs.connect(Deadline::after(kTestTimeout)).ok());
    // A separate thread makes the call and waits while time is advanced here.
    const auto carryOut = [&](auto call) {
        auto done = std::async(std::launch::async, call);
        while (done.wait_for(0s) != std::future_status::ready) {
            if (!cell.tick()) {
                break;
            }
        }
        return done.get();
    };
    const auto testTimeout = [] { return Deadline::after(kTestTimeout); };
    for (const int output : {0, 7, 8, 15, 16, 17}) {
        auto set = carryOut([&] { return outputs.setDigitalOutput(output, true, testTimeout()); });
        QVERIFY2(set.ok(), qPrintable(set.error().toString()));
        QVERIFY(cell.robot.truth().digitalOutputs & (std::uint64_t(1) << output));
    }
    QVERIFY(carryOut([&] { return outputs.setDigitalOutput(8, false, testTimeout()); }).ok());
    QCOMPARE(cell.robot.truth().digitalOutputs, std::uint64_t(0x38081));
    QVERIFY(carryOut([&] { return outputs.setSpeedSlider(0.37, testTimeout()); }).ok());
    QVERIFY(std::abs(cell.robot.truth().speedSlider - 0.37) < 1e-9);
    // A request for standstill must not make the arm creep.
    for (const double creep : {0.0, -0.5, 0.0001, 0.0199}) {
        const auto refused = carryOut([&] { return outputs.setSpeedSlider(creep, testTimeout()); });
        QCOMPARE(refused.error().code, ErrorCode::InvalidArgument);
        QVERIFY2(refused.error().context.contains(QLatin1String("0.02 to 1")),
                 qPrintable(refused.error().toString()));
        QVERIFY(std::abs(cell.robot.truth().speedSlider - 0.37) < 1e-9);
    }
    QVERIFY(carryOut([&] { return outputs.setSpeedSlider(0.02, testTimeout()); }).ok());
    QVERIFY(std::abs(cell.robot.truth().speedSlider - 0.02) < 1e-9);
}

void TestReceiveSimulator::secondOwnerLearnsWhichInputsAreInUse() {
    Cell cell;
    io::OutputsOptions to;
    to.host = QStringLiteral("127.0.0.1");
    to.port = cell.robot.ports().rtde;
    io::Outputs first(to, io::OutputFeedback::fromReceiver(*cell.receiver));
    io::Outputs second(to, io::OutputFeedback::fromReceiver(*cell.receiver));
    QVERIFY(first.connect(Deadline::after(kTestTimeout)).ok());
    QVERIFY(second.connect(Deadline::after(kTestTimeout)).ok());
    QVERIFY(first.canSetSpeedSlider().ok());
    QCOMPARE(second.canSetSpeedSlider().error().code, ErrorCode::RegisterInUse);
    QVERIFY(second.canSetSpeedSlider().error().context.contains(QLatin1String("speed_slider_mask")));
    QCOMPARE(second.canSetDigitalOutput(17).error().code, ErrorCode::RegisterInUse);
    // The register is free when the first client disconnects.
    first.disconnect();
    QVERIFY(eventually([&] {
        return second.connect(Deadline::after(kTestTimeout)).ok() && second.canSetSpeedSlider().ok();
    }));
}

void TestReceiveSimulator::reconnectsWhenTheControllerClosesItsClients() {
    Cell cell;
    QVERIFY(cell.connect());
    QVERIFY(cell.tick());
    const auto before = cell.receiver->counters();
    cell.robot.closeClients();
    cell.robot.step();
    QVERIFY(eventually([&] {
        cell.clock.advanceNs(kNsPerMs);  // the delay before the next attempt is measured on this clock
        return cell.receiver->counters().reconnects > before.reconnects;
    }));
    QVERIFY(cell.tick());
    QCOMPARE(cell.receiver->latest().connection, std::uint64_t(2));
}

void TestReceiveSimulator::aSilentControllerIsStaleThenDisconnected() {
    Cell cell;
    QVERIFY(cell.connect());
    QVERIFY(cell.tick());
    cell.robot.silence(true);
    cell.robot.step();
    cell.clock.advanceNs(150 * kNsPerMs);
    QVERIFY(!cell.receiver->isFresh(100ms));
    QCOMPARE(cell.receiver->state(), receive::ReceiverState::Receiving);
    cell.clock.advanceNs(3 * kNsPerSecond);
    QVERIFY(eventually([&] { return cell.receiver->lastError().code == ErrorCode::LinkLost; }));
    // stop() must not wait for a peer that does not respond.
    cell.receiver->stop();
    QCOMPARE(cell.receiver->state(), receive::ReceiverState::Stopped);
}

QTEST_GUILESS_MAIN(TestReceiveSimulator)
#include "tst_receive_simulator.moc"
