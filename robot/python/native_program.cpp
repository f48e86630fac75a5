// SPDX-License-Identifier: MIT
// Part of tiller._native: programs of a project. Fields of steps are passed as JSON.
#include <QFileInfo>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <algorithm>
#include <map>

#include "robot/kinematics/arm_kinematics.h"
#include "robot/python/native_objects.h"
#include "robot/station/program/execution/program_execution.h"
#include "robot/station/program/preview/preview.h"
#include "robot/station/program/program_edit.h"
#include "robot/station/program/recover/recovery_map.h"
#include "robot/station/program/recover/steps_not_reached.h"
#include "robot/station/program/step_kind.h"

namespace tiller::python {

namespace {

using program::ProgramExecution;

QString qText(const std::string& text) {
    return QString::fromStdString(text);
}

[[noreturn]] void refuse(const QString& context, const QString& why) {
    raise({ErrorCode::InvalidArgument, context, why});
}

QString quotedList(const QStringList& names) {
    return names.isEmpty() ? QStringLiteral("none") : '"' + names.join(QStringLiteral("\", \"")) + '"';
}

QUuid stepId(const std::string& text) {
    return QUuid(qText(text));
}

QString idText(const QUuid& id) {
    return id.toString(QUuid::WithoutBraces);
}

/// The value of a field: a name of an entity, a channel or a choice becomes the value in the file.
QJsonValue fieldValueOf(const project::Project& project, const program::StepField& field,
                        const QJsonValue& given) {
    const auto choices = program::choicesOf(project, field);
    if (!given.isString() || choices.empty()) {
        return given;
    }
    QStringList names;
    for (const auto& [value, name] : choices) {
        if (value == given || name == given.toString()) {
            return value;
        }
        names.append(name);
    }
    refuse(QLatin1String(field.key), QStringLiteral("\"%1\" does not exist. Possible values: %2")
                                         .arg(given.toString(), quotedList(names)));
}

QJsonObject fieldsOf(const project::Project& project, const program::StepKind& kind,
                     const std::string& json) {
    const QJsonObject given = QJsonDocument::fromJson(QByteArray::fromStdString(json)).object();
    const auto known = kind.fields();
    QJsonObject fields;
    for (auto it = given.begin(); it != given.end(); ++it) {
        const auto field = std::find_if(known.begin(), known.end(), [&](const auto& candidate) {
            return it.key() == QLatin1String(candidate.key);
        });
        if (field == known.end()) {
            QStringList keys;
            for (const program::StepField& candidate : known) {
                keys.append(QLatin1String(candidate.key));
            }
            refuse(
                QLatin1String(kind.id),
                QStringLiteral("no field \"%1\". Fields of this step: %2").arg(it.key(), quotedList(keys)));
        }
        fields.insert(it.key(), fieldValueOf(project, *field, it.value()));
    }
    return fields;
}

const program::StepKind& kindNamed(const std::string& id) {
    if (const program::StepKind* kind = program::findStepKind(qText(id))) {
        return *kind;
    }
    QStringList ids;
    for (const program::StepKind* kind : program::stepKinds()) {
        ids.append(QLatin1String(kind->id));
    }
    refuse(QStringLiteral("kind"),
           QStringLiteral("no step \"%1\". Steps: %2").arg(qText(id), quotedList(ids)));
}

const char* stateName(ProgramExecution::State state) {
    switch (state) {
        case ProgramExecution::State::Starting:
            return "starting";
        case ProgramExecution::State::Running:
            return "running";
        case ProgramExecution::State::Waiting:
            return "waiting";
        case ProgramExecution::State::Completed:
            return "completed";
        case ProgramExecution::State::Failed:
            return "failed";
        case ProgramExecution::State::Stopped:
            return "stopped";
    }
    return "";
}

/// Python type: (count, first start [s], total time [s]) for each step.
py::list timingList(const std::vector<program::StepTiming>& timings) {
    py::list list;
    for (const program::StepTiming& timing : timings) {
        list.append(py::make_tuple(timing.count, timing.first, timing.total));
    }
    return list;
}

const char* recoveryName(program::Recovery recovery) {
    switch (recovery) {
        case program::Recovery::NotReached:
            return "not_reached";
        case program::Recovery::Continue:
            return "continue";
        case program::Recovery::MoveBack:
            return "move_back";
        case program::Recovery::Unsafe:
            return "unsafe";
    }
    return "";
}

/// The value of a variable as a Python object. A list of other items than numbers is a string in URScript.
py::object valueOf(const script::ProgramVariable& variable) {
    using Type = script::ProgramVariable::Type;
    const QJsonValue value = program::jsonValue(variable);
    if (variable.type == Type::Whole) {
        return py::int_(value.toInteger());
    }
    switch (value.type()) {
        case QJsonValue::Bool:
            return py::bool_(value.toBool());
        case QJsonValue::Double:
            return py::float_(value.toDouble());
        case QJsonValue::String:
            return string(value.toString());
        case QJsonValue::Array: {
            py::list list;
            const QJsonArray numbers = value.toArray();
            for (const QJsonValue& number : numbers) {
                list.append(number.toDouble());
            }
            return list;
        }
        default:
            return py::none();
    }
}

/// Runs a simulation without the interpreter lock. Ctrl+C ends it.
template <class Call>
auto simulated(Call call) {
    refuseInCallback();
    auto result = [&] {
        const GilReleased released;
        return call();
    }();
    if (PyErr_Occurred() != nullptr) {
        throw py::error_already_set();
    }
    return result;
}

/// A running program and the receiver of its samples.
struct RunParts {
    std::shared_ptr<NativeReceiver> receiver;
    ProgramExecution execution;
};

/// The handle of a running program. NativeController also keeps the program, which continues without its
/// handle.
class NativeRun {
public:
    NativeRun(std::shared_ptr<NativeController> controller, std::shared_ptr<ProgramExecution> execution)
        : controller_(std::move(controller)), execution_(std::move(execution)) {}

