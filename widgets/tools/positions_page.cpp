// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/tools/positions_page.h"

#include <QAction>
#include <QCheckBox>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QMenu>
#include <QPushButton>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include "robot/core/angles.h"
#include "robot/core/robot_model.h"
#include "robot/station/document/project_document.h"
#include "robot/station/link/obstacles.h"
#include "robot/station/text/format.h"
#include "robot/station/text/joint_name.h"
#include "robot/station/text/notation.h"
#include "widgets/common/decimal_spin_box.h"
#include "widgets/common/notice_bar.h"
#include "widgets/common/row_table.h"

namespace tiller {
namespace {

PartModel* positionModel(ProjectDocument& document) {
    const auto at = [&document](int row) -> const project::NamedPosition& {
        return document.positions().list.at(static_cast<std::size_t>(row));
    };
    PartModel::Content content;
    content.valueHeadings = [] { return QStringList{PositionsPage::tr("Joints °")}; };
    content.count = [&document] { return static_cast<int>(document.positions().list.size()); };
    content.isInUse = [&document, at](int row) { return at(row).id == document.positions().home; };
    content.inUse = PositionsPage::tr("Home");
    content.name = [at](int row) { return at(row).name; };
    content.figures = [at](int row) {
        QStringList joints;
        for (const double q : at(row).joints) {
            joints << format::number(toDegrees(q), 0);
        }
        return QStringList{joints.join(QStringLiteral("  "))};
    };
    content.nameProblem = [&document](int, const QString& name) {
        return name.isEmpty() ? PositionsPage::tr("Enter a name for the position.")
               : document.positions().list.findByName(name) != nullptr
                   ? PositionsPage::tr("A position named “%1” already exists. Choose a different name.")
                         .arg(name)
                   : QString();
    };
    content.rename = [&document, at](int row, const QString& name) {
        project::Positions after = document.positions();
        project::NamedPosition position = at(row);
        const QString text = PositionsPage::tr("Rename “%1” to “%2”").arg(position.name, name);
        position.name = name;
        after.list.replace(static_cast<std::size_t>(row), position);
        document.changePositions(after, text);
    };
    return new PartModel(content);
}

}  // namespace

PositionsPage::PositionsPage(RobotSession& session, ProjectDocument& document, QWidget* parent)
    : PartPage(
          QStringLiteral("position"), tr("Positions"), positionModel(document),
          tr("No positions yet.\nJog the arm to a position and press “Set home here” or “Add position”."),
          new QWidget, parent)
    , document_(document)
    , state_(session.state())
    , facts_(new QLabel)
    , hasHeight_(new QCheckBox(tr("Safe height")))
    , height_(new DecimalSpinBox) {
    facts_->setObjectName(QStringLiteral("position.facts"));
    facts_->setWordWrap(true);
    auto* grid = new QGridLayout;
    grid->setHorizontalSpacing(6);
    grid->setVerticalSpacing(6);
    for (int i = 0; i < kJointCount; ++i) {
        auto* box = new DecimalSpinBox;
        box->setObjectName(QStringLiteral("position.details.%1").arg(i));
        box->setAccessibleName(jointName(i));
        box->setToolTip(tr("%1. Press Return to apply the values. Only the stored position changes; the "
                           "robot does not move.")
                            .arg(jointName(i)));
        box->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
        box->setProperty("dense", true);
        box->setMinimumWidth(80);
        box->setSuffix(QStringLiteral("°"));
        const double most = toDegrees(kJointPositionLimit);
        box->setRange(-most, most);
        grid->addWidget(box, i / 3, i % 3);
        joints_[static_cast<std::size_t>(i)] = box;
        connect(box, &QAbstractSpinBox::editingFinished, this, [this, i] { takeJoint(i); });
    }
    hasHeight_->setObjectName(QStringLiteral("position.hasHeight"));
    hasHeight_->setToolTip(
        tr("Height in the base frame. Above this height, the cell is free of obstacles, and the TCP may move "
           "sideways."));
    height_->setObjectName(QStringLiteral("position.height"));
    height_->setAccessibleName(tr("Safe height"));
    auto* heightHere = new QPushButton(tr("At TCP"));
    heightHere->setObjectName(QStringLiteral("position.heightHere"));
    heightHere->setAccessibleName(tr("Set the safe height to the current TCP height"));
    auto* heightRow = new QHBoxLayout;
    heightRow->addWidget(hasHeight_);
    heightRow->addWidget(height_, 1);
    heightRow->addWidget(heightHere);
    auto* layout = new QVBoxLayout(&details());
    layout->setContentsMargins(12, 8, 12, 12);
    layout->setSpacing(6);
    layout->addWidget(facts_);
    layout->addLayout(grid);
    layout->addLayout(heightRow);

    addKey(QStringLiteral("setHome"), tr("Set home here"), tr("Set home here"), 3, [this] {
        setHomeHere();
    })->setProperty("primary", true);
    addKey(QStringLiteral("add"), tr("Add position"), tr("Store the current position of the arm"), 2,
           [this] { addHere(); });
    addKey(QStringLiteral("useAsHome"), tr("Use as home"), tr("Use the selected position as home"), 2,
           [this] { useAsHome(); });
    addCommand(QStringLiteral("setHome"), tr("Set home here"), false, [this] { setHomeHere(); });
    addCommand(QStringLiteral("touchUp"), tr("Touch up position"), true, [this] { touchUp(); });
    addCommand(QStringLiteral("noHome"), tr("Reset to default home"), false, [this] {
        project::Positions after = document_.positions();
        after.home = {};
        document_.changePositions(after, tr("Reset to default home"));
    });
    addCommand(QStringLiteral("rename"), tr("Rename position"), true, [this] { table().renameCurrent(); });
    addCommand(QStringLiteral("delete"), tr("Delete position"), true, [this] { remove(); });

    connect(hasHeight_, &QCheckBox::clicked, this, [this](bool on) {
        setHeight(on ? std::optional(project::SafeHeight{{}, shownHeight_}) : std::nullopt);
    });
    connect(height_, &QAbstractSpinBox::editingFinished, this, &PositionsPage::takeHeight);
    connect(heightHere, &QPushButton::clicked, this, [this] {
        if (!isRefused()) {
            setHeight(project::SafeHeight{{}, state_.tcpPose.position.z()});
        }
    });
    connect(&document_, &ProjectDocument::documentChanged, &notice(), &NoticeBar::dismissQuestion);
    connect(&document_, &ProjectDocument::positionsChanged, this, [this] { followList(); });
    keepDetails();
    followList();
}

const project::NamedPosition* PositionsPage::current() const {
    return currentIn(document_.positions().list);
}

void PositionsPage::insert(project::NamedPosition position, bool asHome, const QString& text) {
    position.id = QUuid::createUuid();
    project::Positions after = document_.positions();
    after.list.append(position);
    if (asHome) {
        after.home = position.id;
    }
    document_.changePositions(after, text);
    selectRow(document_.positions().list.indexOf(position.id));
}

void PositionsPage::change(const project::NamedPosition& position, const QString& text) {
    project::Positions after = document_.positions();
    after.list.replace(static_cast<std::size_t>(after.list.indexOf(position.id)), position);
    document_.changePositions(after, text);
}

bool PositionsPage::isRefused() {
    const QString why = storeObstacle(state_);
    if (!why.isEmpty()) {
        showProblem(why);
    }
    return !why.isEmpty();
}

void PositionsPage::storeIn(const QUuid& id, const QString& text) {
    const project::NamedPosition* now = document_.positions().list.find(id);
    if (now == nullptr || isRefused()) {
        return;
    }
    project::NamedPosition after = *now;
    after.joints = state_.q;
    change(after, text);
}

QString PositionsPage::changeText(const QUuid& id) const {
    const project::NamedPosition* position = document_.positions().list.find(id);
    if (position == nullptr) {
        return {};
    }
    const Vector6 turns = state_.q.values - position->joints.values;
    int joint = 0;
    turns.cwiseAbs().maxCoeff(&joint);
    return tr("Largest joint change: %1 %2.").arg(jointName(joint), format::degrees(turns[joint], 1));
}

void PositionsPage::setHomeHere() {
    if (isRefused()) {
        return;
    }
    if (const project::NamedPosition* home = document_.positions().homePosition()) {
        notice().show(NoticeBar::Kind::Question,
                      {.title = tr("Set “%1” to the current position of the arm?").arg(home->name),
                       .accept = tr("Set home"),
                       .accepted = [this, id = home->id] { storeIn(id, tr("Set home")); },
                       .liveText =
                           [this, id = home->id] {
                               return changeText(id) + QLatin1Char(' ') +
                                      tr("The Home button will then move the arm to this position.");
                           }});
        return;
    }
    project::NamedPosition position;
    position.name = document_.positions().list.uniqueName(tr("Home"));
    position.joints = state_.q;
    insert(position, true, tr("Set home"));
}

void PositionsPage::addHere() {
    if (isRefused()) {
        return;
    }
    project::NamedPosition position;
    position.name = document_.positions().list.nextName(tr("position"));
    position.joints = state_.q;
    insert(position, false, tr("Add the position “%1”").arg(position.name));
}

void PositionsPage::touchUp() {
    const project::NamedPosition* position = current();
    if (position == nullptr) {
        showProblem(tr("Select a position to touch up."));
        return;
    }
    if (isRefused()) {
        return;
    }
    const QString step = tr("Touch up “%1”").arg(position->name);
    notice().show(NoticeBar::Kind::Question,
                  {.title = tr("Touch up “%1”?").arg(position->name),
                   .accept = tr("Touch up"),
                   .accepted = [this, id = position->id, step] { storeIn(id, step); },
                   .liveText = [this, id = position->id] { return changeText(id); }});
}

void PositionsPage::useAsHome() {
    if (const project::NamedPosition* position = current()) {
        project::Positions after = document_.positions();
        after.home = position->id;
        document_.changePositions(after, tr("Use “%1” as home").arg(position->name));
    } else {
        showProblem(tr("Select a position to use as home."));
    }
}

void PositionsPage::remove() {
    const project::NamedPosition* position = current();
    if (position == nullptr) {
        return;
    }
    const QString text = tr("Delete “%1”").arg(position->name);
    project::Positions after = document_.positions();
    if (after.home == position->id) {
        after.home = {};
    }
    after.list.remove(static_cast<std::size_t>(currentRow()));
    document_.changePositions(after, text);
}

void PositionsPage::takeJoint(int joint) {
    const project::NamedPosition* position = current();
    const auto at = static_cast<std::size_t>(joint);
    if (position == nullptr || joints_[at]->isRefused() || joints_[at]->value() == shown_[at]) {
        return;
    }
    project::NamedPosition after = *position;
    after.joints[joint] = toRadians(joints_[at]->value());
    change(after, tr("Change “%1”").arg(position->name));
}

void PositionsPage::takeHeight() {
    if (!height_->isRefused() && height_->value() != shownHeight_ / format::metresPerUnit() &&
        hasHeight_->isChecked()) {
        setHeight(project::SafeHeight{{}, height_->value() * format::metresPerUnit()});
    }
}

void PositionsPage::setHeight(const std::optional<project::SafeHeight>& height) {
    project::Positions after = document_.positions();
    after.safeHeight = height;
    document_.changePositions(after, height ? tr("Set the safe height") : tr("Remove the safe height"));
}

void PositionsPage::setState(const SessionState& state) {
    state_ = state;
    notice().refresh();
    refresh();
}

void PositionsPage::onSelection() {
    refresh();
}

void PositionsPage::refresh() {
    const project::Positions& positions = document_.positions();
    const double perUnit = format::metresPerUnit();
    const std::optional<project::SafeHeight>& safe = positions.safeHeight;
    hasHeight_->setChecked(safe.has_value());
    height_->setEnabled(safe.has_value());
    if (const double most = 10 / perUnit; height_->maximum() != most) {
        height_->setRange(-most, most);
        height_->setSuffix(QStringLiteral(" ") + format::lengthUnit());
    }
    const double height = safe ? safe->height : shownHeight_;
    if (height != shownHeight_) {
        const QSignalBlocker quiet(height_);
        shownHeight_ = height;
        height_->setValue(height / perUnit);
    }
    const project::NamedPosition* position = current();
    findChild<QPushButton*>(QStringLiteral("position.useAsHome"))
        ->setEnabled(position != nullptr && position->id != positions.home);
    for (DecimalSpinBox* box : joints_) {
        box->setEnabled(position != nullptr);
    }
    if (position == nullptr) {
        shownPosition_.reset();
        facts_->setText(tr(
            "The Home button moves the arm to the default home position: upright, without self-collision."));
        return;
    }
    if (!(shownPosition_ == *position)) {
        shownPosition_ = *position;
        for (int i = 0; i < kJointCount; ++i) {
            const auto at = static_cast<std::size_t>(i);
            const QSignalBlocker quiet(joints_[at]);
            joints_[at]->setValue(toDegrees(position->joints[i]));
            shown_[at] = joints_[at]->value();
        }
    }
    const QString what = position->id == positions.home
                             ? tr("%1: target of the Home button").arg(position->name)
                             : position->name;
    if (!state_.hasData()) {
        facts_->setText(what);
        return;
    }
    const Vector6 turns = position->joints.values - state_.q.values;
    int joint = 0;
    turns.cwiseAbs().maxCoeff(&joint);
    facts_->setText(tr("%1 · %2 %3 from the current position")
                        .arg(what, jointName(joint), format::degrees(turns[joint], 1)));
}

}  // namespace tiller

#include "moc_positions_page.cpp"
