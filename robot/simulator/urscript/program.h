// SPDX-License-Identifier: MIT
#pragma once

// A compiled script: fully checked, with resolved names, ready to run any number of times. A program is
// immutable, so that threads can share it.

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "robot/core/version.h"
#include "robot/simulator/urscript/host.h"

namespace tiller::simulator::urscript {

struct Bytecode;

/// Why a text cannot run. Line and column are counted from 1.
struct CompileError {
    int line = 0;
    int column = 0;
    std::string text;  ///< message of the controller, e.g. "compile_error_name_not_found:foo:"
};

struct CompileOptions {
    /// Software version that determines the available builtins; empty: all builtins.
    std::optional<SoftwareVersion> version;
    /// If sources only give a range for the first version of a builtin, use the end of the range.
    bool isListed = false;
    /// Builtins that are unavailable although this software version has them.
    std::vector<std::string> missing;
    /// Program name for text without `def`.
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
    /// True for bare statements without `def`.
    bool isRaw() const;
    /// True if the program calls a builtin that moves the arm. Such a raw statement replaces the running
    /// program.
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

/// Compiles one unit: a `def`, a `sec`, or bare statements, which run as a separate program.
/// Threads  any. Depth and memory are limited for any input.
CompileOutcome compile(std::string_view text, const CompileOptions& options = {});

/// True if programs compiled with these options can call this builtin.
bool isAvailable(std::string_view builtin, const CompileOptions& options);

/// True if the name is a keyword or a builtin of any software version, and therefore not permitted for
/// functions.
bool isReservedName(std::string_view name);

}  // namespace tiller::simulator::urscript
