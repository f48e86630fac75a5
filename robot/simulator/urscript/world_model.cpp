// SPDX-License-Identifier: MIT
#include "robot/simulator/urscript/world_model.h"

#include "robot/simulator/urscript/host.h"

namespace tiller::simulator::urscript {

namespace {

Error noFrame(const std::string& name) {
    return scriptError("Unknown frame '" + name + "'");
}

Eigen::Matrix3d inertiaMatrix(const Vector6& i) {
    Eigen::Matrix3d m;
    m << i[0], i[3], i[4], i[3], i[1], i[5], i[4], i[5], i[2];
    return m;
}

// Parallel axis theorem: contribution of a point mass at `r`.
Eigen::Matrix3d pointInertia(double mass, const Eigen::Vector3d& r) {
    return mass * (r.squaredNorm() * Eigen::Matrix3d::Identity() - r * r.transpose());
}

}  // namespace

bool WorldModel::isFixed(std::string_view name) {
    return name == "world" || name == "base" || name == "flange" || name == "tcp";
}

// The loop in this function ends, because attach() refuses cycles.
std::optional<Eigen::Isometry3d> WorldModel::inBase(std::string_view name, const ArmFrames& arm) const {
    Eigen::Isometry3d T_here_frame = Eigen::Isometry3d::Identity();
    while (!isFixed(name)) {
        const auto it = frames_.find(name);
        if (it == frames_.end()) {
            return std::nullopt;
        }
        T_here_frame = it->second.T_parent_frame * T_here_frame;
        name = it->second.parent;
    }
    if (name == "flange") {
        return arm.flange.transform() * T_here_frame;
    }
    if (name == "tcp") {
        return arm.tcp.transform() * T_here_frame;
    }
    return name == "world" ? T_world_base_.inverse() * T_here_frame : T_here_frame;
}

bool WorldModel::hangsOn(std::string_view name, std::string_view ancestor) const {
    while (name != ancestor) {
        const auto it = frames_.find(name);
        if (it == frames_.end()) {
            return false;
        }
        name = it->second.parent;
    }
    return true;
}

Result<void> WorldModel::add(const std::string& name, const Pose& pose, const std::string& ref) {
    if (name.empty() || contains(name)) {
        return scriptError("Frame '" + name + "' already exists");
    }
    if (!contains(ref)) {
        return noFrame(ref);
    }
    if (frames_.size() >= kMaxFrames) {
        return scriptError("Too many frames");
    }
    frames_[name] = {ref, pose.transform(), {}};
    return {};
}

Result<void> WorldModel::attach(const std::string& child, const std::string& parent, const ArmFrames& arm) {
    const auto it = frames_.find(child);
    if (it == frames_.end()) {
        return noFrame(child);
    }
    if (!contains(parent)) {
        return noFrame(parent);
    }
    if (hangsOn(parent, child)) {
        return scriptError("Frame '" + child + "' cannot be attached to itself");
    }
    it->second.T_parent_frame = inBase(parent, arm)->inverse() * *inBase(child, arm);
    it->second.parent = parent;
    return {};
}

Result<void> WorldModel::move(const std::string& name, const Pose& pose, const std::string& ref,
                              const ArmFrames& arm) {
    const auto it = frames_.find(name);
    const bool isBase = name == "base";
    if (it == frames_.end() && !isBase) {
        return noFrame(name);
    }
    if (!contains(ref)) {
        return noFrame(ref);
    }
    if (isBase) {
        T_world_base_ = T_world_base_ * *inBase(ref, arm) * pose.transform();
        return {};
    }
    it->second.T_parent_frame =
        inBase(it->second.parent, arm)->inverse() * *inBase(ref, arm) * pose.transform();
    return {};
}

Result<void> WorldModel::remove(const std::string& name, const ArmFrames& arm) {
    const auto it = frames_.find(name);
    if (it == frames_.end()) {
        return noFrame(name);
    }
    const std::string parent = it->second.parent;
    for (auto& [childName, child] : frames_) {
        if (child.parent == name) {
            child.T_parent_frame = inBase(parent, arm)->inverse() * *inBase(childName, arm);
            child.parent = parent;
        }
    }
    frames_.erase(it);
    return {};
}

Result<std::string> WorldModel::parentOf(const std::string& name) const {
    if (isFixed(name)) {
        return std::string(name == "tcp" ? "flange" : name == "flange" ? "base" : "world");
    }
    const auto it = frames_.find(name);
    if (it == frames_.end()) {
        return noFrame(name);
    }
    return it->second.parent;
}

Result<std::vector<std::string>> WorldModel::childrenOf(const std::string& name) const {
    if (!contains(name)) {
        return noFrame(name);
    }
    std::vector<std::string> out;
    for (const char* fixed : {"base", "flange", "tcp"}) {
        if (*parentOf(fixed) == name) {
            out.emplace_back(fixed);
        }
    }
    for (const auto& [childName, child] : frames_) {
        if (child.parent == name) {
            out.push_back(childName);
        }
    }
    return out;
}

Result<Pose> WorldModel::convert(const Pose& pose, const std::string& from, const std::string& to,
                                 const ArmFrames& arm) const {
    const auto T_base_from = inBase(from, arm);
    const auto T_base_to = inBase(to, arm);
    if (!T_base_from || !T_base_to) {
        return noFrame(T_base_from ? to : from);
    }
    return Pose(T_base_to->inverse() * *T_base_from * pose.transform());
}

Result<Pose> WorldModel::poseOf(const std::string& name, const std::string& relative, const std::string& axes,
                                const ArmFrames& arm) const {
    const auto T_base_frame = inBase(name, arm);
    const auto T_base_relative = inBase(relative, arm);
    const auto T_base_axes = inBase(axes, arm);
    if (!T_base_frame || !T_base_relative || !T_base_axes) {
        return noFrame(!T_base_frame ? name : !T_base_relative ? relative : axes);
    }
    const Eigen::Matrix3d R_axes_base = T_base_axes->linear().transpose();
    const Eigen::Vector3d offset = T_base_frame->translation() - T_base_relative->translation();
    const Eigen::Matrix3d turn = T_base_frame->linear() * T_base_relative->linear().transpose();
    // If `axes` is `relative`, the result equals inverse(T_base_relative) * T_base_frame.
    return Pose(R_axes_base * offset, rotationVector(R_axes_base * turn * R_axes_base.transpose()));
}

Result<void> WorldModel::setMass(const std::string& name, const Payload& load) {
    const auto it = frames_.find(name);
    if (it == frames_.end()) {
        return noFrame(name);
    }
    it->second.load = load;
    return {};
}

Payload WorldModel::attachedPayload(const ArmFrames& arm) const {
    Payload sum;
    Eigen::Vector3d moment = Eigen::Vector3d::Zero();
    Eigen::Matrix3d inertia = Eigen::Matrix3d::Zero();  // about the flange
    const Eigen::Isometry3d T_flange_base = arm.flange.transform().inverse();
    for (const auto& [name, frame] : frames_) {
        if (!frame.load || !(hangsOn(name, "flange") || hangsOn(name, "tcp"))) {
            continue;
        }
        const Eigen::Isometry3d T_flange_frame = T_flange_base * *inBase(name, arm);
        const Eigen::Vector3d centre = T_flange_frame * frame.load->centreOfGravity;
        const Eigen::Matrix3d R = T_flange_frame.linear();
        sum.mass += frame.load->mass;
        moment += frame.load->mass * centre;
        inertia +=
            R * inertiaMatrix(frame.load->inertia) * R.transpose() + pointInertia(frame.load->mass, centre);
    }
    if (sum.mass > 0) {
        sum.centreOfGravity = moment / sum.mass;
        inertia -= pointInertia(sum.mass, sum.centreOfGravity);
    }
    sum.inertia << inertia(0, 0), inertia(1, 1), inertia(2, 2), inertia(0, 1), inertia(0, 2), inertia(1, 2);
    return sum;
}

}  // namespace tiller::simulator::urscript
