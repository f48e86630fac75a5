// SPDX-License-Identifier: MIT
#include "robot/station/link/robot_tooling.h"

#include "robot/control/tool_setup.h"
#include "robot/station/link/detail/session_backend.h"
#include "robot/station/text/texts.h"

namespace tiller {
namespace {

constexpr std::chrono::milliseconds kToolingTime{2000};

}  // namespace

void RobotTooling::set(const QString& done, std::function<Result<void>(const Deadline&)> order) {
    if (!d_.link || !d_.state.canMove()) {
        session_.journal().add(Severity::Warning, d_.state.controlReason.isEmpty()
                                                      ? tr("Tiller is not in control. Take control first.")
                                                      : d_.state.controlReason);
        return;
    }
    if (d_.state.moving || d_.state.motionActive) {
        session_.journal().add(
            Severity::Warning,
            tr("TCP and payload can be set only at standstill. Wait until the arm has stopped."));
        return;
    }
    const std::uint64_t generation = d_.generation;
    d_.worker.post(&session_, [this, generation, done, order = std::move(order)](const CancelToken& token) {
        const Result<void> result = order(Deadline::after(kToolingTime, token));
        return std::function<void()>([this, generation, done, result] {
            if (generation != d_.generation) {
                return;
            }
            if (result) {
                session_.journal().add(Severity::Info, done, Origin::Operator);
            } else if (result.error().code != ErrorCode::Cancelled) {
                session_.journal().add(Severity::Error, texts::errorText(result.error()));
            }
        });
    });
}

void RobotTooling::setTcp(const Pose& tcp, const QString& name) {
    if (d_.link) {
        set(tr("TCP set on the robot: %1").arg(name),
            [tcp, controller = d_.link->controller](const Deadline& deadline) {
                return control::ToolSetup(*controller).setTcp(tcp, deadline);
            });
    } else {
        set({}, {});
    }
}

void RobotTooling::setPayload(const Load& load, const QString& name) {
    if (d_.link) {
        set(tr("Payload set on the robot: %1").arg(name),
            [load, controller = d_.link->controller](const Deadline& deadline) {
                control::ToolSetup setup(*controller);
                return load.inertia ? setup.setTargetPayload(load.mass, load.centre, *load.inertia, deadline)
                                    : setup.setPayload(load.mass, load.centre, deadline);
            });
    } else {
        set({}, {});
    }
}

}  // namespace tiller
