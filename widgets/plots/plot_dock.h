// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The panel "Plots": the list of signals at its left, pages of plots, what the robot did in a lane underneath, and the
// controls in its title bar. It takes from the session, once a frame, every sample since the last one and the state.

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

    PlotView& view();  ///< Of the page in front.
    PlotPages& pages() { return *pages_; }
    PlotMarks& marks() { return *marks_; }
    SignalStore& store() { return *store_; }
    const SeriesBuffer& history() const;
    const StateLane& lane() const { return *lane_; }

    /// What "Record" makes: holds for the next recording.
    void setRecordingChoice(const RecordingChoice& choice);
    const RecordingChoice& recordingChoice() const { return choice_; }

    /// Shown range as CSV, columns named as in recordings, or as a picture (.png, .svg, .pdf).
    Result<void> exportCsv(const QString& path) const;
    Result<void> exportPicture(const QString& path) const;
    /// By the ending of the name; tells the operator how it went.
    bool exportTo(const QString& path);

    /// Opens a recording of any format on a page of its own, beside what is live: it ends where the history does, or
    /// begins at the cursor A where there is one. That of an incident stands where it happened if the history of its
    /// robot still reaches there, with the cursor A at the moment of the stop. Reads the file elsewhere; tells the
    /// operator how it went.
    /// moment  on the recording's time axis [s], for the cursor A; nothing: as said
    void openRecording(const QString& path, std::optional<double> moment = {});
    /// The moment that cursor A stands on, while it is one of a recording or of a history that is held still.
    const Replay& replay() const;
    void closeRecordings();
    /// Into and from a file of its own; tells nobody.
    Result<void> saveArrangement(const QString& path) const;
    Result<void> openArrangement(const QString& path);
    // Which plots there are, as text for the settings. What cannot be read changes nothing.
    QByteArray arrangement() const;
    void arrange(const QByteArray& json);
    /// How much of the past is kept at most [bytes].
    std::size_t budget() const;
    void setBudget(std::size_t bytes);

    /// How much time the plots can show, as the menu offers it.
    struct Span {
        double seconds = 0;
        QString text;  ///< "2 min"
    };
    static QVector<Span> spans();

public Q_SLOTS:
    /// The jog key that is held, "X+" or "Wrist 2−": names the stretch in the lane. Empty: none.
    void setJogLabel(const QString& label);
    void setPaused(bool paused);
    /// Counts the force shown from what it is now; what is recorded and exported stays as measured.
    void setForceZeroed(bool zeroed);
    /// The list of signals at the left.
    void setSignalsShown(bool shown);
    /// Shows the list, ready for the words to look for.
    void searchSignals();
    void addPage();
    /// The table of what lies at the cursors and between them.
    void setValuesShown(bool shown);
    /// Spectrum of a signal, or one over another.
    void setAnalysisShown(bool shown);
    void setTimeAxis(tiller::TimeAxis axis);
    /// Asks for the words of a note at this moment of the plots' time.
    void askForNote(double time);
    void addNote(double time, const QString& text);
    /// What is shown as a picture, to be pasted elsewhere.
    void copyPicture();
    /// Begins a recording, or ends the one that runs.
    void toggleRecording();
    /// Asks where the shown range shall be saved.
    void askExport();
    /// Asks how the recording in front is to be compared with the model of its arm, and does it.
    void compareWithModel();
    /// Ends a replay: takes cursor A away and shows the newest samples.
    void endReplay();

Q_SIGNALS:
    /// Chosen in the menu of the Record key.
    void recordingChosen(const tiller::RecordingChoice& choice);
    /// What the menu has no room for is to be shown: signals, folder, file name.
    void recordingOptionsWanted();
    /// Another moment is replayed; nothing: all is live again.
    void replayChanged(const tiller::Replay& moment);
    /// Arm and model of a recording part at this moment of its time axis.
    void partedFromModel(const QString& text, const QString& details, const QString& path, double seconds);
    /// Pages, plots, their signals or the budget are others.
    void arrangementChanged();

protected:
    void changeEvent(QEvent* event) override;

private:
    void buildHeader();
    void styleHeader();
    void take(const SampleBatch& batch);
    void takeExtra(const SampleBatch& batch);
    void followAbsent();
    void buildPagesMenu();
    void sayWhatIsShown();
    /// "12.3 MB · 145 kB a second · 40 GB free · 0 packets lost"
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
    void makeWay();
    void askToSaveArrangement();
    void askToOpenArrangement();
    void onState(const SessionState& state);
    void followLane(const SessionState& state);
    void updateHeader();
    void sayNothingToExport();
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
    QHash<QString, double> incidents_;  ///< opened ones: when their stops are on the plots' time axis [s]
    PlotPages* pages_ = nullptr;
    SignalTree* tree_ = nullptr;
    PlotValues* values_ = nullptr;
    PlotAnalysis* analysis_ = nullptr;
    QToolButton* valuesKey_ = nullptr;
    QLabel* historyLabel_ = nullptr;
    QWidget* side_ = nullptr;  // the list and what stands under it
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
    std::optional<double> backAt_;  ///< on the plots' time axis [s]: data came again, not in the lane yet
    RecordingChoice choice_;
    bool recording_ = false;
    double recordingSeconds_ = 0;
    int framesToHistoryText_ = 0;
    int framesToAnalysis_ = 0;
    SerialExecutor files_;  // last: its jobs end before the rest
};

}  // namespace tiller
