// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Table model of the log, oldest entry first. A message equal to the previous message increases the count of
// its row, which shows the first and last time. Only consecutive messages are merged, so that the order
// remains chronological. Beyond kCapacity rows, the oldest rows are removed.

#include <QAbstractTableModel>
#include <QDateTime>
#include <QFont>
#include <QSortFilterProxyModel>
#include <deque>
#include <optional>

#include "robot/station/journal/journal_event.h"

namespace tiller {

class LogModel : public QAbstractTableModel {
    Q_OBJECT

public:
    enum Column { Time, SeverityColumn, Open, Text, ColumnCount };
    enum Role { SeverityRole = Qt::UserRole, TextRole, RecordingRole, MomentRole, WallTimeRole };
    static constexpr int kCapacity = 5000;

    explicit LogModel(QObject* parent = nullptr) : QAbstractTableModel(parent) {}

    /// recording  related file; empty if there is none
    /// moment     position in the recording [s]; empty: the time of the incident
    void append(const QDateTime& time, Severity severity, const QString& text, Origin origin = Origin::Tiller,
                const QString& detail = {}, const QString& recording = {}, std::optional<double> moment = {});
    void clear();
    /// Returns the last row that starts at or before this time; -1 if there is none.
    int rowAt(const QDateTime& time) const;
    /// All details of a row: time, count, origin, meaning and suggested action.
    QString details(int row) const;
    /// A row as tab-separated text: date and time of the first occurrence, severity, and text with count and
    /// last time.
    QString rowText(int row) const;

    static QString severityWord(Severity severity);
    static QFont columnFont(int column);
    static QString openWord();  ///< text of the column Open for rows with a recording
    /// Text for an origin: "Robot", "Operator", "Tiller".
    static QString originWord(Origin origin);

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

private:
    struct Entry {
        QDateTime first;
        QDateTime last;
        Severity severity = Severity::Info;
        QString text;
        Origin origin = Origin::Tiller;
        QString detail;
        QString recording;
        std::optional<double> moment;
        int count = 1;
    };
    QString shown(const Entry& entry, const QString& clock) const;

    std::deque<Entry> entries_;
};

/// Filters by minimum severity and by words. Every word must occur in a row.
class LogFilter : public QSortFilterProxyModel {
    Q_OBJECT

public:
    using QSortFilterProxyModel::QSortFilterProxyModel;
    void setLeastSeverity(Severity severity);
    void setWords(const QString& words);

protected:
    bool filterAcceptsRow(int row, const QModelIndex& parent) const override;

private:
    Severity least_ = Severity::Info;
    QStringList words_;
};

}  // namespace tiller
