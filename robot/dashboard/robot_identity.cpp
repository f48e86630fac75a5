// SPDX-License-Identifier: MIT
#include "robot/dashboard/robot_identity.h"

#include "robot/core/robot_model.h"
#include "robot/dashboard/dashboard_client.h"
#include "robot/script/primary_client.h"
#include "robot/script/script_client.h"

namespace tiller::dashboard {

RobotIdentity askIdentity(const Text& host, int portOffset, bool isCb3, const Deadline& deadline) {
    RobotIdentity identity;
    script::PrimaryClientOptions options;
    options.host = host;
    options.port = script::kPrimaryPort + portOffset;
    options.reconnect = false;
    script::PrimaryClient primary(options);
    primary.start();
    if (primary.waitForState(deadline)) {
        const auto configuration = primary.configuration();
        const auto model = configuration ? robotModelByType(configuration->robotType, isCb3) : std::nullopt;
        identity.model = model ? QString::fromLatin1(robotModel(*model).name) : QString();
    }
    primary.stop();
    DashboardClient client(host, kDashboardPort + portOffset);
    if (client.connect(deadline)) {
        if (const auto serial = client.serialNumber(deadline)) {
            identity.serialNumber = *serial;
        }
        client.close();
    }
    return identity;
}

}  // namespace tiller::dashboard
