// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// What happened, oldest first. A message that repeats the one before it is counted, not listed again: its row
// tells the first and the last time. Only neighbours are, so that the list is always in the order in which
// things happened. Beyond kCapacity the oldest rows go.

#include <QAbstractTableModel>
#include <QDateTime>
#include <QSortFilterProxyModel>
#include <deque>
#include <optional>

#include "robot/station/link/robot_session.h"

namespace tiller {

class LogModel : public QAbstractTableModel {
    Q_OBJECT

public:
    enum Column { Time, SeverityColumn, Open, Text, ColumnCount };
    enum Role { SeverityRole = Qt::UserRole, TextRole, RecordingRole, MomentRole };
    static constexpr int kCapacity = 5000;

    explicit LogModel(QObject* parent = nullptr) : QAbstractTableModel(parent) {}

    /// recording  a file that shows what the row tells of; empty: none
    /// moment     where in it [s]; nothing: at the incident
    void append(const QDateTime& time, Severity severity, const QString& text, Origin origin = Origin::Tiller,
                const QString& detail = {}, const QString& recording = {}, std::optional<double> moment = {});
    void clear();
    /// The last row that began at or before this time; -1: none did.
    int rowAt(const QDateTime& time) const;
    /// All there is to say about a row, for people: when, how often, from whom, what it means, what to do.
    QString details(int row) const;
    /// Row as text, fields separated by tabs: date and time (the first), severity, text with its count and
    /// the last time.
    QString rowText(int row) const;

    static QString severityWord(Severity severity);
    static QString openWord();  ///< Of the column Open, where there is a recording.
    /// "the robot", "the operator", "Tiller"
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

/// By severity from a level on, and by words that must all occur.
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
