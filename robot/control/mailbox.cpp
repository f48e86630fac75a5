// SPDX-License-Identifier: MIT
#include "robot/control/mailbox.h"

namespace tiller::control {

MotionId Mailbox::start(MotionCommand command, std::int64_t nowNs) {
    const std::lock_guard lock(callers_);
    // The time goes first: the control thread must never see the new motion with the old one's last refresh.
    refreshedNs_.store(nowNs, std::memory_order_release);
    command.id = epoch_.beginMotion(nowNs);
    publish(command);
    return command.id;
}

bool Mailbox::refresh(MotionId motion, std::int64_t nowNs) {
    const std::lock_guard lock(callers_);
    return refreshLocked(motion, nullptr, nowNs);
}

bool Mailbox::refresh(MotionId motion, const JogTarget& target, std::int64_t nowNs) {
    const std::lock_guard lock(callers_);
    return refreshLocked(motion, &target, nowNs);
}

bool Mailbox::refreshLocked(MotionId motion, const JogTarget* target, std::int64_t nowNs) {
    if (!epoch_.isActive(motion) || last_.id != motion) {
        return false;
    }
    if (last_.held && nowNs - refreshedNs_.load(std::memory_order_acquire) > kHoldTimeNs) {
        epoch_.end(motion, StopCause::EventLoopStalled, nowNs);
        return false;
    }
    refreshedNs_.store(nowNs, std::memory_order_release);
    if (target != nullptr && last_.kind == MotionCommand::Kind::Jog && last_.jog != *target) {
        MotionCommand changed = last_;
        changed.jog = *target;
        publish(changed);
    }
    return epoch_.isActive(motion);
}

void Mailbox::publish(const MotionCommand& command) {
    last_ = command;
    slots_[back_] = command;
    back_ = middle_.exchange(back_ | kFresh, std::memory_order_acq_rel) & ~kFresh;
}

const MotionCommand* Mailbox::active(std::int64_t nowNs) {
    if ((middle_.load(std::memory_order_relaxed) & kFresh) != 0) {
        front_ = middle_.exchange(front_, std::memory_order_acq_rel) & ~kFresh;
    }
    const MotionCommand& command = slots_[front_];
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
