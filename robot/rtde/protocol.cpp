// SPDX-License-Identifier: MIT
#include "robot/rtde/protocol.h"

#include <array>

namespace tiller::rtde {

namespace {

constexpr std::array kAllDataTypes = {
    DataType::Bool,   DataType::UInt8,    DataType::UInt32,   DataType::UInt64,       DataType::Int32,
    DataType::Double, DataType::Vector3D, DataType::Vector6D, DataType::Vector6Int32, DataType::Vector6UInt32,
};

}  // namespace

const char* packageTypeName(PackageType type) {
    switch (type) {
        case PackageType::RequestProtocolVersion:
            return "RTDE_REQUEST_PROTOCOL_VERSION";
        case PackageType::GetUrControlVersion:
            return "RTDE_GET_URCONTROL_VERSION";
        case PackageType::TextMessage:
            return "RTDE_TEXT_MESSAGE";
        case PackageType::Data:
            return "RTDE_DATA_PACKAGE";
        case PackageType::SetupOutputs:
            return "RTDE_CONTROL_PACKAGE_SETUP_OUTPUTS";
        case PackageType::SetupInputs:
            return "RTDE_CONTROL_PACKAGE_SETUP_INPUTS";
        case PackageType::Start:
            return "RTDE_CONTROL_PACKAGE_START";
        case PackageType::Pause:
            return "RTDE_CONTROL_PACKAGE_PAUSE";
        case PackageType::ReadProperties:
            return "RTDE_READ_PROPERTIES";
    }
    return "unknown";
}

const char* dataTypeName(DataType type) {
    switch (type) {
        case DataType::Bool:
            return "BOOL";
        case DataType::UInt8:
            return "UINT8";
        case DataType::UInt32:
            return "UINT32";
        case DataType::UInt64:
            return "UINT64";
        case DataType::Int32:
            return "INT32";
        case DataType::Double:
            return "DOUBLE";
        case DataType::Vector3D:
            return "VECTOR3D";
        case DataType::Vector6D:
            return "VECTOR6D";
        case DataType::Vector6Int32:
            return "VECTOR6INT32";
        case DataType::Vector6UInt32:
            return "VECTOR6UINT32";
    }
    return "";
}

std::optional<DataType> dataTypeByName(std::string_view name) {
    for (const DataType type : kAllDataTypes) {
        if (name == dataTypeName(type)) {
            return type;
        }
    }
    return std::nullopt;
}

}  // namespace tiller::rtde
