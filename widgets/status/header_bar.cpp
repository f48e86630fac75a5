// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/status/header_bar.h"

#include <QApplication>
#include <QEvent>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QPainter>
#include <QPushButton>
#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "robot/station/text/notation.h"
#include "robot/station/text/texts.h"
#include "widgets/common/single_click.h"
#include "widgets/common/state_chip.h"
#include "widgets/common/theme.h"
#include "widgets/common/window_stacking.h"
#include "widgets/status/simulation_chip.h"
#include "widgets/status/speed_chip.h"
#include "widgets/status/stop_button.h"

namespace tiller {

namespace {

constexpr int kLinkPeriodMs = 500;      // update interval of values that change with every packet
constexpr int kStackingMs = 30;         // delay after a change of the window order, so that several changes
                                        // cause one update
constexpr int kStackingCheckMs = 1000;  // interval of the checks if changes of the window order are reported
constexpr int kStackingPollMs = 250;    // interval of the checks if they are not reported
constexpr double kOrdinaryCap = 0.250;  // [m/s]; the header shows a higher speed cap
constexpr int kBannerHeight = 28;
constexpr int kNarrowBelow = 1900;
constexpr int kTightBelow = 1600;
constexpr int kLeastStateRoom = 112;

StateChip* chip(const QString& caption, const char* name, QWidget* parent) {
    auto* made = new StateChip(caption, parent);
    made->setObjectName(QLatin1String(name));
    return made;
}

/// True if the operator must confirm a change of the slider. Not required for a program of Tiller, because
/// the operator may slow down that program at any time.
bool asksBeforeSlider(const RobotSession& session) {
    return session.state().foreignProgramRuns() && session.mustAskBeforeChange();
}

void showOn(StateChip& chip, const ModeLook& look) {
    chip.setState(look.text, look.shape, look.emphasis, look.advice);
    chip.setMark(look.mark);
}

/// Required width of a button with this text [px].
int roomFor(const QPushButton& key, const QString& text) {
    constexpr int kAround = 2 * (8 + 1);  // padding and border as in the style sheet
    return key.fontMetrics().size(0, text).width() + kAround;
}

/// Returns the text on one line if it fits, otherwise on two lines with the smallest width.
QString stepWords(const QPushButton& key, const QString& text, int width) {
    if (roomFor(key, text) <= width) {
        return text;
    }
    QString best = text;
    for (qsizetype blank = text.indexOf(QLatin1Char(' ')); blank >= 0;
         blank = text.indexOf(QLatin1Char(' '), blank + 1)) {
        QString broken = text;
        broken[blank] = QLatin1Char('\n');
        if (roomFor(key, broken) < roomFor(key, best)) {
            best = broken;
        }
    }
    return best;
}

/// Returns the width of the button that fits every next step [px].
int stepRoom(QPushButton& key, int least) {
    key.ensurePolished();  // applies the font of the style sheet
    int room = least;
    for (const NextStep step : {NextStep::Connect, NextStep::PowerOn, NextStep::ReleaseBrakes,
                                NextStep::Recover, NextStep::TakeControl}) {
        room = std::max(room, roomFor(key, stepWords(key, nextStepText(step), least)));
    }
    return room;
}

/// Returns the minimum width of the connection chip that fits every caption [px].
int linkRoom(const StateChip& chip) {
    SessionState good;
    good.sequence = 1;
    good.link = LinkState::Live;
    SessionState slow = good;
    slow.quality.roundTripMs = 1000;
    SessionState gaps = good;
    gaps.quality.recent = {1000, 0, 1000};
    int room = 0;
    for (const SessionState& state : {good, slow, gaps}) {
        room = std::max(room, chip.leastRoom(linkCaption(state)));
    }
    return room;
}

}  // namespace

HeaderBar::HeaderBar(HeaderPort port, QWidget* parent)
    : QWidget(parent)
    , port_(std::move(port))
    , layout_(new QHBoxLayout(this))
    , name_(new QLabel(QStringLiteral("Tiller"), this))
    , robot_(chip(tr("ROBOT"), "robotChip", this))
    , simulation_(new SimulationChip(this))
    , mode_(chip(tr("ROBOT MODE"), "robotModeChip", this))
    , safety_(chip(tr("SAFETY"), "safetyChip", this))
    , control_(chip(tr("CONTROL"), "controlChip", this))
    , stepButton_(new QPushButton(this))
    , speed_(new SpeedChip(this))
    , link_(chip(tr("LINK"), "linkChip", this))
    , lastStop_(chip(tr("LAST STOP"), "lastStopChip", this))
    , stop_(new StopButton(this))
    , cap_(new QLabel(this)) {
    setObjectName(QStringLiteral("headerBar"));
    setAccessibleName(tr("Robot state"));
    setFixedHeight(kHeight);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);

