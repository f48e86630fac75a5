// SPDX-License-Identifier: MIT
#pragma once

// Common parts of the tests of ur_rtde's control interface. For each test function, there is a simulated
// robot and an interface in control.

#include <ur_rtde/rtde_control_interface.h>

#include <QObject>
#include <cmath>
#include <memory>
#include <vector>

#include "tests/integration/ur_rtde/ur_rtde_cell.h"

namespace tiller::test {

using List = std::vector<double>;

inline const List kStart{-1.6007, -1.7271, -2.2030, -0.8080, 1.5951, -0.0310};

inline List with(List values, std::size_t index, double change) {
    values[index] += change;
    return values;
}

inline bool near(const List& a, const List& b, double tolerance = 1e-3) {
    if (a.size() != b.size()) {
        return false;
    }
    for (std::size_t i = 0; i < a.size(); ++i) {
        if (!(std::abs(a[i] - b[i]) < tolerance)) {
            return false;
        }
    }
    return true;
}

inline List jointsOf(const simulator::SimulatedState& truth) {
    const auto q = truth.q.array();
    return {q.begin(), q.end()};
}

inline List poseOf(const simulator::SimulatedState& truth) {
    const auto pose = truth.tcpPose.array();
    return {pose.begin(), pose.end()};
}

// The measured speeds are noisy.
inline bool stands(const simulator::SimulatedState& truth) {
    return truth.qd.values.cwiseAbs().maxCoeff() < 5e-3;
}

class UrRtdeControlTest : public QObject {
    Q_OBJECT

protected:
    List joints() const { return jointsOf(cell_->robot.truth()); }
    List pose() const { return poseOf(cell_->robot.truth()); }
    bool untilStanding() { return cell_->until(stands); }
    bool untilMoving() {
        return cell_->until([](const simulator::SimulatedState& truth) { return !stands(truth); });
    }
    bool untilNotRunning() {
        return cell_->until(
            [](const simulator::SimulatedState& t) { return t.runtimeState == RuntimeState::Stopped; });
    }

    std::unique_ptr<UrRtdeCell> cell_;
    std::unique_ptr<ur_rtde::RTDEControlInterface> control_;

private Q_SLOTS:
    void init() {
        cell_ = std::make_unique<UrRtdeCell>();
        control_ = std::make_unique<ur_rtde::RTDEControlInterface>(cell_->host());
    }
    void cleanup() {
        control_.reset();
        cell_.reset();
    }
};

}  // namespace tiller::test
