// SPDX-License-Identifier: MIT
#include "robot/simulator/arm/driven_arm.h"

#include "robot/simulator/arm/arm_geometry.h"
#include "robot/simulator/arm/environment.h"
#include "robot/simulator/arm/sensors.h"

namespace tiller::simulator::arm {

struct DrivenArm::Parts {
    Parts(const RobotModel& m, double controlPeriod)
        : model(m), period(controlPeriod), geometry(model), sensors(geometry, period, 1, false) {
        sensors.setNoise(false);
    }

    const RobotModel model;
    const double period;
    ArmGeometry geometry;
    Sensors sensors;
    const Environment nothing;
    ArmState state;
};

DrivenArm::DrivenArm(const RobotModel& model, double period)
    : parts_(std::make_unique<Parts>(model, period)) {}

DrivenArm::~DrivenArm() = default;

double DrivenArm::period() const {
    return parts_->period;
}

const RobotModel& DrivenArm::model() const {
    return parts_->model;
}

void DrivenArm::setPayload(const Payload& payload) {
    if (!(payload == parts_->sensors.payload())) {
        parts_->sensors.setPayload(payload);
    }
}

void DrivenArm::setGravity(const Eigen::Vector3d& gravity) {
    parts_->sensors.setGravity(gravity);
}

void DrivenArm::place(const JointPositions& q) {
    parts_->sensors.place(q.values);
}

void DrivenArm::step(const JointPositions& q, const JointVelocities& qd) {
    Parts& p = *parts_;
    ++p.state.controlStep;
    p.sensors.update({q.values, qd.values}, DriveState::Running, p.nothing, p.state);
}

const ArmState& DrivenArm::state() const {
    return parts_->state;
}

}  // namespace tiller::simulator::arm
