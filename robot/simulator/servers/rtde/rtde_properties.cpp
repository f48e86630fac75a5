// SPDX-License-Identifier: MIT
#include "robot/simulator/servers/rtde/rtde_properties.h"

#include "robot/simulator/net/byte_writer.h"

namespace tiller::simulator {

namespace {

/// Encodes kind and subtype in the two upper bytes.
constexpr std::uint32_t hardware(std::uint32_t kind, std::uint32_t subtype) {
    return (kind << 24) | (subtype << 16);
}

/// Appends the value of a property. Returns the name of its type; empty if the property is unknown.
std::string_view append(ByteWriter& values, std::string_view name, const SoftwareVersion& software) {
    if (name == "v1.software.version") {
        // The lowest 16 bits are reserved.
        values.u64((std::uint64_t{software.major} << 48) | (std::uint64_t{software.minor} << 32) |
                   (std::uint64_t{software.bugfix & 0xFFFFU} << 16));
        return "UINT64";
    }
    if (name == "v1.control_box.type") {
        values.u32(hardware(5, 2));
        return "UINT32";
    }
    if (name == "v1.robot_arm.tool_flange.type") {
        values.u32(hardware(1, 0));
        return "UINT32";
    }
    return {};
}

}  // namespace

bool hasProperties(const SoftwareVersion& software) {
    return software >=
           (software.isPolyScopeX() ? SoftwareVersion{10, 15, 0, 0} : SoftwareVersion{5, 26, 0, 0});
}

void writeProperties(rtde::Bytes& out, const std::vector<std::string>& names,
                     const SoftwareVersion& software) {
    std::string types;
    rtde::Bytes values;
    ByteWriter writer(values);
    bool all = true;
    for (const std::string& name : names) {
        const std::string_view type = append(writer, name, software);
        types += types.empty() ? "" : ",";
        types += type.empty() ? "NOT_FOUND" : type;
        all = all && !type.empty();
    }
    rtde::writeReadPropertiesReply(out, types, all ? rtde::ByteView(values) : rtde::ByteView());
}

}  // namespace tiller::simulator
