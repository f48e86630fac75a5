// SPDX-License-Identifier: MIT
#include "robot/simulator/urscript/interpreter.h"

#include "robot/simulator/urscript/virtual_machine.h"

namespace tiller::simulator::urscript {

Interpreter::Interpreter(std::shared_ptr<const Program> program, Host& host, const Limits& limits)
    : machine_(std::make_unique<Machine>(std::move(program), host, limits)) {}
Interpreter::~Interpreter() = default;

Interpreter::State Interpreter::runFrame() {
    return machine_->runFrame();
}
void Interpreter::pause() {
    machine_->pause();
}
void Interpreter::resume() {
    machine_->resume();
}
void Interpreter::stop() {
    machine_->stop();
}
Interpreter::State Interpreter::state() const {
    return machine_->state;
}
const std::optional<RuntimeError>& Interpreter::error() const {
    return machine_->error;
}
const Program& Interpreter::program() const {
    return *machine_->program;
}
int Interpreter::currentLine() const {
    return machine_->currentLine();
}
std::int64_t Interpreter::frame() const {
    return machine_->frame();
}
int Interpreter::threadCount() const {
    return machine_->threadCount();
}
const Value* Interpreter::global(std::string_view name) const {
    return machine_->global(name);
}
InterpreterMode& Interpreter::mode() {
    return machine_->mode();
}

}  // namespace tiller::simulator::urscript
