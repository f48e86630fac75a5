// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The panel "Plots": list of signals at the left, pages of plots, a lane with the robot state below, and the
// controls in the title bar. Once per frame, it takes the state and all new samples from the session.

#include <QByteArray>
#include <QHash>
#include <QString>
#include <QVector>
#include <memory>
#include <optional>

#include "robot/core/result.h"
#include "robot/recording/recording.h"
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
class HistoryFeed;
class PlotMarks;
class PlotPages;
class PlotReplay;
class PlotValues;
class PlotView;
class RobotSession;
struct SampleBatch;
class SeriesBuffer;
class SignalStore;
class SignalTree;
class StateLane;

class PlotDock : public Panel {
    Q_OBJECT

public:
    explicit PlotDock(RobotSession& session, QWidget* parent = nullptr);
    ~PlotDock() override;

    PlotView& view();  ///< The view of the page in front.
    PlotPages& pages() { return *pages_; }
    PlotMarks& marks() { return *marks_; }
    SignalStore& store() { return *store_; }
    const SeriesBuffer& history() const;
    const StateLane& lane() const { return *lane_; }

    /// Content of a recording started by "Record", from the next one on.
    void setRecordingChoice(const RecordingChoice& choice);
    const RecordingChoice& recordingChoice() const { return choice_; }

    enum class ExportRange { Visible, BetweenCursors };
    /// Selects the format by the file extension, and shows the result to the user: an image of the displayed range
    /// (.png, .svg, .pdf), or the values of the signals on the page. Live signals are exported as .csv; those of a
    /// recording with its own rows and times as .csv, .h5, .hdf5 or .mcap.
    bool exportTo(const QString& path, ExportRange range = ExportRange::Visible);

    /// Opens a recording of any format on a separate page next to the live data: it ends at the end of the history,
    /// or begins at cursor A if set. An incident recording is placed at its time if the history of its robot
    /// includes it, with cursor A at the stop. The file is read in the background; the result is shown to the user.
    /// moment  position of cursor A on the time axis of the recording [s]; empty: as above
    void openRecording(const QString& path, std::optional<double> moment = {});
    /// The time of cursor A while it refers to a recording or to a paused history.
    const Replay& replay() const;
    void closeRecordings();
    /// Saves the arrangement to a separate file or loads it, without messages.
    Result<void> saveArrangement(const QString& path) const;
    Result<void> openArrangement(const QString& path);
    // The arrangement of the plots as text for the settings. Invalid data change nothing.
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
    /// The held jog button, e.g. "X+" or "Wrist 2−", as text in the lane. Empty: none.
    void setJogLabel(const QString& label);
    void setPaused(bool paused);
    /// Displays the force relative to its current value; recorded and exported values are unchanged.
    void setForceZeroed(bool zeroed);
    /// Shows the list of signals at the left.
    void setSignalsShown(bool shown);
    /// Shows the list with the focus in the search field.
    void searchSignals();
    void addPage();
    /// Shows the table of values at and between the cursors.
    void setValuesShown(bool shown);
    /// Shows the spectrum of a signal, or one signal versus another.
    void setAnalysisShown(bool shown);
    void setTimeAxis(tiller::TimeAxis axis);
    /// Asks for the text of a note at this time.
    void askForNote(double time);
    void addNote(double time, const QString& text);
    /// Copies an image of the displayed plots to the clipboard.
    void copyPicture();
    /// Starts or ends a recording.
    void toggleRecording();
    /// Asks for the file for the displayed range.
    void askExport();
    /// Asks for the parameters of the comparison of the recording in front with the model of its arm, and starts
    /// it.
    void compareWithModel();
    /// Ends a replay: removes cursor A and shows the newest samples.
    void endReplay();

Q_SIGNALS:
    /// Selected in the menu of the Record button.
    void recordingChosen(const tiller::RecordingChoice& choice);
    /// The settings that are not in the menu (signals, folder, file name) should be shown.
    void recordingOptionsWanted();
    /// The replayed time has changed; empty: all data are live.
    void replayChanged(const tiller::Replay& moment);
    /// Arm and model of a recording deviate at this time on its time axis.
    void deviatedFromModel(const QString& text, const QString& details, const QString& path, double seconds);
    /// Pages, plots, their signals or the memory limit have changed.
    void arrangementChanged();

protected:
    void changeEvent(QEvent* event) override;

private:
    Result<void> exportValues(const QString& path, ExportRange range) const;
    Result<void> exportPicture(const QString& path) const;
    void buildHeader();
    void styleHeader();
    void take(const SampleBatch& batch);
    void takeExtra(const SampleBatch& batch);
    void followAbsent();
    void buildPagesMenu();
    void announceContent();
    /// e.g. "12.3 MB · 145 kB a second · 40 GB free · 0 packets lost"
    static QString recordingText(const RecordingState& recording);
    QString picturesTitle() const;
    QString historyText() const;
    void askForRecording();
    void showRecording(std::unique_ptr<recording::Recording> file, std::optional<double> incident,
                       std::optional<double> moment);
    void goTo(const QString& recording, std::optional<double> moment);
    double placeOf(const recording::Recording& file, double length, std::optional<double> incident) const;
    PageLayout pageFor(const QString& recording) const;
    bool turnTo(const QString& recording);
    bool isOpen(const QString& path, std::optional<double> moment);
    void makeSpace();
    void askToSaveArrangement();
    void askToOpenArrangement();
    void onState(const SessionState& state);
    void followLane(const SessionState& state);
    void updateHeader();
    void showNothingToExport();
    void buildRecordMenu();
    void showRecordMenu();
    void askForFolder();

    RobotSession& session_;
    std::unique_ptr<SignalStore> store_;
    std::unique_ptr<StateLane> lane_;
    std::unique_ptr<PlotMarks> marks_;
    std::unique_ptr<HistoryFeed> feed_;
    std::unique_ptr<PlotReplay> replay_;
    ComparisonBand* comparisonBand_ = nullptr;
    std::unique_ptr<PlotComparison> comparison_;
    /// opened incidents with the times of their stops on the time axis of the plots [s]
    QHash<QString, double> incidents_;
    PlotPages* pages_ = nullptr;
    SignalTree* tree_ = nullptr;
    PlotValues* values_ = nullptr;
    PlotAnalysis* analysis_ = nullptr;
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
    QString jogLabel_;
    std::optional<double> backAt_;  ///< data resumed at this time, not in the lane yet [s]
    RecordingChoice choice_;
    bool recording_ = false;
    double recordingSeconds_ = 0;
    int framesToHistoryText_ = 0;
    int framesToAnalysis_ = 0;
    SerialExecutor files_;  // last member: its jobs end before other members are destroyed
};

}  // namespace tiller
