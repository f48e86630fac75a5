// SPDX-License-Identifier: MIT
#pragma once

// Options for behaviour of a real controller that public sources leave open and that determines whether and
// when the arm stops. Clients can be tested with every value of each option. The table in README.md lists the
// effects and the sources of each option.

#include <QString>
#include <QStringList>
#include <cstdint>
#include <string>
#include <vector>

#include "robot/core/result.h"

namespace tiller::simulator {

/// The first value of each option is the default. It matches the vendor's simulator or the majority of the
/// sources.
struct BehaviourOptions {
    enum class Time : std::uint8_t { Real, Scaled };
    Time stops = Time::Real;  ///< whether the speed slider slows stopj and stopl
    /// Whether the speed slider slows protective stops and the end of a program.
    Time programStops = Time::Real;
    enum class SpeedCommands : std::uint8_t { Scaled, Real };
    /// Whether the speed slider slows speedj, speedl, servoj and servoc.
    SpeedCommands speedCommands = SpeedCommands::Scaled;

    enum class Registers : std::uint8_t { Kept, Zeroed };
    Registers registers = Registers::Kept;  ///< input registers after the client has disconnected
    enum class Inputs : std::uint8_t { Whole, FirstHalf, LastHalf, Scattered };
    /// Whether a package of inputs is applied at once or over two periods: first half first, last half first,
    /// or scattered fields first.
    Inputs inputs = Inputs::Whole;
    enum class Outputs : std::uint8_t { SamePeriod, NextPeriod };
    Outputs outputs = Outputs::SamePeriod;  ///< when RTDE shows the values written by a script
    enum class Data : std::uint8_t { Even, Late, Doubled, Bunched };
    Data data = Data::Even;  ///< timing of RTDE packages

    enum class RealtimeBits : std::uint8_t { Double, Integer };
    RealtimeBits realtimeBits = RealtimeBits::Double;  ///< format of the digital I/O on port 30003

    enum class Safeguard : std::uint8_t { Pauses, Runs };
    Safeguard safeguard = Safeguard::Pauses;  ///< effect of an open safeguard on the program
    enum class Reset : std::uint8_t { Resumes, Waits };
    Reset safeguardReset = Reset::Resumes;  ///< effect of resetting the safeguard on the paused program
    enum class ProtectiveStop : std::uint8_t { Ends, Pauses, Resumes };
    /// Effect of a protective stop on a program sent over a socket. Resumes: the program continues as soon as
    /// the stop is unlocked.
    ProtectiveStop protectiveStop = ProtectiveStop::Ends;
    enum class EmergencyStop : std::uint8_t { Ends, Pauses };
    EmergencyStop emergencyStop = EmergencyStop::Ends;  ///< effect on the program, loaded or sent
    enum class RemoteToLocal : std::uint8_t { Keeps, Ends };
    RemoteToLocal remoteToLocal = RemoteToLocal::Keeps;  ///< effect of the switch to Local on the program
    enum class Pause : std::uint8_t { Holds, Frees };
    /// Whether force mode and freedrive hold position or continue while the program is paused.
    Pause pause = Pause::Holds;
    enum class StopReturns : std::uint8_t { Standing, Target };
    /// Whether stopj and stopl wait until the arm is at standstill, or only its target.
    StopReturns stopReturns = StopReturns::Standing;
    enum class ThreadStart : std::uint8_t { SamePeriod, NextPeriod };
    ThreadStart threadStart = ThreadStart::SamePeriod;  ///< when a thread started by `run` begins

    enum class EventNode : std::uint8_t { Level, Edge };
    /// Whether an event node of the teach pendant runs while its condition is true, or once each time the
    /// condition becomes true.
    EventNode eventNode = EventNode::Level;
    enum class UnknownUrcap : std::uint8_t { Refuse, Ask, Skip };
    /// Effect of a URCap node without a stand-in: the program does not load, a popup replaces the node and
    /// asks the operator, or a text message names the node and the program continues.
    UnknownUrcap unknownUrcap = UnknownUrcap::Refuse;
    enum class RpcFactory : std::uint8_t { Connects, Defers };
    /// Whether rpc_factory() needs a reachable server, or only the method calls do.
    RpcFactory rpcFactory = RpcFactory::Connects;
    enum class ThreadOrder : std::uint8_t { ThreadsFirst, MainFirst };
    ThreadOrder threadOrder = ThreadOrder::ThreadsFirst;  ///< order of threads that become ready together

    enum class FirstVersions : std::uint8_t { Earliest, Latest };
    /// Availability of functions, fields and commands for which sources only give a range of versions.
    FirstVersions firstVersions = FirstVersions::Earliest;

    /// Whether deprecated builtins are available or unknown to the compiler.
    enum class Builtin : std::uint8_t { Present, Missing };
    Builtin teachMode = Builtin::Present;
    Builtin servoc = Builtin::Present;
    Builtin isWithinSafetyLimits = Builtin::Present;
    Builtin setPayloadMass = Builtin::Present;
    Builtin enableExternalFtSensor = Builtin::Present;

    /// Names of the missing builtins.
    std::vector<std::string> missingBuiltins() const;
};

/// Description of one option.
struct BehaviourOptionInfo {
    QString name;
    QStringList readings;  ///< the first is the default
    QString help;
};

/// All options, in the order of the struct members.
const std::vector<BehaviourOptionInfo>& assumptionTable();
/// Parses "NAME=VALUE".
/// Errors  InvalidArgument, listing all names, or the values of the option
Result<void> assume(BehaviourOptions& assumptions, const QString& words);
/// Returns "NAME=VALUE" for every option that differs from its default, in one line; empty if all have their
/// defaults.
QString assumptionText(const BehaviourOptions& assumptions);
/// Help text with one paragraph per option.
QString assumptionHelp();

}  // namespace tiller::simulator
