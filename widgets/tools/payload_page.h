// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The payloads of the project, one of which is active. A payload is entered, selected from presets, or
// measured with the arm. The page compares the payload configured in the robot with the active payload and
// with the measured forces.

#include <array>
#include <optional>

#include "robot/project/tooling.h"
#include "widgets/tools/part_page.h"
#include "widgets/tools/payload_estimator.h"

class QLabel;

namespace tiller {

class DecimalSpinBox;
class ProjectDocument;

class PayloadPage : public PartPage {
    Q_OBJECT

public:
    /// session, document, policy  must outlive the object
    PayloadPage(RobotSession& session, ProjectDocument& document, MotionPort port, HoldPolicy& policy,
                QWidget* parent = nullptr);

    void setState(const SessionState& state);
    /// Selects the changed payload, and asks the user if the robot has a different payload. Call this after
    /// undo or redo.
    void followStep(const QUuid& id);
    void setHeldSpeed(std::function<HeldSpeed()> speed) { estimator_->setHeldSpeed(std::move(speed)); }
    /// Measures for one second and shows whether the configured payload matches the measured forces.
    void checkTruth();

    /// Tolerances [kg, m]. Larger differences between robot and project are reported.
    static constexpr double kSameMass = 0.005;
    static constexpr double kSameCentre = 0.0005;
    /// Maximum residual force and torque at standstill if the payload is correct [N, Nm].
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
    void storeValue(int figure);
    void refresh();
    void updateValueTexts(const project::Payload& payload);
    void compare();
    void followCheck();
    bool isOnRobot(const project::Payload& payload) const;

    RobotSession& session_;
    ProjectDocument& document_;
    SessionState state_;
    QLabel* facts_;
    std::array<DecimalSpinBox*, 4> boxes_{};  ///< mass and centre of gravity
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
