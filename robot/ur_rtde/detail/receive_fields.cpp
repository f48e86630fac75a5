// SPDX-License-Identifier: MIT
#include "robot/ur_rtde/detail/receive_fields.h"

#include "robot/receive/default_fields.h"

namespace tiller::urrtde {

std::vector<std::string> receiveFields(bool upper) {
    std::vector<std::string> fields = receive::commonFields();
    for (const char* recent : {"ft_raw_wrench", "payload", "payload_cog", "payload_inertia"}) {
        fields.emplace_back(recent);
    }
    receive::addOutputRegisters(fields, upper);
    return fields;
}

}  // namespace tiller::urrtde
