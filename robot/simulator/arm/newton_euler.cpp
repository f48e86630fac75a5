// SPDX-License-Identifier: MIT
#include "robot/simulator/arm/newton_euler.h"

#include <cmath>

namespace tiller::simulator::arm {

namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

Matrix3d symmetric(double xx, double yy, double zz, double xy, double xz, double yz) {
    return (Matrix3d() << xx, xy, xz, xy, yy, yz, xz, yz, zz).finished();
}

/// Additional inertia of a mass of 1 kg when the reference point moves by `arm`.
Matrix3d steiner(const Vector3d& arm) {
    return arm.squaredNorm() * Matrix3d::Identity() - arm * arm.transpose();
}

/// Transform from a frame to the previous frame, Rz(theta) Rx(alpha), given by sines and cosines.
struct Turn {
    double st, ct, sa, ca;

    Vector3d outward(const Vector3d& v) const {
        const double across = ct * v.y() - st * v.x();
        return {ct * v.x() + st * v.y(), ca * across + sa * v.z(), ca * v.z() - sa * across};
    }
    Vector3d inward(const Vector3d& v) const {
        const double across = ca * v.y() - sa * v.z();
        return {ct * v.x() - st * across, st * v.x() + ct * across, sa * v.y() + ca * v.z()};
    }
};

}  // namespace

NewtonEuler::NewtonEuler(const RobotModel& model) {
    const DhParameters& dh = model.dh;
    for (std::size_t i = 0; i < links_.size(); ++i) {
        Link& link = links_[i];
        link.theta = dh.theta[i];
        link.sinAlpha = std::sin(dh.alpha[i]);
        link.cosAlpha = std::cos(dh.alpha[i]);
        link.arm = {dh.a[i], dh.d[i] * link.sinAlpha, dh.d[i] * link.cosAlpha};
        const auto& of = model.links[i];
        const auto& m = of.inertia;
        link.body = {of.mass, Vector3d::Map(of.centreOfMass.data()),
                     symmetric(m[0], m[3], m[5], m[1], m[2], m[4])};
    }
    bareLast_ = links_.back().body;
}

NewtonEuler::Body NewtonEuler::joined(const Body& one, const Body& other) {
    Body both;
    both.mass = one.mass + other.mass;
    if (both.mass > 0) {
        both.centre = (one.mass * one.centre + other.mass * other.centre) / both.mass;
    }
    both.inertia = one.inertia + one.mass * steiner(one.centre - both.centre) + other.inertia +
                   other.mass * steiner(other.centre - both.centre);
    return both;
}

void NewtonEuler::setPayload(const Payload& payload) {
    const Vector6& m = payload.inertia;
    links_.back().body = joined(
        bareLast_, {payload.mass, payload.centreOfGravity, symmetric(m[0], m[1], m[2], m[3], m[4], m[5])});
}

Vector6 NewtonEuler::torques(const Vector6& q, const Vector6& qd, const Vector6& qdd,
                             const Wrench& onFlange) const {
    std::array<Turn, kJointCount> turns;
    std::array<Vector3d, kJointCount> forces;   // total inertial force on the link, at its centre
    std::array<Vector3d, kJointCount> moments;  // moment about the centre
    Vector3d w = Vector3d::Zero();
    Vector3d dw = Vector3d::Zero();
    Vector3d a = gravity_;
    for (std::size_t i = 0; i < links_.size(); ++i) {
        const Link& link = links_[i];
        const auto j = static_cast<int>(i);
        const double theta = q[j] + link.theta;
        const Turn& turn = turns[i] = {std::sin(theta), std::cos(theta), link.sinAlpha, link.cosAlpha};
        // The joint rotates about the z axis of the previous frame.
        dw = turn.outward({dw.x() + w.y() * qd[j], dw.y() - w.x() * qd[j], dw.z() + qdd[j]});
        w = turn.outward({w.x(), w.y(), w.z() + qd[j]});
        a = turn.outward(a) + dw.cross(link.arm) + w.cross(w.cross(link.arm));
        const Body& body = link.body;
        forces[i] = body.mass * (a + dw.cross(body.centre) + w.cross(w.cross(body.centre)));
        moments[i] = body.inertia * dw + w.cross(body.inertia * w);
    }
    Vector6 torques;
    Vector3d force = -onFlange.force;  // force exerted on the previous link, in the frame of this link
    Vector3d moment = -onFlange.torque;
    for (std::size_t i = links_.size(); i-- > 0;) {
        const Link& link = links_[i];
        moment += link.arm.cross(force) + (link.arm + link.body.centre).cross(forces[i]) + moments[i];
        force += forces[i];
        torques[static_cast<int>(i)] = link.sinAlpha * moment.y() + link.cosAlpha * moment.z();
        force = turns[i].inward(force);
        moment = turns[i].inward(moment);
    }
    return torques;
}

}  // namespace tiller::simulator::arm
