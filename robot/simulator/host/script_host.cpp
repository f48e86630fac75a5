// SPDX-License-Identifier: MIT
#include "robot/simulator/host/script_host.h"

#include <QDateTime>

#include "robot/simulator/box/plant.h"
#include "robot/simulator/programs/program_runner.h"

namespace tiller::simulator {

namespace {

constexpr double kProgramEndDeceleration = 10.0;  ///< [rad/s2]

std::size_t at(int number) {
    return static_cast<std::size_t>(number);
}

int pin(urscript::DigitalBank bank, int n) {
    switch (bank) {
        case urscript::DigitalBank::Standard:
            return n;
        case urscript::DigitalBank::Configurable:
            return kConfigurablePin + n;
        case urscript::DigitalBank::Tool:
            return kToolPin + n;
    }
    return n;
}

const RegisterBank& bank(const Plant& plant, urscript::RegisterSide side) {
    return side == urscript::RegisterSide::Input ? plant.registers().input : plant.registers().output;
}

}  // namespace

ScriptHost::ScriptHost(Plant& plant) : plant_(plant) {}
ScriptHost::~ScriptHost() = default;

// ---- registers ------------------------------------------------------------------------------------------

bool ScriptHost::boolRegister(urscript::RegisterSide side, int address) const {
    return bank(plant_, side).bits[at(address)];
}
std::int32_t ScriptHost::intRegister(urscript::RegisterSide side, int address) const {
    return bank(plant_, side).ints[at(address)];
}
double ScriptHost::floatRegister(urscript::RegisterSide side, int address) const {
    return bank(plant_, side).doubles[at(address)];
}
void ScriptHost::setBoolOutput(int address, bool value) {
    plant_.registers().output.bits[at(address)] = value;
}
void ScriptHost::setIntOutput(int address, std::int32_t value) {
    std::int32_t& number = plant_.registers().output.ints[at(address)];
    plant_.registers().overwritten.write(at(address), number);
    number = value;
}
void ScriptHost::setFloatOutput(int address, double value) {
    plant_.registers().output.doubles[at(address)] = value;
}
bool ScriptHost::flag(int number) const {
    return plant_.registers().flags[at(number)];
}
void ScriptHost::setFlag(int number, bool value) {
    plant_.registers().flags[at(number)] = value;
}

// ---- pins -----------------------------------------------------------------------------------------------

bool ScriptHost::digitalInput(urscript::DigitalBank bank, int n) const {
    return Pins::bit(plant_.pins().digitalInputs, pin(bank, n));
}
bool ScriptHost::digitalOutput(urscript::DigitalBank bank, int n) const {
    return Pins::bit(plant_.pins().digitalOutputs, pin(bank, n));
}
void ScriptHost::setDigitalOutput(urscript::DigitalBank bank, int n, bool value) {
    Pins::setBit(plant_.pins().digitalOutputs, pin(bank, n), value);
}

double ScriptHost::analog(urscript::AnalogPort port, int n) const {
    const Pins& pins = plant_.pins();
    switch (port) {
        case urscript::AnalogPort::StandardInput:
            return pins.analogInputs[at(n)];
        case urscript::AnalogPort::StandardOutput:
            return pins.analogOutput(at(n));
        case urscript::AnalogPort::ToolInput:
            return pins.toolAnalogInputs[at(n)];
    }
    return 0;
}

void ScriptHost::setAnalogOutput(int n, double level) {
    plant_.pins().setAnalogOutput(at(n), level);
}

void ScriptHost::setAnalogDomain(urscript::AnalogPort port, int n, int domain) {
    Pins& pins = plant_.pins();
    const unsigned value = domain == 0 ? 0 : 1;
    switch (port) {
        case urscript::AnalogPort::StandardInput:
            pins.analogInputDomains[at(n)] = value;
            break;
        case urscript::AnalogPort::StandardOutput:
            pins.analogOutputDomains[at(n)] = value;
            break;
        case urscript::AnalogPort::ToolInput:
            pins.toolAnalogDomains[at(n)] = value;
            break;
    }
}

void ScriptHost::setToolVoltage(int volts) {
    plant_.pins().toolVoltage = volts;
}

void ScriptHost::setToolCommunication(const urscript::ToolCommunication& settings) {
    plant_.pins().toolCommunication = {settings.enabled,  settings.baudRate,    settings.parity,
                                       settings.stopBits, settings.rxIdleChars, settings.txIdleChars};
}

void ScriptHost::setToolOutputMode(int mode) {
    plant_.pins().toolOutputMode = mode;
}
void ScriptHost::setToolDigitalOutputMode(int n, int mode) {
    plant_.pins().toolDigitalOutputModes[at(n)] = mode;
}

// ---- sockets --------------------------------------------------------------------------------------------

bool ScriptHost::openSocket(std::string_view name, std::string_view address, int port) {
    return sockets_.open(name, address, port);
}
urscript::SocketHost::State ScriptHost::socketState(std::string_view name) const {
    return sockets_.state(name);
}
void ScriptHost::closeSocket(std::string_view name) {
    sockets_.close(name);
}
bool ScriptHost::sendSocket(std::string_view name, std::string_view bytes) {
    return sockets_.send(name, bytes);
}
std::string_view ScriptHost::receivedBytes(std::string_view name) const {
    return sockets_.received(name);
}
void ScriptHost::consumeBytes(std::string_view name, std::size_t count) {
    sockets_.consume(name, count);
}

// ---- messages -------------------------------------------------------------------------------------------

void ScriptHost::textMessage(std::string_view text) {
    plant_.publish(primary::text(plant_.timestampNs(), text));
}

void ScriptHost::programLabel(int number, std::string_view text) {
    plant_.publish(primary::label(plant_.timestampNs(), number, text));
}

int ScriptHost::showPopup(const urscript::Popup& popup) {
    const int id = plant_.popups().open(popup.blocking);
    plant_.publish(
        primary::popup(plant_.timestampNs(), {static_cast<std::uint32_t>(id), popup.warning, popup.error,
                                              popup.blocking, popup.title, popup.text}));
    return id;
}

bool ScriptHost::popupOpen(int id) const {
    return plant_.popups().isOpen(id);
}

// ---- program --------------------------------------------------------------------------------------------

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
    motions_.clear();
    plant_.popups().closeBlocking();
    requests_.clear();
    plant_.arm().compliance().endForceMode();
    plant_.arm().compliance().endFreedrive();
    plant_.arm().abort(kProgramEndDeceleration);
    plant_.watchdogs().clear();
    plant_.setExternalSensorInUse(false);
    sockets_.closeAll();
}

}  // namespace tiller::simulator
