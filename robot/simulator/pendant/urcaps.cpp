// SPDX-License-Identifier: MIT
#include "robot/simulator/pendant/urcaps.h"

#include <QDir>
#include <QRegularExpression>
#include <algorithm>
#include <string_view>

#include "robot/core/file_reading.h"
#include "robot/simulator/pendant/translation.h"

namespace tiller::simulator::pendant {

namespace {

constexpr qint64 kMaxStandIn = 1 << 20;

/// Uses the protocol of the gripper service, which the simulated controller also provides. Position, force
/// and speed are percentages; 0 % is open.
constexpr const char* kRobotiqGripper = R"(# class: com.robotiq.urcap.gripper.GripperNode
# default position: 100
# default force: 50
# default speed: 100
# default blocking: True
# setup
def tiller_gripper(position, force, speed, blocking):
  if socket_get_var("STA", "tiller_gripper") != 3:
    socket_set_var("ACT", 1, "tiller_gripper")
    while socket_get_var("STA", "tiller_gripper") != 3:
      sync()
    end
  end
  socket_set_var("SPE", floor(speed * 2.55 + 0.5), "tiller_gripper")
  socket_set_var("FOR", floor(force * 2.55 + 0.5), "tiller_gripper")
  socket_set_var("POS", floor(position * 2.55 + 0.5), "tiller_gripper")
  socket_set_var("GTO", 1, "tiller_gripper")
  while socket_get_var("PRE", "tiller_gripper") != floor(position * 2.55 + 0.5):
    sync()
  end
  while blocking and socket_get_var("OBJ", "tiller_gripper") == 0:
    sync()
  end
end
if not socket_open("127.0.0.1", 63352, "tiller_gripper"):
  popup("The gripper does not respond", title="Gripper", error=True, blocking=True)
end
# node
tiller_gripper({position}, {force}, {speed}, {blocking})
)";

/// This gripper is not simulated. The node waits for the duration of the motion and reports the width.
constexpr const char* kOnRobotGripper = R"(# class: com.onrobot.urcap.unified.OR_RG
# default rg-target-width: 0.1
# default rg-target-force: 40
# setup
global tiller_rg_width = 0.0
def tiller_rg(width, force):
  sleep(0.1 + norm(width - tiller_rg_width) / 0.2)
  tiller_rg_width = width
  textmsg("RG gripper [m]: ", width)
end
# node
tiller_rg({rg-target-width}, {rg-target-force})
)";

QString literal(const QString& value) {
    static const QRegularExpression kNumber(QStringLiteral("^[+-]?\\d+(\\.\\d*)?([eE][+-]?\\d+)?$"));
    const QString text = value.trimmed();
    if (kNumber.match(text).hasMatch()) {
        return text;
    }
    const QString lower = text.toLower();
    if (lower == QLatin1String("true") || lower == QLatin1String("false")) {
        return lower == QLatin1String("true") ? QStringLiteral("True") : QStringLiteral("False");
    }
    return quoted(value);
}

}  // namespace

UrcapStandIns UrcapStandIns::builtIn() {
    UrcapStandIns all;
    for (const char* const text : {kRobotiqGripper, kOnRobotGripper}) {
        (void)all.add(QStringLiteral("built in"), QString::fromLatin1(text));
    }
    return all;
}

Result<void> UrcapStandIns::addFolder(const QString& folder) {
    const QDir dir(folder);
    if (!dir.exists()) {
        return Error{ErrorCode::FileNotReadable, QStringLiteral("'%1' is not a folder").arg(folder), {}};
    }
    for (const QString& name : dir.entryList({QStringLiteral("*.script")}, QDir::Files, QDir::Name)) {
        const Result<QByteArray> content = readWholeFile(dir.filePath(name), kMaxStandIn);
        if (!content) {
            return content.error();
        }
        if (Result<void> added = add(name, QString::fromUtf8(*content)); !added) {
            return added.error();
        }
    }
    return {};
}

Result<void> UrcapStandIns::add(const QString& name, const QString& text) {
    static const QRegularExpression kClass(QStringLiteral("^#\\s*class:\\s*(\\S+)\\s*$"));
    static const QRegularExpression kDefault(QStringLiteral("^#\\s*default\\s+([^:]+):\\s*(.*)$"));
    static const QRegularExpression kPart(QStringLiteral("^#\\s*(setup|node)\\s*$"));
    UrcapStandIn standIn;
    QStringList* part = &standIn.body;
    for (const QString& line : text.split('\n')) {
        if (const auto match = kClass.match(line); match.hasMatch()) {
            standIn.nodeClass = match.captured(1);
        } else if (const auto given = kDefault.match(line); given.hasMatch()) {
            standIn.defaults[given.captured(1).trimmed()] = given.captured(2).trimmed();
        } else if (const auto begins = kPart.match(line); begins.hasMatch()) {
            part = begins.captured(1) == QLatin1String("setup") ? &standIn.setup : &standIn.body;
        } else if (!line.trimmed().isEmpty()) {
            part->push_back(line);
        }
    }
    if (standIn.nodeClass.isEmpty()) {
        return Error{
            ErrorCode::FileCorrupt, QStringLiteral("'%1' has no line '# class: NAME'").arg(name), {}};
    }
    all_.insert(all_.begin(), std::move(standIn));
    return {};
}

const UrcapStandIn* UrcapStandIns::find(const QString& nodeClass) const {
    const auto found = std::ranges::find_if(all_, [&](const UrcapStandIn& standIn) {
        return nodeClass == standIn.nodeClass || nodeClass.endsWith('.' + standIn.nodeClass);
    });
    return found == all_.end() ? nullptr : &*found;
}

Result<QStringList> UrcapStandIns::bodyOf(const UrcapStandIn& standIn, const XmlElement& node) {
    static const QRegularExpression kPlace(QStringLiteral("\\{([^{}]+)\\}"));
    std::map<QString, QString> values = standIn.defaults;
    if (const XmlElement* const model = node.child("dataModel")) {
        for (const auto& data : model->children) {
            values[data->attribute("key")] = data->attribute("value");
        }
    }
    QStringList lines;
    for (const QString& line : standIn.body) {
        QString filled;
        qsizetype at = 0;
        for (auto it = kPlace.globalMatch(line); it.hasNext();) {
            const QRegularExpressionMatch match = it.next();
            const auto value = values.find(match.captured(1));
            if (value == values.end()) {
                return Error{ErrorCode::FileCorrupt,
                             QStringLiteral(
                                 "the node has no value '%1', and its stand-in has no default for this value")
                                 .arg(match.captured(1)),
                             {}};
            }
            filled += line.mid(at, match.capturedStart() - at) + literal(value->second);
            at = match.capturedEnd();
        }
        lines << filled + line.mid(at);
    }
    return lines;
}

}  // namespace tiller::simulator::pendant
