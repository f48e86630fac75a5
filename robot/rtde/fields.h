// SPDX-License-Identifier: MIT
#pragma once

// Every RTDE field there is, as data: what a controller can send and what a client can set. The catalogue
// informs (type, unit, meaning, since when); whether a given robot has a field is the robot's to say, in its
// setup reply.
// Source: RTDE guide, with the additions of newer software noted as unconfirmed.

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "robot/core/version.h"
#include "robot/rtde/protocol.h"

namespace tiller::rtde {

enum class Direction : std::uint8_t {
    Output,  ///< controller to client
    Input,   ///< client to controller
};

/// The first software that has a field.
struct Since {
    static constexpr std::uint32_t kNever = 255;
    SoftwareVersion cb3;      ///< 0.0.0: all; major kNever: no CB3 software has it
    SoftwareVersion eSeries;  ///< 0.0.0: all
    bool confirmed = true;    ///< false: the field exists on recent software, since when is not documented
};

struct Field {
    const char* name = "";
    DataType type = DataType::Double;
    const char* unit = "";  ///< "rad", "N, Nm"; empty for bits, counts and enumerations
    const char* meaning = "";
    Direction direction = Direction::Output;
    Since since;

    std::size_t components() const { return componentCount(type); }  ///< 1, 3 or 6.
    bool isAvailableOn(const SoftwareVersion& version) const;        ///< By its first and last software.
};

/// The catalogue, single fields first, then registers in rising number. Lives for the whole program.
/// Threads  any
std::span<const Field> outputFields();
std::span<const Field> inputFields();  ///< All that clients may send.

/// Case-sensitive, like the controller. Null when there is no such field.
/// Threads  any. Real-time: yes (one hash look-up) after the first call
const Field* findOutput(std::string_view name);
const Field* findInput(std::string_view name);  ///< Null when there is none.

/// The output whose name is most like this one, case ignored, for messages ("did you mean"); empty when none
/// is.
/// Threads  any
std::string_view nearestOutput(std::string_view name);

/// The name of one number of a field, as in recordings: "actual_q_0"; a field of one number keeps its name.
std::string componentName(std::string_view field, DataType type, std::size_t component);

// General purpose registers. Source: RTDE guide.
inline constexpr int kRegisterCount = 48;      ///< integers 0..47 and doubles 0..47
inline constexpr int kBitRegisterCount = 128;  ///< 0..63 only in two packed words, 64..127 only singly
inline constexpr int kFirstUpperRegister = 24;
inline constexpr int kFirstSingleBitRegister = 64;

/// "output_int_register_24", "input_double_register_3", "output_bit_register_64".
std::string intRegisterName(Direction direction, int number);
std::string doubleRegisterName(Direction direction, int number);  ///< "input_double_register_24"
std::string bitRegisterName(Direction direction, int number);     ///< "input_bit_register_64"

}  // namespace tiller::rtde
