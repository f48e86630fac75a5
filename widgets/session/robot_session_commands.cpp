// SPDX-License-Identifier: GPL-3.0-or-later

// The part of the session that asks the controller for power, recovery and programs, and asks after what RTDE
// does not tell: the control mode, the operational mode and the loaded program.

#include <utility>

#include "widgets/session/robot_session.h"
#include "widgets/session/session_backend.h"
#include "widgets/session/texts.h"

namespace tiller {
namespace {

using dashboard::RobotService;
using dashboard::ServiceKind;
using std::chrono::milliseconds;

constexpr milliseconds kReplyTime{3000};
/// The Robot API may answer only when it is done.
constexpr milliseconds kDoneTime{10'000};
/// Half of the second within which a switch to Local is to be noticed.
constexpr std::int64_t kAskEveryNs = kNsPerSecond / 2;
/// After so long without an answer of ours it is known that another program has taken our program's place.
constexpr std::int64_t kTakenOverNs = 700 * kNsPerMs;

/// Sends one command and reports a refusal.
template <class Call>
void send(RobotSession& session, const std::unique_ptr<RobotLink>& link, const QString& what, Call call) {
    if (!link) {
        Q_EMIT session.message(Severity::Error, texts::errorText({ErrorCode::NotConnected, what, {}}));
        return;
    }
    link->service->post(
        std::move(call), &session,
        [&session, what](const Result<void>& result) {
            if (result) {
                Q_EMIT session.message(Severity::Info, what, Origin::Operator);
            } else {
                Q_EMIT session.message(
                    Severity::Error,
                    RobotSession::tr("%1 failed. %2").arg(what, texts::errorText(result.error())));
            }
        },
        session.state().service == ServiceKind::RobotApi ? kDoneTime : kReplyTime);
}

}  // namespace

QString commandText(RobotCommand command) {
    switch (command) {
        case RobotCommand::PowerOn:
            return RobotSession::tr("Power on");
        case RobotCommand::ReleaseBrakes:
            return RobotSession::tr("Release brakes");
        case RobotCommand::PowerOff:
            return RobotSession::tr("Power off");
        case RobotCommand::RestartSafety:
            return RobotSession::tr("Restart safety");
        case RobotCommand::ClosePopups:
            return RobotSession::tr("Close popups");
        case RobotCommand::Play:
            return RobotSession::tr("Play program");
        case RobotCommand::Pause:
            return RobotSession::tr("Pause program");
        case RobotCommand::StopProgram:
            return RobotSession::tr("Stop program");
    }
    return {};
}

void RobotSession::perform(RobotCommand command) {
    if (const QString why = texts::serviceObstacle(d_->state, command); !why.isEmpty()) {
        Q_EMIT message(Severity::Error, tr("%1 failed. %2").arg(commandText(command), why));
        return;
    }
    if (command == RobotCommand::PowerOff || command == RobotCommand::RestartSafety) {
        stop(control::StopCause::ControlLost);
    }
    send(*this, d_->link, commandText(command),
         [command](RobotService& s, const Deadline& d) { return s.perform(command, d); });
}

void RobotSession::unlockProtectiveStop(const UnlockConsent&) {
    send(*this, d_->link, tr("Protective stop unlocked by the operator"),
         [](RobotService& s, const Deadline& d) { return s.unlockProtectiveStop(d); });
}

void RobotSession::loadProgram(const QString& name) {
    send(*this, d_->link, tr("Load program %1").arg(name),
         [name](RobotService& s, const Deadline& d) { return s.loadProgram(name, d); });
}

void RobotSession::stopForeignProgram(control::StopCause cause) {
    if (d_->state.control == ControlState::InControl) {
        d_->stopInControl = {cause, d_->clock->nowNs()};
    }
    if (!ForeignStop::isMeant(cause, d_->state)) {
        return;
    }
    // In this order: what the taking still sends is stopped too.
    d_->taking.cancel();
    d_->link->foreignStop->request(cause, *d_->link->receiver);
}

void RobotSession::followForeignStop() {
    if (d_->stopInControl && d_->clock->nowNs() - d_->stopInControl->second > kTakenOverNs) {
        d_->stopInControl.reset();
    }
    if (d_->stopInControl && ForeignStop::isMeant(d_->stopInControl->first, d_->state)) {
        d_->link->foreignStop->request(std::exchange(d_->stopInControl, std::nullopt)->first,
                                       *d_->link->receiver);
    }
    switch (d_->link->foreignStop->follow(d_->state)) {
        case ForeignStop::Outcome::None:
            break;
        case ForeignStop::Outcome::Stopped:
            Q_EMIT message(Severity::Info, tr("The program on the robot was stopped"), Origin::Operator);
            break;
        case ForeignStop::Outcome::Failed:
            Q_EMIT message(Severity::Error,
                           tr("The program on the robot was not stopped: stop it on the teach pendant. %1")
                               .arg(texts::errorText(d_->link->foreignStop->error())));
            break;
    }
}

void RobotSession::askService() {
    const std::int64_t now = d_->clock->nowNs();
    // Leaving Remote, a controller ends its script connections: the first sign there is.
    const bool primary = d_->link->primary->isConnected();
    const bool sign = std::exchange(d_->primarySeen, primary) && !primary;
    if (d_->state.link != LinkState::Live || d_->reportAsked ||
        (now - d_->reportAskedNs < kAskEveryNs && !sign)) {
        return;
    }
    d_->reportAsked = true;
    d_->reportAskedNs = now;
    const std::uint64_t generation = d_->generation;
    d_->link->watch->post([](RobotService& s, const Deadline& d) { return s.look(d); }, this,
                          [this, generation](const Result<dashboard::ServiceReport>& result) {
                              if (generation != d_->generation) {
                                  return;
                              }
                              d_->reportAsked = false;
                              // Which service it is stays known while it does not answer.
                              dashboard::ServiceReport silent;
                              silent.kind = d_->report.kind;
                              d_->report = result ? *result : silent;
                              followService(d_->report);
                          },
                          kReplyTime);
}

void RobotSession::followService(const dashboard::ServiceReport& report) {
    if (!report.remoteControl) {
        return;
    }
    // A robot that never was in Remote has remote control switched off, and may be controlled as it is.
    const bool was = std::exchange(d_->remoteSeen, *report.remoteControl);
    if (was && !d_->remoteSeen) {
        leaveForLocal();
    } else if (!was && d_->remoteSeen) {
        d_->localRefuses = true;
        if (d_->state.control == ControlState::Refused) {
            d_->refusal.clear();  // what it was refused for is over, or shows again at the next attempt
        }
        d_->link->foreignStop->reconnect();
    }
}

void RobotSession::leaveForLocal() {
    if (d_->state.control != ControlState::InControl && d_->state.control != ControlState::Taking) {
        return;
    }
    stop(control::StopCause::ControlLost);
    const QString why =
        tr("The robot was switched to Local control: motion was stopped and control given back. Switch it to "
           "Remote control on the teach pendant, then take control again.");
    Q_EMIT message(Severity::Warning, why, Origin::Robot);
    d_->taking.cancel();
    const std::uint64_t generation = d_->generation;
    d_->controlling.post(this,
                         [this, generation, why, controller = d_->link->controller](const CancelToken&) {
                             controller->release();
                             return std::function<void()>([this, generation, why] {
                                 if (generation == d_->generation) {
                                     d_->refusal = why;
                                     refresh();
                                 }
                             });
                         });
}

}  // namespace tiller
