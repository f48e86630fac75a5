// SPDX-License-Identifier: MIT
#pragma once

// The dashboard service, port 29999: one line per request, one line per reply. Source: Dashboard Server
// guide.

#include "robot/simulator/net/line_server.h"
#include "robot/simulator/servers/service/dashboard_commands.h"

namespace tiller::simulator {

class DashboardServer final : public LineServer {
public:
    DashboardServer(ControllerModel& plant, ProgramStore& store) : commands_(plant, store) {}

protected:
    std::uint64_t tagOfNewClient() override { return commands_.rightsOfNewClient(); }
    std::string greeting() override { return "Connected: Universal Robots Dashboard Server\n"; }
    LineAnswer answer(std::string_view line, std::uint64_t rights) override {
        DashboardCommands::Reply reply = commands_.run(line, rights);
        return {std::move(reply.line) + '\n', reply.closes};
    }

private:
    DashboardCommands commands_;
};

}  // namespace tiller::simulator
