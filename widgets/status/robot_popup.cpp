// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/status/robot_popup.h"

#include <QAccessible>
#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>
#include <utility>

#include "robot/station/link/obstacles.h"
#include "widgets/common/enter_key.h"
#include "widgets/common/shapes.h"
#include "widgets/common/theme.h"

namespace tiller {

namespace {

constexpr int kWidth = 460;     // [px]
constexpr int kMinMargin = 16;  // minimum distance from the edges of the widget below [px]
constexpr int kMargin = 16;
constexpr int kBelowCenter = 110;  // distance from the center of the widget below to the lower edge [px]
constexpr int kSign = 22;
constexpr qsizetype kLongest = 600;  // maximum text length [characters]; the log contains the full text

using script::MessageSeverity;

QString kindText(MessageSeverity severity) {
    return severity >= MessageSeverity::Violation ? RobotPopup::tr("Error")
           : severity == MessageSeverity::Warning ? RobotPopup::tr("Warning")
                                                  : RobotPopup::tr("Message");
}

}  // namespace

RobotPopup::RobotPopup(RobotSession& session, QWidget& window, QWidget& over)
    : QFrame(&window)
    , session_(session)
    , over_(over)
    , heading_(new QLabel)
    , text_(new QLabel)
    , note_(new QLabel)
    , key_(new EnterKey) {
    setObjectName(QStringLiteral("robotPopup"));
    setAccessibleName(tr("Popup on the robot"));
    heading_->setObjectName(QStringLiteral("robotPopup.heading"));
    heading_->setProperty("role", QStringLiteral("strong"));
    text_->setObjectName(QStringLiteral("robotPopup.text"));
    text_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    note_->setObjectName(QStringLiteral("robotPopup.note"));
    note_->setProperty("role", QStringLiteral("secondary"));
    for (QLabel* label : {heading_, text_, note_}) {
        label->setWordWrap(true);
        label->setTextFormat(Qt::PlainText);
    }
    key_->setObjectName(QStringLiteral("robotPopup.close"));
    key_->setProperty("primary", true);
    key_->setFocusPolicy(Qt::TabFocus);

    auto* top = new QHBoxLayout;
    top->addSpacing(kSign + 8);
    top->addWidget(heading_, 1);
    auto* bottom = new QHBoxLayout;
    bottom->addWidget(note_, 1);
    bottom->addWidget(key_, 0, Qt::AlignBottom);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(kMargin, kMargin, kMargin, kMargin);
    layout->setSpacing(10);
    layout->addLayout(top);
    layout->addWidget(text_, 1);
    layout->addLayout(bottom);

    unread_.setSingleShot(true);
    unread_.setInterval(kUnreadMs);
    nextUpdate_.setSingleShot(true);
    nextUpdate_.setInterval(kShowEveryMs);
    connect(&nextUpdate_, &QTimer::timeout, this, [this] {
        obstacle_ = obstacleNow(session_.state());
        showNewest();
    });
    connect(&unread_, &QTimer::timeout, this, &RobotPopup::showKey);
    connect(key_, &QPushButton::clicked, this, &RobotPopup::closeOnRobot);
    connect(&session, &RobotSession::controllerMessage, this, &RobotPopup::hear);
    connect(&session, &RobotSession::stateChanged, this, &RobotPopup::followState);
    connect(&session, &RobotSession::commandDone, this, &RobotPopup::followCommand);
    connect(&session, &RobotSession::linkBegan, this, &RobotPopup::forget);
    over_.installEventFilter(this);
    window.installEventFilter(this);
    hide();
    showKey();
}

void RobotPopup::hear(const script::ControllerMessage& message) {
    if (message.kind != script::MessageKind::Popup) {
        return;
    }
    popups_.append(message);
    if (popups_.size() > kMaxPopups) {
        popups_.removeFirst();
        if (asked_) {
            asked_ = std::max<qsizetype>(0, *asked_ - 1);
        }
    }
    refused_ = false;
    unread_.start();
    showSoon();
}

// Limits the update rate. Displaying every popup of a rapid series would overload the layout and the screen
// reader.
void RobotPopup::showSoon() {
    if (nextUpdate_.isActive()) {
        showKey();  // disables the button, because the newest popup has not been read
        return;
    }
    obstacle_ = obstacleNow(session_.state());
    showNewest();
    nextUpdate_.start();
}

void RobotPopup::followState(const SessionState& state) {
    // A controller that was restarted has closed its popups.
    const bool isRestarted = state.hasData() && state.robotTime < robotTime_;
    robotTime_ = state.hasData() ? state.robotTime : robotTime_;
    if (popups_.isEmpty()) {
        return;
    }
    if (state.link == LinkState::Disconnected || isRestarted) {
        forget();
        return;
    }
    const QString obstacle = obstacleNow(state);
    if (obstacle != obstacle_) {
        obstacle_ = obstacle;
        showNewest();
    }
}

QString RobotPopup::obstacleNow(const SessionState& state) const {
    if (refused_) {
        return tr("Tiller could not close the popup. Close the popup on the teach pendant.");
    }
    return state.link == LinkState::Live
               ? serviceObstacle(state, RobotCommand::ClosePopups)
               : tr("No data from the robot. Close the popup on the teach pendant.");
}

void RobotPopup::followCommand(RobotCommand command, bool done) {
    if (command != RobotCommand::ClosePopups || popups_.isEmpty()) {
        return;
    }
    const qsizetype newest = popups_.size() - 1;
    // Use the popup of the request, because another popup may have arrived since. Without a request, another
    // client has closed the newest popup.
    const qsizetype which = std::exchange(asked_, std::nullopt).value_or(newest);
    if (done) {
        remove(which);
        return;
    }
    refused_ = refused_ || which == newest;
    obstacle_ = obstacleNow(session_.state());
    showNewest();
}

void RobotPopup::remove(qsizetype which) {
    // A refusal refers only to the newest popup.
    refused_ = refused_ && which != popups_.size() - 1;
    popups_.removeAt(which);
    obstacle_ = obstacleNow(session_.state());
    showNewest();
}

void RobotPopup::closeOnRobot() {
    if (popups_.isEmpty()) {
        return;
    }
    if (!obstacle_.isEmpty()) {
        remove(popups_.size() - 1);
        return;
    }
    asked_ = popups_.size() - 1;
    showKey();
    session_.services().perform(RobotCommand::ClosePopups);
}

void RobotPopup::closeNewest() {
    if (asked_) {
        return;
    }
    if (popups_.isEmpty() || refused_) {
        // Try again after a refusal. Also close popups that were opened before the connection, because
        // their texts are unknown.
        session_.services().perform(RobotCommand::ClosePopups);
    } else if (closeObstacle().isEmpty()) {
        closeOnRobot();
    }
}

QString RobotPopup::closeObstacle() const {
    if (asked_) {
        return tr("The popup is being closed.");
    }
    return popups_.isEmpty() || isCloseEnabled() ? QString() : tr("Read the popup first.");
}

bool RobotPopup::isCloseEnabled() const {
    return !asked_ && !unread_.isActive();
}

void RobotPopup::forget() {
    popups_.clear();
    obstacle_.clear();
    asked_.reset();
    refused_ = false;
    robotTime_ = 0;
    showNewest();
}

void RobotPopup::showNewest() {
    if (popups_.isEmpty()) {
        hide();
        return;
    }
    ++updates_;
    const script::ControllerMessage& newest = popups_.last();
    heading_->setText(newest.title.isEmpty() ? kindText(newest.severity) : newest.title);
    const bool whole = newest.text.size() <= kLongest;
    text_->setText(whole ? newest.text : newest.text.left(kLongest) + QChar(0x2026));
    const int others = count() - 1;
    const QString more = others > 0 ? tr("%n more popup(s) on the robot.", nullptr, others) : QString();
    note_->setText((obstacle_.isEmpty()
                        ? tr("A waiting program continues when the popup is closed: keep clear of the arm.")
                        : obstacle_) +
                   (more.isEmpty() ? QString() : QLatin1Char(' ') + more));
    setAccessibleDescription(heading_->text() + QStringLiteral(". ") + newest.text);
    showKey();
    show();
    raise();
    place();
    update();
    QAccessibleEvent alert(this, QAccessible::Alert);
    QAccessible::updateAccessibility(&alert);
}

void RobotPopup::showKey() {
    key_->setText(obstacle_.isEmpty() ? tr("Close") : tr("Hide"));
    key_->setAccessibleName(obstacle_.isEmpty() ? tr("Close the popup on the robot") : tr("Hide the popup"));
    key_->setEnabled(isCloseEnabled());
}

void RobotPopup::place() {
    const QWidget& window = *parentWidget();
    const QRect room = over_.isVisible() && over_.window() == &window
                           ? QRect(over_.mapTo(&window, QPoint(0, 0)), over_.size())
                           : window.rect();
    const int width = std::min(kWidth, std::max(240, room.width() - 2 * kMinMargin));
    layout()->activate();
    const int height = std::max(heightForWidth(width), minimumSizeHint().height());
    // The lower edge does not depend on the text if there is enough space, so that a new text does not move the
    // button.
    const int bottom = std::min(room.center().y() + kBelowCenter, room.bottom() - kMinMargin);
    setGeometry(room.center().x() - width / 2, std::max(0, bottom - height), width, height);
}

bool RobotPopup::eventFilter(QObject* watched, QEvent* event) {
    switch (event->type()) {
        case QEvent::Resize:
        case QEvent::Move:
        case QEvent::Show:
        case QEvent::Hide:
        case QEvent::StyleChange:
            if (isVisible()) {
                place();
            }
            break;
        default:
            break;
    }
    return QFrame::eventFilter(watched, event);
}

void RobotPopup::paintEvent(QPaintEvent*) {
    const Theme& theme = Theme::current();
    const MessageSeverity severity = popups_.isEmpty() ? MessageSeverity::Info : popups_.last().severity;
    const bool error = severity >= MessageSeverity::Violation;
    const bool warning = severity == MessageSeverity::Warning;
    const QColor ink = error ? theme.alarm : warning ? theme.warning : theme.text;
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(ink, 2));
    painter.setBrush(theme.raised);
    painter.drawRoundedRect(QRectF(rect()).adjusted(1, 1, -1, -1), kCornerRadius, kCornerRadius);
    drawShape(painter,
              error     ? StateChip::Shape::Octagon
              : warning ? StateChip::Shape::WarningTriangle
                        : StateChip::Shape::Circle,
              QRectF(kMargin, kMargin, kSign, kSign), ink, theme.raised);
}

}  // namespace tiller

#include "moc_robot_popup.cpp"
