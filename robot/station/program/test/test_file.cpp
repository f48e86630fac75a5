// SPDX-License-Identifier: MIT
#include "robot/station/program/test/test_file.h"

#include <QDir>
#include <QFileInfo>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QSet>
#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <numbers>

#include "robot/core/file_reading.h"
#include "robot/core/text_place.h"
#include "robot/station/program/expression.h"

namespace tiller::program {
namespace {

constexpr double kMaxTime = 86'400;   // [s]
constexpr double kMaxForce = 10'000;  // [N]
constexpr double kMaxLength = 50;     // [m]
constexpr double kMaxSignal = 1'000;  // [A or V]
constexpr double kDefaultTimeLimit = 600;
constexpr double kAnalogTolerance = 0.01;
constexpr int kMaxRuns = 1'000'000;

QString fieldOf(const QString& place, const QString& key) {
    return place.isEmpty() ? key : place + QLatin1Char('.') + key;
}
QString itemOf(const QString& place, qsizetype index) {
    return QStringLiteral("%1[%2]").arg(place).arg(index);
}
QString listOf(const QStringList& words) {
    return words.isEmpty() ? QStringLiteral("nothing") : words.join(QStringLiteral(", "));
}

struct Terminal {
    int channel = 0;
    bool isAnalog = false;
};

/// Parses "DI3", "CO0", "AI1" ...
/// direction  'I' or 'O'
/// Returns    the channel as in InputChange or OutputChange; 0 or 1 for an analog input
std::optional<Terminal> terminalIn(const QString& text, char direction) {
    constexpr int kLetters = 2;
    bool ok = false;
    const int pin = text.mid(kLetters).toInt(&ok);
    if (!ok || text.size() != kLetters + 1 || text.at(1) != QLatin1Char(direction)) {
        return std::nullopt;
    }
    using project::IoGroup;
    const auto digital = [pin](IoGroup group) {
        return pin < project::pinCount(group) ? std::optional(Terminal{project::channelOf(group, pin), false})
                                              : std::nullopt;
    };
    switch (text.at(0).toLatin1()) {
        case 'D':
            return digital(IoGroup::Standard);
        case 'C':
            return digital(IoGroup::Configurable);
        case 'T':
            return digital(IoGroup::Tool);
        case 'A':
            return pin < 2 ? std::optional(Terminal{direction == 'O' ? kFirstAnalogOutput + pin : pin, true})
                           : std::nullopt;
        default:
            return std::nullopt;
    }
}

/// Reads one file. Each invalid value is reported as a problem with its position and replaced by a harmless
/// default.
class TestFileReader {
public:
    ReadTestFile read(const QString& path) {
        result_.file.path = path;
        const Result<QByteArray> bytes = readWholeFile(path, kMaxTestFileBytes);
        if (!bytes) {
            report({}, bytes.error().controllerMessage.isEmpty() ? bytes.error().context
                                                                 : bytes.error().controllerMessage);
            return std::move(result_);
        }
        QJsonParseError error;
        const QJsonDocument json = QJsonDocument::fromJson(*bytes, &error);
        if (error.error != QJsonParseError::NoError) {
            report(placeInText(*bytes, error.offset), error.errorString());
        } else if (!json.isObject()) {
            report({}, QStringLiteral("is not a test file: the file must contain one object"));
        } else {
            readRoot(json.object());
        }
        return std::move(result_);
    }

private:
    void report(const QString& place, const QString& text) { result_.problems.append({place, text}); }

    // ---- values -----------------------------------------------------------------------------------------

