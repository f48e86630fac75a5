// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The tab "Log": what happened, newest below, with time and severity; repeats are merged. It can be filtered,
// copied and written to a file.

#include <QDateTime>
#include <QWidget>
#include <functional>
#include <optional>

#include "robot/core/result.h"
#include "robot/station/history/replay_moment.h"
#include "robot/station/link/robot_session.h"

class QLabel;
class QLineEdit;
class QSortFilterProxyModel;
class QTableView;
class QToolButton;

namespace tiller {

class LogFilter;
class LogModel;
class NothingFound;
class ReplayBand;
class SegmentedControl;

class LogTab : public QWidget {
    Q_OBJECT

public:
    explicit LogTab(RobotSession& session, QWidget* parent = nullptr);
    ~LogTab() override;

    LogModel& model() { return *model_; }
    /// Shows the log of a moment, its row selected, and says so: a recording's own, or for the history the rows of this
    /// log. Nothing: live.
    void setReplay(const Replay& moment);
    /// For tests.
    void setTimeSource(std::function<QDateTime()> now) { now_ = std::move(now); }
    /// The rows that are shown, one a line, fields separated by tabs.
    QString shownText() const;
    /// All rows, shown or not, one a line.
    QString allText() const;
    /// Writes all shown rows.
    /// Errors  FileNotWritable, DiskFull
    Result<void> exportTo(const QString& path) const;

public Q_SLOTS:
    void append(tiller::Severity severity, const QString& text,
                tiller::Origin origin = tiller::Origin::Tiller, const QString& detail = {});
    /// The same with the recording of an incident, which can be opened from its row.
    void appendRecording(tiller::Severity severity, const QString& text, const QString& detail,
                         const QString& path);
    /// The same with a moment of a recording [s], at which it is opened.
    void appendMoment(tiller::Severity severity, const QString& text, const QString& detail,
                      const QString& path, double seconds);
    /// Asks for the recording of the current row to be opened; nothing happens when it has none.
    void openRecording();
    /// Copies the selected rows, or all that are shown when none is selected.
    void copy();
    /// Asks for a file and writes the rows that are shown.
    void exportToFile();
    void focusSearch();
    /// Only rows of this severity and above.
    void showFrom(tiller::Severity severity);

Q_SIGNALS:
    /// A row's recording is to be opened.
    /// moment  where in it [s]; nothing: at its incident
    void recordingWanted(const QString& path, std::optional<double> moment);
    /// From a replay back to what is live.
    void liveWanted();

protected:
    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;

private:
    void showDetails();
    void clicked(const QModelIndex& index);
    const LogModel& shownModel() const { return replay_ ? *replayModel_ : *model_; }
    void fillReplay(const ReplayMoment& moment);
    void select(int row);
    void showNothingFound();
    void add(Severity severity, const QString& text, Origin origin, const QString& detail,
             const QString& recording, std::optional<double> moment = {});
    QString textOf(const QList<int>& rows) const;

    std::function<QDateTime()> now_;
    LogModel* model_;
    LogModel* replayModel_;  ///< the log of the recording that is replayed
    std::shared_ptr<const std::vector<recording::RecordedEvent>> replayed_;  ///< what is in it
    bool replay_ = false;                                                    ///< it is shown
    LogFilter* filter_;
    ReplayBand* band_;
    SegmentedControl* severity_;
    QLineEdit* search_;
    QToolButton* open_;
    QTableView* table_;
    NothingFound* nothing_;
    QLabel* details_;
    bool follows_ = true;  ///< the newest line was in sight when the page was left
};

}  // namespace tiller
