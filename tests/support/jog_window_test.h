// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Common parts of the jog tests. For each test function, they provide the real window in control of a
// simulated robot, its buttons, its keyboard and a stick.

#include <QTest>
#include <memory>
#include <optional>

#include "tests/support/window_bench.h"
#include "tests/ui/jog_fixture.h"
#include "widgets/jog/keyboard_jog.h"

namespace tiller::test {

class JogWindowTest : public QObject {
    Q_OBJECT

protected:
    /// Limits of the jog contract.
    static constexpr int kReleaseToStandstillMs = 100;

    struct Bench : WindowBench {
        // Input of a gamepad that is held; empty without a gamepad.
        std::optional<Deflection> device;
    };
    std::unique_ptr<Bench> bench_;

    VirtualCell& cell() { return bench_->cell; }
    app::MainWindow& window() { return bench_->window; }
    HoldToRunButton& key(const char* name) { return bench_->find<HoldToRunButton>(name); }
    KeyboardJog& keyboard() { return *window().findChild<KeyboardJog*>(); }

    /// The input of a stick that is pushed upwards.
    static Deflection tilted() {
        Deflection stick;
        stick.deadMan = true;
        stick.axes[2] = 1;
        return stick;
    }
    void jog(const char* name, int ms) {
        press(key(name));
        cell().advanceMs(ms);
        release(key(name));
        QVERIFY(timeToStandstill(cell()) >= 0);
        cell().advanceMs(40);
    }

private Q_SLOTS:
    void init() {
        bench_ = std::make_unique<Bench>();
        bench_->show();
        QVERIFY2(cell().bringUp(), qPrintable(cell().what()));
        driveKeys(cell(), window().jogColumn().holdKeys(), &window().jogColumn().axisJog());
        cell().everyRefresh = [this, pump = cell().everyRefresh] {
            if (bench_->device) {
                window().jogColumn().axisJog().setInput(*bench_->device);
            }
            pump();
        };
        cell().advanceMs(40);
    }
    void cleanup() { bench_.reset(); }
};

}  // namespace tiller::test