    void checkKeys(const QString& place, const QJsonObject& object, std::initializer_list<const char*> keys) {
        QStringList known;
        for (const char* key : keys) {
            known.append(QLatin1String(key));
        }
        for (const QString& key : object.keys()) {
            if (!known.contains(key)) {
                report(fieldOf(place, key),
                       QStringLiteral("is not a known field; use one of %1").arg(listOf(known)));
            }
        }
    }
    QJsonObject object(const QString& place, const QJsonValue& value) {
        if (!value.isObject()) {
            report(place, QStringLiteral("must be an object"));
        }
        return value.toObject();
    }
    QJsonArray list(const QString& place, const QJsonValue& value) {
        if (!value.isArray() && !value.isUndefined()) {
            report(place, QStringLiteral("must be a list"));
        }
        return value.toArray();
    }
    QString text(const QString& place, const QJsonValue& value) {
        if (!value.isString() || value.toString().isEmpty()) {
            report(place, value.isUndefined() ? QStringLiteral("is missing")
                                              : QStringLiteral("must be a non-empty string"));
        }
        return value.toString();
    }
    double number(const QString& place, const QJsonValue& value, double minimum, double maximum) {
        const double number = value.toDouble(std::numeric_limits<double>::quiet_NaN());
        if (number >= minimum && number <= maximum) {
            return number;
        }
        report(place, value.isUndefined()
                          ? QStringLiteral("is missing")
                          : QStringLiteral("must be a number from %1 to %2").arg(minimum).arg(maximum));
        return minimum;
    }
    double numberOr(const QString& place, const QJsonValue& value, double initial, double minimum,
                    double maximum) {
        return value.isUndefined() ? initial : number(place, value, minimum, maximum);
    }
    int whole(const QString& place, const QJsonValue& value, int minimum, int maximum) {
        const double read = number(place, value, minimum, maximum);
        if (read != std::floor(read)) {
            report(place, QStringLiteral("must be a whole number"));
        }
        return static_cast<int>(read);
    }
    /// Returns the index of the string in `words`.
    int word(const QString& place, const QJsonValue& value, std::initializer_list<const char*> words) {
        QStringList known;
        for (const char* each : words) {
            known.append(QLatin1String(each));
        }
        const auto index = known.indexOf(value.toString());
        if (index < 0) {
            report(place, QStringLiteral("must be one of %1").arg(listOf(known)));
        }
        return static_cast<int>(std::max<qsizetype>(index, 0));
    }
    template <std::size_t count>
    std::array<double, count> numbers(const QString& place, const QJsonValue& value, double maximum) {
        std::array<double, count> read{};
        const QJsonArray items = value.toArray();
        if (items.size() != static_cast<qsizetype>(count)) {
            report(place, QStringLiteral("must be a list of %1 numbers").arg(count));
            return read;
        }
        for (std::size_t i = 0; i < count; ++i) {
            const auto index = static_cast<qsizetype>(i);
            read[i] = number(itemOf(place, index), items.at(index), -maximum, maximum);
        }
        return read;
    }
    ExpectedRange range(const QString& place, const QJsonObject& object) {
        ExpectedRange range;
        range.minimum = numberOr(fieldOf(place, "min"), object.value("min"), range.minimum, 0, kMaxTime);
        range.maximum = numberOr(fieldOf(place, "max"), object.value("max"), range.maximum, 0, kMaxTime);
        if (range.minimum > range.maximum) {
            report(place, QStringLiteral("\"min\" must not be larger than \"max\""));
        }
        return range;
    }
    static bool hasRange(const QJsonObject& object) {
        return object.contains("min") || object.contains("max");
    }

    // ---- references -------------------------------------------------------------------------------------

    const project::Project& project() const { return *result_.file.project; }
    const ProgramScript& script() const { return result_.file.programs[program_].script; }