    py::dict status() const {
        const ProgramExecution::Status now = execution().status();
        py::dict result;
        result["state"] = stateName(now.state);
        result["step"] = now.step;
        result["last_step"] = now.lastStep;
        result["failed_step"] = now.failedStep;
        result["paused"] = now.isPaused;
        result["seconds"] = now.seconds;
        result["timings"] = timingList(now.timings);
        return result;
    }
    /// Python type: (name, value, is a pose) for each variable.
    py::list variables() const {
        py::list list;
        for (const script::ProgramVariable& variable : execution().variables()) {
            list.append(py::make_tuple(string(variable.name), valueOf(variable),
                                       variable.type == script::ProgramVariable::Type::Pose));
        }
        return list;
    }
    void setVariable(const std::string& name, const std::string& text, const Seconds& seconds) const {
        waited(seconds, [&run = execution(), name = qText(name), text = qText(text)](
                            const Deadline& deadline) { return run.changeVariable(name, text, deadline); });
    }
    void wait(const Seconds& seconds) const {
        waited(seconds, [&run = execution()](const Deadline& deadline) { return run.wait(deadline); });
    }
    ProgramExecution& execution() const {
        refuseOfParent(*controller_);
        return *execution_;
    }
    /// No effect in a forked child.
    void stop() const {
        if (controller_->isOwn()) {
            execution_->stop();
        }
    }

private:
    std::shared_ptr<NativeController> controller_;  // must outlive the program
    std::shared_ptr<ProgramExecution> execution_;
};

class NativeProgram {
public:
    NativeProgram(const std::string& name, const std::string& model) {
        project_.robot = modelNamed(model);
        project::Program program;
        program.id = QUuid::createUuid();
        program.name = qText(name);
        program_ = program.id;
        project_.programs.append(std::move(program));
    }

    static std::unique_ptr<NativeProgram> open(const std::string& path,
                                               const std::optional<std::string>& name) {
        const project::OpenedProject opened = taken(project::openProject(qText(path)));
        const project::ProgramList& programs = opened.document.programs;
        const project::Program* chosen = !name && programs.size() == 1 ? &programs.at(0)
                                         : name                        ? programs.findByName(qText(*name))
                                                                       : nullptr;
        if (chosen == nullptr) {
            QStringList names;
            for (const project::Program& program : programs) {
                names.append(program.name);
            }
            refuse(
                QStringLiteral("name"),
                QStringLiteral("select one of the programs of %1: %2").arg(qText(path), quotedList(names)));
        }
        auto program = std::make_unique<NativeProgram>(opened, chosen->id);
        program->path_ = QFileInfo(qText(path)).absoluteFilePath();
        return program;
    }
    NativeProgram(const project::OpenedProject& opened, const QUuid& program)
        : project_(opened.document), program_(program), fingerprint_(opened.fingerprint) {}