    name_->setFont(textFont(20, QFont::Bold));
    for (StateChip* withMenu : {robot_, mode_, control_}) {
        withMenu->setMenuArrow(true);
    }
    link_->setNumberFont(true);
    lastStop_->setNumberFont(true);
    // arrange() sets the layout from the width of the bar.
    layout_->setSizeConstraint(QLayout::SetNoConstraint);
    stepButton_->setObjectName(QStringLiteral("nextStepButton"));
    new SingleClick(*stepButton_);  // a second click would trigger the next step before the user has read it
    stepButton_->setAccessibleName(tr("Next step"));
    stepButton_->setProperty("primary", true);
    QSizePolicy keepsItsPlace(QSizePolicy::Fixed, QSizePolicy::Fixed);
    keepsItsPlace.setRetainSizeWhenHidden(true);
    stepButton_->setSizePolicy(keepsItsPlace);

    layout_->addWidget(name_);
    for (QWidget* widget :
         {static_cast<QWidget*>(robot_), static_cast<QWidget*>(simulation_), static_cast<QWidget*>(mode_),
          static_cast<QWidget*>(safety_), static_cast<QWidget*>(control_), static_cast<QWidget*>(stepButton_),
          static_cast<QWidget*>(speed_), static_cast<QWidget*>(link_), static_cast<QWidget*>(lastStop_)}) {
        layout_->addWidget(widget, 0, Qt::AlignVCenter);
    }
    layout_->addStretch(1);
    layout_->addWidget(stop_, 0, Qt::AlignVCenter);

    connect(robot_, &StateChip::clicked, this, [this] { Q_EMIT menuRequested(Menu::Robot); });
    connect(mode_, &StateChip::clicked, this, [this] { Q_EMIT menuRequested(Menu::Power); });
    connect(control_, &StateChip::clicked, this, [this] { Q_EMIT menuRequested(Menu::Control); });
    connect(safety_, &StateChip::clicked, this, [this] {
        if (state_.hasData() && !allowsMotion(state_.safety())) {
            Q_EMIT recoveryRequested();
        }
    });
    connect(stepButton_, &QPushButton::clicked, this, &HeaderBar::takeStep);
    connect(stop_, &StopButton::stopRequested, this, [this] { port_.stop(control::StopCause::StopButton); });
    connect(speed_, &SpeedChip::fractionChosen, this,
            [this](double fraction) { port_.setSpeedSlider(fraction); });
    cap_->setObjectName(QStringLiteral("capBanner"));
    cap_->setAlignment(Qt::AlignCenter);
    cap_->setFont(textFont(14, QFont::Bold));
    cap_->setAutoFillBackground(true);
    cap_->hide();
    linkPace_.setSingleShot(true);
    linkPace_.setInterval(kLinkPeriodMs);
    connect(&linkPace_, &QTimer::timeout, this, &HeaderBar::showLink);
    stacking_.setSingleShot(true);
    connect(&stacking_, &QTimer::timeout, this, &HeaderBar::stackStopAbove);
    connect(qApp, &QGuiApplication::applicationStateChanged, this, &HeaderBar::stackStopAbove);
    places_.setSingleShot(true);
    places_.setInterval(kKeepPlacesMs);
    connect(&places_, &QTimer::timeout, this, &HeaderBar::letPlacesGo);
    for (QWidget* child : findChildren<QWidget*>()) {
        child->installEventFilter(this);
    }
    arrange();
    applyState(SessionState());
}

