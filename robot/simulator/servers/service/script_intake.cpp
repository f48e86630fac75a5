// SPDX-License-Identifier: MIT
#include "robot/simulator/servers/service/script_intake.h"

#include <array>
#include <string_view>

#include "robot/simulator/controller/controller_model.h"
#include "robot/simulator/programs/program_runner.h"

namespace tiller::simulator {

namespace {
constexpr std::size_t kScriptShare = 256 * 1024;  ///< maximum number of bytes read from one client per call
constexpr std::int32_t kReadOnlyInLocal = 210;
}  // namespace

void ScriptIntake::read(Peer& peer, ControllerModel* plant) {
    std::array<std::uint8_t, 16 * 1024> buffer;
    std::size_t total = 0;
    while (peer.isOpen() && total < kScriptShare) {
        const std::size_t got = peer.receive(buffer);
        if (got == 0) {
            break;
        }
        total += got;
        if (plant != nullptr && mayWrite_) {
            splitter_.feed(std::string_view(reinterpret_cast<const char*>(buffer.data()), got));
        }
    }
    if (plant == nullptr || total == 0) {
        return;
    }
    if (!mayWrite_) {
        plant->publish(primary::errorCode(plant->timestampNs(),
                                          {kReadOnlyInLocal, 0, primary::ReportLevel::Violation,
                                           "socket is read-only while the robot is in local control"}));
        return;
    }
    while (const auto unit = splitter_.next()) {
        plant->programs().submit(*unit);
    }
}

}  // namespace tiller::simulator
