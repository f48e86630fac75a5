// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The arm as it stands, seen in perspective: links, tool frame, the ghost of a target with the way there, the
// trace of the TCP, waypoints, and the direction of a jog. It only shows: nothing done in it moves the robot.
// As long as the operator does not choose what is in the picture, arm, ghost and waypoints are kept in it.

#include <Eigen/Core>
#include <QImage>
#include <QString>
#include <QTimer>
#include <QWidget>
#include <memory>
#include <optional>
#include <vector>

#include "robot/collision/move_check.h"
#include "robot/core/clock.h"
#include "robot/core/robot_model.h"
#include "robot/core/spatial.h"
#include "widgets/common/theme.h"
#include "widgets/scene/camera.h"
#include "widgets/scene/label_placer.h"
#include "widgets/scene/scene_trace.h"
#include "widgets/session/scene_marks.h"
#include "widgets/session/session_state.h"

namespace tiller {

class SceneBodies;
class SceneKeys;
class ScenePainter;

/// A jog under way, for the arrow at the tool.
struct SceneJog {
    Eigen::Vector3d direction = Eigen::Vector3d::Zero();  ///< in the base frame, any length
    QString label;                                        ///< "X+ Base"
    int axis = 0;                                         ///< colour: 0 X, 1 Y, 2 Z
    bool turns = false;                                   ///< about the direction, not along it
    int joint = -1;  ///< a joint turns: 0 ... 5, the way `direction` says about its own axis; -1: none
    int sign = 1;    ///< of the joint's turn
};

class SceneView : public QWidget {
    Q_OBJECT

public:
    explicit SceneView(QWidget* parent = nullptr);
    ~SceneView() override;

    void setModel(const RobotModel& model);
    void setJoints(const JointPositions& q);
    void setTcpOffset(const Pose& offset);
    void setGhost(const std::optional<Ghost>& ghost);
    /// Beside the ghost, of another colour: what would take its place. The two are told apart by words too.
    void setSecondGhost(const std::optional<Ghost>& ghost);
    const std::optional<Ghost>& secondGhost() const { return secondGhost_; }
    /// Shows besides how the arm stood, with a word over the picture that this is a replay. Nothing: it is not.
    void setReplay(const std::optional<ReplayMark>& replay);
    const std::optional<ReplayMark>& replay() const { return replay_; }
    void setWaypoints(const std::vector<WaypointMark>& waypoints);
    void setFrames(const std::vector<FrameMark>& frames);
    const std::vector<FrameMark>& frames() const { return frames_; }
    /// Ways that are drawn besides the ghost's.
    void setPaths(const std::vector<PathMark>& paths);
    const std::vector<PathMark>& paths() const { return paths_; }
    /// What stands around the arm. It is drawn, and looked at before a move.
    void setSurroundings(const collision::CellSurroundings& cell);
    /// What the move to the ghost would be; nothing without a ghost that can be reached.
    const std::optional<collision::MoveReport>& moveReport() const { return report_; }
    /// What stands in the way to the ghost, as a sentence; empty when nothing does.
    QString moveLimitText() const;
    void setJogDirection(const std::optional<SceneJog>& jog);
    const std::optional<SceneJog>& jog() const { return jog_; }
    /// Greyed; with a word in the middle unless it is empty.
    void setStale(bool stale, const QString& word = {});
    void setSpeedFraction(double fraction);
    /// Something lies over the lower edge: arm, ghost and waypoints are kept above it.
    /// height  [px]
    void setCoveredBelow(double height);

    const std::optional<Ghost>& ghost() const { return ghost_; }
    /// "ghost “above tray” · reachable · largest turn Wrist 2 41° · 2.4 s at 35 %"; empty without a ghost.
    QString ghostText() const;
    /// For the jog frame "View": R_base_view, columns X to the right, Y up, Z towards the eye.
    Eigen::Matrix3d viewRotation() const { return camera_.viewRotation(); }
    const Camera& camera() const { return camera_; }
    /// Names of waypoints and frames as they were drawn last, and how many found no place.
    const std::vector<PlacedLabel>& labels() const { return labels_; }
    int hiddenLabels() const { return hiddenLabels_; }
    /// "3 names hidden: come nearer"; empty when none is.
    QString hiddenText() const;

