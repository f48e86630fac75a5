// SPDX-License-Identifier: GPL-3.0-or-later

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QRegularExpression>

#include "app/cli_command.h"
#include "app/cli_options.h"
#include "app/cli_program.h"
#include "app/termination.h"
#include "robot/control/controller.h"
#include "robot/core/wait_until.h"
#include "robot/receive/receiver.h"
#include "robot/station/program/execution/program_execution.h"
#include "robot/station/program/preview/preview.h"
#include "robot/station/program/recover/recovery_map.h"
#include "robot/station/program/recover/steps_not_reached.h"

namespace tiller::app {

namespace {

using namespace std::chrono_literals;
using program::Preview;

/// Parses an input change, e.g. "DI3=on@2.5".
std::optional<program::InputChange> inputFrom(const QString& text) {
    static const QRegularExpression form(QStringLiteral("^([DCT])I([0-7])=(on|off)(?:@([0-9.]+))?\\z"));
    const QRegularExpressionMatch match = form.match(text);
    if (!match.hasMatch() || (match.captured(1) == QLatin1String("T") && match.captured(2).toInt() > 1)) {
        return std::nullopt;
    }
    const project::IoGroup group = match.captured(1) == QLatin1String("D")   ? project::IoGroup::Standard
                                   : match.captured(1) == QLatin1String("C") ? project::IoGroup::Configurable
                                                                             : project::IoGroup::Tool;
    bool isTime = true;
    program::InputChange change;
    change.channel = project::channelOf(group, match.captured(2).toInt());
    change.value = match.captured(3) == QLatin1String("on");
    change.time = match.captured(4).isEmpty() ? 0 : match.captured(4).toDouble(&isTime);
    return isTime ? std::optional(change) : std::nullopt;
}

/// Parses an assignment, e.g. "count=3@7".
std::optional<NumberedAssignment> assignmentFrom(const QString& text) {
    static const QRegularExpression form(QStringLiteral("^([A-Za-z_][A-Za-z0-9_]*)=(.+)@([0-9]{1,7})\\z"));
    const QRegularExpressionMatch match = form.match(text);
    return match.hasMatch() ? std::optional(NumberedAssignment{match.captured(1), match.captured(2),
                                                               match.captured(3).toInt()})
                            : std::nullopt;
}

QJsonArray listOf(const std::array<double, 6>& values) {
    QJsonArray list;
    for (const double value : values) {
        list.append(value);
    }
    return list;
}

/// The value of a variable, e.g. "True" or "[1,2.5]".
QString textOf(const QJsonValue& value) {
    if (value.isBool()) {
        return value.toBool() ? QStringLiteral("True") : QStringLiteral("False");
    }
    const QString list = QString::fromUtf8(QJsonDocument(QJsonArray{value}).toJson(QJsonDocument::Compact));
    return list.mid(1, list.size() - 2);
}

QJsonArray findingsJson(const LoadedProgram& loaded, const std::vector<program::Finding>& findings) {
    QJsonArray list;
    for (const program::Finding& finding : findings) {
        list.append(QJsonObject{{"kind", QString::fromStdString(toString(finding.kind))},
                                {"step", finding.step},
                                {"name", stepName(loaded, finding.step)},
                                {"time", finding.time},
                                {"text", finding.text}});
    }
    return list;
}

QJsonArray timingsJson(const LoadedProgram& loaded, const std::vector<program::StepTiming>& timings) {
    QJsonArray steps;
    for (std::size_t i = 0; i < timings.size(); ++i) {
        const program::StepTiming& timing = timings[i];
        steps.append(QJsonObject{{"number", static_cast<int>(i) + 1},
                                 {"name", stepName(loaded, static_cast<int>(i) + 1)},
                                 {"count", timing.count},
                                 {"first", timing.first},
                                 {"total", timing.total}});
    }
    return steps;
}

QJsonObject toJson(const LoadedProgram& loaded, const Preview& preview) {
    QJsonObject variables;
    for (const auto& [name, value] : preview.variables) {
        variables.insert(QString::fromStdString(name), value.isUndefined() ? QJsonValue::Null : value);
    }
    return {{"simulated", true},
            {"completed", preview.completed},
            {"duration", preview.duration},
            {"findings", findingsJson(loaded, preview.findings)},
            {"steps", timingsJson(loaded, preview.timings)},
            {"variables", variables},
            {"outputs", static_cast<double>(preview.outputs)},
            {"endJoints", listOf(preview.endJoints.array())},
            {"endPose", listOf(preview.endPose.array())}};
}

void print(const LoadedProgram& loaded, const Preview& preview) {
    out() << QStringLiteral("simulated: %1 after %2 s\n")
                 .arg(preview.completed ? QStringLiteral("completed") : QStringLiteral("ended"))
                 .arg(preview.duration, 0, 'f', 3);
    for (std::size_t i = 0; i < preview.timings.size(); ++i) {
        const program::StepTiming& timing = preview.timings[i];
        if (timing.count > 0) {
            const int number = static_cast<int>(i) + 1;
            out() << QStringLiteral("%1  %2  %3 x  %4 s\n")
                         .arg(number, 4)
                         .arg(stepName(loaded, number), -24)
                         .arg(timing.count, 5)
                         .arg(timing.total, 10, 'f', 3);
        }
    }
    for (const auto& [name, value] : preview.variables) {
        if (!value.isUndefined()) {
            out() << QStringLiteral("%1 = %2\n").arg(QString::fromStdString(name), textOf(value));
        }
    }
    for (const program::Finding& finding : preview.findings) {
        out() << QStringLiteral("%1 s  %2\n")
                     .arg(finding.time, 0, 'f', 3)
                     .arg(problemText(loaded, finding.step, finding.text));
    }
}

const char* wordOf(program::StopKind kind) {
    switch (kind) {
        case program::StopKind::Protective:
            return "protectiveStop";
        case program::StopKind::Operator:
            return "operatorStop";
        case program::StopKind::LinkLoss:
            return "linkLoss";
        case program::StopKind::PowerLoss:
            return "powerLoss";
    }
    return "";
}

const char* wordOf(program::Recovery recovery) {
    switch (recovery) {
        case program::Recovery::NotReached:
            return "notReached";
        case program::Recovery::Continue:
            return "continue";
        case program::Recovery::MoveBack:
            return "moveBack";
        case program::Recovery::Unsafe:
            return "unsafe";
    }
    return "";
}

QJsonObject marksJson(const program::StopMarks& marks) {
    QJsonObject object;
    for (const program::StopKind kind : program::kStopKinds) {
        const program::StopMark& mark = marks[static_cast<std::size_t>(kind)];
        object.insert(QLatin1String(wordOf(kind)),
                      QJsonObject{{"mark", QLatin1String(wordOf(mark.recovery))}, {"reason", mark.reason}});
    }
    return object;
}

QJsonObject recoveryJson(const LoadedProgram& loaded, const program::RecoveryMap& map) {
    QJsonArray steps;
    for (std::size_t i = 0; i < map.steps.size(); ++i) {
        steps.append(QJsonObject{{"number", static_cast<int>(i) + 1},
                                 {"name", stepName(loaded, static_cast<int>(i) + 1)},
                                 {"from", map.steps[i].from},
                                 {"stops", marksJson(map.steps[i].marks)}});
    }
    QJsonArray points;
    for (const program::StopPoint& point : map.points) {
        points.append(
            QJsonObject{{"time", point.time}, {"step", point.step}, {"stops", marksJson(point.marks)}});
    }
    QJsonArray unchecked;
    for (const program::UncheckedStep& step : program::uncheckedSteps(loaded.project, loaded.script, map)) {
        unchecked.append(QJsonObject{
            {"number", step.number}, {"name", stepName(loaded, step.number)}, {"reason", step.reason}});
    }
    const program::RecoveryCount count = program::countRecoverable(map);
    return {{"simulated", true},       {"completed", map.isComplete},
            {"checked", count.steps},  {"recoverable", count.recoverable},
            {"total", steps.size()},   {"steps", steps},
            {"notChecked", unchecked}, {"points", points}};
}

void print(const LoadedProgram& loaded, const program::RecoveryMap& map) {
    const program::RecoveryCount count = program::countRecoverable(map);
    out() << QStringLiteral(
                 "simulated: the program can continue after a stop in %1 of the %2 steps that were checked; "
                 "the "
                 "program has %3 steps\n")
                 .arg(count.recoverable)
                 .arg(count.steps)
                 .arg(map.steps.size());
    for (std::size_t i = 0; i < map.steps.size(); ++i) {
        const program::StepRecovery& recovery = map.steps[i];
        if (recovery.from == 0) {
            continue;
        }
        const int number = static_cast<int>(i) + 1;
        out() << QStringLiteral("%1  %2  continues from step %3\n")
                     .arg(number, 4)
                     .arg(stepName(loaded, number), -24)
                     .arg(recovery.from);
        for (const program::StopKind kind : program::kStopKinds) {
            const program::StopMark& mark = recovery.of(kind);
            out() << QStringLiteral("      %1  %2  %3\n")
                         .arg(QLatin1String(wordOf(kind)), -15)
                         .arg(QLatin1String(wordOf(mark.recovery)), -10)
                         .arg(mark.reason);
        }
    }
    for (const program::UncheckedStep& step : program::uncheckedSteps(loaded.project, loaded.script, map)) {
        out() << QStringLiteral("%1  %2  not checked: %3\n")
                     .arg(step.number, 4)
                     .arg(stepName(loaded, step.number), -24)
                     .arg(step.reason);
    }
}

int refuse(const LoadedProgram& loaded, bool json) {
    if (json) {
        QJsonArray problems;
        for (const program::ProgramProblem& problem : loaded.script.problems) {
            problems.append(QJsonObject{{"step", problem.number},
                                        {"name", stepName(loaded, problem.number)},
                                        {"field", problem.field},
                                        {"text", problem.text}});
        }
        out() << QJsonDocument(QJsonObject{{"completed", false}, {"problems", problems}}).toJson();
        out().flush();
    }
    for (const program::ProgramProblem& problem : loaded.script.problems) {
        complain(problemText(loaded, problem.number, problem.text), kFailed);
    }
    return kFailed;
}

using program::ProgramExecution;

struct RobotRun {
    QString address;
    int portOffset = 0;
    bool printsVariables = false;
    bool printsJson = false;
};

/// Prints the step and the variables that have changed.
class Progress {
public:
    explicit Progress(bool printsVariables) : printsVariables_(printsVariables) {}