    void save(const std::string& path) {
        const QString file = QFileInfo(qText(path)).absoluteFilePath();
        QList<QByteArray> known;
        if (file == path_) {
            known.append(fingerprint_);
        }
        const project::SaveReport report = taken(project::saveProject(file, project_, known));
        if (report.changedByOther) {
            raise({ErrorCode::FileNotWritable, file,
                   QStringLiteral("the file exists, or another program has changed it. Save the project to a "
                                  "new file")});
        }
        path_ = file;
        fingerprint_ = report.fingerprint;
    }

    py::str name() const { return string(current().name); }

    void addWaypoint(const std::string& name, const Six& q, const Six& tcp, double blend) {
        if (project_.waypoints.indexOfName(qText(name)) >= 0) {
            refuse(QStringLiteral("name"),
                   QStringLiteral("the project already has a waypoint \"%1\"").arg(qText(name)));
        }
        project::Waypoint point;
        point.id = QUuid::createUuid();
        point.name = qText(name);
        point.joints = JointPositions(q);
        point.tcpOffset = Pose::fromArray(tcp);
        point.pose = kinematics::forwardTcp(robotModel(*project_.robot).dh, point.joints, point.tcpOffset);
        point.blend = blend;
        project_.waypoints.append(point);
    }

    std::vector<std::string> waypoints() const {
        std::vector<std::string> names;
        for (const project::Waypoint& point : project_.waypoints) {
            names.push_back(point.name.toStdString());
        }
        return names;
    }

    std::string addStep(const std::string& kindId, const std::string& fields,
                        const std::optional<std::string>& section, bool disabled) {
        const program::StepKind& kind = kindNamed(kindId);
        project::ProgramStep step = program::newStep(kind);
        const QJsonObject given = fieldsOf(project_, kind, fields);
        for (auto it = given.begin(); it != given.end(); ++it) {
            step.fields.insert(it.key(), it.value());
        }
        step.disabled = disabled;
        const project::Program before = current();
        program::StepPosition at;
        if (section) {
            const project::ProgramStep* found = program::findStep(before.steps, stepId(*section));
            if (found == nullptr) {
                refuse(QStringLiteral("inside"), QStringLiteral("the program does not contain this step"));
            }
            at = {found->id, static_cast<int>(found->steps.size())};
        } else {
            at.row = static_cast<int>(before.steps.size());
        }
        const project::Program after = program::withSteps(before, at, {step});
        if (after == before) {
            refuse(QStringLiteral("inside"),
                   QStringLiteral("this step cannot contain steps, or the steps are nested too deeply"));
        }
        replace(after);
        return idText(step.id).toStdString();
    }

    void setFields(const std::string& id, const std::string& fields) {
        const project::ProgramStep& step = stepOf(id);
        const QJsonObject given = fieldsOf(project_, kindNamed(step.kind.toStdString()), fields);
        project::Program changed = current();
        for (auto it = given.begin(); it != given.end(); ++it) {
            changed =
                program::withField(std::move(changed), stepId(id), it.key(),
                                   it.value().isNull() ? QJsonValue(QJsonValue::Undefined) : it.value());
        }
        replace(changed);
    }

    void removeStep(const std::string& id) {
        stepOf(id);
        replace(program::withoutSteps(current(), {stepId(id)}));
    }

    /// Python type: (id, kind, name, depth, disabled, JSON object of the fields) for each step, in the order
    /// of the step numbers.
    py::list steps() const {
        py::list list;
        addSteps(current().steps, 0, list);
        return list;
    }

