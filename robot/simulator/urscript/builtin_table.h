// SPDX-License-Identifier: MIT
#pragma once

// The table of builtin functions: signature with defaults, first version, and implementation. Compiler,
// interpreter and documentation use the same entries.

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "robot/core/version.h"
#include "robot/simulator/urscript/value.h"

namespace tiller::simulator::urscript {

class Call;
enum class Status;

using BuiltinFunction = Status (*)(Call&);

struct BuiltinParameter {
    std::string name;
    std::string alias;  ///< alternative name used by clients, or empty
    bool required = true;
    Value defaultValue;  ///< Unset if the default depends on the robot's state
    std::string defaultText;
};

enum BuiltinFlags : unsigned {
    kPlain = 0,
    kMotion = 1,        ///< commands the arm
    kAnyArguments = 2,  ///< parameters are not checked
    kClearsInterpreter = 4,
};

inline constexpr int kNever = 1000;
/// Placeholder for the minor version of series 3 that was released together with that of series 5, e.g. 3.10
/// with 5.4, and 3.15 with 5.10.
inline constexpr int kInStep = -1;
/// Minor number of the first version that has a function, for each series; 0: all versions of the series.
struct FirstVersions {
    int minor5 = 0;
    int minor10 = 0;
    int minor3 = kInStep;

    int ofSeries3() const;  ///< kNever: no version has the function
    bool isIn(const SoftwareVersion& version) const;
};

/// Software versions that have a function. If sources only give a range for the first version, `listed` is
/// the end of the range: the first versions whose published lists contain the function.
struct Since {
    FirstVersions first;
    std::optional<FirstVersions> listed = {};

    /// isListed  true: use `listed`, the latest possible first version
    bool availableIn(const SoftwareVersion& version, bool isListed = false) const {
        return (isListed && listed ? *listed : first).isIn(version);
    }
};
inline constexpr Since kPolyScopeX{{kNever, 0, kNever}, FirstVersions{kNever, 11, kNever}};
/// The function is not in the list of 3.3, but in the lists of 2019 (3.11 and 5.5).
inline constexpr Since kAfter33{{0, 0, 4}, FirstVersions{5, 0, 11}};
/// The function is not in the lists of 2019, but in the list of 5.15.
inline constexpr Since kAfter2019{{6}, FirstVersions{15}};
/// Like kAfter2019, but first listed in 2021 (5.11), or used by programs saved with 5.11.
inline constexpr Since kAfter2019By2021{{6}, FirstVersions{11}};
/// Like kAfter2019, but used by programs saved with 5.9.
inline constexpr Since kAfter2019By2020{{6}, FirstVersions{9, 0, kNever}};
/// The function is not in the list of 5.15, but in the lists of 5.24 and 10.11.
inline constexpr Since kAfter515{{16, 0, kNever}, FirstVersions{24, 11, kNever}};
/// Client libraries use the function from 5.3 on. Scripts that 3.15 exports also contain it.
inline constexpr Since kTargetWaypointSince{{3, 0, 9}, FirstVersions{3, 0, 15}};
inline constexpr Since kStructSince{{0, 0, 6}};
inline constexpr Since kStringsSince{{2, 0, 8}};
inline constexpr Since kSeries5{{0, 0, kNever}};

/// A row of the tables as written in the source.
struct BuiltinRow {
    const char* signature;  ///< e.g. "movej(q, a=1.4, v=1.05, t=0, r=0)"; `?` after a name: optional, no
                            ///< fixed default; `t|t_min`: an alternative name
    BuiltinFunction function;
    unsigned flags = kPlain;
    Since since = {};
    const char* needs = nullptr;   ///< for absent(): the required equipment, e.g. "a ROS network"
    const char* partly = nullptr;  ///< part of the effect that is not simulated
};

struct Builtin {
    std::string name;
    std::string signature;
    std::vector<BuiltinParameter> parameters;
    BuiltinFunction function = nullptr;
    unsigned flags = kPlain;
    Since since;
    const char* needs = nullptr;
    const char* partly = nullptr;
};

/// All entries, sorted by name.
const std::vector<Builtin>& builtins();
/// Index into builtins(), or -1.
int findBuiltin(std::string_view name);

// The tables, one per file.
std::span<const BuiltinRow> motionBuiltins();
std::span<const BuiltinRow> forceBuiltins();
std::span<const BuiltinRow> superpositionBuiltins();
std::span<const BuiltinRow> stateBuiltins();
std::span<const BuiltinRow> kinematicsBuiltins();
std::span<const BuiltinRow> setupBuiltins();
std::span<const BuiltinRow> programBuiltins();
std::span<const BuiltinRow> stringBuiltins();
std::span<const BuiltinRow> mathBuiltins();
std::span<const BuiltinRow> listBuiltins();
std::span<const BuiltinRow> poseBuiltins();
std::span<const BuiltinRow> socketBuiltins();
std::span<const BuiltinRow> registerBuiltins();
std::span<const BuiltinRow> ioBuiltins();
std::span<const BuiltinRow> worldBuiltins();
std::span<const BuiltinRow> interpreterBuiltins();
std::span<const BuiltinRow> rpcBuiltins();
std::span<const BuiltinRow> modbusBuiltins();
std::span<const BuiltinRow> absentBuiltins();

}  // namespace tiller::simulator::urscript