    /// Returns the number of a step, given by its number or ID.
    int step(const QString& place, const QJsonValue& value) {
        const int last = static_cast<int>(script().steps.size());
        int found = value.isString() ? script().numberOf(QUuid(value.toString())) : 0;
        if (value.isDouble() && value.toDouble() == std::floor(value.toDouble()) &&
            value.toDouble() <= last) {
            found = value.toInt();
        }
        if (found < 1) {
            report(place,
                   value.isUndefined()
                       ? QStringLiteral("is missing")
                       : QStringLiteral("must be a step of the program: a number from 1 to %1, or an id")
                             .arg(last));
        }
        return std::max(found, 1);
    }
    const project::Waypoint* waypoint(const QString& place, const QJsonValue& value) {
        const int index = project().waypoints.indexOfName(text(place, value));
        if (index >= 0) {
            return &project().waypoints.at(index);
        }
        if (value.isString()) {
            report(place, QStringLiteral("the project has no waypoint \"%1\"").arg(value.toString()));
        }
        return nullptr;
    }
    std::size_t program(const QString& place, const QJsonValue& value) {
        const project::ProgramList& programs = project().programs;
        QStringList names;
        for (const project::Program& each : programs) {
            names.append(each.name);
        }
        const project::Program* found = nullptr;
        if (value.isUndefined() && programs.size() == 1) {
            found = &programs.at(0);
        } else if (value.isUndefined()) {
            report(place, QStringLiteral("is missing; the project has the programs: %1").arg(listOf(names)));
        } else if (found = programs.findByName(text(place, value)); found == nullptr) {
            report(place, QStringLiteral("the project has no program \"%1\"; it has: %2")
                              .arg(value.toString(), listOf(names)));
        }
        if (found == nullptr) {
            return 0;
        }
        std::vector<TestedProgram>& known = result_.file.programs;
        for (std::size_t i = 0; i < known.size(); ++i) {
            if (known[i].id == found->id) {
                return i;
            }
        }
        known.push_back({found->id, found->name, writeScript(project(), found->id)});
        return known.size() - 1;
    }

    // ---- the file ---------------------------------------------------------------------------------------

    void readRoot(const QJsonObject& root) {
        if (root.value("format").toString() != QLatin1String("tiller-test")) {
            report(QStringLiteral("format"), QStringLiteral("must be \"tiller-test\""));
            return;
        }
        const int version = whole(QStringLiteral("version"), root.value("version"), 1, kMaxRuns);
        if (version > kTestFileVersion) {
            report(QStringLiteral("version"), QStringLiteral("is %1; this version of Tiller reads versions "
                                                             "up to %2. Install a newer version of Tiller")
                                                  .arg(version)
                                                  .arg(kTestFileVersion));
            return;
        }
        checkKeys({}, root, {"format", "version", "project", "program", "tests", "note"});
        const QString projectName = text(QStringLiteral("project"), root.value("project"));
        const QJsonArray tests = root.value("tests").toArray();
        if (tests.isEmpty()) {
            report(QStringLiteral("tests"), QStringLiteral("must be a list of at least one test"));
        }
        if (!result_.problems.isEmpty()) {
            return;
        }
        result_.file.projectPath = QDir::cleanPath(QFileInfo(result_.file.path).dir().filePath(projectName));
        auto loaded = project::loadProject(result_.file.projectPath);
        if (!loaded) {
            report(QStringLiteral("project"), loaded.error().toString());
            return;
        }
        result_.file.project = std::make_shared<const project::Project>(std::move(*loaded));
        QSet<QString> names;
        for (qsizetype i = 0; i < tests.size(); ++i) {
            const QString place = itemOf(QStringLiteral("tests"), i);
            readTest(place, object(place, tests.at(i)), root.value("program"));
            if (const QString name = tests.at(i).toObject().value("name").toString(); names.contains(name)) {
                report(fieldOf(place, "name"), QStringLiteral("another test has the same name"));
            } else {
                names.insert(name);
            }
        }
    }

