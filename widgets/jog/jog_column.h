// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The left column of the window: choose frame, motion and speed, then hold a key. It asks a session to move
// through a JogPort and shows what the robot confirmed.

#include <QHash>
#include <QVector>
#include <array>
#include <memory>

#include "widgets/common/hold_rules.h"
#include "widgets/common/panel.h"
#include "widgets/jog/freedrive_axes.h"
#include "widgets/jog/jog_motion.h"
#include "widgets/jog/jog_port.h"
#include "widgets/jog/limiter_line.h"
#include "widgets/jog/travel.h"

class QMenu;
class QTimer;
class QVBoxLayout;

namespace tiller {

class AxisJog;
class BackTrack;
class HoldButton;
struct HoldMotion;
class JogKey;
class JogPad;
class JointRows;
class KeyboardJog;
class LimiterLine;
class PoseView;
class SegmentedControl;

/// Where a bounded motion would end, to be seen before the arm moves.
struct JogGhost {
    QString name;
    JointPositions q;
    bool linear = false;
    bool reachable = true;
    double speed = 0;         ///< [rad/s], or [m/s] when linear
    double acceleration = 0;  ///< [rad/s2], or [m/s2]
};

class JogColumn : public Panel {
    Q_OBJECT

public:
    explicit JogColumn(JogPort port, QWidget* parent = nullptr);
    /// Moves the arm of this session and follows its state.
    explicit JogColumn(RobotSession& session, QWidget* parent = nullptr);
    ~JogColumn() override;

    /// The view's axes in the base frame. The frame "View" can be chosen once this was called.
    void setViewRotation(const Eigen::Matrix3d& R_base_view);
    /// The frames the fourth key of "Frame" offers.
    void setTaughtFrames(const QVector<TaughtFrame>& frames);
    /// Chooses one of them, as the fourth key of "Frame" does; ends the motion of a held key.
    void chooseTaughtFrame(const QUuid& frame);
    void setHome(const JointPositions& home) { home_ = home; }
    /// A TCP speed entered by hand [m/s]; turns and joints in proportion.
    void setFreeSpeed(double tcpSpeed);
    /// A step entered by hand. Longer than 10 mm or 10 deg it runs only while the key is held.
    void setFreeStep(const StepSize& step);
    /// Moves until the tool touches something with this force [N].
    void setUntilContact(double force);
    enum class Entry { Step, Speed, ContactForce };
    /// Opens the field in which the operator enters one of these by hand.
    void askFor(Entry entry);
    /// What freedrive leaves free.
    void setFreedriveAxes(FreedriveAxes axes);
    /// Counts the way from here; once more: since the press again.
    void zeroHere();
    /// Looks at the room left in every direction, one direction a call.
    void lookAround();

    const JogSelection& selection() const { return selection_; }
    /// index  into speedClasses()
    void setSpeedClass(int index);
    /// What holds for every key, and for devices and the keyboard.
    /// terms  must outlive the column
    void setHoldTerms(HoldTerms& terms);
    /// Ends the motion of whichever key is held. To be called before a tab, perspective or tool changes.
    void stopMotion(control::StopCause cause);
    /// True while a key of the column or a device is held and its motion runs.
    bool isHolding() const;
    /// For devices: the same frame, speed and rules as the keys of the column.
    AxisJog& axisJog() { return *axisJog_; }
    /// While the keyboard is armed: F freedrive, Home home, End align, Backspace back, each held.
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
    /// The pointer is on a key whose motion goes to a place, or the key is held.
    void ghostWanted(const tiller::JogGhost& ghost);
    void ghostGone();

protected:
    void changeEvent(QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    using Begin = std::function<Result<RobotSession::MotionId>()>;

    void buildSelectors(QVBoxLayout* layout);
    void connectSelectors();
    void chooseFrame(int segment);
    void showFrames();
    void arrange();
    void showReason();
    QString quietText() const;

    // jog_column_keys.cpp
    void buildBottom(QVBoxLayout* layout);
    void connectKeys();
    void connectBottom();
    void guardKey(HoldButton* key, const Begin& begin, bool steps);
    void guardMotion(HoldButton* key, HoldMotion motion);
    void offerGhost(HoldButton* key, const QString& name, std::function<std::optional<MoveRequest>()> target);
    void showGhost(HoldButton* key);
    Result<RobotSession::MotionId> beginJog(const control::JogTarget& target);
    Result<RobotSession::MotionId> beginMove(const MoveRequest& request);
    Result<RobotSession::MotionId> beginFreedrive();
    QString deviceObstacle() const;
    QString countdown() const;

    // jog_column_room.cpp
    void showLimiter();
    void showMotionTexts();
    void offerChoices(SegmentedControl* control, int segment, std::function<void(QMenu&)> fill);
    void fillStepMenu(QMenu& menu);
    void fillSpeedMenu(QMenu& menu);
    void fillFreedriveMenu(QMenu& menu);
    void askForNumber(const QString& text, double value, double least, double most, int digits,
                      std::function<void(double)> use);
    QString travelText(const Travel& travel, bool turns) const;

    JogPort port_;
    SessionState state_;
    JogSelection selection_;
    QVector<TaughtFrame> frames_;
    JointPositions home_ = defaultHome();
    FreedriveAxes freedriveAxes_ = FreedriveAxes::All;
    bool payloadChecked_ = true;  ///< freedrive looks at the forces first
    QString refusal_;
    HoldBounds bounds_;  ///< of the motion begun last

    SegmentedControl* frame_ = nullptr;
    SegmentedControl* motion_ = nullptr;
    SegmentedControl* speed_ = nullptr;
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
    AxisJog* axisJog_ = nullptr;

    struct GhostOffer {
        QString name;
        std::function<std::optional<MoveRequest>()> target;
    };
    QHash<QObject*, GhostOffer> ghosts_;
    LimiterAdvice nearest_;
    JointPositions limiterAt_;
    control::Limiter limiterSeen_;
    std::array<Travel, 12> room_;  ///< per key of the pad, in the pad's order
    JointPositions lookedFrom_;
    Eigen::Matrix3d lookedIn_ = Eigen::Matrix3d::Zero();
    int look_ = 0;      ///< the direction looked at next
    int lookLeft_ = 0;  ///< how many are still to be looked at
    QTimer* refusalTimer_ = nullptr;
    bool compact_ = false;
    bool hasView_ = false;
};

}  // namespace tiller