HeaderBar::HeaderBar(RobotSession& session, QWidget* parent)
    : HeaderBar(HeaderPort{
                    .perform = [&session](RobotCommand command) { session.services().perform(command); },
                    .takeControl = [&session] { session.takeControl(); },
                    .setSpeedSlider =
                        [&session](double fraction) {
                            const auto set = [&session, fraction] {
                                session.outputs().setSpeedSlider(fraction);
                            };
                            const QString what = QStringLiteral("%1: %2 %")
                                                     .arg(SpeedChip::tr("Speed slider"))
                                                     .arg(std::lround(100 * fraction));
                            if (!asksBeforeSlider(session) || !session.asksBeforeChange(what, set)) {
                                set();
                            }
                        },
                    .asksBeforeSlider = [&session] { return asksBeforeSlider(session); },
                    .stop = [&session](control::StopCause cause) { session.stop(cause); },
                },
                parent) {
    applyState(session.state());
    connect(&session, &RobotSession::stateChanged, this, &HeaderBar::applyState);
}

QWidget* HeaderBar::menuChip(Menu menu) const {
    return menu == Menu::Robot ? robot_ : menu == Menu::Power ? mode_ : control_;
}

void HeaderBar::applyState(const SessionState& state) {
    const bool linkChanged = state.link != state_.link;
    state_ = state;
    const bool connected = state.link != LinkState::Disconnected;
    const bool hasData = state.hasData();

    QString robotAdvice = state.address;
    if (connected && !state.robotName.isEmpty()) {
        robotAdvice = state.robotName + QStringLiteral(" · ") + state.address;
    }
    robot_->setState(connected ? state.robotName : tr("None"), StateChip::Shape::None,
                     StateChip::Emphasis::Normal, robotAdvice);
    simulation_->setVisible(connected && state.simulated);
    if (hasData) {
        ModeLook mode = robotModeLook(state.robotMode, state.moving, state.freedriveActive);
        ModeLook safety = safetyModeLook(state.safety());
        if (state.link == LinkState::Stale) {
            mode.emphasis = safety.emphasis = StateChip::Emphasis::Muted;
        }
        showOn(*mode_, mode);
        showOn(*safety_, safety);
    } else {
        const QString text = connected ? tr("NO DATA") : QStringLiteral("–");
        const ModeLook none{text, StateChip::Shape::None, StateChip::Emphasis::Muted, state.linkReason};
        showOn(*mode_, none);
        showOn(*safety_, none);
    }
    showOn(*control_, controlLook(state));
    control_->setCaption(state.monitorOnly ? tr("MONITOR ONLY") : tr("CONTROL"));
    speed_->setSendsOnRelease(port_.asksBeforeSlider && port_.asksBeforeSlider());
    speed_->setLocked(state.monitorOnly ? texts::monitorOnlyObstacle() : QString());
    speed_->setReported(state.speedFraction, hasData);
    for (StopButton* stop : {stop_, stopAbove_.data()}) {
        if (stop != nullptr) {
            stop->setKeysStop(state.keysStop());
        }
    }
    placeStopAbove();  // an ancestor of the header may have moved

    showStep();
    showCap(state.speedCap);
    showLastStop();
    if (linkChanged || !linkPace_.isActive()) {
        showLink();
    }
}

void HeaderBar::setHoldNote(std::function<QString()> note) {
    holdNote_ = std::move(note);
    showLastStop();
}

