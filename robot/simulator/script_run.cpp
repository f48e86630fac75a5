// SPDX-License-Identifier: MIT
#include "robot/simulator/script_run.h"

#include <QJsonArray>
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "robot/rtde/fields.h"
#include "robot/simulator/controller/controller_model.h"
#include "robot/simulator/host/script_host.h"
#include "robot/simulator/programs/program_runner.h"
#include "robot/simulator/urscript/value_format.h"

namespace tiller::simulator {

namespace {

SimulatorOptions plantOptions(const ScriptRunOptions& options) {
    SimulatorOptions plant;
    plant.model = options.model;
    plant.software = options.software;
    plant.time = Time::Virtual;
    plant.poweredOn = true;
    plant.startJoints = options.start;
    plant.seed = options.seed;
    return plant;
}

QJsonValue jsonOf(const urscript::Value& value) {
    using Type = urscript::Value::Type;
    switch (value.type()) {
        case Type::Unset:
            return QJsonValue::Undefined;
        case Type::Bool:
            return value.asBool();
        case Type::Int:
        case Type::Float:
            return value.number();
        case Type::Pose: {
            QJsonArray list;
            for (const double number : value.pose()) {
                list.append(number);
            }
            return list;
        }
        case Type::List: {
            QJsonArray list;
            for (std::size_t i = 0; i < value.list().size(); ++i) {
                list.append(jsonOf(value.list().at(i)));
            }
            return list;
        }
        case Type::String:
            return QString::fromStdString(value.string());
        default:
            return QString::fromStdString(urscript::toStr(value));
    }
}

}  // namespace

class ScriptRun::Impl {
public:
    explicit Impl(const ScriptRunOptions& options) : plant(plantOptions(options)) {
        for (const std::string& name : options.followedVariables) {
            variables.emplace_back(name, urscript::Value());
        }
        if (options.tcp) {
            plant.arm().setTcp(*options.tcp);
        }
        plant.registers().followed.number = static_cast<std::size_t>(options.followedRegister);
        // The arm reports its position only after a period. Run one period without a program.
        plant.step();
    }

    /// Copies the followed variables, because they no longer exist when the program has ended.
    void readVariables() {
        if (const urscript::Interpreter* program = plant.programs().unreportedProgram()) {
            for (auto& [name, value] : variables) {
                if (const urscript::Value* now = program->global(name)) {
                    value = *now;
                }
            }
        }
    }

