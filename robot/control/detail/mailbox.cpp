// SPDX-License-Identifier: MIT
#include "robot/control/detail/mailbox.h"

#include "robot/control/detail/registers.h"

namespace tiller::control {

void setGateOf(MotionCommand& command, const script::StepGate& gate) {
    const script::VariableChange& change = gate.change;
    command.choice = gate.value();
    command.target = {change.value, static_cast<double>(change.variable), static_cast<double>(change.number)};
}

MotionId Mailbox::start(MotionCommand command, std::int64_t nowNs) {
    const std::lock_guard lock(callers_);
    // Store the time first. Otherwise, the control thread could see the new motion with the previous refresh
    // time.
    refreshedNs_.store(nowNs, std::memory_order_release);
    command.id = epoch_.beginMotion(nowNs);
    publish(command);
    return command.id;
}

MotionId Mailbox::startAfter(std::uint64_t epoch, MotionCommand command, std::int64_t nowNs) {
    const std::lock_guard lock(callers_);
    if (epoch_.current() != epoch) {
        return kNoMotion;
    }
    refreshedNs_.store(nowNs, std::memory_order_release);
    command.id = epoch_.beginMotionAfter(epoch, nowNs);
    if (command.id != kNoMotion) {
        publish(command);
    }
    return command.id;
}

MotionId Mailbox::startUnlessStopped(std::uint64_t stops, MotionCommand command, std::int64_t nowNs) {
    const std::lock_guard lock(callers_);
    const std::int64_t refreshed = refreshedNs_.exchange(nowNs, std::memory_order_acq_rel);
    command.id = epoch_.beginMotionUnlessStopped(stops, nowNs);
    if (command.id == kNoMotion) {
        refreshedNs_.store(refreshed, std::memory_order_release);
    } else {
        publish(command);
    }
    return command.id;
}

bool Mailbox::refresh(MotionId motion, std::int64_t nowNs) {
    const std::lock_guard lock(callers_);
    return isRefreshable(motion, nowNs) && epoch_.isActive(motion);
}

bool Mailbox::refresh(MotionId motion, const JogTarget& target, std::int64_t nowNs) {
    const std::lock_guard lock(callers_);
    if (!isRefreshable(motion, nowNs)) {
        return false;
    }
    if (last_.kind == MotionCommand::Kind::Jog && last_.jog != target) {
        MotionCommand changed = last_;
        changed.jog = target;
        publish(changed);
    }
    return epoch_.isActive(motion);
}

bool Mailbox::change(MotionId motion, const MotionCommand& values, std::int64_t nowNs) {
    const std::lock_guard lock(callers_);
    return replace(motion, values, nowNs);
}

bool Mailbox::setGate(MotionId motion, const script::StepGate& gate) {
    const std::lock_guard lock(callers_);
    if (!epoch_.isActive(motion) || last_.id != motion || last_.kind != MotionCommand::Kind::Script) {
        return false;
    }
    MotionCommand changed = last_;
    setGateOf(changed, gate);
    publish(changed);
    return true;
}

bool Mailbox::replace(MotionId motion, const MotionCommand& values, std::int64_t nowNs) {
    if (!isRefreshable(motion, nowNs) || last_.kind != MotionCommand::Kind::Program) {
        return false;
    }
    MotionCommand changed = values;
    changed.id = last_.id;
    changed.kind = last_.kind;
    changed.held = last_.held;
    changed.program = last_.program;
    changed.limiter = last_.limiter;
    changed.heartbeatTimeout = last_.heartbeatTimeout;
    publish(changed);
    return epoch_.isActive(motion);
}

bool Mailbox::hasAnEnd() {
    const std::lock_guard lock(callers_);
    if (!epoch_.isActive(last_.id)) {
        return false;
    }
    const bool moves = last_.kind == MotionCommand::Kind::MoveJ || last_.kind == MotionCommand::Kind::MoveL;
    const auto program = static_cast<ScriptCommand>(last_.program);
    return moves || (last_.kind == MotionCommand::Kind::Program &&
                     (program == ScriptCommand::MoveJToPose || program == ScriptCommand::MoveLToJoints ||
                      program == ScriptCommand::Section));
}

bool Mailbox::isRefreshable(MotionId motion, std::int64_t nowNs) {
    if (!epoch_.isActive(motion) || last_.id != motion) {
        return false;
    }
    if (last_.held && nowNs - refreshedNs_.load(std::memory_order_acquire) > kHoldTimeNs) {
        epoch_.end(motion, StopCause::EventLoopStalled, nowNs);
        return false;
    }
    refreshedNs_.store(nowNs, std::memory_order_release);
    return true;
}

std::uint64_t Mailbox::stop(const Brake& brake, StopCause cause, std::int64_t nowNs) {
    const std::lock_guard lock(callers_);
    // Publish before the stop, so that the arm brakes as requested from the start. Repeat if another stop has
    // occurred in between.
    Brake chosen = brake;
    chosen.epoch = epoch_.current() + 1;
    brake_.publish(chosen);
    const std::uint64_t made = epoch_.stop(cause, nowNs);
    if (made != chosen.epoch) {
        chosen.epoch = made;
        brake_.publish(chosen);
    }
    return made;
}

Brake Mailbox::brake(std::uint64_t epoch) {
    const Brake& newest = brake_.newest();
    return newest.epoch == epoch ? newest : Brake{};
}

void Mailbox::publish(const MotionCommand& command) {
    last_ = command;
    newest_.publish(command);
}

const MotionCommand* Mailbox::active(std::int64_t nowNs) {
    const MotionCommand& command = newest_.newest();
    if (!epoch_.isActive(command.id)) {
        return nullptr;
    }
    if (command.held && nowNs - refreshedNs_.load(std::memory_order_acquire) > kHoldTimeNs) {
        epoch_.end(command.id, StopCause::EventLoopStalled, nowNs);
        return nullptr;
    }
    return &command;
}

}  // namespace tiller::control
