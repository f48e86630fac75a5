// SPDX-License-Identifier: MIT
//
// Programs as URScript: every kind of step compiles, and errors are reported at the step that caused them.

#include <QRegularExpression>
#include <QTest>

#include "program_samples.h"
#include "robot/simulator/urscript/program.h"
#include "robot/station/program/program_script.h"

using namespace tiller;
using namespace tiller::program;

namespace {

ProgramScript scriptOf(project::Project project, const project::Program& program,
                       const ScriptOptions& options = {}) {
    project.programs.append(program);
    return writeScript(project, program.id, options);
}

QString describe(const ProgramScript& script) {
    QStringList lines;
    for (const ProgramProblem& problem : script.problems) {
        lines.append(QStringLiteral("step %1 %2: %3").arg(problem.number).arg(problem.field, problem.text));
    }
    return lines.join('\n') + '\n' + script.text;
}

QString compileError(const QString& text) {
    const auto compiled = simulator::urscript::compile(text.toStdString());
    return compiled ? QString()
                    : QStringLiteral("line %1: %2")
                          .arg(compiled.error.line)
                          .arg(QString::fromStdString(compiled.error.text));
}

}  // namespace

class TestProgramScript : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void pickAndPlaceCompiles() {
        const project::Project project = sampleProject();
        const ProgramScript script = scriptOf(project, trayProgram(project));
        QVERIFY2(script.ok(), qPrintable(describe(script)));
        QVERIFY2(script.problems.empty(), qPrintable(describe(script)));
        QVERIFY2(compileError(script.text).isEmpty(),
                 qPrintable(compileError(script.text) + '\n' + script.text));
        QCOMPARE(script.name, QString("program_fill_the_tray"));
    }

    void speedLimitsApplyToEveryMove() {
        const project::Project project = sampleProject();
        const QString pick = waypointId(project, "pick");
        const QString place = waypointId(project, "place");
        ScriptOptions options;
        options.limits = {.tool = 0.02, .joint = 0.1};
        const ProgramScript script = scriptOf(
            project,
            makeProgram("slow", {step("moveJ", {{"waypoint", pick}, {"speed", 1}}),
                                 step("moveL", {{"waypoint", place}, {"speed", 0.01}}),
                                 step("moveP", {{"waypoint", pick}, {"speed", 0.5}}),
                                 step("moveCircle", {{"via", place}, {"waypoint", pick}, {"speed", 0.5}}),
                                 step("moveRelative", {{"x", 0.1}, {"speed", 0.5}}),
                                 step("speed", {{"factor", 0.5}},
                                      {step("moveL", {{"waypoint", pick}, {"speed", 0.03}})})}),
            options);
        QVERIFY2(script.ok(), qPrintable(describe(script)));
        QStringList speeds;
        static const QRegularExpression kSpeed(QStringLiteral(", v=([0-9.]+)"));
        for (auto match = kSpeed.globalMatch(script.text); match.hasNext();) {
            speeds.append(match.next().captured(1));
        }
        QCOMPARE(speeds, (QStringList{"0.1", "0.01", "0.02", "0.02", "0.02", "0.015"}));
    }

    // A step of each kind at a permitted position, with all elements that it refers to.
    void everyKindCompiles_data() {
        QTest::addColumn<QString>("kind");
        for (const StepKind* kind : stepKinds()) {
            QTest::newRow(kind->id) << QString::fromLatin1(kind->id);
        }
    }
    void everyKindCompiles() {
        QFETCH(QString, kind);
        project::Project project = sampleProject();
        project::Program called = makeProgram("helper", {step("wait")});
        project.programs.append(called);
        const QHash<QString, QJsonObject> values{
            {"moveJ", {{"waypoint", waypointId(project, "pick")}, {"speed", 0.5}, {"blend", 0.01}}},
            {"moveL", {{"pose", "get_actual_tcp_pose()"}, {"before", 0.02}}},
            {"moveP", {{"waypoint", waypointId(project, "pick")}, {"acceleration", 0.3}}},
            {"moveCircle",
             {{"via", waypointId(project, "row 2")}, {"waypoint", waypointId(project, "row 3")}}},
            {"moveGroup", {{"group", "row"}}},
            {"moveRelative", {{"z", 0.01}, {"axes", "frame"}}},
            {"moveUntil", {{"until", "input"}, {"input", 3}}},
            {"setRegister", {{"value", "2 + 3"}}},
            {"waitInput", {{"timeLimit", 2}}},
            {"waitCondition", {{"condition", "AI0 > 2"}, {"timeLimit", 2}}},
            {"gripper", {{"openOutput", 17}, {"input", 1}}},
            {"tool", {{"tool", idText(project.tooling.tools.at(0).id)}}},
            {"payload", {{"payload", idText(project.tooling.payloads.at(0).id)}}},
            {"frame", {{"frame", idText(project.frames.at(0).id)}}},
            {"loop", {{"variable", "pass"}}},
            {"while", {{"condition", "DI0"}}},
            {"forEachWaypoint", {{"group", "row"}}},
            {"forEachPlace", {{"pattern", idText(project.patterns.at(0).id)}}},
            {"if", {{"condition", "DI0"}}},
            {"elseIf", {{"condition", "DI1"}}},
            {"switch", {{"value", "1 + 1"}}},
            {"case", {{"value", "2"}}},
            {"call", {{"program", idText(called.id)}}},
            {"watch", {{"condition", "DI7"}}},
            {"assign", {{"variable", "x"}, {"value", "1.5"}}},
            {"message", {{"text", "Check the feeder"}, {"level", "warning"}}},
            {"question", {{"text", "How many?"}}},
            {"log", {{"text", "here"}, {"value", "1"}}},
            {"script", {{"text", "if get_standard_digital_in(0):\n  sync()\nend"}}},
            {"comment", {{"text", "a remark\nof two lines"}}},
            {"folder", {{"name", "a folder"}}}};
        const StepKind* row = findStepKind(kind);
        const project::ProgramStep wait = step("wait", {{"time", 0.1}});
        project::ProgramStep tried = step(row->id, values.value(kind));
        if (row->isSection && kind != "switch") {
            tried.steps = {wait};
        }
        if (kind == "switch") {
            tried.steps = {step("case", {{"value", "1"}}, {wait}), step("default", {}, {wait})};
        }
        std::vector<project::ProgramStep> steps{tried};
        if (kind == "elseIf" || kind == "else") {
            steps = {step("if", values["if"], {wait}), tried};
        } else if (kind == "case") {
            steps = {step("switch", values["switch"], {tried})};
        } else if (kind == "default") {
            steps = {step("switch", values["switch"], {step("case", values["case"], {wait}), tried})};
        } else if (kind == "try") {
            steps = {tried, step("onError", {}, {wait})};
        } else if (kind == "onError") {
            steps = {step("try", {}, {wait, step("fail")}), tried};
        } else if (kind == "leaveLoop") {
            steps = {step("loop", {}, {wait, tried})};
        }
        steps.push_back(wait);
        const ProgramScript script = scriptOf(project, makeProgram("one of each", steps));
        QVERIFY2(script.ok() && script.problems.empty(), qPrintable(describe(script)));
        QVERIFY2(compileError(script.text).isEmpty(),
                 qPrintable(compileError(script.text) + '\n' + script.text));
        // With a step gate, the script has the same lines, plus the calls to the gate.
        const QStringList lines = script.text.split('\n');
        const QStringList gated = script.gatedText().split('\n');
        QCOMPARE(gated.size(), lines.size());
        QVERIFY(!script.text.contains("tiller_step(") && !script.text.contains("tiller_turn("));
        for (qsizetype i = 0; i < lines.size(); ++i) {
            QVERIFY2(gated[i] == lines[i] || gated[i].contains("tiller_step("), qPrintable(gated[i]));
        }
        QVERIFY(gated != lines);
        QVERIFY(!row->name().isEmpty());
        QVERIFY(!groupName(row->group).isEmpty());
    }

    // A program does not pause in a force section, where the arm is not at standstill between the steps, or
    // in parallel steps, which must not wait.
    void forceSectionsAndParallelStepsDoNotPause() {
        project::Project project = sampleProject();
        const project::Program called = makeProgram("called", {step("wait")});
        project.programs.append(called);
        const auto call = [&] { return step("call", {{"program", idText(called.id)}}); };
        const ProgramScript script = scriptOf(
            project, makeProgram("sections", {step("force", {}, {step("wait"), call()}),
                                              step("watch", {{"condition", "DI1"}}, {call()}), call()}));
        QVERIFY2(script.ok(), qPrintable(describe(script)));
        QList<int> numbers;
        static const QRegularExpression kCall(QStringLiteral("tiller_step\\((\\d+)\\)"));
        for (auto match = kCall.globalMatch(script.gatedText()); match.hasNext();) {
            numbers.append(match.next().captured(1).toInt());
        }
        std::sort(numbers.begin(), numbers.end());
        // The force section, the watch, the last call, and the step of the called program.
        QCOMPARE(numbers, (QList<int>{1, 4, 6, 7}));
    }

    void linesBelongToTheirSteps() {
        const project::Project project = sampleProject();
        const project::Program tray = trayProgram(project);
        const ProgramScript script = scriptOf(project, tray);
        const QStringList lines = script.text.split('\n');
        QCOMPARE(static_cast<qsizetype>(script.stepOfLine.size()), lines.size() - 1);
        int marks = 0;
        for (qsizetype i = 0; i < lines.size(); ++i) {
            if (lines[i].contains("write_output_integer_register(47, ") && !lines[i].contains("(47, 0)") &&
                !lines[i].contains("-step")) {
                const int number = lines[i].section("(47, ", 1).section(')', 0, 0).toInt();
                QCOMPARE(script.stepAt(static_cast<int>(i) + 1), number);
                ++marks;
            }
        }
        QCOMPARE(static_cast<std::size_t>(marks), script.steps.size());
        QCOMPARE(script.numberOf(tray.steps[3].id), 4);
        QCOMPARE(script.numberOf(tray.steps[3].steps[0].steps[0].id), 6);
        QCOMPARE(script.numberOf(QUuid::createUuid()), 0);
        QCOMPARE(script.stepAt(0), 0);
        QCOMPARE(script.stepAt(100'000), 0);
    }

    void disabledStepsAreLeftOut() {
        project::Project project = sampleProject();
        project::ProgramStep unknown = step("kind of the future");
        unknown.disabled = true;
        project::ProgramStep branch = step("else", {}, {step("wait")});
        branch.disabled = true;
        const ProgramScript script = scriptOf(
            project, makeProgram("p", {unknown, step("if", {{"condition", "DI0"}}, {step("wait")}), branch}));
        QVERIFY2(script.ok(), qPrintable(describe(script)));
        QVERIFY(!script.text.contains("else:"));
        QVERIFY2(compileError(script.text).isEmpty(), qPrintable(script.text));
    }

    void problemsAreReportedAtTheirStep_data() {
        QTest::addColumn<QString>("kind");
        QTest::addColumn<QJsonObject>("fields");
        QTest::addColumn<QString>("field");
        const auto row = [](const char* name, const char* kind, const QJsonObject& fields,
                            const char* field) {
            QTest::newRow(name) << QString::fromLatin1(kind) << fields << QString::fromLatin1(field);
        };
        row("unknown kind", "kind of the future", {}, "");
        row("no target", "moveJ", {}, "waypoint");
        row("both targets", "moveJ", {{"waypoint", "home"}, {"pose", "place"}}, "waypoint");
        row("unknown waypoint", "moveL", {{"waypoint", idText(QUuid::createUuid())}}, "waypoint");
        row("not an id", "moveL", {{"waypoint", 5}}, "waypoint");
        row("unreachable", "moveL", {{"waypoint", "far"}}, "waypoint");
        row("unreachable before", "moveL", {{"waypoint", "home"}, {"before", -1.0}}, "waypoint");
        row("other tool", "moveL", {{"waypoint", "other tool"}}, "waypoint");
        row("moves the gripper", "moveL", {{"waypoint", "acts"}}, "actions");
        row("too fast", "moveJ", {{"waypoint", "home"}, {"speed", 100}}, "speed");
        row("speed is a text", "moveJ", {{"waypoint", "home"}, {"speed", "fast"}}, "speed");
        row("unknown group", "moveGroup", {{"group", "nowhere"}}, "group");
        row("no distance", "moveRelative", {}, "z");
        row("no input", "moveUntil", {{"until", "input"}}, "input");
        row("terminal", "setOutput", {{"output", 18}}, "output");
        row("half a terminal", "setOutput", {{"output", 0.5}}, "output");
        row("flag", "setOutput", {{"value", 1}}, "value");
        row("choice", "gripper", {{"action", "drop"}}, "action");
        row("same output", "gripper", {{"openOutput", 16}}, "openOutput");
        row("register of the step", "setRegister", {{"register", 47}, {"value", "1"}}, "register");
        row("statement", "waitCondition", {{"condition", "1) halt"}}, "condition");
        row("empty expression", "waitCondition", {}, "condition");
        row("no time", "wait", {{"time", 0}}, "time");
        row("endless", "loop", {{"times", 0}}, "");
        row("endless while", "while", {{"condition", "True"}}, "");
        row("variable", "assign", {{"variable", "2x"}, {"value", "1"}}, "variable");
        row("reserved variable", "assign", {{"variable", "tiller_x"}, {"value", "1"}}, "variable");
        row("type", "assign", {{"variable", "known"}, {"type", "text"}, {"value", "\"a\""}}, "variable");
        row("leave no loop", "leaveLoop", {}, "");
        row("else", "else", {}, "");
        row("case", "case", {{"value", "1"}}, "");
        row("on error", "onError", {}, "");
        row("try alone", "try", {}, "");
        row("empty switch", "switch", {{"value", "1"}}, "");
        row("calls itself", "call", {{"program", "self"}}, "program");
        row("values", "call", {{"program", "helper"}, {"arguments", "1, (2, 3), 4"}}, "arguments");
        row("reserved name", "script", {{"text", "tiller_x = 1"}}, "text");
        row("open block", "script", {{"text", "while True:\n  sync()"}}, "text");
        row("leaves the program", "script", {{"text", "end\nmovej([0, 0, 0, 0, 0, 0])\ndef x():"}}, "text");
    }
    void problemsAreReportedAtTheirStep() {
        QFETCH(QString, kind);
        QFETCH(QJsonObject, fields);
        QFETCH(QString, field);
        project::Project project = sampleProject();
        project::Waypoint far = waypointAt("far", {0, 0, 0});
        far.pose.position.x() += 5;
        project::Waypoint other = waypointAt("other tool", {0, 0, 0});
        other.tcpOffset = Pose(0, 0, 0.2, 0, 0, 0);
        project::Waypoint acts = waypointAt("acts", {0, 0, 0});
        acts.actions = {
            {project::WaypointAction::Kind::CloseGripper, project::IoGroup::Standard, 0, true, 0, {}}};
        for (const project::Waypoint& point : {far, other, acts}) {
            project.waypoints.append(point);
        }
        project::Program helper = makeProgram("helper", {step("wait")});
        helper.parameters = {"a", "b"};
        project.programs.append(helper);
        project::Program wrong = makeProgram("wrong", {});
        for (const char* key : {"waypoint"}) {
            if (const int named = project.waypoints.indexOfName(fields[key].toString()); named >= 0) {
                fields[key] = idText(project.waypoints.at(named).id);
            }
        }
        if (fields["program"] == "self" || fields["program"] == "helper") {
            fields["program"] = idText(fields["program"] == "self" ? wrong.id : helper.id);
        }
        wrong.steps = {step("moveJ", {{"waypoint", waypointId(project, "home")}}),
                       step("assign", {{"variable", "known"}, {"type", "whole"}, {"value", "1"}}),
                       step("folder", {}, {step(kind.toLatin1(), fields)})};
        const ProgramScript script = scriptOf(project, wrong);
        QVERIFY2(!script.ok(), qPrintable(script.text));
        QCOMPARE(script.problems.size(), std::size_t(1));
        QCOMPARE(script.problems[0].field, field);
        QCOMPARE(script.problems[0].step, wrong.steps[2].steps[0].id);
        QCOMPARE(script.problems[0].number, 4);
        QVERIFY(!script.problems[0].text.isEmpty());
    }

    void parallelStepsDoNotMove() {
        const project::Project project = sampleProject();
        const ProgramScript script = scriptOf(
            project, makeProgram("p", {step("watch", {{"condition", "DI0"}},
                                            {step("moveJ", {{"waypoint", waypointId(project, "home")}})}),
                                       step("wait")}));
        QVERIFY(!script.ok());
        QCOMPARE(script.problems[0].number, 2);
    }

    void blendsFitBetweenTheWaypoints() {
        const project::Project project = sampleProject();
        const QString pick = waypointId(project, "pick");
        const QString place = waypointId(project, "place");
        const auto blending = [&](double first, double second) {
            return scriptOf(project,
                            makeProgram("p", {step("moveL", {{"waypoint", pick}, {"blend", first}}),
                                              step("moveL", {{"waypoint", place}, {"blend", second}})}));
        };
        QVERIFY2(blending(0.09, 0.09).ok(), qPrintable(describe(blending(0.09, 0.09))));
        QVERIFY(!blending(0.15, 0.1).ok());
        QCOMPARE(blending(0.15, 0.1).problems[0].field, QString("blend"));
        QCOMPARE(blending(0.15, 0.1).problems[0].number, 2);
        QVERIFY(blending(0, 0.15).ok());
    }

    void sectionsSetAndRestore() {
        const project::Project project = sampleProject();
        const QString home = waypointId(project, "home");
        const ProgramScript script = scriptOf(
            project, makeProgram("p", {step("speed", {{"factor", 0.5}},
                                            {step("moveL", {{"waypoint", home}, {"speed", 0.2}})}),
                                       step("moveL", {{"waypoint", home}, {"speed", 0.2}}),
                                       step("tool", {{"tool", idText(project.tooling.tools.at(0).id)}},
                                            {step("moveL", {{"waypoint", home}})})}));
        QVERIFY2(script.ok(), qPrintable(describe(script)));
        QVERIFY(script.text.contains("v=0.1, "));
        QVERIFY(script.text.contains("v=0.2, "));
        QVERIFY(script.text.indexOf("set_tcp(p[0, 0, 0.1, 0, 0, 0])") <
                script.text.indexOf("set_tcp(tiller_tcp_4)"));
    }

    void startsAtAStepOfTheTopLevel() {
        const project::Project project = sampleProject();
        const project::Program tray = trayProgram(project);
        ScriptOptions options;
        options.from = tray.steps[5].id;
        const ProgramScript script = scriptOf(project, tray, options);
        QVERIFY2(script.ok(), qPrintable(describe(script)));
        QVERIFY(script.text.contains("register(47, 18)"));
        QVERIFY(!script.text.contains("register(47, 1)"));
        options.from = tray.steps[4].id;  // On error belongs to Try
        QVERIFY(!scriptOf(project, tray, options).ok());
        options.from = tray.steps[3].steps[0].id;  // inside Try
        QVERIFY(!scriptOf(project, tray, options).ok());
    }

    void aStartStepMustNotNeedSkippedSteps_data() {
        using Steps = std::vector<project::ProgramStep>;
        QTest::addColumn<Steps>("skipped");
        QTest::addColumn<Steps>("rest");
        QTest::addColumn<QStringList>("words");  ///< words in the reason; empty if the program can start
        const auto assign = [](const char* value) {
            return step("assign", {{"variable", "count"}, {"type", "whole"}, {"value", value}});
        };
        const auto use = [] { return step("waitCondition", {{"condition", "count > 0"}}); };
        const auto row = [](const char* name, const Steps& skipped, const Steps& rest,
                            const QStringList& words) { QTest::newRow(name) << skipped << rest << words; };
        row("nothing", {step("wait")}, {step("wait")}, {});
        row("variable", {step("wait"), assign("1")}, {use()}, {"count", "step 2", "Set variable"});
        row("variable in a section", {step("loop", {}, {assign("1")})}, {use()}, {"count", "step 2"});
        row("unused variable", {assign("1")}, {step("wait")}, {});
        row("name in a text", {assign("1")}, {step("message", {{"text", "count"}})}, {});
        row("variable that is set again", {assign("1")}, {assign("2"), use()}, {});
        row("variable that changes", {assign("1")}, {assign("count + 1"), use()}, {"count", "step 1"});
        row("variable that is set in a section", {assign("1")},
            {step("if", {{"condition", "DI1"}}, {assign("2")}), use()}, {"count", "step 1"});
        row("counter", {step("loop", {{"variable", "count"}}, {step("wait")})}, {use()}, {"count", "step 1"});
        row("answer", {step("question", {{"text", "?"}, {"variable", "count"}})}, {use()},
            {"count", "step 1"});
        project::ProgramStep disabled = assign("1");
        disabled.disabled = true;
        row("disabled", {disabled}, {assign("2"), use()}, {});
        row("payload", {step("payload")}, {step("wait")}, {"step 1", "Set payload"});
        row("payload that is set again", {step("payload")}, {step("payload")}, {});
        row("watch", {step("watch", {{"condition", "DI1"}}, {step("wait")})}, {step("wait")}, {"step 1"});
    }
    void aStartStepMustNotNeedSkippedSteps() {
        QFETCH(std::vector<project::ProgramStep>, skipped);
        QFETCH(std::vector<project::ProgramStep>, rest);
        QFETCH(QStringList, words);
        const project::Project project = sampleProject();
        std::vector<project::ProgramStep> steps = skipped;
        steps.insert(steps.end(), rest.begin(), rest.end());
        for (project::ProgramStep& each : steps) {
            if (each.kind == "payload") {
                each.fields["payload"] = idText(project.tooling.payloads.at(0).id);
            }
        }
        ScriptOptions options;
        options.from = rest.front().id;
        const ProgramScript script = scriptOf(project, makeProgram("from", steps), options);
        QVERIFY2(script.ok() == words.isEmpty(), qPrintable(describe(script)));
        for (const QString& word : words) {
            QVERIFY2(script.problems.front().text.contains(word), qPrintable(describe(script)));
        }
        if (script.ok()) {
            QVERIFY2(compileError(script.text).isEmpty(), qPrintable(compileError(script.text)));
        }
    }

    void aCalledProgramCanSetAVariableForLaterSteps() {
        project::Project project = sampleProject();
        const project::Program called = makeProgram(
            "called", {step("assign", {{"variable", "count"}, {"type", "whole"}, {"value", "1"}})});
        project.programs.append(called);
        const project::Program program =
            makeProgram("from", {step("call", {{"program", idText(called.id)}}),
                                 step("waitCondition", {{"condition", "count > 0"}})});
        ScriptOptions options;
        options.from = program.steps[1].id;
        const ProgramScript script = scriptOf(project, program, options);
        QVERIFY(!script.ok());
        QVERIFY2(script.problems.front().text.contains("count"), qPrintable(describe(script)));
    }

    void otherRobotModelIsRefused() {
        const project::Project project = sampleProject();
        ScriptOptions options;
        options.model = RobotModelId::UR10e;
        const ProgramScript script = scriptOf(project, trayProgram(project), options);
        QVERIFY(!script.ok());
        QVERIFY(script.problems[0].text.contains("UR5e"));
    }

    // A called program is written once for each speed, so its steps have several marks.
    void assignmentsFollowEachMarkOfTheirStep() {
        project::Project project = sampleProject();
        const project::Program called = makeProgram("called", {step("setOutput"), step("wait")});
        project.programs.append(called);
        const auto call = [&] { return step("call", {{"program", idText(called.id)}}); };
        const project::Program program =
            makeProgram("main", {step("assign", {{"variable", "n"}, {"type", "number"}, {"value", "0.5"}}),
                                 step("assign", {{"variable", "go"}, {"type", "flag"}, {"value", "False"}}),
                                 call(), step("speed", {{"factor", 0.5}}, {call()}), step("wait")});
        const ProgramScript plain = scriptOf(project, program);
        QVERIFY2(plain.ok(), qPrintable(describe(plain)));
        ScriptOptions options;
        const QUuid at = called.steps.at(1).id;
        options.assignments = {{at, "n", "3"}, {at, "go", "true"}, {program.steps.at(4).id, "n", "-2,5"}};
        const ProgramScript script = scriptOf(project, program, options);
        QVERIFY2(script.ok(), qPrintable(describe(script)));
        QVERIFY2(compileError(script.text).isEmpty(),
                 qPrintable(compileError(script.text) + '\n' + script.text));
        const QStringList lines = script.text.split('\n');
        QStringList rest;
        QStringList inserted;
        for (qsizetype i = 0; i < lines.size(); ++i) {
            if (lines.at(i).trimmed() == "global n = 3.0" || lines.at(i).trimmed() == "global go = True" ||
                lines.at(i).trimmed() == "global n = -2.5") {
                inserted << QStringLiteral("%1 %2")
                                .arg(script.stepAt(static_cast<int>(i) + 1))
                                .arg(lines.at(i).trimmed());
            } else {
                rest << lines.at(i);
            }
        }
        QCOMPARE(rest.join('\n'), plain.text);
        const QString number = QString::number(script.numberOf(at));
        QCOMPARE(inserted, (QStringList{number + " global n = 3.0", number + " global go = True",
                                        number + " global n = 3.0", number + " global go = True",
                                        "6 global n = -2.5"}));
        QCOMPARE(script.stepOfLine.size() + 1, static_cast<std::size_t>(lines.size()));
        for (const ProgramScript::GateLine& gate : script.gateLines) {
            const QString& line = lines.at(static_cast<qsizetype>(gate.line));
            QVERIFY2(gate.step == 0 || line.contains("write_output_integer_register"), qPrintable(line));
        }
    }

    void functionNamesMayBeUsedAsNames() {
        const project::Project project = sampleProject();
        for (const char* name : {"if", "movej", "sync", "end", "7", "Käfig"}) {
            const ProgramScript script =
                scriptOf(project, makeProgram(QString::fromUtf8(name), {step("wait")}));
            QVERIFY2(script.ok() && compileError(script.text).isEmpty(), qPrintable(script.text));
        }
    }

    void missingAndEmptyProgramsAreRefused() {
        const project::Project project = sampleProject();
        QVERIFY(!writeScript(project, QUuid::createUuid()).ok());
        QVERIFY(!writeScript(project, QUuid::createUuid()).problems.empty());
        QVERIFY(!scriptOf(project, makeProgram("empty", {})).ok());
        project::Program parameters = makeProgram("p", {step("wait")});
        parameters.parameters = {"a"};
        QVERIFY(!scriptOf(project, parameters).ok());
    }
};

QTEST_APPLESS_MAIN(TestProgramScript)
#include "tst_program_script.moc"
