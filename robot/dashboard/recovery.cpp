// SPDX-License-Identifier: MIT
#include "robot/dashboard/recovery.h"
#include "robot/core/wait_until.h"

#include <algorithm>

namespace tiller::dashboard {

namespace {

using std::chrono::milliseconds;

QString context() {
    return QStringLiteral("recover the robot");
}

Error missing(const char* what) {
    return {ErrorCode::Rejected, context(), QString::fromLatin1(what)};
}

Error overdue(const Deadline& deadline, const QString& where) {
    return {deadline.isCancelled() ? ErrorCode::Cancelled : ErrorCode::Timeout, context(), where};
}

void pause(const Deadline& deadline, milliseconds time) {
    waitUntil(Deadline::after(std::min(time, deadline.remaining()), deadline.token()), [] { return false; });
}

bool isTooEarly(const DashboardClient&, const Error& error) {
    return error.controllerMessage.contains(QLatin1String("until 5s"));
}
bool isTooEarly(const RobotApiClient&, const Error& error) {
    return error.controllerMessage.startsWith(QLatin1String("409"));  // "not available now"
}

void closePopup(DashboardClient& client, const Deadline& deadline) {
    (void)client.closeSafetyPopup(deadline);
}
void closePopup(RobotApiClient&, const Deadline&) {}  // PolyScope X has no such popup

/// Unlocks as soon as the controller permits.
template <class Client>
Result<void> unlock(Client& client, const Deadline& deadline, const RecoveryProgress& progress) {
    bool waiting = false;
    while (true) {
        const auto unlocked = client.unlockProtectiveStop(deadline);
        const bool early =
            !unlocked && unlocked.error().code == ErrorCode::Rejected && isTooEarly(client, unlocked.error());
        if (!early) {
            return unlocked;
        }
        if (!waiting && progress) {
            progress(RecoveryStep::WaitForUnlock);
        }
        waiting = true;
        pause(deadline, milliseconds(250));
        if (deadline.hasExpired()) {
            return overdue(deadline, unlocked.error().controllerMessage);
        }
    }
}

template <class Client>
Result<void> recoverWith(Client& client, const RecoveryConsent& consent, const Deadline& deadline,
                         const RecoveryProgress& progress) {
    const auto report = [&](RecoveryStep step) {
        if (progress) {
            progress(step);
        }
    };
    report(RecoveryStep::Look);
    RecoveryStep last = RecoveryStep::Look;
    while (!deadline.hasExpired()) {
        const auto safety = client.safetyMode(deadline);
        if (!safety) {
            return safety.error();
        }
        const auto mode = client.robotMode(deadline);
        if (!mode) {
            return mode.error();
        }
        const RecoveryStep next = nextRecoveryStep(*safety, *mode);
        if (next == RecoveryStep::AskPerson) {
            return Error{ErrorCode::Rejected, context(),
                         QStringLiteral("%1: it takes a person at the robot to end this")
                             .arg(safetyModeName(*safety))};
        }
        if (next == RecoveryStep::Done) {
            report(RecoveryStep::Done);
            return {};
        }
        // Each step is started once; later iterations wait for its effect.
        Result<void> done;
        if (next != RecoveryStep::Look && next != last) {
            switch (next) {
                case RecoveryStep::Unlock:
                    if (!consent.causeInspected) {
                        return missing("protective stop: it is only unlocked once its cause was inspected");
                    }
                    report(RecoveryStep::CloseSafetyPopup);
                    closePopup(client, deadline);
                    report(next);
                    done = unlock(client, deadline, progress);
                    break;
                case RecoveryStep::RestartSafety:
                    if (!consent.restartSafety) {
                        return missing("the safety system has to be restarted, which needs your consent");
                    }
                    report(next);
                    done = client.restartSafety(deadline);
                    break;
                case RecoveryStep::PowerOn:
                    if (!consent.powerOn) {
                        return missing("the arm is off; to power it on needs your consent");
                    }
                    report(next);
                    done = client.powerOn(deadline);
                    break;
                default:
                    if (!consent.releaseBrakes) {
                        return missing("the brakes are on; to release them needs your consent");
                    }
                    report(next);
                    done = client.brakeRelease(deadline);
                    break;
            }
            last = next;
        }
        if (!done) {
            return done;
        }
        pause(deadline, milliseconds(50));
    }
    return overdue(deadline, QStringLiteral("the robot has not come to RUNNING"));
}

}  // namespace

RecoveryStep nextRecoveryStep(SafetyMode safety, RobotMode mode) {
    if (safety == SafetyMode::ProtectiveStop) {
        return RecoveryStep::Unlock;
    }
    if (safety == SafetyMode::Violation || safety == SafetyMode::Fault) {
        return RecoveryStep::RestartSafety;
    }
    if (!allowsMotion(safety)) {
        return RecoveryStep::AskPerson;
    }
    switch (mode) {
        case RobotMode::PowerOff:
            return RecoveryStep::PowerOn;
        case RobotMode::Idle:
            return RecoveryStep::ReleaseBrakes;
        case RobotMode::Running:
            return RecoveryStep::Done;
        default:
            return RecoveryStep::Look;
    }
}

Result<void> recover(DashboardClient& client, const RecoveryConsent& consent, const Deadline& deadline,
                     const RecoveryProgress& progress) {
    return recoverWith(client, consent, deadline, progress);
}

Result<void> recover(RobotApiClient& client, const RecoveryConsent& consent, const Deadline& deadline,
                     const RecoveryProgress& progress) {
    return recoverWith(client, consent, deadline, progress);
}

}  // namespace tiller::dashboard
