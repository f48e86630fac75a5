// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Named joint positions, one of which is Home, and the safe height for moves.

#include <array>

#include "robot/project/named_position.h"
#include "widgets/tools/part_page.h"

class QCheckBox;
class QLabel;

namespace tiller {

class DecimalSpinBox;
class ProjectDocument;

class PositionsPage : public PartPage {
    Q_OBJECT

public:
    /// document  must outlive the object
    PositionsPage(RobotSession& session, ProjectDocument& document, QWidget* parent = nullptr);

    void setState(const SessionState& state);
    /// Stores the current position as Home and replaces an existing Home position.
    void setHomeHere();

protected:
    void onSelection() override;

private:
    const project::NamedPosition* current() const;
    /// True if the current position cannot be stored now; the page then shows the reason.
    bool isRefused();
    /// Replaces the joint positions of the entry by those of the arm.
    void storeIn(const QUuid& id, const QString& text);
    QString changeText(const QUuid& id) const;
    void addHere();
    void touchUp();
    void useAsHome();
    void remove();
    void insert(project::NamedPosition position, bool asHome, const QString& text);
    void change(const project::NamedPosition& position, const QString& text);
    void takeJoint(int joint);
    void takeHeight();
    void setHeight(const std::optional<project::SafeHeight>& height);
    void refresh();

    ProjectDocument& document_;
    SessionState state_;
    QLabel* facts_;
    std::array<DecimalSpinBox*, 6> joints_{};
    std::array<double, 6> shown_{};
    std::optional<project::NamedPosition> shownPosition_;
    QCheckBox* hasHeight_;
    DecimalSpinBox* height_;
    double shownHeight_ = 0;
};

}  // namespace tiller
