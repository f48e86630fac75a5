// SPDX-License-Identifier: MIT
//
// The stop contract for programs of a project. In every kind of step, and for all events concerning the
// client, the connection or the robot, the arm stops in time and the program does not continue. In virtual
// time.
//
// Runs a part of the table, which is selected pseudo-randomly but reproducibly. With --all, runs everything.

#include <QSet>
#include <algorithm>
#include <atomic>
#include <thread>

#include "program_samples.h"
#include "robot/station/program/program_script.h"
#include "tests/integration/control/contract_cell.h"
#include "tests/support/waiting.h"

using namespace tiller;
using namespace tiller::control;
using namespace tiller::program;
using namespace tiller::test;
using std::chrono::milliseconds;

namespace {

bool runsAll = false;
constexpr quint32 kSeed = 20261127;
constexpr int kStartedOutput = 7;  ///< switched on directly before the tested steps

/// Steps during which an event occurs.
struct ProgramCase {
    const char* name;
    double fast;  ///< TCP speed at the event [m/s]; 0: directly after the beginning of the steps
    std::function<std::vector<project::ProgramStep>(project::Project&)> steps;
    std::int32_t permitted = script::StepGate::kUnlimited;  ///< number of steps that may begin
};

project::ProgramStep moveTo(const project::Project& project, const char* kind, const char* waypoint,
                            QJsonObject fields = {}) {
    fields.insert("waypoint", waypointId(project, waypoint));
    return step(kind, fields);
}

/// Appends moves back and forth to steps that do not move the arm. If the program continued after an event,
/// the arm would move.
std::vector<project::ProgramStep> thenMoves(const project::Project& project,
                                            std::vector<project::ProgramStep> steps) {
    steps.push_back(moveTo(project, "moveL", "pick"));
    steps.push_back(moveTo(project, "moveL", "place"));
    return steps;
}

std::vector<project::ProgramStep> moves(const project::Project& project) {
    return thenMoves(project, {});
}

QString callOf(project::Project& project) {
    const project::Program called = makeProgram("called", moves(project));
    project.programs.append(called);
    return idText(called.id);
}

const std::vector<ProgramCase>& programCases() {
    constexpr double kLinear = 0.05;  // [m/s]
    static const std::vector<ProgramCase> kCases{
        {"moveJ", kLinear,
         [](project::Project& p) {
             return std::vector{moveTo(p, "moveJ", "pick"), moveTo(p, "moveJ", "place")};
         }},
        {"moveL", kLinear, [](project::Project& p) { return moves(p); }},
        {"moveL with blends", kLinear,
         [](project::Project& p) {
             return std::vector{moveTo(p, "moveL", "pick", {{"blend", 0.02}}),
                                moveTo(p, "moveL", "home", {{"blend", 0.02}}),
                                moveTo(p, "moveL", "place", {{"blend", 0.02}})};
         }},
        {"moveP", kLinear,
         [](project::Project& p) {
             return std::vector{moveTo(p, "moveP", "pick", {{"blend", 0.01}}),
                                moveTo(p, "moveP", "place", {{"blend", 0.01}})};
         }},
        {"moveCircle", kLinear,
         [](project::Project& p) {
             return std::vector{
                 moveTo(p, "moveL", "place"),
                 step("moveCircle", {{"via", waypointId(p, "home")}, {"waypoint", waypointId(p, "pick")}})};
         }},
        {"moveGroup", 0.02,
         [](project::Project& p) {
             return std::vector{step("moveGroup", {{"group", "row"}}), moveTo(p, "moveL", "place")};
         }},
        {"moveRelative", kLinear,
         [](project::Project&) {
             return std::vector{step("moveRelative", {{"x", 0.1}}), step("moveRelative", {{"x", -0.1}})};
         }},
        {"moveUntil", 0.015,
         [](project::Project& p) {
             return std::vector{step("moveUntil", {{"until", "input"},
                                                   {"input", 3},
                                                   {"axes", "base"},
                                                   {"distance", 0.1},
                                                   {"otherwise", "continue"}}),
                                moveTo(p, "moveL", "home")};
         }},
        {"wait", 0,
         [](project::Project& p) {
             return thenMoves(p, {step("wait", {{"time", 0.3}})});
         }},
        {"waitInput", 0,
         [](project::Project& p) {
             return thenMoves(
                 p, {step("waitInput", {{"input", 2}, {"timeLimit", 0.3}, {"otherwise", "continue"}})});
         }},
        {"waitCondition", 0,
         [](project::Project& p) {
             return thenMoves(p,
                              {step("waitCondition",
                                    {{"condition", "DI2"}, {"timeLimit", 0.3}, {"otherwise", "continue"}})});
         }},
        {"outputs", 0,
         [](project::Project& p) {
             return thenMoves(
                 p, {step("setOutput", {{"output", 1}}), step("pulseOutput", {{"output", 2}, {"time", 0.2}}),
                     step("setAnalogOutput"), step("wait", {{"time", 0.1}})});
         }},
        {"gripper", 0,
         [](project::Project& p) {
             return thenMoves(p, {step("gripper", {{"action", "close"}, {"time", 0.3}})});
         }},
        {"loop", kLinear,
         [](project::Project& p) {
             return std::vector{step("loop", {{"times", 3}}, moves(p))};
         }},
        {"forEachWaypoint", 0.02,
         [](project::Project&) {
             return std::vector{
                 step("forEachWaypoint", {{"group", "row"}, {"variable", "at"}},
                      {step("moveL", {{"pose", "at"}, {"before", 0.05}}), step("moveL", {{"pose", "at"}})})};
         }},
        {"forEachPlace", 0.02,
         [](project::Project& p) {
             return std::vector{step(
                 "forEachPlace", {{"pattern", idText(p.patterns.at(0).id)}, {"variable", "slot"}},
                 {step("moveL", {{"pose", "slot"}, {"before", 0.05}}), step("moveL", {{"pose", "slot"}})})};
         }},
        {"if", kLinear,
         [](project::Project& p) {
             return std::vector{step("if", {{"condition", "not DI2"}}, moves(p))};
         }},
        {"while", kLinear,
         [](project::Project& p) {
             return std::vector{step("while", {{"condition", "not DI2"}}, moves(p))};
         }},
        {"if with branches", kLinear,
         [](project::Project& p) {
             return std::vector{step("if", {{"condition", "DI2"}}, {step("wait")}),
                                step("elseIf", {{"condition", "not DI2"}}, moves(p)),
                                step("else", {}, {step("wait")})};
         }},
        {"else", kLinear,
         [](project::Project& p) {
             return std::vector{step("if", {{"condition", "DI2"}}, {step("wait")}),
                                step("else", {}, moves(p))};
         }},
        {"leave loop", kLinear,
         [](project::Project& p) {
             return std::vector{step("loop", {{"times", 0}},
                                     thenMoves(p, {step("moveRelative", {{"x", 0.05}}), step("leaveLoop")})),
                                moveTo(p, "moveL", "pick"), moveTo(p, "moveL", "place")};
         }},
        {"end", kLinear,
         [](project::Project& p) {
             return thenMoves(p, {step("if", {{"condition", "DI2"}}, {step("end")})});
         }},
        {"default", kLinear,
         [](project::Project& p) {
             return std::vector{
                 step("switch", {{"value", "3"}},
                      {step("case", {{"value", "1"}}, {step("wait")}), step("default", {}, moves(p))})};
         }},
        {"switch", kLinear,
         [](project::Project& p) {
             return std::vector{
                 step("switch", {{"value", "2 - 1"}},
                      {step("case", {{"value", "1"}}, moves(p)), step("default", {}, {step("wait")})})};
         }},
        {"variables and notes", 0,
         [](project::Project& p) {
             return thenMoves(p, {step("assign", {{"variable", "count"}, {"type", "whole"}, {"value", "4"}}),
                                  step("setRegister", {{"value", "count"}}),
                                  step("log", {{"text", "count "}, {"value", "count"}}),
                                  step("folder", {}, {step("comment", {{"text", "no move"}})}),
                                  step("wait", {{"time", 0.1}})});
         }},
        {"message", 0,
         [](project::Project& p) {
             return thenMoves(p, {step("message", {{"text", "Check the part"}})});
         }},
        {"message without waiting", kLinear,
         [](project::Project& p) {
             return thenMoves(p, {step("message", {{"text", "Moving"}, {"waits", false}})});
         }},
        {"question", 0,
         [](project::Project& p) {
             return thenMoves(p, {step("question", {{"text", "How many?"}})});
         }},
        {"call", kLinear,
         [](project::Project& p) {
             return std::vector{step("call", {{"program", callOf(p)}})};
         }},
        {"try", kLinear,
         [](project::Project& p) {
             return std::vector{step("try", {}, moves(p)), step("onError", {}, {step("wait")})};
         }},
        {"on error", kLinear,
         [](project::Project& p) {
             return std::vector{step("try", {}, {step("fail")}), step("onError", {}, moves(p))};
         }},
        {"script", kLinear,
         [](project::Project& p) {
             return thenMoves(
                 p, {step("script",
                          {{"text",
                            "speedl([0.1, 0, 0, 0, 0, 0], 0.5, 0.8)\nspeedl([-0.1, 0, 0, 0, 0, 0], 0.5, "
                            "0.8)"}})});
         }},
        {"script with a thread", kLinear,
         [](project::Project& p) {
             return thenMoves(
                 p, {step("script", {{"text",
                                      "thread mover():\n  while True:\n    speedl([0.1, 0, 0, 0, 0, 0], 0.5, "
                                      "0.4)\n    speedl([-0.1, 0, 0, 0, 0, 0], 0.5, 0.4)\n  end\nend\n"
                                      "mine = run mover()\njoin mine"}})});
         }},
        {"force", 0.02,
         [](project::Project&) {
             return std::vector{
                 step("force", {{"axes", "base"}, {"force", 30}}, {step("wait", {{"time", 20}})})};
         }},
        {"moves in a force section", kLinear,
         [](project::Project& p) {
             return std::vector{step("force", {{"axes", "base"}, {"force", 5}}, moves(p))};
         }},
        {"tool", kLinear,
         [](project::Project& p) {
             return std::vector{
                 step("tool", {{"tool", idText(p.tooling.tools.at(0).id)}},
                      {step("moveRelative", {{"x", 0.1}}), step("moveRelative", {{"x", -0.1}})})};
         }},
        {"payload, frame and speed", kLinear,
         [](project::Project& p) {
             const QString payload = idText(p.tooling.payloads.at(0).id);
             const QString frame = idText(p.frames.at(0).id);
             return std::vector{
                 step("payload", {{"payload", payload}}),
                 step("frame", {{"frame", frame}}, {step("speed", {{"factor", 0.8}}, moves(p))})};
         }},
    };
    return kCases;
}

void collectKinds(const std::vector<project::ProgramStep>& steps, QSet<QString>& kinds) {
    for (const project::ProgramStep& each : steps) {
        kinds.insert(each.kind);
        collectKinds(each.steps, kinds);
    }
}

/// A program that switches kStartedOutput on and then repeats the steps, with a thread that watches an input.
project::Program programOf(const ProgramCase& tested, project::Project& project) {
    std::vector<project::ProgramStep> steps{moveTo(project, "moveJ", "home"),
                                            step("setOutput", {{"output", kStartedOutput}})};
    steps.push_back(step("watch", {{"condition", "DI5"}}, {step("setOutput", {{"output", 6}})}));
    steps.push_back(step("loop", {{"times", 0}}, tested.steps(project)));
    return makeProgram(tested.name, steps);
}

QString scriptOf(const ProgramCase& tested) {
    project::Project project = sampleProject();
    const project::Program program = programOf(tested, project);
    project.programs.append(program);
    const ProgramScript script = writeScript(project, program.id);
    for (const ProgramProblem& problem : script.problems) {
        qWarning("%s: step %d: %s", tested.name, problem.number, qPrintable(problem.text));
    }
    return script.gatedText();
}

/// A supervised script that runs in its own thread, as in an application.
class Run {
public:
    ~Run() {
        if (thread_.joinable()) {
            thread_.join();
        }
    }
    Error begin(ContractCell& cell, const QString& script, std::int32_t permitted) {
        thread_ = std::thread([this, &cell, script, permitted] {
            ScriptTerms terms;
            terms.holding = Holding::Held;
            terms.gate = script::StepGate{permitted, false};
            terms.starting = [this](const Motion& motion) {
                motion_ = motion;
                isStarted_ = true;
                return true;
            };
            outcome_ = Programs(*cell.controller).runScript(script, Deadline::never(), terms);
            isEnded_ = true;
        });
        while (!isStarted_ && !isEnded_) {
            cell.step();
        }
        cell.motion = motion_;
        const std::uint64_t started = 1U << kStartedOutput;
        // The thread that sends the program needs real time.
        const Deadline limit = testTimeout();
        while ((cell.robot.truth().digitalOutputs & started) == 0 && !isEnded_ && !limit.hasExpired()) {
            (void)motion_.refresh();
            cell.stepMs(1);
        }
        if ((cell.robot.truth().digitalOutputs & started) == 0) {
            return isEnded_ && !outcome_ ? outcome_.error()
                                         : Error{ErrorCode::Timeout, QStringLiteral("start the program"), {}};
        }
        return {};
    }
    bool isEnded() const { return isEnded_; }
    const Result<void>& outcome() const { return outcome_; }

private:
    std::thread thread_;
    std::atomic<bool> isStarted_ = false;
    std::atomic<bool> isEnded_ = false;
    Motion motion_;
    Result<void> outcome_;
};

const std::vector<ContractEvent>& events() {
    static const std::vector<ContractEvent> kAll = [] {
        std::vector<ContractEvent> all{
            {"button released", 250, [](ContractCell& c) { c.holding = false; }, {}}};
        // A program that was paused when its process was killed moves for up to 100 ms when it is resumed on
        // the teach pendant.
        std::copy_if(contractEvents().begin(), contractEvents().end(), std::back_inserter(all),
                     [](const ContractEvent& event) { return !event.losesBoth; });
        for (ContractEvent& event : all) {
            event.limitMs = 250;
        }
        return all;
    }();
    return kAll;
}

QString checkOnce(const ProgramCase& tested, const ContractEvent& event) {
    const QString script = scriptOf(tested);
    if (script.isEmpty()) {
        return QStringLiteral("%1: the program has problems").arg(QLatin1String(tested.name));
    }
    Run run;
    ContractCell cell({}, 1);
    const ContractMotion motion{
        .name = tested.name,
        .needs = nullptr,
        .byOperator = false,
        .isLong = true,
        .fast = tested.fast,
        .begin = [&](ContractCell& c) { return run.begin(c, script, tested.permitted); },
        .hold = [](ContractCell& c) { (void)c.motion.refresh(); },
    };
    const ContractOutcome outcome = cell.run(motion, event);
    const bool isAlone = !cell.reachable && cell.robot.truth().runtimeState == RuntimeState::Playing;
    cell.clock.freeze(false);
    cell.robot.stop();
    cell.controller->release();
    if (outcome.problem.isEmpty() && isAlone) {
        return QStringLiteral("%1 x %2: the program continues without its client")
            .arg(QLatin1String(tested.name), QLatin1String(event.name));
    }
    return outcome.problem.isEmpty()
               ? QString()
               : QStringLiteral("%1 x %2: %3")
                     .arg(QLatin1String(tested.name), QLatin1String(event.name), outcome.problem);
}

QString check(const ProgramCase& tested, const ContractEvent& event) {
    // While a program starts, virtual time can overtake the threads of a busy computer. In this case, the
    // event has not happened.
    constexpr int kStarts = 3;
    QString problem;
    for (int i = 0; i < kStarts; ++i) {
        problem = checkOnce(tested, event);
        if (!problem.contains(QLatin1String("not begun: LinkLost"))) {
            break;
        }
    }
    return problem;
}

}  // namespace

