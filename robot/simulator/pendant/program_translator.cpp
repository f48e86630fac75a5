// SPDX-License-Identifier: MIT
#include "robot/simulator/pendant/program_translator.h"

#include <QStringList>
#include <algorithm>
#include <cmath>
#include <utility>

#include "robot/simulator/pendant/urcaps.h"

namespace tiller::simulator::pendant {

namespace {

constexpr std::size_t kMaxSubPrograms = 1000;
constexpr double kMinCurrent = 0.004, kMaxCurrent = 0.020;  ///< range of analog terminals [A]
constexpr double kMaxVoltage = 10.0;                        ///< [V]
constexpr const char* kDefaultCase = "2147483647";          ///< value of the default case of a Switch

QString textOf(const XmlElement& node, const char* child) {
    const XmlElement* const found = node.target(child);
    return found == nullptr ? QString() : found->text.trimmed();
}

bool isElse(const XmlElement& node) {
    return node.attribute("type") == QLatin1String("Else");
}

bool continuesIf(const XmlElement& node) {
    return node.is("If") && (isElse(node) || node.attribute("type") == QLatin1String("ElseIf"));
}

/// Branches that are stored as children of an If instead of after it, without the branches of nested Ifs.
std::vector<const XmlElement*> branchesBelow(const XmlElement& node, const Translation& t) {
    std::vector<const XmlElement*> branches;
    const XmlElement* const children = node.child("children");
    bool isOpen = false;
    for (std::size_t i = 0; children != nullptr && i < children->children.size(); ++i) {
        const XmlElement& child = t.nodeAt(*children->children[i]);
        if (!isSuppressed(child) && !continuesIf(child)) {
            isOpen = child.is("If");
        } else if (!isSuppressed(child) && !isOpen) {
            branches.push_back(&child);
        }
    }
    return branches;
}

}  // namespace

ProgramTranslator::ProgramTranslator(const PendantSource& source, const Installation& installation)
    : source_(source)
    , t_(installation, source.software, source.isReserved)
    , x_(t_)
    , motion_(
          t_, x_, [this](const XmlElement& node) { writeChildren(node); }, source.keepsDisabled) {}

Result<PendantProgram> ProgramTranslator::translate(const XmlElement& root, const QString& name) {
    t_.out = &head_;
    const XmlElement* const parts = root.child("children");
    const XmlElement* const main = parts == nullptr ? nullptr : parts->child("MainProgram");
    if (root.name.contains(QLatin1String("ProgramRootNode"))) {
        t_.refuse(root, QStringLiteral("programs saved before PolyScope 3 are not simulated"));
    } else if (!root.is("URProgram")) {
        t_.refuse(root, QStringLiteral("this is not a program: the root element is not URProgram"));
    } else if (main == nullptr) {
        t_.refuse(root, QStringLiteral("the element MainProgram is missing"));
    }
    if (t_.refusal()) {
        return *t_.refusal();
    }
    t_.findPlaces(root);
    t_.numberNodes(*parts);
    const QString head = QStringLiteral("def %1():").arg(t_.uniqueName(name));
    writeInstallation();
    writeInitialValues(root, false);
    writeInitNode(*parts, *main);
    motion_.defineWaypoints(root);

    t_.out = &body_;
    writeBeforeStart(*parts);
    writeThreads(*parts);
    writeRepeated(*main, QStringLiteral("Robot Program"));
    writeSubPrograms(*parts);

    if (motion_.usesDirections()) {
        Motion::defineDirections(head_);
    }
    if (t_.refusal()) {
        return *t_.refusal();
    }
    PendantProgram program;
    ScriptText timers(1);
    t_.out = &timers;
    defineTimers();
    ScriptText whole;
    whole.line(head);
    for (const ScriptText* const part : {&timers, &head_, &functions_, &body_}) {
        whole.append(*part);
    }
    whole.line(QStringLiteral("end"));
    program.script = whole.text().toStdString();
    program.marks = whole.marks();
    program.unfinished = t_.unfinishedNode();
    return program;
}

// ---- beginning of a program -----------------------------------------------------------------------------

void ProgramTranslator::writeInstallation() {
    const Installation& installation = t_.installation;
    if (const auto tcp = installation.tcps.find(installation.activeTcp); tcp != installation.tcps.end()) {
        statement(QStringLiteral("set_tcp(p[%1])").arg(tcp->second));
    }
    if (installation.defaultPayload) {
        writePayload(*installation.defaultPayload);
    }
    for (int i = 0; i < 2 && !installation.file.isEmpty(); ++i) {
        const bool isVoltage = installation.analogOutputIsVoltage[static_cast<std::size_t>(i)];
        statement(QStringLiteral("set_analog_outputdomain(%1, %2)").arg(i).arg(isVoltage ? 1 : 0));
    }
    for (const QString& call : installation.setup) {
        if (!source_.hasFunction || source_.hasFunction(call.section('(', 0, 0))) {
            statement(call);
        }
    }
    for (const auto& [name, feature] : installation.features) {
        if (feature.isVariable) {
            statement(QStringLiteral("global %1 = p[%2]").arg(identifier(name), feature.pose));
        }
    }
    for (const auto& [name, value] : installation.variables) {
        statement(QStringLiteral("global %1 = %2").arg(identifier(name), value));
    }
    for (const auto& [name, signal] : installation.signals_) {
        statement(QStringLiteral("modbus_add_signal(%1, %2, %3, %4, %5, %6)")
                      .arg(quoted(signal.host))
                      .arg(signal.slave)
                      .arg(signal.address)
                      .arg(static_cast<int>(signal.type))
                      .arg(quoted(name), signal.sequential ? "True" : "False"));
        if (!signal.frequency.isEmpty()) {
            statement(QStringLiteral("modbus_set_signal_update_frequency(%1, %2)")
                          .arg(quoted(name), signal.frequency));
        }
        const bool isOutput = signal.type == ModbusSignal::Type::DigitalOutput ||
                              signal.type == ModbusSignal::Type::RegisterOutput;
        if (isOutput && !signal.runState.isEmpty()) {
            statement(QStringLiteral("modbus_set_runstate_dependent_choice(%1, %2)")
                          .arg(quoted(name), signal.runState));
        }
    }
}

void ProgramTranslator::writePayload(const Payload& payload) {
    const bool hasInertia = !payload.inertia.isEmpty() && !t_.software.isCb3() &&
                            (t_.software.major > 5 || t_.software.minor >= 10);
    const QString center =
        payload.centerOfGravity.isEmpty() ? QString() : QStringLiteral(", [%1]").arg(payload.centerOfGravity);
    statement(
        hasInertia && !center.isEmpty()
            ? QStringLiteral("set_target_payload(%1%2, [%3])").arg(payload.mass, center, payload.inertia)
            : QStringLiteral("set_payload(%1%2)").arg(payload.mass, center));
}

/// The initial value of a variable is stored at its first use in the program.
void ProgramTranslator::writeInitialValues(const XmlElement& element, bool suppressed) {
    for (const auto& child : element.children) {
        const bool off = suppressed || isSuppressed(*child);
        const XmlElement* const value = child->is("variable") || child->is("ProgramVariable")
                                            ? child->child("initializeExpression")
                                            : nullptr;
        if (value != nullptr && !value->children.empty() && child->has("name")) {
            const Translation::Reasons before = t_.reasons();
            const QString script = x_.of(*value).script;
            if (off && !before.refusal && t_.refusal()) {
                t_.restore(before);  // unsupported nodes are permitted in disabled parts
            } else {
                statement(QStringLiteral("global %1 = %2").arg(identifier(child->attribute("name")), script));
            }
        }
        writeInitialValues(*child, off);
    }
}

/// Writes the values of "Variables Setup", unless the program does not use them.
void ProgramTranslator::writeInitNode(const XmlElement& parts, const XmlElement& main) {
    const XmlElement* const init = parts.child("InitVariablesNode");
    const XmlElement* const variables = init == nullptr ? nullptr : init->child("variables");
    if (variables == nullptr || main.attribute("InitVariablesNode") == QLatin1String("false")) {
        return;
    }
    for (const auto& variable : variables->children) {
        const XmlElement* const value = variable->child("expression");
        const QString script = value == nullptr ? QString() : x_.of(*value).script.trimmed();
        if (!script.isEmpty()) {
            statement(QStringLiteral("global %1 = %2").arg(identifier(variable->attribute("name")), script));
        }
    }
}

void ProgramTranslator::defineTimers() {
    for (const QString& timer : timers_) {
        statement(QStringLiteral("global %1 = 0.0").arg(timer));
        statement(QStringLiteral("global %1_is_counting = False").arg(timer));
    }
    if (timers_.empty()) {
        return;
    }
    statement(QStringLiteral("thread tiller_timers():"));
    statement(QStringLiteral("  while True:"));
    for (const QString& timer : timers_) {
        statement(QStringLiteral("    if %1_is_counting:").arg(timer));
        statement(QStringLiteral("      %1 = %1 + get_steptime()").arg(timer));
        statement(QStringLiteral("    end"));
    }
    statement(QStringLiteral("    sync()"));
    statement(QStringLiteral("  end"));
    statement(QStringLiteral("end"));
    statement(QStringLiteral("run tiller_timers()"));
}

// ---- parts of a program ---------------------------------------------------------------------------------

void ProgramTranslator::writeBeforeStart(const XmlElement& parts) {
    for (const auto& part : parts.children) {
        if (part->is("SpecialSequence") && part->attribute("type") == QLatin1String("BeforeStart")) {
            t_.label(*part, QStringLiteral("BeforeStart"));
            writeChildren(*part);
        } else if (!part->is("MainProgram") && !part->is("Thread") && !part->is("Event") &&
                   !part->is("InitVariablesNode") && !part->is("SubProgram") && !part->is("Comment") &&
                   !isSuppressed(*part)) {
            t_.refuse(*part, QStringLiteral("this part of a program is not simulated"));
        } else if (isSuppressed(*part) || part->is("Comment")) {
            markOmitted(*part);
        }
    }
}

void ProgramTranslator::writeThreads(const XmlElement& parts) {
    for (const auto& part : parts.children) {
        if (part->is("Thread")) {
            const QString name = t_.uniqueName(part->attribute("name"));
            statement(QStringLiteral("thread %1():").arg(name));
            t_.out->indent();
            writeRepeated(*part, part->attribute("name"));
            t_.out->outdent();
            statement(QStringLiteral("end"));
            statement(QStringLiteral("threadId_%1 = run %1()").arg(name));
        }
    }
    writeEvents(parts);
}

/// One thread runs the nodes of the first event whose condition is true. While they run, no condition is
/// checked.
void ProgramTranslator::writeEvents(const XmlElement& parts) {
    struct Event {
        const XmlElement* node;
        QString condition;
        QString done;  ///< name of a variable; true: the event has run since its condition became true
    };
    std::vector<Event> events;
    for (const auto& part : parts.children) {
        if (part->is("Event")) {
            const QString number = QString::number(events.size() + 1);
            events.push_back({part.get(), x_.in(*part, "expression", QStringLiteral("the condition")).script,
                              t_.uniqueName(QStringLiteral("event_done_") + number)});
        }
    }
    if (events.empty()) {
        return;
    }
    const QString name = t_.uniqueName(QStringLiteral("EventThread"));
    statement(QStringLiteral("thread %1():").arg(name));
    t_.out->indent();
    for (const Event& event : events) {
        if (source_.eventNeedsEdge) {
            statement(QStringLiteral("%1 = False").arg(event.done));
        }
    }
    statement(QStringLiteral("while True:"));
    t_.out->indent();
    for (const Event& event : events) {
        if (source_.eventNeedsEdge) {
            statement(QStringLiteral("%1 = %1 and (%2)").arg(event.done, event.condition));
        }
    }
    bool isOpen = false;
    for (const Event& event : events) {
        const char* const word = std::exchange(isOpen, true) ? "elif" : "if";
        if (source_.eventNeedsEdge) {
            statement(QStringLiteral("%1 (not %2) and (%3):").arg(word, event.done, event.condition));
            statement(QStringLiteral("  %1 = True").arg(event.done));
        } else {
            statement(QStringLiteral("%1 (%2):").arg(word, event.condition));
        }
        writeBlock(*event.node);
    }
    statement(QStringLiteral("end"));
    statement(QStringLiteral("sync()"));
    t_.out->outdent();
    statement(QStringLiteral("end"));
    t_.out->outdent();
    statement(QStringLiteral("end"));
    statement(QStringLiteral("threadId_%1 = run %1()").arg(name));
}

/// Programs and threads restart at their end, unless the corresponding check box is cleared.
void ProgramTranslator::writeRepeated(const XmlElement& part, const QString& label) {
    if (part.attribute("runOnlyOnce") == QLatin1String("false")) {
        statement(QStringLiteral("while True:"));
        t_.out->indent();
        t_.label(part, label);
        t_.out->outdent();
        writeBlock(part);
        statement(QStringLiteral("end"));
    } else {
        t_.label(part, label);
        writeChildren(part);
    }
}

void ProgramTranslator::writeSubPrograms(const XmlElement& parts) {
    t_.out = &functions_;
    std::size_t written = 0;
    const auto writeCalled = [&] {
        // Writing a subprogram may add the subprograms that it calls to the list.
        for (; written < subPrograms_.size() && !t_.refusal(); ++written) {
            const SubProgram sub = subPrograms_[written];
            statement(QStringLiteral("def %1():").arg(sub.name));
            t_.out->indent();
            t_.label(*sub.node, sub.node->attribute("name"));
            t_.out->outdent();
            writeBlock(*sub.body);
            statement(QStringLiteral("end"));
        }
    };
    writeCalled();
    // Scripts may call the remaining subprograms. Subprograms that cannot be translated or are unfinished are
    // omitted, and calling them is an error.
    for (const auto& part : parts.children) {
        const XmlElement* const sub = part->is("SubProgram") ? part->resolved() : nullptr;
        if (sub == nullptr || subProgramOf_.contains(sub) || t_.refusal()) {
            continue;
        }
        const Translation::Reasons reasons = t_.reasons();
        const ScriptText before = functions_;
        addSubProgram(*sub);
        writeCalled();
        if (t_.refusal() || (t_.unfinishedNode() && !reasons.unfinished)) {
            t_.restore(reasons);
            functions_ = before;
            functions_.mark(NodeMark::Kind::Omitted, t_.numberOf(*sub),
                            QStringLiteral("this subprogram is not called and cannot be translated"));
            written = subPrograms_.size();
        }
    }
}

/// Returns the index of the subprogram in the list; empty if the subprogram is refused.
std::optional<std::size_t> ProgramTranslator::addSubProgram(const XmlElement& sub) {
    auto place = subProgramOf_.find(&sub);
    if (place == subProgramOf_.end()) {
        const XmlElement* const body = bodyOf(sub);
        if (body == nullptr) {
            return std::nullopt;
        }
        place = subProgramOf_.emplace(&sub, subPrograms_.size()).first;
        subPrograms_.push_back({t_.uniqueName(sub.attribute("name")), &sub, body});
    }
    return place->second;
}

/// A subprogram is either contained in the file or stored in a separate program file.
const XmlElement* ProgramTranslator::bodyOf(const XmlElement& subProgram) {
    if (subProgram.child("children") != nullptr) {
        return &subProgram;
    }
    for (const char* const element : {"programFile", "file"}) {
        if (const QString file = textOf(subProgram, element); !file.isEmpty()) {
            return mainOfFile(file, subProgram);
        }
    }
    return &subProgram;
}

const XmlElement* ProgramTranslator::mainOfFile(const QString& name, const XmlElement& at) {
    auto known = files_.find(name);
    if (known == files_.end()) {
        const std::optional<QByteArray> content = source_.files(name);
        Result<std::unique_ptr<XmlElement>> tree =
            content ? readPendantFile(*content)
                    : Result<std::unique_ptr<XmlElement>>(
                          Error{ErrorCode::FileNotReadable,
                                QStringLiteral("there is no file '%1' in the programs folder").arg(name),
                                {}});
        if (!tree) {
            t_.refuse(at, tree.error().context);
            return nullptr;
        }
        known = files_.emplace(name, std::move(*tree)).first;
        // The definitions of the file belong to the beginning of the program, not to the position of the
        // call.
        ScriptText* const here = std::exchange(t_.out, &head_);
        t_.findPlaces(*known->second);
        writeInitialValues(*known->second, false);
        motion_.defineWaypoints(*known->second);
        t_.out = here;
    }
    const XmlElement* const parts = known->second->child("children");
    const XmlElement* const main = parts == nullptr ? nullptr : parts->child("MainProgram");
    if (!known->second->is("URProgram") || main == nullptr) {
        t_.refuse(at, QStringLiteral("'%1' is not a program").arg(name));
        return nullptr;
    }
    return main;
}

// ---- nodes ----------------------------------------------------------------------------------------------

void ProgramTranslator::writeBlock(const XmlElement& node) {
    t_.out->indent();
    const int before = t_.out->statements();
    writeChildren(node);
    if (t_.out->statements() == before) {
        statement(QStringLiteral("sync()"));  // a block must contain a statement
    }
    t_.out->outdent();
}

void ProgramTranslator::writeChildren(const XmlElement& node) {
    const XmlElement* const children = node.child("children");
    if (children == nullptr) {
        return;
    }
    std::vector<const XmlElement*> branches;  // branches of an If that may be continued by the next child
    const auto finish = [&] {
        if (!branches.empty()) {
            writeBranches(std::exchange(branches, {}), 0);
        }
    };
    for (const auto& place : children->children) {
        const XmlElement& child = t_.nodeAt(*place);
        if (isSuppressed(child)) {
            if (source_.keepsDisabled) {
                finish();
                writeDisabled(child);
            }
            continue;
        }
        if (continuesIf(child)) {
            // In older files, branches are children of the If node, which has already written them.
            if (!branches.empty()) {
                branches.push_back(&child);
            } else if (!node.is("If")) {
                t_.refuse(child, QStringLiteral("there is no If before this branch"));
            }
            continue;
        }
        finish();
        if (child.is("If")) {
            branches = branchesBelow(child, t_);
            branches.insert(branches.begin(), &child);
        } else {
            writeNode(child);
        }
    }
    finish();
}

/// Marks a comment, or a disabled node in a place where only enabled nodes are translated.
void ProgramTranslator::markOmitted(const XmlElement& node) {
    if (node.is("Comment")) {
        t_.out->mark(NodeMark::Kind::Omitted, t_.numberOf(node),
                     QStringLiteral("comment: ") + node.attribute("comment"));
    } else {
        t_.out->mark(NodeMark::Kind::Omitted, t_.numberOf(node),
                     QStringLiteral("a disabled node is not imported at this position"));
    }
}

/// Translates a disabled node between marks. If a part of the node is unsupported or unfinished, the whole
/// node is replaced by a mark with the reason.
void ProgramTranslator::writeDisabled(const XmlElement& suppressed) {
    using Kind = NodeMark::Kind;
    const Translation::Reasons reasons = t_.reasons();
    const ScriptText before = *t_.out;
    const int number = t_.numberOf(suppressed);
    t_.out->mark(Kind::DisabledBegin, number);
    for (const auto& node : suppressed.children) {
        if (continuesIf(*node)) {
            t_.refuse(*node, QStringLiteral("a disabled branch of an If node is not simulated"));
        } else if (node->is("If")) {
            std::vector<const XmlElement*> branches = branchesBelow(*node, t_);
            branches.insert(branches.begin(), node.get());
            writeBranches(branches, 0);
        } else {
            writeNode(*node);
        }
    }
    const std::optional<Error> refusal = t_.refusal() ? t_.refusal() : t_.unfinishedNode();
    if (refusal && !reasons.refusal && !reasons.unfinished) {
        *t_.out = before;
        t_.restore(reasons);
        t_.out->mark(Kind::Omitted, number, refusal->context);
        return;
    }
    t_.out->setStatements(before.statements());
    t_.out->mark(Kind::DisabledEnd, number);
}

/// A continuously checked condition ends its child nodes when it becomes false. The next branch is then
/// evaluated.
void ProgramTranslator::writeBranches(const std::vector<const XmlElement*>& branches, std::size_t first) {
    const XmlElement& node = *branches[first];
    const bool hasNext = first + 1 < branches.size();
    if (isElse(node)) {
        t_.label(node, QStringLiteral("Else"));
        writeChildren(node);
        if (hasNext) {
            t_.refuse(*branches[first + 1], QStringLiteral("this branch follows an Else branch"));
        }
        return;
    }
    const Expression condition = x_.in(node, "expression", QStringLiteral("the condition"));
    t_.label(node, QStringLiteral("%1 %2").arg(first == 0 ? "If" : "ElseIf", condition.shown));
    const auto writeNext = [&] {
        t_.out->indent();
        const int before = t_.out->statements();
        writeBranches(branches, first + 1);
        if (t_.out->statements() == before) {
            statement(QStringLiteral("sync()"));
        }
        t_.out->outdent();
    };
    if (!node.isTrue("checkContinuously")) {
        statement(QStringLiteral("if (%1):").arg(condition.script));
        writeBlock(node);
        if (hasNext) {
            statement(QStringLiteral("else:"));
            writeNext();
        }
        statement(QStringLiteral("end"));
        return;
    }
    const QString name = t_.uniqueName(QStringLiteral("check_%1").arg(t_.nextNumber()));
    const QString state = name + "_state", handle = name + "_thread";  // 0 running, 1 done, 2 condition false
    statement(QStringLiteral("global %1 = 2").arg(state));
    statement(QStringLiteral("thread %1():").arg(name));
    writeBlock(node);
    statement(QStringLiteral("  %1 = 1").arg(state));
    statement(QStringLiteral("end"));
    statement(QStringLiteral("if (%1):").arg(condition.script));
    statement(QStringLiteral("  %1 = 0").arg(state));
    statement(QStringLiteral("  %1 = run %2()").arg(handle, name));
    statement(QStringLiteral("  while %1 == 0:").arg(state));
    statement(QStringLiteral("    if (%1):").arg(condition.script));
    statement(QStringLiteral("      sync()"));
    statement(QStringLiteral("    else:"));
    statement(QStringLiteral("      kill %1").arg(handle));
    statement(QStringLiteral("      %1 = 2").arg(state));
    statement(QStringLiteral("    end"));
    statement(QStringLiteral("  end"));
    statement(QStringLiteral("end"));
    if (hasNext) {
        statement(QStringLiteral("if %1 == 2:").arg(state));
        writeNext();
        statement(QStringLiteral("end"));
    }
}

void ProgramTranslator::writeNode(const XmlElement& node) {
    using Write = void (ProgramTranslator::*)(const XmlElement&);
    static const std::map<QString, Write> kNodes{
        {"Script", &ProgramTranslator::writeScript},
        {"Assignment", &ProgramTranslator::writeAssignment},
        {"Wait", &ProgramTranslator::writeWait},
        {"Set", &ProgramTranslator::writeSet},
        {"SetPayload", &ProgramTranslator::writeSetPayload},
        {"Loop", &ProgramTranslator::writeLoop},
        {"Switch", &ProgramTranslator::writeSwitch},
        {"Popup", &ProgramTranslator::writePopup},
        {"Timer", &ProgramTranslator::writeTimer},
        {"CallSubProgram", &ProgramTranslator::writeCall},
        {"Contributed", &ProgramTranslator::writeUrcap},
    };
    using WriteMotion = void (Motion::*)(const XmlElement&);
    static const std::map<QString, WriteMotion> kMotions{
        {"Move", &Motion::writeMove},
        {"Waypoint", &Motion::writeWaypoint},
        {"CircleMove", &Motion::writeCircle},
        {"gui.program.direction.MoveDirectionNode", &Motion::writeDirection},
        {"SafeHome", &Motion::writeHome},
        {"Force", &Motion::writeForce},
    };
    if (const auto found = kNodes.find(node.name); found != kNodes.end()) {
        (this->*found->second)(node);
    } else if (const auto motion = kMotions.find(node.name); motion != kMotions.end()) {
        (motion_.*motion->second)(node);
    } else if (node.is("Folder")) {
        t_.out->mark(NodeMark::Kind::FolderBegin, t_.numberOf(node), node.attribute("name"));
        t_.label(node, node.attribute("name"));
        writeChildren(node);
        t_.out->mark(NodeMark::Kind::FolderEnd, t_.numberOf(node));
    } else if (node.is("Halt")) {
        t_.label(node, QStringLiteral("Halt"));
        statement(QStringLiteral("halt"));
    } else if (node.is("Comment")) {
        t_.out->mark(NodeMark::Kind::Comment, t_.numberOf(node), node.attribute("comment"));
        const QString comment = node.attribute("comment");
        t_.label(node, comment.isEmpty() ? QStringLiteral("Comment") : '\'' + comment + '\'');
    } else if (node.is("Placeholder")) {
        t_.unfinished(node, QStringLiteral("this node is empty"));
    } else if (!node.is("Until")) {  // written with its direction or waypoint
        t_.refuse(node, QStringLiteral("this node is not simulated"));
    }
}

void ProgramTranslator::writeAssignment(const XmlElement& node) {
    const QString variable = x_.variable(node);
    if (node.attribute("valueSource") == QLatin1String("Operator")) {
        static const std::map<QString, const char*> kTypes{
            {"Boolean", "boolean"}, {"Integer", "integer"}, {"Float", "float"}, {"String", "string"}};
        const auto type = kTypes.find(node.attribute("valueType"));
        const QString message = node.attribute("message");
        if (type == kTypes.end()) {
            t_.refuse(
                node,
                QStringLiteral("a value of type '%1' is not simulated").arg(node.attribute("valueType")));
            return;
        }
        t_.label(node, variable + QChar(0x2254) + '\'' + message + '\'');
        statement(QStringLiteral("global %1 = request_%2_from_primary_client(%3)")
                      .arg(variable, QLatin1String(type->second), quoted(message)));
        return;
    }
    const Expression value = x_.in(node, "expression", QStringLiteral("the value"));
    t_.label(node, variable + QChar(0x2254) + value.shown);
    statement(QStringLiteral("global %1 = %2").arg(variable, value.script));
}

void ProgramTranslator::writeTimer(const XmlElement& node) {
    const QString timer = x_.variable(node);
    const QString action = node.attribute("action");
    t_.label(node, QStringLiteral("%1: %2").arg(timer, action));
    if (!timer.isEmpty() && std::ranges::find(timers_, timer) == timers_.end()) {
        timers_.push_back(timer);
    }
    if (action == QLatin1String("Start") || action == QLatin1String("Stop")) {
        statement(QStringLiteral("%1_is_counting = %2")
                      .arg(timer, action == QLatin1String("Start") ? "True" : "False"));
    } else if (action == QLatin1String("Reset")) {
        statement(QStringLiteral("%1 = 0.0").arg(timer));
    } else {
        t_.refuse(node, QStringLiteral("the action '%1' is not simulated").arg(action));
    }
}

void ProgramTranslator::writeScript(const XmlElement& node) {
    const XmlElement* const cached = node.target("cachedContents");
    const QString file = textOf(node, "file");
    QString text;
    if (cached != nullptr || !file.isEmpty()) {
        t_.label(node, QStringLiteral("Script: %1").arg(file.section('/', -1)));
        const std::optional<QByteArray> content =
            cached == nullptr ? source_.files(file) : std::optional(cached->text.toUtf8());
        if (!content) {
            t_.refuse(node, QStringLiteral("there is no file '%1' in the programs folder").arg(file));
            return;
        }
        text = QString::fromUtf8(*content);
    } else {
        const Expression line = x_.in(node, "expression", QStringLiteral("the script"));
        t_.label(node, line.shown);
        text = line.script;
    }
    for (const QString& line : text.split('\n')) {
        if (!line.trimmed().isEmpty()) {
            statement(line);
        }
    }
}

void ProgramTranslator::waitUntil(const QString& condition) {
    statement(QStringLiteral("while not(%1):").arg(condition));
    statement(QStringLiteral("  sync()"));
    statement(QStringLiteral("end"));
}

void ProgramTranslator::writeWait(const XmlElement& node) {
    const QString type = node.attribute("type");
    if (type == QLatin1String("Sleep")) {
        const QString seconds = numberList(textOf(node, "waitTime"), 1);
        t_.label(node, QStringLiteral("Wait: %1").arg(seconds));
        if (seconds.isEmpty() || seconds.toDouble() < 0) {
            t_.refuse(node, QStringLiteral("'%1' is not a valid wait time").arg(textOf(node, "waitTime")));
        }
        statement(QStringLiteral("sleep(%1)").arg(seconds));
    } else if (type == QLatin1String("DigitalInput")) {
        const Expressions::Signal signal = x_.signal(node);
        const QString value = textOf(node, "digitalValue");
        const bool high = value == QLatin1String("1") || value == QLatin1String("true");
        if (!high && value != QLatin1String("0") && value != QLatin1String("false")) {
            t_.unfinished(node, QStringLiteral("the value to wait for is missing"));
        }
        t_.label(node, QStringLiteral("Wait %1=%2").arg(signal.shown, high ? "HI" : "LO"));
        waitUntil(QStringLiteral("%1 == %2").arg(signal.read, high ? "True" : "False"));
    } else if (type == QLatin1String("AnalogInput")) {
        const Expressions::Signal signal = x_.signal(node);
        const QString value = numberList(textOf(node, "analogValue"), 1);
        const QString comparison = textOf(node, "analogComparison");
        const char* const sign = comparison == QLatin1String("0")   ? "<"
                                 : comparison == QLatin1String("1") ? ">"
                                                                    : nullptr;
        if (value.isEmpty() || sign == nullptr) {
            t_.refuse(node, QStringLiteral("this comparison of an analog input is not simulated"));
            return;
        }
        t_.label(node, QStringLiteral("Wait %1%2%3").arg(signal.shown, QLatin1String(sign), value));
        waitUntil(QStringLiteral("%1 %2 %3").arg(signal.read, QLatin1String(sign), value));
    } else if (type == QLatin1String("Condition")) {
        const Expression condition = x_.in(node, "expression", QStringLiteral("the condition"));
        t_.label(node, QStringLiteral("Wait %1").arg(condition.shown));
        waitUntil(condition.script);
    } else if (type == QLatin1String("NoWait")) {
        t_.label(node, QStringLiteral("Wait"));
    } else {
        t_.refuse(node, QStringLiteral("a wait of type '%1' is not simulated").arg(type));
    }
}

void ProgramTranslator::writeSet(const XmlElement& node) {
    const QString type = node.attribute("type");
    if (type == QLatin1String("NoAction")) {
        t_.label(node, QStringLiteral("Set"));
        writeToolSettings(node);
        return;
    }
    if (type != QLatin1String("DigitalOutput") && type != QLatin1String("AnalogOutput") &&
        type != QLatin1String("ExpressionOutput")) {
        t_.refuse(node, QStringLiteral("an action of type '%1' is not simulated").arg(type));
        return;
    }
    const Expressions::Signal signal = x_.signal(node);
    QString value, shown;
    if (type == QLatin1String("DigitalOutput")) {
        const QString digit = textOf(node, "digitalValue");
        const bool high = digit == QLatin1String("1") || digit == QLatin1String("true");
        if (!high && digit != QLatin1String("0") && digit != QLatin1String("false")) {
            t_.unfinished(node, QStringLiteral("the value is missing"));
        }
        value = high ? QStringLiteral("True") : QStringLiteral("False");
        shown = high ? QStringLiteral("On") : QStringLiteral("Off");
    } else if (type == QLatin1String("AnalogOutput")) {
        // The node stores amperes or volts, but the script function expects a fraction of the range.
        bool ok = false;
        double amount = textOf(node, "analogValue").toDouble(&ok);
        shown = textOf(node, "analogValue");
        const bool isAnalog = signal.kind != nullptr && signal.kind->value == TerminalValue::Analog;
        const auto index = static_cast<std::size_t>(signal.number);
        if (isAnalog && index < t_.installation.analogOutputIsVoltage.size() &&
            t_.installation.analogOutputIsVoltage[index]) {
            amount /= kMaxVoltage;
        } else if (isAnalog) {
            amount = (amount - kMinCurrent) / (kMaxCurrent - kMinCurrent);
        }
        if (!ok || (isAnalog && !(amount >= -1e-9 && amount <= 1 + 1e-9))) {
            t_.refuse(node, QStringLiteral("'%1' is not within the range of the output").arg(shown));
        }
        value = QString::number(isAnalog ? std::clamp(amount, 0.0, 1.0) : amount, 'g', 12);
    } else {
        const Expression expression = x_.in(node, "expression", QStringLiteral("the value"));
        value = expression.script;
        shown = expression.shown;
        if (signal.kind != nullptr && signal.kind->value == TerminalValue::Analog) {
            t_.refuse(node, QStringLiteral("an expression for an analog output is not simulated"));
        }
    }
    t_.label(node, QStringLiteral("Set %1=%2").arg(signal.shown, shown));
    const QString line = signal.write(value);
    if (line.isEmpty() && (signal.kind != nullptr || signal.modbus != nullptr)) {
        t_.refuse(node, QStringLiteral("'%1' is not an output").arg(signal.shown));
    }
    statement(line);
}

/// Writes the tool settings of a Set node. They apply with or without an action.
void ProgramTranslator::writeToolSettings(const XmlElement& node) {
    if (const XmlElement* const given = node.child("tcp")) {
        const XmlElement* const tcp = given->resolved();
        const QString name = tcp == nullptr ? QString() : tcp->attribute("referencedName");
        const auto found = t_.installation.tcps.find(name);
        if (found == t_.installation.tcps.end()) {
            t_.refuse(node,
                      QStringLiteral("there is no TCP '%1': %2").arg(name, t_.installation.shownName()));
            return;
        }
        statement(QStringLiteral("set_tcp(p[%1])").arg(found->second));
    }
    if (node.has("payload")) {
        const QString mass = numberList(node.attribute("payload"), 1);
        const QString center = numberList(node.attribute("centerOfGravity"), 3);
        if (mass.isEmpty() || (center.isEmpty() && !node.isTrue("tcpAsCog"))) {
            t_.refuse(node, QStringLiteral(
                                "the payload is not simulated: mass and centre of gravity must be numbers"));
        }
        // Without a centre of gravity, the TCP is used.
        writePayload({{}, mass, node.isTrue("tcpAsCog") ? QString() : center, {}});
    }
}

void ProgramTranslator::writeSetPayload(const XmlElement& node) {
    QString name = node.attribute("workpieceName");
    if (const XmlElement* const named = node.target("payload"); name.isEmpty() && named != nullptr) {
        name = named->attribute("referencedName");
    }
    t_.label(node, QStringLiteral("Set Payload: %1").arg(name));
    if (const Payload* const payload = t_.installation.payload(name)) {
        writePayload(*payload);
    } else {
        t_.refuse(node,
                  QStringLiteral("there is no payload '%1': %2").arg(name, t_.installation.shownName()));
    }
}

/// Repeats the child nodes in a thread that is killed when `condition` is no longer true.
void ProgramTranslator::writeWhileHolds(const XmlElement& node, const QString& condition) {
    const QString name = t_.uniqueName(QStringLiteral("check_%1").arg(t_.nextNumber()));
    statement(QStringLiteral("thread %1():").arg(name));
    t_.out->indent();
    statement(QStringLiteral("while True:"));
    writeBlock(node);
    statement(QStringLiteral("end"));
    t_.out->outdent();
    statement(QStringLiteral("end"));
    statement(QStringLiteral("if (%1):").arg(condition));
    statement(QStringLiteral("  %1_thread = run %1()").arg(name));
    statement(QStringLiteral("  while (%1):").arg(condition));
    statement(QStringLiteral("    sync()"));
    statement(QStringLiteral("  end"));
    statement(QStringLiteral("  kill %1_thread").arg(name));
    statement(QStringLiteral("end"));
}

void ProgramTranslator::writeLoop(const XmlElement& node) {
    const QString type = node.attribute("type");
    if (type == QLatin1String("Always") || type == QLatin1String("Forever")) {
        t_.label(node, QStringLiteral("Loop"));
        statement(QStringLiteral("while True:"));
        writeBlock(node);
        statement(QStringLiteral("end"));
    } else if (type == QLatin1String("While")) {
        const Expression condition = x_.in(node, "expression", QStringLiteral("the condition"));
        t_.label(node, QStringLiteral("Loop %1").arg(condition.shown));
        if (node.isTrue("checkContinuously")) {
            writeWhileHolds(node, condition.script);
            return;
        }
        statement(QStringLiteral("while (%1):").arg(condition.script));
        writeBlock(node);
        statement(QStringLiteral("end"));
    } else if (type == QLatin1String("Counting")) {
        bool ok = false;
        const int count = node.attribute("count").toInt(&ok);
        if (!ok || count < 0) {
            t_.unfinished(node, QStringLiteral("the count is missing"));
        }
        const QString counter = node.child("loopVariable") != nullptr
                                    ? x_.variable(node, "loopVariable")
                                    : t_.uniqueName(QStringLiteral("loop_%1").arg(t_.nextNumber()));
        t_.label(node, QStringLiteral("Loop %1 times").arg(count));
        statement(QStringLiteral("%1 = 0").arg(counter));
        statement(QStringLiteral("while (%1 < %2):").arg(counter).arg(count));
        writeBlock(node);
        statement(QStringLiteral("  %1 = %1 + 1").arg(counter));
        statement(QStringLiteral("end"));
    } else {
        t_.refuse(node, QStringLiteral("a loop of type '%1' is not simulated").arg(type));
    }
}

void ProgramTranslator::writeSwitch(const XmlElement& node) {
    const Expression value = x_.in(node, "expression", QStringLiteral("the value"));
    const QString variable = t_.uniqueName(QStringLiteral("switch_%1").arg(t_.nextNumber()));
    t_.label(node, QStringLiteral("Switch %1").arg(value.shown));
    statement(QStringLiteral("%1 = %2").arg(variable, value.script));
    const XmlElement* const children = node.child("children");
    const XmlElement* otherwise = nullptr;
    bool isOpen = false;
    const auto writeCase = [&](const XmlElement& branch, const QString& label) {
        t_.out->indent();
        t_.label(branch, label);
        t_.out->outdent();
        writeBlock(branch);
    };
    for (std::size_t i = 0; children != nullptr && i < children->children.size(); ++i) {
        const XmlElement& branch = t_.nodeAt(*children->children[i]);
        if (isSuppressed(branch) || branch.is("Comment")) {
            markOmitted(branch);
            continue;
        }
        const QString wanted = branch.attribute("caseValue");
        const bool isDefault =
            wanted == QLatin1String(kDefaultCase) || branch.name.contains(QLatin1String("Default"));
        if (branch.is("Case") && !wanted.isEmpty() && !isDefault) {
            if (numberList(wanted, 1).isEmpty()) {
                t_.refuse(branch, QStringLiteral("'%1' is not a number").arg(wanted));
            }
            statement(QStringLiteral("%1 (%2 == %3):").arg(isOpen ? "elif" : "if", wanted, variable));
            writeCase(branch, QStringLiteral("Case %1").arg(wanted));
            isOpen = true;
        } else if (isDefault && otherwise == nullptr) {
            otherwise = &branch;
        } else {
            t_.refuse(branch, QStringLiteral("this node is not simulated inside a Switch node"));
        }
    }
    if (otherwise != nullptr) {
        statement(isOpen ? QStringLiteral("else:") : QStringLiteral("if True:"));
        writeCase(*otherwise, QStringLiteral("Default Case"));
        isOpen = true;
    }
    if (isOpen) {
        statement(QStringLiteral("end"));
    }
}

/// A popup waits for the operator unless it halts the program.
void ProgramTranslator::writePopup(const XmlElement& node) {
    const QString type = node.attribute("type");
    const bool isWarning = type == QLatin1String("Warning"), isError = type == QLatin1String("Error");
    const bool halts = node.isTrue("haltProgram");
    const bool isVariable = node.attribute("inputType") == QLatin1String("Variable");
    const QString text = isVariable ? x_.variable(node) : quoted(node.attribute("message"));
    t_.label(node, isVariable ? QStringLiteral("Popup")
                              : QStringLiteral("Popup: %1").arg(node.attribute("message")));
    statement(QStringLiteral("popup(%1, \"%2\", %3, %4, blocking=%5)")
                  .arg(text,
                       isWarning ? "Warning"
                       : isError ? "Error"
                                 : "Message",
                       isWarning ? "True" : "False", isError ? "True" : "False", halts ? "False" : "True"));
    if (halts) {
        statement(QStringLiteral("halt"));
    }
}

void ProgramTranslator::writeCall(const XmlElement& node) {
    const XmlElement* const named = node.child("subprogram");
    if (named == nullptr) {
        t_.unfinished(node, QStringLiteral("the subprogram is missing"));
        return;
    }
    const XmlElement* const sub = named->resolved();
    if (sub == nullptr || subPrograms_.size() >= kMaxSubPrograms) {
        t_.refuse(node, QStringLiteral("the referenced element is not a subprogram"));
        return;
    }
    const std::optional<std::size_t> place = addSubProgram(*sub);
    if (!place) {
        return;
    }
    t_.label(node, QStringLiteral("Call %1").arg(sub->attribute("name")));
    statement(subPrograms_[*place].name + QStringLiteral("()"));
}

void ProgramTranslator::writeUrcap(const XmlElement& node) {
    const QString nodeClass = node.attribute("strategyClass");
    const QString shown = node.has("strategyURCapName") ? node.attribute("strategyURCapName") : nodeClass;
    if (nodeClass.contains(QLatin1String(kControlNodeOwner))) {
        statement(
            QString::fromUtf8(kControlNode.data(), static_cast<qsizetype>(kControlNode.size())).trimmed());
        return;
    }
    const QString label =
        node.has("strategyProgramNodeType") ? node.attribute("strategyProgramNodeType") : shown;
    t_.label(node, label);
    if (const UrcapStandIn* const standIn = source_.urcaps.find(nodeClass)) {
        const Result<QStringList> lines = UrcapStandIns::bodyOf(*standIn, node);
        if (!lines) {
            t_.refuse(node, lines.error().context);
            return;
        }
        if (urcaps_.insert(standIn).second) {
            for (const QString& line : standIn->setup) {
                head_.line(line);
            }
        }
        for (const QString& line : *lines) {
            statement(line);
        }
        writeChildren(node);
        return;
    }
    switch (source_.unknownUrcap) {
        case UnknownUrcap::Refuse:
            t_.refuse(node,
                      QStringLiteral("the node of '%1' is not simulated, and class '%2' has no stand-in")
                          .arg(shown, nodeClass));
            break;
        case UnknownUrcap::Ask:
            statement(
                QStringLiteral("popup(%1, \"URCap\", False, False, blocking=True)")
                    .arg(quoted(QStringLiteral("%1 (%2) is not simulated. Continue?").arg(label, shown))));
            break;
        case UnknownUrcap::Skip:
            statement(QStringLiteral("textmsg(%1)")
                          .arg(quoted(
                              QStringLiteral("%1 (%2) is not simulated and was skipped").arg(label, shown))));
            break;
    }
}

}  // namespace tiller::simulator::pendant
