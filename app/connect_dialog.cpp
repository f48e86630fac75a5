// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/connect_dialog.h"

#include <QAction>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QHostAddress>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QRegularExpression>
#include <QStyle>
#include <QVBoxLayout>
#include <algorithm>
#include <utility>

#include "widgets/common/fit_to_contents.h"

namespace tiller::app {

QString hostProblem(const QString& host) {
    if (host.isEmpty()) {
        return ConnectDialog::tr("Enter the robot's address, as shown on the teach pendant under About.");
    }
    static const QRegularExpression fourNumbers(QStringLiteral("^[0-9.]+$"));
    if (fourNumbers.match(host).hasMatch() && (QHostAddress(host).isNull() || host.count('.') != 3)) {
        return ConnectDialog::tr("An IP address consists of four numbers from 0 to 255, e.g. 192.168.0.10.");
    }
    static const QRegularExpression name(QStringLiteral("^[A-Za-z0-9_.:-]+$"));
    if (!name.match(host).hasMatch()) {
        return ConnectDialog::tr("A host name contains only letters, digits, dots and hyphens.");
    }
    return {};
}

ConnectDialog::ConnectDialog(const QVector<RobotAddress>& remembered, QWidget* parent)
    : QDialog(parent)
    , remembered_(remembered)
    , host_(new QLineEdit)
    , name_(new QLineEdit)
    , list_(new QListWidget)
    , forget_(new QPushButton(tr("Forget")))
    , simulator_(new QPushButton(tr("Start the simulated robot")))
    , sample_(new QPushButton(tr("Open sample project…")))
    , connect_(new QPushButton(tr("Connect")))
    , hint_(new QLabel) {
    setObjectName("connectDialog");
    setWindowTitle(tr("Connect"));
    setMinimumWidth(600);

    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(24, 24, 24, 24);
    layout->setSpacing(16);
    // The robot part is first if there are remembered robots. Otherwise, the user is probably new, so the
    // simulator part is first.
    QWidget* const robot = robotPart();
    QWidget* const simulator = simulatorPart();
    layout->addWidget(remembered.isEmpty() ? simulator : robot);
    layout->addSpacing(12);
    layout->addWidget(remembered.isEmpty() ? robot : simulator);

    auto* safety = new QLabel(tr(
        "Before you move a real arm: keep everyone out of its reach, keep the emergency stop within reach, "
        "check the payload and the TCP, and start slowly. STOP in this window is not an emergency stop."));
    safety->setProperty("role", "secondary");
    safety->setWordWrap(true);
    layout->addWidget(safety);

    auto* buttons = new QHBoxLayout;
    auto* cancel = new QPushButton(tr("Cancel"));
    cancel->setObjectName("cancelConnect");
    auto* project = new QPushButton(tr("Open project…"));
    project->setObjectName("openProject");
    project->setToolTip(tr("Opens a project without a robot, to view and edit waypoints and programs."));
    for (QPushButton* button : {project, cancel, connect_, simulator_, sample_, forget_}) {
        button->setAutoDefault(false);  // moving the focus must not change the default button
    }
    buttons->addWidget(project);
    buttons->addStretch();
    buttons->addWidget(cancel);
    buttons->addWidget(connect_);
    layout->addLayout(buttons);

    connect(simulator_, &QPushButton::clicked, this, [this] { choose(Choice::Simulator); });
    connect(sample_, &QPushButton::clicked, this, [this] { choose(Choice::Sample); });
    connect(project, &QPushButton::clicked, this, [this] { choose(Choice::Project); });
    connect(connect_, &QPushButton::clicked, this, [this] { choose(Choice::Robot); });
    connect(cancel, &QPushButton::clicked, this, &QDialog::reject);
    connect(host_, &QLineEdit::textEdited, this, &ConnectDialog::followAddress);
    connect(host_, &QLineEdit::textChanged, this, &ConnectDialog::updateButtons);
    connect(name_, &QLineEdit::textEdited, this, [this] { nameTyped_ = true; });
    connect(name_, &QLineEdit::textChanged, this, &ConnectDialog::updateButtons);
    showRobot(0);
    updateButtons();
    host_->setFocus();
    host_->selectAll();
}

QWidget* ConnectDialog::simulatorPart() {
    auto* part = new QWidget;
    auto* layout = new QVBoxLayout(part);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(16);
    auto* title = new QLabel(tr("Try the simulator"));
    title->setProperty("role", "strong");
    auto* text =
        new QLabel(tr("A simulated UR5e that runs in Tiller. All functions are available without risk."));
    text->setProperty("role", "secondary");
    text->setWordWrap(true);
    simulator_->setObjectName("startSimulator");
    simulator_->setMinimumHeight(44);
    sample_->setObjectName("startSample");
    sample_->setMinimumHeight(44);
    sample_->setToolTip(tr("Starts the simulated robot and opens a project with taught waypoints."));
    layout->addWidget(title);
    layout->addWidget(text);
    auto* keys = new QHBoxLayout;
    keys->setSpacing(8);
    keys->addWidget(simulator_, 3);
    keys->addWidget(sample_, 2);
    layout->addLayout(keys);
    return part;
}

QWidget* ConnectDialog::robotPart() {
    auto* part = new QWidget;
    auto* layout = new QVBoxLayout(part);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(16);
    auto* title = new QLabel(tr("Connect to a robot"));
    title->setProperty("role", "strong");
    layout->addWidget(title);
    host_->setObjectName("robotHost");
    host_->setAccessibleName(tr("Address or host name of the robot"));
    host_->setPlaceholderText(QStringLiteral("192.168.0.10"));
    name_->setObjectName("robotName");
    name_->setAccessibleName(tr("Display name of the robot"));
    name_->setPlaceholderText(tr("Lab UR5e"));
    auto* form = new QFormLayout;
    form->addRow(tr("Address"), host_);
    form->addRow(tr("Name"), name_);
    layout->addLayout(form);

    list_->setObjectName("rememberedRobots");
    list_->setAccessibleName(tr("Recently connected robots"));
    list_->setMaximumHeight(104);
    for (const RobotAddress& robot : std::as_const(remembered_)) {
        list_->addItem(robot.name == robot.host ? robot.host
                                                : QStringLiteral("%1 · %2").arg(robot.name, robot.host));
    }
    forget_->setObjectName("forgetRobot");
    forget_->setToolTip(
        tr("Removes the selected robot from this list (Delete). The robot itself is not affected."));
    auto* forgetKey = new QAction(list_);
    forgetKey->setShortcut(QKeySequence::Delete);
    forgetKey->setShortcutContext(Qt::WidgetShortcut);
    list_->addAction(forgetKey);
    auto* row = new QHBoxLayout;
    row->addWidget(list_, 1);
    row->addWidget(forget_, 0, Qt::AlignTop);
    layout->addLayout(row);
    list_->setVisible(!remembered_.isEmpty());
    forget_->setVisible(!remembered_.isEmpty());
    connect(list_, &QListWidget::currentRowChanged, this, &ConnectDialog::showRobot);
    connect(list_, &QListWidget::itemActivated, this, [this] { connect_->click(); });
    connect(forgetKey, &QAction::triggered, this, &ConnectDialog::forgetRobot);
    connect(forget_, &QPushButton::clicked, this, &ConnectDialog::forgetRobot);

    hint_->setObjectName("connectHint");
    hint_->setProperty("role", "secondary");
    hint_->setWordWrap(true);
    layout->addWidget(hint_);
    connect_->setObjectName("connectRobot");
    return part;
}

void ConnectDialog::showEvent(QShowEvent* event) {
    QDialog::showEvent(event);
    fitToContents(*this);
}

void ConnectDialog::choose(Choice choice) {
    choice_ = choice;
    accept();
}

void ConnectDialog::showRobot(int row) {
    if (row < 0 || row >= remembered_.size()) {
        return;
    }
    host_->setText(remembered_[row].host);
    name_->setText(remembered_[row].name);
    nameTyped_ = false;
}

void ConnectDialog::forgetRobot() {
    const int row = list_->currentRow() >= 0 ? list_->currentRow() : 0;
    if (row >= remembered_.size()) {
        return;
    }
    Q_EMIT forgetRequested(remembered_.takeAt(row));
    delete list_->takeItem(row);
    list_->setVisible(!remembered_.isEmpty());
    forget_->setVisible(!remembered_.isEmpty());
    host_->clear();
    name_->clear();
    nameTyped_ = false;
    showRobot(std::max(0, list_->currentRow()));
}

void ConnectDialog::followAddress() {
    if (nameTyped_) {
        return;
    }
    const QString host = host_->text().trimmed();
    const auto known = std::find_if(remembered_.cbegin(), remembered_.cend(),
                                    [&host](const RobotAddress& robot) { return robot.host == host; });
    name_->setText(known == remembered_.cend() ? QString() : known->name);
}

void ConnectDialog::updateButtons() {
    const QString problem = hostProblem(host_->text().trimmed());
    const bool nothing = host_->text().isEmpty() && name_->text().isEmpty();
    connect_->setEnabled(problem.isEmpty());
    hint_->setText(problem);
    const auto makeDefault = [](QPushButton* key, bool is) {
        key->setDefault(is);
        if (key->property("primary").toBool() != is) {
            key->setProperty("primary", is);
            key->style()->unpolish(key);
            key->style()->polish(key);
        }
    };
    makeDefault(connect_, problem.isEmpty());
    makeDefault(simulator_, nothing);
    if (isVisible()) {
        fitToContents(*this);
    }
}

RobotAddress ConnectDialog::address() const {
    const QString host = host_->text().trimmed();
    const QString name = name_->text().trimmed();
    const auto known = std::find_if(remembered_.cbegin(), remembered_.cend(),
                                    [&host](const RobotAddress& robot) { return robot.host == host; });
    const int portOffset = known == remembered_.cend() ? 0 : known->portOffset;
    return {name.isEmpty() ? host : name, host, portOffset, false};
}

}  // namespace tiller::app

#include "moc_connect_dialog.cpp"
