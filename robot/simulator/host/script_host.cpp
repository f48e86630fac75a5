// SPDX-License-Identifier: MIT
#include "robot/simulator/host/script_host.h"

#include <QDateTime>

#include "robot/simulator/plant/plant.h"

namespace tiller::simulator {

namespace {

constexpr double kProgramEndDeceleration = 10.0;  ///< [rad/s2]

}  // namespace

ScriptHost::ScriptHost(Plant& plant)
    : ScriptMotion(plant)
    , ScriptSuperposition(plant)
    , ScriptArm(plant)
    , ScriptTerminals(plant)
    , ScriptMessages(plant)
    , plant_(plant) {}

void ScriptHost::beginPeriod() {
    serviceSockets();
    plant_.registers().overwritten.beginPeriod();
    if (const bool running = plant_.programs().isActive(); running != wasRunning_) {
        wasRunning_ = running;
        ScriptTerminals::programChanged(running);
        modbus().programChanged(running);
    }
    modbus().step(plant_.stepTime());
    const bool wanted = ScriptTerminals::freedriveWanted() || modbus().freedriveWanted();
    if (wanted != freedriveWanted_) {
        freedriveWanted_ = wanted;
        plant_.setFreedriveButton(wanted);
    }
}

double ScriptHost::stepTime() const {
    return plant_.stepTime();
}
std::int64_t ScriptHost::controllerTimeNs() const {
    return static_cast<std::int64_t>(plant_.timestampNs());
}
std::int64_t ScriptHost::systemTimeNs() const {
    return QDateTime::currentMSecsSinceEpoch() * 1'000'000;
}

Result<void> ScriptHost::protectiveStop() {
    constexpr std::int32_t kRequestedByProgram = 209;
    plant_.protectiveStop({kRequestedByProgram, 0, primary::ReportLevel::Warning, ""});
    return {};
}

void ScriptHost::powerDown() {
    plant_.shutDown();
}

Result<void> ScriptHost::setWatchdog(std::string_view field, double minFrequency,
                                     urscript::WatchdogAction action) {
    return plant_.watchdogs().set(field, minFrequency, action);
}

void ScriptHost::programEnded(urscript::ProgramKind kind) {
    if (kind == urscript::ProgramKind::Secondary || !plant_.programs().isEndingMain()) {
        return;
    }
    forgetMotions();
    plant_.popups().closeBlocking();
    forgetRequests();
    plant_.arm().compliance().endForceMode();
    plant_.arm().compliance().endFreedrive();
    plant_.arm().abort(kProgramEndDeceleration);
    plant_.watchdogs().clear();
    plant_.setExternalSensorInUse(false);
    closeAllSockets();
}

}  // namespace tiller::simulator
