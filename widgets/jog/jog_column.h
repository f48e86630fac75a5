// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The left column of the window: choose frame, motion and speed, then hold a key. It asks a session to move
// through a JogPort and shows what the robot confirmed.

#include <QVector>
#include <memory>

#include "widgets/common/panel.h"
#include "widgets/jog/jog_motion.h"
#include "widgets/jog/jog_port.h"
#include "widgets/jog/limiter_line.h"

class QTimer;
class QVBoxLayout;

namespace tiller {

class AxisJog;
class BackTrack;
class HoldButton;
class JogPad;
class JointRows;
class LimiterLine;
class PoseView;
class SegmentedControl;

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
    void setHome(const JointPositions& home) { home_ = home; }
    /// A TCP speed entered by hand [m/s]; turns and joints in proportion.
    void setFreeSpeed(double tcpSpeed);
    /// A step entered by hand. Longer than 10 mm or 10 deg it runs only while the key is held.
    void setFreeStep(const StepSize& step);
    /// Counts the way from here.
    void zeroHere();
    /// Looks at the room left in every direction, one direction a call.
    void lookAround();

    const JogSelection& selection() const { return selection_; }
    /// index  into speedClasses()
    void setSpeedClass(int index);
    /// Ends the motion of whichever key is held. To be called before a tab, perspective or tool changes.
    void stopMotion(control::StopCause cause);
    /// True while a key of the column is held and its motion runs.
    bool isHolding() const;
    /// For devices: the same frame, speed and rules as the keys of the column.
    AxisJog& axisJog() { return *axisJog_; }
    /// Every key that moves the arm, for a test clock or a test's pump.
    QVector<HoldButton*> holdKeys() const;

    QSize sizeHint() const override { return {390, 948}; }
    QSize minimumSizeHint() const override;

public Q_SLOTS:
    void applyState(const tiller::SessionState& state);

Q_SIGNALS:
    /// A press moved nothing; a sentence that says why and what to do.
    void refused(const QString& reason);

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    void buildSelectors(QVBoxLayout* layout);
    void buildBottom(QVBoxLayout* layout);
    void connectKeys();
    void connectSelectors();
    void guardKey(HoldButton* key, std::function<Result<RobotSession::MotionId>()> begin, bool steps);
    void chooseFrame(int segment);
    void showFrames();
    void arrange();
    void showReason();
    void showLimiter();
    QString quietText() const;

    JogPort port_;
    SessionState state_;
    JogSelection selection_;
    QVector<TaughtFrame> frames_;
    JointPositions home_ = defaultHome();
    QString refusal_;

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
    Limiter nearest_;
    JointPositions limiterAt_;
    int look_ = 0;  ///< the direction looked at next
    QTimer* refusalTimer_ = nullptr;
    bool compact_ = false;
    bool hasView_ = false;
};

}  // namespace tiller
