// SPDX-License-Identifier: MIT
#pragma once

// A script, compiled: checked in full, names resolved, ready to run any number of times. Immutable, so that
// it may be shared between threads.

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "robot/core/version.h"
#include "robot/simulator/urscript/host.h"

namespace tiller::simulator::urscript {

struct Bytecode;

/// Why a text cannot run. Line and column count from 1 in the text as given.
struct CompileError {
    int line = 0;
    int column = 0;
    std::string text;  ///< as the controller words it: "compile_error_name_not_found:foo:"
};

struct CompileOptions {
    /// Software whose builtins exist; none: all of them.
    std::optional<SoftwareVersion> version;
    /// Builtins that do not exist although the software has them by its version.
    std::vector<std::string> missing;
    /// Program name of a text without `def`.
    std::string rawName = "unnamed";
};

class Program {
public:
    explicit Program(std::unique_ptr<const Bytecode> code);
    ~Program();
    Program(const Program&) = delete;
    Program& operator=(const Program&) = delete;

    const std::string& name() const;
    ProgramKind kind() const;
    /// Bare statements, not a `def`.
    bool isRaw() const;
    /// Contains a call of a builtin that moves the arm (a raw statement that does replaces the running
    /// program).
    bool commandsMotion() const;
    const Bytecode& code() const { return *code_; }

private:
    std::unique_ptr<const Bytecode> code_;
};

/// Either a program or an error.
struct CompileOutcome {
    std::shared_ptr<const Program> program;
    CompileError error;
    explicit operator bool() const { return program != nullptr; }
};

/// Compiles one unit: a `def`, a `sec`, or bare statements (run as a program of their own).
/// Threads  any. Bounded in depth and memory for any input.
CompileOutcome compile(std::string_view text, const CompileOptions& options = {});

/// Whether a name is a word of the language or a builtin of any software, so that a function needs another.
bool isReservedName(std::string_view name);

}  // namespace tiller::simulator::urscript