    void print(const LoadedProgram& loaded, const ProgramExecution& execution) {
        const int step = execution.status().step;
        if (step != step_ && step > 0) {
            out() << QStringLiteral("step %1 (%2)\n").arg(step).arg(stepName(loaded, step));
        }
        step_ = step;
        if (printsVariables_) {
            for (const script::ProgramVariable& variable : execution.variables()) {
                const QJsonValue value = program::jsonValue(variable);
                if (values_.value(variable.name) != value) {
                    values_.insert(variable.name, value);
                    out() << QStringLiteral("%1 = %2\n").arg(variable.name, textOf(value));
                }
            }
        }
        out().flush();
    }

private:
    const bool printsVariables_;
    int step_ = 0;
    QJsonObject values_;
};

QJsonObject toJson(const LoadedProgram& loaded, const ProgramExecution& execution, const QString& error) {
    const ProgramExecution::Status status = execution.status();
    QJsonObject variables;
    for (const script::ProgramVariable& variable : execution.variables()) {
        variables.insert(variable.name, program::jsonValue(variable));
    }
    return {{"simulated", false},
            {"completed", status.state == ProgramExecution::State::Completed},
            {"error", error},
            {"lastStep", status.lastStep},
            {"duration", status.seconds},
            {"steps", timingsJson(loaded, status.timings)},
            {"variables", variables}};
}

int runOnRobot(LoadedProgram loaded, const RobotRun& run, program::PreviewOptions given) {
    receive::ReceiverOptions receiverOptions;
    receiverOptions.host = run.address;
    receiverOptions.port = static_cast<std::uint16_t>(rtde::kPort + run.portOffset);
    receiverOptions.fields = program::executionFields();
    receive::Receiver receiver(receiverOptions);
    if (const auto started = receiver.start(); !started) {
        return complain(started.error().toString(), kFailed);
    }
    const auto first = receiver.waitForData(Deadline::after(5s));
    if (!first) {
        return complain(first.error().toString(), kFailed);
    }
    loaded.options.version = receiver.version();
    control::ControllerOptions controllerOptions;
    controllerOptions.host = run.address;
    controllerOptions.portOffset = run.portOffset;
    // The robot itself stops after 100 ms without a heartbeat. A shorter pause of this PC, which the robot
    // does not detect, must not end the run.
    controllerOptions.dataTimeout = 2s;
    controllerOptions.connectionTimeout = 2s;
    control::Controller controller(controllerOptions);
    if (const auto taken = controller.takeControl(Deadline::after(5s)); !taken) {
        return complain(taken.error().toString(), kFailed);
    }
    // The arm may still be braking if a program of another client was running. Wait for standstill, so that
    // the arm is still at the position of this sample when the program starts.
    const bool isStill = waitUntil(Deadline::after(5s), [&] { return !controller.status().moving; });
    const auto sample = receiver.subscribe().next(Deadline::after(5s));
    if (!isStill || !sample) {
        return complain(
            isStill ? sample.error().toString() : QStringLiteral("the arm did not stop within 5 s"), kFailed);
    }
    const std::uint64_t stops = controller.stops();
    bool isInterrupted = false;
    given.isCancelled = [&isInterrupted] {
        isInterrupted = isInterrupted || waitForTermination(0ms);
        return isInterrupted;
    };
    const program::CheckedProgram checked =
        program::checkForRobot(loaded.project, loaded.program, loaded.options, given, *sample);
    if (isInterrupted) {
        return complain(QStringLiteral("interrupted before the start of the program"), kFailed);
    }
    if (!checked.obstacles.isEmpty()) {
        for (const QString& obstacle : checked.obstacles) {
            complain(obstacle, kFailed);
        }
        return kFailed;
    }
    loaded.script = checked.script;
    ProgramExecution execution(controller, receiver.subscribe(), checked, {}, stops);
    const Deadline limit = Deadline::after(std::chrono::duration<double>(given.timeLimit));
    bool isLate = false;
    Progress progress(run.printsVariables);
    while (execution.isActive()) {
        if (waitForTermination(10ms) || (!isLate && limit.hasExpired())) {
            isLate = limit.hasExpired();
            execution.stop();
        }
        if (!run.printsJson) {
            progress.print(loaded, execution);
        }
    }
    const ProgramExecution::Status end = execution.status();
    QString error;
    if (end.state == ProgramExecution::State::Failed) {
        error = problemText(loaded, end.failedStep, QStringLiteral("the step failed"));
    } else if (end.state != ProgramExecution::State::Completed) {
        error = problemText(loaded, end.lastStep,
                            isLate ? QStringLiteral("the time limit set with --time-limit expired")
                                   : execution.wait(Deadline::never()).error().toString());
    }
    if (run.printsJson) {
        out() << QJsonDocument(toJson(loaded, execution, error)).toJson();
        out().flush();
    } else {
        progress.print(loaded, execution);
    }
    return error.isEmpty() ? kSuccess : complain(error, kFailed);
}

int runProgram(const CommandArguments& arguments) {
    if (arguments.operands().size() != 1) {
        return wrongArguments(QStringLiteral("run: one project file is required"));
    }
    if (arguments.isSet("simulate") == arguments.isSet("robot")) {
        return wrongArguments(QStringLiteral("run: either --simulate or --robot ADDRESS is required"));
    }
    if (arguments.isSet("recoverability") &&
        (arguments.isSet("robot") || arguments.isSet("from") || arguments.isSet("set"))) {
        return wrongArguments(QStringLiteral(
            "--recoverability requires --simulate and cannot be combined with --from or --set"));
    }
    if (arguments.isSet("robot") && !isHostName(arguments.value("robot"))) {
        return wrongArguments(
            QStringLiteral("run: '%1' is not an address or a host name").arg(arguments.value("robot")));
    }
    program::PreviewOptions options;
    for (const QString& text : arguments.values("input")) {
        const auto change = inputFrom(text);
        if (!change) {
            return wrongArguments(
                QStringLiteral("--input must have the form DI3=on or DI3=off@2.5, not '%1'").arg(text));
        }
        options.inputs.push_back(*change);
    }
    options.timeLimit = arguments.number("time-limit");
    std::vector<NumberedAssignment> assignments;
    for (const QString& text : arguments.values("set")) {
        const auto assignment = assignmentFrom(text);
        if (!assignment) {
            return wrongArguments(
                QStringLiteral("--set must have the form count=3@7 or done=True@7, not '%1'").arg(text));
        }
        assignments.push_back(*assignment);
    }
    auto loaded = loadProgram(arguments.operands().constFirst(), arguments.value("program"),
                              static_cast<int>(arguments.number("from")), assignments);
    if (!loaded) {
        return complain(loaded.error().toString(), kFailed);
    }
    if (!loaded->script.ok()) {
        return refuse(*loaded, arguments.isSet("json"));
    }
    holdTerminationSignals();
    if (arguments.isSet("robot")) {
        const RobotRun run{.address = arguments.value("robot"),
                           .portOffset = static_cast<int>(arguments.number("port-offset")),
                           .printsVariables = arguments.isSet("variables"),
                           .printsJson = arguments.isSet("json")};
        return runOnRobot(std::move(*loaded), run, options);
    }
    options.isCancelled = [] { return waitForTermination(std::chrono::milliseconds(0)); };
    if (arguments.isSet("recoverability")) {
        program::RecoveryOptions recovery;
        recovery.preview = options;
        const program::RecoveryMap map = program::checkRecovery(loaded->project, loaded->program,
                                                                loaded->script, loaded->options, recovery);
        if (arguments.isSet("json")) {
            out() << QJsonDocument(recoveryJson(*loaded, map)).toJson();
        } else {
            print(*loaded, map);
        }
        out().flush();
        return map.isComplete ? kSuccess : kFailed;
    }
    if (arguments.isSet("json") || arguments.isSet("variables")) {
        for (const QString& name : loaded->script.declared) {
            options.variables.push_back(name.toStdString());
        }
    }
    const Preview preview =
        program::previewProgram(loaded->project, loaded->script, loaded->options, options);
    if (arguments.isSet("json")) {
        out() << QJsonDocument(toJson(*loaded, preview)).toJson();
    } else {
        print(*loaded, preview);
    }
    out().flush();
    return preview.isGood() ? kSuccess : kFailed;
}

}  // namespace

const Command& runProgramCommand() {
    static const Command kCommand{
        .name = "run",
        .operands = "FILE",
        .summary = "runs a program of a project, simulated or on a robot",
        .title = "runs a program of a project",
        .usage = {"FILE.tiller --simulate [options]", "FILE.tiller --robot ADDRESS [options]"},
        .options =
            {{"simulate", "", "runs the program in the simulated controller, faster than real time"},
             {"robot", "ADDRESS",
              "runs the program on a robot, after a simulated run from the current position of the arm"},
             {"program", "NAME", "name of the program; not needed if the project has only one program"},
             {"from", "STEP", "starts at the step with this number", "0", {0, 1e6}},
             {"input", "CHANNEL=on|off[@SECONDS]",
              "sets a digital input of the simulated run: DI0-DI7, CI0-CI7, TI0, TI1. Can be "
              "repeated"},
             {"set", "NAME=VALUE@STEP",
              "sets a variable each time the step with this number begins, before the step: a number, True "
              "or "
              "False. Can be repeated"},
             {"variables", "",
              "prints the variables: on a robot whenever they change, otherwise at the end of the run"},
             {"time-limit", "SECONDS", "stops the run after this time (default %1)", "3600", {0.001, 1e6}},
             {"port-offset", "N", "added to every port number of the robot (default %1)", "0", kPortOffsets},
             {"recoverability", "",
              "prints, for each step, whether the program can continue after a stop in the step, and which "
              "steps "
              "were not checked. Requires --simulate and cannot be combined with --from or --set"},
             {"json", "", "prints one JSON object instead of text"}},
        .notes =
            "A run on a robot moves the arm at the programmed speeds without asking for confirmation. Keep "
            "clear of the arm. Ctrl+C, the end of this command and a lost connection stop the run. The "
            "command takes control, which stops any other program, and then checks the program from the "
            "position of the arm. The run is refused if a simulated run of the first ten minutes finds a "
            "collision or a stop, or if the robot and the project have different robot models.\nExit code: 0 "
            "the program ended without findings, 1 the program failed or had findings, 2 invalid arguments.",
        .run = runProgram};
    return kCommand;
}

}  // namespace tiller::app
