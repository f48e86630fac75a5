// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/io/gripper_panel.h"
#include "robot/station/text/texts.h"

#include <QEvent>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QStyle>
#include <QVBoxLayout>
#include <cmath>

#include "robot/station/text/format.h"
#include "robot/station/text/notation.h"
#include "widgets/common/choice_box.h"
#include "widgets/common/decimal_spin_box.h"
#include "widgets/common/enter_key.h"
#include "widgets/common/no_focus_scroll_area.h"
#include "widgets/common/theme.h"

namespace tiller {
namespace {

using io::RobotiqActivation;
using io::RobotiqObject;

constexpr int kGripperRefreshMs = 50;
/// Delay [ms] after which a newly shown button is enabled, so that a double click on the gripper list cannot
/// press it.
constexpr int kSettleMs = 500;
constexpr int kMaxTcpPort = 65535;
/// Initial speed and force [%]. They are low, and they are not saved.
constexpr double kFirstSpeed = 50;
constexpr double kFirstForce = 20;
constexpr int kRemedyLines = 4;

QPushButton* key(const QString& text, const QString& name, const QString& accessible) {
    auto* button = new EnterKey(text);
    button->setObjectName(name);
    button->setAccessibleName(accessible);
    button->setStyleSheet(QStringLiteral("padding: 0 10px;"));
    return button;
}

QLabel* valueLabel(const QString& name, const QString& accessible) {
    auto* label = new QLabel(QStringLiteral("–"));
    label->setObjectName(name);
    label->setAccessibleName(accessible);
    label->setFont(textFont(15));
    // Fixed size policy, so that a changed text does not move the surrounding rows.
    label->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
    return label;
}

/// Returns false if the text in the box is valid; otherwise shows the error and returns true.
bool isRefused(DecimalSpinBox* box) {
    if (box->isRefused()) {
        box->explainRefusal();
        return true;
    }
    box->interpretText();
    return false;
}

void setText(QLabel* label, const QString& text) {
    if (label->text() != text) {
        label->setText(text);
        label->setToolTip(text);
        label->setAccessibleDescription(text);
    }
}

void setObstacle(QAbstractButton* button, const QString& why, const QString& tip) {
    const QString text = why.isEmpty() ? tip : why;
    if (button->toolTip() != text) {
        button->setToolTip(text);
        button->setAccessibleDescription(text);
    }
    if (button->isEnabled() != why.isEmpty()) {
        button->setEnabled(why.isEmpty());
    }
}

int byteOf(double percent) {
    return static_cast<int>(std::lround(percent / 100.0 * io::kRobotiqMost));
}

/// Text of the choice without its outputs, as in the list of grippers.
QString kindOf(const GripperChoice& choice) {
    using Kind = GripperChoice::Kind;
    return choice.kind == Kind::None         ? QStringLiteral("none")
           : choice.kind == Kind::OneOutput  ? QStringLiteral("output")
           : choice.kind == Kind::TwoOutputs ? QStringLiteral("outputs")
                                             : choice.toText();
}

}  // namespace

GripperPanel::GripperPanel(RobotSession& session, QWidget* parent)
    : QWidget(parent)
    , session_(session)
    , state_(session.state())
    , kind_(new ChoiceBox)
    , closeOutput_(new ChoiceBox)
    , openOutput_(new ChoiceBox)
    , stateText_(valueLabel(QStringLiteral("gripper.state"), tr("Gripper state")))
    , openingText_(valueLabel(QStringLiteral("gripper.opening"), tr("Gripper opening")))
    , holdsText_(valueLabel(QStringLiteral("gripper.holds"), tr("Gripped object")))
    , activate_(key(tr("Activate"), QStringLiteral("gripper.activate"), tr("Activate the gripper")))
    , open_(key(tr("Open"), QStringLiteral("gripper.open"), tr("Open the gripper")))
    , close_(key(tr("Close"), QStringLiteral("gripper.close"), tr("Close the gripper")))
    , move_(key(tr("Move"), QStringLiteral("gripper.move"), tr("Move the fingers to the target opening")))
    , position_(new DecimalSpinBox)
    , speed_(new DecimalSpinBox)
    , force_(new DecimalSpinBox)
    , remedy_(new QLabel)
    , robotiq_(session) {
    setObjectName(QStringLiteral("gripper"));
    setAccessibleName(tr("Gripper"));
    setOutputs_ = [this](std::uint32_t mask, std::uint32_t values, const QString& what) {
        session_.outputs().setDigitalOutputs(mask, values, what);
    };
    build();
    choose({});

    connect(kind_, &QComboBox::activated, this, &GripperPanel::chosenByUser);
    connect(closeOutput_, &QComboBox::activated, this, &GripperPanel::chosenByUser);
    connect(openOutput_, &QComboBox::activated, this, &GripperPanel::chosenByUser);
    const auto ask = [this](const std::function<void()>& change) {
        if (!session_.asksBeforeChange(tr("Gripper"), change)) {
            change();
        }
    };
    connect(activate_, &QAbstractButton::clicked, this,
            [this, ask] { ask([this] { robotiq_.activate(); }); });
    connect(open_, &QAbstractButton::clicked, this, [this, ask] {
        ask([this] { choice_.usesOutputs() ? setHand(false) : move(0, tr("Gripper: open")); });
    });
    connect(close_, &QAbstractButton::clicked, this, [this, ask] {
        ask([this] { choice_.usesOutputs() ? setHand(true) : move(io::kRobotiqMost, tr("Gripper: close")); });
    });
    connect(move_, &QAbstractButton::clicked, this, [this, ask] {
        if (isRefused(position_)) {
            return;
        }
        const double opening = position_->value() * format::metresPerUnit();
        ask([this, opening] {
            move(robotiq_.position(opening), tr("Gripper: move to %1").arg(format::length(opening, 1)));
        });
    });
    connect(&robotiq_, &RobotiqLink::changed, this, &GripperPanel::refresh);
    connect(&session_, &RobotSession::stateChanged, this, &GripperPanel::follow);
    // Update the display periodically, because the state becomes outdated if no data arrive.
    refreshTimer_.setInterval(kGripperRefreshMs);
    connect(&refreshTimer_, &QTimer::timeout, this, &GripperPanel::refresh);
    refreshTimer_.start();
    refresh();
}

// ---- layout ---------------------------------------------------------------------------------------------

void GripperPanel::build() {
    kind_->setObjectName(QStringLiteral("gripper.kind"));
    kind_->setAccessibleName(tr("Gripper type"));
    kind_->addItem(tr("None"), kindOf({}));
    for (const auto model :
         {GripperChoice::Model::TwoF85, GripperChoice::Model::TwoF140, GripperChoice::Model::HandE}) {
        GripperChoice choice;
        choice.kind = GripperChoice::Kind::Robotiq;
        choice.model = model;
        kind_->addItem(tr("Robotiq %1").arg(QLatin1String(robotiqRange(model).name)), kindOf(choice));
    }
    kind_->addItem(tr("One output: on = closed"), QStringLiteral("output"));
    kind_->addItem(tr("Two outputs: open, close"), QStringLiteral("outputs"));
    closeOutput_->setObjectName(QStringLiteral("gripper.closeOutput"));
    closeOutput_->setAccessibleName(tr("Closing output"));
    openOutput_->setObjectName(QStringLiteral("gripper.openOutput"));
    openOutput_->setAccessibleName(tr("Opening output"));
    for (QComboBox* box : {kind_, closeOutput_, openOutput_}) {
        box->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
        box->setMinimumContentsLength(8);
        box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    }

    const std::tuple<DecimalSpinBox*, const char*, QString> figures[] = {
        {position_, "gripper.position", tr("Target opening")},
        {speed_, "gripper.speed", tr("Finger speed")},
        {force_, "gripper.force", tr("Finger force")}};
    for (const auto& [box, name, accessible] : figures) {
        box->setObjectName(QLatin1String(name));
        box->setAccessibleName(accessible);
        box->setFixedWidth(112);
    }
    for (DecimalSpinBox* box : {speed_, force_}) {
        box->setDecimals(0);
        box->setRange(0, 100);
        box->setSuffix(QStringLiteral(" %"));
    }
    speed_->setValue(kFirstSpeed);
    force_->setValue(kFirstForce);

    remedy_->setObjectName(QStringLiteral("gripper.remedy"));
    remedy_->setAccessibleName(tr("Suggested action"));
    remedy_->setWordWrap(true);
    remedy_->setAlignment(Qt::AlignLeft | Qt::AlignTop);
    remedy_->setContentsMargins(0, 10, 0, 0);

    auto* page = new QWidget;
    page->setObjectName(QStringLiteral("gripper.page"));
    auto* lines = new QVBoxLayout(page);
    lines->setContentsMargins(12, 10, 12, 12);
    lines->setSpacing(0);
    auto* grid = new QGridLayout;
    grid->setHorizontalSpacing(8);
    grid->setVerticalSpacing(6);
    grid->setColumnStretch(1, 1);
    QVector<QWidget*> always;
    addRow(grid, tr("Gripper"), kind_, always);
    addRow(grid, tr("Closed by"), closeOutput_, ofOutputs_);
    addRow(grid, tr("Opened by"), openOutput_, ofTwoOutputs_);
    addRow(grid, tr("State"), stateText_, ofAny_);
    addRow(grid, tr("Opening"), openingText_, ofRobotiq_);
    addRow(grid, tr("Object"), holdsText_, ofRobotiq_);
    QWidget* keys = buildKeys();
    grid->addWidget(keys, grid->rowCount(), 0, 1, 3);
    ofAny_.append(keys);
    addRow(grid, tr("Target"), position_, ofRobotiq_, move_);
    addRow(grid, tr("Speed"), speed_, ofRobotiq_);
    addRow(grid, tr("Force"), force_, ofRobotiq_);
    lines->addLayout(grid);
    lines->addWidget(remedy_);
    lines->addStretch();

    auto* scroll = new NoFocusScrollArea;
    scroll->setObjectName(QStringLiteral("gripper.scroll"));
    scroll->setAccessibleName(tr("Gripper"));
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setFocusPolicy(Qt::NoFocus);
    scroll->setWidgetResizable(true);
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    scroll->setWidget(page);
    // Make the viewport transparent, so that the panel behind it is visible.
    scroll->viewport()->setAutoFillBackground(false);
    page->setAutoFillBackground(false);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(scroll);
    // Use a constant height, so that a suggestion does not move other elements.
    remedy_->setMinimumHeight(kRemedyLines * QFontMetrics(textFont(15)).lineSpacing() + 10);
    listOutputs();
    fitValues();
    position_->setValue(position_->maximum());
}

QWidget* GripperPanel::buildKeys() {
    auto* keys = new QWidget;
    auto* row = new QHBoxLayout(keys);
    row->setContentsMargins(0, 4, 0, 4);
    row->setSpacing(8);
    for (QAbstractButton* button : {activate_, open_, close_}) {
        row->addWidget(button, 1);
    }
    return keys;
}

void GripperPanel::addRow(QGridLayout* grid, const QString& label, QWidget* field, QVector<QWidget*>& group,
                          QWidget* fieldKey) {
    const int line = grid->rowCount();
    auto* name = new QLabel(label);
    name->setProperty("role", "secondary");
    name->setBuddy(field);
    grid->addWidget(name, line, 0);
    const bool figure = qobject_cast<DecimalSpinBox*>(field) != nullptr;
    grid->addWidget(field, line, 1, 1, fieldKey == nullptr && !figure ? 2 : 1,
                    figure ? Qt::AlignLeft : Qt::Alignment());
    group.append(name);
    group.append(field);
    if (fieldKey != nullptr) {
        grid->addWidget(fieldKey, line, 2);
        group.append(fieldKey);
    }
}

void GripperPanel::fitValues() {
    const RobotiqRange& range = robotiqRange(choice_.model);
    const QSignalBlocker quiet(position_);
    const double before = position_->value();
    const double most = range.stroke / format::metresPerUnit();
    const double scale = position_->maximum() > 0 ? most / position_->maximum() : 1;
    position_->setDecimals(Notation::current().length == LengthUnit::Inches ? 3 : 1);
    position_->setSuffix(QLatin1Char(' ') + format::lengthUnit());
    position_->setRange(0, most);
    position_->setValue(before * scale);
    position_->setToolTip(tr("Target opening of the fingers, 0 to %1. “Move” starts the motion.")
                              .arg(format::length(range.stroke, 1)));
    speed_->setToolTip(tr("Speed of the next motion. 0 % is about %1, 100 % about %2.")
                           .arg(format::speed(range.leastSpeed), format::speed(range.mostSpeed)));
    force_->setToolTip(tr("Force of the next grip. 0 % is about %1, 100 % about %2.")
                           .arg(format::newtons(range.leastForce), format::newtons(range.mostForce)));
}

void GripperPanel::listOutputs() {
    for (QComboBox* box : {closeOutput_, openOutput_}) {
        const QSignalBlocker quiet(box);
        const int chosen = box == closeOutput_ ? choice_.closeOutput : choice_.openOutput;
        box->clear();
        for (int output = 0; output < io::kDigitalOutputs; ++output) {
            const QString terminal = ioTerminal(true, output);
            const QString name = names_.value(terminal);
            box->addItem(name.isEmpty() ? terminal : tr("%1 · %2").arg(terminal, name));
        }
        box->setCurrentIndex(chosen);
        box->setToolTip(box->currentText());
    }
}

void GripperPanel::changeEvent(QEvent* event) {
    if (event->type() == QEvent::StyleChange) {
        fitValues();
    }
    QWidget::changeEvent(event);
}

// ---- selection of the gripper ---------------------------------------------------------------------------

void GripperPanel::setMemory(GripperMemory memory) {
    memory_ = std::move(memory);
    robot_.clear();
    follow(session_.state());
}

void GripperPanel::readAgain() {
    if (robot_.isEmpty() || !memory_.load) {
        return;
    }
    // Do not select the same gripper again, because that would close its connection.
    if (const GripperChoice choice = GripperChoice::fromText(memory_.load(robot_)); choice != choice_) {
        choose(choice);
        chosen_.start();
    }
}

void GripperPanel::setNames(const QMap<QString, QString>& names) {
    if (names != names_) {
        names_ = names;
        listOutputs();
        refresh();
    }
}

void GripperPanel::setAddress(const QString& host, int port) {
    address_ = {host, port};
    refollow();
}

void GripperPanel::follow(const SessionState& state) {
    state_ = state;
    const QString robot = state.link == LinkState::Disconnected ? QString()
                          : state.simulated                     ? QStringLiteral("simulator")
                                                                : state.address;
    if (robot != robot_) {
        robot_ = robot;
        choose(robot.isEmpty() || !memory_.load ? GripperChoice()
                                                : GripperChoice::fromText(memory_.load(robot)));
    }
}

void GripperPanel::chosenByUser() {
    GripperChoice choice = choice_;
    const QString kind = kind_->currentData().toString();
    choice.closeOutput = closeOutput_->currentIndex();
    choice.openOutput = openOutput_->currentIndex();
    if (kind == QLatin1String("output")) {
        choice.kind = GripperChoice::Kind::OneOutput;
    } else if (kind == QLatin1String("outputs")) {
        choice.kind = GripperChoice::Kind::TwoOutputs;
    } else {
        const GripperChoice robotiq = GripperChoice::fromText(kind);
        choice.kind = robotiq.kind;
        choice.model = robotiq.model;
    }
    if (choice == choice_) {
        return;
    }
    choose(choice);
    chosen_.start();
    // Do not save an incomplete selection: opening and closing need different outputs.
    const bool complete =
        choice.kind != GripperChoice::Kind::TwoOutputs || choice.closeOutput != choice.openOutput;
    if (!robot_.isEmpty() && memory_.keep && complete) {
        memory_.keep(robot_, choice.toText());
    }
    session_.journal().add(Severity::Info, tr("Gripper set to %1").arg(kind_->currentText()),
                           Origin::Operator);
}

void GripperPanel::choose(const GripperChoice& choice) {
    choice_ = choice;
    outputs_.choose(choice);
    using Kind = GripperChoice::Kind;
    kind_->setCurrentIndex(kind_->findData(kindOf(choice)));
    kind_->setToolTip(kind_->currentText());
    listOutputs();
    fitValues();
    const auto show = [](const QVector<QWidget*>& group, bool shown) {
        for (QWidget* widget : group) {
            widget->setVisible(shown);
        }
    };
    show(ofAny_, choice.kind != Kind::None);
    show(ofRobotiq_, choice.kind == Kind::Robotiq);
    show(ofOutputs_, choice.usesOutputs());
    show(ofTwoOutputs_, choice.kind == Kind::TwoOutputs);
    activate_->setVisible(choice.kind == Kind::Robotiq);
    refollow();
    refresh();
}

void GripperPanel::refollow() {
    const auto& [host, port] =
        address_.value_or(std::pair(state_.address, io::kRobotiqPort + state_.portOffset));
    if (choice_.kind == GripperChoice::Kind::Robotiq && !robot_.isEmpty() && port <= kMaxTcpPort) {
        robotiq_.follow(host, port, choice_.model);
    } else {
        robotiq_.leave();
    }
}

// ---- commands -------------------------------------------------------------------------------------------

GripperPort GripperPanel::port() {
    return {
        .choice = [this] { return choice_; },
        .obstacle = [this] { return robotiqObstacle(); },
        .move =
            [this](bool close, const CancelToken& token) {
                move(close ? io::kRobotiqMost : 0, close ? tr("Gripper: close") : tr("Gripper: open"), token);
            },
        .stop = [this] { robotiq_.stop(tr("Gripper: stop")); },
        .outcome = [this](bool close) { return robotiqOutcome(close); },
    };
}

QString GripperPanel::robotiqObstacle() const {
    const std::optional<io::RobotiqState> now = robotiq_.state();
    if (!now) {
        return robotiq_.reason();
    }
    if (!robotiq_.faultText().isEmpty()) {
        return robotiq_.faultText();
    }
    if (now->activation != io::RobotiqActivation::Active) {
        return tr("Activate the gripper first.");
    }
    // If a box contains invalid input, the previous value would be sent.
    return speed_->isRefused() || force_->isRefused()
               ? tr("Speed or force is out of range. Enter a value from 0 to 100 %.")
               : QString();
}

std::optional<Result<void>> GripperPanel::robotiqOutcome(bool close) const {
    if (robotiq_.isBusy()) {
        return std::nullopt;
    }
    if (const QString why = robotiqObstacle(); !why.isEmpty()) {
        return Result<void>(Error{ErrorCode::Cancelled, why, {}});
    }
    const io::RobotiqState now = *robotiq_.state();
    if (now.requested != (close ? io::kRobotiqMost : 0)) {
        return Result<void>(Error{ErrorCode::Cancelled,
                                  tr("The gripper did not execute the command. Check that no other program "
                                     "controls the gripper, then try again."),
                                  {}});
    }
    return now.object == io::RobotiqObject::Moving ? std::nullopt : std::optional(Result<void>());
}

void GripperPanel::move(int position, const QString& what, const CancelToken& token) {
    if (isRefused(speed_) || isRefused(force_)) {
        return;
    }
    robotiq_.move(
        position, byteOf(speed_->value()), byteOf(force_->value()),
        tr("%1 (speed %2, force %3)")
            .arg(what, format::percent(speed_->value() / 100), format::percent(force_->value() / 100)),
        token);
}

void GripperPanel::setHand(bool close) {
    const OutputGripper::Command command = outputs_.command(close, clock_->nowNs());
    setOutputs_(command.mask, command.values, command.what);
    refresh();
}

// ---- display --------------------------------------------------------------------------------------------

QString GripperPanel::obstacleOfLink() const {
    if (robot_.isEmpty()) {
        return tr("Connect to a robot first. Tiller stores the gripper selection for each robot.");
    }
    if (state_.link != LinkState::Live) {
        return tr("The robot is not sending data. Wait for data, or reconnect.");
    }
    if (state_.monitorOnly) {
        return texts::monitorOnlyObstacle();
    }
    // This reason applies to all buttons, because they are enabled together.
    return chosen_.isValid() && chosen_.elapsed() < kSettleMs ? tr("Please wait…") : QString();
}

void GripperPanel::refresh() {
    using Kind = GripperChoice::Kind;
    const QString noRobot = robot_.isEmpty() ? obstacleOfLink() : QString();
    for (QComboBox* box : {kind_, closeOutput_, openOutput_}) {
        if (box->isEnabled() != noRobot.isEmpty()) {
            box->setEnabled(noRobot.isEmpty());
        }
    }
    if (choice_.kind == Kind::None) {
        say(!noRobot.isEmpty() ? noRobot
                               : tr("Select the mounted gripper. The choice is stored for this robot."),
            "secondary");
    } else if (choice_.kind == Kind::Robotiq) {
        refreshRobotiq();
    } else {
        refreshOutputs();
    }
}

void GripperPanel::refreshRobotiq() {
    const std::optional<io::RobotiqState> now = robotiq_.state();
    const bool active = now && now->activation == RobotiqActivation::Active;
    const bool activating = now && now->activation == RobotiqActivation::Activating;
    const bool settled = active && !robotiq_.isBusy();
    const QString opening = now ? format::length(robotiq_.opening(now->position), 1) : tr("unknown");
    setText(stateText_, !now                                   ? tr("unknown")
                        : activating                           ? tr("activating…")
                        : !active                              ? tr("not active")
                        : robotiq_.isBusy()                    ? tr("pending…")
                        : !now->goTo                           ? tr("active")
                        : now->object == RobotiqObject::Moving ? tr("moving")
                                                               : tr("active, at standstill"));
    stateText_->setEnabled(true);
    setText(openingText_, opening);
    setText(holdsText_, !settled || !now->goTo                         ? tr("unknown")
                        : now->object == RobotiqObject::Moving         ? tr("unknown while moving")
                        : now->object == RobotiqObject::StoppedClosing ? tr("external grip")
                        : now->object == RobotiqObject::StoppedOpening ? tr("internal grip")
                                                                       : tr("none"));
    const QString link = obstacleOfLink();
    const QString fault = robotiq_.faultText();
    const bool noPort = io::kRobotiqPort + state_.portOffset > kMaxTcpPort && !address_;
    const QString unknown =
        noPort ? tr("The gripper is not available with this port offset. Use a smaller port offset.")
               : robotiq_.reason();
    const QString why = !link.isEmpty() ? link : !now ? unknown : QString();
    const QString moving = !why.isEmpty() ? why
                           : activating   ? tr("Activating: the fingers open and close once.")
                           : !active      ? tr("Activate the gripper first.")
                                          : QString();
    const QString activation = !why.isEmpty()              ? why
                               : activating                ? moving
                               : active && fault.isEmpty() ? tr("The gripper is active.")
                                                           : QString();
    setObstacles(moving, activation);
    if (!now) {
        say(unknown, robotiq_.isConnecting() ? "secondary" : "warning");
    } else if (!fault.isEmpty()) {
        say(fault, "warning");
    } else {
        say(moving, "secondary");
    }
}

void GripperPanel::refreshOutputs() {
    outputs_.follow(state_, clock_->nowNs());
    setText(stateText_, outputs_.text());
    stateText_->setEnabled(state_.link == LinkState::Live);
    const QString link = obstacleOfLink();
    const QString why = link.isEmpty() ? outputs_.obstacle(session_.outputs().holders()) : link;
    setObstacles(why, why);
    say(why.isEmpty() ? outputs_.complaint() : why, link.isEmpty() ? "warning" : "secondary");
}

void GripperPanel::setObstacles(const QString& moving, const QString& activating) {
    const QString stays = tr("Stopping the arm does not open the gripper.");
    const auto tip = [&stays](const QString& what) { return what + QLatin1Char('\n') + stays; };
    setObstacle(activate_, activating,
                tr("The fingers open and close once and drop any gripped object. Keep your fingers clear of "
                   "the gripper."));
    setObstacle(open_, moving, tip(tr("Opens the gripper and releases the object.")));
    setObstacle(close_, moving, tip(tr("Closes the gripper. Keep your fingers clear of the gripper.")));
    setObstacle(move_, moving, tip(tr("Moves the fingers to the target opening.")));
}

void GripperPanel::say(const QString& text, const char* role) {
    if (remedy_->property("role").toString() != QLatin1String(role)) {
        remedy_->setProperty("role", role);
        remedy_->style()->unpolish(remedy_);
        remedy_->style()->polish(remedy_);
    }
    setText(remedy_, text);
}

}  // namespace tiller

#include "moc_gripper_panel.cpp"
