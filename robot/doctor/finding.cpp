// SPDX-License-Identifier: MIT
#include "robot/doctor/finding.h"

#include <QCoreApplication>
#include <QJsonArray>
#include <array>

namespace tiller::doctor {
namespace {

struct Row {
    const char* id;
    const char* title;
};

constexpr std::array<Row, kConditionCount> kRows = {{
    {"address", QT_TRANSLATE_NOOP("Doctor", "Address resolves")},
    {"host", QT_TRANSLATE_NOOP("Doctor", "Host responds")},
    {"port.rtde", QT_TRANSLATE_NOOP("Doctor", "RTDE port")},
    {"port.primary", QT_TRANSLATE_NOOP("Doctor", "Primary port")},
    {"port.secondary", QT_TRANSLATE_NOOP("Doctor", "Secondary port")},
    {"port.realtime", QT_TRANSLATE_NOOP("Doctor", "Real-time port")},
    {"port.service", QT_TRANSLATE_NOOP("Doctor", "Dashboard or Robot API")},
    {"protocol", QT_TRANSLATE_NOOP("Doctor", "RTDE protocol")},
    {"software", QT_TRANSLATE_NOOP("Doctor", "Controller software")},
    {"model", QT_TRANSLATE_NOOP("Doctor", "Robot model")},
    {"remote", QT_TRANSLATE_NOOP("Doctor", "Remote control")},
    {"safety", QT_TRANSLATE_NOOP("Doctor", "Safety")},
    {"power", QT_TRANSLATE_NOOP("Doctor", "Power and brakes")},
    {"registers.upper", QT_TRANSLATE_NOOP("Doctor", "Control registers free")},
    {"registers.lower", QT_TRANSLATE_NOOP("Doctor", "Fieldbus registers free")},
    {"rate", QT_TRANSLATE_NOOP("Doctor", "Data rate")},
    {"privilege", QT_TRANSLATE_NOOP("Doctor", "Real-time priority on this PC")},
    {"latency", QT_TRANSLATE_NOOP("Doctor", "Wake-up latency on this PC")},
    {"payload", QT_TRANSLATE_NOOP("Doctor", "TCP and payload")},
}};

const Row& rowOf(Condition condition) {
    return kRows[static_cast<std::size_t>(condition)];
}

}  // namespace

QString conditionId(Condition condition) {
    return QLatin1String(rowOf(condition).id);
}

QString conditionTitle(Condition condition) {
    return QCoreApplication::translate("Doctor", rowOf(condition).title);
}

QString verdictName(Verdict verdict) {
    switch (verdict) {
        case Verdict::Good:
            return QStringLiteral("good");
        case Verdict::Attention:
            return QStringLiteral("attention");
        case Verdict::Bad:
            return QStringLiteral("bad");
        case Verdict::Skipped:
            break;
    }
    return QStringLiteral("skipped");
}

Verdict overall(const Report& report) {
    Verdict worst = Verdict::Good;
    for (const Finding& finding : report) {
        if (finding.verdict == Verdict::Bad) {
            return Verdict::Bad;
        }
        if (finding.verdict == Verdict::Attention) {
            worst = Verdict::Attention;
        }
    }
    return worst;
}

QJsonObject toJson(const Report& report) {
    QJsonArray findings;
    for (const Finding& finding : report) {
        findings.append(QJsonObject{
            {"condition", conditionId(finding.condition)},
            {"title", conditionTitle(finding.condition)},
            {"verdict", verdictName(finding.verdict)},
            {"cause", finding.cause},
            {"detail", finding.detail},
            {"fix", finding.fix},
        });
    }
    return {{"verdict", verdictName(overall(report))}, {"findings", findings}};
}

QString toText(const Report& report) {
    QString text;
    for (const Finding& finding : report) {
        text += QStringLiteral("%1  %2%3\n")
                    .arg(verdictName(finding.verdict).leftJustified(9), conditionTitle(finding.condition),
                         finding.detail.isEmpty() ? QString() : QStringLiteral(": ") + finding.detail);
        if (!finding.fix.isEmpty()) {
            text += QStringLiteral("           ") + finding.fix + QLatin1Char('\n');
        }
    }
    return text;
}

}  // namespace tiller::doctor
