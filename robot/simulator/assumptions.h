// SPDX-License-Identifier: MIT
#pragma once

// What public sources leave open about a real controller, and decides whether and when the arm stops. Each
// fact is a switch with every reading it could have, so that clients can be shown to be right whichever is
// true. The table in README.md says where each comes from and what depends on it.

#include <QString>
#include <QStringList>
#include <cstdint>
#include <string>
#include <vector>

#include "robot/core/result.h"

namespace tiller::simulator {

/// The first reading of each is the default: what the vendor's simulator or most sources suggest.
struct Assumptions {
    enum class Time : std::uint8_t { Real, Scaled };
    Time stops = Time::Real;         ///< stopj and stopl are not, or are, slowed by the speed slider
    Time programStops = Time::Real;  ///< the same for protective stops and the end of a program
    enum class SpeedCommands : std::uint8_t { Scaled, Real };
    SpeedCommands speedCommands = SpeedCommands::Scaled;  ///< the same for speedj, speedl, servoj and servoc

    enum class Registers : std::uint8_t { Kept, Zeroed };
    Registers registers = Registers::Kept;  ///< inputs whose client has gone
    enum class Inputs : std::uint8_t { Whole, FirstHalf, LastHalf, Scattered };
    /// A package of inputs is applied at once, or over two periods: its first or last half first, or every
    /// other field, whichever they are.
    Inputs inputs = Inputs::Whole;
    enum class Outputs : std::uint8_t { SamePeriod, NextPeriod };
    Outputs outputs = Outputs::SamePeriod;  ///< when RTDE shows what a script has written
    enum class Data : std::uint8_t { Even, Late, Doubled, Bunched };
    Data data = Data::Even;  ///< how RTDE packages leave

    enum class RealtimeBits : std::uint8_t { Double, Integer };
    RealtimeBits realtimeBits = RealtimeBits::Double;  ///< digital inputs and outputs on port 30003

    enum class Safeguard : std::uint8_t { Pauses, Runs };
    Safeguard safeguard = Safeguard::Pauses;  ///< what an open safeguard does to the program
    enum class Reset : std::uint8_t { Resumes, Waits };
    Reset safeguardReset = Reset::Resumes;  ///< what its reset does to the paused program
    enum class ProtectiveStop : std::uint8_t { Ends, Pauses, Resumes };
    /// What happens to a program sent over a socket; Resumes: goes on as soon as the stop is unlocked.
    ProtectiveStop protectiveStop = ProtectiveStop::Ends;
    enum class EmergencyStop : std::uint8_t { Ends, Pauses };
    EmergencyStop emergencyStop = EmergencyStop::Ends;  ///< of a program, whether file or not
    enum class RemoteToLocal : std::uint8_t { Keeps, Ends };
    RemoteToLocal remoteToLocal = RemoteToLocal::Keeps;  ///< the program that runs
    enum class Pause : std::uint8_t { Holds, Frees };
    /// Force mode and freedrive hold still while the program is paused, or go on.
    Pause pause = Pause::Holds;
    enum class StopReturns : std::uint8_t { Standing, Target };
    StopReturns stopReturns = StopReturns::Standing;  ///< stopj and stopl wait for the arm, or its target
    enum class ThreadStart : std::uint8_t { SamePeriod, NextPeriod };
    ThreadStart threadStart = ThreadStart::SamePeriod;  ///< when `run` lets the new thread begin

    enum class EventNode : std::uint8_t { Level, Edge };
    /// An event node of the pendant runs while its condition is true, or once each time it becomes true.
    EventNode eventNode = EventNode::Level;
    enum class UnknownUrcap : std::uint8_t { Refuse, Ask, Skip };
    /// A program with a node of a URCap that has no stand-in does not load, a popup asks the operator in place of
    /// the node, or a text message names the node and the program continues.
    UnknownUrcap unknownUrcap = UnknownUrcap::Refuse;
    enum class RpcFactory : std::uint8_t { Connects, Defers };
    /// rpc_factory() needs a server that accepts, or only the calls of its methods do.
    RpcFactory rpcFactory = RpcFactory::Connects;
    enum class ThreadOrder : std::uint8_t { ThreadsFirst, MainFirst };
    ThreadOrder threadOrder = ThreadOrder::ThreadsFirst;  ///< within a period, if all have waited for it

    /// Deprecated builtins: there, or names the compiler does not know.
    enum class Builtin : std::uint8_t { Present, Missing };
    Builtin teachMode = Builtin::Present;
    Builtin servoc = Builtin::Present;
    Builtin isWithinSafetyLimits = Builtin::Present;
    Builtin setPayloadMass = Builtin::Present;
    Builtin enableExternalFtSensor = Builtin::Present;

    /// Names of the builtins that are missing.
    std::vector<std::string> missingBuiltins() const;
};

/// One switch, by its words.
struct AssumptionInfo {
    QString name;
    QStringList readings;  ///< the first is the default
    QString help;
};

/// All switches, in the order of the struct.
const std::vector<AssumptionInfo>& assumptionTable();
/// Takes "NAME=VALUE".
/// Errors  InvalidArgument, with all names or with the readings of that one
Result<void> assume(Assumptions& assumptions, const QString& words);
/// "NAME=VALUE" of everything that is not as by default, in one line; empty: nothing.
QString assumptionText(const Assumptions& assumptions);
/// A paragraph each, for people.
QString assumptionHelp();

}  // namespace tiller::simulator
