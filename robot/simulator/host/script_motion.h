// SPDX-License-Identifier: MIT
#pragma once

// Converts the motion commands of URScript to those of the arm.

#include <map>

#include "robot/simulator/arm/arm.h"
#include "robot/simulator/urscript/host.h"

namespace tiller::simulator {

class Plant;

/// Threads  the simulator thread
class ScriptMotion : public virtual urscript::MotionHost {
public:
    explicit ScriptMotion(Plant& plant) : plant_(plant) {}

    Result<void> startMotion(urscript::ThreadId thread, const urscript::MotionCommand& command) override;
    Result<bool> motionFinished(urscript::ThreadId thread) override;
    void motionAbandoned(urscript::ThreadId thread) override;
    Result<void> forceMode(const urscript::ForceMode& mode) override;
    void endForceMode() override;
    Result<void> setForceModeDamping(double damping) override;
    double forceModeDamping() const override;
    Result<void> setForceModeGainScaling(double scaling) override;
    double forceModeGainScaling() const override;
    Result<void> freedrive(const urscript::Freedrive& mode) override;
    void endFreedrive() override;
    int freedriveStatus() const override;
    Result<void> setJointPositions(const JointPositions& q) override;
    Result<void> resetRevolutionCounter(const JointPositions& qNear) override;
    Result<void> screwDriving(double force, double speedLimit) override;
    Result<void> endScrewDriving() override;

    /// Discards the motions of an ended program.
    void forgetMotions() { motions_.clear(); }

private:
    struct Motion {
        arm::MotionId id = 0;
        bool settles = false;  ///< the command is a stop, which waits until the arm is at rest
        double settled = 0;    ///< time waited for standstill [s]
    };
    bool comesToRest(Motion& motion) const;
    Result<void> begunForces(const arm::ForceModeParameters& parameters);

    std::map<urscript::ThreadId, Motion> motions_;  ///< unfinished motions by thread
    Plant& plant_;
};

}  // namespace tiller::simulator
