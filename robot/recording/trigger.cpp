// SPDX-License-Identifier: MIT
#include "robot/recording/trigger.h"

#include <QDir>
#include <QFileInfo>
#include <QRegularExpression>
#include <cmath>
#include <utility>

namespace tiller::recording {

Result<RecordingTrigger> RecordingTrigger::parse(const Text& text) {
    static const QRegularExpression kComparison(
        QStringLiteral("^\\s*(\\w+)(?::(\\d{1,2}))?\\s*(>|<|!=|==|=)\\s*(\\S+)\\s*$"));
    static const QRegularExpression kChange(QStringLiteral("^\\s*(\\w+)(?::(\\d{1,2}))?\\s+changes\\s*$"));
    RecordingTrigger trigger;
    if (text.simplified() == QLatin1String("program starts")) {
        trigger.column = "runtime_state";
        trigger.when = When::Equal;
        constexpr double kPlaying = 2;  // value of runtime_state; source: RTDE guide
        trigger.value = kPlaying;
        return trigger;
    }
    const auto change = kChange.match(text);
    const auto comparison = kComparison.match(text);
    const auto match = change.hasMatch() ? change : comparison;
    bool ok = match.hasMatch();
    if (comparison.hasMatch()) {
        const QString sign = comparison.captured(3);
        trigger.when = sign == QLatin1String(">")    ? When::Above
                       : sign == QLatin1String("<")  ? When::Below
                       : sign == QLatin1String("!=") ? When::Unequal
                                                     : When::Equal;
        trigger.value = comparison.captured(4).toDouble(&ok);
        ok = ok && std::isfinite(trigger.value);
    } else {
        trigger.when = When::Changes;
    }
    trigger.column = match.captured(1).toStdString();
    trigger.bit = match.captured(2).isEmpty() ? -1 : match.captured(2).toInt();
    constexpr int kBits = 64;
    if (!ok || trigger.bit >= kBits) {
        return Error{ErrorCode::InvalidArgument, QStringLiteral("read the trigger \"%1\"").arg(text),
                     QStringLiteral("expected COLUMN > NUMBER (or <, =, !=), COLUMN:BIT = 1, COLUMN changes, "
                                    "or \"program starts\"")};
    }
    return trigger;
}

Result<TriggerWatch> TriggerWatch::make(const RecordingTrigger& trigger,
                                        const receive::SampleLayout& layout) {
    const auto index = layout.indexOfComponent(trigger.column);
    if (!index) {
        return Error{
            ErrorCode::FieldUnknown, QStringLiteral("monitor the trigger"),
            QStringLiteral(
                "no received column is named \"%1\"; vectors have one column per number, such as actual_q_0")
                .arg(Text(trigger.column))};
    }
    TriggerWatch watch(trigger);
    watch.index_ = *index;
    return watch;
}

bool TriggerWatch::holds(double value) {
    if (std::isnan(value)) {
        return false;
    }
    if (trigger_.bit >= 0) {
        const double whole = std::fmod(std::floor(value / std::ldexp(1.0, trigger_.bit)), 2.0);
        value = whole;
    }
    const std::optional<double> before = std::exchange(previous_, value);
    switch (trigger_.when) {
        case RecordingTrigger::When::Above:
            return value > trigger_.value;
        case RecordingTrigger::When::Below:
            return value < trigger_.value;
        case RecordingTrigger::When::Equal:
            return value == trigger_.value;
        case RecordingTrigger::When::Unequal:
            return value != trigger_.value;
        case RecordingTrigger::When::Changes:
            return before && *before != value;
    }
    return false;
}

TriggerWatch::Verdict TriggerWatch::add(const receive::Sample& sample) {
    const bool now = holds(sample.at(index_));
    const bool cameTrue = !std::exchange(held_, now) && now;
    if (now) {
        heldUntilNs_ = sample.hostTimeNs;
    }
    if (!recording_) {
        recording_ = cameTrue;
        return cameTrue ? Verdict::Begin : Verdict::Keep;
    }
    if (static_cast<double>(sample.hostTimeNs - heldUntilNs_) > trigger_.after * 1e9) {
        recording_ = false;
        return Verdict::End;
    }
    return Verdict::Write;
}

QString numberedPath(const QString& path, int number) {
    const QFileInfo info(path);
    const QString suffix = info.suffix().isEmpty() ? QString() : QLatin1Char('.') + info.suffix();
    const QString name = info.fileName().chopped(suffix.size());
    return info.dir().filePath(
        QStringLiteral("%1_%2%3").arg(name).arg(number, 3, 10, QLatin1Char('0')).arg(suffix));
}

}  // namespace tiller::recording
