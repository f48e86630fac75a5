// SPDX-License-Identifier: MIT

#include <QTest>
#include <functional>

#include "program_samples.h"
#include "robot/station/program/program_edit.h"
#include "robot/station/program/step_uses.h"

using namespace tiller;
using namespace tiller::program;

namespace {

/// Describes a tree, e.g. "a b(c d) e": the texts of log steps, and folders with their contents.
QString shapeOf(const Steps& steps) {
    QStringList texts;
    for (const project::ProgramStep& step : steps) {
        const QString name = step.fields[step.kind == "folder" ? "name" : "text"].toString();
        texts << name + (step.disabled ? "-" : "") +
                     (step.steps.empty() ? QString() : '(' + shapeOf(step.steps) + ')');
    }
    return texts.join(' ');
}

project::ProgramStep leaf(const char* text) {
    return step("log", {{"text", text}});
}

/// Creates the tree a b(c d(e) f) g.
project::Program sample() {
    return makeProgram("p", {leaf("a"),
                             step("folder", {{"name", "b"}},
                                  {leaf("c"), step("folder", {{"name", "d"}}, {leaf("e")}), leaf("f")}),
                             leaf("g")});
}

QUuid idOf(const project::Program& program, const QString& text) {
    QUuid found;
    const std::function<void(const Steps&)> search = [&](const Steps& steps) {
        for (const project::ProgramStep& step : steps) {
            if (step.fields["text"] == text || step.fields["name"] == text) {
                found = step.id;
            }
            search(step.steps);
        }
    };
    search(program.steps);
    return found;
}

QSet<QUuid> idsOf(const project::Program& program, const QStringList& texts) {
    QSet<QUuid> ids;
    for (const QString& text : texts) {
        ids.insert(idOf(program, text));
    }
    return ids;
}

}  // namespace

