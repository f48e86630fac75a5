// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The header, never hidden: which robot, in which modes, who is in control and what the next step is, how
// fast, how good the link, how the last stop went, and STOP in its own corner. What was just clicked keeps
// its place for half a second, with all that stands beside it: a second click never lands on something else.

#include <QPointer>
#include <QTimer>
#include <QWidget>
#include <functional>

#include "robot/station/link/robot_session.h"
#include "widgets/status/mode_look.h"

class QHBoxLayout;
class QLabel;
class QPushButton;

namespace tiller {

class SimulationChip;
class SpeedChip;
class StateChip;
class StopButton;

/// What the header asks a session to do.
struct HeaderPort {
    std::function<void(RobotCommand)> perform;
    std::function<void()> takeControl;
    std::function<void(double fraction)> setSpeedSlider;
    std::function<void(control::StopCause)> stop;
};

class HeaderBar : public QWidget {
    Q_OBJECT

public:
    explicit HeaderBar(HeaderPort port, QWidget* parent = nullptr);
    /// Follows this session and asks it.
    explicit HeaderBar(RobotSession& session, QWidget* parent = nullptr);

    /// The chip a menu opens below.
    enum class Menu { Robot, Power, Control };
    QWidget* menuChip(Menu menu) const;
    NextStep shownStep() const { return step_; }
    /// note  asked for a sentence that says why nobody confirms that a key is held; empty: somebody does
    void setHoldNote(std::function<QString()> note);

    static constexpr int kHeight = 76;
    QSize sizeHint() const override { return {1920, kHeight}; }
    QSize minimumSizeHint() const override { return {1200, kHeight}; }
    /// How long everything stays where it is after a click [ms].
    static constexpr int kKeepPlacesMs = 500;

public Q_SLOTS:
    void applyState(const tiller::SessionState& state);

Q_SIGNALS:
    /// "Connect…" was clicked.
    void connectRequested();
    /// A chip with an arrow was clicked.
    void menuRequested(tiller::HeaderBar::Menu menu);
    /// "Recover…", or the safety chip.
    void recoveryRequested();

protected:
    void changeEvent(QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void showEvent(QShowEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void offerStopAbove();
    void placeStopAbove();
    void takeStep();
    void showStep();
    void offerStep(bool visible, bool enabled);
    void keepPlaces();
    void letPlacesGo();
    void showLink();
    void arrange();
    void showCap(double speedCap);
    void showLastStop();

    HeaderPort port_;
    std::function<QString()> holdNote_;
    SessionState state_;
    NextStep step_ = NextStep::None;
    bool stepLostFocus_ = false;  ///< when it was greyed or hidden
    QTimer linkPace_;
    QTimer places_;  ///< runs while everything keeps its place

    QHBoxLayout* layout_;
    QLabel* name_;
    StateChip* robot_;
    SimulationChip* simulation_;
    StateChip* mode_;
    StateChip* safety_;
    StateChip* control_;
    QPushButton* stepButton_;
    SpeedChip* speed_;
    StateChip* link_;
    StateChip* lastStop_;
    StopButton* stop_;
    /// A dialog keeps the mouse from this window: STOP stands above it then, in its usual place.
    QPointer<StopButton> stopAbove_;
    QLabel* cap_;  ///< the banner below the bar; hidden unless the cap was raised
};

}  // namespace tiller
