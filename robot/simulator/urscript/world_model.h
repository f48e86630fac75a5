// SPDX-License-Identifier: MIT
#pragma once

// The named frames of PolyScope X: a tree below "world" that always contains "base", "flange" and "tcp".
// Frames attached to the flange or the TCP move with the arm. Source: world model list of the script
// directory. Behaviour that the source does not specify is documented at each function.

#include <Eigen/Geometry>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "robot/core/result.h"
#include "robot/core/spatial.h"
#include "robot/simulator/urscript/payload.h"

namespace tiller::simulator::urscript {

/// Position of the arm: T_base_flange and T_base_tcp.
struct ArmFrames {
    Pose flange, tcp;
};

/// Errors  all functions: ScriptError, naming the frame
class WorldModel {
public:
    static constexpr std::size_t kMaxFrames = 1000;

    /// Adds a frame. The name must be unique.
    /// pose  pose relative to `ref`, which becomes the parent
    Result<void> add(const std::string& name, const Pose& pose, const std::string& ref);
    /// Changes the parent of `child` without moving it. Cycles are refused.
    Result<void> attach(const std::string& child, const std::string& parent, const ArmFrames& arm);
    /// Moves a frame without changing its parent. Of the permanent frames, only the base can be moved (in the
    /// world). Frames attached to the world then do not move.
    /// pose  pose relative to `ref`
    Result<void> move(const std::string& name, const Pose& pose, const std::string& ref,
                      const ArmFrames& arm);
    /// Removes a frame. Its children are attached to its parent without moving.
    Result<void> remove(const std::string& name, const ArmFrames& arm);
    /// Removes all frames except the permanent ones.
    void clear() { frames_.clear(); }
    /// Like clear(), and also moves the base to the origin of the world.
    void reset() {
        clear();
        T_world_base_ = Eigen::Isometry3d::Identity();
    }

    bool contains(const std::string& name) const { return isFixed(name) || frames_.contains(name); }
    Result<std::string> parentOf(const std::string& name) const;
    Result<std::vector<std::string>> childrenOf(const std::string& name) const;
    Result<Pose> convert(const Pose& pose, const std::string& from, const std::string& to,
                         const ArmFrames& arm) const;
    /// Pose of `name` relative to `relative`, in the axes of `axes`.
    Result<Pose> poseOf(const std::string& name, const std::string& relative, const std::string& axes,
                        const ArmFrames& arm) const;

    /// load  payload in the axes of the frame
    Result<void> setMass(const std::string& name, const Payload& load);
    /// Total load attached to the flange and the TCP, in the flange frame.
    Payload attachedPayload(const ArmFrames& arm) const;

private:
    struct Frame {
        std::string parent;
        Eigen::Isometry3d T_parent_frame = Eigen::Isometry3d::Identity();
        std::optional<Payload> load;
    };
    static bool isFixed(std::string_view name);
    std::optional<Eigen::Isometry3d> inBase(std::string_view name, const ArmFrames& arm) const;
    bool hangsOn(std::string_view name, std::string_view ancestor) const;

    std::map<std::string, Frame, std::less<>> frames_;
    Eigen::Isometry3d T_world_base_ = Eigen::Isometry3d::Identity();
};

}  // namespace tiller::simulator::urscript
