// SPDX-License-Identifier: MIT
#pragma once

// Rules of assignment, access to elements and members, and the methods of values. All functions throw Fault
// for operations that the language does not permit.

#include <cstddef>
#include <string>

#include "robot/simulator/urscript/bytecode.h"
#include "robot/simulator/urscript/value.h"

namespace tiller::simulator::urscript {

/// name  variable name for messages
void assign(Value& variable, Value v, const std::string& name);
/// Returns the value `steps` levels down, unshared for writing. Advances `indices` past the indices used.
Value& descend(Value& root, const Path& path, std::size_t steps, const Value*& indices);
/// Assigns `element` to the element or member of `holder` that the last step of a path selects.
void assignElement(Value& holder, const Path::Part& part, const Value* indices, Value element);
void checkBounds(const Value& root, std::size_t listLength);
Value applyMethod(Value& object, const MethodCall& call, const Value* arguments);

}  // namespace tiller::simulator::urscript
