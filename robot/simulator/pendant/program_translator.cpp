// SPDX-License-Identifier: MIT
#include "robot/simulator/programs/urp_writer.h"

#include <QRegularExpression>
#include <QStringList>
#include <array>
#include <utility>

#include "robot/simulator/programs/external_control.h"

namespace tiller::simulator {

namespace {

/// A fresh pendant's: the arm upright. [rad]
constexpr const char* kProgramHome = "0, -1.5707963268, 0, -1.5707963268, 0, 0";
constexpr double kHomeSpeed = 1.05;         ///< [rad/s]
constexpr double kHomeAcceleration = 1.40;  ///< [rad/s2]
constexpr std::size_t kMostSubPrograms = 1000;

/// A word the language takes for a name.
QString nameOf(QString words) {
    for (QChar& c : words) {
        c = c.isLetterOrNumber() && c.unicode() < 128 ? c : QChar('_');
    }
    return words.isEmpty() || words[0].isDigit() ? 'p' + words : words;
}

/// The pendant shows some operators as one sign.
QString withoutSigns(QString text) {
    static const std::pair<QChar, const char*> kSigns[] = {
        {QChar(0x225F), "=="}, {QChar(0x2260), "!="}, {QChar(0x2264), "<="},
        {QChar(0x2265), ">="}, {QChar(0x2254), "="},
    };
    for (const auto& [sign, words] : kSigns) {
        text.replace(sign, QLatin1String(words));
    }
    return text;
}

/// Words keep their distance from what stands beside them; the pendant saves some tokens without blanks.
QString apart(const QString& token) {
    const bool begins = !token.isEmpty() && token.front().isLetterOrNumber();
    const bool ends = !token.isEmpty() && token.back().isLetterOrNumber();
    return (begins ? QStringLiteral(" ") : QString()) + token + (ends ? QStringLiteral(" ") : QString());
}

bool isSuppressed(const UrpElement& node) {
    return node.is("SuppressedNode") || node.is("suppressedNode");
}

/// What a terminal is called on the pendant before an installation names it, and how a script reads it.
struct Pin {
    const char* name;
    const char* function;
    int count;
};
constexpr Pin kPins[] = {
    {"digital_in", "get_standard_digital_in", 8},
    {"digital_out", "get_standard_digital_out", 8},
    {"config_in", "get_configurable_digital_in", 8},
    {"config_out", "get_configurable_digital_out", 8},
    {"tool_in", "get_tool_digital_in", 2},
    {"tool_out", "get_tool_digital_out", 2},
    {"analog_in", "get_standard_analog_in", 2},
    {"analog_out", "get_standard_analog_out", 2},
    {"tool_analog_in", "get_tool_analog_in", 2},
    {"gp_bool_in", "read_input_boolean_register", 128},
    {"gp_int_in", "read_input_integer_register", 48},
    {"gp_float_in", "read_input_float_register", 48},
    {"gp_bool_out", "read_output_boolean_register", 128},
    {"gp_int_out", "read_output_integer_register", 48},
    {"gp_float_out", "read_output_float_register", 48},
};

/// Six numbers, as text; empty when they are not.
QString anglesOf(const UrpElement& holder) {
    const UrpElement* const position = holder.child("position");
    const UrpElement* const joints = (position == nullptr ? &holder : position)->child("JointAngles");
    const QString angles = joints == nullptr ? QString() : joints->attribute("angles");
    const QStringList numbers = angles.split(',');
    bool all = numbers.size() == 6;
    for (const QString& number : numbers) {
        bool ok = false;
        number.trimmed().toDouble(&ok);
        all = all && ok;
    }
    return all ? '[' + angles + ']' : QString();
}

}  // namespace

void UrpWriter::refuse(const UrpElement& at, const QString& why) {
    if (error_) {
        return;
    }
    const QString own = at.attribute("name");
    const QString named = own.isEmpty() ? QString() : QStringLiteral(" '%1'").arg(own);
    error_ = Error{ErrorCode::FileCorrupt,
                   QStringLiteral("line %1, %2%3: %4").arg(at.line).arg(at.name, named, why),
                   {}};
}

QString UrpWriter::uniqueName(const QString& words) {
    const QString wanted = nameOf(words);
    QString name = wanted;
    for (int i = 2; !names_.insert(name).second; ++i) {
        name = QStringLiteral("%1_%2").arg(wanted).arg(i);
    }
    return name;
}

Result<std::string> UrpWriter::write(const UrpElement& root, const QString& name) {
    if (!root.is("URProgram")) {
        refuse(root, QStringLiteral("not a program, which begins with URProgram"));
        return *error_;
    }
    const UrpElement* const parts = root.child("children");
    const UrpElement* const main = parts == nullptr ? nullptr : parts->child("MainProgram");
    if (main == nullptr) {
        refuse(root, QStringLiteral("there is no MainProgram"));
        return *error_;
    }
    const QString head = QStringLiteral("def %1():\n").arg(uniqueName(name));
    ++depth_;
    writeInitialValues(root, false);
    writeBeforeStart(*parts);
    writeThreads(*parts);
    writeRepeated(*main);
    // What the nodes have called; names are found wherever in the program they are told.
    const QString body = std::exchange(script_, {});
    writeSubPrograms();
    --depth_;
    if (error_) {
        return *error_;
    }
    return (head + script_ + otherInitialValues_ + body + QStringLiteral("end\n")).toStdString();
}

// ---- parts of a program ---------------------------------------------------------------------------------

void UrpWriter::writeInitialValues(const UrpElement& element, bool suppressed) {
    for (const auto& child : element.children) {
        const bool off = suppressed || isSuppressed(*child);
        const UrpElement* const value =
            child->is("variable") ? child->child("initializeExpression") : nullptr;
        if (value != nullptr && !value->children.empty()) {
            const bool goodSoFar = !error_;
            const QString line =
                QStringLiteral("global %1 = %2").arg(variableOf(*child), expressionOf(*value));
            if (off && goodSoFar && error_) {
                error_.reset();  // what is switched off need not be understood
            } else {
                emitLine(line);
            }
        }
        writeInitialValues(*child, off);
    }
}

void UrpWriter::writeBeforeStart(const UrpElement& parts) {
    for (const auto& part : parts.children) {
        if (part->is("SpecialSequence") && part->attribute("type") == QLatin1String("BeforeStart")) {
            writeChildrenOf(*part);
        } else if (!part->is("MainProgram") && !part->is("Thread") && !part->is("InitVariablesNode") &&
                   !part->is("SubProgram") && !part->is("Comment") && !isSuppressed(*part)) {
            refuse(*part, QStringLiteral("this part of a program is not simulated"));
        }
    }
}

void UrpWriter::writeThreads(const UrpElement& parts) {
    for (const auto& part : parts.children) {
        if (part->is("Thread")) {
            const QString name = uniqueName(part->attribute("name"));
            emitLine(QStringLiteral("thread %1():").arg(name));
            ++depth_;
            writeRepeated(*part);
            --depth_;
            emitLine(QStringLiteral("end"));
            emitLine(QStringLiteral("handle_%1 = run %1()").arg(name));
        }
    }
}

/// A program and a thread begin anew at their end, unless the box for that is not ticked.
void UrpWriter::writeRepeated(const UrpElement& part) {
    if (part.attribute("runOnlyOnce") == QLatin1String("false")) {
        emitLine(QStringLiteral("while True:"));
        writeBlock(part);
        emitLine(QStringLiteral("end"));
    } else {
        writeChildrenOf(part);
    }
}

void UrpWriter::writeSubPrograms() {
    // Grows while their own calls are written.
    for (std::size_t i = 0; i < subPrograms_.size() && !error_; ++i) {
        const SubProgram sub = subPrograms_[i];
        emitLine(QStringLiteral("def %1():").arg(sub.name));
        writeBlock(*sub.body);
        emitLine(QStringLiteral("end"));
    }
}

/// A sub program is written out in the file, or is a program of its own beside it.
const UrpElement* UrpWriter::bodyOf(const UrpElement& subProgram) {
    const UrpElement* const file = subProgram.child("file");
    if (subProgram.child("children") != nullptr || file == nullptr) {
        return &subProgram;
    }
    return mainOfFile(file->text.trimmed(), subProgram);
}

const UrpElement* UrpWriter::mainOfFile(const QString& name, const UrpElement& at) {
    auto known = trees_.find(name);
    if (known == trees_.end()) {
        Result<std::unique_ptr<UrpElement>> tree = readTree_(name);
        if (!tree) {
            refuse(at, tree.error().context);
            return nullptr;
        }
        known = trees_.emplace(name, std::move(*tree)).first;
        // They belong to the beginning of the program, not to where the sub program is called.
        QString soFar = std::exchange(script_, {});
        const int depth = std::exchange(depth_, 1);
        writeInitialValues(*known->second, false);
        depth_ = depth;
        otherInitialValues_ += std::exchange(script_, std::move(soFar));
    }
    const UrpElement* const parts = known->second->child("children");
    const UrpElement* const main = parts == nullptr ? nullptr : parts->child("MainProgram");
    if (!known->second->is("URProgram") || main == nullptr) {
        refuse(at, QStringLiteral("'%1' is not a program").arg(name));
        return nullptr;
    }
    return main;
}

// ---- nodes ----------------------------------------------------------------------------------------------

void UrpWriter::writeBlock(const UrpElement& node) {
    ++depth_;
    const qsizetype before = script_.size();
    writeChildrenOf(node);
    if (script_.size() == before) {
        emitLine(QStringLiteral("sync()"));  // a block has to have a statement
    }
    --depth_;
}

void UrpWriter::writeChildrenOf(const UrpElement& node) {
    const UrpElement* const children = node.child("children");
    if (children == nullptr) {
        return;
    }
    bool openIf = false;  // one that an Else may follow
    for (const auto& child : children->children) {
        if (isSuppressed(*child)) {
            continue;
        }
        const QString type = child->is("If") ? child->attribute("type") : QString();
        const bool continues = type == QLatin1String("Else") || type == QLatin1String("ElseIf");
        if (openIf && !continues) {
            emitLine(QStringLiteral("end"));
            openIf = false;
        }
        if (child->is("If")) {
            writeBranch(*child, type);
            // One that stands within its If ends with that.
            openIf = openIf || !continues;
        } else {
            writeNode(*child);
        }
    }
    if (openIf) {
        emitLine(QStringLiteral("end"));
    }
}

void UrpWriter::writeBranch(const UrpElement& node, const QString& type) {
    const UrpElement* const condition = node.child("expression");
    const bool isElse = type == QLatin1String("Else");
    if (!isElse && condition == nullptr) {
        refuse(node, QStringLiteral("there is no condition"));
        return;
    }
    emitLine(isElse ? QStringLiteral("else:")
                    : QStringLiteral("%1 %2:").arg(
                          type == QLatin1String("ElseIf") ? QStringLiteral("elif") : QStringLiteral("if"),
                          expressionOf(*condition)));
    writeBlock(node);
}

void UrpWriter::writeNode(const UrpElement& node) {
    if (node.is("Script")) {
        writeScript(node);
    } else if (node.is("Assignment")) {
        writeAssignment(node);
    } else if (node.is("Wait")) {
        writeWait(node);
    } else if (node.is("Move")) {
        writeMove(node);
    } else if (node.is("SafeHome")) {
        writeSafeHome(node);
    } else if (node.is("Folder")) {
        writeChildrenOf(node);
    } else if (node.is("Loop")) {
        writeLoop(node);
    } else if (node.is("Popup")) {
        writePopup(node);
    } else if (node.is("Halt")) {
        emitLine(QStringLiteral("halt"));
    } else if (node.is("Timer")) {
        writeTimer(node);
    } else if (node.is("CallSubProgram")) {
        writeCall(node);
    } else if (node.is("Contributed") &&
               node.attribute("strategyClass").contains(QLatin1String(kControlNodeOwner))) {
        emitLine(QString::fromUtf8(kControlNode.data(), kControlNode.size()).trimmed());
    } else if (node.is("Contributed")) {
        refuse(node,
               QStringLiteral("the node of '%1' is not simulated")
                   .arg(node.attribute("strategyURCapName").isEmpty() ? node.attribute("strategyClass")
                                                                      : node.attribute("strategyURCapName")));
    } else if (!node.is("Comment")) {
        refuse(node, QStringLiteral("this node is not simulated"));
    }
}

void UrpWriter::writeAssignment(const UrpElement& node) {
    const UrpElement* const variable = node.child("variable");
    const UrpElement* const value = node.child("expression");
    if (variable == nullptr || value == nullptr) {
        refuse(node, QStringLiteral("variable or value is missing"));
        return;
    }
    emitLine(QStringLiteral("global %1 = %2").arg(variableOf(*variable), expressionOf(*value)));
}

/// A timer shows on the pendant; here it is a variable like others, which stands still.
void UrpWriter::writeTimer(const UrpElement& node) {
    if (const UrpElement* const variable = node.child("variable")) {
        emitLine(QStringLiteral("global %1 = 0.0").arg(variableOf(*variable)));
    }
}

void UrpWriter::writeScript(const UrpElement& node) {
    const UrpElement* const kept = node.child("cachedContents");
    const UrpElement* const line = node.child("expression");
    const UrpElement* const file = node.child("file");
    QString text;
    if (kept != nullptr) {
        text = kept->text;
    } else if (line != nullptr) {
        text = expressionOf(*line);
    } else if (file != nullptr) {
        const QString name = file->text.trimmed();
        const std::optional<QByteArray> content = readScript_(name);
        if (!content) {
            refuse(node, QStringLiteral("there is no file '%1' in the programs folder").arg(name));
            return;
        }
        text = QString::fromUtf8(*content);
    }
    for (const QString& words : text.split('\n')) {
        if (!words.trimmed().isEmpty()) {
            emitLine(words);
        }
    }
}

void UrpWriter::writeWait(const UrpElement& node) {
    const UrpElement* const time = node.child("waitTime");
    bool ok = false;
    const double seconds = time == nullptr ? 0 : time->text.toDouble(&ok);
    if (node.attribute("type") != QLatin1String("Sleep") || !ok || !(seconds >= 0)) {
        refuse(node, QStringLiteral("only a wait for a time is simulated"));
        return;
    }
    emitLine(QStringLiteral("sleep(%1)").arg(seconds));
}

void UrpWriter::writeLoop(const UrpElement& node) {
    const QString type = node.attribute("type");
    const int count = node.attribute("count").toInt();
    const UrpElement* const condition = node.child("expression");
    if (type == QLatin1String("Always") || type == QLatin1String("Forever")) {
        emitLine(QStringLiteral("while True:"));
        writeBlock(node);
    } else if (type == QLatin1String("While") && condition != nullptr) {
        emitLine(QStringLiteral("while %1:").arg(expressionOf(*condition)));
        writeBlock(node);
    } else if (type == QLatin1String("Counting") && count > 0) {
        const QString counter = QStringLiteral("loop_%1").arg(++loops_);
        emitLine(counter + QStringLiteral(" = 0"));
        emitLine(QStringLiteral("while %1 < %2:").arg(counter).arg(count));
        writeBlock(node);
        emitLine(QStringLiteral("  %1 = %1 + 1").arg(counter));
    } else {
        refuse(node, QStringLiteral("this kind of loop is not simulated, or has no condition"));
        return;
    }
    emitLine(QStringLiteral("end"));
}

void UrpWriter::writePopup(const UrpElement& node) {
    QString message = node.attribute("message");
    message.remove('"').replace('\n', ' ');
    emitLine(QStringLiteral("popup(\"%1\", blocking=%2)")
                 .arg(message, node.attribute("haltProgram") == QLatin1String("true") ? "True" : "False"));
}

void UrpWriter::writeCall(const UrpElement& node) {
    const UrpElement* const named = node.child("subprogram");
    const UrpElement* const sub = named == nullptr ? nullptr : named->resolved();
    if (sub == nullptr || subPrograms_.size() >= kMostSubPrograms) {
        refuse(node, QStringLiteral("it leads to no sub program"));
        return;
    }
    // The part of the program may itself be a path to the place where the sub program is written out.
    const UrpElement* const told = sub->resolved();
    const UrpElement& whole = told == nullptr ? *sub : *told;
    auto place = subProgramOf_.find(&whole);
    if (place == subProgramOf_.end()) {
        const UrpElement* const body = bodyOf(whole);
        if (body == nullptr) {
            return;
        }
        place = subProgramOf_.emplace(&whole, subPrograms_.size()).first;
        subPrograms_.push_back({uniqueName(whole.attribute("name")), body});
    }
    emitLine(subPrograms_[place->second].name + QStringLiteral("()"));
}

// ---- motion ---------------------------------------------------------------------------------------------

double UrpWriter::numberOf(const UrpElement& node, const char* attribute) {
    bool ok = false;
    const double value = node.attribute(attribute).toDouble(&ok);
    if (!ok) {
        refuse(node, QStringLiteral("%1 is no number").arg(QLatin1String(attribute)));
    }
    return value;
}

void UrpWriter::writeMove(const UrpElement& node) {
    const QString type = node.attribute("motionType");
    const QString function = type == QLatin1String("MoveJ")   ? QStringLiteral("movej")
                             : type == QLatin1String("MoveL") ? QStringLiteral("movel")
                             : type == QLatin1String("MoveP") ? QStringLiteral("movep")
                                                              : QString();
    if (function.isEmpty()) {
        refuse(node, QStringLiteral("motion '%1' is not simulated").arg(type));
        return;
    }
    const UrpElement* const children = node.child("children");
    if (children == nullptr) {
        return;
    }
    for (const auto& child : children->children) {
        if (child->is("Waypoint")) {
            writeWaypoint(*child, node, function);
        } else if (child->is("SafeHome")) {
            writeSafeHome(*child);
        } else if (!isSuppressed(*child) && !child->is("Comment")) {
            refuse(*child, QStringLiteral("this node is not simulated within a move"));
        }
    }
}

/// A waypoint may have a speed and a blend of its own.
void UrpWriter::writeWaypoint(const UrpElement& waypoint, const UrpElement& move, const QString& function) {
    const QString target = targetOf(waypoint, move);
    if (target.isEmpty()) {
        refuse(waypoint, QStringLiteral("its position cannot be told"));
        return;
    }
    const UrpElement* const own = waypoint.child("motionParameters");
    const bool joints = function == QLatin1String("movej");
    const auto value = [&](const char* ownName, const char* common) {
        return own != nullptr && !own->attribute(ownName).isEmpty() ? numberOf(*own, ownName)
                                                                    : numberOf(move, common);
    };
    const double speed = value(joints ? "jointSpeed" : "cartesianSpeed", "speed");
    const double acceleration = value(joints ? "jointAcceleration" : "cartesianAcceleration", "acceleration");
    QString line = QStringLiteral("%1(%2, a=%3, v=%4").arg(function, target).arg(acceleration).arg(speed);
    if (own != nullptr && !own->attribute("blendRadius").isEmpty()) {
        line += QStringLiteral(", r=%1").arg(numberOf(*own, "blendRadius"));
    }
    emitLine(line + ')');
}

/// The position is one of the installation, which is not read: the node's own, or a fresh pendant's.
void UrpWriter::writeSafeHome(const UrpElement& node) {
    const QString own = anglesOf(node);
    const auto value = [&](const char* attribute, double otherwise) {
        return node.attribute(attribute).isEmpty() ? otherwise : numberOf(node, attribute);
    };
    emitLine(QStringLiteral("movej(%1, a=%2, v=%3)")
                 .arg(own.isEmpty() ? '[' + QLatin1String(kProgramHome) + ']' : own)
                 .arg(value("acceleration", kHomeAcceleration))
                 .arg(value("speed", kHomeSpeed)));
}

/// Empty when it cannot be told.
QString UrpWriter::targetOf(const UrpElement& waypoint, const UrpElement& move) {
    const QString type = waypoint.attribute("type");
    if (type == QLatin1String("Fixed")) {
        return anglesOf(waypoint);
    }
    const UrpElement* const variable = waypoint.child("variable");
    const UrpElement* const feature = move.child("feature");
    // A pose in another frame than the base's would need the installation.
    const bool inBase =
        feature == nullptr || feature->attribute("referencedName") == QLatin1String("Joint_0_name");
    return type == QLatin1String("Variable") && variable != nullptr && inBase ? variableOf(*variable)
                                                                              : QString();
}

// ---- expressions ----------------------------------------------------------------------------------------

QString UrpWriter::variableOf(const UrpElement& reference) {
    const UrpElement* const variable = reference.resolved();
    const QString name = variable == nullptr ? QString() : variable->attribute("name");
    if (name.isEmpty()) {
        refuse(reference, QStringLiteral("it leads to no variable"));
    }
    return nameOf(name);
}

QString UrpWriter::pinOf(const UrpElement& node) {
    const UrpElement* const given = node.child("pin");
    const UrpElement* const pin = given == nullptr ? nullptr : given->resolved();
    if (pin == nullptr) {
        refuse(node, QStringLiteral("it names no pin"));
        return {};
    }
    const QString name =
        pin->attribute("referencedName").isEmpty() ? pin->text.trimmed() : pin->attribute("referencedName");
    static const QRegularExpression kNumbered(QStringLiteral("^(\\w+)\\[(\\d{1,3})\\]$"));
    const QRegularExpressionMatch match = kNumbered.match(name);
    for (const Pin& known : kPins) {
        if (match.hasMatch() && match.captured(1).toLower() == QLatin1String(known.name) &&
            match.captured(2).toInt() < known.count) {
            return QStringLiteral("%1(%2)").arg(QLatin1String(known.function), match.captured(2));
        }
    }
    refuse(node,
           QStringLiteral("pin '%1' is not known; names given in an installation are not read").arg(name));
    return {};
}

QString UrpWriter::expressionOf(const UrpElement& expression) {
    QString text;
    for (const auto& part : expression.children) {
        if (part->is("ExpressionChar")) {
            text += part->attribute("character");
        } else if (part->is("ExpressionToken")) {
            text += apart(part->attribute("token") + part->attribute("character"));
        } else if (part->is("ExpressionVariable") && !part->children.empty()) {
            text += variableOf(*part->children.front());
        } else if (part->is("ExpressionIO")) {
            text += pinOf(*part);
        } else {
            refuse(*part, QStringLiteral("this part of an expression is not simulated"));
        }
    }
    return withoutSigns(text);
}

}  // namespace tiller::simulator
