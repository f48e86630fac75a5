// SPDX-License-Identifier: MIT
#include "robot/simulator/arm/dynamics.h"

#include <kdl/chain.hpp>
#include <kdl/chaindynparam.hpp>
#include <optional>

#include "robot/simulator/arm/newton_euler.h"

namespace tiller::simulator::arm {

namespace {
/// Inertia of a motor and its gear relative to the joint torque [kg m2/Nm]. The manufacturer publishes no
/// values. The order of magnitude is from published identifications.
constexpr double kRotorInertia = 0.005;

KDL::Vector toKdl(const Eigen::Vector3d& v) {
    return {v.x(), v.y(), v.z()};
}

KDL::RigidBodyInertia toKdl(const LinkInertia& link) {
    const auto& c = link.centreOfMass;
    const auto& i = link.inertia;
    return KDL::RigidBodyInertia(link.mass, KDL::Vector(c[0], c[1], c[2]),
                                 KDL::RotationalInertia(i[0], i[3], i[5], i[1], i[2], i[4]));
}

KDL::RigidBodyInertia toKdl(const Payload& payload) {
    const Vector6& i = payload.inertia;
    return KDL::RigidBodyInertia(payload.mass, toKdl(payload.centreOfGravity),
                                 KDL::RotationalInertia(i[0], i[1], i[2], i[3], i[4], i[5]));
}
}  // namespace

struct Dynamics::Chain {
    explicit Chain(const RobotModel& m) : model(m), q(6), qd(6), torque(6), mass(6), newtonEuler(m) {
        const DhParameters& dh = model.dh;
        for (std::size_t i = 0; i < 6; ++i) {
            chain.addSegment(KDL::Segment(KDL::Joint(KDL::Joint::RotZ),
                                          KDL::Frame::DH(dh.a[i], dh.alpha[i], dh.d[i], dh.theta[i]),
                                          toKdl(model.links[i])));
        }
    }

    void rebuild(const Eigen::Vector3d& gravity) {
        parameters.emplace(chain, toKdl(-gravity));
        newtonEuler.setGravity(gravity);
    }

    static void set(KDL::JntArray& to, const Vector6& from) { to.data = from; }

    const RobotModel& model;
    KDL::Chain chain;
    std::optional<KDL::ChainDynParam> parameters;
    KDL::JntArray q, qd, torque;
    KDL::JntSpaceInertiaMatrix mass;
    NewtonEuler newtonEuler;
    Payload payload;
};

Dynamics::Dynamics(const RobotModel& model) : chain_(std::make_unique<Chain>(model)) {
    setGravity({0, 0, 9.82});
}

Dynamics::~Dynamics() = default;

void Dynamics::setPayload(const Payload& payload) {
    chain_->payload = payload;
    chain_->newtonEuler.setPayload(payload);
    chain_->chain.getSegment(5).setInertia(toKdl(chain_->model.links[5]) + toKdl(payload));
}

void Dynamics::setGravity(const Eigen::Vector3d& gravity) {
    chain_->rebuild(gravity);
}

Vector6 Dynamics::torques(const Vector6& q, const Vector6& qd, const Vector6& qdd, const Wrench& onFlange) {
    return chain_->newtonEuler.torques(q, qd, qdd, onFlange);
}

Matrix6 Dynamics::massMatrix(const Vector6& q, bool rotors) {
    Chain& c = *chain_;
    Chain::set(c.q, q);
    c.parameters->JntToMass(c.q, c.mass);
    Matrix6 mass = c.mass.data;
    if (rotors) {
        mass.diagonal() += kRotorInertia * Eigen::Map<const Vector6>(c.model.maxTorque.data());
    }
    return mass;
}

Vector6 Dynamics::coriolis(const Vector6& q, const Vector6& qd) {
    Chain& c = *chain_;
    Chain::set(c.q, q);
    Chain::set(c.qd, qd);
    c.parameters->JntToCoriolis(c.q, c.qd, c.torque);
    return c.torque.data;
}

Vector6 Dynamics::gravityTorques(const Vector6& q) {
    return torques(q, Vector6::Zero(), Vector6::Zero());
}

Dynamics::Momentum Dynamics::momentum(const std::array<Eigen::Isometry3d, 7>& frames,
                                      const Vector6& qd) const {
    Momentum sum;
    Eigen::Vector3d omega = Eigen::Vector3d::Zero();
    Eigen::Vector3d origin = frames[0].translation();
    Eigen::Vector3d velocity = Eigen::Vector3d::Zero();
    const auto add = [&](const Eigen::Isometry3d& T, double mass, const Eigen::Vector3d& centreInFrame,
                         const Eigen::Matrix3d& inertiaInFrame) {
        const Eigen::Vector3d offset = T.linear() * centreInFrame;
        const Eigen::Vector3d centre = T.translation() + offset;
        const Eigen::Vector3d linear = mass * (velocity + omega.cross(offset));
        sum.linear += linear;
        sum.angular +=
            centre.cross(linear) + T.linear() * (inertiaInFrame * (T.linear().transpose() * omega));
        sum.mass += mass;
        sum.firstMoment += mass * centre;
    };
    for (int i = 0; i < kJointCount; ++i) {
        const auto k = static_cast<std::size_t>(i);
        omega += frames[k].linear().col(2) * qd[i];
        const Eigen::Isometry3d& T = frames[k + 1];
        velocity += omega.cross(T.translation() - origin);
        origin = T.translation();
        const LinkInertia& link = chain_->model.links[k];
        const auto& m = link.inertia;
        Eigen::Matrix3d inertia;
        inertia << m[0], m[1], m[2], m[1], m[3], m[4], m[2], m[4], m[5];
        add(T, link.mass, Eigen::Map<const Eigen::Vector3d>(link.centreOfMass.data()), inertia);
    }
    const Payload& load = chain_->payload;
    const Vector6& m = load.inertia;
    Eigen::Matrix3d inertia;
    inertia << m[0], m[3], m[4], m[3], m[1], m[5], m[4], m[5], m[2];
    add(frames[6], load.mass, load.centreOfGravity, inertia);
    return sum;
}

}  // namespace tiller::simulator::arm
