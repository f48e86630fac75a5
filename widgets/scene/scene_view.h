// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The 3D view in perspective. It shows the arm, the tool frame, the ghost of a target with its path, the
// trace of the TCP, waypoints, and the direction of a jog. The view does not move the robot. Arm, ghost and
// waypoints are kept visible until the user changes the view.

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
#include "robot/station/link/session_state.h"
#include "widgets/common/scene_marks.h"
#include "widgets/common/theme.h"
#include "widgets/scene/camera.h"
#include "widgets/scene/label_placer.h"
#include "widgets/scene/scene_trace.h"

namespace tiller {

class SceneBodies;
class SceneKeys;
class ScenePainter;

/// The current jog, shown as an arrow at the tool.
struct SceneJog {
    Eigen::Vector3d direction = Eigen::Vector3d::Zero();  ///< in the base frame, any length
    QString label;                                        ///< e.g. "X+ Base"
    int axis = 0;                                         ///< colour: 0 X, 1 Y, 2 Z
    bool turns = false;                                   ///< true for a rotation about the direction
    int joint = -1;  ///< rotating joint 0 ... 5, with `direction` along its axis; -1 if there is none
    int sign = 1;    ///< sign of the joint rotation
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
    /// Sets a second ghost in another colour: the position that would replace the first ghost. Texts also
    /// distinguish the two ghosts.
    void setSecondGhost(const std::optional<Ghost>& ghost);
    const std::optional<Ghost>& secondGhost() const { return secondGhost_; }
    /// Also shows the arm at a past time, with a text above the arm. Empty if there is none.
    void setReplay(const std::optional<ReplayMark>& replay);
    const std::optional<ReplayMark>& replay() const { return replay_; }
    /// The large text during replay; empty if there is none. The live arm alone is not labelled as a replay.
    QString replayHeadline() const;
    /// The model that the replayed arm is drawn with.
    const RobotModel& replayModel() const;
    void setWaypoints(const std::vector<WaypointMark>& waypoints);
    void setFrames(const std::vector<FrameMark>& frames);
    const std::vector<FrameMark>& frames() const { return frames_; }
    /// Sets the paths shown in addition to the path of the ghost.
    void setPaths(const std::vector<PathMark>& paths);
    const std::vector<PathMark>& paths() const { return paths_; }
    /// Sets the surroundings of the arm. They are displayed, and moves are checked against them.
    void setSurroundings(const collision::CellSurroundings& cell);
    /// Result of checking the move to the ghost; empty without a reachable ghost.
    const std::optional<collision::MoveReport>& moveReport() const { return report_; }
    /// The limit on the move to the ghost, as a sentence; empty if there is none.
    QString moveLimitText() const;
    void setJogDirection(const std::optional<SceneJog>& jog);
    const std::optional<SceneJog>& jog() const { return jog_; }
    /// Shows the scene in grey, with an optional text in the centre.
    void setStale(bool stale, const QString& word = {});
    void setSpeedFraction(double fraction);
    /// Sets the height of an overlay at the bottom [px]. Arm, ghost and waypoints are kept visible above the
    /// overlay.
    void setCoveredBelow(double height);

    const std::optional<Ghost>& ghost() const { return ghost_; }
    /// Text with values of the ghost, e.g. "ghost “above tray” · reachable · largest turn Wrist 2 41° · 2.4 s
    /// at 35 %"; empty without a ghost.
    QString ghostText() const;
    /// Axes of the view in the base frame: columns are X to the right, Y up, Z towards the eye. MainWindow
    /// converts them to the jog frame.
    Eigen::Matrix3d viewRotation() const { return camera_.viewRotation(); }
    const Camera& camera() const { return camera_; }
    /// The labels of waypoints and frames in the last image, and the number of labels without a free
    /// position.
    const std::vector<PlacedLabel>& labels() const { return labels_; }
    int hiddenLabels() const { return hiddenLabels_; }
    /// Text with the number of hidden labels; empty if all labels are visible.
    QString hiddenText() const { return hiddenText(hiddenLabels_); }