    void readTest(const QString& place, const QJsonObject& object, const QJsonValue& program) {
        ProgramTest test;
        checkKeys(place, object,
                  {"name", "program", "start", "timeLimit", "operatorTime", "answers", "inputs", "faults",
                   "expect", "note"});
        test.name = text(fieldOf(place, "name"), object.value("name"));
        const bool hasOwn = object.contains("program");
        const qsizetype before = result_.problems.size();
        test.program = this->program(hasOwn ? fieldOf(place, "program") : QStringLiteral("program"),
                                     hasOwn ? object.value("program") : program);
        if (result_.problems.size() > before) {
            return;  // steps cannot be checked without a program
        }
        program_ = test.program;
        PreviewOptions& options = test.options;
        options.timeLimit = numberOr(fieldOf(place, "timeLimit"), object.value("timeLimit"),
                                     kDefaultTimeLimit, 0.001, kMaxTime);
        options.operatorTime = numberOr(fieldOf(place, "operatorTime"), object.value("operatorTime"),
                                        options.operatorTime, 0, kMaxTime);
        readStart(fieldOf(place, "start"), object.value("start"), options);
        options.answers = list(fieldOf(place, "answers"), object.value("answers"));
        for (qsizetype i = 0; i < options.answers.size(); ++i) {
            const QJsonValue answer = options.answers.at(i);
            if (!answer.isBool() && !answer.isDouble() && !answer.isString()) {
                report(itemOf(fieldOf(place, "answers"), i),
                       QStringLiteral("must be true, false, a number or a string"));
            }
        }
        readEvents(place, "inputs", object, test, &TestFileReader::input);
        readEvents(place, "faults", object, test, &TestFileReader::fault);
        readExpectations(fieldOf(place, "expect"), object.value("expect"), test);
        result_.file.tests.push_back(std::move(test));
    }

    void readStart(const QString& place, const QJsonValue& value, PreviewOptions& options) {
        if (value.isUndefined()) {
            return;
        }
        const QJsonObject start = object(place, value);
        checkKeys(place, start, {"waypoint", "joints"});
        if (start.contains("waypoint") == start.contains("joints")) {
            report(place, QStringLiteral("must have either \"waypoint\" or \"joints\""));
        } else if (start.contains("joints")) {
            constexpr double kMaxAngle = 4 * std::numbers::pi;  // larger values are probably in degrees
            const auto q = numbers<kJointCount>(fieldOf(place, "joints"), start.value("joints"), kMaxAngle);
            options.start = JointPositions(q);
        } else if (const project::Waypoint* point =
                       waypoint(fieldOf(place, "waypoint"), start.value("waypoint"))) {
            options.start = point->joints;
        }
    }

    void readEvents(const QString& place, const char* key, const QJsonObject& test, ProgramTest& into,
                    PreviewEvent (TestFileReader::*readOne)(const QString&, const QJsonObject&)) {
        const QString listPlace = fieldOf(place, QLatin1String(key));
        const QJsonArray items = list(listPlace, test.value(QLatin1String(key)));
        for (qsizetype i = 0; i < items.size(); ++i) {
            const QString at = itemOf(listPlace, i);
            const QJsonObject item = object(at, items.at(i));
            PreviewEvent event = (this->*readOne)(at, item);
            readTime(at, item, event);
            into.options.events.push_back(event);
            into.eventPlaces.push_back(itemOf(QLatin1String(key), i));
        }
    }

    void readTime(const QString& place, const QJsonObject& item, PreviewEvent& event) {
        if (!item.contains("step")) {
            event.time = numberOr(fieldOf(place, "at"), item.value("at"), 0, 0, kMaxTime);
            for (const char* key : {"run", "after"}) {
                if (item.contains(QLatin1String(key))) {
                    report(fieldOf(place, QLatin1String(key)), QStringLiteral("requires the field \"step\""));
                }
            }
            return;
        }
        if (item.contains("at")) {
            report(fieldOf(place, "at"), QStringLiteral("cannot be combined with \"step\"; use \"after\""));
        }
        event.step = step(fieldOf(place, "step"), item.value("step"));
        event.run = item.contains("run") ? whole(fieldOf(place, "run"), item.value("run"), 1, kMaxRuns) : 1;
        event.time = numberOr(fieldOf(place, "after"), item.value("after"), 0, 0, kMaxTime);
    }