    ControllerModel plant;
    std::vector<std::pair<std::string, urscript::Value>> variables;
    double began = 0;
};

ScriptRun::ScriptRun(const ScriptRunOptions& options) : d_(std::make_unique<Impl>(options)) {}
ScriptRun::~ScriptRun() = default;

std::optional<ScriptFault> ScriptRun::check(const QString& script, const SoftwareVersion& software) {
    urscript::CompileOptions options;
    options.version = software;
    const urscript::CompileOutcome outcome = urscript::compile(script.toStdString(), options);
    return outcome
               ? std::nullopt
               : std::optional(ScriptFault{outcome.error.line, QString::fromStdString(outcome.error.text)});
}

bool ScriptRun::isReservedName(const QString& name) {
    return urscript::isReservedName(name.toStdString());
}

std::optional<ScriptFault> ScriptRun::start(const QString& script) {
    if (auto fault = check(script, d_->plant.options().software)) {
        return fault;
    }
    d_->plant.programs().submitText(script.toStdString());
    d_->began = d_->plant.elapsed();
    return std::nullopt;
}

bool ScriptRun::step() {
    d_->plant.step();
    static_cast<void>(d_->plant.takeOutbox());
    d_->readVariables();
    return d_->plant.programs().isActive() && !d_->plant.programs().isPaused();
}

double ScriptRun::stepTime() const {
    return d_->plant.stepTime();
}
double ScriptRun::time() const {
    return d_->plant.elapsed() - d_->began;
}
JointPositions ScriptRun::q() const {
    return d_->plant.arm().state().targetQ;
}
Pose ScriptRun::tcpPose() const {
    return d_->plant.arm().state().targetTcpPose;
}
bool ScriptRun::isStandstill() const {
    return d_->plant.arm().state().isStandstill();
}
double ScriptRun::tcpForce() const {
    return d_->plant.telemetry().tcpForce.force.norm();
}
std::array<double, 2> ScriptRun::analogOutputs() const {
    return {d_->plant.pins().analogOutput(0), d_->plant.pins().analogOutput(1)};
}
QJsonValue ScriptRun::followedVariable(const std::string& name) const {
    const auto found = std::find_if(d_->variables.begin(), d_->variables.end(),
                                    [&name](const auto& entry) { return entry.first == name; });
    return found == d_->variables.end() ? QJsonValue(QJsonValue::Undefined) : jsonOf(found->second);
}
std::uint64_t ScriptRun::digitalOutputs() const {
    return d_->plant.pins().digitalOutputs;
}
SafetyMode ScriptRun::safetyMode() const {
    return d_->plant.safety().mode();
}
ControllerState ScriptRun::controllerState() const {
    const RegisterBank& registers = d_->plant.registers().output;
    ControllerState state{d_->plant.pins().digitalOutputs,
                          d_->plant.pins().analogOutputLevels,
                          registers.bits,
                          registers.ints,
                          registers.doubles,
                          d_->plant.arm().tcp(),
                          d_->plant.arm().payload().mass,
                          d_->plant.arm().payload().centreOfGravity};
    if (const auto followed = d_->plant.registers().followed.number) {
        state.integerRegisters.at(*followed) = 0;
    }
    return state;
}
void ScriptRun::setControllerState(const ControllerState& state) {
    d_->plant.pins().digitalOutputs = state.digitalOutputs;
    d_->plant.pins().analogOutputLevels = state.analogOutputs;
    RegisterBank& registers = d_->plant.registers().output;
    registers.bits = state.boolRegisters;
    registers.ints = state.integerRegisters;
    registers.doubles = state.floatRegisters;
    d_->plant.arm().setTcp(state.tcp);
    arm::Payload payload;
    payload.mass = state.payload;
    payload.centreOfGravity = state.payloadCentre;
    d_->plant.arm().setPayload(payload);
}
std::optional<QString> ScriptRun::variable(const QString& name) const {
    const urscript::Interpreter* program = d_->plant.programs().mainProgram();
    const urscript::Value* value = program != nullptr ? program->global(name.toStdString()) : nullptr;
    return value != nullptr ? std::optional(QString::fromStdString(urscript::toStr(*value))) : std::nullopt;
}
std::vector<std::int32_t> ScriptRun::takeWritten() {
    return std::exchange(d_->plant.registers().followed.values, {});
}
std::optional<ScriptFault> ScriptRun::failure() const {
    const auto& failure = d_->plant.programs().failure();
    return failure ? std::optional(ScriptFault{failure->line, QString::fromStdString(failure->text)})
                   : std::nullopt;
}
QString ScriptRun::stopText() const {
    return QString::fromStdString(d_->plant.stopText());
}

bool ScriptRun::waitsForOperator() const {
    return d_->plant.popups().anyBlocking() || d_->plant.scriptHost().asked();
}
bool ScriptRun::waitsForAnswer() const {
    return d_->plant.scriptHost().asked().has_value();
}
bool ScriptRun::answerOperator(const QJsonValue& answer) {
    d_->plant.popups().closeBlocking();
    const auto asked = d_->plant.scriptHost().asked();
    if (!asked) {
        return answer.isUndefined();
    }
    using urscript::RequestedType;
    ScriptHost& host = d_->plant.scriptHost();
    constexpr double kLargest = std::numeric_limits<std::int32_t>::max();
    const double number = answer.toDouble();
    bool fits = answer.isUndefined();
    switch (*asked) {
        case RequestedType::Boolean:
            fits = fits || answer.isBool();
            host.answerRequest(answer.toBool());
            break;
        case RequestedType::Integer: {
            const bool isWhole = number == std::floor(number) && std::abs(number) <= kLargest;
            fits = fits || (answer.isDouble() && isWhole);
            host.answerRequest(static_cast<std::int32_t>(isWhole ? number : 0));
            break;
        }
        case RequestedType::Float:
            fits = fits || answer.isDouble();
            host.answerRequest(number);
            break;
        case RequestedType::String:
            fits = fits || answer.isString();
            host.answerRequest(answer.toString().toStdString());
            break;
    }
    return fits;
}

void ScriptRun::setDigitalInput(int channel, bool value) {
    if (channel >= 0 && channel < kDigitalPins) {
        Pins::setBit(d_->plant.pins().digitalInputs, channel, value);
    }
}
void ScriptRun::setAnalogInput(int number, double value) {
    if (number == 0 || number == 1) {
        d_->plant.pins().analogInputs[static_cast<std::size_t>(number)] = value;
    }
}
void ScriptRun::setInputInteger(int number, std::int32_t value) {
    d_->plant.registers().input.ints.at(static_cast<std::size_t>(number)) = value;
    const rtde::Field* field = rtde::findInput(rtde::intRegisterName(rtde::Direction::Input, number));
    if (field != nullptr) {
        d_->plant.watchdogs().touched(static_cast<std::size_t>(field - rtde::inputFields().data()));
    }
}
void ScriptRun::setHandForce(const Eigen::Vector3d& force) {
    d_->plant.arm().environment().setHandWrench(Wrench{force, Eigen::Vector3d::Zero()});
}
void ScriptRun::stop(StopEvent event) {
    constexpr std::int32_t kCollision = 157;
    switch (event) {
        case StopEvent::ProtectiveStop:
            d_->plant.protectiveStop(
                {kCollision, 0, primary::ReportLevel::Warning, "a protective stop was triggered"});
            break;
        case StopEvent::OperatorStop:
            d_->plant.programs().requestStop();
            break;
        case StopEvent::EmergencyStop:
            d_->plant.safety().set(SafetySystem::Input::RobotEmergencyStop, true);
            break;
        case StopEvent::PowerLoss:
            d_->plant.losePower();
            break;
    }
}

}  // namespace tiller::simulator
