// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/tools/tcp_page.h"

#include <QAction>
#include <QLabel>
#include <QMenu>
#include <QPushButton>
#include <QVBoxLayout>

#include "robot/project/waypoint_list.h"
#include "robot/station/document/project_document.h"
#include "robot/station/text/notation.h"
#include "widgets/common/notice_bar.h"
#include "widgets/common/pose_editor.h"
#include "widgets/common/row_table.h"
#include "widgets/tools/tcp_teacher.h"

namespace tiller {
namespace {

/// Cause of the notice that the TCPs of robot and project differ.
constexpr char kTcpDifference[] = "robot.tcp";

PartModel* tcpModel(ProjectDocument& document) {
    const auto at = [&document](int row) -> const project::Tool& {
        return document.tooling().tools.at(static_cast<std::size_t>(row));
    };
    PartModel::Content content;
    content.valueHeadings = [] {
        return QStringList{QStringLiteral("X %1").arg(format::lengthUnit()),
                           QStringLiteral("Y %1").arg(format::lengthUnit()),
                           QStringLiteral("Z %1").arg(format::lengthUnit())};
    };
    content.count = [&document] { return static_cast<int>(document.tooling().tools.size()); };
    content.isInUse = [&document, at](int row) { return at(row).id == document.tooling().activeTool; };
    content.inUse = TcpPage::tr("In use");
    content.name = [at](int row) { return at(row).name; };
    content.figures = [at](int row) {
        QStringList figures;
        for (int i = 0; i < 3; ++i) {
            figures << format::lengthNumber(at(row).tcpOffset[i], 2, false);
        }
        return figures;
    };
    content.nameProblem = [&document](int, const QString& name) {
        return name.isEmpty() ? TcpPage::tr("Enter a name for the TCP.")
               : document.tooling().tools.findByName(name) != nullptr
                   ? TcpPage::tr("A TCP named “%1” already exists. Choose a different name.").arg(name)
                   : QString();
    };
    content.rename = [&document, at](int row, const QString& name) {
        project::Tooling after = document.tooling();
        project::Tool tool = at(row);
        const QString text = TcpPage::tr("Rename “%1” to “%2”").arg(tool.name, name);
        tool.name = name;
        after.tools.replace(static_cast<std::size_t>(row), tool);
        document.changeTooling(after, text);
    };
    return new PartModel(content);
}

}  // namespace

TcpPage::TcpPage(RobotSession& session, ProjectDocument& document, QWidget* parent)
    : PartPage(QStringLiteral("tcp"), tr("TCPs"), tcpModel(document),
               tr("No TCPs yet.\nPress “From robot” to store the active TCP, or “Teach…” to teach a TCP with "
                  "the arm."),
               new QWidget, parent)
    , session_(session)
    , document_(document)
    , state_(session.state())
    , pose_(new PoseEditor(QStringLiteral("tcp.details"), tr("TCP"),
                           tr("Relative to the flange. Press Return to apply the value to the project. The "
                              "robot's TCP does not change.")))
    , facts_(new QLabel)
    , teacher_(new TcpTeacher(this)) {
    teacher_->hide();
    facts_->setObjectName(QStringLiteral("tcp.facts"));
    facts_->setWordWrap(true);
    auto* layout = new QVBoxLayout(&details());
    layout->setContentsMargins(12, 8, 12, 12);
    layout->setSpacing(6);
    layout->addWidget(facts_);
    layout->addWidget(pose_);

    addKey(QStringLiteral("use"), tr("Set on robot"), tr("Use this TCP and set it on the robot"), 3, [this] {
        use();
    })->setProperty("primary", true);
    addKey(QStringLiteral("teach"), tr("Teach…"), tr("Teach a TCP with the arm"), 2, [this] {
        teachingInto_ = {};
        teach();
    });
    addKey(QStringLiteral("fromRobot"), tr("From robot"), tr("Store the active TCP of the robot"), 2,
           [this] { addFromRobot(); });
    addCommand(QStringLiteral("use"), tr("Set TCP on robot"), true, [this] { use(); });
    addCommand(QStringLiteral("teachAgain"), tr("Teach the selected TCP again…"), true, [this] {
        teachingInto_ = current() != nullptr ? current()->id : QUuid();
        teach();
    });
    addCommand(QStringLiteral("new"), tr("Enter new TCP"), false, [this] {
        project::Tool tool;
        tool.name = document_.tooling().tools.nextName(tr("tool"));
        insert(tool);
        pose_->editFirst();
    });
    addCommand(QStringLiteral("rename"), tr("Rename TCP"), true, [this] { table().renameCurrent(); });
    addCommand(QStringLiteral("duplicate"), tr("Duplicate TCP"), true, [this] { duplicate(); });
    addCommand(QStringLiteral("delete"), tr("Delete TCP"), true, [this] { remove(); });

    connect(pose_, &PoseEditor::poseEntered, this, [this](const Pose& pose) {
        if (const project::Tool* tool = current()) {
            project::Tool after = *tool;
            after.tcpOffset = pose;
            change(after, tr("Change the TCP “%1”").arg(tool->name));
        }
    });
    connect(teacher_, &TcpTeacher::cancelled, this, [this] { showInstead(nullptr); });
    connect(teacher_, &TcpTeacher::made, this, [this](const Pose& tcp) {
        showInstead(nullptr);
        if (const project::Tool* tool = document_.tooling().tools.find(teachingInto_)) {
            project::Tool after = *tool;
            after.tcpOffset = tcp;
            change(after, tr("Teach the TCP “%1” again").arg(tool->name));
            return;
        }
        project::Tool tool;
        tool.name = document_.tooling().tools.nextName(tr("tool"));
        tool.tcpOffset = tcp;
        insert(tool);
    });
    connect(&document_, &ProjectDocument::documentChanged, &notice(), &NoticeBar::dismissQuestion);
    connect(&document_, &ProjectDocument::toolingChanged, this, [this] {
        followList();
        compare();
    });
    followList();
}

const project::Tool* TcpPage::current() const {
    return currentIn(document_.tooling().tools);
}

void TcpPage::insert(project::Tool tool) {
    tool.id = QUuid::createUuid();
    project::Tooling after = document_.tooling();
    after.tools.append(tool);
    document_.changeTooling(after, tr("Add the TCP “%1”").arg(tool.name));
    selectRow(document_.tooling().tools.indexOf(tool.id));
}

void TcpPage::change(const project::Tool& tool, const QString& text) {
    project::Tooling after = document_.tooling();
    after.tools.replace(static_cast<std::size_t>(after.tools.indexOf(tool.id)), tool);
    document_.changeTooling(after, text);
}

void TcpPage::addFromRobot() {
    if (!state_.hasData()) {
        showProblem(tr("No robot is connected. Connect a robot, or try the simulator."));
        return;
    }
    for (const project::Tool& tool : document_.tooling().tools) {
        if (tool.tcpOffset == state_.tcpOffset) {
            selectRow(document_.tooling().tools.indexOf(tool.id));
            showProblem(tr("The active TCP of the robot is already stored as “%1”.").arg(tool.name));
            return;
        }
    }
    project::Tool tool;
    tool.name = document_.tooling().tools.nextName(tr("tool"));
    tool.tcpOffset = state_.tcpOffset;
    insert(tool);
}

void TcpPage::teach() {
    const project::Tool* into = document_.tooling().tools.find(teachingInto_);
    teacher_->begin(into != nullptr ? tr("Teach “%1” again").arg(into->name) : tr("Teach a new TCP"),
                    into != nullptr ? into->tcpOffset.rotation : state_.tcpOffset.rotation);
    notice().dismiss();
    showInstead(teacher_);
}

void TcpPage::use() {
    const project::Tool* tool = current();
    if (tool == nullptr) {
        showProblem(tr("Select the TCP to set."));
        return;
    }
    const project::Tool chosen = *tool;
    // Do not ask about the difference that this command removes.
    asked_ = chosen;
    askedAbout_ = state_.tcpOffset;
    project::Tooling after = document_.tooling();
    after.activeTool = chosen.id;
    document_.changeTooling(after, tr("Use the TCP “%1”").arg(chosen.name));
    notice().resolve(QLatin1String(kTcpDifference));
    notice().dismiss();
    if (!state_.canMove()) {
        showProblem(state_.controlReason.isEmpty() ? tr("Tiller is not in control. Take control first.")
                                                   : state_.controlReason);
        return;
    }
    session_.tooling().setTcp(chosen.tcpOffset, chosen.name);
}

void TcpPage::duplicate() {
    if (const project::Tool* tool = current()) {
        project::Tool copy = *tool;
        copy.name = document_.tooling().tools.uniqueName(copy.name);
        insert(copy);
    }
}

void TcpPage::remove() {
    const project::Tool* tool = current();
    if (tool == nullptr) {
        return;
    }
    const QString text = tr("Delete the TCP “%1”").arg(tool->name);
    project::Tooling after = document_.tooling();
    if (after.activeTool == tool->id) {
        after.activeTool = {};
    }
    after.tools.remove(static_cast<std::size_t>(currentRow()));
    document_.changeTooling(after, text);
}

void TcpPage::setState(const SessionState& state) {
    state_ = state;
    teacher_->setLive(state);
    refresh();
    compare();
}

void TcpPage::onSelection() {
    refresh();
}

void TcpPage::refresh() {
    const project::Tool* tool = current();
    findChild<QPushButton*>(QStringLiteral("tcp.use"))->setEnabled(tool != nullptr);
    pose_->setVisible(tool != nullptr);
    if (tool == nullptr) {
        facts_->clear();
        return;
    }
    pose_->setPose(tool->tcpOffset);
    if (!state_.hasData()) {
        facts_->setText(tr("%1, relative to the flange").arg(tool->name));
        return;
    }
    const project::PoseDifference by = project::poseDifference(tool->tcpOffset, state_.tcpOffset);
    facts_->setText(
        by.distance <= kSameDistance && by.angle <= kSameAngle
            ? tr("%1, active on the robot").arg(tool->name)
            : tr("%1, %2 from the robot's TCP").arg(tool->name, format::difference(by.distance, by.angle)));
}

void TcpPage::followStep(const QUuid& id) {
    if (const int row = document_.tooling().tools.indexOf(id); row >= 0) {
        selectRow(row);
    }
    asked_.reset();
    compare();
}

void TcpPage::compare() {
    const project::Tool* used = document_.tooling().tools.find(document_.tooling().activeTool);
    if (used == nullptr || !state_.hasData()) {
        asked_.reset();
        notice().resolve(QLatin1String(kTcpDifference));
        return;
    }
    if (state_.moving) {
        return;
    }
    const project::PoseDifference by = project::poseDifference(used->tcpOffset, state_.tcpOffset);
    if (by.distance <= kSameDistance && by.angle <= kSameAngle) {
        asked_.reset();
        notice().resolve(QLatin1String(kTcpDifference));
        return;
    }
    if (asked_ == *used && askedAbout_ == state_.tcpOffset) {
        return;
    }
    asked_ = *used;
    askedAbout_ = state_.tcpOffset;
    const QString title = tr("The robot's TCP differs from “%1”").arg(used->name);
    const QString text =
        tr("On the robot: %1. In the project: %2. Difference: %3. Nothing was changed.")
            .arg(format::position(state_.tcpOffset.position), format::position(used->tcpOffset.position),
                 format::difference(by.distance, by.angle));
    session_.journal().add(Severity::Warning, title + QStringLiteral(": ") + text);
    notice().show(NoticeBar::Kind::Question, {.title = title,
                                              .text = text,
                                              .accept = tr("Set “%1” on the robot").arg(used->name),
                                              .accepted =
                                                  [this, id = used->id] {
                                                      selectRow(document_.tooling().tools.indexOf(id));
                                                      use();
                                                  },
                                              .cause = QLatin1String(kTcpDifference)});
}

}  // namespace tiller

#include "moc_tcp_page.cpp"