void HeaderBar::showLastStop() {
    const control::StopMeasurement& last = state_.lastStop;
    const QString note = holdNote_ ? holdNote_() : QString();
    const auto advice = [&note](const QString& text) {
        return note.isEmpty() ? text : text + QStringLiteral("\n") + note;
    };
    lastStop_->setCaption(note.isEmpty() ? tr("LAST STOP") : tr("LAST STOP · no key check"));
    if (const control::UnmeasuredStop& lost = state_.unmeasuredStop; !state_.lastStopSeen) {
        const bool failed = lost.reason == control::UnmeasuredStop::Reason::NotStopped;
        lastStop_->setState(
            failed ? tr("Not stopped") : tr("Not measured"), StateChip::Shape::None,
            failed ? StateChip::Emphasis::Warning : StateChip::Emphasis::Muted,
            advice(
                lost.cause == control::StopCause::None &&
                        lost.reason == control::UnmeasuredStop::Reason::OtherProgram
                    ? tr("The program was stopped on the robot, so the stop could not be measured.")
                : lost.cause == control::StopCause::None
                    ? tr("The robot stopped sending data while the arm was moving, so the stop could not be "
                         "measured.")
                    : tr("Cause: %1 (%2)")
                          .arg(texts::stopCauseText(lost.cause), texts::unmeasuredText(lost.reason))));
    } else if (last.count > 0) {
        lastStop_->setState(
            tr("%1 ms · %2").arg(last.durationMs, 0, 'f', 0).arg(format::length(last.distanceMm / 1e3, 1)),
            StateChip::Shape::None, StateChip::Emphasis::Normal,
            advice(tr("Measured from the stop command to standstill. Cause: %1")
                       .arg(texts::stopCauseText(last.cause))));
    } else {
        lastStop_->setState(QStringLiteral("–"), StateChip::Shape::None, StateChip::Emphasis::Muted,
                            advice(tr("No stop measured yet")));
    }
}

void HeaderBar::showLink() {
    ModeLook look = linkLook(state_);
    if (width() < kTightBelow && look.emphasis == StateChip::Emphasis::Normal) {
        // If there is little space, the normal state shows only the packet rate.
        look.advice.prepend(look.text + QLatin1Char('\n'));
        look.text = look.text.section(QStringLiteral(" · "), 0, 0);
    }
    showOn(*link_, look);
    // If there is little space, the first word is elided, so that the consequence for jogging remains.
    link_->setCaption(linkCaption(state_), StateChip::ElidedPart::Before);
    if (state_.link != LinkState::Disconnected) {
        linkPace_.start();
    }
}

void HeaderBar::showCap(double speedCap) {
    const bool raised = speedCap > kOrdinaryCap + 1e-9;
    if (raised) {
        cap_->setText(tr("▲ Speed cap raised to %1").arg(format::speed(speedCap)));
        cap_->setToolTip(tr("The arm may move faster than %1. Lower the speed cap in Settings. The cap is "
                            "reset when Tiller is closed.")
                             .arg(format::speed(kOrdinaryCap)));
        cap_->setAccessibleName(cap_->text());
        QPalette colours;
        colours.setColor(QPalette::Window, Theme::current().warningBackground);
        colours.setColor(QPalette::WindowText, Theme::current().warning);
        cap_->setPalette(colours);
    }
    if (raised != cap_->isVisibleTo(this)) {
        cap_->setVisible(raised);
        setFixedHeight(kHeight + (raised ? kBannerHeight : 0));
        arrange();
    }
}

