// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The panel "Plots": TCP force above, joint currents below, what the robot did in a lane underneath, and the
// controls in its title bar. It takes from the session, once a frame, every sample since the last one and the state.

#include <QString>
#include <QVector>
#include <memory>
#include <optional>

#include "robot/core/result.h"
#include "widgets/common/panel.h"
#include "widgets/session/recording_choice.h"
#include "widgets/session/session_state.h"

class QLabel;
class QToolButton;

namespace tiller {

class ElidedLabel;
class PlotFeed;
class PlotView;
class RobotSession;
struct SampleBatch;
class SeriesBuffer;
class StateLane;

class PlotDock : public Panel {
    Q_OBJECT

public:
    explicit PlotDock(RobotSession& session, QWidget* parent = nullptr);
    ~PlotDock() override;

    PlotView& view() { return *view_; }
    const SeriesBuffer& history() const { return *history_; }
    const StateLane& lane() const { return *lane_; }

    /// What "Record" makes: holds for the next recording.
    void setRecordingChoice(const RecordingChoice& choice);
    const RecordingChoice& recordingChoice() const { return choice_; }

    /// Shown range as CSV, columns named as in recordings, or as a picture (.png, .svg, .pdf).
    Result<void> exportCsv(const QString& path) const;
    Result<void> exportPicture(const QString& path) const;
    /// By the ending of the name; tells the operator how it went.
    bool exportTo(const QString& path);

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
    /// Begins a recording, or ends the one that runs.
    void toggleRecording();
    /// Asks where the shown range shall be saved.
    void askExport();

Q_SIGNALS:
    /// Chosen in the menu of the Record key.
    void recordingChosen(const tiller::RecordingChoice& choice);
    /// What the menu has no room for is to be shown: signals, folder, file name.
    void recordingOptionsWanted();

protected:
    void changeEvent(QEvent* event) override;

private:
    void buildHeader();
    void styleHeader();
    void take(const SampleBatch& batch);
    void onState(const SessionState& state);
    void followLane(const SessionState& state);
    void updateHeader();
    void sayNothingToExport();
    void buildRecordMenu();
    void showRecordMenu();
    void askForFolder();

    RobotSession& session_;
    std::unique_ptr<SeriesBuffer> history_;
    std::unique_ptr<StateLane> lane_;
    std::unique_ptr<PlotFeed> feed_;
    PlotView* view_ = nullptr;
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
};

}  // namespace tiller