    /// Python type: (step number, step ID, field, text).
    py::list problems() const {
        py::list list;
        for (const program::ProgramProblem& problem : program::writeScript(project_, program_).problems) {
            list.append(py::make_tuple(problem.number, idText(problem.step).toStdString(),
                                       string(problem.field), string(problem.text)));
        }
        return list;
    }

    py::str script() const { return string(validScript({}).text); }

    py::dict preview(const std::optional<Six>& start, const std::optional<std::string>& from,
                     const std::vector<std::tuple<double, int, bool>>& inputs, double timeLimit,
                     double sampleInterval) const {
        const program::ScriptOptions options = optionsFrom(from);
        const program::ProgramScript script = validScript(options);
        const program::PreviewOptions given = previewOptions(start, inputs, timeLimit, sampleInterval);
        const program::Preview preview =
            simulated([&] { return program::previewProgram(project_, script, options, given); });
        py::list findings;
        for (const program::Finding& finding : preview.findings) {
            findings.append(
                py::make_tuple(toString(finding.kind), finding.step, finding.time, string(finding.text)));
        }
        const auto rows = static_cast<py::ssize_t>(preview.path.size());
        py::array_t<double> path({rows, py::ssize_t{14}});
        auto numbers = path.mutable_unchecked<2>();
        for (py::ssize_t row = 0; row < rows; ++row) {
            const program::PathSample& sample = preview.path[static_cast<std::size_t>(row)];
            numbers(row, 0) = sample.time;
            numbers(row, 1) = sample.step;
            for (py::ssize_t i = 0; i < 6; ++i) {
                numbers(row, 2 + i) = sample.q.array()[static_cast<std::size_t>(i)];
                numbers(row, 8 + i) = sample.tcp.array()[static_cast<std::size_t>(i)];
            }
        }
        const auto array = [](const Six& six) { return py::array_t<double>(6, six.data()); };
        py::dict result;
        result["completed"] = preview.completed;
        result["endless"] = preview.isEndless;
        result["duration"] = preview.duration;
        result["findings"] = findings;
        result["timings"] = timingList(preview.timings);
        result["names"] = names(script);
        result["path"] = path;
        result["end_q"] = array(preview.endJoints.array());
        result["end_pose"] = array(preview.endPose.array());
        result["outputs"] = preview.outputs;
        return result;
    }

    /// Python type: (step number, name, number of the step to continue from, [(mark, reason) for each kind of
    /// stop], reason why the step was not checked).
    py::list recoverability(const std::vector<std::tuple<double, int, bool>>& inputs,
                            double timeLimit) const {
        const program::ProgramScript script = validScript({});
        program::RecoveryOptions options;
        options.preview = previewOptions({}, inputs, timeLimit, program::PreviewOptions().sampleInterval);
        const program::RecoveryMap map =
            simulated([&] { return program::checkRecovery(project_, program_, script, {}, options); });
        if (!map.isComplete) {
            raise({ErrorCode::ScriptError, QStringLiteral("check recoverability"),
                   QStringLiteral("the simulated program did not complete. Preview the program first")});
        }
        const QStringList stepNames = nameList(script);
        std::map<int, QString> unchecked;
        for (const program::UncheckedStep& step : program::uncheckedSteps(project_, script, map)) {
            unchecked[step.number] = step.reason;
        }
        py::list list;
        for (std::size_t i = 0; i < map.steps.size(); ++i) {
            py::list marks;
            for (const program::StopKind kind : program::kStopKinds) {
                const program::StopMark& mark = map.steps[i].of(kind);
                marks.append(py::make_tuple(recoveryName(mark.recovery), string(mark.reason)));
            }
            list.append(py::make_tuple(i + 1, string(stepNames[static_cast<qsizetype>(i)]), map.steps[i].from,
                                       marks, string(unchecked[static_cast<int>(i) + 1])));
        }
        return list;
    }