void HeaderBar::showStep() {
    if (places_.isActive()) {
        return;  // elements keep their positions after a click; the step is shown later
    }
    const bool isAnother = nextStep(state_) != step_;
    step_ = nextStep(state_);
    if (isAnother) {
        stepButton_->clearFocus();  // a key press may have been intended for the previous step
    }
    const QString obstacle = nextStepObstacle(state_);
    offerStep(step_ != NextStep::None, obstacle.isEmpty());
    if (isAnother) {
        stepButton_->setText(stepWords(*stepButton_, nextStepText(step_), stepButton_->width()));
    }
    stepButton_->setAccessibleName(step_ == NextStep::None ? tr("Next step") : nextStepText(step_));
    stepButton_->setToolTip(obstacle.isEmpty() ? nextStepAdvice(step_) : obstacle);
}

// Shows or hides the button for the next step. If the focused button is hidden or disabled, Qt passes the
// focus to the next control, the speed slider. This function prevents that and restores the focus when the
// next step becomes available.
void HeaderBar::offerStep(bool visible, bool enabled) {
    if (!visible || !enabled) {
        stepLostFocus_ = stepLostFocus_ || stepButton_->hasFocus();
        stepButton_->clearFocus();
    }
    stepButton_->setVisible(visible);
    stepButton_->setEnabled(enabled);
    if (visible && enabled && std::exchange(stepLostFocus_, false) && window()->focusWidget() == nullptr) {
        stepButton_->setFocus(Qt::OtherFocusReason);
    }
}

void HeaderBar::keepPlaces() {
    layout_->activate();
    layout_->setEnabled(false);
    places_.start();
}

void HeaderBar::letPlacesGo() {
    layout_->setEnabled(true);
    showStep();
    layout_->invalidate();
    layout_->activate();
}

void HeaderBar::showEvent(QShowEvent* event) {
    QWidget::showEvent(event);
    window()->installEventFilter(this);
}

void HeaderBar::offerStopAbove() {
    QWidget* dialog = QApplication::activeModalWidget();
    if (dialog == nullptr || !dialog->isVisible() || stopAbove_ || dialog == window()) {
        return;
    }
    stopAbove_ = new StopButton(dialog);
    stopAbove_->setObjectName(QStringLiteral("stopAboveDialog"));
    stopAbove_->setWindowFlags(Qt::ToolTip);  // the only window type that does not receive the focus
    stopAbove_->setAttribute(Qt::WA_ShowWithoutActivating);
    connect(stopAbove_, &StopButton::stopRequested, this,
            [this] { port_.stop(control::StopCause::StopButton); });
    stopAbove_->setKeysStop(state_.keysStop());
    placeStopAbove();
    stopAbove_->show();
    // The watch is a child of the button, so that it exists only while a dialog is open.
    stackingWatch_ = new StackingWatch(stopAbove_);
    connect(stackingWatch_, &StackingWatch::changed, this, [this] {
        if (stacking_.remainingTime() > kStackingMs) {
            stacking_.start(kStackingMs);
        }
    });
    stackStopAbove();
}

void HeaderBar::stackStopAbove() {
    if (!stopAbove_) {
        return;
    }
    stacking_.start(stackingWatch_->isActive() ? kStackingCheckMs : kStackingPollMs);
    // The display server puts windows of this type in front of all others, where the button would cover
    // windows of other programs, e.g. the STOP button of another robot. Show only the part that they do not
    // cover, but keep the button above all windows of this program. QWidget::winId() is outdated here,
    // because Qt has created the native window again.
    QList<QWindow*> windows;
    const QWidgetList all = QApplication::topLevelWidgets();
    for (const QWidget* each : all) {
        const Qt::WindowType type = each->windowType();
        if (each->isVisible() && each->windowHandle() != nullptr && type != Qt::Popup &&
            type != Qt::ToolTip) {
            windows.append(each->windowHandle());
        }
    }
    QRegion covered;
    const Stacking stacking = keepAbove(windows, *stopAbove_->windowHandle(), covered);
    if (stacking == Stacking::Unsupported) {
        return;
    }
    const QRegion free = QRegion(stopAbove_->rect()) - covered;
    if (stacking == Stacking::NoneVisible || free.isEmpty()) {
        stopAbove_->hide();
        return;
    }
    if (const QRegion shape = covered.isEmpty() ? QRegion() : free; shape != stopAbove_->mask()) {
        stopAbove_->setMask(shape);
    }
    stopAbove_->show();
}