    PreviewEvent input(const QString& place, const QJsonObject& item) {
        checkKeys(place, item, {"input", "hand", "value", "at", "step", "run", "after"});
        PreviewEvent event;
        if (item.contains("hand")) {
            event.kind = PreviewEvent::Kind::HandForce;
            const auto force = numbers<3>(fieldOf(place, "hand"), item.value("hand"), kMaxForce);
            event.force = {force[0], force[1], force[2]};
            if (item.contains("input")) {
                report(place, QStringLiteral("must have either \"input\" or \"hand\""));
            }
            return event;
        }
        const QString name = text(fieldOf(place, "input"), item.value("input"));
        const std::optional<Terminal> terminal = terminalIn(name, 'I');
        if (!terminal) {
            report(fieldOf(place, "input"),
                   QStringLiteral("must be one of DI0 to DI7, CI0 to CI7, TI0, TI1, AI0, AI1, not \"%1\"")
                       .arg(name));
            return event;
        }
        event.kind = terminal->isAnalog ? PreviewEvent::Kind::AnalogInput : PreviewEvent::Kind::DigitalInput;
        event.channel = terminal->channel;
        event.value = signal(fieldOf(place, "value"), item.value("value"), terminal->isAnalog);
        return event;
    }

    double signal(const QString& place, const QJsonValue& value, bool isAnalog) {
        if (isAnalog) {
            return number(place, value, 0, kMaxSignal);
        }
        if (!value.isBool()) {
            report(place, QStringLiteral("must be true or false"));
        }
        return value.toBool() ? 1 : 0;
    }

    PreviewEvent fault(const QString& place, const QJsonObject& item) {
        using Kind = PreviewEvent::Kind;
        checkKeys(place, item, {"fault", "at", "step", "run", "after"});
        constexpr Kind kinds[] = {Kind::ProtectiveStop, Kind::OperatorStop, Kind::EmergencyStop,
                                  Kind::PowerLoss, Kind::LinkLoss};
        PreviewEvent event;
        event.kind =
            kinds[word(fieldOf(place, "fault"), item.value("fault"),
                       {"protectiveStop", "operatorStop", "emergencyStop", "powerLoss", "linkLoss"})];
        return event;
    }

    // ---- expectations -----------------------------------------------------------------------------------

