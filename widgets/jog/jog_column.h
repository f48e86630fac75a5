// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The left column of the window: selection of frame, motion and speed, and the jog buttons. A MotionPort
// starts the motions. The display shows the motion that the robot confirms.

#include <QVector>
#include <memory>
#include <optional>
#include <vector>

#include "robot/station/jog/freedrive_axes.h"
#include "robot/station/jog/jog_motion.h"
#include "robot/station/link/motion_port.h"
#include "robot/station/link/move_time.h"
#include "widgets/common/panel.h"
#include "widgets/common/scene_marks.h"
#include "widgets/hold/hold_rules.h"
#include "widgets/jog/limiter_line.h"

class QMenu;
class QTimer;
class QVBoxLayout;

namespace tiller {

class ArmKey;
class AxisJog;
class RetracePath;
class HoldGuard;
class HoldToRunButton;
struct Deflection;
struct HoldMotion;
class JogKey;
class JogPad;
class JogSelectors;
class JointRows;
class KeyboardJog;
class KeyGhosts;
class LimiterLine;
class PoseView;
class SegmentedControl;
class TravelWatch;

/// The current jog by a button of the column, the keyboard, a gamepad or a SpaceMouse.
struct ShownJog {
    QString label;      ///< name as on the buttons, e.g. "X+", "X+ Y+", "Wrist 2−"
    QString frameName;  ///< empty for a joint motion
    Eigen::Vector3d direction = Eigen::Vector3d::Zero();  ///< in the base frame; zero for a joint motion
    int axis = 0;                                         ///< axis that defines the colour, 0 ... 2
    bool turns = false;                                   ///< true for a rotation about the direction
    int joint = -1;                                       ///< rotating joint, 0 ... 5; -1 if there is none
    int sign = 1;                                         ///< sign of the joint rotation
    friend bool operator==(const ShownJog&, const ShownJog&) = default;
};

class JogColumn : public Panel {
    Q_OBJECT

public:
    /// Layouts for different heights of the column.
    enum class Fold {
        Open,    ///< everything at normal size
        Snug,    ///< joints in smaller rows, smaller buttons
        Pairs,   ///< joints in two columns
        Folded,  ///< either pose or joints
    };

    /// policy  the policy of the window, for all buttons, devices and the keyboard; must outlive the column
    JogColumn(MotionPort port, HoldPolicy& policy, QWidget* parent = nullptr);
    /// Moves the arm of this session and displays its state.
    JogColumn(RobotSession& session, HoldPolicy& policy, QWidget* parent = nullptr);
    ~JogColumn() override;

    /// Selectors of the frame, motion and speed for the next press.
    JogSelectors& selectors() { return *selectors_; }
    const JogSelection& selection() const;
    /// The selected speed, which is an upper limit for all hold-to-run motions.
    HeldSpeed heldSpeed() const;
    /// ofProject  true if the position is from the project, so that the project guard of the session may
    /// refuse the move
    void setHome(const JointPositions& home, bool ofProject);
    /// Sets the axes that are free in freedrive.
    void setFreedriveAxes(FreedriveAxes axes);
    /// Sets the zero point of the distance display. A second call removes it.
    void zeroHere();
    /// The positions of the path that Back would retrace, oldest first, for the 3D view.
    std::vector<JointPositions> retracePath() const;
    /// Remaining distances, shown on the pad buttons.
    TravelWatch& travel() { return *travel_; }

    /// Ends the motion of any held button. Call this before a change of tab, perspective or tool.
    void stopMotion(control::StopCause cause);
    /// True while a motion of a held button or device is active.
    bool isHolding() const;
    /// Jogging by keyboard and devices, with the same frame, speed and rules as the buttons.
    AxisJog& axisJog() { return *axisJog_; }
    /// Connects the button that arms the keyboard with this keyboard. While the keyboard is armed, these keys
    /// are hold-to-run keys: F (freedrive), Home (home position), End (align), Backspace (back).
    void addHoldKeys(KeyboardJog& keyboard);
    /// All buttons that move the arm, for tests.
    QVector<HoldToRunButton*> holdKeys() const;