void HeaderBar::placeStopAbove() {
    if (!stopAbove_) {
        return;
    }
    if (const QPoint place = stop_->mapToGlobal(QPoint(0, 0)); stopAbove_->pos() != place) {
        stopAbove_->move(place);
    }
    if (stopAbove_->size() != stop_->size()) {
        stopAbove_->setFixedSize(stop_->size());
    }
}

bool HeaderBar::eventFilter(QObject* watched, QEvent* event) {
    if (watched == window()) {
        switch (event->type()) {
            case QEvent::WindowBlocked:
                // Show the button later, because the dialog is not visible yet.
                QMetaObject::invokeMethod(this, &HeaderBar::offerStopAbove, Qt::QueuedConnection);
                break;
            case QEvent::WindowUnblocked:
                delete stopAbove_;
                break;
            case QEvent::Move:
            case QEvent::Resize:
                placeStopAbove();
                break;
            default:
                break;
        }
        return QWidget::eventFilter(watched, event);
    }
    if (watched == stop_ && (event->type() == QEvent::Move || event->type() == QEvent::Resize)) {
        placeStopAbove();
        return QWidget::eventFilter(watched, event);
    }
    if (watched == stepButton_ &&
        (event->type() == QEvent::KeyPress || event->type() == QEvent::KeyRelease)) {
        const auto& key = static_cast<const QKeyEvent&>(*event);
        if (key.key() == Qt::Key_Space) {
            return true;  // a user who presses Space wants to stop the arm, not to power it on
        }
        if (event->type() == QEvent::KeyPress &&
            (key.key() == Qt::Key_Return || key.key() == Qt::Key_Enter)) {
            if (!key.isAutoRepeat()) {
                stepButton_->click();
            }
            return true;
        }
    }
    if (event->type() == QEvent::MouseButtonPress || event->type() == QEvent::MouseButtonDblClick ||
        event->type() == QEvent::TouchBegin) {
        keepPlaces();
    }
    return QWidget::eventFilter(watched, event);
}

void HeaderBar::takeStep() {
    if (step_ != NextStep::Connect && step_ != NextStep::Recover) {
        // Disable the button, so that a second click has no effect while the step is in progress.
        keepPlaces();
        offerStep(true, false);
    }
    switch (step_) {
        case NextStep::None:
            break;
        case NextStep::Connect:
            Q_EMIT connectRequested();
            break;
        case NextStep::PowerOn:
            port_.perform(RobotCommand::PowerOn);
            break;
        case NextStep::ReleaseBrakes:
            port_.perform(RobotCommand::ReleaseBrakes);
            break;
        case NextStep::Recover:
            Q_EMIT recoveryRequested();
            break;
        case NextStep::TakeControl:
            port_.takeControl();
            break;
    }
}

void HeaderBar::changeEvent(QEvent* event) {
    if (event->type() == QEvent::StyleChange) {
        showLastStop();  // units may have changed
        showCap(state_.speedCap);
        contentWidths_ = {};
        arrange();  // fonts may have changed
    }
    QWidget::changeEvent(event);
}

void HeaderBar::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    arrange();
}

