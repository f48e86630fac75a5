// SPDX-License-Identifier: MIT
// The class Robot: one object for data, control, outputs, services and recordings, and its events.
#include <QTemporaryDir>
#include <QTest>
#include <algorithm>
#include <cmath>
#include <mutex>
#include <stop_token>
#include <vector>

#include "robot/api/robot.h"
#include "robot/testing/robot_fixture.h"
#include "tests/support/waiting.h"

using namespace tiller;
using namespace tiller::test;
using namespace tiller::virtual_time;
using Kind = RobotEvent::Kind;

namespace {

Deadline limit() {
    return RobotFixture::limit();
}

/// A simulated robot in virtual time, a Robot that is connected to it, and the events received so far.
class Bench {
public:
    explicit Bench(std::vector<std::string> fields = {}) {
        RobotOptions options;
        options.fields = std::move(fields);
        options.clock = bench.clock().get();
        options.onEvent = [this](const RobotEvent& event) {
            const std::lock_guard lock(mutex_);
            events_.push_back(event);
        };
        robot.emplace(bench.robot().listenAddress(), options);
        bench.follow(robot->receiver());
        bench.follow(robot->controller());
    }
    ~Bench() { end(); }
    Bench(const Bench&) = delete;
    Bench& operator=(const Bench&) = delete;

    Result<void> takeControl() {
        bench.start().value();
        return bench.whileTimePasses([this] {
            const auto connected = robot->connect(limit());
            return connected ? robot->takeControl(limit()) : connected;
        });
    }
    void end() {
        bench.whileTimePasses([this] { robot.reset(); });
    }
    /// Starts a move and advances 0.5 s, so that the arm is moving.
    control::Motion move() {
        JointPositions target = bench.robot().truth().q;
        target[0] += 1;
        control::Motion motion = robot->motions().moveJ(target, {.speed = 0.5}).value();
        bench.step(0.5);
        return motion;
    }
    bool isMoving() const { return bench.robot().truth().qd.values.norm() > 1e-3; }
    /// Waits for the first event of this kind.
    bool hasEvent(Kind kind) {
        return QTest::qWaitFor([&] { return event(kind).has_value(); }, 20'000);
    }
    std::optional<RobotEvent> event(Kind kind) {
        const std::lock_guard lock(mutex_);
        const auto found = std::find_if(events_.begin(), events_.end(),
                                        [kind](const RobotEvent& event) { return event.kind == kind; });
        return found == events_.end() ? std::nullopt : std::optional(*found);
    }

    LockStep bench;
    std::optional<Robot> robot;

private:
    std::mutex mutex_;
    std::vector<RobotEvent> events_;
};

}  // namespace

class TestRobot : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void oneObjectReadsMovesRecordsAndSetsOutputs() {
        const QTemporaryDir folder;
        Bench cell({"actual_q"});
        const auto taken = cell.takeControl();
        QVERIFY2(taken.ok(), why(taken));
        QVERIFY(cell.robot->record({.path = folder.filePath("run.csv"), .fields = {"actual_q"}}).ok());
        JointPositions target = cell.bench.robot().truth().q;
        target[5] += 0.3;
        const auto move = cell.robot->motions().moveJ(target);
        QVERIFY2(move.ok(), why(move));
        QVERIFY(cell.bench.whileTimePasses([&] { return move->wait(limit()); }).ok());
        cell.bench.step(0.1);
        const receive::Sample sample = cell.robot->latest();
        QVERIFY(std::abs(receive::RobotState(sample).q()[5] - target[5]) < 1e-3);
        // The fields that confirm outputs are received even if they were not requested.
        const auto set = cell.bench.whileTimePasses(
            [&] { return cell.robot->outputs().setDigitalOutput(2, true, limit()); });
        QVERIFY2(set.ok(), why(set));
        QCOMPARE(cell.bench.robot().truth().digitalOutputs, std::uint64_t(4));
        QVERIFY(cell.robot->stopRecording().ok());
        QVERIFY(cell.robot->recorder().progress().rows > 100);
        const auto service = cell.robot->service(limit());
        QVERIFY2(service.ok(), why(service));
        QCOMPARE((*service)->kind(), dashboard::ServiceKind::Dashboard);
        QCOMPARE(cell.robot->service(limit()).value(), *service);
    }

