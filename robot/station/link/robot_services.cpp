// SPDX-License-Identifier: MIT
#include "robot/station/link/robot_services.h"
#include "robot/station/link/obstacles.h"

#include <functional>
#include <utility>

#include "robot/station/link/detail/session_backend.h"
#include "robot/station/link/robot_session.h"
#include "robot/station/text/texts.h"

namespace tiller {
namespace {

using dashboard::RobotService;
using dashboard::ServiceKind;
using std::chrono::milliseconds;

constexpr milliseconds kReplyTime{3000};
/// The Robot API may reply only after the command is complete.
constexpr milliseconds kDoneTime{10'000};
/// The state is queried every half second, because a change to Local must be detected within one second.
constexpr std::int64_t kAskEveryNs = kNsPerSecond / 2;

/// Sends one command and logs the result.
/// after  called with true if the command was executed
template <class Call>
void send(
    RobotSession& session, const std::unique_ptr<RobotLink>& link, const QString& what, Call call,
    const std::function<void(bool)>& after = [](bool) {}) {
    if (!link) {
        session.journal().add(Severity::Error, texts::errorText({ErrorCode::NotConnected, what, {}}));
        after(false);
        return;
    }
    link->service->post(
        std::move(call), &session,
        [&session, what, after](const Result<void>& result) {
            if (result) {
                session.journal().add(Severity::Info, what, Origin::Operator);
            } else {
                session.journal().add(
                    Severity::Error,
                    RobotServices::tr("%1 failed. %2").arg(what, texts::errorText(result.error())));
            }
            after(result.ok());
        },
        session.state().service == ServiceKind::RobotApi ? kDoneTime : kReplyTime);
}

/// True if the command starts, pauses or ends an external program.
bool changesProgram(RobotCommand command, const SessionState& state) {
    switch (command) {
        case RobotCommand::Play:
            return true;
        case RobotCommand::PowerOff:
        case RobotCommand::Pause:
            return state.foreignProgramRuns();
        case RobotCommand::StopProgram:
            return state.hasForeignProgram();
        default:
            return false;
    }
}

}  // namespace

QString commandText(RobotCommand command) {
    switch (command) {
        case RobotCommand::PowerOn:
            return RobotServices::tr("Power on");
        case RobotCommand::ReleaseBrakes:
            return RobotServices::tr("Release brakes");
        case RobotCommand::PowerOff:
            return RobotServices::tr("Power off");
        case RobotCommand::RestartSafety:
            return RobotServices::tr("Restart safety");
        case RobotCommand::ClosePopups:
            return RobotServices::tr("Close popups");
        case RobotCommand::Play:
            return RobotServices::tr("Play program");
        case RobotCommand::Pause:
            return RobotServices::tr("Pause program");
        case RobotCommand::StopProgram:
            return RobotServices::tr("Stop program");
    }
    return {};
}

void RobotServices::perform(RobotCommand command, bool confirmed) {
    if (session_.refusesCommand(commandText(command))) {
        Q_EMIT session_.commandDone(command, false);
        return;
    }
    if (const QString why = serviceObstacle(d_.state, command); !why.isEmpty()) {
        session_.journal().add(Severity::Error, tr("%1 failed. %2").arg(commandText(command), why));
        Q_EMIT session_.commandDone(command, false);
        return;
    }
    if (!confirmed && changesProgram(command, d_.state)) {
        Q_EMIT session_.commandQuestion(command);
        Q_EMIT session_.commandDone(command, false);
        return;
    }
    if (command == RobotCommand::PowerOff || command == RobotCommand::RestartSafety) {
        session_.stop(control::StopCause::ControlLost);
    }
    send(
        session_, d_.link, commandText(command),
        [command](RobotService& s, const Deadline& d) { return s.perform(command, d); },
        [this, command](bool done) { Q_EMIT session_.commandDone(command, done); });
}

void RobotServices::unlockProtectiveStop(const UnlockConsent&) {
    if (session_.refusesCommand(tr("Unlock protective stop"))) {
        return;
    }
    send(session_, d_.link, tr("Protective stop unlocked by the operator"),
         [](RobotService& s, const Deadline& d) { return s.unlockProtectiveStop(d); });
}

void RobotServices::loadProgram(const QString& name) {
    const QString what = tr("Load program %1").arg(name);
    if (session_.refusesCommand(what)) {
        return;
    }
    send(session_, d_.link, what,
         [name](RobotService& s, const Deadline& d) { return s.loadProgram(name, d); });
}

void RobotServices::listPrograms(QObject* context, const std::function<void(const QStringList&)>& done) {
    if (d_.link && d_.state.service == dashboard::ServiceKind::RobotApi) {
        d_.link->watch->post([](RobotService& s, const Deadline& d) { return s.programs(d); }, context,
                             [done](const Result<QStringList>& names) {
                                 if (names) {
                                     done(*names);
                                 }
                             },
                             kReplyTime);
    }
}

void RobotServices::stopPrograms(control::StopCause cause, std::uint64_t epoch) {
    if (!ExternalProgramStopper::isByStopKey(cause)) {
        return;
    }
    const SessionState now = d_.stateNow();
    if (ExternalProgramStopper::isMeant(cause, now)) {
        stopOnEveryRoute(cause);
    } else if (now.control == ControlState::InControl && unconfirmed_) {
        unconfirmed_->confirmation.repeat(epoch);
    } else if (now.control == ControlState::InControl) {
        unconfirmed_ = {cause, control::StopConfirmation(epoch, d_.stopEvidence())};
    }
    // Report last, because connected slots may take time.
    const bool isControlAlive = now.control == ControlState::InControl && d_.stopEvidence().inControl;
    if (!now.isFresh() && !isControlAlive && !std::exchange(hasReportedSilence_, true)) {
        session_.journal().add(Severity::Error,
                               tr("The robot sends no data, so a stop may not reach the robot. Press the "
                                  "emergency stop if the arm must stop."));
    }
}

void RobotServices::stopOnEveryRoute(control::StopCause cause) {
    unconfirmed_.reset();
    // Cancel taking control first, so that the stop also applies to anything that is still sent.
    d_.taking.cancel();
    d_.link->foreignStop->request(cause, *d_.link->receiver);
}

bool RobotServices::stopsForeignProgramsAtOnce() const {
    return d_.link && d_.link->foreignStop->isReady();
}

void RobotServices::followForeignStop(const SampleBatch& batch) {
    using Verdict = control::StopConfirmation::Verdict;
    hasReportedSilence_ = hasReportedSilence_ && !d_.state.isFresh();
    if (const auto verdict =
            unconfirmed_ ? unconfirmed_->confirmation.look(d_.stopEvidence()) : Verdict::Waiting;
        verdict == Verdict::EveryRoute) {
        stopOnEveryRoute(unconfirmed_->cause);
    } else if (verdict == Verdict::Confirmed) {
        unconfirmed_.reset();
    }
    switch (d_.link->foreignStop->follow(d_.state, batch)) {
        case ExternalProgramStopper::Outcome::None:
            break;
        case ExternalProgramStopper::Outcome::Stopped:
            session_.journal().add(Severity::Info, tr("The program on the robot was stopped."),
                                   Origin::Operator);
            break;
        case ExternalProgramStopper::Outcome::Failed:
            session_.journal().add(
                Severity::Error,
                tr("The program on the robot could not be stopped. Stop the program on the teach pendant. %1")
                    .arg(texts::errorText(d_.link->foreignStop->error())));
            break;
    }
}

void RobotServices::ask() {
    const std::int64_t now = d_.clock->nowNs();
    // When the controller leaves Remote, it closes its script connections. This is the earliest indication of
    // the change.
    const bool primary = d_.link->primary->isConnected();
    const bool sign = std::exchange(primarySeen_, primary) && !primary;
    if (d_.state.link != LinkState::Live || reportAsked_ || (now - reportAskedNs_ < kAskEveryNs && !sign)) {
        return;
    }
    reportAsked_ = true;
    reportAskedNs_ = now;
    const std::uint64_t generation = d_.generation;
    d_.link->watch->post([](RobotService& s, const Deadline& d) { return s.look(d); }, &session_,
                         [this, generation](const Result<dashboard::ServiceReport>& result) {
                             if (generation != d_.generation) {
                                 return;
                             }
                             reportAsked_ = false;
                             // The type of service stays known while the service does not respond.
                             dashboard::ServiceReport silent;
                             silent.kind = d_.report.kind;
                             d_.report = result ? *result : silent;
                             followReport(d_.report);
                         },
                         kReplyTime);
}

void RobotServices::followReport(const dashboard::ServiceReport& report) {
    if (!report.remoteControl) {
        return;
    }
    // If the robot was never in Remote, remote control is assumed to be disabled, and the robot accepts
    // commands in Local.
    const bool was = std::exchange(remoteSeen_, *report.remoteControl);
    if (was && !remoteSeen_) {
        leaveForLocal();
    } else if (!was && remoteSeen_) {
        d_.localRefuses = true;
        if (d_.state.control == ControlState::Refused) {
            d_.refusal.clear();  // the cause is resolved, or the next attempt reports it again
        }
        d_.link->foreignStop->reconnect();
    }
}

void RobotServices::leaveForLocal() {
    if (d_.state.control != ControlState::InControl && d_.state.control != ControlState::Taking) {
        return;
    }
    session_.stop(control::StopCause::ControlLost);
    const QString why =
        tr("The robot was switched to Local control: the motion was stopped and control was given back. "
           "Switch the robot to Remote control on the teach pendant, then take control again.");
    session_.journal().add(Severity::Warning, why, Origin::Robot);
    d_.taking.cancel();
    const std::uint64_t generation = d_.generation;
    d_.controlling.post(&session_,
                        [this, generation, why, controller = d_.link->controller](const CancelToken&) {
                            controller->release();
                            return std::function<void()>([this, generation, why] {
                                if (generation == d_.generation) {
                                    d_.refusal = why;
                                    d_.refusedByClient = false;
                                    session_.refresh();
                                }
                            });
                        });
}

void RobotServices::forget() {
    d_.report = {};
    unconfirmed_.reset();
    reportAsked_ = false;
    remoteSeen_ = false;
    primarySeen_ = false;
}

}  // namespace tiller
