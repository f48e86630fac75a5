// SPDX-License-Identifier: MIT
#pragma once

// A client in virtual time. Each wait advances the controller.

#include <array>

#include "tests/support/raw_client.h"

namespace tiller::test {

using Six = std::array<double, 6>;

class SteppedClient {
public:
    explicit SteppedClient(VirtualRobot& robot) : robot_(robot) {}
    virtual ~SteppedClient() = default;

    /// Advances by control periods and reads the data of the robot in each period.
    virtual void step(int ticks = 1) = 0;
    /// Steps until the condition is true, but at most for this virtual time.
    template <class Condition>
    bool until(Condition condition, double seconds) {
        for (int n = static_cast<int>(seconds / robot_.controller.stepTime()); n > 0; --n) {
            if (condition()) {
                return true;
            }
            step();
        }
        return condition();
    }

    QByteArray trouble;  ///< the failed step

protected:
    bool fail(const char* step) {
        trouble = step;
        return false;
    }

    VirtualRobot& robot_;
};

}  // namespace tiller::test
