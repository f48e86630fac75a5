// SPDX-License-Identifier: MIT
#include "robot/station/link/robotiq_link.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "robot/station/link/robot_session.h"
#include "robot/station/text/notation.h"
#include "robot/station/text/texts.h"

namespace tiller {
namespace {

using io::RobotiqActivation;
using io::RobotiqFault;
using io::RobotiqObject;
using std::chrono::milliseconds;

constexpr milliseconds kGripperReplyTime{2000};
constexpr milliseconds kCommandTime{4000};
constexpr int kActivationMs = 15'000;
constexpr int kLookEveryMs = 100;
/// Maximum age of a reply that is used [ms].
constexpr int kFreshMs = 1000;
constexpr std::array kRetryMs = {500, 1000, 2000, 5000};

}  // namespace

RobotiqLink::RobotiqLink(RobotSession& session, QObject* parent) : QObject(parent), session_(session) {
    lookTimer_.setSingleShot(true);
    connect(&lookTimer_, &QTimer::timeout, this, &RobotiqLink::look);
}

RobotiqLink::~RobotiqLink() {
    end();
}

void RobotiqLink::follow(const QString& host, int port, GripperChoice::Model model) {
    end();
    host_ = host;
    port_ = port;
    model_ = model;
    open_ = kUsuallyOpen;
    closed_ = kUsuallyClosed;
    client_ = std::make_shared<io::RobotiqClient>(host, port);
    reason_ = tr("Connecting to the gripper…");
    look();
    Q_EMIT changed();
}

void RobotiqLink::leave() {
    if (client_ != nullptr) {
        end();
        Q_EMIT changed();
    }
}

void RobotiqLink::end() {
    if (client_ == nullptr) {
        return;
    }
    ++generation_;
    worker_.cancelAll();
    worker_.postCleanup([client = std::exchange(client_, nullptr)] { client->close(); });
    lookTimer_.stop();
    looking_ = false;
    busy_ = false;
    next_.reset();
    failures_ = 0;
    state_.reset();
    reason_.clear();
    carriedOut_ = false;
    held_ = false;
    logged_ = RobotiqFault::None;
    activating_.reset();
}

std::optional<io::RobotiqState> RobotiqLink::state() const {
    return state_ && answered_.elapsed() <= kFreshMs ? state_ : std::nullopt;
}

QString RobotiqLink::reason() const {
    if (client_ == nullptr || state()) {
        return {};
    }
    return state_ ? errorText({ErrorCode::Timeout, {}, {}}) : reason_;
}

double RobotiqLink::opening(int position) const {
    const double part = static_cast<double>(closed_ - position) / (closed_ - open_);
    return std::clamp(part, 0.0, 1.0) * robotiqRange(model_).stroke;
}

int RobotiqLink::position(double opening) const {
    const double part = opening / robotiqRange(model_).stroke;
    return std::clamp(static_cast<int>(std::lround(closed_ - part * (closed_ - open_))), 0, io::kRobotiqMost);
}

// ---- state queries --------------------------------------------------------------------------------------

void RobotiqLink::look() {
    if (client_ == nullptr || looking_) {
        return;
    }
    looking_ = true;
    const bool afterCommand = carriedOut_;
    worker_.post(
        this, [this, afterCommand, generation = generation_, client = client_](const CancelToken& token) {
            const Deadline deadline = Deadline::after(kGripperReplyTime, token);
            const Result<void> connected = client->isConnected() ? Result<void>() : client->connect(deadline);
            const Look found = connected ? client->look(deadline) : Look(connected.error());
            if (!found) {
                client->close();  // later replies could belong to earlier requests
            }
            return std::function<void()>([this, afterCommand, generation, found] {
                if (generation == generation_) {
                    looking_ = false;
                    take(found, afterCommand);
                }
            });
        });
}

void RobotiqLink::take(const Look& found, bool afterCommand) {
    if (!found) {
        lose(errorText(found.error()));
    } else if (!found->has_value()) {
        lose(
            tr("The gripper does not send any values. Power on the arm. If the problem persists, check the "
               "gripper cable at the wrist."));
    } else {
        if (failures_ > 0) {
            session_.journal().add(Severity::Info, tr("The gripper responds again."), Origin::Robot);
        }
        failures_ = 0;
        reason_.clear();
        answered_.start();
        busy_ = busy_ && !afterCommand;
        note(**found);
        state_ = **found;
        learnEnds(*state_);
    }
    if (next_ && !busy_) {
        send(*std::exchange(next_, std::nullopt));
    }
    const auto retry = static_cast<std::size_t>(std::max(failures_ - 1, 0));
    lookTimer_.start(failures_ == 0 ? kLookEveryMs : kRetryMs[std::min(retry, kRetryMs.size() - 1)]);
    Q_EMIT changed();
}

void RobotiqLink::lose(const QString& reason) {
    state_.reset();
    busy_ = false;
    next_.reset();  // earlier commands must not move the fingers after reconnecting
    activating_.reset();
    held_ = false;
    ++failures_;
    // Each reason is logged once.
    if (reason != reason_) {
        reason_ = reason;
        session_.journal().add(Severity::Warning, reason);
    }
}

void RobotiqLink::note(const io::RobotiqState& now) {
    if (now.fault != logged_) {
        logged_ = now.fault;
        if (const QString fault = textOf(now.fault); !fault.isEmpty()) {
            session_.journal().add(Severity::Error, fault, Origin::Robot);
        }
    }
    if (busy_) {
        return;  // the state was read before the command was sent
    }
    if (activating_ && now.activation == RobotiqActivation::Active) {
        activating_.reset();
        session_.journal().add(Severity::Info, tr("The gripper is active."), Origin::Robot);
    } else if (activating_ && activating_->elapsed() > kActivationMs) {
        activating_.reset();
        session_.journal().add(Severity::Error, tr("The gripper was not activated. Check that nothing "
                                                   "blocks its fingers, then press “Activate” again."));
    }
    if (now.holds() && !held_) {
        session_.journal().add(
            Severity::Info,
            tr("The gripper holds an object (%1 open).").arg(format::length(opening(now.position), 1)),
            Origin::Robot);
    } else if (held_ && !now.holds() && state_ && state_->requested == now.requested) {
        session_.journal().add(Severity::Warning, tr("The gripper lost the object."), Origin::Robot);
    }
    held_ = now.holds();
}

// Determines the end positions of the fingers from a full stroke without an object.
void RobotiqLink::learnEnds(const io::RobotiqState& now) {
    constexpr int kOpenAtMost = 40;
    constexpr int kClosedAtLeast = 180;
    if (now.activation != RobotiqActivation::Active || !now.goTo ||
        now.object != RobotiqObject::AtDestination) {
        return;
    }
    if (now.requested == 0 && now.position <= kOpenAtMost) {
        open_ = now.position;
    } else if (now.requested == io::kRobotiqMost && now.position >= kClosedAtLeast) {
        closed_ = now.position;
    }
}

// ---- commands -------------------------------------------------------------------------------------------

void RobotiqLink::activate() {
    send(
        {tr("Gripper: activate"),
         [](io::RobotiqClient& client, const Deadline& deadline) { return client.beginActivation(deadline); },
         true});
}

void RobotiqLink::move(int position, int speed, int force, const QString& what, const CancelToken& token) {
    send({what,
          [position, speed, force](io::RobotiqClient& client, const Deadline& deadline) {
              return client.move(position, speed, force, deadline);
          },
          false, token});
}

void RobotiqLink::stop(const QString& what) {
    if (client_ == nullptr) {
        return;
    }
    next_.reset();
    // The stop is sent after the current command, without waiting for the next state query.
    post({what, [](io::RobotiqClient& client, const Deadline& deadline) {
              const Result<void> connected = client.isConnected() ? Result<void>() : client.connect(deadline);
              return connected ? client.stop(deadline) : connected;
          }});
}

void RobotiqLink::send(const Command& command) {
    if (session_.refusesCommand(command.what) || client_ == nullptr) {
        return;
    }
    if (busy_) {
        next_ = command;
        return;
    }
    post(command);
}

void RobotiqLink::post(const Command& command) {
    busy_ = true;
    carriedOut_ = false;
    held_ = false;
    // Do not start the timer for a queued command, because another command may replace it.
    if (command.activates) {
        activating_.emplace().start();
    }
    worker_.post(this, [this, generation = generation_, command, client = client_](const CancelToken& token) {
        const CancelToken either(
            [token, own = command.token] { return token.isCancelled() || own.isCancelled(); });
        const Deadline deadline = Deadline::after(kCommandTime, either);
        // Do not reconnect to send a command, because the state may have changed since the command was
        // issued.
        const Result<void> result = command.token.isCancelled()
                                        ? Error{ErrorCode::Cancelled, command.what, {}}
                                        : command.call(*client, deadline);
        if (!result && result.error().code == ErrorCode::ProtocolError) {
            client->close();
        }
        return std::function<void()>([this, generation, command, result] {
            if (generation != generation_) {
                return;
            }
            carriedOut_ = true;
            if (result) {
                session_.journal().add(Severity::Info, command.what, Origin::Operator);
            } else if (!command.token.isCancelled()) {
                activating_.reset();
                session_.journal().add(Severity::Error,
                                       tr("%1 failed. %2").arg(command.what, errorText(result.error())));
            }
            // The next state query reads the effect and ends the busy state.
            lookTimer_.start(0);
            Q_EMIT changed();
        });
    });
    Q_EMIT changed();
}

// ---- texts ----------------------------------------------------------------------------------------------

QString RobotiqLink::errorText(const Error& error) const {
    switch (error.code) {
        case ErrorCode::ConnectionRefused:
            return tr("No gripper service responds at %1:%2. Install Robotiq's URCap on the robot and select "
                      "the gripper in the robot's installation.")
                .arg(host_)
                .arg(port_);
        case ErrorCode::Timeout:
            return tr(
                "The gripper is not responding. Check the cable at the wrist and the gripper settings on the "
                "Installation tab of the teach pendant. If the problem persists, restart the robot.");
        case ErrorCode::ConnectionClosed:
        case ErrorCode::NotConnected:
            return tr(
                "The robot closed the connection to the gripper and may be restarting. Tiller reconnects "
                "automatically; the gripper continues to hold its object.");
        case ErrorCode::Rejected:
            return tr(
                "The gripper did not accept the command. Activate the gripper. If it is already active, "
                "check its settings on the Installation tab of the teach pendant.");
        default:
            return texts::errorText(error);
    }
}

QString RobotiqLink::faultText() const {
    const std::optional<io::RobotiqState> now = state();
    return now ? textOf(now->fault) : QString();
}

QString RobotiqLink::textOf(io::RobotiqFault fault) {
    switch (fault) {
        case RobotiqFault::None:
            return {};
        case RobotiqFault::ActionDelayed:
            return tr("The gripper is activating; the command runs afterwards.");
        case RobotiqFault::NotActivated:
            return tr("The gripper received a motion command before it was active. Press “Activate”.");
        case RobotiqFault::Temperature:
            return tr("The gripper is too hot. Let it cool down, then press “Activate”.");
        case RobotiqFault::Communication:
            return tr(
                "The gripper received no command for one second. Check its cable at the wrist, then press "
                "“Activate”.");
        case RobotiqFault::UnderVoltage:
            return tr(
                "The supply voltage of the gripper is too low. Set the tool voltage to 24 V, then press "
                "“Activate”.");
        case RobotiqFault::ReleaseActive:
            return tr(
                "The automatic release of the gripper is in progress. Wait until it is complete, then press "
                "“Activate”.");
        case RobotiqFault::ReleaseFinished:
            return tr("The automatic release of the gripper is complete. Press “Activate”.");
        case RobotiqFault::Internal:
            return tr(
                "The gripper has an internal fault. Press “Activate”. If the fault returns, contact "
                "Robotiq.");
        case RobotiqFault::Activation:
            return tr("Activation failed. Check that nothing blocks the fingers, then press “Activate”.");
        case RobotiqFault::Overcurrent:
            return tr(
                "The gripper draws too much current. Check that nothing blocks the fingers, then press "
                "“Activate”.");
    }
    return tr("The gripper reports fault %1. Press “Activate”. If the fault returns, see the gripper manual.")
        .arg(static_cast<int>(fault));
}

}  // namespace tiller

#include "moc_robotiq_link.cpp"