    void eventsReportControlMotionsAndStops() {
        Bench cell;
        const auto taken = cell.takeControl();
        QVERIFY2(taken.ok(), why(taken));
        QVERIFY(cell.hasEvent(Kind::ProgramStarted));
        QVERIFY(cell.hasEvent(Kind::ControlTaken));
        QVERIFY(!cell.event(Kind::ControlLost) && !cell.event(Kind::MotionEnded));
        const control::Motion motion = cell.move();
        QVERIFY(cell.bench.robot().inject("protective-stop").ok());
        cell.bench.step(0.5);
        QVERIFY(cell.hasEvent(Kind::ProtectiveStop));
        QCOMPARE(cell.event(Kind::ProtectiveStop)->safetyMode, SafetyMode::ProtectiveStop);
        QVERIFY(cell.hasEvent(Kind::MotionEnded));
        QCOMPARE(cell.event(Kind::MotionEnded)->motion, motion.id());
        QCOMPARE(cell.event(Kind::MotionEnded)->cause, motion.state().cause);
        QVERIFY(cell.hasEvent(Kind::ProgramEnded));
        QVERIFY(cell.hasEvent(Kind::ControlLost));
        QVERIFY(cell.event(Kind::ControlLost)->loss != control::ControlLoss::None);
        QVERIFY(!cell.event(Kind::DataLost));
    }

    void lostDataAreAnEvent() {
        Bench cell;
        QVERIFY(cell.takeControl().ok());
        QVERIFY(cell.bench.robot().inject("silence on").ok());
        cell.bench.step(0.3);
        QVERIFY(cell.hasEvent(Kind::DataLost));
        QVERIFY(!cell.event(Kind::DataResumed));
        QVERIFY(cell.bench.robot().inject("silence off").ok());
        cell.bench.step(0.3);
        QVERIFY(cell.hasEvent(Kind::DataResumed));
    }

    void aStopInAnEventHandlerIsSent() {
        LockStep bench;
        bench.start().value();
        std::optional<Robot> robot;
        RobotOptions options;
        options.clock = bench.clock().get();
        options.onEvent = [&robot](const RobotEvent& event) {
            if (event.kind == Kind::DataLost) {
                robot->stop();
            }
        };
        options.control.dataTimeout = std::chrono::milliseconds(2000);
        options.control.connectionTimeout = std::chrono::milliseconds(0);
        robot.emplace(bench.robot().listenAddress(), options);
        bench.follow(robot->receiver());
        bench.follow(robot->controller());
        QVERIFY(bench
                    .whileTimePasses([&] {
                        const auto connected = robot->connect(limit());
                        return connected ? robot->takeControl(limit()) : connected;
                    })
                    .ok());
        const std::uint64_t stops = robot->controller()->stops();
        QVERIFY(bench.robot().inject("silence on").ok());
        bench.step(0.3);
        QTRY_VERIFY_WITH_TIMEOUT(robot->controller()->stops() > stops, 20'000);
        QVERIFY(bench.robot().inject("silence off").ok());
        bench.whileTimePasses([&] { robot.reset(); });
    }

    void destroyingTheObjectStopsTheArm() {
        Bench cell;
        QVERIFY(cell.takeControl().ok());
        (void)cell.move();
        QVERIFY(cell.isMoving());
        const double begin = cell.bench.robot().truth().timestamp;
        cell.end();
        // Limit of the contract: 250 ms after the last packet.
        QVERIFY(cell.bench.stepUntil([&] { return !cell.isMoving(); }, 0.25));
        QVERIFY(cell.bench.robot().truth().timestamp > begin);
        cell.bench.step(1);
        QVERIFY(!cell.isMoving());
    }

    void aStopTokenEndsAWaitButNotTheMotion() {
        Bench cell;
        QVERIFY(cell.takeControl().ok());
        const control::Motion motion = cell.move();
        std::stop_source stop;
        stop.request_stop();
        QCOMPARE(
            motion.wait(Deadline::after(std::chrono::hours(1), cancelledBy(stop.get_token()))).error().code,
            ErrorCode::Cancelled);
        QVERIFY(motion.isActive());
    }

    void aRefusedConnectionCanBeRepeated() {
        Bench cell;
        const auto refused = cell.robot->connect(limit());
        QCOMPARE(refused.error().code, ErrorCode::ConnectionRefused);
        QCOMPARE(cell.robot->record({.path = "unused.csv"}).error().code, ErrorCode::NotConnected);
        const auto taken = cell.takeControl();
        QVERIFY2(taken.ok(), why(taken));
    }
};

QTEST_GUILESS_MAIN(TestRobot)
#include "tst_robot.moc"