    QSize sizeHint() const override { return {390, 948}; }
    QSize minimumSizeHint() const override;

public Q_SLOTS:
    void applyState(const tiller::SessionState& state);

Q_SIGNALS:
    /// A press had no effect. `reason` is a sentence with the reason and a suggested action.
    void refused(const QString& reason);
    /// A jog has started, changed direction or ended. `jog` is empty after the end.
    void jogShown(const std::optional<tiller::ShownJog>& jog);
    /// heldSpeed() may have changed.
    void speedChanged();
    /// The pointer is on a button whose motion has a target, or the user holds this button.
    void ghostWanted(const tiller::Ghost& ghost);
    void ghostHidden();
    /// retracePath() has changed. Emitted about ten times per second at most.
    void retracePathChanged();

protected:
    void changeEvent(QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    using Begin = std::function<Result<RobotSession::MotionId>()>;

    void buildBottom(QVBoxLayout* layout, HoldPolicy& policy);
    void connectKeys();
    void connectBottom();
    /// Effect of the step mode on a button.
    enum class Steps { None, Lengths, Turns };
    void guardKey(HoldToRunButton* key, const Begin& begin, Steps steps);
    /// modified  if true, Ctrl and Shift change the speed
    void guardMotion(HoldToRunButton* key, HoldMotion motion, bool modified);
    Result<RobotSession::MotionId> beginJog(const control::JogTarget& target);
    Result<RobotSession::MotionId> beginMove(const MoveRequest& request);
    Result<RobotSession::MotionId> beginFreedrive();
    QString deviceObstacle() const;
    void fillFreedriveMenu(QMenu& menu);
    /// Sizes of the selector rows at the top [px].
    struct Rows {
        int height;
        int apart;
    };
    Rows rowsFor(Fold fold) const;
    /// Minimum button size of the pad [px].
    int keyFor(Fold fold) const;
    int heightFor(Fold fold) const;
    Fold foldFor(int height) const;
    /// Selects the layout for the available height and touchHeight().
    void fold();
    void arrange();
    void showReason();
    void showFrame();
    void reportRetracePath();
    void showJog();
    void lightKeys();
    void showFactor();
    std::optional<ShownJog> shownJog() const;
    HoldGuard* stepButton(const Deflection& wish) const;
    bool isDriven(const JogKey& key) const;
    bool isDriven(int joint, int direction) const;
    void showSpeeds();
    void showLimiter();
    QString quietText() const;
    QString countdown() const;

    MotionPort port_;
    SessionState state_;
    JointPositions home_ = defaultHome();
    bool homeOfProject_ = false;
    FreedriveAxes freedriveAxes_ = FreedriveAxes::All;
    bool payloadChecked_ = true;  ///< if true, the payload forces are checked before freedrive starts
    QString refusal_;
    HoldBounds bounds_;  ///< limits of the last motion

    JogSelectors* selectors_ = nullptr;
    SegmentedControl* detailTab_ = nullptr;
    JogPad* pad_ = nullptr;
    LimiterLine* limiter_ = nullptr;
    PoseView* pose_ = nullptr;
    JointRows* joints_ = nullptr;
    HoldToRunButton* freedrive_ = nullptr;
    HoldToRunButton* homeKey_ = nullptr;
    HoldToRunButton* align_ = nullptr;
    HoldToRunButton* back_ = nullptr;
    std::unique_ptr<RetracePath> track_;
    std::uint64_t retracePathReported_ = 0;  ///< RetracePath::revision() at the last signal
    int retracePathFrames_ = 0;              ///< frames since the last signal
    AxisJog* axisJog_ = nullptr;
    ArmKey* armKey_ = nullptr;

    KeyGhosts* ghosts_ = nullptr;
    TravelWatch* travel_ = nullptr;
    std::optional<ShownJog> shownJog_;
    double keyFactor_ = 1;  ///< speed factor at the start of the current motion
    LimiterAdvice nearest_;
    JointPositions limiterAt_;
    std::shared_ptr<const collision::CollisionCheck> limiterWith_;
    Eigen::Matrix3d limiterIn_ = Eigen::Matrix3d::Zero();
    control::Limiter limiterSeen_;
    JointPositions speedsAt_;  ///< arm position for which the displayed speeds were computed
    /// True if the displayed speeds are valid for the selection, the slider and the position.
    bool speedsKnown_ = false;
    QTimer* refusalTimer_ = nullptr;
    Fold fold_ = Fold::Open;
    int finger_ = 0;  ///< touchHeight() of the current layout
};

}  // namespace tiller
