// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/waypoints/actions_dialog.h"

#include <QAbstractItemView>
#include <QDialogButtonBox>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>
#include <utility>

#include "robot/station/route/action_words.h"
#include "widgets/common/choice_box.h"
#include "widgets/common/decimal_spin_box.h"

namespace tiller {
namespace {

using project::IoGroup;
using Action = project::WaypointAction;

QLabel* labelFor(const QString& text, QWidget* field) {
    auto* label = new QLabel(text);
    label->setBuddy(field);
    return label;
}

}  // namespace

ActionsDialog::ActionsDialog(const std::vector<project::Waypoint>& waypoints, QWidget* parent)
    : QDialog(parent)
    , actions_(waypoints.front().actions)
    , list_(new QListWidget)
    , kind_(new ChoiceBox)
    , pin_(new ChoiceBox)
    , value_(new ChoiceBox)
    , seconds_(new DecimalSpinBox) {
    setObjectName(QStringLiteral("waypoint.actions"));
    const auto count = static_cast<int>(waypoints.size());
    setWindowTitle(count == 1 ? tr("Actions at “%1”").arg(waypoints.front().name)
                              : tr("Actions at %n waypoints", nullptr, count));
    auto* what = new QLabel(
        tr("“Run route (hold)” runs these actions in order at the waypoint while the button is held."));
    what->setProperty("role", "secondary");
    what->setWordWrap(true);
    const bool differ =
        std::any_of(waypoints.begin(), waypoints.end(),
                    [this](const project::Waypoint& point) { return point.actions != actions_; });
    auto* warning = new QLabel(
        tr("These waypoints have different actions. “Apply” replaces them all with the actions below."));
    warning->setObjectName(QStringLiteral("waypoint.actions.differ"));
    warning->setProperty("role", "warning");
    warning->setWordWrap(true);
    warning->setVisible(differ);

    list_->setObjectName(QStringLiteral("waypoint.actions.list"));
    list_->setAccessibleName(tr("Actions in order"));
    list_->setMinimumHeight(120);
    auto* upper = new QHBoxLayout;
    upper->addWidget(list_, 1);
    upper->addWidget(buildKeys());

    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel);
    buttons->button(QDialogButtonBox::Ok)->setText(tr("Apply"));
    buttons->button(QDialogButtonBox::Ok)->setObjectName(QStringLiteral("waypoint.actions.accept"));
    connect(buttons, &QDialogButtonBox::accepted, this, &ActionsDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    auto* layout = new QVBoxLayout(this);
    layout->addWidget(what);
    layout->addWidget(warning);
    layout->addLayout(upper, 1);
    layout->addWidget(buildFields());
    layout->addWidget(buttons);
    setMinimumWidth(440);
    connect(list_, &QListWidget::currentRowChanged, this, &ActionsDialog::refresh);
    show(0);
}

QPushButton* ActionsDialog::addKey(const char* name, const QString& text, const QString& toolTip,
                                   const std::function<void()>& pressed) {
    auto* key = new QPushButton(text);
    key->setObjectName(QStringLiteral("waypoint.actions.") + QLatin1String(name));
    key->setAccessibleName(toolTip);
    key->setToolTip(toolTip);
    key->setAutoDefault(true);  // Return activates the default button, because Space stops the robot
    connect(key, &QPushButton::clicked, this, pressed);
    return key;
}

QWidget* ActionsDialog::buildKeys() {
    auto* keys = new QWidget;
    auto* layout = new QVBoxLayout(keys);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(
        addKey("add", tr("Add"), tr("Add an action after the selected action"), [this] { add(); }));
    remove_ = addKey("remove", tr("Remove"), tr("Remove the selected action"), [this] { remove(); });
    up_ = addKey("up", tr("Up"), tr("Move the selected action up"), [this] { move(-1); });
    down_ = addKey("down", tr("Down"), tr("Move the selected action down"), [this] { move(1); });
    for (QPushButton* key : {remove_, up_, down_}) {
        layout->addWidget(key);
    }
    layout->addStretch(1);
    return keys;
}

QWidget* ActionsDialog::buildFields() {
    const auto name = [](QWidget* field, const char* path, const QString& text) {
        field->setObjectName(QStringLiteral("waypoint.actions.") + QLatin1String(path));
        field->setAccessibleName(text);
    };
    name(kind_, "kind", tr("Action"));
    name(pin_, "pin", tr("Terminal"));
    name(value_, "value", tr("State"));
    name(seconds_, "seconds", tr("Duration"));
    kind_->addItems(ActionWords::kinds());
    value_->addItems({tr("off"), tr("on")});
    for (ChoiceBox* box : {kind_, pin_, value_}) {
        box->view()->setAccessibleName(box->accessibleName());
        connect(box, &QComboBox::activated, this, &ActionsDialog::change);
    }
    seconds_->setDecimals(2);
    seconds_->setRange(0, project::kMaxActionTime);
    seconds_->setSuffix(QStringLiteral(" s"));
    connect(seconds_, &QDoubleSpinBox::valueChanged, this, &ActionsDialog::change);

    kindText_ = labelFor(tr("Action"), kind_);
    pinText_ = labelFor(tr("Terminal"), pin_);
    valueText_ = labelFor(tr("State"), value_);
    secondsText_ = labelFor(tr("Duration"), seconds_);
    auto* fields = new QWidget;
    auto* grid = new QGridLayout(fields);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setColumnStretch(1, 1);
    const std::pair<QLabel*, QWidget*> rows[] = {
        {kindText_, kind_}, {pinText_, pin_}, {valueText_, value_}, {secondsText_, seconds_}};
    for (const auto& [label, field] : rows) {
        const int row = grid->rowCount();
        grid->addWidget(label, row, 0);
        grid->addWidget(field, row, 1);
        // Hidden fields keep their space, so that every field has the same position for all action types.
        for (QWidget* part : {static_cast<QWidget*>(label), field}) {
            QSizePolicy policy = part->sizePolicy();
            policy.setRetainSizeWhenHidden(true);
            part->setSizePolicy(policy);
        }
    }
    return fields;
}

void ActionsDialog::add() {
    Action action;
    action.kind = Action::Kind::SetOutput;
    // The next action usually has the same type as the previous action.
    const int row = list_->currentRow();
    if (row >= 0) {
        action = actions_[static_cast<std::size_t>(row)];
        action.extra = {};
    }
    actions_.insert(actions_.begin() + (row + 1), action);
    show(row + 1);
    kind_->setFocus();
}

void ActionsDialog::remove() {
    const int row = list_->currentRow();
    if (row >= 0) {
        actions_.erase(actions_.begin() + row);
        show(std::min(row, static_cast<int>(actions_.size()) - 1));
    }
}

void ActionsDialog::move(int by) {
    const int row = list_->currentRow();
    const int to = row + by;
    if (row >= 0 && to >= 0 && to < static_cast<int>(actions_.size())) {
        std::swap(actions_[static_cast<std::size_t>(row)], actions_[static_cast<std::size_t>(to)]);
        show(to);
    }
}

void ActionsDialog::change() {
    const int row = list_->currentRow();
    if (filling_ || row < 0) {
        return;
    }
    Action& action = actions_[static_cast<std::size_t>(row)];
    const auto kind = static_cast<Action::Kind>(kind_->currentIndex());
    if (kind != action.kind) {
        action.kind = kind;
        action.seconds = kindOf(action).usualSeconds;
    } else {
        action.seconds = action.usesTime() ? seconds_->value() : 0;
    }
    if (action.usesPin() && pin_->currentIndex() >= 0) {
        const int channel = pin_->currentData().toInt();
        action.group = channel < project::channelOf(IoGroup::Configurable, 0) ? IoGroup::Standard
                       : channel < project::channelOf(IoGroup::Tool, 0)       ? IoGroup::Configurable
                                                                              : IoGroup::Tool;
        action.pin = channel - project::channelOf(action.group, 0);
        action.value = value_->currentIndex() == 1;
    }
    list_->item(row)->setText(ActionWords::of(action));
    refresh();
}

/// Lists the digital outputs or inputs, depending on the action type.
void ActionsDialog::listPins() {
    const int row = list_->currentRow();
    Action action = actions_[static_cast<std::size_t>(row)];
    const int chosen = project::channelOf(action.group, action.pin);
    pin_->clear();
    for (const IoGroup group : {IoGroup::Standard, IoGroup::Configurable, IoGroup::Tool}) {
        for (int pin = 0; pin < project::pinCount(group); ++pin) {
            action.group = group;
            action.pin = pin;
            pin_->addItem(ActionWords::terminal(action), project::channelOf(group, pin));
        }
    }
    pin_->setCurrentIndex(pin_->findData(chosen));
}

void ActionsDialog::show(int current) {
    {
        const QSignalBlocker quiet(list_);
        list_->clear();
        list_->addItems(ActionWords::of(actions_));
        list_->setCurrentRow(std::min(current, list_->count() - 1));
    }
    refresh();
}

void ActionsDialog::refresh() {
    const int row = list_->currentRow();
    const bool any = row >= 0;
    remove_->setEnabled(any);
    up_->setEnabled(row > 0);
    down_->setEnabled(any && row + 1 < list_->count());
    const Action action = any ? actions_[static_cast<std::size_t>(row)] : Action();
    filling_ = true;
    for (QWidget* part : {static_cast<QWidget*>(kind_), static_cast<QWidget*>(kindText_)}) {
        part->setVisible(any);
    }
    for (QWidget* part : {static_cast<QWidget*>(pin_), static_cast<QWidget*>(pinText_),
                          static_cast<QWidget*>(value_), static_cast<QWidget*>(valueText_)}) {
        part->setVisible(any && action.usesPin());
    }
    for (QWidget* part : {static_cast<QWidget*>(seconds_), static_cast<QWidget*>(secondsText_)}) {
        part->setVisible(any && action.usesTime());
    }
    const bool isLimit = kindOf(action).time == project::WaypointActionKind::Time::Limit;
    secondsText_->setText(isLimit ? tr("Timeout") : tr("Duration"));
    seconds_->setToolTip(isLimit ? tr("After this time, the action fails with a message. With 0, the action "
                                      "waits while the button is held, up to one hour.")
                                 : QString());
    if (any) {
        kind_->setCurrentIndex(static_cast<int>(action.kind));
        listPins();
        value_->setCurrentIndex(action.value ? 1 : 0);
        seconds_->setValue(action.seconds);
    }
    filling_ = false;
}

void ActionsDialog::accept() {
    if (seconds_->isVisible() && seconds_->isRefused()) {
        seconds_->setFocus();
        seconds_->explainRefusal();
        return;
    }
    QDialog::accept();
}

}  // namespace tiller

#include "moc_actions_dialog.cpp"
