// SPDX-License-Identifier: MIT
//
// Programs that run in the simulated controller, in virtual time.

#include <QElapsedTimer>
#include <QTest>

#include "program_samples.h"
#include "robot/station/program/preview/preview.h"

using namespace tiller;
using namespace tiller::program;

namespace {

struct Ran {
    ProgramScript script;
    Preview preview;
};

Ran run(project::Project project, const project::Program& program, const PreviewOptions& options = {}) {
    project.programs.append(program);
    Ran ran;
    ran.script = writeScript(project, program.id);
    if (ran.script.ok()) {
        ran.preview = previewProgram(project, ran.script, {}, options);
    }
    return ran;
}

QByteArray describe(const Ran& ran) {
    QStringList lines;
    for (const ProgramProblem& problem : ran.script.problems) {
        lines << QStringLiteral("problem at %1 %2: %3").arg(problem.number).arg(problem.field, problem.text);
    }
    for (const Finding& finding : ran.preview.findings) {
        lines << QStringLiteral("%1 s, step %2: %3").arg(finding.time).arg(finding.step).arg(finding.text);
    }
    QStringList order;
    for (const int step : ran.preview.order) {
        order << QString::number(step);
    }
    return (lines.join('\n') + '\n' + order.join(' ') + '\n' + ran.script.text).toUtf8();
}

QByteArray texts(const std::vector<int>& numbers) {
    QByteArray text;
    for (const int number : numbers) {
        text += QByteArray::number(number) + ' ';
    }
    return text.trimmed();
}

std::vector<InputChange> on(int channel, double time = 0) {
    return {{time, channel, true}};
}

}  // namespace

