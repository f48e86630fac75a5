// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/connect_dialog.h"

#include <QFormLayout>
#include <QHBoxLayout>
#include <QHostAddress>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QRegularExpression>
#include <QVBoxLayout>

#include "widgets/common/room.h"

namespace tiller::app {

QString hostProblem(const QString& host) {
    if (host.isEmpty()) {
        return ConnectDialog::tr("Enter the robot's address, as shown on the teach pendant under About.");
    }
    static const QRegularExpression fourNumbers(QStringLiteral("^[0-9.]+$"));
    if (fourNumbers.match(host).hasMatch() && (QHostAddress(host).isNull() || host.count('.') != 3)) {
        return ConnectDialog::tr("An address has four numbers of 0 to 255, as in 192.168.0.10.");
    }
    static const QRegularExpression name(QStringLiteral("^[A-Za-z0-9_.:-]+$"));
    if (!name.match(host).hasMatch()) {
        return ConnectDialog::tr("A host name has letters, digits, dots and hyphens only.");
    }
    return {};
}

ConnectDialog::ConnectDialog(const QVector<RobotAddress>& remembered, QWidget* parent) : QDialog(parent) {
    setObjectName("connectDialog");
    setWindowTitle(tr("Connect"));
    setMinimumWidth(520);

    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(24, 24, 24, 24);
    layout->setSpacing(16);

    auto* simulatorTitle = new QLabel(tr("Try the simulator"));
    simulatorTitle->setProperty("role", "strong");
    auto* simulatorText =
        new QLabel(tr("A simulated UR5e inside this program. Everything works, nothing can be hurt."));
    simulatorText->setProperty("role", "secondary");
    simulatorText->setWordWrap(true);
    auto* simulatorButton = new QPushButton(tr("Start the simulated robot"));
    simulatorButton->setObjectName("startSimulator");
    simulatorButton->setProperty("primary", true);
    simulatorButton->setDefault(true);
    simulatorButton->setMinimumHeight(44);
    layout->addWidget(simulatorTitle);
    layout->addWidget(simulatorText);
    layout->addWidget(simulatorButton);
    layout->addSpacing(12);

    auto* robotTitle = new QLabel(tr("Connect a robot"));
    robotTitle->setProperty("role", "strong");
    layout->addWidget(robotTitle);
    auto* form = new QFormLayout;
    host_ = new QLineEdit(remembered.isEmpty() ? QString() : remembered.first().host);
    host_->setObjectName("robotHost");
    host_->setAccessibleName(tr("Address or host name of the robot"));
    host_->setPlaceholderText(QStringLiteral("192.168.0.10"));
    name_ = new QLineEdit(remembered.isEmpty() ? QString() : remembered.first().name);
    portOffset_ = remembered.isEmpty() ? 0 : remembered.first().portOffset;
    name_->setObjectName("robotName");
    name_->setAccessibleName(tr("Name shown for the robot"));
    name_->setPlaceholderText(tr("Lab UR5e"));
    form->addRow(tr("Address"), host_);
    form->addRow(tr("Name"), name_);
    layout->addLayout(form);

    if (!remembered.isEmpty()) {
        auto* list = new QListWidget;
        list->setObjectName("rememberedRobots");
        list->setAccessibleName(tr("Robots connected to before"));
        for (const RobotAddress& robot : remembered) {
            list->addItem(robot.name == robot.host ? robot.host
                                                   : QStringLiteral("%1 · %2").arg(robot.name, robot.host));
        }
        list->setMaximumHeight(120);
        connect(list, &QListWidget::currentRowChanged, this, [this, remembered](int row) {
            if (row >= 0) {
                host_->setText(remembered[row].host);
                name_->setText(remembered[row].name);
                portOffset_ = remembered[row].portOffset;
            }
        });
        connect(list, &QListWidget::itemActivated, this, [this] { connect_->click(); });
        layout->addWidget(list);
    }

    hint_ = new QLabel;
    hint_->setObjectName("connectHint");
    hint_->setProperty("role", "secondary");
    hint_->setWordWrap(true);
    layout->addWidget(hint_);

    auto* safety = new QLabel(
        tr("Before you move a real arm: keep everybody out of its reach, have the emergency stop at "
           "hand, check payload and TCP, start slowly. The STOP of this window is not an emergency "
           "stop."));
    safety->setProperty("role", "secondary");
    safety->setWordWrap(true);
    layout->addWidget(safety);

    auto* buttons = new QHBoxLayout;
    auto* cancel = new QPushButton(tr("Cancel"));
    cancel->setObjectName("cancelConnect");
    connect_ = new QPushButton(tr("Connect"));
    connect_->setObjectName("connectRobot");
    connect_->setAutoDefault(false);
    auto* project = new QPushButton(tr("Open a project…"));
    project->setObjectName("openProject");
    project->setToolTip(tr("Waypoints from a file, without a robot: everything but moving works."));
    project->setAutoDefault(false);
    buttons->addWidget(project);
    buttons->addStretch();
    buttons->addWidget(cancel);
    buttons->addWidget(connect_);
    layout->addLayout(buttons);

    connect(simulatorButton, &QPushButton::clicked, this, [this] { choose(Choice::Simulator); });
    connect(project, &QPushButton::clicked, this, [this] { choose(Choice::Project); });
    connect(connect_, &QPushButton::clicked, this, [this] { choose(Choice::Robot); });
    connect(host_, &QLineEdit::textEdited, this, [this] { portOffset_ = 0; });
    connect(cancel, &QPushButton::clicked, this, &QDialog::reject);
    connect(host_, &QLineEdit::textChanged, this, &ConnectDialog::updateButtons);
    connect(host_, &QLineEdit::returnPressed, connect_, &QPushButton::click);
    updateButtons();
}

void ConnectDialog::showEvent(QShowEvent* event) {
    QDialog::showEvent(event);
    makeRoom(*this);
}

void ConnectDialog::choose(Choice choice) {
    choice_ = choice;
    accept();
}

void ConnectDialog::updateButtons() {
    const QString problem = hostProblem(host_->text().trimmed());
    connect_->setEnabled(problem.isEmpty());
    hint_->setText(problem);
    if (isVisible()) {
        makeRoom(*this);
    }
}

RobotAddress ConnectDialog::address() const {
    const QString host = host_->text().trimmed();
    const QString name = name_->text().trimmed();
    return {name.isEmpty() ? host : name, host, portOffset_, false};
}

}  // namespace tiller::app
