// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The payloads of the project: in figures, from presets, or weighed with the arm; one of them in use. What the robot was
// told is compared with it, and with what the arm feels.

#include <array>
#include <optional>

#include "robot/project/tooling.h"
#include "widgets/tools/part_page.h"
#include "widgets/tools/payload_estimator.h"

class QLabel;

namespace tiller {

class FigureBox;
class ProjectDocument;

class PayloadPage : public PartPage {
    Q_OBJECT

public:
    /// document  must outlive it
    PayloadPage(RobotSession& session, ProjectDocument& document, MotionPort port, QWidget* parent = nullptr);

    void setState(const SessionState& state);
    /// After undo or redo: selects what changed, and asks when the robot has another one than the project.
    void followStep(const QUuid& id);
    void setHeldSpeed(std::function<HeldSpeed()> speed) { estimator_->setHeldSpeed(std::move(speed)); }
    /// Weighs for a second and says whether the payload the robot was told of explains what the arm feels.
    void checkTruth();

    /// Larger differences are told [kg, m].
    static constexpr double kSameMass = 0.005;
    static constexpr double kSameCentre = 0.0005;
    /// What a true payload may leave of the forces at rest [N, Nm].
    static constexpr double kTrueForce = 3.0;
    static constexpr double kTrueTorque = 0.5;

protected:
    void onSelection() override;

private:
    const project::Payload* current() const;
    void addFromRobot();
    void use();
    void remove();
    void insert(project::Payload payload);
    void change(const project::Payload& payload, const QString& text);
    void takeFigure(int figure);
    void refresh();
    void showFigures(const project::Payload& payload);
    void compare();
    void followCheck();
    bool isOnRobot(const project::Payload& payload) const;

    RobotSession& session_;
    ProjectDocument& document_;
    SessionState state_;
    QLabel* facts_;
    std::array<FigureBox*, 4> boxes_{};  ///< mass, then the centre
    std::array<double, 4> shown_{};
    std::optional<project::Payload> shownPayload_;
    double shownUnit_ = 0;
    PayloadEstimator* estimator_;
    StandstillMean mean_;
    bool checking_ = false;
    std::optional<project::Payload> asked_;
    double askedMass_ = 0;
    Eigen::Vector3d askedCentre_ = Eigen::Vector3d::Zero();
};

}  // namespace tiller
