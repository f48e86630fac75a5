// SPDX-License-Identifier: MIT
#include "robot/dashboard/recovery.h"
#include "robot/core/wait_until.h"

#include <algorithm>
#include <memory>
#include <optional>

namespace tiller::dashboard {

namespace {

using std::chrono::milliseconds;

// Pause between attempts to connect to a restarting controller.
constexpr milliseconds kOutagePause{100};

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
    return error.controllerMessage.startsWith(QLatin1String("409"));  // HTTP status for "not available now"
}

/// True if the error is a connection failure that can occur while a controller restarts.
bool isOutage(const Error& error) {
    return error.code == ErrorCode::ConnectionClosed || error.code == ErrorCode::ConnectionRefused ||
           error.code == ErrorCode::HostUnreachable || error.code == ErrorCode::NotConnected ||
           error.code == ErrorCode::LinkLost;
}

Result<void> connectAgain(DashboardClient& client, const Deadline& deadline) {
    return client.isConnected() ? Result<void>() : client.connect(deadline);
}
Result<void> connectAgain(RobotApiClient&, const Deadline&) {
    return {};  // each request uses a separate connection
}

void closePopup(DashboardClient& client, const Deadline& deadline) {
    (void)client.closeSafetyPopup(deadline);
}
void closePopup(RobotApiClient&, const Deadline&) {}  // PolyScope X has no such popup

/// Unlocks the protective stop as soon as the controller permits it.
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
    Error outage;
    // An outage is not returned as an error, because the modes read next show its effect.
    const auto endsWith = [&](const Error& error) -> std::optional<Error> {
        if (!isOutage(error)) {
            return error;
        }
        outage = error;
        // Steps started before a restart must be repeated, except for an unlock, because a consent is
        // valid for one unlock only.
        last = last == RecoveryStep::Unlock ? last : RecoveryStep::Look;
        pause(deadline, kOutagePause);
        return std::nullopt;
    };
    while (!deadline.hasExpired()) {
        const auto connected = connectAgain(client, deadline);
        const auto safety = connected ? client.safetyMode(deadline) : Result<SafetyMode>(connected.error());
        const auto mode = safety ? client.robotMode(deadline) : Result<RobotMode>(safety.error());
        if (!mode) {
            if (const auto error = endsWith(mode.error())) {
                return *error;
            }
            continue;
        }
        const RecoveryStep next = nextRecoveryStep(*safety, *mode);
        if (next == RecoveryStep::AskPerson) {
            return Error{ErrorCode::Rejected, context(),
                         QStringLiteral("%1: only a person at the robot can end this state")
                             .arg(safetyModeName(*safety))};
        }
        if (next == RecoveryStep::Done) {
            report(RecoveryStep::Done);
            return {};
        }
        // Each step is started once. Later iterations wait for its effect.
        Result<void> done;
        if (next != RecoveryStep::Look && next != last) {
            switch (next) {
                case RecoveryStep::Unlock:
                    if (!consent.causeInspected) {
                        return missing(
                            "the protective stop is unlocked only after its cause has been inspected");
                    }
                    report(RecoveryStep::CloseSafetyPopup);
                    closePopup(client, deadline);
                    report(next);
                    done = unlock(client, deadline, progress);
                    break;
                case RecoveryStep::RestartSafety:
                    if (!consent.restartSafety) {
                        return missing("the safety system must be restarted, which requires your consent");
                    }
                    report(next);
                    done = client.restartSafety(deadline);
                    break;
                case RecoveryStep::PowerOn:
                    if (!consent.powerOn) {
                        return missing("the arm is powered off; powering it on requires your consent");
                    }
                    report(next);
                    done = client.powerOn(deadline);
                    break;
                default:
                    if (!consent.releaseBrakes) {
                        return missing("the brakes are engaged; releasing the brakes requires your consent");
                    }
                    report(next);
                    done = client.brakeRelease(deadline);
                    break;
            }
            last = next;
        }
        if (!done) {
            if (const auto error = endsWith(done.error())) {
                return *error;
            }
            continue;
        }
        pause(deadline, milliseconds(50));
    }
    return overdue(deadline, outage.code == ErrorCode::None
                                 ? QStringLiteral("the robot did not reach RUNNING")
                                 : QStringLiteral("the robot did not reach RUNNING; ") + outage.toString());
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

Result<void> recover(const ServiceAddress& address, const RecoveryConsent& consent, const Deadline& deadline,
                     const RecoveryProgress& progress) {
    auto service = openService(address, deadline);
    while (!service && isOutage(service.error()) && !deadline.hasExpired()) {
        pause(deadline, kOutagePause);
        service = openService(address, deadline);
    }
    if (!service) {
        return service.error();
    }
    if ((*service)->kind() == ServiceKind::RobotApi) {
        RobotApiClient client(address.host, address.robotApiPort);
        return recover(client, consent, deadline, progress);
    }
    service->reset();  // use only one connection to the dashboard server
    DashboardClient client(address.host, address.dashboardPort);
    return recover(client, consent, deadline, progress);
}

}  // namespace tiller::dashboard
