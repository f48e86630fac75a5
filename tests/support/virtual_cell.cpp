// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/virtual_cell.h"
#include "tests/support/event_spy.h"

#include <QCoreApplication>
#include <QElapsedTimer>
#include <QEvent>
#include <QPointer>
#include <thread>
#include <utility>

#include "robot/receive/receiver.h"

namespace tiller::test {
namespace {

constexpr int kTickMs = 2;
constexpr int kRefreshMs = 16;
constexpr int kPumpMs = 20;
/// Windows repaint only at every fifth refresh, as on a slow computer, because painting takes most of a
/// test's processor time.
constexpr int kRefreshesPerPaint = 5;
/// Maximum real time to wait for another thread. A working computer never reaches this limit.
constexpr std::chrono::seconds kTestTimeout{20};

}  // namespace

/// Delays the repainting of windows while the time of the cell advances.
class VirtualCell::PaintDelay : public QObject {
public:
    PaintDelay() { QCoreApplication::instance()->installEventFilter(this); }

    /// Processes events. Windows repaint in every kRefreshesPerPaint-th call.
    void processEvents() {
        isDelaying_ = ++refreshes_ % kRefreshesPerPaint != 0;
        if (!isDelaying_) {
            release();
        }
        QCoreApplication::processEvents();
        isDelaying_ = false;
    }
    /// Posts the delayed repaints, so that windows repaint when events are processed next.
    void release() {
        for (const QPointer<QObject>& window : std::exchange(waiting_, {})) {
            if (window) {
                QCoreApplication::postEvent(window, new QEvent(QEvent::UpdateRequest), Qt::LowEventPriority);
            }
        }
    }

protected:
    bool eventFilter(QObject* window, QEvent* event) override {
        if (!isDelaying_ || event->type() != QEvent::UpdateRequest) {
            return false;
        }
        waiting_.append(window);
        return true;
    }

private:
    bool isDelaying_ = false;
    int refreshes_ = 0;
    QList<QPointer<QObject>> waiting_;
};

simulator::SimulatorOptions VirtualCell::options() {
    simulator::SimulatorOptions options;
    // Each process has its own loopback address, so that tests can run in parallel.
    const auto pid = static_cast<unsigned>(QCoreApplication::applicationPid());
    options.listenAddress = QStringLiteral("127.%1.%2.1").arg(10 + pid % 200).arg((pid / 200) % 250);
    options.time = simulator::Time::Virtual;
    options.poweredOn = true;
    options.fastTransitions = true;
    return options;
}

VirtualCell::VirtualCell(VirtualClock& c, RobotSession& s, const simulator::SimulatorOptions& r)
    : clock(c)
    , session(s)
    , robot(r)
    , portOffset_(r.portOffset)
    , paintDelay_(std::make_unique<PaintDelay>()) {}

VirtualCell::~VirtualCell() {
    session.disconnectFromRobot();
    robot.stop();
}

bool VirtualCell::connect() {
    const Result<void> started = robot.start();
    if (!started) {
        what_ = started.error().toString();
        return false;
    }
    test::onMessage(session.journal(), &session, [this](Severity severity, const QString& text) {
        if (severity == Severity::Error) {
            what_ = text;
        }
    });
    session.connectTo({QStringLiteral("Virtual UR5e"), robot.listenAddress(), portOffset_, true});
    QElapsedTimer waited;
    waited.start();
    const auto within = [&] { return std::chrono::milliseconds(waited.elapsed()) < kTestTimeout; };
    while (session.state().link != LinkState::Live && within()) {
        advanceMs(kRefreshMs);
    }
    if (session.state().link != LinkState::Live) {
        what_ = QStringLiteral("no data: ") + session.state().linkReason;
        return false;
    }
    return true;
}

bool VirtualCell::bringUp() {
    if (!connect()) {
        return false;
    }
    QElapsedTimer waited;
    waited.start();
    session.takeControl();
    while (session.state().control == ControlState::Taking &&
           std::chrono::milliseconds(waited.elapsed()) < kTestTimeout) {
        advanceMs(kRefreshMs);
    }
    if (!session.state().canMove()) {
        what_ = QStringLiteral("not in control: ") + session.state().controlReason;
        return false;
    }
    return true;
}

void VirtualCell::tick() {
    clock.advanceNs(kTickMs * kNsPerMs);
    const std::uint64_t inputs = robot.inputPackages();
    receive::Receiver* receiver = session.receiver();
    const bool receiving = receiver != nullptr && receiver->state() == receive::ReceiverState::Receiving;
    receive::Subscription ring;
    std::uint64_t packets = 0;
    std::uint64_t sequence = 0;
    if (receiving) {
        ring = receiver->subscribe();
        packets = receiver->counters().packets;
        receiver->latest(newest_);
        sequence = newest_.sequence;
    }
    // Check all places where the package is visible, because they are updated one after the other.
    const auto isTakenIn = [&] {
        receiver->latest(newest_);
        return ring.pending() > 0 && newest_.sequence != sequence && receiver->counters().packets != packets;
    };
    robot.step();

    QElapsedTimer waited;
    waited.start();
    const auto isWaiting = [&] { return std::chrono::milliseconds(waited.elapsed()) < kTestTimeout; };
    while (receiving && !isTakenIn() && receiver->state() == receive::ReceiverState::Receiving &&
           waited.elapsed() < 500) {
        std::this_thread::yield();
    }
    awaitFirstAnswers(inputs);
    // The controller replies to each data package with one input package, unless it has lost control.
    while (session.state().control == ControlState::InControl && isWaiting()) {
        if (robot.waitForInputPackages(inputs + 1, Deadline::after(std::chrono::milliseconds(200)))) {
            break;
        }
        session.refresh();
    }
}

// The watchdog of the program uses robot time. Robot time must not advance faster than the replying thread
// runs, even before the session has detected that it is in control.
// inputs  number of packages received from the client up to the last step of the robot
void VirtualCell::awaitFirstAnswers(std::uint64_t inputs) {
    if (session.state().control != ControlState::Taking) {
        inputsBeforeTaking_ = inputs;
        return;
    }
    const bool answers = inputs > inputsBeforeTaking_;
    // The timeout is much longer than the delay of a thread on a busy machine. If the robot advanced earlier,
    // the program would end, and taking control would fail.
    if (answers && !robot.waitForInputPackages(inputs + 1, Deadline::after(std::chrono::seconds(2)))) {
        inputsBeforeTaking_ = inputs;  // the program has ended; do not wait until it starts again
    }
}

void VirtualCell::interfaceTurn() {
    sinceRefresh_ += kTickMs;
    sincePump_ += kTickMs;
    if (sincePump_ >= kPumpMs) {
        sincePump_ = 0;
        if (everyRefresh) {
            everyRefresh();
        }
    }
    if (sinceRefresh_ >= kRefreshMs) {
        sinceRefresh_ = 0;
        paintDelay_->processEvents();
        session.refresh();
    }
}

void VirtualCell::advanceMs(int ms) {
    for (int t = 0; t < ms; t += kTickMs) {
        tick();
        interfaceTurn();
    }
    paintDelay_->release();
}

bool VirtualCell::advanceUntil(const std::function<bool()>& condition, int atMostMs) {
    for (int t = 0; t < atMostMs && !condition(); t += kTickMs) {
        tick();
        interfaceTurn();
    }
    paintDelay_->release();
    return condition();
}

void VirtualCell::advanceWithFrozenInterface(int ms) {
    for (int t = 0; t < ms; t += kTickMs) {
        tick();
    }
}

double distanceMm(const Pose& a, const Pose& b) {
    return 1000.0 * (a.position - b.position).norm();
}

}  // namespace tiller::test
