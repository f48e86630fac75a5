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

/// One or more packages, each small enough for every client. `body` is compared, so without time.
struct VariableBodies {
    std::vector<Bytes> names, values;
};
/// Of the program's own globals; empty for a program without any.
VariableBodies variablesOf(const urscript::Interpreter& program, const SoftwareVersion& software);
/// A body with its frame.
Bytes variablePackage(std::uint64_t timestampNs, const Bytes& body);

}  // namespace tiller::simulator::primary
