// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The real window in virtual time, together with another client whose program moves the arm.

#include <QApplication>
#include <QElapsedTimer>
#include <QTest>
#include <functional>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "robot/script/script_client.h"
#include "tests/support/event_spy.h"
#include "tests/support/waiting.h"
#include "tests/support/window_bench.h"
#include "tests/ui/jog_fixture.h"
#include "widgets/jog/device_jog.h"
#include "widgets/status/stop_button.h"

namespace tiller::test {

/// Maximum robot time until the robot has read the stop command and starts to decelerate [ms]. Excludes the
/// deceleration.
inline constexpr int kAtOnceMs = 20;
inline constexpr int kBrakingMs = 1000;
inline constexpr int kForeignTimeoutMs = 20'000;

struct Pad : InputDevice {
    explicit Pad(DeviceReading& r) : reading(r) {}
    QString name() const override { return QStringLiteral("Test pad"); }
    DeviceShape shape() const override { return {}; }
    std::optional<DeviceReading> read() override { return reading; }
    DeviceReading& reading;
};

struct PadSource : DeviceSource {
    explicit PadSource(DeviceReading& r) : reading(r) {}
    std::vector<std::unique_ptr<InputDevice>> appeared() override {
        std::vector<std::unique_ptr<InputDevice>> found;
        if (!std::exchange(given, true)) {
            found.push_back(std::make_unique<Pad>(reading));
        }
        return found;
    }
    DeviceReading& reading;
    bool given = false;
};

enum class Way { StopButton, Escape, Space, Device };
inline constexpr const char* kWays[] = {"STOP", "Esc", "Space", "device"};

struct ForeignProgramBench : WindowBench {
    DeviceReading pad;
    /// Shared, because the window outlives this object.
    std::shared_ptr<QStringList> said = std::make_shared<QStringList>();
    QStringList& errors = *said;
    std::unique_ptr<script::ScriptClient> pendant;

    explicit ForeignProgramBench(const simulator::SimulatorOptions& robot = VirtualCell::options())
        : WindowBench(robot) {
        test::onMessage(window.session().journal(), &window,
                        [all = said](Severity severity, const QString& text) {
                            if (severity == Severity::Error) {
                                *all << text;
                            }
                        });
        window.devices().addSource(std::make_unique<PadSource>(pad));
        show();
    }

    const SessionState& state() { return window.session().state(); }
    bool runs() const { return cell.truth().runtimeState == RuntimeState::Playing; }

    /// Starts a program of another client that rotates the base back and forth.
    bool startProgram(const char* body =
                          "movej([1.0, -1.7, -2.2, -0.8, 1.6, 0], a=2, v=1)\n"
                          "movej([-1.6, -1.7, -2.2, -0.8, 1.6, 0], a=2, v=1)\n") {
        pendant = std::make_unique<script::ScriptClient>(
            cell.robot.listenAddress(), script::kPrimaryPort + cell.robot.options().portOffset);
        return pendant->connect(testTimeout()).ok() &&
               pendant
                   ->send(QStringLiteral("def others():\nwhile True:\n%1sync()\nend\nend\n")
                              .arg(QLatin1String(body)),
                          testTimeout())
                   .ok() &&
               within([this] { return runs() && state().runtimeState == RuntimeState::Playing; });
    }
    bool startMoving() {
        return startProgram() && within([this] {
                   return tcpSpeed(cell) > 0.2 && state().moving &&
                          window.session().services().stopsForeignProgramsAtOnce();
               });
    }
    /// Advances robot and window together until the condition is true. Each step also waits in real time,
    /// because the other clients run in real time.
    bool within(const std::function<bool()>& condition) {
        QElapsedTimer waited;
        waited.start();
        while (!condition() && waited.elapsed() < kForeignTimeoutMs) {
            cell.advanceMs(16);
        }
        return condition();
    }
    /// True if the program ends within kAtOnceMs, the time in which the robot reads the stop command.
    bool stopsAtOnce() {
        for (int ms = 0; ms < kAtOnceMs && runs(); ms += 2) {
            cell.robot.drainSockets();
            cell.advanceMs(2);
        }
        return !runs();
    }
    bool comesToRest() {
        return cell.advanceUntil(
            [this] {
                return cell.truth().runtimeState == RuntimeState::Stopped && standsStill(cell) &&
                       state().runtimeState == RuntimeState::Stopped;
            },
            kBrakingMs);
    }

    void stop(Way way) {
        QWidget* focus = QApplication::focusWidget();
        QWidget* target = focus != nullptr ? focus : QApplication::activeWindow();
        switch (way) {
            case Way::StopButton:
                sendMouse(find<StopButton>("stopButton"), QEvent::MouseButtonPress);
                sendMouse(find<StopButton>("stopButton"), QEvent::MouseButtonRelease);
                break;
            case Way::Escape:
                QTest::keyClick(target, Qt::Key_Escape);
                break;
            case Way::Space:
                QTest::keyClick(target, Qt::Key_Space);
                break;
            case Way::Device:
                pad.stop = true;
                window.devices().poll();
                pad.stop = false;
                window.devices().poll();
                break;
        }
    }
};

}  // namespace tiller::test
