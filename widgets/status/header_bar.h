// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The header, which is always visible. It shows the robot, modes, control and the next step, speed,
// connection quality, the last stop, and STOP in its own corner. After a click, all elements keep their
// positions for half a second, so that a second click does not hit another element.

#include <QPointer>
#include <QTimer>
#include <QWidget>
#include <array>
#include <functional>
#include <optional>

#include "robot/station/link/robot_session.h"
#include "widgets/status/mode_look.h"

class QHBoxLayout;
class QLabel;
class QPushButton;

namespace tiller {

class SimulationChip;
class SpeedChip;
class StackingWatch;
class StateChip;
class StopButton;

/// Session functions that the header uses.
struct HeaderPort {
    std::function<void(RobotCommand)> perform;
    std::function<void()> takeControl;
    std::function<void(double fraction)> setSpeedSlider;
    std::function<bool()> asksBeforeSlider =
        {};  ///< true if setSpeedSlider() asks the operator; may be empty
    std::function<void(control::StopCause)> stop;
};

class HeaderBar : public QWidget {
    Q_OBJECT

public:
    explicit HeaderBar(HeaderPort port, QWidget* parent = nullptr);
    explicit HeaderBar(RobotSession& session, QWidget* parent = nullptr);

    /// Menus that are opened by chips with an arrow.
    enum class Menu { Robot, Power, Control };
    QWidget* menuChip(Menu menu) const;
    NextStep shownStep() const { return step_; }
    /// note  returns the reason why key states are not verified; empty if they are verified
    void setHoldNote(std::function<QString()> note);

    static constexpr int kHeight = 76;
    QSize sizeHint() const override { return {1920, kHeight}; }
    QSize minimumSizeHint() const override { return {1200, kHeight}; }
    /// Time after a click during which positions do not change [ms].
    static constexpr int kKeepPlacesMs = 500;

public Q_SLOTS:
    void applyState(const tiller::SessionState& state);

Q_SIGNALS:
    void connectRequested();
    /// A chip with an arrow was clicked.
    void menuRequested(tiller::HeaderBar::Menu menu);
    /// "Recover…" or the safety chip was clicked.
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
    void stackStopAbove();
    void takeStep();
    void showStep();
    void offerStep(bool visible, bool enabled);
    void keepPlaces();
    void letPlacesGo();
    void showLink();
    enum class Size { Wide, Narrow, Tight };
    void arrange();
    void arrange(Size size, int below);
    int requiredWidth() const;
    /// Widths that fit every value of robot mode, safety and control without eliding [px].
    const std::array<int, 3>& contentWidths(bool tight);
    void showCap(double speedCap);
    void showLastStop();

    HeaderPort port_;
    std::function<QString()> holdNote_;
    SessionState state_;
    NextStep step_ = NextStep::None;
    /// Cache per size (normal, tight); reset when fonts change.
    std::array<std::optional<std::array<int, 3>>, 2> contentWidths_;
    bool stepLostFocus_ = false;  ///< true if the button was disabled or hidden while it had the focus
    QTimer linkPace_;
    QTimer places_;  ///< active while positions must not change

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
    /// STOP button above a modal dialog that blocks this window, at the same position as the blocked button.
    QPointer<StopButton> stopAbove_;
    QTimer stacking_;                        ///< active while stopAbove_ exists
    QPointer<StackingWatch> stackingWatch_;  ///< exists as long as stopAbove_
    QLabel* cap_;  ///< the banner below the bar; hidden unless the speed cap was raised
};

}  // namespace tiller
