// SPDX-License-Identifier: MIT
#include "robot/control/detail/control_script.h"

#include <QRegularExpression>
#include <QSet>
#include <QStringList>
#include <algorithm>
#include <cmath>

#include "robot/control/detail/registers.h"
#include "robot/script/supervised_program.h"

namespace tiller::control {

namespace {

constexpr auto kIndent = "        ";

QString fixed(double value) {
    constexpr int kDigits = 6;
    return QString::number(value, 'f', kDigits);
}

QString numbers(const std::array<double, 6>& values) {
    QStringList out;
    for (const double value : values) {
        out.append(fixed(value));
    }
    return out.join(QLatin1String(", "));
}

/// Returns true if `version` is at least `since`. `since` contains the first versions for e-Series and CB3,
/// e.g. "5.10 3.15". Without a CB3 version, or with "-", this series does not have the function. A third
/// version is for PolyScope X; without it, the first version applies.
bool isSince(const SoftwareVersion& version, const QString& since) {
    const QStringList series = since.split(QLatin1Char(' '), Qt::SkipEmptyParts);
    const bool ownOfX = version.isPolyScopeX() && series.size() > 2;
    const QString least = series.value(ownOfX ? 2 : version.isCb3() ? 1 : 0, QStringLiteral("-"));
    if (least == QLatin1String("-")) {
        return false;
    }
    const QStringList parts = least.split(QLatin1Char('.'));
    return version >=
           SoftwareVersion{parts.value(0).toUInt(), parts.value(1).toUInt(), parts.value(2).toUInt(), 0};
}

/// mark  a function, e.g. "teach_mode", or a function and its first versions, e.g. "time 5.17"
/// Returns  true if the controller has the function and has not refused it
bool isCalled(const SoftwareVersion& version, const QString& mark, const QStringList& refused) {
    const QString since = mark.section(QLatin1Char(' '), 1);
    return !refused.contains(mark.section(QLatin1Char(' '), 0, 0)) &&
           (since.isEmpty() || isSince(version, since));
}

/// Empties the lines that do not apply to this software, controller or section. No lines are removed, so that
/// line numbers stay valid.
QString linesFor(const SoftwareVersion& version, const QString& source, const QString& section,
                 const QStringList& refused) {
    QStringList lines = source.split(QLatin1Char('\n'));
    QList<bool> wanted;  // one entry per enclosing block
    for (QString& line : lines) {
        const QString mark = line.trimmed();
        if (mark.startsWith(QLatin1String("#{{SINCE "))) {
            wanted << isSince(version, mark.mid(9).chopped(2));
        } else if (mark.startsWith(QLatin1String("#{{USES "))) {
            wanted << section.contains(mark.mid(8).chopped(2));
        } else if (mark.startsWith(QLatin1String("#{{CALLS "))) {
            wanted << isCalled(version, mark.mid(9).chopped(2), refused);
        } else if (mark == QLatin1String("#{{ELSE}}")) {
            wanted.last() = !wanted.last();
        } else if (mark == QLatin1String("#{{END}}")) {
            wanted.removeLast();
        } else if (!wanted.contains(false)) {
            continue;
        }
        line.clear();
    }
    return lines.join(QLatin1Char('\n'));
}

/// Prefixes the names of the program, so that they cannot conflict with names in a section.
QString prefixed(const QString& program) {
    static const QRegularExpression kDefinition(QStringLiteral("^    (?:(?:def|thread) (\\w+)\\(|(\\w+) = )"),
                                                QRegularExpression::MultilineOption);
    static const QRegularExpression kWord(
        QStringLiteral("\\{\\{[^}]*\\}\\}|#[^\\n]*|\"[^\"]*\"|\\b[A-Za-z_]\\w*\\b"));
    QSet<QString> own;
    for (auto it = kDefinition.globalMatch(program); it.hasNext();) {
        const auto match = it.next();
        own.insert(match.captured(1).isEmpty() ? match.captured(2) : match.captured(1));
    }
    QString out;
    qsizetype done = 0;
    for (auto it = kWord.globalMatch(program); it.hasNext();) {
        const auto match = it.next();
        if (own.contains(match.captured())) {
            out += QStringView(program).mid(done, match.capturedStart() - done);
            out += QLatin1String("tiller_") + match.captured();
            done = match.capturedEnd();
        }
    }
    return out + QStringView(program).mid(done).toString();
}

}  // namespace

QString ControlScript::place(int line, int column) const {
    const int inSection = line - sectionLine + 1;
    if (inSection >= 1 && inSection <= sectionLines && sectionLines > 0 && sectionLine > 0) {
        return QStringLiteral("line %1").arg(inSection);
    }
    const int added = line > sectionLine ? sectionLines - 1 : 0;
    // The second line of each file except the first contains the file name.
    int inPart = line - added + firstLine - 1;
    QString part = QStringLiteral("control.script");
    const QStringList lines = QString::fromUtf8(controlScriptTemplate()).split(QLatin1Char('\n'));
    for (qsizetype at = std::min<qsizetype>(inPart, lines.size()) - 1; at >= 0; --at) {
        if (lines[at].startsWith(QLatin1String("# PART "))) {
            part = lines[at].section(QLatin1Char(' '), 2, 2).chopped(1);
            inPart -= static_cast<int>(at) - 1;
            break;
        }
    }
    return QStringLiteral("%1 line %2, column %3").arg(part).arg(inPart).arg(column);
}

QString refusedName(const QString& text) {
    static const QRegularExpression kUnknown(QStringLiteral("name_not_found:(\\w+):"));
    static const QRegularExpression kOptional(QStringLiteral("#\\{\\{CALLS (\\w+)"));
    const QString name = kUnknown.match(text).captured(1);
    for (auto it = kOptional.globalMatch(QString::fromUtf8(controlScriptTemplate())); it.hasNext();) {
        const QString block = it.next().captured(1);
        // The call that ends teach mode is in the same block as the call that starts it.
        if (name == block || name == QLatin1String("end_") + block) {
            return block;
        }
    }
    return {};
}

ControlScript controlScript(const SoftwareVersion& version, RegisterRange range, std::int32_t session,
                            const MotionLimits& limits, const ArmLimits& arm, const QString& section,
                            const QStringList& refused, const ForceSettings& force,
                            std::chrono::milliseconds abandonedAfter) {
    const QString source = QString::fromUtf8(controlScriptTemplate());
    // Ports that accept scripts also execute single lines, so text before the program must not be sent.
    const qsizetype begin = source.indexOf(QLatin1String("def "));
    ControlScript script;
    script.text = prefixed(linesFor(version, source.mid(begin), section, refused));
    script.firstLine = static_cast<int>(source.left(begin).count(QLatin1Char('\n'))) + 1;
    const auto fill = [&](const char* name, const QString& value) {
        script.text.replace(QStringLiteral("{{%1}}").arg(QLatin1String(name)), value);
    };
    fill("FIRST", QString::number(firstRegister(range)));
    fill("SESSION", QString::number(session));
    fill("STEP", script::stepTimeText(version));
    fill("TIME_TO_LIVE", fixed(std::chrono::duration<double>(kHoldTime).count()));
    fill("BRAKE_LINEAR", fixed(limits.jogDeceleration));
    fill("BRAKE_ROTATION", fixed(limits.jointDeceleration));
    fill("BRAKE_JOINTS", fixed(limits.jointDeceleration));
    fill("STANDSTILL_TIME", fixed(std::chrono::duration<double>(kStandstillTime).count()));
    fill("BRAKE_MAX", fixed(kJointAccelerationLimit));
    fill("JOINT_SPEEDS", numbers(arm.maxSpeed));
    fill("JOINT_TORQUES", numbers(arm.maxTorque));
    fill("UPPER_ARM", fixed(std::abs(arm.dh.a[1])));
    fill("ABANDONED", fixed(std::chrono::duration<double>(abandonedAfter).count()));
    fill("LEEWAY", fixed(kJointLeeway));
    const auto setting = [&](const char* function, const char* since, const std::optional<double>& value) {
        return value && isSince(version, QLatin1String(since))
                   ? QStringLiteral("%1(%2)").arg(QLatin1String(function), fixed(*value))
                   : QString();
    };
    fill("FORCE_DAMPING", setting("force_mode_set_damping", "5.0 3.5", force.damping));
    fill("FORCE_GAIN_SCALING", setting("force_mode_set_gain_scaling", "5.0", force.gainScaling));
    fill("WATCHDOG", QString::fromStdString(watchdogName(range)));
    QStringList lines = section.trimmed().isEmpty() ? QStringList{QStringLiteral("sync()")}
                                                    : section.split(QLatin1Char('\n'));
    const qsizetype at = script.text.indexOf(QLatin1String("{{SECTION}}"));
    script.sectionLine = static_cast<int>(script.text.left(at).count(QLatin1Char('\n'))) + 1;
    script.sectionLines = static_cast<int>(lines.size());
    script.text.replace(at, QLatin1String("{{SECTION}}").size(),
                        lines.join(QLatin1Char('\n') + QLatin1String(kIndent)));
    return script;
}

}  // namespace tiller::control