    /// Draws one frame. Called by paintEvent(), benchmarks and the image export.
    void paintScene(QPainter& painter, const QSizeF& size);

    QSize sizeHint() const override { return {930, 520}; }
    QSize minimumSizeHint() const override { return {240, 180}; }

public Q_SLOTS:
    void setState(const tiller::SessionState& state);
    /// Fits all objects in the view from this direction.
    void lookFrom(tiller::StandardView from);
    void resetView() { lookFrom(StandardView::Home); }
    /// Fits the arm, ghost, waypoints and frames in the view, and keeps them visible from then on.
    void fitAll();

Q_SIGNALS:
    void ghostTextChanged(const QString& text);
    void moveLimitChanged(const QString& text);
    /// The camera moved. A jog in the frame "View" must stop or follow the view.
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
    static QString hiddenText(int labels);
    /// Schedules a repaint, at most 60 per second.
    void changed();
    /// True if the arm has visibly moved since the last image.
    bool armHasMoved() const;
    /// Repeats the check of the move to the ghost, and updates the texts about the ghost.
    void updateGhost();
    QString ghostValues() const;
    void rebuildCheck();
    QRectF drawJog(ScenePainter& scene);
    /// Height of the floor of the cell [m]; empty if the cell has no floor.
    std::optional<double> floorHeight() const;
    void orbitBy(const QPointF& pixels);
    void panBy(const QPointF& pixels);
    void zoomBy(double factor);
    /// Positions the camera for an image of this size.
    void frame(const QSizeF& size);
    std::vector<Camera::Ball> inSight() const;
    /// share  fraction of the image to keep free around the visible objects
    QMarginsF margins(const QSizeF& size, double share) const;
    void placeKeys();
    void drawNames(ScenePainter& scene, const QSizeF& size, const QRectF& arrowName);
    void drawGround(QPainter& painter, const QSize& size);
    void drawPaths(ScenePainter& scene);

    RobotModel model_;
    JointPositions q_;
    JointPositions drawnAt_;  ///< joint positions of the arm in the last image
    Pose tcpOffset_;
    std::optional<Ghost> ghost_;
    std::optional<Ghost> secondGhost_;
    std::optional<ReplayMark> replay_;
    collision::CellSurroundings cell_;
    std::optional<collision::CollisionCheck> check_;  ///< empty: create again before the next check
    std::optional<collision::MoveReport> report_;
    QString limitText_;
    QTimer examineTimer_;  ///< limits the rate of checks while the arm moves
    QString ghostText_;
    std::vector<WaypointMark> waypoints_;
    std::vector<FrameMark> frames_;
    std::optional<SceneJog> jog_;
    std::vector<PathMark> paths_;
    SceneTrace trace_;
    std::unique_ptr<SceneBodies> bodies_;
    QImage ground_;
    Camera::Eye groundSeenFrom_;  ///< camera position for which ground_ was drawn
    std::optional<ColorScheme> groundScheme_;
    bool haveJoints_ = false;
    bool stale_ = true;
    QString staleWord_;
    double speedFraction_ = 1.0;
    Camera camera_;
    SceneKeys* keys_;
    bool keptInSight_ = true;            ///< true until the user moves the view or zooms
    bool fitWanted_ = true;              ///< true if the view must be fitted again
    double coveredBelow_ = 0;            ///< [px]
    std::optional<Camera> beforeGhost_;  ///< the view to restore when the ghost disappears
    std::vector<PlacedLabel> labels_;
    int hiddenLabels_ = 0;
    QPointF dragFrom_;
    enum class Drag { None, Orbit, Pan };
    Drag drag_ = Drag::None;
    Qt::MouseButton dragButton_ = Qt::NoButton;
    bool focusByKey_ = false;  // true if a key set the focus; only then, the focus ring is drawn
    QTimer frameTimer_;
    std::int64_t lastPaintNs_ = 0;
};

}  // namespace tiller
