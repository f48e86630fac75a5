// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The left column of the window: choose frame, motion and speed, then hold a key. It asks a session to move
// through a MotionPort and shows what the robot confirmed.

#include <QVector>
#include <memory>
#include <optional>
#include <vector>

#include "widgets/common/hold_rules.h"
#include "widgets/common/panel.h"
#include "widgets/jog/freedrive_axes.h"
#include "widgets/jog/jog_motion.h"
#include "widgets/jog/limiter_line.h"
#include "widgets/session/motion_port.h"
#include "widgets/session/move_time.h"
#include "widgets/session/scene_marks.h"

class QMenu;
class QTimer;
class QVBoxLayout;

namespace tiller {

class ArmKey;
class AxisJog;
class BackTrack;
class HoldButton;
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

/// A jog under way, whatever holds it: a key of the column, the keyboard, a gamepad or a SpaceMouse.
struct ShownJog {
    QString label;      ///< as the keys are called: "X+", "X+ Y+", "Wrist 2−"
    QString frameName;  ///< empty for joints
    Eigen::Vector3d direction = Eigen::Vector3d::Zero();  ///< in the base frame; zero for joints
    int axis = 0;                                         ///< 0-2: the one that gives the colour
    bool turns = false;                                   ///< about the direction, not along it
    int joint = -1;                                       ///< the one that turns, 0 ... 5; -1: none
    int sign = 1;                                         ///< of the joint's turn
    friend bool operator==(const ShownJog&, const ShownJog&) = default;
};

class JogColumn : public Panel {
    Q_OBJECT

public:
    /// What the height of the column has room for.
    enum class Fold {
        Open,    ///< everything at its size
        Snug,    ///< joints in low rows, keys a little smaller
        Pairs,   ///< joints in two columns
        Folded,  ///< pose or joints, by choice
    };

    explicit JogColumn(MotionPort port, QWidget* parent = nullptr);
    /// Moves the arm of this session and follows its state.
    explicit JogColumn(RobotSession& session, QWidget* parent = nullptr);
    ~JogColumn() override;

    /// Frame, motion and speed of the next press.
    JogSelectors& selectors() { return *selectors_; }
    const JogSelection& selection() const;
    /// The chosen speed: the fastest that any motion held by a key may be.
    HeldSpeed heldSpeed() const;
    /// ofProject  it is a position of the project: the project guard of the session may refuse it
    void setHome(const JointPositions& home, bool ofProject);
    /// What freedrive leaves free.
    void setFreedriveAxes(FreedriveAxes axes);
    /// Counts the way from here; once more: since the press again.
    void zeroHere();
    /// The places that Back leads over, the oldest first, for the view.
    std::vector<JointPositions> wayBack() const;
    /// How far the arm can still go, as the keys of the pad show it.
    TravelWatch& travel() { return *travel_; }

    /// What holds for every key, and for devices and the keyboard.
    /// terms  must outlive the column
    void setHoldTerms(HoldTerms& terms);
    /// Ends the motion of whichever key is held. To be called before a tab, perspective or tool changes.
    void stopMotion(control::StopCause cause);
    /// True while a key of the column or a device is held and its motion runs.
    bool isHolding() const;
    /// For devices: the same frame, speed and rules as the keys of the column.
    AxisJog& axisJog() { return *axisJog_; }
    /// The column's key arms this keyboard. While it is armed: F freedrive, Home home, End align, Backspace back, each held.
    void addHoldKeys(KeyboardJog& keyboard);
    /// Every key that moves the arm, for a test clock or a test's pump.
    QVector<HoldButton*> holdKeys() const;

    QSize sizeHint() const override { return {390, 948}; }
    QSize minimumSizeHint() const override;

public Q_SLOTS:
    void applyState(const tiller::SessionState& state);

Q_SIGNALS:
    /// A press moved nothing; a sentence that says why and what to do.
    void refused(const QString& reason);
    /// A jog begins, goes another way, or ends (nothing).
    void jogShown(const std::optional<tiller::ShownJog>& jog);
    /// heldSpeed() may be another one.
    void speedChanged();
    /// The pointer is on a key whose motion goes to a place, or the key is held.
    void ghostWanted(const tiller::Ghost& ghost);
    void ghostGone();
    /// wayBack() is another one; at most some ten times a second.
    void wayBackChanged();

protected:
    void changeEvent(QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    using Begin = std::function<Result<RobotSession::MotionId>()>;

    void buildBottom(QVBoxLayout* layout);
    void connectKeys();
    void connectBottom();
    /// What a key does when steps are chosen.
    enum class Steps { None, Lengths, Turns };
    void guardKey(HoldButton* key, const Begin& begin, Steps steps);
    /// modified  whether Ctrl and Shift change its speed
    void guardMotion(HoldButton* key, HoldMotion motion, bool modified);
    Result<RobotSession::MotionId> beginJog(const control::JogTarget& target);
    Result<RobotSession::MotionId> beginMove(const MoveRequest& request);
    Result<RobotSession::MotionId> beginFreedrive();
    QString deviceObstacle() const;
    void fillFreedriveMenu(QMenu& menu);
    /// Of the rows of selectors at the top [px].
    struct Rows {
        int height;
        int apart;
    };
    Rows rowsFor(Fold fold) const;
    /// The least height of a key of the pad [px].
    int keyFor(Fold fold) const;
    int heightFor(Fold fold) const;
    Fold foldFor(int height) const;
    /// Shows what there is room for, and with the height of a finger where it has to be.
    void fold();
    void arrange();
    void showReason();
    void showFrame();
    void tellWayBack();
    void showJog();
    void lightKeys();
    void showFactor();
    std::optional<ShownJog> shownJog() const;
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
    bool payloadChecked_ = true;  ///< freedrive looks at the forces first
    QString refusal_;
    HoldBounds bounds_;  ///< of the motion begun last

    JogSelectors* selectors_ = nullptr;
    SegmentedControl* detailTab_ = nullptr;
    JogPad* pad_ = nullptr;
    LimiterLine* limiter_ = nullptr;
    PoseView* pose_ = nullptr;
    JointRows* joints_ = nullptr;
    HoldButton* freedrive_ = nullptr;
    HoldButton* homeKey_ = nullptr;
    HoldButton* align_ = nullptr;
    HoldButton* back_ = nullptr;
    std::unique_ptr<BackTrack> track_;
    std::uint64_t wayBackTold_ = 0;  ///< BackTrack::revision
    int wayBackFrames_ = 0;          ///< since it was told
    AxisJog* axisJog_ = nullptr;
    ArmKey* armKey_ = nullptr;

    KeyGhosts* ghosts_ = nullptr;
    TravelWatch* travel_ = nullptr;
    std::optional<ShownJog> shownJog_;
    double keyFactor_ = 1;  ///< with which the motion of a key was begun
    LimiterAdvice nearest_;
    JointPositions limiterAt_;
    std::shared_ptr<const collision::CollisionCheck> limiterWith_;
    Eigen::Matrix3d limiterIn_ = Eigen::Matrix3d::Zero();
    control::Limiter limiterSeen_;
    JointPositions speedsAt_;   ///< where the arm stood when the keys' speeds were worked out
    bool speedsKnown_ = false;  ///< they are those of the selection, the slider and the place now
    QTimer* refusalTimer_ = nullptr;
    Fold fold_ = Fold::Open;
    int finger_ = 0;  ///< touchHeight() when it was arranged
};

}  // namespace tiller
