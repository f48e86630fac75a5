// SPDX-License-Identifier: MIT
#include "robot/station/history/signal_store.h"

#include <QFileInfo>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "robot/receive/receiver.h"
#include "robot/recording/export.h"
#include "robot/station/history/selected_signals.h"

namespace tiller {

namespace {

constexpr double kNoData = std::numeric_limits<double>::quiet_NaN();
/// Time for which the newest sample is valid [s].
constexpr double kHolds = 0.05;

/// Adds the row times of a recording as samples without values.
Result<void> readTimes(const recording::Recording& file, SeriesBuffer& history, double begin) {
    const Result<std::vector<double>> times = file.times({0, file.rows()});
    if (!times) {
        return times.error();
    }
    std::vector<SeriesBuffer::Row> rows;
    rows.reserve(times->size());
    for (const double time : *times) {
        double at = begin + time;
        if (!rows.empty() && !(at > rows.back().time)) {
            at = std::nextafter(rows.back().time, std::numeric_limits<double>::infinity());
        }
        rows.push_back({at, false});
    }
    for (const recording::RecordedGap& gap : file.gaps()) {
        if (gap.row < rows.size()) {
            rows[gap.row].gapBefore = true;
        }
    }
    for (const recording::RowRange& missing : file.unreadable()) {
        if (missing.first + missing.count < rows.size()) {
            rows[missing.first + missing.count].gapBefore = true;
        }
    }
    history.appendRows(rows, [](std::size_t, std::size_t) { return kNoData; });
    return {};
}

/// The newest sample after a gap, or the first sample. A receiver that reconnects by itself leaves a gap.
std::int64_t lastGap(const SeriesBuffer& history) {
    std::int64_t sample = history.end() - 1;
    while (sample > history.first() && !history.gapBefore(sample)) {
        --sample;
    }
    return sample;
}

}  // namespace

void SignalStore::setRobot(const QString& address, const QString& name) {
    linkFirst_ = live().end();
    if (!robots_.empty() && robots_.back().first == linkFirst_) {
        robots_.pop_back();  // this robot sent no samples
    }
    if (robots_.empty() || robots_.back().address != address) {
        robots_.push_back({linkFirst_, address, name, {}});
    }
}

void SignalStore::setRobotModel(RobotModelId model) {
    if (robots_.empty()) {
        return;
    }
    HistoryRobot& newest = robots_.back();
    const std::int64_t first =
        newest.model && *newest.model != model ? std::max(linkFirst_, lastGap(live())) : newest.first;
    if (newest.first < first) {
        robots_.push_back({first, newest.address, newest.name, model});
    } else {
        newest.model = model;
    }
}

const HistoryRobot* SignalStore::robotAt(double time) const {
    const auto sample = heldAt(live(), time);
    if (!sample) {
        return nullptr;
    }
    const auto after =
        std::upper_bound(robots_.begin(), robots_.end(), *sample,
                         [](std::int64_t at, const HistoryRobot& robot) { return at < robot.first; });
    return after == robots_.begin() ? nullptr : &*std::prev(after);
}

std::optional<std::int64_t> SignalStore::newestRobotChange() const {
    const bool isChange = robots_.size() > 1 && robots_.back().first < live().end();
    return isChange ? std::optional(robots_.back().first) : std::nullopt;
}

bool SignalStore::hasSeveralRobots(double from, double to) const {
    const double earliest = std::min(from, to);
    const double latest = std::max(from, to);
    return std::any_of(robots_.begin(), robots_.end(), [&](const HistoryRobot& robot) {
        const std::int64_t change = robot.first;
        return &robot != &robots_.front() && live().first() < change && change < live().end() &&
               earliest <= live().time(change - 1) && latest >= live().time(change);
    });
}

SignalStore::SignalStore(const HistoryLimits& limits, QObject* parent) : QObject(parent), limits_(limits) {
    for (int i = 0; i < 2; ++i) {
        tables_.emplace_back().buffer = std::make_unique<SeriesBuffer>();
    }
    const QVector<SignalInfo> all = robotSignals();
    for (const SignalInfo& info : all) {
        byKey_.insert(info.key, count());
        signals_.emplace_back().info = info;
    }
    for (const std::string& field : receive::defaultFields()) {
        addField(kLive, QString::fromStdString(field));
    }
    tables_[kLive].layout = std::make_shared<const receive::SampleLayout>(receive::defaultFields());
    share();
}

void SignalStore::addField(int table, const QString& field) {
    Table& into = tables_[static_cast<std::size_t>(table)];
    for (Signal& signal : signals_) {
        if (signal.info.field != field || signal.column >= 0 || signal.table >= kFirstRecording) {
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

std::optional<std::int64_t> SignalStore::heldAt(const SeriesBuffer& buffer, double time) {
    const std::int64_t at = buffer.lastBefore(time);
    if (at < 0) {
        return std::nullopt;
    }
    const bool isLast = at + 1 == buffer.end();
    if (isLast ? time > buffer.lastTime() + kHolds : buffer.time(at) != time && buffer.gapBefore(at + 1)) {
        return std::nullopt;
    }
    return at;
}

std::optional<double> SignalStore::valueAt(int signal, double time) const {
    const SeriesBuffer* buffer = this->buffer(signal);
    const auto at = buffer == nullptr ? std::nullopt : heldAt(*buffer, time);
    if (!at) {
        return std::nullopt;
    }
    const double value = this->value(signal, *at);
    return std::isnan(value) ? std::nullopt : std::optional<double>(value);
}

std::vector<std::int64_t> SignalStore::changes(int signal, std::int64_t begin, std::int64_t end) const {
    std::vector<std::int64_t> found;
    const SeriesBuffer* buffer = this->buffer(signal);
    if (buffer == nullptr) {
        return found;
    }
    // Skip ranges in which the whole column is constant.
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
            // Extents ignore NaN, so a range that begins and ends with a value may contain a sample without a
            // value.
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
        return signal >= 0 && info(signal).bit < 0 && !isDerived(signal);
    };
    Result<std::shared_ptr<DerivedSignal>> made = DerivedSignal::make(text, exists);
    if (!made) {
        return made.error();
    }
    const std::shared_ptr<DerivedSignal> derivation = *made;
    if (const int known = find(derivation->text()); known >= 0) {
        if (Signal& one = signals_[static_cast<std::size_t>(known)];
            one.computedPart < 1 && !one.isComputing) {
            compute(known);  // retry after an earlier failure
        }
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
                         tr("%1 is not part of the same RTDE packets as the other signals.").arg(key)};
        }
        signal.table = from.table;
        signal.inputs.push_back(input);
    }
    if (signal.table >= kFirstRecording) {
        problem_.clear();
        const QSet<int> needed(signal.inputs.begin(), signal.inputs.end());
        bool isThere = loadOutlines(needed);
        for (const int input : needed) {
            isThere = isThere && load(input);
        }
        if (!isThere) {
            return Error{ErrorCode::FileNotReadable, context.context, problem_};
        }
    }
    for (const int input : signal.inputs) {
        signal.inputColumns.push_back(column(input));
    }
    SignalInfo& info = signal.info;
    info.key = derivation->text();
    info.group = signal.table < kFirstRecording ? tr("Derived") : this->info(signal.inputs.front()).group;
    info.family = info.label = info.longLabel = derivation->name();
    info.meaning = derivation->text();
    setUnit(info, derivation->unit());
    Table& table = tables_[static_cast<std::size_t>(signal.table)];
    table.columns.push_back(info.key.toStdString());
    const int number = count();
    table.derived.push_back(number);
    byKey_.insert(info.key, number);
    signal.derivation = derivation;
    signals_.push_back(std::move(signal));
    if (table.pieces) {
        compute(number);
    } else {
        signals_.back().column = table.buffer->addColumn(Precision::Single);
        table.buffer->fillColumn(
            column(number), [&](std::int64_t sample) { return derivedAt(*table.buffer, number, sample); });
    }
    share();
    Q_EMIT signalAdded(number);
    return number;
}

RecordedSignal SignalStore::recordedSignal(int signal) const {
    const Signal& wanted = signals_[static_cast<std::size_t>(signal)];
    if (!wanted.derivation) {
        return {{fileColumnOf(signal)}, wanted.info.bit, {}};
    }
    RecordedSignal computed{{}, -1, wanted.derivation->text()};
    for (const int input : wanted.inputs) {
        computed.columns.push_back(fileColumnOf(input));
    }
    return computed;
}

std::optional<RecordedStretch> SignalStore::stretchOf(std::span<const int> wanted, std::int64_t begin,
                                                      std::int64_t end) const {
    RecordedStretch stretch;
    const Table* table = nullptr;
    for (const int signal : wanted) {
        const int number = signals_[static_cast<std::size_t>(signal)].table;
        const Table* of = number < kFirstRecording ? nullptr : &tables_[static_cast<std::size_t>(number)];
        if (of == nullptr || !of->pieces || (table != nullptr && of != table)) {
            return std::nullopt;
        }
        table = of;
        stretch.wanted.push_back(recordedSignal(signal));
    }
    if (table == nullptr || begin >= end) {
        return std::nullopt;
    }
    stretch.path = table->file->path();
    stretch.begin = table->pieces->begin();
    stretch.startUtcNs = table->file->startUtcNs();
    stretch.columns = table->file->columns().size();
    stretch.rows = {static_cast<std::uint64_t>(begin), static_cast<std::uint64_t>(end - begin)};
    return stretch;
}

std::unique_ptr<SelectedSignals> SignalStore::selected(std::span<const int> wanted) const {
    const Table& table =
        tables_[static_cast<std::size_t>(signals_[static_cast<std::size_t>(wanted.front())].table)];
    const auto time = recording::timeColumn(*table.file);
    std::vector<SelectedSignals::Column> columns;
    for (const int signal : wanted) {
        const RecordedSignal from = recordedSignal(signal);
        const SignalInfo& info = this->info(signal);
        recording::RecordedColumn column;
        if (from.derivation.isEmpty() && from.bit < 0) {
            if (time == from.columns.front()) {
                continue;
            }
            column = table.file->columns()[from.columns.front()];
        } else if (from.derivation.isEmpty()) {
            column = {info.key.mid(table.name.size() + 1).toStdString(), {}, true};
        } else {
            column = {from.derivation.toStdString(), info.unit.toStdString()};
        }
        columns.push_back({column, from});
    }
    return std::make_unique<SelectedSignals>(*table.file, columns);
}

void SignalStore::compute(int signal) {
    Signal& computed = signals_[static_cast<std::size_t>(signal)];
    Table& table = tables_[static_cast<std::size_t>(computed.table)];
    if (computed.column < 0) {
        computed.column = table.pieces->addComputed(recordedSignal(signal));
    }
    computed.computedPart = 0;
    computed.isComputing = true;
    const std::array<int, 1> itself = {signal};
    const RecordedStretch stretch = *stretchOf(itself, 0, table.buffer->end());
    // All rows must be read, which takes several seconds per hour of data, so this runs on the worker.
    worker_.post(this, [this, signal, stretch, closing = closing_](const CancelToken& ending) {
        if (closing.isCancelled()) {
            return std::function<void()>();
        }
        const auto read = stretch.readAll(ending, [&](std::uint64_t first, const RecordedRows::Rows& rows) {
            constexpr auto kEach = static_cast<std::size_t>(SeriesColumn::kSummary);
            std::vector<MinMax> extents((rows.times.size() + kEach - 1) / kEach);
            for (std::size_t row = 0; row < rows.times.size(); ++row) {
                extents[row / kEach].add(rows.values.front()[row]);
            }
            QMetaObject::invokeMethod(
                this,
                [this, signal, first, closing, extents = std::move(extents)] {
                    if (!closing.isCancelled()) {
                        takeExtents(signal, static_cast<std::int64_t>(first), extents);
                    }
                },
                Qt::QueuedConnection);
            return !closing.isCancelled();
        });
        return std::function<void()>([this, signal, closing, read] {
            if (closing.isCancelled()) {
                return;
            }
            Signal& done = signals_[static_cast<std::size_t>(signal)];
            done.isComputing = false;
            done.computedPart = read ? 1 : done.computedPart;
            Q_EMIT computedFurther(signal);
            if (!read) {
                Q_EMIT computationFailed(tr("%1 could not be computed completely: %2")
                                             .arg(info(signal).longLabel, read.error().toString()));
            }
        });
    });
}

void SignalStore::takeExtents(int signal, std::int64_t first, std::span<const MinMax> extents) {
    Signal& computed = signals_[static_cast<std::size_t>(signal)];
    SeriesBuffer& history = *tables_[static_cast<std::size_t>(computed.table)].buffer;
    history.setExtents(computed.column, first, SeriesColumn::kSummary, extents);
    computed.computedPart = static_cast<double>(first) / static_cast<double>(history.end());
    Q_EMIT computedFurther(signal);
}

int SignalStore::findOrDerive(const QString& key) {
    if (const int known = find(key); known >= 0 || !key.contains(QLatin1Char('='))) {
        return known;
    }
    const Result<int> made = derive(key);
    return made ? *made : -1;
}

double SignalStore::controllerTime(double time) const {
    const auto next = std::upper_bound(
        clocks_.begin(), clocks_.end(), time,
        [](double wanted, const std::pair<double, double>& clock) { return wanted < clock.first; });
    if (next == clocks_.begin()) {
        return time;
    }
    // Remove the rounding error of the sum with the offset. Time stamps have at most nine decimal places.
    constexpr double kPerSecond = 1e9;
    return std::round((time - (next - 1)->second) * kPerSecond) / kPerSecond;
}

QStringList SignalStore::shownFields() const {
    return fieldsFor(wanted_, true);
}

QStringList SignalStore::fieldsFor(const QHash<const void*, QSet<int>>& wanted, bool withLive) const {
    QStringList fields;
    const auto add = [&](const Signal& one) {
        if (!one.info.field.isEmpty() && (withLive || one.table != kLive) && one.table < kFirstRecording &&
            !fields.contains(one.info.field)) {
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
    problem_.clear();
    if (!loadOutlines(shown)) {
        return false;
    }
    for (const int signal : shown) {
        if (!load(signal)) {
            return false;
        }
    }
    QHash<const void*, QSet<int>> wanted = wanted_;
    if (shown.isEmpty()) {
        wanted.remove(who);
    } else {
        wanted[who] = shown;
    }
    const QStringList fields = fieldsFor(wanted, false);
    if (fields == furtherFields_) {
        wanted_ = wanted;
        return true;
    }
    std::vector<std::string> names;
    for (const QString& field : fields) {
        names.push_back(field.toStdString());
    }
    if (!receive::fitsFieldList(names)) {
        problem_ = tr("The robot cannot send this many signals at once. Remove other signals first.");
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

Result<QString> SignalStore::open(std::unique_ptr<recording::Recording> file, double begin) {
    const Error empty{
        ErrorCode::InvalidArgument,
        tr("The recording %1 contains no samples. Open a different recording.").arg(file->path()),
        {}};
    if (file->rows() == 0) {
        return empty;
    }
    auto history =
        std::make_unique<SeriesBuffer>(0, HistoryLimits{1e12, std::numeric_limits<std::size_t>::max()});
    std::unique_ptr<HistoryFile> pieces;
    if (HistoryFile::benefitsFromSummaries(*file)) {
        auto made = HistoryFile::make(*file, *history, begin);
        if (!made) {
            return made.error();
        }
        pieces = std::move(made).value();
    } else if (const Result<void> read = readTimes(*file, *history, begin); !read) {
        return read.error();
    }
    // Braces are reserved for names in expressions.
    QString plain = QFileInfo(file->path()).fileName();
    plain.replace(QLatin1Char('{'), QLatin1Char('(')).replace(QLatin1Char('}'), QLatin1Char(')'));
    QString name = plain;
    const auto isTaken = [this](const QString& wanted) {
        return std::any_of(tables_.begin(), tables_.end(),
                           [&](const Table& table) { return table.name == wanted; });
    };
    for (int more = 2; isTaken(name); ++more) {
        name = QStringLiteral("%1 (%2)").arg(plain).arg(more);
    }
    Table& table = tables_.emplace_back();
    table.buffer = std::move(history);
    table.pieces = std::move(pieces);
    table.name = name;
    // Recorded signals have the same display names as the signals of the robot.
    QHash<QString, QVector<int>> known;
    const int robots = count();
    for (int i = 0; i < robots; ++i) {
        const SignalInfo& info = this->info(i);
        if (!info.field.isEmpty() && signals_[static_cast<std::size_t>(i)].table < kFirstRecording) {
            const receive::FieldInfo* field = receive::findField(info.field.toStdString());
            known[QString::fromStdString(field->componentName(info.component))].append(i);
        }
    }
    for (std::size_t fileColumn = 0; fileColumn < file->columns().size(); ++fileColumn) {
        const recording::RecordedColumn& column = file->columns()[fileColumn];
        const QString columnName = QString::fromStdString(column.name);
        QVector<SignalInfo> infos;
        for (const int like : known.value(columnName)) {
            infos.append(info(like));
        }
        if (infos.isEmpty()) {
            SignalInfo info;
            info.key = info.family = info.label = info.longLabel = columnName;
            info.kind = column.whole ? receive::FieldKind::Count : receive::FieldKind::Number;
            setUnit(info, QString::fromStdString(column.unit));
            infos.append(info);
        }
        for (SignalInfo& info : infos) {
            info.field = columnName;
            info.component = 0;
            info.meaning = tr("%1 of %2").arg(info.key, name);
            info.key = name + QLatin1Char('/') + info.key;
            info.group = name;
            byKey_.insert(info.key, count());
            Signal& signal = signals_.emplace_back();
            signal.info = info;
            signal.table = static_cast<int>(tables_.size()) - 1;
            signal.fileColumn = fileColumn;
        }
    }
    table.file = std::move(file);
    prepareSamples(table);
    Q_EMIT signalAdded(count() - 1);
    return name;
}

QStringList SignalStore::takeProblems(const QString& recording) {
    const auto table = std::find_if(tables_.begin(), tables_.end(),
                                    [&](const Table& each) { return each.file && each.name == recording; });
    return table == tables_.end() ? QStringList()
                                  : table->file->problems().mid(
                                        std::exchange(table->problemsTaken, table->file->problems().size()));
}

bool SignalStore::hasCapacityFor(int signal, std::size_t bytes) {
    if (memoryBytes() + bytes <= limits_.bytes) {
        return true;
    }
    problem_ = tr("The history memory is too small to show %1. Increase the memory in the “Layout” menu.")
                   .arg(info(signal).longLabel);
    return false;
}

bool SignalStore::loadOutlines(const QSet<int>& shown) {
    for (std::size_t number = kFirstRecording; number < tables_.size(); ++number) {
        Table& table = tables_[number];
        std::vector<std::string> names;
        std::vector<std::size_t> columns;
        std::vector<Precision> precisions;
        std::size_t bytes = 0;
        for (const int signal : shown) {
            const Signal& wanted = signals_[static_cast<std::size_t>(signal)];
            const std::string name = wanted.info.field.toStdString();
            const auto has = [&name](const std::vector<std::string>& list) {
                return std::find(list.begin(), list.end(), name) != list.end();
            };
            if (!table.pieces || wanted.table != static_cast<int>(number) || wanted.column >= 0 ||
                wanted.derivation || has(table.columns) || has(names)) {
                continue;
            }
            names.push_back(name);
            columns.push_back(fileColumnOf(signal));
            precisions.push_back(wanted.info.precision());
            const std::size_t extent =
                2 * (precisions.back() == Precision::Single ? sizeof(float) : sizeof(double));
            bytes += table.file->rows() / static_cast<std::uint64_t>(SeriesColumn::kSummary) * extent;
            if (!hasCapacityFor(signal, bytes)) {
                return false;
            }
        }
        if (columns.empty()) {
            continue;
        }
        const auto added = table.pieces->add(columns, precisions);
        if (!added) {
            problem_ = added.error().toString();
            return false;
        }
        table.columns.insert(table.columns.end(), names.begin(), names.end());
        table.derived.resize(table.columns.size(), -1);
    }
    return true;
}

bool SignalStore::sharpen(const SeriesBuffer& history, std::int64_t begin, std::int64_t end, int pixelColumns,
                          HistoryFile::Effort effort) {
    const auto table = std::find_if(tables_.begin(), tables_.end(),
                                    [&](const Table& each) { return each.buffer.get() == &history; });
    return table != tables_.end() && table->pieces &&
           table->pieces->sharpen(begin, end, pixelColumns, effort);
}

bool SignalStore::load(int signal) {
    Signal& wanted = signals_[static_cast<std::size_t>(signal)];
    if (wanted.table < kFirstRecording || wanted.column >= 0) {
        return true;
    }
    Table& table = tables_[static_cast<std::size_t>(wanted.table)];
    const std::string name = wanted.info.field.toStdString();
    const auto known = std::find(table.columns.begin(), table.columns.end(), name);
    if (known != table.columns.end()) {
        wanted.column = static_cast<int>(known - table.columns.begin());
        return true;
    }
    const std::uint64_t rows = table.file->rows();
    const std::size_t size = wanted.info.precision() == Precision::Single ? sizeof(float) : sizeof(double);
    if (!hasCapacityFor(signal, rows * size)) {
        return false;
    }
    const std::size_t column = fileColumnOf(signal);
    constexpr std::uint64_t kAtOnce = 1 << 16;
    std::vector<double> part;
    std::uint64_t partBegin = 0;
    QString failure;
    const int added = table.buffer->addColumn(wanted.info.precision());
    table.buffer->fillColumn(added, [&](std::int64_t sample) {
        const auto row = static_cast<std::uint64_t>(sample);
        if (part.empty() || row >= partBegin + part.size()) {
            partBegin = row;
            const std::array<std::size_t, 1> columns = {column};
            auto read = table.file->read(columns, {row, std::min(kAtOnce, rows - row)});
            if (read && !read->front().empty()) {
                part = std::move(read->front());
            } else {
                failure = read ? QString() : read.error().toString();
                part.assign(std::min(kAtOnce, rows - row), kNoData);
            }
        }
        return part[row - partBegin];
    });
    table.columns.push_back(name);
    table.derived.push_back(-1);
    wanted.column = added;
    if (!failure.isEmpty()) {
        problem_ = failure;  // the readable part is still shown
    }
    return true;
}

QString SignalStore::recordingOf(int signal) const {
    const int table = signals_[static_cast<std::size_t>(signal)].table;
    return table < kFirstRecording ? QString() : tables_[static_cast<std::size_t>(table)].name;
}

const SignalStore::Table* SignalStore::tableOf(const QString& recording) const {
    const auto found = std::find_if(tables_.begin() + kFirstRecording, tables_.end(),
                                    [&](const Table& table) { return table.name == recording; });
    return found == tables_.end() ? nullptr : &*found;
}

const recording::Recording* SignalStore::recorded(const QString& recording) const {
    const Table* table = tableOf(recording);
    return table == nullptr ? nullptr : table->file.get();
}

QStringList SignalStore::recordings() const {
    QStringList names;
    for (std::size_t i = kFirstRecording; i < tables_.size(); ++i) {
        names << tables_[i].name;
    }
    return names;
}

const SeriesBuffer* SignalStore::timesOf(const QString& recording) const {
    const Table* table = tableOf(recording);
    return table == nullptr ? nullptr : table->buffer.get();
}

void SignalStore::prepareSamples(Table& table) {
    std::vector<std::string> fields;
    for (const receive::FieldInfo& field : receive::fieldInfos()) {
        if (table.file->indexOf(field.componentName(0))) {
            fields.emplace_back(field.name);
        }
    }
    table.layout = std::make_shared<const receive::SampleLayout>(fields);
    for (std::size_t place = 0; place < table.layout->size(); ++place) {
        if (const auto column = table.file->indexOf(table.layout->componentNames()[place])) {
            table.places.push_back(place);
            table.fileColumns.push_back(*column);
        }
    }
}

receive::Sample SignalStore::sampleAt(const QString& recording, double time) const {
    const Table* table = recording.isEmpty() ? &tables_[kLive] : tableOf(recording);
    const auto at = table == nullptr ? std::nullopt : heldAt(*table->buffer, time);
    if (!at) {
        return {};
    }
    receive::Sample sample(table->layout);
    sample.sequence = static_cast<std::uint64_t>(*at) + 1;
    if (!table->file) {
        for (std::size_t column = 0; column < table->columns.size(); ++column) {
            if (const auto place = table->layout->indexOfComponent(table->columns[column]);
                place && table->derived[column] < 0) {
                sample.values[*place] = table->buffer->value(static_cast<int>(column), *at);
            }
        }
        return sample;
    }
    const auto read = table->file->read(table->fileColumns, {static_cast<std::uint64_t>(*at), 1});
    for (std::size_t i = 0; read && i < read->size(); ++i) {
        if (!(*read)[i].empty()) {
            sample.values[table->places[i]] = (*read)[i].front();
        }
    }
    return sample;
}

std::vector<int> SignalStore::signalsOf(const QString& recording) const {
    std::vector<int> found;
    for (int i = 0; i < count(); ++i) {
        const int table = signals_[static_cast<std::size_t>(i)].table;
        if (table >= kFirstRecording && tables_[static_cast<std::size_t>(table)].name == recording) {
            found.push_back(i);
        }
    }
    return found;
}

void SignalStore::closeRecordings() {
    closing_.cancel();
    closing_ = {};
    // Signal numbers are never reused, so these entries stay empty.
    for (Signal& signal : signals_) {
        if (signal.table >= kFirstRecording) {
            byKey_.remove(signal.info.key);
            signal = {};
        }
    }
    tables_.resize(kFirstRecording);
    Q_EMIT signalAdded(-1);
}

void SignalStore::setLimits(const HistoryLimits& limits) {
    limits_ = limits;
    share();
}

void SignalStore::share() {
    // The time stamps are stored as double, so they need as much memory as two value columns.
    const auto weight = [](const Table& table) { return static_cast<double>(table.columns.size() + 2); };
    const double all =
        weight(tables_[kLive]) + (tables_[kFurther].columns.empty() ? 0 : weight(tables_[kFurther]));
    for (Table& table : std::span(tables_).first(kFirstRecording)) {
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
