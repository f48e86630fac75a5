// SPDX-License-Identifier: MIT
#include "robot/simulator/urp_file.h"

#include <zlib.h>
#include <QStringList>
#include <utility>

#include "robot/simulator/external_control.h"
#include "robot/simulator/urp_tree.h"

namespace tiller::simulator {

namespace {

constexpr qsizetype kLargestXml = 64 << 20;

bool isGzip(const QByteArray& content) {
    return content.startsWith("\x1f\x8b");
}

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

/// Turns nodes into statements.
class UrpWriter {
public:
    std::optional<std::string> write(const UrpElement& root, const QString& name) {
        if (!root.is("URProgram")) {
            return std::nullopt;
        }
        const UrpElement* const parts = root.child("children");
        const UrpElement* const main = parts == nullptr ? nullptr : parts->child("MainProgram");
        if (main == nullptr) {
            return std::nullopt;
        }
        emitLine(QStringLiteral("def %1():").arg(nameOf(name)));
        ++depth_;
        writeInitialValues(root);
        writeBeforeStart(*parts);
        writeThreads(*parts);
        writeRepeated(*main);
        --depth_;
        emitLine(QStringLiteral("end"));
        return good_ ? std::optional(script_.toStdString()) : std::nullopt;
    }

private:
    void emitLine(const QString& line) { script_ += QString(2 * depth_, ' ') + line + '\n'; }
    void refuse() { good_ = false; }

    // ---- parts of a program

    void writeInitialValues(const UrpElement& element) {
        for (const auto& child : element.children) {
            const UrpElement* const value =
                child->is("variable") ? child->child("initializeExpression") : nullptr;
            if (value != nullptr && !value->children.empty()) {
                emitLine(QStringLiteral("global %1 = %2").arg(variableOf(*child), expressionOf(*value)));
            }
            writeInitialValues(*child);
        }
    }

    void writeBeforeStart(const UrpElement& parts) {
        for (const auto& part : parts.children) {
            if (part->is("SpecialSequence") && part->attribute("type") == QLatin1String("BeforeStart")) {
                writeChildrenOf(*part);
            } else if (!part->is("MainProgram") && !part->is("Thread") && !part->is("InitVariablesNode")) {
                refuse();  // event nodes, subprograms
            }
        }
    }

