// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/signals/signal_store.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "robot/receive/receiver.h"

namespace tiller {

namespace {

constexpr double kNoData = std::numeric_limits<double>::quiet_NaN();
/// Behind the newest sample its value holds for as long [s].
constexpr double kHolds = 0.05;

}  // namespace

SignalStore::SignalStore(const HistoryLimits& limits, QObject* parent) : QObject(parent), limits_(limits) {
    for (int i = 0; i < 2; ++i) {
        tables_.push_back({std::make_unique<SeriesBuffer>(), {}, {}});
    }
    const QVector<SignalInfo> all = robotSignals();
    for (const SignalInfo& info : all) {
        byKey_.insert(info.key, count());
        signals_.emplace_back().info = info;
    }
    for (const std::string& field : receive::defaultFields()) {
        addField(kLive, QString::fromStdString(field));
    }
    share();
}

void SignalStore::addField(int table, const QString& field) {
    Table& into = tables_[static_cast<std::size_t>(table)];
    for (Signal& signal : signals_) {
        if (signal.info.field != field || signal.column >= 0) {
            continue;
        }
        const receive::FieldInfo* info = receive::findField(field.toStdString());
        const std::string name = info->componentName(signal.info.component);
        const auto known = std::find(into.columns.begin(), into.columns.end(), name);
        signal.table = table;
        signal.column = static_cast<int>(known - into.columns.begin());
        if (known == into.columns.end()) {
            into.buffer->addColumn(signal.info.precision());
            into.columns.push_back(name);
            into.derived.push_back(-1);
        }
    }
}

const SeriesBuffer* SignalStore::buffer(int signal) const {
    const int table = signals_[static_cast<std::size_t>(signal)].table;
    return table == kNowhere ? nullptr : tables_[static_cast<std::size_t>(table)].buffer.get();
}

double SignalStore::value(int signal, std::int64_t sample) const {
    const SeriesBuffer* buffer = this->buffer(signal);
    if (buffer == nullptr) {
        return kNoData;
    }
    const double value = buffer->value(column(signal), sample);
    const int bit = info(signal).bit;
    if (bit < 0 || !(value >= 0)) {
        return bit < 0 ? value : kNoData;
    }
    return static_cast<double>(static_cast<std::uint64_t>(value) >> bit & 1);
}

std::optional<double> SignalStore::valueAt(int signal, double time) const {
    const SeriesBuffer* buffer = this->buffer(signal);
    const std::int64_t at = buffer == nullptr ? -1 : buffer->lastBefore(time);
    if (at < 0) {
        return std::nullopt;
    }
    const bool isLast = at + 1 == buffer->end();
    if (isLast ? time > buffer->lastTime() + kHolds : buffer->time(at) != time && buffer->gapBefore(at + 1)) {
        return std::nullopt;
    }
    const double value = this->value(signal, at);
    return std::isnan(value) ? std::nullopt : std::optional<double>(value);
}

std::vector<std::int64_t> SignalStore::changes(int signal, std::int64_t begin, std::int64_t end) const {
    std::vector<std::int64_t> found;
    const SeriesBuffer* buffer = this->buffer(signal);
    if (buffer == nullptr) {
        return found;
    }
    // Stretches in which the whole column is the same are stepped over.
    constexpr std::int64_t kStretch = 256;
    const auto differs = [](double a, double b) { return a != b && !(std::isnan(a) && std::isnan(b)); };
    const int column = this->column(signal);
    std::int64_t at = std::max(begin, buffer->first() + 1);
    const std::int64_t stop = std::min(end, buffer->end());
    while (at < stop) {
        const std::int64_t to = std::min(stop, (at | (kStretch - 1)) + 1);
        const MinMax extent = buffer->minMax(column, at - 1, to);
        const bool same =
            !extent.isEmpty() && extent.min == extent.max && !std::isnan(buffer->value(column, at - 1));
        if (same || extent.isEmpty()) {
            // NaN hides in an extent: a stretch that begins with a value and ends with one may have a hole.
            if (extent.isEmpty() || !std::isnan(buffer->value(column, to - 1))) {
                at = to;
                continue;
            }
        }
        for (; at < to; ++at) {
            if (differs(value(signal, at), value(signal, at - 1))) {
                found.push_back(at);
            }
        }
    }
    return found;
}

Result<int> SignalStore::derive(const QString& text) {
    const auto exists = [this](const QString& key) {
        const int signal = find(key);
        return signal >= 0 && info(signal).bit < 0;
    };
    Result<std::shared_ptr<Derivation>> made = Derivation::make(text, exists);
    if (!made) {
        return made.error();
    }
    const std::shared_ptr<Derivation> derivation = *made;
    if (const int known = find(derivation->text()); known >= 0) {
        return known;
    }
    const Error context{ErrorCode::InvalidArgument, tr("compute a signal"), {}};
    Signal signal;
    for (const QString& key : derivation->inputs()) {
        const int input = find(key);
        const Signal& from = signals_[static_cast<std::size_t>(input)];
        if (from.table == kNowhere) {
            addField(kFurther, from.info.field);
        }
        if (signal.table != kNowhere && signal.table != from.table) {
            return Error{context.code, context.context,
                         tr("%1 does not come in the same packets as the others.").arg(key)};
        }
        signal.table = from.table;
        signal.inputs.push_back(input);
        signal.inputColumns.push_back(from.column);
    }
    SignalInfo& info = signal.info;
    info.key = derivation->text();
    info.group = tr("Derived");
    info.family = info.label = info.longLabel = derivation->name();
    info.meaning = derivation->text();
    setUnit(info, derivation->unit());
    Table& table = tables_[static_cast<std::size_t>(signal.table)];
    signal.column = table.buffer->addColumn(Precision::Single);
    signal.derivation = derivation;
    table.columns.push_back(info.key.toStdString());
    const int number = count();
    table.derived.push_back(number);
    byKey_.insert(info.key, number);
    signals_.push_back(std::move(signal));
    table.buffer->fillColumn(column(number),
                             [&](std::int64_t sample) { return derivedAt(*table.buffer, number, sample); });
    share();
    Q_EMIT signalAdded(number);
    return number;
}

int SignalStore::findOrDerive(const QString& key) {
    if (const int known = find(key); known >= 0 || !key.contains(QLatin1Char('='))) {
        return known;
    }
    const Result<int> made = derive(key);
    return made ? *made : -1;
}

QStringList SignalStore::fieldsFor(const QHash<const void*, QSet<int>>& wanted) const {
    QStringList fields;
    const auto add = [&](const Signal& one) {
        if (!one.info.field.isEmpty() && one.table != kLive && !fields.contains(one.info.field)) {
            fields.append(one.info.field);
        }
    };
    for (const QSet<int>& shown : wanted) {
        for (const int signal : shown) {
            add(signals_[static_cast<std::size_t>(signal)]);
            for (const int input : signals_[static_cast<std::size_t>(signal)].inputs) {
                add(signals_[static_cast<std::size_t>(input)]);
            }
        }
    }
    std::sort(fields.begin(), fields.end());
    return fields;
}

bool SignalStore::want(const void* who, const QSet<int>& shown) {
    QHash<const void*, QSet<int>> wanted = wanted_;
    if (shown.isEmpty()) {
        wanted.remove(who);
    } else {
        wanted[who] = shown;
    }
    const QStringList fields = fieldsFor(wanted);
    if (fields == furtherFields_) {
        wanted_ = wanted;
        return true;
    }
    constexpr qsizetype kTimestamp = 10;  // with its comma
    if (static_cast<std::size_t>(fields.join(QLatin1Char(',')).size() + kTimestamp) >
        receive::longestFieldList()) {
        return false;
    }
    for (const QString& field : std::as_const(fields)) {
        addField(kFurther, field);
    }
    share();
    wanted_ = wanted;
    furtherFields_ = fields;
    Q_EMIT furtherFieldsChanged(furtherFields_);
    return true;
}

void SignalStore::setLimits(const HistoryLimits& limits) {
    limits_ = limits;
    share();
}

void SignalStore::share() {
    // Times count as two columns.
    const auto weight = [](const Table& table) { return static_cast<double>(table.columns.size() + 2); };
    const double all =
        weight(tables_[kLive]) + (tables_[kFurther].columns.empty() ? 0 : weight(tables_[kFurther]));
    for (Table& table : tables_) {
        HistoryLimits part = limits_;
        part.bytes = static_cast<std::size_t>(static_cast<double>(limits_.bytes) * weight(table) / all);
        table.buffer->setLimits(part);
    }
}

std::size_t SignalStore::memoryBytes() const {
    std::size_t bytes = 0;
    for (const Table& table : tables_) {
        bytes += table.buffer->memoryBytes();
    }
    return bytes;
}

}  // namespace tiller

#include "moc_signal_store.cpp"
