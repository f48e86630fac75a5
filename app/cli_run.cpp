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

QJsonArray listOf(const std::array<double, 6>& values) {
    QJsonArray list;
    for (const double value : values) {
        list.append(value);
    }
    return list;
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

QJsonObject toJson(const LoadedProgram& loaded, const Preview& preview) {
    QJsonArray steps;
    for (std::size_t i = 0; i < preview.timings.size(); ++i) {
        const program::StepTiming& timing = preview.timings[i];
        steps.append(QJsonObject{{"number", static_cast<int>(i) + 1},
                                 {"name", stepName(loaded, static_cast<int>(i) + 1)},
                                 {"count", timing.count},
                                 {"first", timing.first},
                                 {"total", timing.total}});
    }
    return {{"simulated", true},
            {"completed", preview.completed},
            {"duration", preview.duration},
            {"findings", findingsJson(loaded, preview.findings)},
            {"steps", steps},
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
    return {{"simulated", true}, {"completed", map.isComplete}, {"steps", steps}, {"points", points}};
}

void print(const LoadedProgram& loaded, const program::RecoveryMap& map) {
    const program::RecoveryCount count = program::countRecoverable(map);
    out() << QStringLiteral("simulated: the program can continue after a stop in %1 of %2 steps\n")
                 .arg(count.recoverable)
                 .arg(count.steps);
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

int runOnRobot(LoadedProgram loaded, const QString& address, int portOffset, program::PreviewOptions given) {
    receive::ReceiverOptions receiverOptions;
    receiverOptions.host = address;
    receiverOptions.port = static_cast<std::uint16_t>(rtde::kPort + portOffset);
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
    controllerOptions.host = address;
    controllerOptions.portOffset = portOffset;
    // The robot itself stops after 100 ms without a heartbeat. A shorter pause of this PC, which the robot
    // does not detect, must not end the run.
    controllerOptions.dataTimeout = 2s;
    controllerOptions.connectionTimeout = 2s;
    control::Controller controller(controllerOptions);
    if (const auto taken = controller.takeControl(Deadline::after(5s)); !taken) {
        return complain(taken.error().toString(), kFailed);
    }
    // The arm may still be braking if a program of another client was running. Wait for standstill, so that the
    // arm is still at the position of this sample when the program starts.
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
    program::ProgramExecution execution(controller, receiver.subscribe(), checked, {}, stops);
    const Deadline limit = Deadline::after(std::chrono::duration<double>(given.timeLimit));
    bool isLate = false;
    int shown = 0;
    program::ProgramExecution::Status now;
    while (execution.isActive()) {
        if (waitForTermination(10ms) || (!isLate && limit.hasExpired())) {
            isLate = limit.hasExpired();
            execution.stop();
        }
        now = execution.status();
        if (now.step != shown && now.step > 0) {
            out() << QStringLiteral("step %1 (%2)\n").arg(now.step).arg(stepName(loaded, now.step));
            out().flush();
        }
        shown = now.step;
    }
    now = execution.status();
    if (now.state == program::ProgramExecution::State::Completed) {
        return kSuccess;
    }
    if (now.state == program::ProgramExecution::State::Failed) {
        return complain(problemText(loaded, now.failedStep, QStringLiteral("the step failed")), kFailed);
    }
    const Error error = execution.wait(Deadline::never()).error();
    return complain(problemText(loaded, now.lastStep,
                                isLate ? QStringLiteral("the time limit set with --time-limit expired")
                                       : error.toString()),
                    kFailed);
}

int runProgram(const CommandArguments& arguments) {
    if (arguments.operands().size() != 1) {
        return wrongArguments(QStringLiteral("run: one project file is required"));
    }
    if (arguments.isSet("simulate") == arguments.isSet("robot")) {
        return wrongArguments(QStringLiteral("run: either --simulate or --robot ADDRESS is required"));
    }
    if (arguments.isSet("recoverability") && (arguments.isSet("robot") || arguments.isSet("from"))) {
        return wrongArguments(
            QStringLiteral("--recoverability requires --simulate and cannot be combined with --from"));
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
    auto loaded = loadProgram(arguments.operands().constFirst(), arguments.value("program"),
                              static_cast<int>(arguments.number("from")));
    if (!loaded) {
        return complain(loaded.error().toString(), kFailed);
    }
    if (!loaded->script.ok()) {
        return refuse(*loaded, arguments.isSet("json"));
    }
    holdTerminationSignals();
    if (arguments.isSet("robot")) {
        return runOnRobot(std::move(*loaded), arguments.value("robot"),
                          static_cast<int>(arguments.number("port-offset")), options);
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
             {"time-limit", "SECONDS", "stops the run after this time (default %1)", "3600", {0.001, 1e6}},
             {"port-offset", "N", "added to every port number of the robot (default %1)", "0", kPortOffsets},
             {"recoverability", "",
              "prints, for each step, whether the program can continue after a stop in the step. Requires "
              "--simulate and cannot be combined with --from"},
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
