// SPDX-License-Identifier: MIT
#pragma once

// The global variables of the running program for primary clients, package type 25: the names once, the values when
// they change. Source: client interface manual, "Variable values", and clients that read it: every value ends with
// a line break, the elements of a list do not; a struct, which has no encoding, is sent as None.

#include <cstdint>
#include <vector>

#include "robot/simulator/servers/primary/primary_messages.h"

namespace tiller::simulator::urscript {
class Interpreter;
class Value;
}  // namespace tiller::simulator::urscript

namespace tiller::simulator::primary {

/// One or more packages, each small enough for every client. Without time stamp, because `body` is compared.
struct VariableBodies {
    std::vector<Bytes> names, values;
};
/// For the program's own globals; empty for a program without globals.
VariableBodies variablesOf(const urscript::Interpreter& program, const SoftwareVersion& software);
/// Adds the package frame to a body.
Bytes variablePackage(std::uint64_t timestampNs, const Bytes& body);

}  // namespace tiller::simulator::primary
