// SPDX-License-Identifier: MIT
#include "robot/simulator/controller/controller_model.h"

namespace tiller::simulator {

ControllerModel::ControllerModel(const SimulatorOptions& options)
    : Plant(options), host_(*this), programs_(*this, host_) {
    refreshTelemetry();
}

ControllerModel::~ControllerModel() {
    programs_.endAll();  // programs that are ending still use the host, which refers to this object
}

void ControllerModel::step() {
    beginPeriod();
    host_.beginPeriod();
    programs_.step();
    reactToSafety();  // a script may have requested a protective stop
    host_.stepConveyors();
    endPeriod();
}

}  // namespace tiller::simulator