    std::unique_ptr<NativeRun> start(const std::shared_ptr<NativeController>& controller,
                                     const std::shared_ptr<NativeReceiver>& receiver,
                                     const std::optional<std::string>& from,
                                     const std::vector<std::string>& breakpoints, std::uint64_t stops) const {
        refuseInCallback();
        refuseOfParent(*controller);
        refuseWhileRunning(*controller);  // first, because a program runs instead of the control program
        if (!controller->controller.status().inControl) {
            raise({ErrorCode::NotInControl, QStringLiteral("start the program"),
                   QStringLiteral("call take_control() first")});
        }
        program::ScriptOptions options = optionsFrom(from);
        options.version = receiver->receiver.version();
        const program::PreviewOptions given = previewOptions({}, {}, program::PreviewOptions().timeLimit,
                                                             program::PreviewOptions().sampleInterval);
        const receive::Sample sample = receiver->receiver.latest();
        const program::CheckedProgram checked =
            simulated([&] { return program::checkForRobot(project_, program_, options, given, sample); });
        if (!checked.obstacles.isEmpty()) {
            refuse(QStringLiteral("start the program"), checked.obstacles.join(QLatin1Char('\n')));
        }
        QSet<QUuid> pauses;
        for (const std::string& step : breakpoints) {
            if (!checked.script.canPauseBefore(stepId(step))) {
                refuse(QStringLiteral("breakpoints"),
                       QStringLiteral("the program cannot pause before the step %1").arg(qText(step)));
            }
            pauses.insert(stepId(step));
        }
        refuseWhileRunning(*controller);  // another thread may have started a program during the simulation
        const std::shared_ptr<RunParts> parts(
            new RunParts{receiver, ProgramExecution(controller->controller, receiver->receiver.subscribe(),
                                                    checked, pauses, stops)});
        const std::shared_ptr<ProgramExecution> execution(parts, &parts->execution);
        controller->setRun(execution);
        return std::make_unique<NativeRun>(controller, execution);
    }