void HeaderBar::arrange() {
    const int below = cap_->isVisibleTo(this) ? kBannerHeight : 1;
    cap_->setGeometry(0, kHeight, width(), kBannerHeight);
    lastStop_->show();
    // The size is also reduced if the texts of the language need more space.
    const Size largest = width() < kTightBelow    ? Size::Tight
                         : width() < kNarrowBelow ? Size::Narrow
                                                  : Size::Wide;
    for (const Size size : {Size::Wide, Size::Narrow, Size::Tight}) {
        if (size < largest) {
            continue;
        }
        arrange(size, below);
        if (requiredWidth() <= width()) {
            break;
        }
    }
    // In the smallest windows, the texts of some languages need the space of the last-stop chip. The jog
    // column also shows the last stop, but only this chip shows that there is no key-state check.
    const bool hasNote = holdNote_ && !holdNote_().isEmpty();
    if (!hasNote && requiredWidth() > width()) {
        lastStop_->hide();
        layout_->setSpacing(2);
        layout_->invalidate();
    }
    int missing = requiredWidth() - width();
    for (StateChip* chip : {control_, safety_, mode_}) {
        const int cut = std::clamp(missing, 0, std::max(0, chip->minimumWidth() - kLeastStateRoom));
        chip->setRoom(chip->minimumWidth() - cut);
        missing -= cut;
    }
    stepButton_->setText(stepWords(*stepButton_, nextStepText(step_), stepButton_->width()));
}

/// Returns the width that fits all texts, including the simulation label [px].
int HeaderBar::requiredWidth() const {
    const int required = layout_->minimumSize().width() +
                         std::max(0, linkRoom(*link_) - link_->minimumSizeHint().width()) +
                         (lastStop_->isHidden() ? 0
                                                : std::max(0, lastStop_->leastRoom(lastStop_->caption()) -
                                                                  lastStop_->minimumSizeHint().width()));
    return simulation_->isHidden() ? required + simulation_->minimumWidth() + layout_->spacing() : required;
}

void HeaderBar::arrange(Size size, int below) {
    const bool tight = size == Size::Tight;
    layout_->setContentsMargins(tight ? 8 : 16, 0, tight ? 8 : 16, below);
    const auto wide = [size](int least, int middle, int most) {
        return size == Size::Tight ? least : size == Size::Narrow ? middle : most;
    };
    layout_->setSpacing(wide(4, 8, 12));
    for (StateChip* chip : {robot_, mode_, safety_, control_, link_, lastStop_}) {
        chip->setDense(tight);
    }
    name_->setVisible(!tight);
    stop_->setFixedWidth(wide(128, 160, 230));
    // The positions of the buttons do not depend on the texts, so that a second click does not hit a
    // different button. The values to the right of the buttons share the remaining width.
    robot_->setRoom(wide(86, 150, 170));
    simulation_->setFixedWidth(wide(112, 130, 145));
    const auto& [mode, safety, control] = contentWidths(tight);
    mode_->setRoom(std::max(mode, wide(96, 136, 150)));
    safety_->setRoom(std::max(safety, wide(96, 150, 170)));
    control_->setRoom(std::max(control, wide(96, 160, 176)));
    stepButton_->setFixedWidth(stepRoom(*stepButton_, wide(142, 150, 150)));
    speed_->setFixedWidth(wide(118, 130, 140));
    link_->setLeastCharacters(wide(6, 11, 15));
    lastStop_->setLeastCharacters(wide(6, 11, 14));
    layout_->invalidate();
}

const std::array<int, 3>& HeaderBar::contentWidths(bool tight) {
    auto& widths = contentWidths_.at(tight ? 1 : 0);
    if (!widths) {
        const auto widest = [](const StateChip& chip, const std::vector<ModeLook>& looks) {
            int width = 0;
            for (const ModeLook& look : looks) {
                width = std::max(width, chip.minWidth(look.text, look.shape, look.emphasis, look.mark));
            }
            return width;
        };
        widths = {widest(*mode_, robotModeLooks()), widest(*safety_, safetyModeLooks()),
                  widest(*control_, controlLooks())};
    }
    return *widths;
}

void HeaderBar::paintEvent(QPaintEvent*) {
    const Theme& theme = Theme::current();
    QPainter painter(this);
    painter.fillRect(rect(), theme.raised);
    painter.setPen(theme.border);
    painter.drawLine(0, height() - 1, width(), height() - 1);
}

}  // namespace tiller

#include "moc_header_bar.cpp"