class TestProgramPreview : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void anEndlessProgramIsPreviewedForTwoCycles() {
        const project::Project project = sampleProject();
        const auto wait = [](double time) { return step("wait", {{"time", time}}); };
        // Step 2 is the endless loop, step 3 is a counted loop at the start of each cycle, and step 5 is the
        // last step of a cycle.
        const Ran ran = run(
            project, makeProgram("Endless",
                                 {wait(0.1), step("loop", {{"times", 0}},
                                                  {step("loop", {{"times", 3}}, {wait(0.2)}), wait(0.4)})}));
        QVERIFY2(ran.preview.isGood(), describe(ran));
        QVERIFY(ran.preview.isEndless);
        QCOMPARE(ran.script.cycles, std::vector<int>{2});
        QCOMPARE(ran.preview.timings[3].count, 6);
        QCOMPARE(ran.preview.timings[4].count, 2);
        QVERIFY2(std::abs(ran.preview.duration - 2.1) < 0.1, describe(ran));
        // A fault in the loop is found.
        const Ran bad =
            run(project, makeProgram("Bad", {step("loop", {{"times", 0}}, {wait(0.1), step("fail")})}));
        QVERIFY(!bad.preview.isGood() && !bad.preview.isEndless);
    }

    void theTrayProgramFillsEveryCell() {
        const project::Project project = sampleProject();
        PreviewOptions options;
        options.inputs = on(0);
        const Ran ran = run(project, trayProgram(project), options);
        QVERIFY2(ran.preview.isGood(), describe(ran));
        // The tray has twelve positions, and the steps in the loop ran once for each of them.
        QCOMPARE(ran.preview.timings[5].count, 12);
        QCOMPARE(ran.preview.timings[11].count, 12);
        QVERIFY(ran.preview.timings[11].total > 12 * 0.01);
        QCOMPARE(ran.preview.timings[17].count, 1);
        const project::Waypoint& home = project.waypoints.at(0);
        const Pose end = *project::poseInBase(home, project.frames);
        QVERIFY2((ran.preview.endPose.position - end.position).norm() < 1e-4, describe(ran));
        QCOMPARE(ran.preview.outputs, std::uint64_t(0));
        QVERIFY(ran.preview.path.size() > 100);
        QVERIFY(std::abs(ran.preview.path.back().time - ran.preview.duration) < 1e-9);
    }

    void missingPartRunsTheOnErrorSection() {
        const project::Project project = sampleProject();
        const Ran ran = run(project, trayProgram(project));  // the input stays off
        QVERIFY2(ran.preview.isGood(), describe(ran));
        QCOMPARE(ran.preview.timings[7].count, 1);   // the gripper closes once
        QCOMPARE(ran.preview.timings[8].count, 0);   // and no later step in the loop runs
        QCOMPARE(ran.preview.timings[14].count, 1);  // the On error section runs
        QCOMPARE(ran.preview.timings[16].count, 1);  // the last step still runs
    }

    void failureWithoutOnErrorEndsTheProgram() {
        const Ran ran =
            run(sampleProject(), makeProgram("p", {step("wait", {{"time", 0.1}}),
                                                   step("waitInput", {{"input", 3}, {"timeLimit", 0.5}}),
                                                   step("wait", {{"time", 0.1}})}));
        QVERIFY(!ran.preview.completed);
        QCOMPARE(texts(ran.preview.order), QByteArray("1 2"));
        QCOMPARE(ran.preview.findings.size(), std::size_t(1));
        QVERIFY(ran.preview.findings[0].kind == Finding::Kind::StepFailed);
        QCOMPARE(ran.preview.findings[0].step, 2);
        QVERIFY2(std::abs(ran.preview.findings[0].time - 0.6) < 0.02, describe(ran));
    }

    void stepsRunInOrder_data() {
        QTest::addColumn<int>("input");
        QTest::addColumn<QByteArray>("order");
        // 1 if {2} 3 else {4}; 5 loop twice {6 switch {7 case 1 {8} 9 case 2 {10} 11 default {12}}}; 13 while
        // {14, 15}
        QTest::newRow("on") << 0 << QByteArray("1 2 5 6 7 8 6 9 10 13 14 15 14 15 14 15 16");
        QTest::newRow("off") << 1 << QByteArray("1 3 4 5 6 7 8 6 9 10 13 14 15 14 15 14 15 16");
    }
    void stepsRunInOrder() {
        QFETCH(int, input);
        QFETCH(QByteArray, order);
        const project::ProgramStep wait = step("wait", {{"time", 0.01}});
        const auto another = [] { return step("wait", {{"time", 0.01}}); };
        PreviewOptions options;
        options.inputs = on(input);
        const Ran ran = run(
            sampleProject(),
            makeProgram(
                "p", {step("if", {{"condition", "DI0"}}, {another()}), step("else", {}, {another()}),
                      step("loop", {{"times", 2}, {"variable", "pass"}},
                           {step("switch", {{"value", "pass"}},
                                 {step("case", {{"value", "1"}}, {another()}),
                                  step("case", {{"value", "2"}}, {another()}),
                                  step("default", {}, {another()})})}),
                      step("while", {{"condition", "pass < 5"}},
                           {step("assign", {{"variable", "pass"}, {"type", "whole"}, {"value", "pass + 1"}}),
                            another()}),
                      step("end")}),
            options);
        QVERIFY2(ran.preview.isGood(), describe(ran));
        QCOMPARE(texts(ran.preview.order), order);
    }

    void calledProgramsReceiveTheirValues() {
        project::Project project = sampleProject();
        project::Program helper = makeProgram(
            "helper", {step("if", {{"condition", "again > 1"}}, {step("wait", {{"time", 0.01}})})});
        helper.parameters = {"again"};
        project.programs.append(helper);
        const Ran ran = run(
            project, makeProgram("p", {step("call", {{"program", idText(helper.id)}, {"arguments", "1"}}),
                                       step("call", {{"program", idText(helper.id)}, {"arguments", "2"}})}));
        QVERIFY2(ran.preview.isGood(), describe(ran));
        QCOMPARE(texts(ran.preview.order), QByteArray("1 3 1 2 3 4 2"));
    }

    void watchRunsInParallelWithTheProgram() {
        PreviewOptions options;
        options.inputs = on(2, 0.5);
        const Ran ran =
            run(sampleProject(),
                makeProgram("p", {step("watch", {{"condition", "DI2"}}, {step("setOutput", {{"output", 5}})}),
                                  step("wait", {{"time", 1}})}),
                options);
        QVERIFY2(ran.preview.isGood(), describe(ran));
        QCOMPARE(ran.preview.outputs, std::uint64_t(1) << 5);
        QVERIFY(std::abs(ran.preview.duration - 1) < 0.1);
    }

    void operatorAnswersAreUsed() {
        const Ran ran = run(
            sampleProject(),
            makeProgram("p", {step("message", {{"text", "Check"}}), step("question", {{"text", "How many?"}}),
                              step("question", {{"text", "Go on?"}, {"variable", "b"}, {"type", "flag"}}),
                              step("if", {{"condition", "b or answer > 1"}}, {step("wait")})}));
        QVERIFY2(ran.preview.isGood(), describe(ran));
        QCOMPARE(texts(ran.preview.order), QByteArray("1 2 3 4"));
        QVERIFY(ran.preview.duration > 3);
    }

    void everyMoveReachesItsTarget() {
        const project::Project project = sampleProject();
        const QString tool = idText(project.tooling.tools.at(0).id);
        const Ran ran = run(
            project,
            makeProgram(
                "p",
                {step("moveJ", {{"waypoint", waypointId(project, "home")}}),
                 step("moveGroup", {{"group", "row"}}),
                 step("moveP", {{"waypoint", waypointId(project, "pick")}}),
                 step("moveCircle",
                      {{"via", waypointId(project, "row 2")}, {"waypoint", waypointId(project, "place")}}),
                 step("frame", {{"frame", idText(project.frames.at(0).id)}},
                      {step("moveRelative", {{"axes", "frame"}, {"x", 0.02}})}),
                 step("moveRelative", {{"axes", "base"}, {"z", 0.03}}),
                 step("moveUntil",
                      {{"until", "distance"}, {"axes", "base"}, {"direction", "-z"}, {"distance", 0.03}}),
                 step("tool", {{"tool", tool}},
                      {step("moveL", {{"waypoint", waypointId(project, "place")}})})}));
        QVERIFY2(ran.preview.isGood(), describe(ran));
        const Pose place = *project::poseInBase(project.waypoints.at(2), project.frames);
        QVERIFY2((ran.preview.endPose.position - place.position).norm() < 2e-4, describe(ran));
    }

    void aMoveEndsWhenTheInputChanges() {
        PreviewOptions options;
        options.inputs = on(4, 0.5);
        const project::ProgramStep down =
            step("moveUntil",
                 {{"until", "input"}, {"input", 4}, {"axes", "base"}, {"direction", "+z"}, {"speed", 0.05}});
        const Ran reached = run(sampleProject(), makeProgram("p", {down}), options);
        QVERIFY2(reached.preview.isGood(), describe(reached));
        const Ran missed = run(sampleProject(), makeProgram("p", {down}));
        QVERIFY(!missed.preview.completed);
        QVERIFY(missed.preview.findings[0].kind == Finding::Kind::StepFailed);
    }

    void collisionsAreFoundAtTheirStep() {
        project::Project project = sampleProject();
        const Pose pick = *project::poseInBase(project.waypoints.at(1), project.frames);
        project.cell.boxes = {{QUuid::createUuid(),
                               "feeder",
                               QUuid(),
                               Pose(pick.position, Eigen::Vector3d::Zero()),
                               {0.04, 0.04, 0.04},
                               true,
                               {}}};
        const Ran ran =
            run(project, makeProgram("p", {step("moveJ", {{"waypoint", waypointId(project, "home")}}),
                                           step("moveL", {{"waypoint", waypointId(project, "pick")}})}));
        QVERIFY2(ran.preview.completed && !ran.preview.isGood(), describe(ran));
        QCOMPARE(ran.preview.findings.size(), std::size_t(1));
        QVERIFY(ran.preview.findings[0].kind == Finding::Kind::Collision);
        QCOMPARE(ran.preview.findings[0].step, 2);
        QVERIFY(ran.preview.findings[0].text.contains("feeder"));
    }

    void anObjectWithoutAPositionIsFound() {
        project::Project project = sampleProject();
        project::CellBox box;
        box.name = QStringLiteral("feeder");
        box.frame = QUuid::createUuid();
        project.cell.boxes = {box};
        const Ran ran = run(project, makeProgram("p", {step("wait", {{"time", 0.1}})}));
        QVERIFY2(ran.preview.completed && !ran.preview.isGood(), describe(ran));
        QCOMPARE(ran.preview.findings.size(), std::size_t(1));
        QVERIFY(ran.preview.findings[0].kind == Finding::Kind::Collision);
        QVERIFY(ran.preview.findings[0].text.contains("feeder"));
    }

    void stopsAndScriptErrorsAreFoundAtTheirStep() {
        const Ran stop =
            run(sampleProject(), makeProgram("p", {step("wait", {{"time", 0.1}}),
                                                   step("moveRelative", {{"axes", "base"}, {"y", -2.5}})}));
        QVERIFY(!stop.preview.completed);
        QVERIFY2(!stop.preview.findings.empty(), describe(stop));
        QCOMPARE(stop.preview.findings[0].step, 2);
        const Ran runtime =
            run(sampleProject(), makeProgram("p", {step("wait", {{"time", 0.1}}),
                                                   step("script", {{"text", "x = [1, 2]\nx = x[5]"}})}));
        QVERIFY(!runtime.preview.completed);
        QVERIFY2(runtime.preview.findings[0].kind == Finding::Kind::RuntimeError, describe(runtime));
        QCOMPARE(runtime.preview.findings[0].step, 2);
        const Ran compile = run(
            sampleProject(), makeProgram("p", {step("wait", {{"time", 0.1}}),
                                               step("if", {{"condition", "unknown > 2"}}, {step("wait")})}));
        QVERIFY2(compile.preview.findings[0].kind == Finding::Kind::ScriptError, describe(compile));
        QCOMPARE(compile.preview.findings[0].step, 2);
    }

    void aProgramThatDoesNotEndIsLimited() {
        PreviewOptions options;
        options.timeLimit = 5;
        const Ran ran =
            run(sampleProject(), makeProgram("p", {step("while", {{"condition", "True"}}, {step("wait")})}),
                options);
        QVERIFY(!ran.preview.completed);
        QVERIFY(ran.preview.findings[0].kind == Finding::Kind::TimeLimit);
        options.timeLimit = 3600;
        options.isCancelled = [] { return true; };
        const Ran cancelled =
            run(sampleProject(), makeProgram("p", {step("loop", {{"times", 0}}, {step("wait")})}), options);
        QVERIFY(cancelled.preview.findings[0].kind == Finding::Kind::Cancelled);
    }

    void twoRunsAreIdentical() {
        const project::Project project = sampleProject();
        const Ran first = run(project, trayProgram(project));
        const Ran second = run(project, trayProgram(project));
        QCOMPARE(first.preview.duration, second.preview.duration);
        QVERIFY(first.preview.endJoints == second.preview.endJoints);
    }
};

QTEST_APPLESS_MAIN(TestProgramPreview)
#include "tst_program_preview.moc"