    py::list names() const { return names(program::writeScript(project_, program_)); }

private:
    const project::Program& current() const { return *project_.programs.find(program_); }
    static void refuseWhileRunning(const NativeController& controller) {
        if (const auto run = controller.run(); run && run->isActive()) {
            refuse(QStringLiteral("start the program"),
                   QStringLiteral("a program of this robot is running. Stop it first"));
        }
    }
    void replace(const project::Program& changed) {
        project_.programs.replace(static_cast<std::size_t>(project_.programs.indexOf(program_)), changed);
    }
    const project::ProgramStep& stepOf(const std::string& id) const {
        const project::ProgramStep* step = program::findStep(current().steps, stepId(id));
        if (step == nullptr) {
            refuse(QStringLiteral("step"), QStringLiteral("the program does not contain this step"));
        }
        return *step;
    }
    static void addSteps(const program::Steps& steps, int depth, py::list& list) {
        for (const project::ProgramStep& step : steps) {
            list.append(py::make_tuple(
                idText(step.id).toStdString(), string(step.kind), string(program::kindName(step)), depth,
                step.disabled, QJsonDocument(step.fields).toJson(QJsonDocument::Compact).toStdString()));
            addSteps(step.steps, depth + 1, list);
        }
    }
    QStringList nameList(const program::ProgramScript& script) const {
        QStringList list;
        for (int number = 1; number <= static_cast<int>(script.steps.size()); ++number) {
            list.append(program::stepName(project_, script, number));
        }
        return list;
    }
    py::list names(const program::ProgramScript& script) const {
        py::list list;
        for (const QString& name : nameList(script)) {
            list.append(string(name));
        }
        return list;
    }
    program::ScriptOptions optionsFrom(const std::optional<std::string>& from) const {
        program::ScriptOptions options;
        options.from = from ? stepOf(*from).id : QUuid();
        return options;
    }
    program::ProgramScript validScript(const program::ScriptOptions& options) const {
        program::ProgramScript script = program::writeScript(project_, program_, options);
        if (!script.ok()) {
            QStringList texts;
            for (const program::ProgramProblem& problem : script.problems) {
                texts.append(problem.number > 0
                                 ? QStringLiteral("step %1 (%2): %3")
                                       .arg(problem.number)
                                       .arg(program::stepName(project_, script, problem.number), problem.text)
                                 : problem.text);
            }
            refuse(current().name, texts.join(QLatin1Char('\n')));
        }
        return script;
    }
    static program::PreviewOptions previewOptions(const std::optional<Six>& start,
                                                  const std::vector<std::tuple<double, int, bool>>& inputs,
                                                  double timeLimit, double sampleInterval) {
        program::PreviewOptions options;
        if (start) {
            options.start = JointPositions(*start);
        }
        for (const auto& [time, channel, value] : inputs) {
            options.inputs.push_back({time, channel, value});
        }
        options.timeLimit = timeLimit;
        options.sampleInterval = sampleInterval;
        options.isCancelled = [] { return isInterrupted(); };
        return options;
    }
    project::Project project_;
    QUuid program_;
    QString path_;  ///< path of the project file; empty: not saved
    QByteArray fingerprint_;
};

/// Python type: (kind, name, contains steps, [(key, label, type of the value, minimum, maximum, choices)]).
py::list kindList() {
    using program::FieldType;
    py::list list;
    for (const program::StepKind* kind : program::stepKinds()) {
        py::list fields;
        for (const program::StepField& field : kind->fields()) {
            const char* type = "str";
            switch (field.type) {
                case FieldType::Number:
                    type = "float";
                    break;
                case FieldType::Whole:
                    type = "int";
                    break;
                case FieldType::Flag:
                    type = "bool";
                    break;
                case FieldType::DigitalInput:
                case FieldType::DigitalOutput:
                    type = "channel";
                    break;
                case FieldType::Expression:
                    type = "expression";
                    break;
                default:
                    break;
            }
            std::vector<std::string> choices;
            for (const program::Choice& choice : field.choices) {
                choices.emplace_back(choice.key);
            }
            fields.append(py::make_tuple(field.key, string(field.label), type, field.optional, field.minimum,
                                         field.maximum, choices));
        }
        list.append(py::make_tuple(kind->id, string(kind->name()), kind->isSection, fields));
    }
    return list;
}

}  // namespace

void defineProgram(py::module_& module) {
    py::class_<NativeRun>(module, "ProgramRun")
        .def("status", &NativeRun::status)
        .def("variables", &NativeRun::variables)
        .def("set_variable", &NativeRun::setVariable, py::arg("name"), py::arg("value"), py::arg("timeout"))
        .def("wait", &NativeRun::wait, py::arg("timeout"))
        .def("pause", [](const NativeRun& self) { self.execution().pause(); })
        .def("resume", [](const NativeRun& self) { self.execution().resume(); })
        .def("step_once", [](const NativeRun& self) { self.execution().stepOnce(); })
        .def("finish_cycle",
             [](const NativeRun& self, bool ends) { self.execution().setEndsWithCycle(ends); })
        .def("stop", &NativeRun::stop);
    py::class_<NativeProgram>(module, "Program")
        .def(py::init<const std::string&, const std::string&>(), py::arg("name"), py::arg("model"))
        .def_static("open", &NativeProgram::open, py::arg("path"), py::arg("name"))
        .def("save", &NativeProgram::save, py::arg("path"))
        .def("name", &NativeProgram::name)
        .def("names", py::overload_cast<>(&NativeProgram::names, py::const_))
        .def("add_waypoint", &NativeProgram::addWaypoint, py::arg("name"), py::arg("q"), py::arg("tcp"),
             py::arg("blend"))
        .def("waypoints", &NativeProgram::waypoints)
        .def("add_step", &NativeProgram::addStep, py::arg("kind"), py::arg("fields"), py::arg("section"),
             py::arg("disabled"))
        .def("set_fields", &NativeProgram::setFields, py::arg("step"), py::arg("fields"))
        .def("remove_step", &NativeProgram::removeStep, py::arg("step"))
        .def("steps", &NativeProgram::steps)
        .def("problems", &NativeProgram::problems)
        .def("script", &NativeProgram::script)
        .def("preview", &NativeProgram::preview, py::arg("start"), py::arg("from_step"), py::arg("inputs"),
             py::arg("time_limit"), py::arg("sample_interval"))
        .def("recoverability", &NativeProgram::recoverability, py::arg("inputs"), py::arg("time_limit"))
        .def("start", &NativeProgram::start, py::arg("controller"), py::arg("receiver"), py::arg("from_step"),
             py::arg("breakpoints"), py::arg("stops"));
    module.def("step_kinds", &kindList);
    module.def("execution_fields", &program::executionFields);
}

}  // namespace tiller::python
