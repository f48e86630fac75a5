// SPDX-License-Identifier: MIT
#include "robot/station/program/preview/simulated_run.h"

#include <algorithm>
#include <map>

namespace tiller::program {
namespace {

simulator::ScriptRunOptions runOptions(const project::Project& project, const ProgramScript& script,
                                       const ScriptOptions& scriptOptions, const PreviewOptions& options) {
    simulator::ScriptRunOptions run;
    run.model = scriptOptions.model.value_or(project.robot.value_or(RobotModelId::UR5e));
    run.software = scriptOptions.version;
    run.start = options.start.value_or(startPosition(project, script));
    run.tcp = SimulatedRun::tcpAtStart(project, script);
    run.followedRegister = kStepRegister;
    run.seed = options.seed;
    run.followedVariables = options.variables;
    return run;
}

}  // namespace

SimulatedRun::SimulatedRun(const project::Project& project, const ProgramScript& script,
                           const ScriptOptions& scriptOptions, const PreviewOptions& options)
    : script_(script)
    , options_(options)
    , run_(runOptions(project, script, scriptOptions, options))
    , inputs_(options.inputs) {
    std::stable_sort(inputs_.begin(), inputs_.end(),
                     [](const InputChange& a, const InputChange& b) { return a.time < b.time; });
}

Pose SimulatedRun::tcpAtStart(const project::Project& project, const ProgramScript& script) {
    const project::Tool* active = project.tooling.tools.find(project.tooling.activeTool);
    return active != nullptr ? active->tcpOffset : script.tcp.value_or(Pose());
}

std::optional<simulator::ScriptFault> SimulatedRun::start(const QString& text) {
    applyInputs();
    return run_.start(text);
}

bool SimulatedRun::step() {
    const bool runs = run_.step();
    applyInputs();
    answerOperator();
    return runs;
}

void SimulatedRun::applyInputs() {
    while (nextInput_ < inputs_.size() && inputs_[nextInput_].time <= run_.time()) {
        run_.setDigitalInput(inputs_[nextInput_].channel, inputs_[nextInput_].value);
        ++nextInput_;
    }
}

void SimulatedRun::answerOperator() {
    if (!run_.waitsForOperator()) {
        askedAt_.reset();
    } else if (!askedAt_) {
        askedAt_ = run_.time();
    } else if (run_.time() - *askedAt_ >= options_.operatorTime) {
        const bool isQuestion = run_.waitsForAnswer();
        // The value is undefined if there are not enough answers.
        const QJsonValue answer = isQuestion && questions_ < options_.answers.size()
                                      ? options_.answers.at(questions_)
                                      : QJsonValue(QJsonValue::Undefined);
        if (!run_.answerOperator(answer) && isQuestion) {
            unfitAnswers_.push_back(questions_);
        }
        questions_ += isQuestion ? 1 : 0;
        askedAt_.reset();
    }
}

std::vector<InputChange> SimulatedRun::remainingInputs() const {
    std::vector<InputChange> remaining(inputs_.begin() + static_cast<std::ptrdiff_t>(nextInput_),
                                       inputs_.end());
    for (InputChange& change : remaining) {
        change.time -= run_.time();
    }
    return remaining;
}

std::vector<InputChange> SimulatedRun::inputs() const {
    std::map<int, bool> values;
    for (std::size_t i = 0; i < nextInput_; ++i) {
        values[inputs_[i].channel] = inputs_[i].value;
    }
    std::vector<InputChange> set;
    for (const auto& [channel, value] : values) {
        set.push_back({0, channel, value});
    }
    return set;
}

}  // namespace tiller::program
