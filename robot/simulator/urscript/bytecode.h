// SPDX-License-Identifier: MIT
#pragma once

// The executable form of a program: code of a stack machine, one sequence per function. Variables are slot
// numbers and callees are indices, so that no names are looked up at run time.

#include <cstdint>
#include <string>
#include <vector>

#include "robot/simulator/urscript/ast.h"
#include "robot/simulator/urscript/host.h"
#include "robot/simulator/urscript/program.h"
#include "robot/simulator/urscript/value.h"

namespace tiller::simulator::urscript {

enum class Op : std::uint8_t {
    // values; b = index or immediate
    PushConstant,
    PushInt,
    PushTrue,
    PushFalse,
    PushNone,
    PushUnset,  // value of an omitted argument
    LoadLocal,
    LoadGlobal,
    StoreLocal,
    StoreGlobal,
    DeclareLocal,  // `local x = v`: discards the old value and its type
    StorePath,     // b = path; stack: indices..., value
    Pop,
    // operators
    Add,
    Subtract,
    Multiply,
    Divide,
    Modulo,
    Negate,
    Plus,
    Not,
    Xor,
    ToBool,
    Equal,
    NotEqual,
    Less,
    Greater,
    LessEqual,
    GreaterEqual,
    // composites
    MakePose,
    MakeList,    // b = number of elements
    MakeStruct,  // b = index into shapes
    Index,       // one index
    Index2,      // row, column
    Member,      // b = constant (name)
    // control; b = target
    Jump,
    JumpIfFalse,
    JumpIfFalseKeep,  // keeps the bool for `and`, `or` only if it jumps
    JumpIfTrueKeep,
    JumpIfSet,  // a = local; skips the default value of a passed parameter
    // calls
    Call,         // b = function, a = arguments
    CallBuiltin,  // b = builtin, a = arguments
    CallMethod,   // b = index into methods
    Return,       // the value is on the stack
    ReturnNone,
    Throw,  // b = constant (text)
    // threads
    Run,  // b = function
    Join,
    Kill,
    EnterCritical,
    ExitCritical,
    Halt,
    Pause,
    Label,  // a unused, b = index into labels
};

struct Instruction {
    Op op;
    std::uint16_t a = 0;
    std::int32_t b = 0;
};

/// Target of a nested assignment or a method call: a variable and the steps to the element.
struct Path {
    enum class Step : std::uint8_t { Index, Index2, Member };
    bool global = false;
    int slot = 0;
    using Part = std::pair<Step, std::string>;
    std::vector<Part> steps;
    int indexValues = 0;  ///< number of stack values used by the steps
};

enum class Method : std::uint8_t {
    Unknown,
    Append,
    Pop,
    Insert,
    Extend,
    Remove,
    Slice,
    Clear,
    Length,
    Capacity,
    ExcessCapacity,
    ToString
};

struct MethodCall {
    Method method = Method::Unknown;
    std::string name;
    int arguments = 0;
    bool onPath = false;  ///< false: the object is on the stack below the arguments
    Path path;
};

struct FunctionCode {
    std::string name;
    ast::FunctionKind kind = ast::FunctionKind::Def;
    int parameters = 0;
    int locals = 0;  ///< parameters included
    int stack = 0;   ///< maximum stack depth for operands
    std::vector<Instruction> code;
    std::vector<ast::Position> positions;  ///< one per instruction in `code`
    std::vector<std::string> localNames;
    std::vector<bool> optional;  ///< for each parameter: true if it has a default
    bool outermost = false;      ///< defined directly in the program or in a line of interpreter mode
};

struct Bytecode {
    std::string name;
    ProgramKind kind = ProgramKind::Main;
    bool raw = false;
    bool commandsMotion = false;
    bool clearsInterpreter = false;       ///< contains a call of clear_interpreter()
    CompileOptions options;               ///< also used for the lines of interpreter mode
    std::vector<FunctionCode> functions;  ///< [0] is the main body
    std::vector<Value> constants;
    std::vector<std::string>
        globals;  ///< names of all globals, or of those that an interpreter mode line adds
    std::vector<Path> paths;
    std::vector<MethodCall> methods;
    std::vector<std::vector<std::string>> shapes;  ///< member names of struct literals
    struct LabelText {
        int number;
        std::string text;
    };
    std::vector<LabelText> labels;
};

}  // namespace tiller::simulator::urscript
