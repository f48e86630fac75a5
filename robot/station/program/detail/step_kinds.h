// SPDX-License-Identifier: MIT
#pragma once

// The step kinds. Each is defined in a separate file. Private to robot/station/program.

#include "robot/station/program/step_kind.h"

namespace tiller::program {

const StepKind& moveJStep();
const StepKind& moveLStep();
const StepKind& movePStep();
const StepKind& moveCircleStep();
const StepKind& moveGroupStep();
const StepKind& moveRelativeStep();
const StepKind& moveUntilStep();
const StepKind& setOutputStep();
const StepKind& pulseOutputStep();
const StepKind& setAnalogOutputStep();
const StepKind& setRegisterStep();
const StepKind& waitInputStep();
const StepKind& waitStep();
const StepKind& waitConditionStep();
const StepKind& gripperStep();
const StepKind& toolStep();
const StepKind& payloadStep();
const StepKind& frameStep();
const StepKind& speedStep();
const StepKind& forceStep();
const StepKind& loopStep();
const StepKind& whileLoopStep();
const StepKind& forEachWaypointStep();
const StepKind& forEachPlaceStep();
const StepKind& leaveLoopStep();
const StepKind& ifStep();
const StepKind& elseIfStep();
const StepKind& elseStep();
const StepKind& switchStep();
const StepKind& caseStep();
const StepKind& defaultStep();
const StepKind& callStep();
const StepKind& watchStep();
const StepKind& tryStep();
const StepKind& onErrorStep();
const StepKind& failStep();
const StepKind& endProgramStep();
const StepKind& assignStep();
const StepKind& messageStep();
const StepKind& questionStep();
const StepKind& noteStep();
const StepKind& scriptTextStep();
const StepKind& commentStep();
const StepKind& folderStep();

}  // namespace tiller::program
