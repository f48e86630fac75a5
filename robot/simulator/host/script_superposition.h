// SPDX-License-Identifier: MIT
#pragma once

// Superposed motions of a program: offsets and conveyors.

#include "robot/simulator/urscript/host.h"

namespace tiller::simulator {

class Plant;

/// Threads  the simulator thread
class ScriptSuperposition : public virtual urscript::SuperpositionHost {
public:
    explicit ScriptSuperposition(Plant& plant) : plant_(plant) {}

    /// Updates the encoder counts and moves the conveyors. Must be called once per control period, after the
    /// scripts.
    void stepConveyors();

    Result<void> enablePathOffset() override;
    Result<void> setPathOffset(const Pose& offset, int type) override;
    Result<Pose> pathOffset(int type) const override;
    Result<void> setPathOffsetFilter(double alpha) override;
    Result<void> setPathOffsetLimits(double translation, double rotation) override;
    Result<void> trackConveyorLinear(const Pose& direction, double ticksPerMeter, int encoder) override;
    Result<void> trackConveyorCircular(const Pose& center, double ticksPerRevolution, bool rotateTool,
                                       int encoder) override;
    Result<double> encoderTicks(int encoder) const override;
    Result<void> setEncoderTicks(int encoder, double ticks) override;
    Result<void> enableEncoder(int encoder, int decoder, int inputA, int inputB) override;
    Result<void> setEncoderRange(int encoder, int rangeId) override;

private:
    int trackedEncoder_ = 0;  ///< encoder of the tracked conveyor
    Plant& plant_;
};

}  // namespace tiller::simulator
