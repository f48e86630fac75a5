// SPDX-License-Identifier: MIT
#include "robot/simulator/urscript/virtual_machine.h"

#include <algorithm>
#include <cmath>
#include <new>

namespace tiller::simulator::urscript {

Interpreter::Machine::Machine(std::shared_ptr<const Program> p, Host& host, const Limits& limits)
    : program(std::move(p))
    , host_(host)
    , limits_(limits)
    , code_(program->code())
    , mode_(code_)
    , remote_(host)
    , context_{host, limits_, program->kind(), 0, limits.randomSeed, &mode_, &remote_} {
    context_.stepNs = std::llround(host.stepTime() * 1e9);
    globals_.resize(code_.globals.size());
    start(0, -1);
}

Interpreter::Machine::~Machine() {
    stop();
}

// --------------------------------------------------------------------------------------------------- the
// frame

Interpreter::State Interpreter::Machine::runFrame() {
    if (state != State::Running) {
        return state;
    }
    inFrame_ = true;
    hostTold_ = false;
    ++frame;
    beginFrame();
    // Cooperative: a thread runs until it blocks, so nothing else runs between two of its statements,
    // critical section or not, and everything else runs while it waits, critical section or not.
    while (!over_) {
        Thread* const thread = next();
        if (thread == nullptr) {
            break;
        }
        run(*thread);
        removeEnded();
    }
    if (!over_ && program->kind() == ProgramKind::Secondary) {
        fail(*threads_.front(), kTooMuchBehind);
    }
    inFrame_ = false;
    if (stopRequested_ && state == State::Running) {
        state = State::Stopped;
    }
    if (state != State::Running) {
        finishProgram();
    } else if (pauseRequested_) {
        state = State::Paused;
    }
    pauseRequested_ = false;
    return state;
}

void Interpreter::Machine::beginFrame() {
    frameOperations_ = limits_.frameOperations;
    for (const auto& thread : threads_) {
        // What a thread overdrew is paid back from the next slices; what it left over is lost.
        thread->sliceNs = std::min(context_.stepNs, thread->sliceNs + context_.stepNs);
        thread->operations = limits_.threadOperationsPerFrame;
        if (thread->state == Thread::State::Polling) {
            thread->state = Thread::State::Ready;
            thread->sliceNs = context_.stepNs;
        }
    }
    mode_.beginFrame();
    pollMotion();
    abortMove();
}

// `abort` in interpreter mode: the move becomes a stop, and is over when that is.
void Interpreter::Machine::abortMove() {
    constexpr double kDeceleration = 4.0;  // [rad/s2]
    if (mode_.takeAbort() && context_.motionOwner == 0 && context_.abortable) {
        context_.abortable = !host_.startMotion(0, StopJ{kDeceleration}).ok();
    }
}

// Before any thread runs: one that waits for its motion must not block another that may command by now.
void Interpreter::Machine::pollMotion() {
    if (context_.motionOwner < 0) {
        return;
    }
    const Result<bool> finished = host_.motionFinished(context_.motionOwner);
    if (!finished.ok()) {
        const Error e = finished.error();
        const QString& text = e.controllerMessage.isEmpty() ? e.context : e.controllerMessage;
        fail(*find(context_.motionOwner), text.toStdString());
    } else if (*finished) {
        context_.motionOwner = -1;
    }
}

bool Interpreter::Machine::runnable(const Thread& thread) const {
    if (thread.sliceNs <= 0) {
        return false;
    }
    return thread.state == Thread::State::Ready ||
           (thread.state == Thread::State::Joining && find(thread.joined) == nullptr);
}

// Who has most of the frame left; among equals the eldest.
Interpreter::Machine::Thread* Interpreter::Machine::next() const {
    Thread* best = nullptr;
    for (const auto& thread : threads_) {
        if ((best == nullptr || thread->sliceNs > best->sliceNs) && runnable(*thread)) {
            best = thread.get();
        }
    }
    return best;
}

void Interpreter::Machine::run(Thread& thread) {
    thread.state = Thread::State::Ready;
    const std::int64_t before = thread.operations;
    try {
        execute(thread);
    } catch (const Fault& f) {
        fail(thread, f.text);
        if (error) {
            error->overrun = f.overrun;
        }
    } catch (const std::bad_alloc&) {
        fail(thread, "Out of memory");
    }
    frameOperations_ -= before - thread.operations;
    if (stopRequested_) {
        over_ = true;
    }
}

ast::Position Interpreter::Machine::position(const Thread& thread) {
    const CallFrame& call = thread.calls.back();
    // pc is the next instruction, but a builtin that waits is its own next one.
    const int pc = std::max(thread.again ? call.pc : call.pc - 1, 0);
    return call.function->positions[static_cast<std::size_t>(pc)];
}

void Interpreter::Machine::fail(const Thread& thread, const std::string& text) {
    if (state != State::Running) {
        return;
    }
    RuntimeError e;
    e.text = text;
    if (!thread.calls.empty()) {
        const ast::Position at = position(thread);
        e.line = at.line;
        e.column = at.column;
    }
    error = std::move(e);
    state = State::Failed;
    over_ = true;
}

void Interpreter::Machine::finishProgram() {
    over_ = true;
    threads_.clear();
    context_.motionOwner = -1;
    if (!hostTold_) {
        hostTold_ = true;
        host_.programEnded(program->kind());
    }
}

// ------------------------------------------------------------------------------------------- control from
// outside

void Interpreter::Machine::pause() {
    if (state != State::Running) {
        return;
    }
    if (inFrame_) {
        pauseRequested_ = true;
    } else {
        state = State::Paused;
    }
}

void Interpreter::Machine::resume() {
    pauseRequested_ = false;
    if (state == State::Paused) {
        state = State::Running;
    }
}

void Interpreter::Machine::stop() {
    if (state >= State::Finished) {
        return;
    }
    if (inFrame_) {
        stopRequested_ = true;
        return;
    }
    state = State::Stopped;
    finishProgram();
}

// -------------------------------------------------------------------------------------------------------
// threads

Interpreter::Machine::Thread& Interpreter::Machine::start(int function, ThreadId parent) {
    auto thread = std::make_unique<Thread>();
    thread->id = nextId_++;
    thread->parent = parent;
    thread->sliceNs = limits_.threadsBeginNextFrame && parent >= 0 ? 0 : context_.stepNs;
    thread->operations = limits_.threadOperationsPerFrame;
    thread->calls.reserve(8);
    threads_.push_back(std::move(thread));
    Thread& started = *threads_.back();
    enter(started, function, 0);
    return started;
}

Interpreter::Machine::Thread* Interpreter::Machine::find(ThreadId id) const {
    for (const auto& thread : threads_) {
        if (thread->id == id && thread->state != Thread::State::Ended) {
            return thread.get();
        }
    }
    return nullptr;
}

void Interpreter::Machine::endThread(Thread& thread) {
    thread.state = Thread::State::Ended;
    if (context_.motionOwner == thread.id) {
        context_.motionOwner = -1;
        host_.motionAbandoned(thread.id);
    }
    // What it started belongs to whoever started it, so that killing an ancestor still reaches it.
    for (const auto& other : threads_) {
        if (other->parent == thread.id) {
            other->parent = thread.parent;
        }
    }
}

void Interpreter::Machine::killTree(ThreadId id) {
    Thread* thread = find(id);
    if (thread == nullptr) {
        return;
    }
    std::vector<ThreadId> doomed{id};
    for (std::size_t i = 0; i < doomed.size(); ++i) {
        for (const auto& other : threads_) {
            if (other->parent == doomed[i] && other->state != Thread::State::Ended) {
                doomed.push_back(other->id);
            }
        }
    }
    for (const ThreadId each : doomed) {
        endThread(*find(each));
    }
}

void Interpreter::Machine::removeEnded() {
    std::erase_if(threads_, [](const auto& thread) { return thread->state == Thread::State::Ended; });
}

ThreadId Interpreter::Machine::handleOf(const Value& v) const {
    if (!v.isNumber()) {
        fault(std::string("Type error: a thread handle is an integer, not ") + v.typeName());
    }
    // The main body has no handle: 0 means no thread.
    const double d = v.number();
    return d >= 1 && d < static_cast<double>(nextId_) ? static_cast<ThreadId>(d) : -1;
}

int Interpreter::Machine::currentLine() const {
    const Thread* main = find(0);
    if (frame == 0 || main == nullptr || main->calls.empty()) {
        return 0;
    }
    return position(*main).line;
}

int Interpreter::Machine::threadCount() const {
    return static_cast<int>(std::count_if(threads_.begin(), threads_.end(), [](const auto& thread) {
        return thread->state != Thread::State::Ended;
    }));
}

// Nothing may run in code that goes: threads that do are ended.
void Interpreter::Machine::forgetLines() {
    for (const auto& thread : threads_) {
        if (thread->id != 0 && thread->state != Thread::State::Ended &&
            std::any_of(thread->calls.begin(), thread->calls.end(),
                        [this](const CallFrame& call) { return call.unit != &code_.program; })) {
            endThread(*thread);
        }
    }
    mode_.forget();
    globals_.resize(code_.globals.size());
}

const Value* Interpreter::Machine::global(std::string_view name) const {
    const auto it = std::find(code_.globals.begin(), code_.globals.end(), name);
    if (it == code_.globals.end()) {
        return nullptr;
    }
    const std::size_t slot = static_cast<std::size_t>(it - code_.globals.begin());
    return slot >= globals_.size() || globals_[slot].isUnset() ? nullptr : &globals_[slot];
}

// ---------------------------------------------------------------------------------------------------------
// the face

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
    return machine_->frame;
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