    void readExpectations(const QString& place, const QJsonValue& value, ProgramTest& test) {
        TestExpectations& expected = test.expected;
        for (const PreviewEvent& event : test.options.events) {
            expected.allowsProtectiveStop =
                expected.allowsProtectiveStop || event.kind == PreviewEvent::Kind::ProtectiveStop;
        }
        if (value.isUndefined()) {
            return;
        }
        const QJsonObject expect = object(place, value);
        checkKeys(place, expect,
                  {"end", "step", "collisions", "protectiveStop", "pose", "clearance", "force", "duration",
                   "cycleTime", "outputs", "finalOutputs", "variables", "runs"});
        const auto at = [&place](const char* key) { return fieldOf(place, QLatin1String(key)); };
        if (expect.contains("end")) {
            constexpr Preview::End ends[] = {Preview::End::Completed, Preview::End::Failed,
                                             Preview::End::Stopped, Preview::End::Running};
            expected.end =
                ends[word(at("end"), expect.value("end"), {"completed", "failed", "stopped", "running"})];
        }
        if (expect.contains("step")) {
            expected.endStep = step(at("step"), expect.value("step"));
            if (expected.end == Preview::End::Completed) {
                report(at("step"),
                       QStringLiteral("requires \"end\" to be \"failed\", \"stopped\" or \"running\""));
            }
        }
        if (expect.contains("collisions")) {
            expected.allowsCollisions =
                word(at("collisions"), expect.value("collisions"), {"none", "allowed"}) == 1;
        }
        if (expect.contains("protectiveStop")) {
            expected.allowsProtectiveStop =
                word(at("protectiveStop"), expect.value("protectiveStop"), {"none", "allowed"}) == 1;
        }
        if (expect.contains("pose")) {
            readPose(at("pose"), object(at("pose"), expect.value("pose")), expected);
        }
        if (expect.contains("clearance")) {
            expected.clearance = number(at("clearance"), expect.value("clearance"), 0, kMaxLength);
            test.options.measuresClearance = true;
            if (project().cell.isEmpty()) {
                report(at("clearance"),
                       QStringLiteral("the project has no floor, planes or boxes; add them to its cell"));
            }
        }
        if (expect.contains("force")) {
            expected.force = number(at("force"), expect.value("force"), 0, kMaxForce);
        }
        if (expect.contains("duration")) {
            const QJsonObject duration = object(at("duration"), expect.value("duration"));
            checkKeys(at("duration"), duration, {"min", "max"});
            expected.duration = limitedRange(at("duration"), duration);
        }
        if (expect.contains("cycleTime")) {
            const QJsonObject cycle = object(at("cycleTime"), expect.value("cycleTime"));
            checkKeys(at("cycleTime"), cycle, {"step", "min", "max"});
            expected.cycle = {step(fieldOf(at("cycleTime"), "step"), cycle.value("step")),
                              limitedRange(at("cycleTime"), cycle)};
        }
        const QJsonArray outputs = list(at("outputs"), expect.value("outputs"));
        for (qsizetype i = 0; i < outputs.size(); ++i) {
            const QString itemPlace = itemOf(at("outputs"), i);
            const QJsonObject item = object(itemPlace, outputs.at(i));
            checkKeys(itemPlace, item, {"output", "value", "tolerance", "min", "max"});
            expected.outputs.push_back(output(fieldOf(itemPlace, "output"), item.value("output").toString(),
                                              fieldOf(itemPlace, "value"), item.value("value")));
            ExpectedOutput& read = expected.outputs.back();
            read.tolerance = numberOr(fieldOf(itemPlace, "tolerance"), item.value("tolerance"),
                                      read.tolerance, 0, kMaxSignal);
            read.time = range(itemPlace, item);
        }
        const QJsonObject finals = optionalObject(at("finalOutputs"), expect.value("finalOutputs"));
        for (auto each = finals.begin(); each != finals.end(); ++each) {
            const QString itemPlace = fieldOf(at("finalOutputs"), each.key());
            expected.finalOutputs.push_back(output(itemPlace, each.key(), itemPlace, each.value()));
        }
        readVariables(at("variables"), optionalObject(at("variables"), expect.value("variables")), test);
        const QJsonObject runs = optionalObject(at("runs"), expect.value("runs"));
        for (auto each = runs.begin(); each != runs.end(); ++each) {
            const QString itemPlace = fieldOf(at("runs"), each.key());
            bool isNumber = false;
            const int number = each.key().toInt(&isNumber);
            expected.runs.push_back({step(itemPlace, isNumber ? QJsonValue(number) : QJsonValue(each.key())),
                                     whole(itemPlace, each.value(), 0, kMaxRuns)});
        }
        std::sort(expected.runs.begin(), expected.runs.end(),
                  [](const ExpectedRuns& a, const ExpectedRuns& b) { return a.step < b.step; });
    }

    QJsonObject optionalObject(const QString& place, const QJsonValue& value) {
        return value.isUndefined() ? QJsonObject() : object(place, value);
    }

    ExpectedRange limitedRange(const QString& place, const QJsonObject& item) {
        if (!hasRange(item)) {
            report(place, QStringLiteral("must have \"min\", \"max\" or both"));
        }
        return range(place, item);
    }

