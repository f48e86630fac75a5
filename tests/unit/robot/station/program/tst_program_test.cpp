// SPDX-License-Identifier: MIT
//
// Test files for programs: reading, running in virtual time, judging and reports.

#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QTemporaryDir>
#include <QTest>
#include <QXmlStreamReader>
#include <functional>

#include "program_samples.h"
#include "robot/station/program/test/test_file.h"
#include "robot/station/program/test/test_report.h"

using namespace tiller;
using namespace tiller::program;

namespace {

QByteArray describe(const TestOutcome& outcome) {
    QStringList lines;
    for (const Verdict& verdict : outcome.verdicts) {
        lines.append(QStringLiteral("%1 %2").arg(verdict.passed ? "ok" : "FAILED", verdictText(verdict)));
    }
    return lines.join('\n').toUtf8();
}

QByteArray describe(const ReadTestFile& read) {
    QStringList lines;
    for (const project::FileProblem& problem : read.problems) {
        lines.append(problem.toString());
    }
    return lines.join('\n').toUtf8();
}

const Verdict* verdictOf(const TestOutcome& outcome, const QString& name) {
    const auto found =
        std::find_if(outcome.verdicts.begin(), outcome.verdicts.end(),
                     [&name](const Verdict& verdict) { return verdict.name.startsWith(name); });
    return found == outcome.verdicts.end() ? nullptr : &*found;
}

/// Calls `use` with each variant of the value in which one value is null.
void forEachNull(const QJsonValue& value, const std::function<void(const QJsonValue&)>& use) {
    use(QJsonValue());
    const QJsonObject object = value.toObject();
    for (const QString& key : object.keys()) {
        forEachNull(object[key], [&](const QJsonValue& changed) {
            QJsonObject copy = object;
            copy[key] = changed;
            use(copy);
        });
    }
    const QJsonArray list = value.toArray();
    for (qsizetype i = 0; i < list.size(); ++i) {
        forEachNull(list.at(i), [&](const QJsonValue& changed) {
            QJsonArray copy = list;
            copy[i] = changed;
            use(copy);
        });
    }
}

QJsonObject parsed(const char* json) {
    QJsonParseError error;
    const QJsonDocument document = QJsonDocument::fromJson(json, &error);
    if (error.error != QJsonParseError::NoError) {
        qFatal("%s: %s", json, qPrintable(error.errorString()));
    }
    return document.object();
}

}  // namespace

class TestProgramTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() {
        project_ = sampleProject();
        project_.cell.floor = -0.2;
        // 1 moveJ home, 2 setOutput 2, 3 waitInput 0, 4 loop 3 x { 5 moveL pick, 6 moveL place, 7 assign }, 8
        // if AI0 { 9 setOutput 3 }, 10 comment, 11 setAnalogOutput, 12 question, 13 setOutput 2 off
        project_.programs.append(makeProgram(
            "cell",
            {step("moveJ", {{"waypoint", waypointId(project_, "home")}}), step("setOutput", {{"output", 2}}),
             step("waitInput", {{"input", 0}, {"timeLimit", 2}}),
             step("loop", {{"times", 3}},
                  {step("moveL", {{"waypoint", waypointId(project_, "pick")}}),
                   step("moveL", {{"waypoint", waypointId(project_, "place")}}),
                   step("assign", {{"variable", "parts"}, {"type", "whole"}, {"value", "parts + 1"}})}),
             step("if", {{"condition", "AI0 > 2"}}, {step("setOutput", {{"output", 3}})}),
             step("comment", {{"text", "not counted"}}),
             step("setAnalogOutput", {{"output", 0}, {"level", 0.5}}),
             step("question", {{"variable", "count"}, {"type", "whole"}, {"text", "How many?"}}),
             step("setOutput", {{"output", 2}, {"value", false}})}));
        project_.programs.append(
            makeProgram("endless", {step("loop", {{"times", 0}}, {step("wait", {{"time", 0.25}})})}));
        project_.programs.append(makeProgram("wrong", {step("wait"), step("moveL")}));
        project_.programs.append(
            makeProgram("through the floor", {step("moveJ", {{"waypoint", waypointId(project_, "home")}}),
                                              step("moveRelative", {{"axes", "base"}, {"z", -0.5}})}));
        QVERIFY(project::saveProject(folder_.filePath("cell.tiller"), project_).ok());
    }

    void everyFieldIsRead() {
        const ReadTestFile read = readOne(complete());
        QVERIFY2(read.problems.isEmpty(), describe(read));
        const ProgramTest& test = read.file.tests.at(0);
        QCOMPARE(read.file.programs.at(test.program).name, QStringLiteral("cell"));
        QCOMPARE(test.options.start->values[1], -1.7);
        QCOMPARE(test.options.timeLimit, 30.0);
        QCOMPARE(test.options.operatorTime, 0.2);
        QCOMPARE(test.options.answers, QJsonArray{4});
        const std::vector<PreviewEvent>& events = test.options.events;
        QCOMPARE(events.size(), std::size_t(4));
        QVERIFY(events[0].kind == PreviewEvent::Kind::DigitalInput && events[0].time == 1.5 &&
                events[0].value == 1);
        QVERIFY(events[1].kind == PreviewEvent::Kind::AnalogInput && events[1].channel == 1 &&
                events[1].step == 5 && events[1].run == 2 && events[1].time == 0.1 && events[1].value == 2.5);
        QVERIFY(events[2].kind == PreviewEvent::Kind::HandForce &&
                events[2].force == Eigen::Vector3d(1, 2, 3));
        QVERIFY(events[3].kind == PreviewEvent::Kind::LinkLoss && events[3].time == 20);
        const TestExpectations& expected = test.expected;
        QVERIFY(expected.end == Preview::End::Stopped && expected.endStep == 6);
        QVERIFY(expected.allowsCollisions && expected.allowsProtectiveStop && test.options.measuresClearance);
        QCOMPARE(expected.pose->position, 0.002);
        QCOMPARE(*expected.clearance, 0.05);
        QCOMPARE(*expected.force, 40.0);
        QCOMPARE(expected.duration->minimum, 1.0);
        QCOMPARE(expected.cycle->time.maximum, 3.0);
        QCOMPARE(expected.outputs.at(0).channel, 17);
        QCOMPARE(expected.outputs.at(1).tolerance, 0.1);
        QCOMPARE(expected.finalOutputs.at(0).channel, 9);
        QCOMPARE(expected.variables.at(0).value.toDouble(), 3.0);
        QCOMPARE(expected.runs.at(0).count, 3);
        QCOMPARE(test.options.variables, std::vector<std::string>{"parts"});
    }

    void stepsAreFoundById() {
        const QString id = idText(project_.programs.findByName("cell")->steps.at(3).steps.at(1).id);
        QJsonObject test = parsed(R"({"name": "a"})");
        test["expect"] = QJsonObject{{"end", "stopped"}, {"step", id}, {"runs", QJsonObject{{id, 1}}}};
        const ReadTestFile read = readOne(test);
        QVERIFY2(read.problems.isEmpty(), describe(read));
        QCOMPARE(read.file.tests.at(0).expected.endStep, 6);
        QCOMPARE(read.file.tests.at(0).expected.runs.at(0).step, 6);
    }

    void invalidTestsAreReported_data() {
        QTest::addColumn<QByteArray>("test");
        QTest::addColumn<QString>("problem");
        const auto row = [](const char* name, const char* test, const char* problem) {
            QTest::newRow(name) << QByteArray(test) << QString(problem);
        };
        row("no name", R"({})", "tests[0].name: is missing");
        row("misspelt", R"({"name": "a", "expcet": {}})",
            "tests[0].expcet: is not a known field; use one of name,");
        row("expectation", R"({"name": "a", "expect": {"forse": 3}})",
            "tests[0].expect.forse: is not a known field");
        row("program", R"({"name": "a", "program": "x"})",
            "the project has no program \"x\"; it has: cell, endless");
        row("limit", R"({"name": "a", "timeLimit": -1})", "tests[0].timeLimit: must be a number from 0.001");
        row("start", R"({"name": "a", "start": {}})",
            "tests[0].start: must have either \"waypoint\" or \"joints\"");
        row("degrees", R"({"name": "a", "start": {"joints": [0, -90, 0, 0, 0, 0]}})",
            "tests[0].start.joints[1]: must be");
        row("waypoint", R"({"name": "a", "start": {"waypoint": "x"}})",
            "start.waypoint: the project has no waypoint \"x\"");
        row("input", R"({"name": "a", "inputs": [{"input": "TI2", "value": true}]})",
            "inputs[0].input: must be one of DI0");
        row("value", R"({"name": "a", "inputs": [{"input": "DI2", "value": 1}]})",
            "inputs[0].value: must be true or false");
        row("analog", R"({"name": "a", "inputs": [{"input": "AI0", "value": true}]})",
            "inputs[0].value: must be a number");
        row("both times", R"({"name": "a", "inputs": [{"input": "DI2", "value": true, "at": 1, "step": 2}]})",
            "inputs[0].at: cannot be combined with \"step\"; use \"after\"");
        row("after", R"({"name": "a", "inputs": [{"input": "DI2", "value": true, "after": 1}]})",
            "inputs[0].after: requires the field \"step\"");
        row("step", R"({"name": "a", "faults": [{"fault": "linkLoss", "step": 14}]})",
            "faults[0].step: must be a step of the program: a number from 1 to 13, or an id");
        row("fault", R"({"name": "a", "faults": [{"fault": "fire"}]})",
            "faults[0].fault: must be one of protectiveStop,");
        row("list", R"({"name": "a", "inputs": {}})", "tests[0].inputs: must be a list");
        row("answer", R"({"name": "a", "answers": [null]})",
            "answers[0]: must be true, false, a number or a string");
        row("end", R"({"name": "a", "expect": {"end": "done"}})",
            "expect.end: must be one of completed, failed");
        row("end step", R"({"name": "a", "expect": {"step": 2}})", "expect.step: requires \"end\"");
        row("range", R"({"name": "a", "expect": {"duration": {}}})",
            "duration: must have \"min\", \"max\" or both");
        row("order", R"({"name": "a", "expect": {"duration": {"min": 2, "max": 1}}})",
            "\"min\" must not be larger than \"max\"");
        row("cycle", R"({"name": "a", "expect": {"cycleTime": {"min": 2}}})", "cycleTime.step: is missing");
        row("pose", R"({"name": "a", "expect": {"pose": {"pose": [1, 2]}}})",
            "pose.pose: must be a list of 6 numbers");
        row("output", R"({"name": "a", "expect": {"outputs": [{"output": "DI0", "value": true}]}})",
            "outputs[0].output: must be one of DO0");
        row("final output", R"({"name": "a", "expect": {"finalOutputs": {"DO9": true}}})",
            "finalOutputs.DO9: must be one of");
        row("variable", R"({"name": "a", "expect": {"variables": {"a b": 1}}})", "variables.a b: ");
        row("variable value", R"({"name": "a", "expect": {"variables": {"a": null}}})",
            "variables.a: must be a number");
        row("runs", R"({"name": "a", "expect": {"runs": {"5": 1.5}}})", "runs.5: must be a whole number");
    }
    void invalidTestsAreReported() {
        QFETCH(QByteArray, test);
        QFETCH(QString, problem);
        const ReadTestFile read = readOne(parsed(test.constData()));
        QVERIFY2(describe(read).contains(problem.toUtf8()), describe(read));
        QCOMPARE(read.problems.size(), 1);
    }

    void invalidFilesAreReported_data() {
        QTest::addColumn<QByteArray>("content");
        QTest::addColumn<QString>("problem");
        QTest::newRow("empty") << QByteArray() << "line 1, column 1: ";
        QTest::newRow("syntax") << QByteArray("{\n  \"format\": }") << "line 2, column 14: ";
        QTest::newRow("list") << QByteArray("[]") << "is not a test file";
        QTest::newRow("project") << QByteArray(R"({"format": "tiller-project"})")
                                 << "format: must be \"tiller-test\"";
        QTest::newRow("newer") << QByteArray(R"({"format": "tiller-test", "version": 2})")
                               << "version: is 2; this version of Tiller reads versions up to 1";
        QTest::newRow("no tests")
            << QByteArray(R"({"format": "tiller-test", "version": 1, "project": "cell.tiller"})")
            << "tests: must be a list of at least one test";
        QTest::newRow("no project")
            << QByteArray(
                   R"({"format": "tiller-test", "version": 1, "project": "none.tiller", "tests": [{}]})")
            << "none.tiller";
        QTest::newRow("no program")
            << QByteArray(
                   R"({"format": "tiller-test", "version": 1, "project": "cell.tiller", "tests": [{"name": "a"}]})")
            << "program: is missing; the project has the programs: cell, endless";
    }
    void invalidFilesAreReported() {
        QFETCH(QByteArray, content);
        QFETCH(QString, problem);
        const ReadTestFile read = readTestFile(write(content));
        QVERIFY2(describe(read).contains(problem.toUtf8()), describe(read));
    }

    void damagedFilesNeverCrash() {
        const QByteArray whole = QJsonDocument(fileWith(QJsonArray{passing()})).toJson();
        QVERIFY(readTestFile(write(whole)).problems.isEmpty());
        for (qsizetype length = 0; length < whole.size() - 2; length += 7) {
            QVERIFY(!readTestFile(write(whole.left(length))).problems.isEmpty());
        }
    }

    void everyFieldIsChecked() {
        int count = 0;
        forEachNull(complete(), [&](const QJsonValue& damaged) {
            if (damaged.isObject()) {
                const QByteArray text = QJsonDocument(damaged.toObject()).toJson(QJsonDocument::Compact);
                QVERIFY2(!readOne(damaged.toObject()).problems.isEmpty(), text);
                ++count;
            }
        });
        QVERIFY(count > 60);
    }

    void namesMustDiffer() {
        const QJsonObject test = passing();
        const ReadTestFile read =
            readTestFile(write(QJsonDocument(fileWith(QJsonArray{test, test})).toJson()));
        QVERIFY2(describe(read).contains("tests[1].name: another test has the same name"), describe(read));
    }

    void missingFileIsReported() {
        const ReadTestFile read = readTestFile(folder_.filePath("nowhere.test.json"));
        QCOMPARE(read.problems.size(), 1);
    }

    void expectationsAreMet() {
        const TestOutcome outcome = run(passing());
        QVERIFY2(outcome.passed(), describe(outcome));
        QCOMPARE(outcome.verdicts.size(), std::size_t(17));
    }

    void eachExpectationCanFail_data() {
        QTest::addColumn<QByteArray>("expect");
        QTest::addColumn<QString>("name");
        QTest::addColumn<QString>("measured");
        const auto row = [](const char* name, const char* expect, const char* measured) {
            QTest::newRow(name) << QByteArray(expect) << QString(name) << QString(measured);
        };
        row("end", R"({"end": "failed"})", "completed");
        row("pose", R"({"pose": {"waypoint": "home"}})", "away");
        row("clearance", R"({"clearance": 5})", " mm at ");
        row("force", R"({"force": 0})", " N at ");
        row("duration", R"({"duration": {"max": 1}})", " s");
        row("cycle time", R"({"cycleTime": {"step": 5, "max": 0.1}})", " in 2 cycles");
        row("cycle time of step 1", R"({"cycleTime": {"step": 1, "max": 100}})",
            "the step began fewer than two times");
        row("outputs", R"({"outputs": [{"output": "DO2", "value": true}]})", "DO2 on at ");
        row("output at the end", R"({"finalOutputs": {"DO3": false}})", "DO3 on");
        row("variable parts", R"({"variables": {"parts": 4}})", "3");
        row("variable none", R"({"variables": {"none": 4}})", "not set");
        row("runs of step 5", R"({"runs": {"5": 2}})", "3");
    }
    void eachExpectationCanFail() {
        QFETCH(QByteArray, expect);
        QFETCH(QString, name);
        QFETCH(QString, measured);
        QJsonObject test = passing();
        test["expect"] = parsed(expect.constData());
        const TestOutcome outcome = run(test);
        const Verdict* verdict = verdictOf(outcome, name);
        QVERIFY2(verdict != nullptr && !verdict->passed, describe(outcome));
        QVERIFY2(verdict->measured.contains(measured), describe(outcome));
        QCOMPARE(std::count_if(outcome.verdicts.begin(), outcome.verdicts.end(),
                               [](const Verdict& each) { return !each.passed; }),
                 1);
    }

    void outputsAreExpectedInTheirOrder() {
        QJsonObject test = passing();
        test["expect"] = parsed(
            R"({"outputs": [{"output": "DO3", "value": true}, {"output": "DO2", "value": true}, {"output": "DO2", "value": false}]})");
        QVERIFY2(!run(test).passed(), describe(run(test)));
        test["expect"] = parsed(
            R"({"outputs": [{"output": "DO2", "value": true, "max": 0.001}, {"output": "DO2", "value": false}]})");
        QVERIFY2(!run(test).passed(), describe(run(test)));
    }

    void stopsEndTheRunAtTheirStep_data() {
        QTest::addColumn<QString>("fault");
        for (const char* fault :
             {"protectiveStop", "operatorStop", "emergencyStop", "powerLoss", "linkLoss"}) {
            QTest::newRow(fault) << QString(fault);
        }
    }
    void stopsEndTheRunAtTheirStep() {
        QFETCH(QString, fault);
        QJsonObject test = passing();
        test["answers"] = QJsonArray();
        test["faults"] = QJsonArray{QJsonObject{{"fault", fault}, {"step", 6}, {"run", 2}, {"after", 0.1}}};
        test["expect"] = parsed(R"({"end": "stopped", "step": 6, "runs": {"5": 2, "6": 2, "8": 0},
                                    "finalOutputs": {"DO2": true}, "variables": {"parts": 1}})");
        const TestOutcome outcome = run(test);
        QVERIFY2(outcome.passed(), describe(outcome));
        test["expect"] = QJsonObject();
        const TestOutcome unexpected = run(test);
        QVERIFY2(verdictOf(unexpected, "end")->measured.startsWith("stopped at step 6"),
                 describe(unexpected));
        QVERIFY(!unexpected.passed());
    }

    void lostLinkEndsTheProgramAfterTheHeartbeatTimeout() {
        // Until the timeout, the program keeps running.
        QJsonObject test = parsed(R"({"name": "a", "program": "endless", "timeLimit": 1,
            "faults": [{"fault": "linkLoss", "at": 0.95}], "expect": {"end": "running"}})");
        const TestOutcome running = run(test);
        QVERIFY2(running.passed(), describe(running));
        test["timeLimit"] = 2;
        const TestOutcome stopped = run(test);
        QVERIFY2(verdictOf(stopped, "end")->measured.startsWith("stopped"), describe(stopped));
        QVERIFY2(stopped.preview.duration > 1.04 && stopped.preview.duration < 1.2, describe(stopped));
    }

    void failedStepsEndTheRun() {
        const TestOutcome outcome =
            run(parsed(R"({"name": "a", "expect": {"end": "failed", "step": 3, "duration": {"min": 2}}})"));
        QVERIFY2(outcome.passed(), describe(outcome));
        const TestOutcome other = run(parsed(R"({"name": "a", "expect": {"end": "failed", "step": 2}})"));
        QVERIFY2(!verdictOf(other, "end")->passed, describe(other));
    }

    void protectiveStopsFailUnlessAllowed() {
        QJsonObject test = passing();
        test["answers"] = QJsonArray();
        test["faults"] = QJsonArray{QJsonObject{{"fault", "protectiveStop"}, {"step", 5}}};
        test["expect"] = parsed(R"({"end": "stopped", "protectiveStop": "none"})");
        const TestOutcome outcome = run(test);
        QVERIFY2(verdictOf(outcome, "end")->passed && !verdictOf(outcome, "protective stop")->passed,
                 describe(outcome));
    }

    void endlessProgramsAreMeasured() {
        const TestOutcome outcome = run(parsed(R"({"name": "a", "program": "endless", "timeLimit": 3,
            "expect": {"end": "running", "cycleTime": {"step": 2, "min": 0.24, "max": 0.27}}})"));
        QVERIFY2(outcome.passed(), describe(outcome));
    }

    void eventsThatNeverTakePlaceFail() {
        QJsonObject test = passing();
        test["inputs"] = QJsonArray{QJsonObject{{"input", "DI0"}, {"value", true}},
                                    QJsonObject{{"input", "DI1"}, {"value", true}, {"step", 9}}};
        test["expect"] = QJsonObject();
        const TestOutcome outcome = run(test);
        QVERIFY2(!outcome.passed(), describe(outcome));
        QVERIFY2(
            verdictOf(outcome, "inputs and faults")->measured.contains("inputs[1] did not occur: step 9"),
            describe(outcome));
    }

    void answersMustFitTheQuestions() {
        QJsonObject test = passing();
        test["answers"] = QJsonArray{"four"};
        test["expect"] = QJsonObject();
        QVERIFY(verdictOf(run(test), "answers")->measured.contains("answers[0] has a different type"));
        test["answers"] = QJsonArray{4, 5};
        QVERIFY(!verdictOf(run(test), "answers")->passed);
    }

    void handsPushTheTool() {
        QJsonObject test = passing();
        test["inputs"] = QJsonArray{QJsonObject{{"input", "DI0"}, {"value", true}},
                                    QJsonObject{{"hand", QJsonArray{0, 0, 30}}, {"step", 5}}};
        test["expect"] = parsed(R"({"force": 20})");
        QVERIFY2(!run(test).passed(), describe(run(test)));
        test["expect"] = parsed(R"({"force": 40})");
        QVERIFY2(run(test).passed(), describe(run(test)));
    }

    void collisionsFailUnlessAllowed() {
        QJsonObject test =
            parsed(R"({"name": "a", "program": "through the floor", "expect": {"clearance": 0}})");
        const TestOutcome outcome = run(test);
        QVERIFY2(!verdictOf(outcome, "collisions")->passed, describe(outcome));
        QVERIFY2(!verdictOf(outcome, "clearance")->passed, describe(outcome));
        test["expect"] = parsed(R"({"collisions": "allowed"})");
        QVERIFY2(run(test).passed(), describe(run(test)));
    }

    void programsWithErrorsFail() {
        const TestOutcome outcome = run(parsed(R"({"name": "a", "program": "wrong"})"));
        QVERIFY(!outcome.passed() && !outcome.hasRun);
        QVERIFY2(outcome.verdicts.at(0).measured.contains("step 2 (MoveL): "), describe(outcome));
    }

    void sameSeedGivesTheSameReport() {
        QJsonArray tests;
        for (int i = 0; i < 6; ++i) {
            QJsonObject test = passing();
            test["name"] = QString::number(i);
            tests.append(test);
        }
        const std::vector<TestFile> files{readTestFile(write(QJsonDocument(fileWith(tests)).toJson())).file};
        const auto report = [&files](std::uint64_t seed, int threads) {
            const std::vector<TestOutcome> outcomes = runTests(files, {.seed = seed, .threads = threads});
            return QJsonDocument(reportJson(files, outcomes, seed)).toJson() +
                   junitXml(files, outcomes, seed);
        };
        const QByteArray first = report(7, 1);
        QCOMPARE(report(7, 1), first);
        QCOMPARE(report(7, 3), first);
        QVERIFY(report(8, 1) != first);
    }

    void coverageCountsTheSteps() {
        QJsonObject other = parsed(R"({"name": "b", "expect": {"end": "failed"}})");
        const std::vector<TestFile> files{
            readTestFile(write(QJsonDocument(fileWith(QJsonArray{passing(), other})).toJson())).file};
        const std::vector<TestOutcome> outcomes = runTests(files);
        const std::vector<ProgramCoverage> coverage = coverageOf(files, outcomes);
        QCOMPARE(coverage.size(), std::size_t(1));
        QCOMPARE(coverage[0].steps.size(), std::size_t(12));  // without the comment step
        QCOMPARE(coverage[0].executed(), 12);
        QCOMPARE(coverage[0].steps.at(0).count, 2);
        const std::vector<TestOutcome> last{outcomes.at(1)};
        QCOMPARE(coverageOf(files, last)[0].executed(), 3);
        QVERIFY(
            reportText(files, last, 1).contains("coverage of cell: 3 of 12 steps\n  not run: step 4 (Loop)"));
        QCOMPARE(coverageJson(coverage)["programs"].toArray().at(0)["executed"].toInt(), 12);
    }

    void junitXmlIsWellFormed() {
        QJsonObject failing = passing();
        failing["name"] = QStringLiteral("<\"fails\"> & more \x01");
        failing["expect"] = parsed(R"({"duration": {"max": 1}})");
        QJsonObject wrong = parsed(R"({"name": "w", "program": "wrong"})");
        const std::vector<TestFile> files{
            readTestFile(write(QJsonDocument(fileWith(QJsonArray{passing(), failing, wrong})).toJson()))
                .file};
        QXmlStreamReader xml(junitXml(files, runTests(files), 1));
        QStringList cases;
        QStringList failures;
        while (!xml.atEnd()) {
            if (xml.readNext() != QXmlStreamReader::StartElement) {
                continue;
            }
            if (xml.name() == QLatin1String("testsuite")) {
                QCOMPARE(xml.attributes().value("tests").toInt(), 3);
                QCOMPARE(xml.attributes().value("failures").toInt(), 1);
                QCOMPARE(xml.attributes().value("errors").toInt(), 1);
            } else if (xml.name() == QLatin1String("testcase")) {
                cases.append(xml.attributes().value("name").toString());
                QVERIFY(!xml.attributes().value("time").isEmpty());
            } else if (xml.name() == QLatin1String("failure") || xml.name() == QLatin1String("error")) {
                failures.append(xml.attributes().value("message").toString());
            }
        }
        QVERIFY2(!xml.hasError(), qPrintable(xml.errorString()));
        QCOMPARE(cases, (QStringList{"passes", "<\"fails\"> & more ", "w"}));
        QCOMPARE(failures.size(), 2);
        QVERIFY2(failures[0].startsWith("duration: ") && failures[0].endsWith("(expected at most 1.000 s)"),
                 qPrintable(failures[0]));
    }

