// SPDX-License-Identifier: MIT
#pragma once

// A client that behaves like ur_rtde 1.5.8, as seen in its network traffic: its start-up sequence, its
// recipes with trailing commas, its register protocol, and its reaction to stops. It runs in virtual time:
// each wait advances the controller by one period and reads one package.

#include <array>
#include <initializer_list>
#include <memory>
#include <optional>

#include "tests/integration/clients/register_script.h"
#include "tests/support/stepped_client.h"

namespace tiller::test {

class RegisterClient : public SteppedClient {
public:
    enum Recipe : char {
        kMove = 1,
        kServo,
        kForce,
        kNothing,
        kServoCircular,
        kSix,
        kFour,
        kOne,
        kInt,
        kFourteen,
        kKick,
        kTwelve,
        kSpeed,
        kJog,
        kPath,
        kUntilContact,
        kFreedrive,
        kExternalForce,
        kSensor,
        kStop
    };
    struct State {
        quint32 robotBits = 0;
        quint32 safetyBits = 0;
        quint32 runtime = 0;
        std::array<qint32, 3> ints{};
        Six doubles{};
    };

    RegisterClient(VirtualRobot& robot, int offset = 0) : SteppedClient(robot), offset_(offset) {}

    /// Performs the start-up step by step. Where ur_rtde would give up, returns false with the step in
    /// `trouble`.
    bool connect();
    bool upload(const QByteArray& path = {});

    /// Follows the command function of ur_rtde step by step, and returns false where that function returns
    /// false.
    bool command(Recipe recipe, int id, std::initializer_list<double> doubles = {},
                 std::initializer_list<int> ints = {});
    /// Sends a command without waiting for its completion.
    bool realtime(Recipe recipe, int id, std::initializer_list<double> doubles = {},
                  std::initializer_list<int> ints = {}) {
        return waitReady() && send(recipe, id, doubles, ints);
    }
    bool send(Recipe recipe, int id, const std::vector<double>& doubles, const std::vector<int>& ints);
    bool clear() { return send(kNothing, 0, {}, {}); }
    /// Advances by control periods.
    void step(int ticks = 1) override;
    /// Ends the script in the same way as the path and custom-script functions of ur_rtde.
    bool stopScript();
    void disconnect();

    const State& state() const { return state_; }
    simulator::SimulatedState truth() const { return robot_.controller.truth(); }
    RawDashboard& dashboard() { return *dashboard_; }
    RawClient& scriptSocket() { return *script_; }

private:
    bool waitReady();
    bool inMode(quint32 safetyBit) const { return (state_.safetyBits >> safetyBit & 1U) != 0; }

    int offset_;
    std::unique_ptr<RawDashboard> dashboard_;
    std::unique_ptr<RawRtde> rtde_;
    std::unique_ptr<RawClient> script_;
    State state_;
};

}  // namespace tiller::test
