// SPDX-License-Identifier: MIT
// Round trips, error messages and 1000 damaged files, for all parts of a project except frames and waypoints.

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QRandomGenerator>
#include <QTest>
#include <functional>

#include "full_project.h"

using namespace tiller;
using namespace tiller::project;

namespace {

QByteArray bytesOfFull() {
    return *serializeProject(fullProject());
}

QJsonObject rootOfFull() {
    return QJsonDocument::fromJson(bytesOfFull()).object();
}

/// Returns `value` with the element at `path` (e.g. "tools[1].name") replaced; an undefined value removes the
/// element.
QJsonValue replaced(const QJsonValue& value, const QString& path, const QJsonValue& by) {
    if (path.isEmpty()) {
        return by;
    }
    if (path.startsWith(QLatin1Char('['))) {
        const auto end = path.indexOf(QLatin1Char(']'));
        QJsonArray array = value.toArray();
        const int index = path.mid(1, end - 1).toInt();
        array[index] = replaced(array[index], path.mid(end + 1), by);
        return array;
    }
    const QString rest = path.startsWith(QLatin1Char('.')) ? path.mid(1) : path;
    qsizetype end = 0;
    while (end < rest.size() && rest[end] != QLatin1Char('.') && rest[end] != QLatin1Char('[')) {
        ++end;
    }
    QJsonObject object = value.toObject();
    const QString key = rest.left(end);
    const QJsonValue inner = replaced(object.value(key), rest.mid(end), by);
    if (inner.isUndefined()) {
        object.remove(key);
    } else {
        object[key] = inner;
    }
    return object;
}

QByteArray fullWith(const QString& path, const QJsonValue& by) {
    return QJsonDocument(replaced(rootOfFull(), path, by).toObject()).toJson();
}

/// Returns true if every waypoint of `found` is also in `whole`, unchanged except for references to a lost
/// pattern.
bool allFrom(const WaypointList& found, const WaypointList& whole) {
    return std::all_of(found.begin(), found.end(), [&](const Waypoint& point) {
        const int at = whole.indexOf(point.id);
        if (at < 0) {
            return false;
        }
        Waypoint original = whole.at(at);
        if (point.place.isNull()) {
            original.place = {};
        }
        return original == point;
    });
}

}  // namespace

