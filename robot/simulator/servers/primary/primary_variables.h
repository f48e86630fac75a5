// SPDX-License-Identifier: MIT
#pragma once

// The global variables of the running program for primary clients, package type 25. The names are sent once,
// and the values when they change. Every value ends with a line break; the elements of a list do not. A
// struct has no encoding and is sent as None. Source: client interface manual, "Variable values", and clients
// that read this package.

#include <cstdint>
#include <vector>

#include "robot/simulator/plant/primary_messages.h"

namespace tiller::simulator::urscript {
class Interpreter;
class Value;
}  // namespace tiller::simulator::urscript

namespace tiller::simulator::primary {

/// The variables in one or more packages, each small enough for every client. The bodies have no time stamp,
/// so that they can be compared.
struct VariableBodies {
    std::vector<Bytes> names, values;
};
/// Global variables of the program; empty if it has no variables.
VariableBodies variablesOf(const urscript::Interpreter& program, const SoftwareVersion& software);
/// Adds the package frame to a body.
Bytes variablePackage(std::uint64_t timestampNs, const Bytes& body);

}  // namespace tiller::simulator::primary