class TestProgramEdit : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void theUsesOfAWaypointAreCounted() {
        project::Project project = sampleProject();
        const QString pick = waypointId(project, "pick");
        const project::Program program = makeProgram(
            "p", {step("moveL", {{"waypoint", pick}}),
                  step("loop", {},
                       {step("moveCircle", {{"via", waypointId(project, "place")}, {"waypoint", pick}}),
                        step("moveGroup", {{"group", "row"}}), step("forEachWaypoint", {{"group", "row"}})}),
                  step("log", {{"text", pick}}), step("future", {{"waypoint", pick}})});
        project.programs.append(program);
        project.programs.append(makeProgram("q", {step("moveJ", {{"waypoint", pick}})}));
        const auto uses = [&](const char* name) {
            const int row = project.waypoints.indexOf(QUuid(waypointId(project, name)));
            return countUses(project, project.waypoints.at(row));
        };
        QCOMPARE(uses("pick"), 3);
        QCOMPARE(uses("row 1"), 2);
        QCOMPARE(uses("home"), 0);
    }

    void stepsAreFound() {
        const project::Program program = sample();
        QCOMPARE(shapeOf(program.steps), QString("a b(c d(e) f) g"));
        QCOMPARE(findStep(program.steps, idOf(program, "e"))->fields["text"].toString(), QString("e"));
        QVERIFY(findStep(program.steps, QUuid::createUuid()) == nullptr);
        QCOMPARE(positionOf(program, idOf(program, "f"))->row, 2);
        QVERIFY(positionOf(program, idOf(program, "f"))->section == idOf(program, "b"));
        QVERIFY(!positionOf(program, QUuid::createUuid()));
        QCOMPARE(shapeOf(selectedSteps(program, idsOf(program, {"g", "d", "e"}))), QString("d(e) g"));
    }

    void stepsMove_data() {
        QTest::addColumn<QStringList>("moved");
        QTest::addColumn<QString>("section");
        QTest::addColumn<int>("row");
        QTest::addColumn<QString>("after");
        QTest::newRow("to the end") << QStringList{"a"} << "" << 3 << "b(c d(e) f) g a";
        QTest::newRow("to the front") << QStringList{"g"} << "" << 0 << "g a b(c d(e) f)";
        QTest::newRow("where it is") << QStringList{"a"} << "" << 1 << "a b(c d(e) f) g";
        QTest::newRow("into a section") << QStringList{"a", "g"} << "d" << 1 << "b(c d(e a g) f)";
        QTest::newRow("out of one") << QStringList{"e", "c"} << "" << 1 << "a c e b(d f) g";
        QTest::newRow("within one") << QStringList{"c"} << "b" << 3 << "a b(d(e) f c) g";
        QTest::newRow("a section with its steps") << QStringList{"d", "e"} << "" << 0 << "d(e) a b(c f) g";
        QTest::newRow("into itself") << QStringList{"b"} << "d" << 0 << "a b(c d(e) f) g";
        QTest::newRow("into no section") << QStringList{"a"} << "g" << 0 << "a b(c d(e) f) g";
        QTest::newRow("beyond the end") << QStringList{"a"} << "" << 99 << "b(c d(e) f) g a";
    }
    void stepsMove() {
        QFETCH(QStringList, moved);
        QFETCH(QString, section);
        QFETCH(int, row);
        QFETCH(QString, after);
        const project::Program program = sample();
        const StepPosition at{section.isEmpty() ? QUuid() : idOf(program, section), row};
        QCOMPARE(shapeOf(withMovedSteps(program, idsOf(program, moved), at).steps), after);
    }

    void stepsAreAddedRemovedAndCopied() {
        const project::Program program = sample();
        QCOMPARE(shapeOf(withSteps(program, {idOf(program, "b"), 1}, {leaf("x"), leaf("y")}).steps),
                 QString("a b(c x y d(e) f) g"));
        QCOMPARE(shapeOf(withoutSteps(program, idsOf(program, {"d", "g"})).steps), QString("a b(c f)"));
        const project::Program twice = withDuplicates(program, idsOf(program, {"c", "d"}));
        QCOMPARE(shapeOf(twice.steps), QString("a b(c d(e) c d(e) f) g"));
        QVERIFY(twice.steps[1].steps[0].id != twice.steps[1].steps[2].id);
        QVERIFY(twice.steps[1].steps[1].steps[0].id != twice.steps[1].steps[3].steps[0].id);
        QCOMPARE(shapeOf(withDisabled(program, idsOf(program, {"a", "d"}), true).steps),
                 QString("a- b(c d-(e) f) g"));
        QCOMPARE(shapeOf(withField(program, idOf(program, "e"), "text", "new").steps),
                 QString("a b(c d(new) f) g"));
        QVERIFY(!findStep(withField(program, idOf(program, "e"), "text", QJsonValue::Undefined).steps,
                          idOf(program, "e"))
                     ->fields.contains("text"));
    }

    void stepsChangeTheirLevel() {
        const project::Program program = sample();  // a b(c d(e) f) g
        QCOMPARE(shapeOf(withNested(program, idsOf(program, {"g"})).steps), QString("a b(c d(e) f g)"));
        QCOMPARE(shapeOf(withNested(program, idsOf(program, {"f"})).steps), QString("a b(c d(e f)) g"));
        QVERIFY(withNested(program, idsOf(program, {"a"})) == program);  // no step above it
        QVERIFY(withNested(program, idsOf(program, {"b"})) == program);  // "a" is not a section
        QCOMPARE(shapeOf(withUnnested(program, idsOf(program, {"e"})).steps), QString("a b(c d e f) g"));
        QCOMPARE(shapeOf(withUnnested(program, idsOf(program, {"c", "f"})).steps),
                 QString("a b(d(e)) c f g"));
        QVERIFY(withUnnested(program, idsOf(program, {"a"})) == program);
        QCOMPARE(shapeOf(withShifted(program, idsOf(program, {"g"}), -1).steps), QString("a g b(c d(e) f)"));
        QCOMPARE(shapeOf(withShifted(program, idsOf(program, {"c"}), 1).steps), QString("a b(d(e) c f) g"));
        QVERIFY(withShifted(program, idsOf(program, {"c"}), -1) == program);
        QVERIFY(withShifted(program, idsOf(program, {"g"}), 1) == program);
        QVERIFY(withShifted(program, {}, 1) == program);
    }

    void newStepsFollowTheSelectedOne() {
        project::Program program = sample();
        const auto into = [&](const QUuid& id) {
            return shapeOf(withSteps(program, positionBehind(program, id), {leaf("x")}).steps);
        };
        QCOMPARE(into(idOf(program, "c")), QString("a b(c x d(e) f) g"));
        QCOMPARE(into(idOf(program, "d")), QString("a b(c d(e) x f) g"));
        QCOMPARE(into({}), QString("a b(c d(e) f) g x"));
        program = withoutSteps(program, idsOf(program, {"e"}));
        QCOMPARE(into(idOf(program, "d")), QString("a b(c d(x) f) g"));  // the section is empty
    }

    void nestingIsLimited() {
        project::Program program = makeProgram("p", {step("folder", {{"name", "0"}})});
        for (int depth = 1; depth < project::kMaxProgramDepth; ++depth) {
            program = withSteps(program, {idOf(program, QString::number(depth - 1)), 0},
                                {step("folder", {{"name", QString::number(depth)}})});
        }
        const QUuid deepest = idOf(program, QString::number(project::kMaxProgramDepth - 1));
        QVERIFY(!deepest.isNull());
        QVERIFY(withSteps(program, {deepest, 0}, {leaf("x")}) == program);
    }

    void stepsRoundTripAsText() {
        const project::Program program = sample();
        const auto back = stepsFromText(textOf(program.steps));
        QVERIFY(back.has_value());
        QCOMPARE(shapeOf(*back), shapeOf(program.steps));
        QVERIFY((*back)[0].id != program.steps[0].id);
        for (const char* text :
             {"", "hello", "{}", "{\"tillerSteps\": [1]}", "{\"tillerSteps\": [{\"do\": \"wait\"}]}"}) {
            QVERIFY2(!stepsFromText(text), text);
        }
    }

    void enteredNumbersUseTheDisplayedUnit() {
        StepField field{"speed", "Speed", FieldType::Number, {}, true, Unit::Speed, 0.001, 2, {}};
        QCOMPARE(fieldInput(field, "50").value, QJsonValue(0.05));
        QCOMPARE(fieldInput(field, " 12.5 ").value, QJsonValue(0.0125));
        QCOMPARE(fieldInput(field, "2000").value, QJsonValue(2));
        // A comma never groups digits, so "1,250" must not become 1250.
        QCOMPARE(fieldInput(field, "1,250").value, QJsonValue(0.00125));
        QVERIFY(fieldInput(field, "1.250,5").value.isUndefined());
        QVERIFY(fieldInput(field, "").value.isUndefined() && fieldInput(field, "").refusal.isEmpty());
        for (const char* text : {"0", "2000.1", "-1", "fast", "nan", "inf", "1e9"}) {
            QVERIFY2(fieldInput(field, text).value.isUndefined(), text);
            QCOMPARE(fieldInput(field, text).refusal,
                     QString("“Speed” must be between 1 mm/s and 2,000 mm/s."));
        }
        QCOMPARE(editText(field, 1.25), QString("1250"));
        QCOMPARE(editText(field, QJsonValue::Undefined), QString());
        field.optional = false;
        QVERIFY(!fieldInput(field, "").refusal.isEmpty());
        const StepField whole{"times", "Times", FieldType::Whole, 1, false, Unit::None, -5, 5, {}};
        QCOMPARE(fieldInput(whole, "3").value, QJsonValue(3));
        QCOMPARE(fieldInput(whole, "−3").value, QJsonValue(-3));  // a typographic minus
        QVERIFY(!fieldInput(whole, "2.5").refusal.isEmpty());
    }

    void choicesHaveNames() {
        const project::Project project = sampleProject();
        const auto namesOf = [&](FieldType type) {
            StepField field;
            field.type = type;
            QStringList names;
            for (const auto& [value, name] : choicesOf(project, field)) {
                names << name;
            }
            return names;
        };
        QCOMPARE(namesOf(FieldType::Group), QStringList{"row"});
        QCOMPARE(namesOf(FieldType::Tool), (QStringList{"gripper", "camera"}));
        QCOMPARE(namesOf(FieldType::DigitalOutput).size(), 18);
        QCOMPARE(namesOf(FieldType::DigitalOutput).last(), QString("TO 1"));
        QVERIFY(namesOf(FieldType::Waypoint).contains("pick"));
        QVERIFY(namesOf(FieldType::Number).isEmpty());
    }

    void summariesHaveNamesAndUnits() {
        const project::Project project = sampleProject();
        QCOMPARE(
            summaryOf(
                project,
                step("moveL", {{"waypoint", waypointId(project, "pick")}, {"before", 0.05}, {"speed", 0.1}})),
            QString("pick, 50 mm, 100 mm/s, Run waypoint actions"));
        QCOMPARE(summaryOf(project, step("setOutput", {{"output", 9}})), QString("CO 1, On"));
        QCOMPARE(summaryOf(project, step("forEachPlace", {{"pattern", idText(project.patterns.at(0).id)}})),
                 QString("tray, place"));
        QCOMPARE(summaryOf(project, step("moveL", {{"waypoint", idText(QUuid::createUuid())}})),
                 QString("?, Run waypoint actions"));
        QCOMPARE(summaryOf(project, step("kind of the future")), QString());
    }
};

QTEST_APPLESS_MAIN(TestProgramEdit)
#include "tst_program_edit.moc"
