// SPDX-License-Identifier: MIT
#pragma once

// Project edits as objects that can be applied and reverted: four for the waypoint list, and one for any
// other part. ProjectDocument creates them; an undo history stores them.

#include <QString>
#include <QVector>
#include <type_traits>
#include <vector>

#include "robot/station/document/project_document.h"

namespace tiller {

/// One edit, with the content before and after it. apply() requires the document state before the edit,
/// revert() the state after it.
class ProjectEdit {
public:
    explicit ProjectEdit(const QString& text) : text_(text) {}
    virtual ~ProjectEdit() = default;
    /// Text for the undo history, e.g. "Delete “home”".
    const QString& text() const { return text_; }
    virtual void apply(ProjectDocument& document) = 0;
    virtual void revert(ProjectDocument& document) = 0;
    /// The programs after apply() or, if `reverted`, after revert(); null if the edit does not change
    /// programs.
    virtual const project::ProgramList* programs(bool /*reverted*/) const { return nullptr; }

private:
    QString text_;
};

class InsertWaypoints : public ProjectEdit {
public:
    InsertWaypoints(int row, std::vector<project::Waypoint> waypoints, const QString& text);
    void apply(ProjectDocument& document) override;
    void revert(ProjectDocument& document) override;

private:
    int row_;
    std::vector<project::Waypoint> waypoints_;
};

class RemoveWaypoints : public ProjectEdit {
public:
    RemoveWaypoints(QVector<int> rows, const QString& text);
    void apply(ProjectDocument& document) override;
    void revert(ProjectDocument& document) override;

private:
    QVector<int> rows_;  // ascending
    std::vector<project::Waypoint> taken_;
};

class ChangeWaypoints : public ProjectEdit {
public:
    /// before, after  the same waypoints in the same order
    ChangeWaypoints(std::vector<project::Waypoint> before, std::vector<project::Waypoint> after,
                    const QString& text);
    void apply(ProjectDocument& document) override;
    void revert(ProjectDocument& document) override;

private:
    std::vector<project::Waypoint> before_;
    std::vector<project::Waypoint> after_;
};

class ReorderWaypoints : public ProjectEdit {
public:
    /// before, after  the IDs of all waypoints in list order
    ReorderWaypoints(QVector<QUuid> before, QVector<QUuid> after, const QString& text);
    void apply(ProjectDocument& document) override;
    void revert(ProjectDocument& document) override;

private:
    QVector<QUuid> before_;
    QVector<QUuid> after_;
};

/// All parts except the waypoints are small, so the edit stores the whole part.
template <class Part>
class EditPart : public ProjectEdit {
public:
    EditPart(Part project::Project::*part, Part before, Part after, const QString& text)
        : ProjectEdit(text), part_(part), before_(std::move(before)), after_(std::move(after)) {}
    void apply(ProjectDocument& document) override { document.setPartRaw(part_, after_); }
    void revert(ProjectDocument& document) override { document.setPartRaw(part_, before_); }
    const project::ProgramList* programs(bool reverted) const override {
        if constexpr (std::is_same_v<Part, project::ProgramList>) {
            return reverted ? &before_ : &after_;
        } else {
            return ProjectEdit::programs(reverted);
        }
    }

private:
    Part project::Project::*part_;
    Part before_;
    Part after_;
};

}  // namespace tiller
