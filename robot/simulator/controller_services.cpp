// SPDX-License-Identifier: MIT
#include "robot/simulator/controller_services.h"

#include <QAbstractEventDispatcher>

#include "robot/simulator/faults.h"
#include "robot/simulator/host/script_host.h"
#include "robot/simulator/programs/program_runner.h"

namespace tiller::simulator {

ControllerServices::ControllerServices(const SimulatorOptions& options)
    : plant(options)
    , services(plant, [this](std::string_view line) { return answerFaultLine(*this, line); }) {}

void ControllerServices::service() {
    // Qt events are required only to accept connections and for sockets of scripts, so they are processed
    // only then.
    const bool hasClient = services.link().poller().poll();
    if (hasClient || plant.scriptHost().hasSockets() || plant.programs().awaitsScript()) {
        if (auto* dispatcher = QAbstractEventDispatcher::instance()) {
            dispatcher->processEvents(QEventLoop::AllEvents);
        }
    }
    services.faults().service();  // not skipped in silent mode, so that a fault line can end that mode
    if (!silent) {
        services.service();
    }
    if (plant.isShutDown()) {
        services.close();
    }
}

void ControllerServices::tick() {
    services.rtde().beginPeriod();
    service();
    plant.step();
    if (plant.telemetry().boots != boots_) {
        boots_ = plant.telemetry().boots;
        services.closeClients();
    }
    if (!silent) {
        services.publish();
    }
}

void ControllerServices::setRemoteControl(bool remote) {
    if (plant.isRemoteControl() == remote) {
        return;
    }
    plant.setRemoteControl(remote);
    if (!remote && plant.assumptions().remoteToLocal == BehaviourOptions::RemoteToLocal::Ends) {
        plant.programs().requestStop();
    }
    if (plant.options().gateLocalControl && !remote && !plant.options().software.isCb3()) {
        services.closeScriptClients();
    }
}

}  // namespace tiller::simulator