    /// Draws one frame; paintEvent() does nothing else. For benchmarks and pictures.
    void paintScene(QPainter& painter, const QSizeF& size);

    QSize sizeHint() const override { return {930, 520}; }
    QSize minimumSizeHint() const override { return {240, 180}; }

public Q_SLOTS:
    void setState(const tiller::SessionState& state);
    /// Looks from there, with everything in the picture.
    void lookFrom(tiller::StandardView from);
    void resetView() { lookFrom(StandardView::Home); }
    /// Arm, ghost, waypoints and frames into the picture; they are kept in it from now on.
    void fitAll();

Q_SIGNALS:
    void ghostTextChanged(const QString& text);
    /// As moveLimitText().
    void moveLimitChanged(const QString& text);
    /// The eye moved: a jog in the frame "View" must stop or follow.
    void viewChanged();

protected:
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void changeEvent(QEvent* event) override;
    void focusInEvent(QFocusEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    /// Asks for a repaint, at most 60 a second.
    void changed();
    /// True when somebody could see that the arm is not where it was drawn last.
    bool armHasMoved() const;
    /// Looks at the way to the ghost anew.
    void updateGhost();
    QString ghostFigures() const;
    void rebuildCheck();
    QRectF drawJog(ScenePainter& scene);
    /// Of the cell [m]; nothing where it has none.
    std::optional<double> floorHeight() const;
    void orbitBy(const QPointF& pixels);
    void panBy(const QPointF& pixels);
    void zoomBy(double factor);
    /// Places the eye for a picture of this size.
    void frame(const QSizeF& size);
    std::vector<Camera::Ball> inSight() const;
    /// share  of the picture that is left free around what must be in sight
    QMarginsF margins(const QSizeF& size, double share) const;
    void placeKeys();
    void drawNames(ScenePainter& scene, const QSizeF& size, const QRectF& arrowName);
    void drawGround(QPainter& painter, const QSize& size);
    void drawPaths(ScenePainter& scene);

    RobotModel model_;
    JointPositions q_;
    JointPositions drawnAt_;  ///< the joints in the last picture
    Pose tcpOffset_;
    std::optional<Ghost> ghost_;
    std::optional<Ghost> secondGhost_;
    std::optional<ReplayMark> replay_;
    collision::CellSurroundings cell_;
    std::optional<collision::CollisionCheck> check_;  ///< nothing: to be made anew
    std::optional<collision::MoveReport> report_;
    QString limitText_;
    QTimer examineTimer_;  ///< while the arm moves, the way is looked at a few times a second
    QString ghostText_;
    std::vector<WaypointMark> waypoints_;
    std::vector<FrameMark> frames_;
    std::optional<SceneJog> jog_;
    std::vector<PathMark> paths_;
    SceneTrace trace_;
    std::unique_ptr<SceneBodies> bodies_;
    QImage ground_;               ///< what lies under the bodies, as drawn last
    Camera::Eye groundSeenFrom_;  ///< by this eye
    std::optional<ColorScheme> groundScheme_;
    bool haveJoints_ = false;
    bool stale_ = true;
    QString staleWord_;
    double speedFraction_ = 1.0;
    Camera camera_;
    SceneKeys* keys_;
    bool keptInSight_ = true;            ///< until the operator moves the picture or zooms
    bool fitWanted_ = true;              ///< the picture is made anew
    double coveredBelow_ = 0;            ///< [px]
    std::optional<Camera> beforeGhost_;  ///< to go back to when the ghost is gone
    std::vector<PlacedLabel> labels_;
    int hiddenLabels_ = 0;
    QPointF dragFrom_;
    enum class Drag { None, Orbit, Pan };
    Drag drag_ = Drag::None;
    Qt::MouseButton dragButton_ = Qt::NoButton;
    bool focusByKey_ = false;  // a click needs no frame to show where the focus is
    QTimer frameTimer_;
    std::int64_t lastPaintNs_ = 0;
};

}  // namespace tiller
