// SPDX-License-Identifier: MIT
#include "robot/recording/trigger.h"

#include <QDir>
#include <QFileInfo>
#include <QLocale>
#include <QRegularExpression>
#include <algorithm>
#include <cmath>
#include <utility>

namespace tiller::recording {

namespace {

using When = TriggerCondition::When;

Result<TriggerCondition> conditionIn(const QString& text) {
    static const QRegularExpression kComparison(QStringLiteral(
        "^\\s*(?:(\\w+)(?::(\\d{1,2}))?|norm\\s*\\(([^()]*)\\))\\s*(>|<|!=|==|=)\\s*(\\S+)\\s*$"));
    static const QRegularExpression kChange(QStringLiteral("^\\s*(\\w+)(?::(\\d{1,2}))?\\s+changes\\s*$"));
    static const QRegularExpression kColumn(QStringLiteral("^\\w+$"));
    TriggerCondition condition;
    if (text.simplified() == QLatin1String("program starts")) {
        condition.columns = {"runtime_state"};
        condition.when = When::Equal;
        constexpr double kPlaying = 2;  // value of runtime_state; source: RTDE guide
        condition.value = kPlaying;
        return condition;
    }
    const auto change = kChange.match(text);
    const auto comparison = kComparison.match(text);
    const auto match = change.hasMatch() ? change : comparison;
    bool ok = match.hasMatch();
    QStringList columns{match.captured(1)};
    if (comparison.hasMatch()) {
        const QString sign = comparison.captured(4);
        condition.when = sign == QLatin1String(">")    ? When::Above
                         : sign == QLatin1String("<")  ? When::Below
                         : sign == QLatin1String("!=") ? When::Unequal
                                                       : When::Equal;
        condition.value = comparison.captured(5).toDouble(&ok);
        ok = ok && std::isfinite(condition.value);
        condition.norm = columns.front().isEmpty();
        if (condition.norm) {
            columns = comparison.captured(3).split(QLatin1Char(','));
        }
    } else {
        condition.when = When::Changes;
    }
    for (const QString& column : std::as_const(columns)) {
        ok = ok && kColumn.match(column.trimmed()).hasMatch();
        condition.columns.push_back(column.trimmed().toStdString());
    }
    condition.bit = match.captured(2).isEmpty() ? -1 : match.captured(2).toInt();
    constexpr int kBits = 64;
    if (!ok || condition.bit >= kBits) {
        return Error{
            ErrorCode::InvalidArgument, QStringLiteral("read the trigger \"%1\"").arg(text.trimmed()),
            QStringLiteral("expected COLUMN > NUMBER (or <, =, !=), COLUMN:BIT = 1, "
                           "norm(COLUMN, COLUMN, ...) > NUMBER, COLUMN changes, or \"program starts\"; "
                           "combine conditions with \"and\" and \"or\"")};
    }
    return condition;
}

QString textOf(const TriggerCondition& condition, double value) {
    QStringList columns;
    for (const std::string& column : condition.columns) {
        columns << QString::fromStdString(column);
    }
    QString subject = columns.join(QStringLiteral(", "));
    subject = condition.norm ? QStringLiteral("norm(%1)").arg(subject) : subject;
    subject += condition.bit < 0 ? QString() : QStringLiteral(":%1").arg(condition.bit);
    const QString now = QString::number(value, 'g', QLocale::FloatingPointShortest);
    if (condition.when == When::Changes) {
        return QStringLiteral("%1 changes (%2)").arg(subject, now);
    }
    const QString sign = condition.when == When::Above   ? QStringLiteral(">")
                         : condition.when == When::Below ? QStringLiteral("<")
                         : condition.when == When::Equal ? QStringLiteral("=")
                                                         : QStringLiteral("!=");
    return QStringLiteral("%1 %2 %3 (%4)")
        .arg(subject, sign, QString::number(condition.value, 'g', QLocale::FloatingPointShortest), now);
}

}  // namespace

Result<RecordingTrigger> RecordingTrigger::parse(const Text& text) {
    static const QRegularExpression kOr(QStringLiteral("\\s+or\\s+|\\|\\|"),
                                        QRegularExpression::CaseInsensitiveOption);
    static const QRegularExpression kAnd(QStringLiteral("\\s+and\\s+|&&"),
                                         QRegularExpression::CaseInsensitiveOption);
    RecordingTrigger trigger;
    const QStringList alternatives = text.split(kOr);
    for (const QString& alternative : alternatives) {
        std::vector<TriggerCondition> all;
        const QStringList conditions = alternative.split(kAnd);
        for (const QString& each : conditions) {
            auto condition = conditionIn(each);
            if (!condition) {
                return condition.error();
            }
            all.push_back(std::move(condition).value());
        }
        trigger.any.push_back(std::move(all));
    }
    return trigger;
}

std::vector<std::string> RecordingTrigger::columns() const {
    std::vector<std::string> columns;
    for (const std::vector<TriggerCondition>& all : any) {
        for (const TriggerCondition& condition : all) {
            for (const std::string& column : condition.columns) {
                if (std::find(columns.begin(), columns.end(), column) == columns.end()) {
                    columns.push_back(column);
                }
            }
        }
    }
    return columns;
}

Result<TriggerWatch> TriggerWatch::make(const RecordingTrigger& trigger,
                                        const receive::SampleLayout& layout) {
    TriggerWatch watch(trigger);
    for (const std::vector<TriggerCondition>& all : trigger.any) {
        std::vector<Watched>& conditions = watch.any_.emplace_back();
        for (const TriggerCondition& condition : all) {
            Watched& watched = conditions.emplace_back();
            watched.condition = condition;
            for (const std::string& column : condition.columns) {
                const auto index = layout.indexOfComponent(column);
                if (!index) {
                    return Error{ErrorCode::FieldUnknown, QStringLiteral("monitor the trigger"),
                                 QStringLiteral("no received column is named \"%1\"; vectors have one column "
                                                "per number, such as actual_q_0")
                                     .arg(Text(column))};
                }
                watched.indices.push_back(*index);
            }
        }
    }
    return watch;
}

bool TriggerWatch::holds(Watched& watched, const receive::Sample& sample) {
    const TriggerCondition& condition = watched.condition;
    double value = sample.at(watched.indices.front());
    if (condition.norm) {
        double squares = 0;
        for (const std::size_t index : watched.indices) {
            squares += sample.at(index) * sample.at(index);
        }
        value = std::sqrt(squares);
    }
    if (std::isnan(value)) {
        return false;
    }
    if (condition.bit >= 0) {
        value = std::fmod(std::floor(value / std::ldexp(1.0, condition.bit)), 2.0);
    }
    watched.value = value;
    const std::optional<double> before = std::exchange(watched.previous, value);
    switch (condition.when) {
        case When::Above:
            return value > condition.value;
        case When::Below:
            return value < condition.value;
        case When::Equal:
            return value == condition.value;
        case When::Unequal:
            return value != condition.value;
        case When::Changes:
            return before && *before != value;
    }
    return false;
}

bool TriggerWatch::isActive(const receive::Sample& sample) {
    bool isActive = false;
    for (std::vector<Watched>& all : any_) {
        bool isTrue = true;
        for (Watched& watched : all) {
            // Evaluate every condition, so that it has the previous value.
            isTrue = holds(watched, sample) && isTrue;
        }
        if (isTrue && !isActive && !held_ && !recording_) {
            QStringList texts;
            for (const Watched& watched : all) {
                texts << textOf(watched.condition, watched.value);
            }
            cause_ = texts.join(QStringLiteral(" and "));
        }
        isActive = isActive || isTrue;
    }
    return isActive;
}

TriggerWatch::Verdict TriggerWatch::add(const receive::Sample& sample) {
    const bool now = isActive(sample);
    const bool cameTrue = !std::exchange(held_, now) && now;
    if (now) {
        heldUntilNs_ = sample.hostTimeNs;
    }
    if (!recording_) {
        recording_ = cameTrue;
        return cameTrue ? Verdict::Begin : Verdict::Keep;
    }
    if (static_cast<double>(sample.hostTimeNs - heldUntilNs_) > after_ * 1e9) {
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
