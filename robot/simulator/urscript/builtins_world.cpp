// SPDX-License-Identifier: MIT
// Named frames (PolyScope X).

#include "robot/simulator/urscript/builtin_table.h"
#include "robot/simulator/urscript/call.h"

namespace tiller::simulator::urscript {

namespace {

template <class T>
T valueOrFault(Result<T> outcome) {
    if (!outcome.ok()) {
        fault(outcome.error());
    }
    return std::move(*outcome);
}

Pose finitePose(const Call& c, std::size_t i) {
    const Pose pose = c.pose(i);
    if (!pose.allFinite()) {
        c.badArgument(i, "a pose of finite numbers");
    }
    return pose;
}

Status addFrame(Call& c) {
    c.check(c.host.world().add(c.string(0), finitePose(c, 1), c.string(2)));
    return Status::Done;
}
Status attachFrame(Call& c) {
    c.check(c.host.world().attach(c.string(0), c.string(1), c.host.armFrames()));
    return Status::Done;
}
Status moveFrame(Call& c) {
    c.check(c.host.world().move(c.string(0), finitePose(c, 1), c.string(2), c.host.armFrames()));
    return Status::Done;
}
Status deleteFrame(Call& c) {
    c.check(c.host.world().remove(c.string(0), c.host.armFrames()));
    return Status::Done;
}
Status deleteAllFrames(Call& c) {
    c.host.world().clear();
    return Status::Done;
}
Status resetWorldModel(Call& c) {
    c.host.world().reset();
    return Status::Done;
}
Status getPose(Call& c) {
    c.result = valueOrFault(c.host.world().poseOf(
        c.string(0), c.string(1), c.given(2) ? c.string(2) : c.string(1), c.host.armFrames()));
    return Status::Done;
}
Status convertPose(Call& c) {
    c.result = valueOrFault(c.host.convertPose(finitePose(c, 0), c.string(1), c.string(2)));
    return Status::Done;
}
Status isFrame(Call& c) {
    c.result = c.host.world().contains(c.string(0));
    return Status::Done;
}
Status frameParent(Call& c) {
    c.result = Value(valueOrFault(c.host.world().parentOf(c.string(0))));
    return Status::Done;
}
Status frameChildren(Call& c) {
    ListData data;
    for (const std::string& name : valueOrFault(c.host.world().childrenOf(c.string(0)))) {
        data.insert(data.size(), Value(name));
    }
    c.result = Value::list(std::move(data));
    return Status::Done;
}

Status setMassProperties(Call& c) {
    Payload load;
    load.mass = c.finite(1);
    load.centreOfGravity = c.three(2);
    const std::array<double, 6> inertia = c.six(3);
    load.inertia = Eigen::Map<const Vector6>(inertia.data());
    if (load.mass < 0 || !load.centreOfGravity.allFinite() || !load.inertia.allFinite()) {
        fault("set_mass_properties: mass, centre of gravity and inertia must be finite numbers");
    }
    c.check(c.host.world().setMass(c.string(0), load));
    return Status::Done;
}
Status setPayloadFromFrames(Call& c) {
    c.check(c.host.setPayload(c.host.world().attachedPayload(c.host.armFrames()), 0, false));
    return Status::Done;
}

constexpr BuiltinRow kWorldRows[] = {
    {"add_frame(name, pose, ref_name=\"base\")", addFrame, kPlain, kPolyScopeX},
    {"attach_frame(child, parent)", attachFrame, kPlain, kPolyScopeX},
    {"move_frame(name, pose, ref_name=\"base\")", moveFrame, kPlain, kPolyScopeX},
    {"delete_frame(name)", deleteFrame, kPlain, kPolyScopeX},
    {"delete_all_frames()", deleteAllFrames, kPlain, kPolyScopeX},
    {"reset_world_model()", resetWorldModel, kPlain, kPolyScopeX},
    {"get_pose(name, rel_name, ref_name?)", getPose, kPlain, kPolyScopeX},
    {"convert_pose(pose, from_frame, to_frame)", convertPose, kPlain, kPolyScopeX},
    {"is_frame(name)", isFrame, kPlain, kPolyScopeX},
    {"get_frame_parent(name)", frameParent, kPlain, kPolyScopeX},
    {"get_children(name)", frameChildren, kPlain, kPolyScopeX},
    {"set_mass_properties(frame, m, cog, inertia)", setMassProperties, kPlain, kPolyScopeX},
    {"set_payload_from_attached_frames()", setPayloadFromFrames, kPlain, kPolyScopeX},
};

}  // namespace

std::span<const BuiltinRow> worldBuiltins() {
    return kWorldRows;
}

}  // namespace tiller::simulator::urscript
