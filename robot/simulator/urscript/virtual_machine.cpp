// SPDX-License-Identifier: MIT
#include "robot/simulator/urscript/virtual_machine.h"

#include <algorithm>
#include <cmath>
#include <new>

namespace tiller::simulator::urscript {

Interpreter::Machine::Machine(std::shared_ptr<const Program> p, Host& host, const Limits& limits)
    : Execution(*p, host, limits), program(std::move(p)) {
    start(0, -1);
}

Interpreter::Machine::~Machine() {
    stop();
}

// ---- the frame --------------------------------------------------------------------------------------------

Interpreter::State Interpreter::Machine::runFrame() {
    if (state != State::Running) {
        return state;
    }
    inFrame_ = true;
    hostNotified_ = false;
    ++frame_;
    beginFrame();
    // Scheduling is cooperative: a thread runs until it blocks. While it waits, other threads run, even in a
    // critical section.
    while (!over_) {
        ScriptThread* const thread = next();
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
        // Time used beyond a slice is deducted from the next slices. Unused time is lost.
        thread->sliceNs = std::min(context_.stepNs, thread->sliceNs + context_.stepNs);
        thread->operations = limits_.threadOperationsPerFrame;
        if (thread->state == ScriptThread::State::Polling) {
            thread->state = ScriptThread::State::Ready;
            thread->sliceNs = context_.stepNs;
        }
    }
    mode_.beginFrame();
    pollMotion();
    abortMove();
}

// `abort` in interpreter mode replaces the move by a stop. The move command completes with the stop.
void Interpreter::Machine::abortMove() {
    constexpr double kDeceleration = 4.0;  // [rad/s2]
    if (mode_.takeAbort() && context_.motionOwner == 0 && context_.abortable) {
        context_.abortable = !host_.startMotion(0, StopJ{kDeceleration}).ok();
    }
}

// This function must be called before any thread runs. Otherwise, a thread that is still waiting for its
// motion could block a thread that starts a command in this frame.
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

bool Interpreter::Machine::runnable(const ScriptThread& thread) const {
    if (thread.sliceNs <= 0) {
        return false;
    }
    return thread.state == ScriptThread::State::Ready ||
           (thread.state == ScriptThread::State::Joining && find(thread.joined) == nullptr);
}

// Returns the thread with the most remaining time. Among equal threads, returns the oldest, but the main body
// last unless limits_.mainFirst is set.
ScriptThread* Interpreter::Machine::next() const {
    const auto precedes = [this](const ScriptThread& later, const ScriptThread& best) {
        const bool mainWaits = !limits_.mainFirst && best.id == 0;
        return later.sliceNs > best.sliceNs || (mainWaits && later.sliceNs == best.sliceNs);
    };
    ScriptThread* best = nullptr;
    for (const auto& thread : threads_) {
        if ((best == nullptr || precedes(*thread, *best)) && runnable(*thread)) {
            best = thread.get();
        }
    }
    return best;
}

void Interpreter::Machine::run(ScriptThread& thread) {
    thread.state = ScriptThread::State::Ready;
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

ast::Position Interpreter::Machine::position(const ScriptThread& thread) {
    const CallFrame& call = thread.calls.back();
    // pc is the next instruction or, in a waiting builtin, the call of that builtin.
    const int pc = std::max(thread.again ? call.pc : call.pc - 1, 0);
    return call.function->positions[static_cast<std::size_t>(pc)];
}

void Interpreter::Machine::fail(const ScriptThread& thread, const std::string& text) {
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
    if (!hostNotified_) {
        hostNotified_ = true;
        host_.programEnded(program->kind());
    }
}

// ---- control by the host ----------------------------------------------------------------------------------

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

// ---- threads ------------------------------------------------------------------------------------------------

ScriptThread& Interpreter::Machine::start(int function, ThreadId parent) {
    auto thread = std::make_unique<ScriptThread>();
    thread->id = nextId_++;
    thread->parent = parent;
    thread->sliceNs = limits_.threadsBeginNextFrame && parent >= 0 ? 0 : context_.stepNs;
    thread->operations = limits_.threadOperationsPerFrame;
    thread->calls.reserve(8);
    threads_.push_back(std::move(thread));
    ScriptThread& started = *threads_.back();
    enter(started, function, 0);
    return started;
}

ThreadId Interpreter::Machine::startThread(int function, ThreadId parent) {
    if (threadCount() >= limits_.threads ||
        threads_.size() >= 8 * static_cast<std::size_t>(limits_.threads)) {
        fault("Too many threads");
    }
    return start(function, parent).id;
}

void Interpreter::Machine::finish() {
    state = State::Finished;
    over_ = true;
}

ScriptThread* Interpreter::Machine::find(ThreadId id) const {
    for (const auto& thread : threads_) {
        if (thread->id == id && thread->state != ScriptThread::State::Ended) {
            return thread.get();
        }
    }
    return nullptr;
}

void Interpreter::Machine::endThread(ScriptThread& thread) {
    thread.state = ScriptThread::State::Ended;
    if (context_.motionOwner == thread.id) {
        context_.motionOwner = -1;
        host_.motionAbandoned(thread.id);
    }
    // The parent adopts the children of the thread, so that killing an ancestor also ends them.
    for (const auto& other : threads_) {
        if (other->parent == thread.id) {
            other->parent = thread.parent;
        }
    }
}

void Interpreter::Machine::killTree(ThreadId id) {
    ScriptThread* thread = find(id);
    if (thread == nullptr) {
        return;
    }
    std::vector<ThreadId> doomed{id};
    for (std::size_t i = 0; i < doomed.size(); ++i) {
        for (const auto& other : threads_) {
            if (other->parent == doomed[i] && other->state != ScriptThread::State::Ended) {
                doomed.push_back(other->id);
            }
        }
    }
    for (const ThreadId each : doomed) {
        endThread(*find(each));
    }
}

void Interpreter::Machine::removeEnded() {
    std::erase_if(threads_, [](const auto& thread) { return thread->state == ScriptThread::State::Ended; });
}

ThreadId Interpreter::Machine::handleOf(const Value& v) const {
    if (!v.isNumber()) {
        fault(std::string("Type error: a thread handle is an integer, not ") + v.typeName());
    }
    // The main body has no handle, so 0 is not a thread.
    const double d = v.number();
    return d >= 1 && d < static_cast<double>(nextId_) ? static_cast<ThreadId>(d) : -1;
}

int Interpreter::Machine::currentLine() const {
    const ScriptThread* main = find(0);
    if (frame_ == 0 || main == nullptr || main->calls.empty()) {
        return 0;
    }
    return position(*main).line;
}

int Interpreter::Machine::threadCount() const {
    return static_cast<int>(std::count_if(threads_.begin(), threads_.end(), [](const auto& thread) {
        return thread->state != ScriptThread::State::Ended;
    }));
}

// Threads that run in removed code must end.
void Interpreter::Machine::forgetLines() {
    for (const auto& thread : threads_) {
        if (thread->id != 0 && thread->state != ScriptThread::State::Ended &&
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

}  // namespace tiller::simulator::urscript