    void readPose(const QString& place, const QJsonObject& item, TestExpectations& expected) {
        checkKeys(place, item, {"waypoint", "pose", "position", "rotation"});
        ExpectedPose pose;
        pose.position =
            numberOr(fieldOf(place, "position"), item.value("position"), pose.position, 0, kMaxLength);
        pose.rotation =
            numberOr(fieldOf(place, "rotation"), item.value("rotation"), pose.rotation, 0, std::numbers::pi);
        if (item.contains("waypoint") == item.contains("pose")) {
            report(place, QStringLiteral("must have either \"waypoint\" or \"pose\""));
        } else if (item.contains("pose")) {
            pose.pose = Pose::fromArray(numbers<6>(fieldOf(place, "pose"), item.value("pose"), kMaxLength));
        } else if (const project::Waypoint* point =
                       waypoint(fieldOf(place, "waypoint"), item.value("waypoint"))) {
            const std::optional<Pose> inBase = project::poseInBase(*point, project().frames);
            if (!inBase) {
                report(fieldOf(place, "waypoint"),
                       QStringLiteral("the frame of the waypoint is not in the project"));
            }
            pose.pose = inBase.value_or(Pose());
        }
        expected.pose = pose;
    }

    ExpectedOutput output(const QString& namePlace, const QString& name, const QString& valuePlace,
                          const QJsonValue& value) {
        ExpectedOutput read;
        read.name = name;
        const std::optional<Terminal> terminal = terminalIn(name, 'O');
        if (!terminal) {
            report(namePlace,
                   QStringLiteral("must be one of DO0 to DO7, CO0 to CO7, TO0, TO1, AO0, AO1, not \"%1\"")
                       .arg(name));
            return read;
        }
        read.channel = terminal->channel;
        read.tolerance = terminal->isAnalog ? kAnalogTolerance : 0;
        read.value = signal(valuePlace, value, terminal->isAnalog);
        return read;
    }

    void readVariables(const QString& place, const QJsonObject& variables, ProgramTest& test) {
        for (auto each = variables.begin(); each != variables.end(); ++each) {
            const QString at = fieldOf(place, each.key());
            ExpectedVariable variable;
            variable.name = each.key();
            variable.value = each.value();
            if (QString why; !isVariableName(each.key(), &why)) {
                report(at, why);
            }
            if (each.value().isObject()) {
                const QJsonObject item = each.value().toObject();
                checkKeys(at, item, {"value", "tolerance"});
                variable.value = item.value("value");
                variable.tolerance =
                    numberOr(fieldOf(at, "tolerance"), item.value("tolerance"), variable.tolerance, 0, 1e9);
            }
            const QJsonArray items = variable.value.toArray();
            const bool isList = variable.value.isArray() &&
                                std::all_of(items.begin(), items.end(), [](const QJsonValue& item) {
                                    return item.isDouble() || item.isBool() || item.isString();
                                });
            if (!variable.value.isDouble() && !variable.value.isBool() && !variable.value.isString() &&
                !isList) {
                report(at, QStringLiteral("must be a number, true, false, a string or a list of these"));
            }
            test.options.variables.push_back(variable.name.toStdString());
            test.expected.variables.push_back(std::move(variable));
        }
    }

    ReadTestFile result_;
    std::size_t program_ = 0;  ///< program of the current test
};

}  // namespace

ReadTestFile readTestFile(const QString& path) {
    return TestFileReader().read(path);
}

QString outputName(int channel) {
    constexpr int kConfigurable = 8;
    constexpr int kTool = 16;
    return channel < kConfigurable        ? QStringLiteral("DO%1").arg(channel)
           : channel < kTool              ? QStringLiteral("CO%1").arg(channel - kConfigurable)
           : channel < kFirstAnalogOutput ? QStringLiteral("TO%1").arg(channel - kTool)
                                          : QStringLiteral("AO%1").arg(channel - kFirstAnalogOutput);
}

}  // namespace tiller::program
