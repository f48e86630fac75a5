// SPDX-License-Identifier: MIT
// Sends arbitrary lines to the dashboard and the gripper of one robot, with occasional control periods in
// between. Every command must get one line as its reply, and nothing may crash.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "robot/simulator/controller/controller_model.h"
#include "robot/simulator/equipment/gripper.h"
#include "robot/simulator/programs/program_store.h"
#include "robot/simulator/servers/service/dashboard_commands.h"

using namespace tiller;
using namespace tiller::simulator;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static ControllerModel plant{[] {
        SimulatorOptions options;
        options.poweredOn = true;
        options.fastTransitions = true;
        return options;
    }()};
    static ProgramStore store{QString(), [] { return pendant::PendantSource(); }};
    static DashboardCommands dashboard(plant, store);
    static Gripper gripper;

    std::string_view text(reinterpret_cast<const char*>(data), size);
    while (!text.empty()) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        const std::string_view line = text.substr(0, end);
        text.remove_prefix(std::min(end + 1, text.size()));
        const DashboardCommands::Reply reply = dashboard.run(line, dashboard.rightsOfNewClient());
        if (reply.line.empty()) {
            std::abort();
        }
        gripper.set(line.substr(0, 3), static_cast<int>(line.size()));
        gripper.get(line);
        gripper.step(0.002);
    }
    plant.step();
    plant.takeOutbox();
    while (plant.popups().closeNewest()) {
    }
    return 0;
}
