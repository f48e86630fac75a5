// SPDX-License-Identifier: MIT
// Connections break while all objects use them: the control thread streams, callers send commands and
// queries, the receiver decodes, and two threads set outputs. In all cases, each call must end with an error,
// nothing may hang, and it must be possible to take control again. Runs in real time, mainly for
// ThreadSanitizer.
#include <QTest>
#include <atomic>
#include <thread>
#include <vector>

#include "robot/control/controller.h"
#include "robot/control/motions.h"
#include "robot/io/outputs.h"
#include "robot/receive/receiver.h"
#include "robot/script/program_stopper.h"
#include "robot/simulator/simulator.h"
#include "tests/support/waiting.h"

using namespace tiller;
using namespace tiller::control;
using namespace tiller::test;
using std::chrono::milliseconds;

namespace {

constexpr int kBreaks = 12;

simulator::SimulatorOptions robotOptions() {
    simulator::SimulatorOptions options;
    options.anyFreePorts = true;
    options.poweredOn = true;
    options.fastTransitions = true;
    return options;
}

/// Repeats an action until the end of the test.
class Crowd {
public:
    ~Crowd() { end(); }
    template <class Call>
    void add(Call call) {
        threads_.emplace_back([this, call]() mutable {
            while (!over_) {
                call();
                std::this_thread::sleep_for(std::chrono::microseconds(300));
            }
        });
    }
    void end() {
        over_ = true;
        for (std::thread& thread : threads_) {
            thread.join();
        }
        threads_.clear();
    }
    const std::atomic<bool>& over() const { return over_; }

private:
    std::atomic<bool> over_{false};
    std::vector<std::thread> threads_;
};

}  // namespace

class TestBrokenLink : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void aBrokenLinkIsReportedToAllSubscribers_data() {
        QTest::addColumn<QString>("fault");
        QTest::newRow("connections ended in good order") << QStringLiteral("close-clients");
    }
    void aBrokenLinkIsReportedToAllSubscribers() {
        QFETCH(QString, fault);
        simulator::Simulator robot(robotOptions());
        QVERIFY(robot.start().ok());

        receive::ReceiverOptions receiving;
        receiving.host = robot.listenAddress();
        receiving.port = robot.ports().rtde;
        receiving.priority = 0;
        receiving.reconnectDelays = {milliseconds(1)};
        receive::Receiver receiver(receiving);
        QVERIFY(receiver.start().ok());

        io::OutputsOptions setting;
        setting.host = robot.listenAddress();
        setting.port = robot.ports().rtde;
        io::Outputs outputs(setting, io::OutputFeedback::fromReceiver(receiver));

        ControllerOptions controlling;
        controlling.host = robot.listenAddress();
        controlling.primaryPort = robot.ports().primary;
        controlling.rtdePort = robot.ports().rtde;
        controlling.priority = 0;
        Controller controller(controlling);

        script::ProgramStopperOptions stopping;
        stopping.host = robot.listenAddress();
        stopping.port = robot.ports().primary;
        script::ProgramStopper stopper(stopping);
        stopper.start();

        std::atomic<int> taken{0};
        std::atomic<int> jogs{0};
        std::atomic<int> refusals{0};
        Crowd crowd;
        crowd.add([&] {
            if (!controller.status().inControl &&
                controller.takeControl(Deadline::after(milliseconds(5000))).ok()) {
                ++taken;
            }
        });
        for (const double speed : {0.03, -0.03}) {
            crowd.add([&, speed, jog = Jog()]() mutable {
                JogTarget target;
                target.twist.linear.z() = speed;
                if (jog.refresh(target)) {
                    return;
                }
                const auto begun = Motions(controller).startJog(target);
                jog = begun ? *begun : Jog();
                begun ? ++jogs : ++refusals;
            });
        }
        crowd.add([&] {
            const ControllerStatus status = controller.status();
            controller.motionState(status.motion);
            (void)controller.version();
            (void)controller.limits();
            if (status.ticks % 97 == 0) {
                controller.stop(StopCause::ApiCall);
            }
        });
        crowd.add([&, stream = receiver.subscribe(), sample = receive::Sample(receiver.layout())]() mutable {
            while (stream.next(sample)) {
            }
            (void)receiver.latest();
            (void)receiver.lastError();
            (void)receiver.version();
            (void)receiver.counters();
            (void)receiver.state();
        });
        for (const int output : {0, 1}) {
            crowd.add([&, output, on = false]() mutable {
                on = !on;
                (void)outputs.setDigitalOutput(output, on, Deadline::after(milliseconds(200)));
                (void)outputs.canSetDigitalOutput(output);
                (void)outputs.isConnected();
            });
        }
        crowd.add([&] {
            (void)stopper.isConnected();
            (void)stopper.error();
        });

        for (int n = 0; n < kBreaks; ++n) {
            const int before = taken;
            QTRY_VERIFY_WITH_TIMEOUT(taken > before || controller.status().inControl, 60'000);
            const int moved = jogs;
            QTRY_VERIFY_WITH_TIMEOUT(jogs > moved || controller.status().motion != kNoMotion, 60'000);
            QVERIFY(robot.inject(fault).ok());
        }
        QTRY_VERIFY_WITH_TIMEOUT(refusals > 0, 60'000);
        crowd.end();
        controller.release();
        // The arm must come to a standstill.
        QTRY_VERIFY_WITH_TIMEOUT(robot.truth().tcpSpeed.linear.norm() < 0.001, 60'000);
        QTRY_COMPARE_WITH_TIMEOUT(receiver.state(), receive::ReceiverState::Receiving, 60'000);
        const auto again = controller.takeControl(testTimeout());
        QVERIFY2(again.ok(), why(again));
    }
};

QTEST_GUILESS_MAIN(TestBrokenLink)
#include "tst_broken_link.moc"
