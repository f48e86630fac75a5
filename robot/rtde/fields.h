// SPDX-License-Identifier: MIT
#pragma once

// The catalogue of RTDE fields: all outputs a controller can send and all inputs a client can set, with type,
// unit, description and the first software version. The catalogue is informative; the setup reply of a robot
// determines whether a field exists. Source: RTDE guide. Fields added by newer software are marked as
// unconfirmed.

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "robot/core/version.h"
#include "robot/rtde/protocol.h"

namespace tiller::rtde {

enum class Direction : std::uint8_t {
    Output,  ///< sent by the controller
    Input,   ///< sent by the client
};

/// The first software version that has a field.
struct Since {
    static constexpr std::uint32_t kNever = 255;
    SoftwareVersion cb3;      ///< 0.0.0: all versions; major kNever: not available on CB3
    SoftwareVersion eSeries;  ///< 0.0.0: all versions
    bool confirmed =
        true;  ///< false: the field exists in recent software, but its first version is not documented
};

struct Field {
    const char* name = "";
    DataType type = DataType::Double;
    const char* unit = "";  ///< e.g. "rad", "N, Nm"; empty for bits, counts and enumerations
    const char* meaning = "";
    Direction direction = Direction::Output;
    Since since;

    /// Number of values in the field: 1, 3 or 6.
    std::size_t components() const { return componentCount(type); }
    /// True if `version` is the first software version of the field or a later one.
    bool isAvailableOn(const SoftwareVersion& version) const;
    /// Like isAvailableOn(), but if the first version is not documented, the field is available only from
    /// 5.25 and 10.12 on, the software versions of the clients that list the field.
    bool isListedOn(const SoftwareVersion& version) const;
};

/// All outputs: first the single fields, then the registers in ascending order. The span remains valid until
/// the program ends.
/// Threads  any
std::span<const Field> outputFields();
std::span<const Field> inputFields();  ///< All inputs, in the same order.

/// Finds an output by name. Case-sensitive, like the controller.
/// Returns  null if there is no such field
/// Threads  any. Real-time: yes (one hash look-up) after the first call
const Field* findOutput(std::string_view name);
const Field* findInput(std::string_view name);  ///< Like findOutput(), for inputs.

/// The output with the most similar name, ignoring case, for messages ("did you mean"). Empty if no name is
/// similar.
/// Threads  any
std::string_view nearestOutput(std::string_view name);

/// Name of one component of a field as used in recordings, e.g. "actual_q_0". A scalar field keeps its name.
std::string componentName(std::string_view field, DataType type, std::size_t component);

// Ranges of the general purpose registers. Source: RTDE guide.
inline constexpr int kRegisterCount = 48;  ///< integers 0..47 and doubles 0..47
inline constexpr int kBitRegisterCount =
    128;  ///< bits 0..63 only in two packed integers, 64..127 only individually
inline constexpr int kFirstUpperRegister = 24;
inline constexpr int kFirstSingleBitRegister = 64;

/// e.g. "output_int_register_24"
std::string intRegisterName(Direction direction, int number);
std::string doubleRegisterName(Direction direction, int number);  ///< e.g. "input_double_register_24"
std::string bitRegisterName(Direction direction, int number);     ///< e.g. "input_bit_register_64"

}  // namespace tiller::rtde