class TestProgramContract : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void everyStepKindIsTested() {
        QSet<QString> missing;
        for (const StepKind* kind : stepKinds()) {
            missing.insert(QLatin1String(kind->id));
        }
        for (const ProgramCase& tested : programCases()) {
            project::Project project = sampleProject();
            QSet<QString> kinds;
            collectKinds(programOf(tested, project).steps, kinds);
            missing -= kinds;
        }
        QVERIFY2(missing.isEmpty(), qPrintable(QStringList(missing.values()).join(", ")));
    }

    // Every kind of step. In a partial run, each kind is combined with a different event.
    void everyStepEndsInTime_data() {
        QTest::addColumn<int>("tested");
        for (std::size_t i = 0; i < programCases().size(); ++i) {
            QTest::newRow(programCases()[i].name) << static_cast<int>(i);
        }
    }
    void everyStepEndsInTime() {
        QFETCH(int, tested);
        QStringList problems;
        const std::size_t count = events().size();
        const std::size_t first =
            QRandomGenerator(kSeed).bounded(static_cast<quint32>(count)) + static_cast<std::size_t>(tested);
        for (std::size_t i = 0; i < (runsAll ? count : 1); ++i) {
            const QString problem =
                check(programCases()[static_cast<std::size_t>(tested)], events()[(first + i) % count]);
            if (!problem.isEmpty()) {
                problems << problem;
            }
        }
        QVERIFY2(problems.isEmpty(), qPrintable(problems.join(QLatin1Char('\n'))));
    }

    // Every event while the program waits before a move. Opening the gate afterwards has no effect.
    void everyEventEndsAWaitingProgram_data() { everyEventStopsALinearMove_data(); }
    void everyEventEndsAWaitingProgram() {
        QFETCH(int, event);
        ProgramCase waiting{"waiting", 0, [](project::Project& p) { return moves(p); }};
        waiting.permitted = 4;  // to home, output, watch, loop
        ContractEvent late = events()[static_cast<std::size_t>(event)];
        late.after.emplace_back([](ContractCell& c) { (void)c.motion.setGate({}); });
        const QString problem = check(waiting, late);
        QVERIFY2(problem.isEmpty(), qPrintable(problem));
    }

    // Tests every event during a linear move.
    void everyEventStopsALinearMove_data() {
        QTest::addColumn<int>("event");
        for (std::size_t i = 0; i < events().size(); ++i) {
            QTest::newRow(events()[i].name) << static_cast<int>(i);
        }
    }
    void everyEventStopsALinearMove() {
        QFETCH(int, event);
        const QString problem = check(programCases()[1], events()[static_cast<std::size_t>(event)]);
        QVERIFY2(problem.isEmpty(), qPrintable(problem));
    }
};

int main(int argc, char** argv) {
    QCoreApplication app(argc, argv);
    QStringList arguments = QCoreApplication::arguments();
    runsAll = arguments.removeAll(QStringLiteral("--all")) > 0;
    TestProgramContract test;
    return QTest::qExec(&test, arguments);
}

#include "tst_program_contract.moc"
