// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The panel "Plots". It contains the signal list at the left, pages of plots, lanes with the robot state
// below the plots, and controls in the title bar. It shows the history of the session and adds recordings to
// it.

#include <QByteArray>
#include <QHash>
#include <QString>
#include <QVector>
#include <memory>
#include <optional>

#include "robot/core/result.h"
#include "robot/recording/recording.h"
#include "robot/recording/table_format.h"
#include "robot/station/executor/serial_executor.h"
#include "robot/station/history/replay_moment.h"
#include "robot/station/link/recording_choice.h"
#include "robot/station/link/session_state.h"
#include "widgets/common/panel.h"
#include "widgets/plots/plot_layout.h"

class QLabel;
class QToolButton;

namespace tiller {

class ComparisonBand;
class ElidedLabel;
class PlotAnalysis;
class PlotComparison;
class LiveHistory;
class PlotMarks;
class PlotPages;
class PlotPlayback;
class PlotReplay;
class PlotValues;
class PlotView;
class RecordingsDialog;
class RobotSession;
class SeriesBuffer;
class SignalStore;
class SignalTree;

class PlotDock : public Panel {
    Q_OBJECT

public:
    /// live  the history of the session; must outlive the panel, like `session`
    PlotDock(RobotSession& session, LiveHistory& live, QWidget* parent = nullptr);
    ~PlotDock() override;

    PlotView& view();
    PlotPages& pages() { return *pages_; }
    PlotMarks& marks() { return *marks_; }
    SignalStore& store() { return store_; }
    const SeriesBuffer& history() const;

    /// Sets the content of recordings that are started with "Record". The next recording uses it.
    void setRecordingChoice(const RecordingChoice& choice);
    const RecordingChoice& recordingChoice() const { return choice_; }

    enum class ExportRange { Visible, BetweenCursors };
    /// Exports to a file and shows the result to the user. The file extension selects an image of the
    /// displayed range (.png, .svg, .pdf) or the values of the signals on the page. Live signals can be
    /// exported as .csv. The signals of a recording with its own rows and times can be exported as .csv, .h5,
    /// .hdf5 or .mcap.
    bool exportTo(const QString& path, ExportRange range = ExportRange::Visible);

    /// Opens a recording of any format on a separate page next to the live data. By default, its end is
    /// aligned to the end of the history. If cursor A is set, its start is aligned to cursor A. An incident
    /// recording is placed at the time of the incident if the history of its robot includes that time, and
    /// cursor A is set to the stop. The file is read in the background, and the result is shown to the user.
    /// moment  position of cursor A on the time axis of the recording [s]; if empty, as described above
    /// format  for a table of another program. A dialog asks for missing parts.
    void openRecording(const QString& path, std::optional<double> moment = {},
                       const recording::TableFormat& format = {});
    /// The time of cursor A while the cursor is in a recording or in a paused history.
    const Replay& replay() const;
    /// Shows the data at a time of day, with cursor A at this time.
    /// replayed  the time is in the recording of the current page; otherwise, it is in the history
    void goToClock(const QDateTime& time, bool replayed);
    void closeRecordings();
    /// Prompts for a recording and opens it.
    void askForRecording();
    /// Shows the page of the standard plots, or reports why it cannot be shown.
    void showStandard();
    bool isValuesShown() const;
    bool isPlaying() const;
    bool isAnalysisShown() const;
    bool isRecordingInFront() const;  ///< true if the displayed page shows a recording
    /// Saves the arrangement to a separate file. Shows no messages to the user.
    Result<void> saveArrangement(const QString& path) const;
    Result<void> openArrangement(const QString& path);
    // The arrangement of the plots as text, for the settings. arrange() ignores invalid data.
    QByteArray arrangement() const;
    void arrange(const QByteArray& json);
    /// Memory limit of the history [bytes].
    std::size_t budget() const;
    void setBudget(std::size_t bytes);