class TestProjectParts : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void everythingRoundTripsByteForByte() {
        const Project document = fullProject();
        const Result<QByteArray> bytes = serializeProject(document);
        QVERIFY2(bytes.ok(), qPrintable(bytes.error().toString()));
        const Result<Project> read = parseProject(*bytes);
        QVERIFY2(read.ok(), qPrintable(read.error().toString()));
        QVERIFY(read->waypoints == document.waypoints);
        QVERIFY(read->tooling == document.tooling);
        QVERIFY(read->positions == document.positions);
        QVERIFY(read->patterns == document.patterns);
        QVERIFY(read->cell == document.cell);
        QVERIFY(read->paths == document.paths);
        QVERIFY(read->programs == document.programs);
        QVERIFY(*read == document);
        QCOMPARE(*serializeProject(*read), *bytes);
    }

    void safetyDistanceAndExclusionsRoundTrip() {
        Project document = fullProject();
        document.cell.safetyDistance = 0.025;
        CellBox box = document.cell.boxes.at(0);
        box.enabled = false;
        document.cell.boxes.replace(0, box);
        CellPlane plane = document.cell.planes.at(0);
        plane.enabled = false;
        document.cell.planes.replace(0, plane);
        const Result<Project> read = parseProject(*serializeProject(document));
        QVERIFY2(read.ok(), qPrintable(read.error().toString()));
        QVERIFY(read->cell == document.cell);
        QVERIFY(!read->cell.boxes.at(0).enabled && !read->cell.planes.at(0).enabled);
        QCOMPARE(read->cell.safetyDistance, 0.025);
    }

    void emptySectionsAreNotWritten() {
        const QJsonObject root = QJsonDocument::fromJson(*serializeProject(Project())).object();
        QCOMPARE(root.keys(), QStringList({"format", "frames", "version", "waypoints"}));
        Project plain;
        Waypoint point = fullWaypoint("plain", QUuid());
        point.group.clear();
        point.colour = WaypointColour::None;
        point.note.clear();
        point.actions.clear();
        plain.waypoints.append(point);
        const QJsonObject written =
            QJsonDocument::fromJson(*serializeProject(plain)).object()["waypoints"].toArray()[0].toObject();
        QCOMPARE(written.keys(), QStringList({"blend", "frame", "id", "jointSpeed", "joints", "move", "name",
                                              "pose", "rules", "tcpOffset", "toolSpeed"}));
    }

    void fileOfTheFirstVersionOpens() {
        Project plain;
        plain.robot = RobotModelId::UR5e;
        Waypoint point = fullWaypoint("plain", QUuid());
        point.group.clear();
        point.colour = WaypointColour::None;
        point.note.clear();
        point.actions.clear();
        plain.waypoints.append(point);
        QByteArray bytes = *serializeProject(plain);
        QVERIFY(bytes.contains("\"version\": 2"));
        bytes.replace("\"version\": 2", "\"version\": 1");
        const Result<Project> read = parseProject(bytes);
        QVERIFY2(read.ok(), qPrintable(read.error().toString()));
        QVERIFY(*read == plain);
    }

    void unknownFieldsOfEveryPartSurvive() {
        QJsonValue root = rootOfFull();
        for (const char* path :
             {"later", "waypoints[0].later", "waypoints[0].actions[0].later", "tools[0].later",
              "payloads[1].later", "positions[0].later", "patterns[0].later", "patterns[0].first.later",
              "cell.later", "cell.boxes[0].later", "cell.planes[0].later", "paths[0].later",
              "programs[0].later", "programs[0].steps[0].later", "programs[0].steps[0].steps[0].later",
              "frames[0].later"}) {
            root = replaced(root, QLatin1String(path), QJsonArray{1, "two"});
        }
        const QByteArray bytes = QJsonDocument(root.toObject()).toJson();
        const Result<Project> read = parseProject(bytes);
        QVERIFY2(read.ok(), qPrintable(read.error().toString()));
        QCOMPARE(*serializeProject(*read), bytes);
    }

    void wrongFieldsAreNamed_data() {
        QTest::addColumn<QString>("path");
        QTest::addColumn<QJsonValue>("value");
        QTest::addColumn<QString>("said");
        const auto row = [](const char* path, const QJsonValue& value, const char* said) {
            QTest::newRow(qPrintable(QStringLiteral("%1 %2").arg(path, said)))
                << QString(path) << value << QString(said);
        };
        const QString nobody = QUuid::createUuid().toString(QUuid::WithoutBraces);
        row("waypoints[0].colour", "mauve",
            "waypoints[0].colour: \"mauve\" is not one of \"none\", \"blue\"");
        row("waypoints[0].group", 3, "waypoints[0].group: is a number, not a text");
        row("waypoints[0].note", QJsonArray(), "waypoints[0].note: is a list, not a text");
        row("waypoints[0].actions", "x", "waypoints[0].actions: is a text, not a list");
        row("waypoints[0].actions[0].do", "dance", "waypoints[0].actions[0].do: \"dance\" is not one of");
        row("waypoints[0].actions[0].pin", 8, "actions[0].pin: is 8, outside the range 0 to 7");
        row("waypoints[0].actions[0].pin", 1.5, "actions[0].pin: is 1.5, not a whole number");
        row("waypoints[0].actions[0].value", 1, "actions[0].value: is a number, not true or false");
        row("waypoints[0].actions[1].pin", 2, "actions[1].pin: is 2, outside the range 0 to 1");
        row("waypoints[0].actions[3].seconds", -1,
            "actions[3].seconds: is -1 s, outside the range 0 to 3600 s");
        row("waypoints[0].actions[3]", 5, "actions[3]: is a number, not an object");
        row("waypoints[1].place", 5, "waypoints[1].place: is a number, not an object");
        row("waypoints[1].place.pattern", nobody, "waypoints[1].place: no pattern of this project");
        row("waypoints[11].history[0].at", "noon", "history[0].at: is not a date and time");
        row("waypoints[11].history[0].before", QJsonValue::Undefined, "history[0].before.name: is missing");
        row("waypoints[11].history[1].before.joints", 1, "history[1].before.joints: is a number");
        row("tools", 1, "tools: is a number, not a list");
        row("tools[0].name", "", "tools[0].name: is empty");
        row("tools[0].tcpOffset[2]", 150, "tools[0].tcpOffset[2]: is 150 m");
        row("tools[0].radius", 40, "tools[0].radius: is 40 m, outside the range 0 to 1 m");
        row("activeTool", nobody, "activeTool: no item of this project has that id");
        row("payloads[0].mass", -2, "payloads[0].mass: is -2 kg, outside the range 0 to 50 kg");
        row("payloads[0].centre", QJsonArray{1, 2}, "payloads[0].centre: has 2 numbers, not 3");
        row("payloads[0].centre[0]", 50, "payloads[0].centre[0]: is 50 m, outside the range -5 to 5 m");
        row("payloads[1].inertia[0]", -1, "payloads[1].inertia[0]: is -1 kg m2");
        row("activePayload", 7, "activePayload: is a number, not a text");
        row("positions[0].joints[1]", 90, "positions[0].joints[1]: is 90 rad");
        row("positions[1].id", QJsonValue::Undefined, "positions[1].id: is missing");
        row("home", nobody, "home: no item of this project has that id");
        row("safeHeight", 0.3, "safeHeight: is a number, not an object");
        row("safeHeight.frame", nobody, "safeHeight.frame: no frame of this project");
        row("patterns[0].columns", 0, "patterns[0].columns: is 0, outside the range 1 to 200");
        row("patterns[0].columns", 1e300, "patterns[0].columns: is 1e+300, outside the range 1 to 200");
        row("patterns[0].order", "spiral",
            "patterns[0].order: \"spiral\" is neither \"rows\" nor \"meander\"");
        row("patterns[0].first.pose", QJsonValue::Undefined, "patterns[0].first.pose: is missing");
        row("patterns[0].excluded[0].row", -1, "patterns[0].excluded[0].row: is -1");
        row("patterns[0].corners[0]", nobody, "patterns[0].corners[0]: no waypoint of this project");
        row("patterns[0].corners[1]", "x", "patterns[0].corners[1]: is not an id");
        row("cell", QJsonArray(), "cell: is a list, not an object");
        row("cell.floor", "low", "cell.floor: is a text, not a number");
        row("cell.boxes[0].enabled", 1, "cell.boxes[0].enabled: is a number, not ");
        row("cell.safetyDistance", -0.01, "cell.safetyDistance: ");
        row("cell.boxes[0].size[1]", 0, "cell.boxes[0].size[1]: is 0 m; the minimum edge length");
        row("cell.planes[0].frame", "x", "cell.planes[0].frame: \"x\" is not an id");
        row("paths[0].points[1].t", -1, "paths[0].points[1].t: is -1 s");
        row("paths[0].points[0].q", QJsonArray{1}, "paths[0].points[0].q: has 1 numbers, not 6");
        row("paths[0].tolerance", QJsonValue::Undefined, "paths[0].tolerance: is missing");
        row("programs[0].name", "", "programs[0].name: is empty");
        row("programs[0].parameters[0]", 1, "programs[0].parameters[0]: is a number, not a text");
        row("programs[0].steps[0].do", QJsonValue::Undefined, "programs[0].steps[0].do: is missing");
        row("programs[0].steps[0].steps[0].id", "x", "programs[0].steps[0].steps[0].id: \"x\" is not an id");
        row("programs[0].steps[0].steps[0].disabled", 1,
            "programs[0].steps[0].steps[0].disabled: is a number, not ");
        row("programs[0].steps[1]", 5, "programs[0].steps[1]: is a number, not an object");
    }
    void wrongFieldsAreNamed() {
        QFETCH(QString, path);
        QFETCH(QJsonValue, value);
        QFETCH(QString, said);
        const QByteArray bytes = fullWith(path, value);
        const Result<Project> read = parseProject(bytes);
        QVERIFY(!read.ok());
        QVERIFY(read.error().code == ErrorCode::FileCorrupt);
        QVERIFY2(read.error().context.contains(said), qPrintable(read.error().context));
    }

    void duplicateIdsAreReported() {
        const QJsonObject root = rootOfFull();
        const QJsonValue id = root["tools"].toArray()[0].toObject()["id"];
        const QByteArray twice = QJsonDocument(replaced(root, "tools[1].id", id).toObject()).toJson();
        QVERIFY2(parseProject(twice).error().context.contains("tools[1].id: is already used in tools"),
                 qPrintable(parseProject(twice).error().context));
    }

    void stepsOfAProgramHaveDifferentIds() {
        const QJsonObject root = rootOfFull();
        const QJsonValue id = root["programs"].toArray()[0].toObject()["steps"].toArray()[0].toObject()["id"];
        const QByteArray twice =
            QJsonDocument(replaced(root, "programs[0].steps[0].steps[0].id", id).toObject()).toJson();
        QVERIFY2(
            parseProject(twice).error().context.contains("steps[0].steps[0].id: is used by another step"),
            qPrintable(parseProject(twice).error().context));
    }

    void nestedStepsAreLimited() {
        Project document;
        Program program;
        program.id = QUuid::createUuid();
        program.name = "deep";
        std::vector<ProgramStep>* steps = &program.steps;
        for (int depth = 0; depth < kMaxProgramDepth; ++depth) {
            steps->push_back({QUuid::createUuid(), "folder", {}, false, {}});
            steps = &steps->front().steps;
        }
        document.programs.append(program);
        QVERIFY(serializeProject(document).ok());
        steps->push_back({QUuid::createUuid(), "folder", {}, false, {}});
        document.programs.replace(0, program);
        QVERIFY2(serializeProject(document).error().context.contains("nested deeper than 50"),
                 qPrintable(serializeProject(document).error().context));
    }

    void stepsReferToWaypointsByTheirIds() {
        const Project document = fullProject();
        const Program& program = document.programs.at(0);
        QVERIFY(refersTo(program, document.waypoints.at(0).id));
        QVERIFY(!refersTo(program, document.frames.at(0).id));
    }

    void pathTimesMustIncrease() {
        const Result<Project> read = parseProject(fullWith("paths[0].points[0].t", 3));
        QVERIFY2(read.error().context.contains("paths[0].points[1].t: is 0.5 s, outside the range 3 to"),
                 qPrintable(read.error().context));
    }

    void tooLargePatternIsRefused() {
        QJsonValue root = replaced(rootOfFull(), "patterns[0].columns", 200);
        root = replaced(root, "patterns[0].rows", 200);
        const Result<Project> read = parseProject(QJsonDocument(root.toObject()).toJson());
        QVERIFY2(read.error().context.contains("has 80000 cells, more than 5000"),
                 qPrintable(read.error().context));
    }

    // If reading a project dropped an obstacle, motions would no longer avoid it.
    void obstaclesWithAMissingFrameAreKept() {
        Project document = fullProject();
        CellBox box = document.cell.boxes.at(0);
        CellPlane plane = document.cell.planes.at(0);
        box.frame = plane.frame = QUuid::createUuid();
        document.cell.boxes.replace(0, box);
        document.cell.planes.replace(0, plane);
        const Result<QByteArray> bytes = serializeProject(document);
        QVERIFY2(bytes.ok(), qPrintable(bytes.error().toString()));
        const Result<Project> read = parseProject(*bytes);
        QVERIFY2(read.ok(), qPrintable(read.error().toString()));
        QCOMPARE(read->cell, document.cell);
    }

    void unreadableObstaclesAreCounted() {
        const Result<RecoveredProject> found = recoverFromBytes(fullWith("cell.boxes[0].size[1]", 0));
        QVERIFY(found.ok());
        QCOMPARE(found->lostObstacles, 1);
        QCOMPARE(found->lostParts, 1);
    }

    void damageLosesOnlyTheDamagedEntries() {
        const Project document = fullProject();
        QJsonValue root = QJsonDocument::fromJson(*serializeProject(document)).object();
        root = replaced(root, "tools[1].name", 5);
        root = replaced(root, "patterns[0].rows", "x");
        const Result<RecoveredProject> found = recoverFromBytes(QJsonDocument(root.toObject()).toJson());
        QVERIFY(found.ok());
        QCOMPARE(found->lostParts, 2);
        QCOMPARE(found->lostWaypoints, 0);
        QCOMPARE(found->document.waypoints.size(), document.waypoints.size());
        QVERIFY(found->document.tooling.activeTool.isNull());
        QCOMPARE(found->document.tooling.tools.size(), std::size_t(1));
        // The positions of a lost pattern remain as waypoints.
        QVERIFY(found->document.waypoints.at(1).place.isNull());
        QVERIFY(serializeProject(found->document).ok());
    }

    void aThousandDamagedFilesHarmNothing() {
        const Project whole = fullProject();
        const QByteArray bytes = *serializeProject(whole);
        QRandomGenerator random(20260304);
        int refused = 0;
        for (int n = 0; n < 1000; ++n) {
            QByteArray damaged = bytes;
            const int wounds = 1 + static_cast<int>(random.bounded(3));
            for (int wound = 0; wound < wounds; ++wound) {
                const auto at = static_cast<qsizetype>(random.bounded(static_cast<int>(damaged.size())));
                switch (random.bounded(5)) {
                    case 0:
                        damaged[at] = static_cast<char>(random.bounded(256));
                        break;
                    case 1:
                        damaged.truncate(std::max<qsizetype>(at, 1));
                        break;
                    case 2:
                        damaged.remove(at, 1 + random.bounded(40));
                        break;
                    case 3:
                        damaged.insert(at, damaged.mid(random.bounded(static_cast<int>(damaged.size())), 30));
                        break;
                    default:
                        damaged[at] = "{}[]\",:-e0"[random.bounded(10)];
                        break;
                }
            }
            const Result<Project> read = parseProject(damaged);
            const Result<RecoveredProject> found = recoverFromBytes(damaged);
            if (!read) {
                ++refused;
                QVERIFY(!read.error().context.isEmpty());
            } else {
                // Any accepted document can be written and read back unchanged.
                const Result<QByteArray> again = serializeProject(*read);
                QVERIFY2(again.ok(), qPrintable(again.error().toString()));
                QVERIFY(*parseProject(*again) == *read);
            }
            if (found && read) {
                QVERIFY(found->problems.isEmpty());
            }
            if (found && !read) {
                QVERIFY(!found->problems.isEmpty());
            }
        }
        QVERIFY2(refused > 500, qPrintable(QString::number(refused)));
    }

    void noWholeWaypointIsDroppedSilently() {
        const Project whole = fullProject();
        const QJsonObject root = QJsonDocument::fromJson(*serializeProject(whole)).object();
        // Replaces a value at a random position in the file with a value of another type, 1000 times.
        QStringList paths;
        const std::function<void(const QJsonValue&, const QString&)> collect = [&](const QJsonValue& value,
                                                                                   const QString& path) {
            if (!path.isEmpty()) {
                paths << path;
            }
            const QJsonObject object = value.toObject();
            for (auto it = object.begin(); it != object.end(); ++it) {
                collect(it.value(), path.isEmpty() ? it.key() : path + QLatin1Char('.') + it.key());
            }
            const QJsonArray array = value.toArray();
            for (int i = 0; i < array.size(); ++i) {
                collect(array[i], QStringLiteral("%1[%2]").arg(path).arg(i));
            }
        };
        collect(root, {});
        QVERIFY2(paths.size() > 1000, qPrintable(QString::number(paths.size())));
        QRandomGenerator random(7);
        const QJsonArray others = {QJsonValue(), -1e9, "odd", QJsonObject{{"x", 1}}, QJsonArray{1}, true};
        for (int n = 0; n < 1000; ++n) {
            const QString path = paths[random.bounded(static_cast<int>(paths.size()))];
            const QJsonValue by = others[random.bounded(static_cast<int>(others.size()))];
            const QByteArray bytes = QJsonDocument(replaced(root, path, by).toObject()).toJson();
            const Result<RecoveredProject> found = recoverFromBytes(bytes);
            if (!found) {
                QVERIFY2(path == "format" || path == "version", qPrintable(path));
                continue;
            }
            const int kept = found->document.waypoints.size();
            if (kept + found->lostWaypoints != whole.waypoints.size()) {
                // The list is lost only if the list itself or an enclosing list was replaced. This loss is
                // reported.
                QVERIFY2(path == "waypoints", qPrintable(path));
                QVERIFY(!found->problems.isEmpty() || by.isArray());
            }
            if (kept < whole.waypoints.size()) {
                QVERIFY2(!found->problems.isEmpty(), qPrintable(path));
            }
            if (!path.startsWith(QLatin1String("waypoints"))) {
                QVERIFY2(allFrom(found->document.waypoints, whole.waypoints) || path.startsWith("frames"),
                         qPrintable(path));
            }
        }
    }
};

QTEST_GUILESS_MAIN(TestProjectParts)
#include "tst_project_parts.moc"
