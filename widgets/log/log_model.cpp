// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/log/log_model.h"

#include <algorithm>

#include "widgets/common/theme.h"

namespace tiller {

namespace {
const QString kClock = QStringLiteral("HH:mm:ss");
}

QString LogModel::severityWord(Severity severity) {
    switch (severity) {
        case Severity::Info:
            return tr("Info");
        case Severity::Warning:
            return tr("▲ Warning");
        case Severity::Error:
            return tr("⬣ Error");
    }
    return {};
}

QString LogModel::openWord() {
    return tr("Open");
}

QString LogModel::originWord(Origin origin) {
    switch (origin) {
        case Origin::Tiller:
            return tr("Tiller");
        case Origin::Operator:
            return tr("Operator");
        case Origin::Robot:
            return tr("Robot");
    }
    return {};
}

void LogModel::append(const QDateTime& time, Severity severity, const QString& text, Origin origin,
                      const QString& detail, const QString& recording, std::optional<double> moment) {
    if (!entries_.empty()) {
        Entry& entry = entries_.back();
        if (entry.severity == severity && entry.origin == origin && entry.text == text &&
            entry.detail == detail && entry.recording == recording && entry.moment == moment) {
            ++entry.count;
            entry.last = time;
            const int row = rowCount() - 1;
            Q_EMIT dataChanged(index(row, 0), index(row, ColumnCount - 1));
            return;
        }
    }
    if (rowCount() == kCapacity) {
        beginRemoveRows({}, 0, 0);
        entries_.pop_front();
        endRemoveRows();
    }
    beginInsertRows({}, rowCount(), rowCount());
    entries_.push_back({time, time, severity, text, origin, detail, recording, moment, 1});
    endInsertRows();
}

void LogModel::clear() {
    beginResetModel();
    entries_.clear();
    endResetModel();
}

int LogModel::rowAt(const QDateTime& time) const {
    const auto after =
        std::upper_bound(entries_.begin(), entries_.end(), time,
                         [](const QDateTime& at, const Entry& entry) { return at < entry.first; });
    return static_cast<int>(after - entries_.begin()) - 1;
}

QString LogModel::shown(const Entry& entry, const QString& clock) const {
    return entry.count == 1
               ? entry.text
               : tr("(×%1, last at %2) %3").arg(entry.count).arg(entry.last.toString(clock), entry.text);
}

QString LogModel::details(int row) const {
    const Entry& entry = entries_.at(static_cast<std::size_t>(row));
    QString text =
        entry.count == 1
            ? tr("%1 · Origin: %2").arg(entry.first.toString(kClock), originWord(entry.origin))
            : tr("%1 times between %2 and %3 · Origin: %4")
                  .arg(entry.count)
                  .arg(entry.first.toString(kClock), entry.last.toString(kClock), originWord(entry.origin));
    text += QLatin1Char('\n') + entry.text;
    return entry.detail.isEmpty() ? text : text + QLatin1Char('\n') + entry.detail;
}

QString LogModel::rowText(int row) const {
    const Entry& entry = entries_.at(static_cast<std::size_t>(row));
    QString text = shown(entry, QStringLiteral("HH:mm:ss.zzz"));
    if (!entry.detail.isEmpty()) {
        text += QStringLiteral(". ") + entry.detail;
    }
    text.replace(QLatin1Char('\n'), QLatin1Char(' ')).replace(QLatin1Char('\t'), QLatin1Char(' '));
    // The text is not translated, because other programs read it.
    static const char* const kWords[] = {"Info", "Warning", "Error"};
    return QStringLiteral("%1\t%2\t%3")
        .arg(entry.first.toString(QStringLiteral("yyyy-MM-dd HH:mm:ss.zzz")),
             QLatin1String(kWords[static_cast<int>(entry.severity)]), text);
}

int LogModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(entries_.size());
}

int LogModel::columnCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : ColumnCount;
}

QVariant LogModel::data(const QModelIndex& index, int role) const {
    if (!index.isValid() || index.row() >= rowCount()) {
        return {};
    }
    const Entry& entry = entries_.at(static_cast<std::size_t>(index.row()));
    switch (role) {
        case Qt::DisplayRole:
            return index.column() == Time             ? entry.first.toString(kClock)
                   : index.column() == SeverityColumn ? severityWord(entry.severity)
                   : index.column() == Open           ? (entry.recording.isEmpty() ? QString() : openWord())
                                                      : shown(entry, kClock);
        case Qt::ToolTipRole:
            if (index.column() == Open && !entry.recording.isEmpty()) {
                return entry.moment ? tr("Open the recording at this time")
                                    : tr("Open the recording of this incident at the time of the stop");
            }
            return details(index.row());
        case Qt::FontRole:
            return columnFont(index.column());
        case Qt::ForegroundRole:
            if (index.column() == SeverityColumn && entry.severity != Severity::Info) {
                return entry.severity == Severity::Error ? Theme::current().alarm : Theme::current().warning;
            }
            if (index.column() == Open) {
                return Theme::current().text;
            }
            return index.column() == Text ? QVariant() : QVariant(Theme::current().secondary);
        case Qt::AccessibleTextRole:
            return rowText(index.row());
        case RecordingRole:
            return entry.recording;
        case MomentRole:
            return entry.moment ? QVariant(*entry.moment) : QVariant();
        case WallTimeRole:
            return entry.first;
        case SeverityRole:
            return static_cast<int>(entry.severity);
        case TextRole:
            return entry.text + QLatin1Char(' ') + entry.detail + QLatin1Char(' ') + originWord(entry.origin);
        default:
            return {};
    }
}

QFont LogModel::columnFont(int column) {
    if (column == Open) {
        QFont font = textFont(13);
        font.setUnderline(true);
        return font;
    }
    return column == Time ? numberFont(13) : textFont(14);
}

QVariant LogModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (orientation != Qt::Horizontal) {
        return {};
    }
    if (role == Qt::TextAlignmentRole) {
        return QVariant(Qt::AlignLeft | Qt::AlignVCenter);
    }
    if (role != Qt::DisplayRole) {
        return {};
    }
    return section == Time             ? tr("Time")
           : section == SeverityColumn ? tr("Severity")
           : section == Open           ? QString()
                                       : tr("Event");
}

void LogFilter::setLeastSeverity(Severity severity) {
    least_ = severity;
    invalidateFilter();
}

void LogFilter::setWords(const QString& words) {
    words_ = words.split(QLatin1Char(' '), Qt::SkipEmptyParts);
    invalidateFilter();
}

bool LogFilter::filterAcceptsRow(int row, const QModelIndex& parent) const {
    const QModelIndex index = sourceModel()->index(row, LogModel::Text, parent);
    if (index.data(LogModel::SeverityRole).toInt() < static_cast<int>(least_)) {
        return false;
    }
    const QString text = index.data(LogModel::TextRole).toString();
    return std::all_of(words_.begin(), words_.end(),
                       [&](const QString& word) { return text.contains(word, Qt::CaseInsensitive); });
}

}  // namespace tiller

#include "moc_log_model.cpp"