    /// A time range offered in the menu.
    struct Span {
        double seconds = 0;
        QString text;  ///< e.g. "2 min"
    };
    static QVector<Span> spans();

public Q_SLOTS:
    void setPaused(bool paused);
    /// Displays the force relative to its current value. Recorded and exported values remain unchanged.
    void setForceZeroed(bool zeroed);
    void setSignalsShown(bool shown);
    /// Shows the list of signals and sets the focus to its search field.
    void searchSignals();
    void addPage();
    /// Shows or hides the table of values at and between the cursors.
    void setValuesShown(bool shown);
    /// Shows or hides the analysis panel (spectrum or XY).
    void setAnalysisShown(bool shown);
    void setTimeAxis(tiller::TimeAxis axis);
    void askForNote(double time);
    void addNote(double time, const QString& text);
    /// Copies an image of the displayed plots to the clipboard.
    void copyPicture();
    void toggleRecording();
    /// Shows the metadata of recordings for editing.
    void editMetadata();
    /// Shows the list of the recordings in the folder for recordings.
    void listRecordings();
    /// Prompts for the file, then exports the displayed range.
    void askExport();
    /// Prompts for the parameters and starts the comparison of the current recording with the model of its
    /// arm.
    void compareWithModel();
    /// Starts the playback of the current page, or reports that there are no samples; see PlotPlayback::start().
    void play(double speed);
    void stopPlayback();
    /// Ends a replay: removes cursor A and shows the newest samples.
    void endReplay();

Q_SIGNALS:
    /// The user selected a recording content in the menu of the Record button.
    void recordingChosen(const tiller::RecordingChoice& choice);
    /// The user wants to change the settings that are not in the menu: signals, folder and file name.
    void recordingOptionsWanted();
    /// The replayed time has changed. Empty if all data are live.
    void replayChanged(const tiller::Replay& moment);
    /// Pages, plots, their signals or the memory limit have changed.
    void arrangementChanged();

protected:
    void changeEvent(QEvent* event) override;

private:
    Result<void> exportValues(const QString& path, ExportRange range) const;
    Result<void> exportPicture(const QString& path) const;
    void buildHeader();
    void styleHeader();
    void take();
    void followAbsent();
    void buildPagesMenu();
    void announceContent();
    /// e.g. "12.3 MB · 145 kB/s · 40 GB free · 0 packets lost"
    static QString recordingText(const RecordingState& recording);
    QString picturesTitle() const;
    QString historyText() const;
    void askForFormat(const QString& path, std::optional<double> moment, const recording::TableFormat& format,
                      const QString& reason);
    void showRecording(std::unique_ptr<recording::Recording> file, std::optional<double> incident,
                       std::optional<double> moment);
    void goTo(const QString& recording, std::optional<double> moment);
    double placeOf(const recording::Recording& file, double length, std::optional<double> incident) const;
    PageLayout pageFor(const QString& recording) const;
    /// Reports damage of recordings that was found while reading them.
    void reportProblems();
    bool turnTo(const QString& recording);
    bool isOpen(const QString& path, std::optional<double> moment);
    void makeSpace();
    void askToSaveArrangement();
    void askToOpenArrangement();
    void onState(const SessionState& state);
    void updateHeader();
    void showNothingToExport();
    void askForMetadata(bool thenRecords);
    void startRecording();
    void buildRecordMenu();
    void showRecordMenu();
    void askForFolder();

    RobotSession& session_;
    LiveHistory& live_;
    SignalStore& store_;
    std::unique_ptr<PlotMarks> marks_;
    std::unique_ptr<PlotReplay> replay_;
    std::unique_ptr<PlotPlayback> playback_;
    ComparisonBand* comparisonBand_ = nullptr;
    std::unique_ptr<PlotComparison> comparison_;
    /// stop time of the opened incidents on the time axis of the plots [s]
    QHash<QString, double> incidents_;
    PlotPages* pages_ = nullptr;
    SignalTree* tree_ = nullptr;
    PlotValues* values_ = nullptr;
    PlotAnalysis* analysis_ = nullptr;
    RecordingsDialog* recordings_ = nullptr;  // created when it is first shown
    QToolButton* valuesKey_ = nullptr;
    QLabel* historyLabel_ = nullptr;
    QWidget* side_ = nullptr;  // the signal list and the elements below it
    QToolButton* signalsKey_ = nullptr;
    QToolButton* pagesKey_ = nullptr;
    ElidedLabel* readout_ = nullptr;
    QToolButton* span_ = nullptr;
    QToolButton* pause_ = nullptr;
    QToolButton* zero_ = nullptr;
    QToolButton* export_ = nullptr;
    QToolButton* record_ = nullptr;
    QToolButton* recordMenu_ = nullptr;
    RecordingChoice choice_;
    QMap<QString, recording::TableFormat> tables_;  ///< as PlotLayout::tables
    bool recording_ = false;
    bool waiting_ = false;  ///< true while the recording waits for its trigger
    double recordingSeconds_ = 0;
    int framesToHistoryText_ = 0;
    int framesToAnalysis_ = 0;
    int framesToAge_ = 0;
    SerialExecutor files_;  // last member, so that its jobs end before the other members are destroyed
};

}  // namespace tiller
