// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The tab "Log" shows events with time and severity, newest at the bottom. Repeated messages are merged. The
// log can be filtered, copied and saved to a file.

#include <QWidget>
#include <memory>
#include <optional>

#include "robot/core/result.h"
#include "robot/station/history/replay_moment.h"
#include "robot/station/journal/journal.h"

class QLabel;
class QLineEdit;
class QSortFilterProxyModel;
class QTableView;
class QToolButton;

namespace tiller {

class LogFilter;
class LogModel;
class EmptyState;
class ReplayBand;
class SegmentedControl;

class LogTab : public QWidget {
    Q_OBJECT

public:
    explicit LogTab(Journal& journal, QWidget* parent = nullptr);
    ~LogTab() override;

    LogModel& model() { return *model_; }
    /// Shows the log of a recording, or the live log at a past time, and selects the row of that time. Empty
    /// for live data.
    void setReplay(const Replay& moment);
    /// The displayed rows as tab-separated text, one per line.
    QString shownText() const;
    /// All rows as tab-separated text, including the rows hidden by the filter.
    QString allText() const;
    /// Writes all displayed rows.
    /// Errors  FileNotWritable, DiskFull
    Result<void> exportTo(const QString& path) const;

public Q_SLOTS:
    /// Emits recordingWanted() if the current row has a recording.
    void openRecording();
    /// Copies the selected rows, or all displayed rows if none is selected.
    void copy();
    /// Asks for a file and writes the displayed rows.
    void exportToFile();
    void focusSearch();
    /// Sets the minimum severity of the filter.
    void showFrom(tiller::Severity severity);

Q_SIGNALS:
    /// The user opened the recording of a row.
    /// moment  position in the recording [s]; if empty, the time of the incident
    void recordingWanted(const QString& path, std::optional<double> moment);
    /// The user wants to see the plots and the view at the time of a row.
    /// replayed  the row is part of the log of a recording
    void timeWanted(const QDateTime& time, bool replayed);
    /// The user wants to return to live data.
    void liveWanted();

protected:
    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;

private:
    void fitColumn(int column, const QStringList& words);
    void showDetails();
    void clicked(const QModelIndex& index);
    /// Opens the recording of the current row. If it has none, emits timeWanted().
    void activate();
    const LogModel& shownModel() const { return replay_ ? *replayModel_ : *model_; }
    void fillReplay(const ReplayMoment& moment);
    void select(int row);
    void showEmptyState();
    void append(const JournalEvent& event);
    QString textOf(const QList<int>& rows) const;

    Journal& journal_;
    LogModel* model_;
    LogModel* replayModel_;  ///< log of the replayed recording
    std::shared_ptr<const std::vector<recording::RecordedEvent>> replayed_;  ///< events in replayModel_
    bool replay_ = false;  ///< true while replayModel_ is displayed
    LogFilter* filter_;
    ReplayBand* band_;
    SegmentedControl* severity_;
    QLineEdit* search_;
    QToolButton* open_;
    QTableView* table_;
    EmptyState* nothing_;
    QLabel* details_;
    bool follows_ = true;  ///< true if the newest row was visible when the tab was hidden
};

}  // namespace tiller