private:
    /// A test that passes, with every kind of expectation.
    static QJsonObject passing() {
        return parsed(R"({"name": "passes", "answers": [4],
            "inputs": [{"input": "DI0", "value": true, "step": 3, "after": 0.5}, {"input": "AI0", "value": 2.5}],
            "expect": {"end": "completed", "pose": {"waypoint": "place"}, "clearance": 0.05, "force": 60,
                       "duration": {"min": 3, "max": 60}, "cycleTime": {"step": 5, "min": 0.5, "max": 20},
                       "outputs": [{"output": "DO2", "value": true}, {"output": "DO3", "value": true},
                                   {"output": "AO0", "value": 0.012, "tolerance": 0.0001}, {"output": "DO2", "value": false}],
                       "finalOutputs": {"DO3": true, "AO0": 0.012}, "variables": {"parts": 3, "count": 4},
                       "runs": {"5": 3, "9": 1}}})");
    }
    /// A test with every field.
    static QJsonObject complete() {
        return parsed(R"({"name": "all", "start": {"joints": [-1.6, -1.7, -2.2, -0.8, 1.6, 0]},
            "timeLimit": 30, "operatorTime": 0.2, "answers": [4],
            "inputs": [{"input": "DI0", "value": true, "at": 1.5},
                       {"input": "AI1", "value": 2.5, "step": 5, "run": 2, "after": 0.1},
                       {"hand": [1, 2, 3], "step": 6}],
            "faults": [{"fault": "linkLoss", "at": 20}],
            "expect": {"end": "stopped", "step": 6, "collisions": "allowed", "protectiveStop": "allowed",
                       "pose": {"waypoint": "place", "position": 0.002, "rotation": 0.02}, "clearance": 0.05,
                       "force": 40, "duration": {"min": 1, "max": 9}, "cycleTime": {"step": 5, "max": 3},
                       "outputs": [{"output": "TO1", "value": true, "min": 0.5},
                                   {"output": "AO0", "value": 4.5, "tolerance": 0.1}],
                       "finalOutputs": {"CO1": false}, "variables": {"parts": {"value": 3, "tolerance": 0.5}},
                       "runs": {"5": 3}}})");
    }
    static QJsonObject fileWith(const QJsonArray& tests) {
        return {{"format", "tiller-test"},
                {"version", 1},
                {"project", "cell.tiller"},
                {"program", "cell"},
                {"tests", tests}};
    }
    QString write(const QByteArray& content) const {
        const QString path = folder_.filePath("a.test.json");
        QFile file(path);
        if (!file.open(QIODevice::WriteOnly) || file.write(content) != content.size()) {
            qFatal("cannot write %s", qPrintable(path));
        }
        return path;
    }
    ReadTestFile readOne(const QJsonObject& test) const {
        return readTestFile(write(QJsonDocument(fileWith(QJsonArray{test})).toJson()));
    }
    TestOutcome run(const QJsonObject& test) const {
        const ReadTestFile read = readOne(test);
        if (!read.problems.isEmpty()) {
            qFatal("%s", describe(read).constData());
        }
        return runTests({read.file}).at(0);
    }

    QTemporaryDir folder_;
    project::Project project_;
};

QTEST_APPLESS_MAIN(TestProgramTest)
#include "tst_program_test.moc"