    void writeThreads(const UrpElement& parts) {
        for (const auto& part : parts.children) {
            if (part->is("Thread")) {
                const QString name = nameOf(part->attribute("name"));
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
    void writeRepeated(const UrpElement& part) {
        if (part.attribute("runOnlyOnce") == QLatin1String("false")) {
            emitLine(QStringLiteral("while True:"));
            writeBlock(part);
            emitLine(QStringLiteral("end"));
        } else {
            writeChildrenOf(part);
        }
    }

    // ---- nodes

    void writeBlock(const UrpElement& node) {
        ++depth_;
        const qsizetype before = script_.size();
        writeChildrenOf(node);
        if (script_.size() == before) {
            emitLine(QStringLiteral("sync()"));  // a block has to have a statement
        }
        --depth_;
    }

    void writeChildrenOf(const UrpElement& node) {
        const UrpElement* const children = node.child("children");
        if (children == nullptr) {
            return;
        }
        bool openIf = false;  // one that an Else may follow
        for (const auto& child : children->children) {
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

    void writeBranch(const UrpElement& node, const QString& type) {
        const UrpElement* const condition = node.child("expression");
        const bool isElse = type == QLatin1String("Else");
        if (!isElse && condition == nullptr) {
            refuse();
            return;
        }
        emitLine(isElse ? QStringLiteral("else:")
                        : QStringLiteral("%1 %2:").arg(
                              type == QLatin1String("ElseIf") ? QStringLiteral("elif") : QStringLiteral("if"),
                              expressionOf(*condition)));
        writeBlock(node);
    }

    void writeNode(const UrpElement& node) {
        if (node.is("Script")) {
            writeScript(node);
        } else if (node.is("Assignment")) {
            writeAssignment(node);
        } else if (node.is("Wait")) {
            writeWait(node);
        } else if (node.is("Move")) {
            writeMove(node);
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
        } else if (node.is("Contributed") &&
                   node.attribute("strategyClass").contains(QLatin1String(kControlNodeOwner))) {
            emitLine(QString::fromUtf8(kControlNode.data(), kControlNode.size()).trimmed());
        } else if (!node.is("Comment")) {
            refuse();
        }
    }

    QString variableOf(const UrpElement& reference) {
        const UrpElement* const variable = reference.resolved();
        const QString name = variable == nullptr ? QString() : variable->attribute("name");
        if (name.isEmpty()) {
            refuse();
        }
        return nameOf(name);
    }

    QString expressionOf(const UrpElement& expression) {
        QString text;
        for (const auto& part : expression.children) {
            if (part->is("ExpressionChar") || part->is("ExpressionToken")) {
                text += part->attribute("character") + part->attribute("token");
            } else if (part->is("ExpressionVariable") && !part->children.empty()) {
                text += variableOf(*part->children.front());
            } else {
                refuse();
            }
        }
        return withoutSigns(text);
    }

    void writeAssignment(const UrpElement& node) {
        const UrpElement* const variable = node.child("variable");
        const UrpElement* const value = node.child("expression");
        if (variable == nullptr || value == nullptr) {
            refuse();
            return;
        }
        emitLine(QStringLiteral("global %1 = %2").arg(variableOf(*variable), expressionOf(*value)));
    }

    /// A timer shows on the pendant; here it is a variable like others, which stands still.
    void writeTimer(const UrpElement& node) {
        if (const UrpElement* const variable = node.child("variable")) {
            emitLine(QStringLiteral("global %1 = 0.0").arg(variableOf(*variable)));
        }
    }

    void writeScript(const UrpElement& node) {
        const UrpElement* const file = node.child("cachedContents");
        const UrpElement* const line = node.child("expression");
        const QString text = file != nullptr ? file->text : line != nullptr ? expressionOf(*line) : QString();
        for (const QString& words : text.split('\n')) {
            if (!words.trimmed().isEmpty()) {
                emitLine(words);
            }
        }
    }

    void writeWait(const UrpElement& node) {
        const UrpElement* const time = node.child("waitTime");
        bool ok = false;
        const double seconds = time == nullptr ? 0 : time->text.toDouble(&ok);
        good_ = good_ && node.attribute("type") == QLatin1String("Sleep") && ok && seconds >= 0;
        emitLine(QStringLiteral("sleep(%1)").arg(seconds));
    }

    void writeLoop(const UrpElement& node) {
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
            refuse();
            return;
        }
        emitLine(QStringLiteral("end"));
    }

    void writePopup(const UrpElement& node) {
        QString message = node.attribute("message");
        message.remove('"');
        emitLine(
            QStringLiteral("popup(\"%1\", blocking=%2)")
                .arg(message, node.attribute("haltProgram") == QLatin1String("true") ? "True" : "False"));
    }

    // ---- motion

    void writeMove(const UrpElement& node) {
        const QString type = node.attribute("motionType");
        const QString function = type == QLatin1String("MoveJ")   ? QStringLiteral("movej")
                                 : type == QLatin1String("MoveL") ? QStringLiteral("movel")
                                                                  : QString();
        bool okSpeed = false, okAcceleration = false;
        const double speed = node.attribute("speed").toDouble(&okSpeed);
        const double acceleration = node.attribute("acceleration").toDouble(&okAcceleration);
        good_ = good_ && okSpeed && okAcceleration && !function.isEmpty();
        const UrpElement* const waypoints = node.child("children");
        if (waypoints == nullptr) {
            return;
        }
        for (const auto& waypoint : waypoints->children) {
            const QString target = waypoint->is("Waypoint") ? targetOf(*waypoint, node) : QString();
            if (target.isEmpty()) {
                refuse();
                return;
            }
            emitLine(QStringLiteral("%1(%2, a=%3, v=%4)").arg(function, target).arg(acceleration).arg(speed));
        }
    }

    /// Empty when it cannot be told.
    QString targetOf(const UrpElement& waypoint, const UrpElement& move) {
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

    static QString anglesOf(const UrpElement& waypoint) {
        const UrpElement* const position = waypoint.child("position");
        const UrpElement* const joints = position == nullptr ? nullptr : position->child("JointAngles");
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

    QString script_;
    int depth_ = 0;
    int loops_ = 0;
    bool good_ = true;
};

}  // namespace

std::optional<QByteArray> gunzip(const QByteArray& compressed, qsizetype most) {
    if (!isGzip(compressed)) {
        return std::nullopt;
    }
    z_stream stream{};
    constexpr int kGzipOnly = 16 + MAX_WBITS;
    if (inflateInit2(&stream, kGzipOnly) != Z_OK) {
        return std::nullopt;
    }
    // zlib reads only; its interface is older than const.
    stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(compressed.constData()));
    stream.avail_in = static_cast<uInt>(compressed.size());
    QByteArray out;
    QByteArray piece(64 * 1024, Qt::Uninitialized);
    int state = Z_OK;
    while (state == Z_OK && out.size() <= most) {
        stream.next_out = reinterpret_cast<Bytef*>(piece.data());
        stream.avail_out = static_cast<uInt>(piece.size());
        state = inflate(&stream, Z_NO_FLUSH);
        out.append(piece.constData(), piece.size() - static_cast<qsizetype>(stream.avail_out));
    }
    inflateEnd(&stream);
    return state == Z_STREAM_END && out.size() <= most ? std::optional(out) : std::nullopt;
}

bool isUrpFile(const QByteArray& content) {
    return isGzip(content) || content.left(4096).contains("<URProgram");
}

std::optional<std::string> scriptOfUrp(const QByteArray& content, const QString& name) {
    const std::optional<QByteArray> xml = isGzip(content) ? gunzip(content, kLargestXml) : content;
    const std::unique_ptr<UrpElement> root = xml ? readUrpTree(*xml) : nullptr;
    return root ? UrpWriter().write(*root, name) : std::nullopt;
}

}  // namespace tiller::simulator
