// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/ui/random_user.h"

#include <QApplication>
#include <QClipboard>
#include <QDialog>
#include <QFileDialog>
#include <QKeySequence>
#include <QLineEdit>
#include <QMenu>
#include <QTcpSocket>
#include <QTest>
#include <QThread>
#include <algorithm>
#include <iterator>
#include <utility>

#include "app/action_table.h"
#include "robot/station/jog/jog_motion.h"
#include "tests/support/virtual_cell.h"
#include "tests/ui/step_log.h"
#include "widgets/hold/hold_to_run_button.h"
#include "widgets/jog/jog_column.h"

namespace tiller::test {
namespace {

constexpr int kQuietEvery = 40;  // number of steps
/// Percentage of clicks after which the next step waits for the whole period in which nothing may move.
constexpr int kLongWatch = 1;
/// Percentage of the other clicks after which the next step waits for 10 to 40 ms of this period.
constexpr int kShortWatch = 15;
/// The window is painted only in this percentage of steps, because painting takes most of the time of a step.
constexpr int kPaintedOfHundred = 10;
/// Maximum time from release to standstill [ms]. The limits of the contract are tested in virtual time.
constexpr int kStandstillMs = 1000;
/// Apparent motion of an arm at standstill due to encoder noise [rad].
constexpr double kRestTolerance = 0.0015;
/// Maximum time until a requested robot is connected [ms].
constexpr double kConnectMs = 30'000;
constexpr qint64 kHopelessMs = 90'000;

constexpr QSize kSmallest{1264, 672};
constexpr QSize kLargest{1920, 1080};

struct Fault {
    const char* words;
    const char*
        cure;  ///< command that ends the fault; empty: it ends automatically or the operator must end it
    int weight;
    bool link = false;
};
constexpr Fault kFaults[] = {
    {"link lost", "link back", 6, true},
    {"silence on", "silence off", 3, true},
    {"close-clients", "", 4, true},
    {"half-open", "", 2, true},
    {"delay 20 5", "delay 0", 2, true},
    {"split 7", "split 0", 2, true},
    {"coalesce 10", "coalesce 0", 2, true},
    {"emergency-stop on", "emergency-stop off", 3},
    {"system-emergency-stop on", "system-emergency-stop off", 2},
    {"safeguard on", "safeguard off", 4},
    {"reduced on", "reduced off", 3},
    {"protective-stop", "", 1},
    {"violation", "", 1},
    {"power-loss", "", 1},
    {"script-error", "", 2},
    {"popup Look_here", "close-popup", 2},
    {"speed 0.3", "speed 1", 4},
    {"digital-input 3 on", "digital-input 3 off", 3},
    {"remote off", "remote on", 2},
    {"operational-mode manual", "operational-mode none", 2},
    {"joint-near-limit 4 5", "", 1},
};

struct KeyStroke {
    Qt::Key key;
    Qt::KeyboardModifiers modifiers;
    const char* text;
};
const KeyStroke kStrokes[] = {
    {Qt::Key_Tab, {}, "\t"},
    {Qt::Key_Tab, {}, "\t"},
    {Qt::Key_Backtab, Qt::ShiftModifier, ""},
    {Qt::Key_Escape, {}, "\x1b"},
    {Qt::Key_Escape, {}, "\x1b"},
    {Qt::Key_Return, {}, "\r"},
    {Qt::Key_Return, {}, "\r"},
    {Qt::Key_Enter, Qt::KeypadModifier, "\r"},
    {Qt::Key_Space, {}, " "},
    {Qt::Key_Left, {}, ""},
    {Qt::Key_Right, {}, ""},
    {Qt::Key_Up, {}, ""},
    {Qt::Key_Down, {}, ""},
    {Qt::Key_Down, Qt::AltModifier, ""},
    {Qt::Key_PageUp, {}, ""},
    {Qt::Key_PageDown, {}, ""},
    {Qt::Key_Home, {}, ""},
    {Qt::Key_End, {}, ""},
    {Qt::Key_Delete, {}, "\x7f"},
    {Qt::Key_Backspace, {}, "\b"},
    {Qt::Key_F1, {}, ""},
    {Qt::Key_F2, {}, ""},
    {Qt::Key_F2, {}, ""},
    {Qt::Key_T, {}, "t"},
    {Qt::Key_T, {}, "t"},
    {Qt::Key_U, {}, "u"},
    {Qt::Key_G, {}, "g"},
    {Qt::Key_Z, {}, "z"},
    {Qt::Key_P, {}, "p"},
    {Qt::Key_J, Qt::ControlModifier, ""},
    {Qt::Key_J, Qt::ControlModifier, ""},
    {Qt::Key_K, Qt::ControlModifier, ""},
    {Qt::Key_1, Qt::ControlModifier, ""},
    {Qt::Key_2, Qt::ControlModifier, ""},
    {Qt::Key_3, Qt::ControlModifier, ""},
    {Qt::Key_4, Qt::ControlModifier, ""},
    {Qt::Key_Z, Qt::ControlModifier, ""},
    {Qt::Key_Y, Qt::ControlModifier, ""},
    {Qt::Key_D, Qt::ControlModifier, ""},
    {Qt::Key_A, Qt::ControlModifier, ""},
    {Qt::Key_C, Qt::ControlModifier, ""},
    {Qt::Key_X, Qt::ControlModifier, ""},
    {Qt::Key_Q, Qt::ControlModifier, ""},
    {Qt::Key_S, Qt::ControlModifier | Qt::ShiftModifier, ""},
    {Qt::Key_Comma, Qt::ControlModifier, ""},
    {Qt::Key_Shift, {}, ""},
    {Qt::Key_Control, {}, ""},
};

/// Keys of the armed keyboard with their modifiers.
const KeyStroke kHeldStrokes[] = {
    {Qt::Key_Left, {}, ""},
    {Qt::Key_Right, {}, ""},
    {Qt::Key_Up, {}, ""},
    {Qt::Key_PageUp, {}, ""},
    {Qt::Key_PageDown, Qt::ShiftModifier, ""},
    {Qt::Key_Up, Qt::AltModifier, ""},
    {Qt::Key_1, {}, "1"},
    {Qt::Key_4, {}, "4"},
    {Qt::Key_Plus, {}, "+"},
    {Qt::Key_Minus, {}, "-"},
    {Qt::Key_F, {}, "f"},
    {Qt::Key_G, {}, "g"},
    {Qt::Key_Backspace, {}, "\b"},
    {Qt::Key_Shift, {}, ""},
    {Qt::Key_Control, {}, ""},
};

QStringList texts() {
    return {QStringLiteral("0"),        QStringLiteral("1"),     QStringLiteral("-3.5"),
            QStringLiteral("99"),       QStringLiteral("1e9"),   QStringLiteral("12,5"),
            QStringLiteral("abc"),      QStringLiteral("   "),   QStringLiteral("Gripper 1"),
            QStringLiteral("Größe 東"), QStringLiteral("nan"),   QStringLiteral("x\ty\tz"),
            QStringLiteral("<b>&\"'"),  QStringLiteral("%1 %n"), QStringLiteral("−7")};
}

QStringList clippings() {
    return {QStringLiteral("1\t2\t3\t4\t5\t6"),
            QStringLiteral("P1\tMoveJ\tBase\n"),
            QStringLiteral("p[0.1, -0.4, 0.3, 0, 3.14, 0]"),
            QStringLiteral("-90.0\t-90.0\t-90.0\t-90.0\t90.0\t0.0\nfoo\n"),
            QString(3000, QLatin1Char('9')),
            QString()};
}

bool stands(const simulator::SimulatedState& truth) {
    return truth.tcpSpeed.linear.norm() < 0.001 && truth.qd.values.cwiseAbs().maxCoeff() < 0.002;
}

simulator::SimulatorOptions robotAt(int place) {
    simulator::SimulatorOptions options = VirtualCell::options();
    options.time = simulator::Time::Real;
    const QString address = options.listenAddress;
    options.listenAddress = address.section(QLatin1Char('.'), 0, 2) + QStringLiteral(".%1").arg(1 + place);
    return options;
}

QString buttonName(Qt::MouseButton button) {
    return button == Qt::LeftButton    ? QStringLiteral("left")
           : button == Qt::RightButton ? QStringLiteral("right")
                                       : QStringLiteral("middle");
}

}  // namespace

// ---- waiting ----------------------------------------------------------------------------------------------

WaitTime::WaitTime(const simulator::Simulator& robot) : robot_(robot), began_(robot.truth().timestamp) {
    real_.start();
}

void WaitTime::wait() {
    QTest::qWait(3);
    ++turns_;
}

double WaitTime::ms() const {
    constexpr double kTurnMs = 10;  // longer iterations were delayed by other processes
    const double robot = (robot_.truth().timestamp - began_) * 1000;
    return std::min({static_cast<double>(real_.elapsed()), robot, turns_ * kTurnMs});
}

bool WaitTime::isHopeless() const {
    return real_.elapsed() > kHopelessMs;
}

// ---- start and end ----------------------------------------------------------------------------------------

RandomUser::RandomUser(quint32 seed, int place)
    : random_(seed)
    , robot_(robotAt(place))
    , window_(app::Settings(folder_.filePath(QStringLiteral("settings.ini"))))
    , hand_(window_)
    , truth_(window_) {
    window_.installEventFilter(this);
    // An animated dock would still be moving during the next steps.
    window_.setAnimated(false);
    connect(&visitor_, &QTimer::timeout, this, &RandomUser::visit);
}

RandomUser::~RandomUser() {
    hand_.letGo();
    closeAllDialogs();
    visitor_.stop();
    window_.removeEventFilter(this);
}

bool RandomUser::begin() {
    if (const Result<void> started = robot_.start(); !started) {
        fail(started.error().toString());
        return false;
    }
    // The checks do not cover a second simulated robot.
    if (QAction* another = window_.actions().find(QStringLiteral("robot.simulator"))) {
        another->setEnabled(false);
    }
    window_.setTheme(chance(50) ? QStringLiteral("light") : QStringLiteral("dark"));
    window_.resize(chance(50) ? kSmallest : QSize(1600, 900));
    window_.show();
    window_.activateWindow();
    if (!QTest::qWaitForWindowActive(&window_)) {
        fail(QStringLiteral("the window did not become active"));
        return false;
    }
    window_.openProject(folder_.filePath(QStringLiteral("cell.tiller")));
    window_.connectRobot({QStringLiteral("Random UR5e"), robot_.listenAddress(), 0, true});
    RobotSession& session = window_.session();
    WaitTime waited(robot_);
    bool asked = false;
    while (!session.state().canMove() && waited.ms() < kConnectMs && !waited.isHopeless()) {
        if (session.state().link == LinkState::Live && !asked) {
            asked = true;
            session.takeControl(RobotSession::ForeignProgram::Stop);
        }
        waited.wait();
    }
    if (!session.state().canMove()) {
        fail(QStringLiteral("not in control: ") + session.state().controlReason);
        return false;
    }
    visitor_.start(10);
    return true;
}

void RandomUser::play(int steps) {
    for (int i = 0; i < steps && isFine(); ++i) {
        step();
    }
}

void RandomUser::finish() {
    if (!isFine()) {
        return;
    }
    note(QStringLiteral("end: all faults are cleared"));
    places_.end();
    resting_.reset();
    hand_.letGo();
    closeAllDialogs();
    window_.setUpdatesEnabled(true);
    inject(QStringLiteral("clear"));
    const SessionState& state = window_.session().state();
    WaitTime waited(robot_);
    double nextCare = 0;
    const auto isBack = [&] {
        return state.link == LinkState::Live && state.address == robot_.listenAddress();
    };
    while (!isBack() && waited.ms() < kConnectMs && !waited.isHopeless()) {
        if (waited.ms() >= nextCare) {
            cureAll();
            if (state.link == LinkState::Disconnected || state.address != robot_.listenAddress()) {
                care();
            }
            nextCare += 1000;
        }
        waited.wait();
    }
    if (!isBack()) {
        fail(QStringLiteral("the window does not reconnect to a working robot: ") + state.linkReason);
        return;
    }
    quietMoment();
    if (window_.grab().isNull()) {
        fail(QStringLiteral("the window cannot be painted"));
    }
}

void RandomUser::note(const QString& what) {
    StepLog::add(QStringLiteral("%1  %2").arg(number_, 5).arg(what));
}

void RandomUser::fail(const QString& what) {
    if (failure_.isEmpty()) {
        failure_ = QStringLiteral("step %1: %2").arg(number_).arg(what);
    }
}

/// Prevents the random user from quitting the application.
bool RandomUser::eventFilter(QObject* watched, QEvent* event) {
    if (watched == &window_ && event->type() == QEvent::Close) {
        event->ignore();
        return true;
    }
    return QObject::eventFilter(watched, event);
}

// ---- a step -----------------------------------------------------------------------------------------------

const QList<RandomUser::Act>& RandomUser::acts() {
    static const QList<Act> all = {
        {26, &RandomUser::clickControl},
        {5, &RandomUser::clickPixel},
        {6, &RandomUser::clickAgain},
        {4, &RandomUser::clickOther, true},
        {2, &RandomUser::doubleClick},
        {6, &RandomUser::holdKeyOnScreen},
        {11, &RandomUser::wander, true, true, false},
        {4, &RandomUser::turnWheel, true, false, true},
        {4, &RandomUser::drag},
        {12, &RandomUser::pressKey, true},
        {4, &RandomUser::holdKey, true},
        {4, &RandomUser::typeText},
        {1, &RandomUser::pasteText},
        {2, &RandomUser::resizeWindow, true},
        {2, &RandomUser::letGo, true},
        {3, &RandomUser::wait, true, true, false},
        {5, &RandomUser::faultOrCure, true, true},
        {4, &RandomUser::care, true, true},
    };
    return all;
}

int RandomUser::below(qsizetype count) {
    return count <= 0 ? 0 : random_.bounded(static_cast<int>(count));
}

const RandomUser::Act& RandomUser::drawAct(bool held) {
    int sum = 0;
    for (const Act& act : acts()) {
        sum += !held || act.whileHeld ? act.weight : 0;
    }
    int drawn = below(sum);
    for (const Act& act : acts()) {
        const int weight = !held || act.whileHeld ? act.weight : 0;
        if (drawn < weight) {
            return act;
        }
        drawn -= weight;
    }
    return acts().first();
}

void RandomUser::step() {
    ++number_;
    bringWindowBack();
    endOldDialogs();
    judgeRest();
    if (!isFine()) {
        return;
    }
    const bool painted = number_ % 100 < kPaintedOfHundred;
    if (painted != window_.updatesEnabled()) {
        window_.setUpdatesEnabled(painted);
    }
    if (number_ % kQuietEvery == 0) {
        quietMoment();
        return;
    }
    if (hand_.holdsKey() && chance(30)) {
        note(QStringLiteral("lets a key go"));
        places_.end();
        hand_.keyUp();
    }
    if (hand_.holdsButton() && chance(35)) {
        letGo();
    }
    const Act& act = drawAct(hand_.holdsButton());
    if (!act.keepsWatch) {
        places_.end();
    }
    if (act.mayMoveArm) {
        resting_.reset();
    }
    (this->*act.run)();
    QTest::qWait(below(4));
    judgePlaces();
    stepsInMotion_ += stands(robot_.truth()) ? 0 : 1;
}

void RandomUser::bringWindowBack() {
    if (!window_.isVisible()) {
        window_.show();
    }
    // Activate a window, as a window manager does after the active window was closed.
    if (QApplication::activeWindow() == nullptr && QApplication::activePopupWidget() == nullptr) {
        QWidget* modal = QApplication::activeModalWidget();
        (modal != nullptr ? modal : &window_)->activateWindow();
        QTest::qWait(0);
    }
}

// ---- selection --------------------------------------------------------------------------------------------

QList<QWidget*> RandomUser::windowsInReach() const {
    if (QWidget* popup = QApplication::activePopupWidget()) {
        return {popup};
    }
    const QWidget* modal = QApplication::activeModalWidget();
    QList<QWidget*> found;
    for (QWidget* top : QApplication::topLevelWidgets()) {
        const bool stop = top->objectName() == QLatin1String("stopAboveDialog");
        // In a file dialog, the random user could delete files. See endFileDialog().
        if (!top->isVisible() || top->windowHandle() == nullptr ||
            qobject_cast<QFileDialog*>(top) != nullptr || (top->windowType() == Qt::ToolTip && !stop) ||
            (modal != nullptr && top != modal && !stop)) {
            continue;
        }
        found.append(top);
    }
    return found;
}

QWidget* RandomUser::someWindow() {
    const QList<QWidget*> windows = windowsInReach();
    return windows.isEmpty() ? nullptr : windows[below(windows.size())];
}

std::optional<RandomUser::Target> RandomUser::someControl() {
    QWidget* window = someWindow();
    if (window == nullptr) {
        return std::nullopt;
    }
    QList<QWidget*> controls;
    for (QWidget* widget : window->findChildren<QWidget*>()) {
        // "startSimulator" would connect to a robot whose state is unknown to the checks.
        if (PlacesWatch::isControl(*widget) && widget->isVisible() && widget->window() == window &&
            widget->objectName() != QLatin1String("startSimulator")) {
            controls.append(widget);
        }
    }
    constexpr int kAttempts = 8;
    for (int attempt = 0; attempt < kAttempts && !controls.isEmpty(); ++attempt) {
        QWidget* control = controls[below(controls.size())];
        const QRect seen = control->visibleRegion().boundingRect();
        if (!seen.isEmpty()) {
            const QPoint at = seen.topLeft() + QPoint(below(seen.width()), below(seen.height()));
            return Target{window, control->mapTo(window, at), nameOf(*control)};
        }
    }
    return somePixel();
}

std::optional<RandomUser::Target> RandomUser::somePixel() {
    QWidget* window = someWindow();
    if (window == nullptr) {
        return std::nullopt;
    }
    const QPoint at(below(window->width()), below(window->height()));
    const QWidget* hit = window->childAt(at);
    if (hit != nullptr && hit->objectName() == QLatin1String("startSimulator")) {
        return std::nullopt;
    }
    return Target{window, at, nameOf(hit != nullptr ? *hit : *window)};
}

std::optional<RandomUser::Target> RandomUser::someHoldKey() {
    if (!windowsInReach().contains(&window_)) {
        return std::nullopt;
    }
    QList<HoldToRunButton*> keys;
    for (HoldToRunButton* key : window_.findChildren<HoldToRunButton*>()) {
        if (key->isVisible() && key->window() == &window_ && !key->visibleRegion().isEmpty()) {
            keys.append(key);
        }
    }
    if (keys.isEmpty()) {
        return std::nullopt;
    }
    const HoldToRunButton* key = keys[below(keys.size())];
    return Target{&window_, key->mapTo(&window_, key->rect().center()), nameOf(*key)};
}

// ---- user actions -----------------------------------------------------------------------------------------

void RandomUser::click(const Target& target) {
    if (!target.window) {
        return;
    }
    note(QStringLiteral("clicks %1 at %2,%3 in %4")
             .arg(target.name)
             .arg(target.at.x())
             .arg(target.at.y())
             .arg(nameOf(*target.window)));
    last_ = target;
    places_.begin(*target.window, target.at);
    watchedClicks_ += places_.controlsAtPointer() > 0 ? 1 : 0;
    hand_.click(*target.window, target.at, Qt::LeftButton);
    if (chance(kLongWatch)) {
        watchOn(PlacesWatch::kKeepMs);
    } else if (chance(kShortWatch)) {
        watchOn(10 + below(30));
    }
}

void RandomUser::clickControl() {
    if (const auto target = someControl()) {
        click(*target);
    }
}

void RandomUser::clickPixel() {
    if (const auto target = somePixel()) {
        click(*target);
    }
}

/// Clicks a second time at the same position.
void RandomUser::clickAgain() {
    if (last_ && last_->window && windowsInReach().contains(last_->window.data())) {
        Target again = *last_;
        const QWidget* hit = again.window->childAt(again.at);
        again.name = QStringLiteral("again ") + nameOf(hit != nullptr ? *hit : *again.window);
        click(again);
    }
}

void RandomUser::clickOther() {
    const auto target = someControl();
    if (!target || !target->window) {
        return;
    }
    const Qt::MouseButton button = chance(70) ? Qt::RightButton : Qt::MiddleButton;
    note(QStringLiteral("%1 button on %2").arg(buttonName(button), target->name));
    hand_.click(*target->window, target->at, button);
}

void RandomUser::doubleClick() {
    const auto target = chance(50) ? someControl() : somePixel();
    if (target && target->window) {
        note(QStringLiteral("double clicks %1").arg(target->name));
        hand_.doubleClick(*target->window, target->at, Qt::LeftButton);
    }
}

void RandomUser::holdKeyOnScreen() {
    const auto target = someHoldKey();
    if (!target) {
        return;
    }
    note(QStringLiteral("holds %1").arg(target->name));
    last_ = target;
    places_.begin(window_, target->at);
    const Qt::KeyboardModifiers modifiers = chance(80)   ? Qt::KeyboardModifiers()
                                            : chance(50) ? Qt::KeyboardModifiers(Qt::ShiftModifier)
                                                         : Qt::KeyboardModifiers(Qt::ControlModifier);
    hand_.press(window_, target->at, Qt::LeftButton, modifiers);
    watchOn(20 + below(50));
}

void RandomUser::wander() {
    const auto target = chance(70) ? someControl() : somePixel();
    if (target && target->window) {
        note(QStringLiteral("points at %1").arg(target->name));
        hand_.moveTo(*target->window, target->at);
    }
}

void RandomUser::turnWheel() {
    const auto target = chance(50) ? someControl() : somePixel();
    if (target && target->window) {
        const int notches = below(7) - 3;
        note(QStringLiteral("wheel %1 on %2").arg(notches).arg(target->name));
        hand_.wheel(*target->window, target->at, notches,
                    chance(80) ? Qt::KeyboardModifiers() : Qt::KeyboardModifiers(Qt::ControlModifier));
    }
}

void RandomUser::drag() {
    const auto target = chance(50) ? someControl() : somePixel();
    if (!target || !target->window) {
        return;
    }
    const int reach = chance(50) ? 20 : 400;
    const QPoint by(below(2 * reach) - reach, below(2 * reach) - reach);
    note(QStringLiteral("drags %1 from %2,%3 by %4,%5")
             .arg(target->name)
             .arg(target->at.x())
             .arg(target->at.y())
             .arg(by.x())
             .arg(by.y()));
    hand_.press(*target->window, target->at, Qt::LeftButton);
    const int parts = 2 + below(4);
    for (int part = 1; part <= parts && target->window && hand_.holdsButton(); ++part) {
        hand_.moveTo(*target->window, target->at + by * part / parts);
        QTest::qWait(1);
    }
    hand_.release(Qt::LeftButton);
}

void RandomUser::pressKey() {
    const KeyStroke& stroke = kStrokes[below(static_cast<qsizetype>(std::size(kStrokes)))];
    note(QStringLiteral("key ") + QKeySequence(QKeyCombination(stroke.modifiers, stroke.key)).toString());
    hand_.keyClick(stroke.key, stroke.modifiers, QString::fromLatin1(stroke.text));
}

void RandomUser::holdKey() {
    const KeyStroke& stroke = kHeldStrokes[below(static_cast<qsizetype>(std::size(kHeldStrokes)))];
    note(QStringLiteral("holds key ") +
         QKeySequence(QKeyCombination(stroke.modifiers, stroke.key)).toString());
    hand_.keyDown(stroke.key, stroke.modifiers, QString::fromLatin1(stroke.text));
    QTest::qWait(below(60));
}

void RandomUser::typeText() {
    // A key may close the field.
    const QPointer<QWidget> field = QApplication::focusWidget();
    QStringList choice = texts();
    if (field != nullptr && field->objectName() == QLatin1String("robotHost")) {
        // Use only known robots, because a name would be looked up in the network.
        choice = {robot_.listenAddress(), QStringLiteral("127.0.0.254"), QStringLiteral("my robot")};
        hand_.keyClick(Qt::Key_A, Qt::ControlModifier);
    } else if (chance(40)) {
        hand_.keyClick(Qt::Key_A, Qt::ControlModifier);
    }
    const QString text = choice[below(choice.size())];
    note(QStringLiteral("types \"%1\" into %2")
             .arg(text, field == nullptr ? QStringLiteral("nothing") : nameOf(*field)));
    hand_.type(text);
    if (chance(50)) {
        hand_.keyClick(Qt::Key_Return, {}, QStringLiteral("\r"));
    }
}

void RandomUser::pasteText() {
    const QStringList all = clippings();
    QGuiApplication::clipboard()->setText(all[below(all.size())]);
    note(QStringLiteral("pastes"));
    hand_.keyClick(Qt::Key_V, Qt::ControlModifier);
}

void RandomUser::resizeWindow() {
    const QSize size = chance(25) ? kSmallest
                       : chance(25)
                           ? kLargest
                           : QSize(kSmallest.width() + below(kLargest.width() - kSmallest.width()),
                                   kSmallest.height() + below(kLargest.height() - kSmallest.height()));
    note(QStringLiteral("makes the window %1x%2").arg(size.width()).arg(size.height()));
    places_.end();
    window_.resize(size);
    QTest::qWait(10);
}

void RandomUser::letGo() {
    if (hand_.holdsButton() || hand_.holdsKey()) {
        note(QStringLiteral("lets everything go"));
        places_.end();
        hand_.letGo();
    }
}

void RandomUser::wait() {
    note(QStringLiteral("waits"));
    watchOn(5 + below(40));
}

// ---- events of the robot ----------------------------------------------------------------------------------

void RandomUser::inject(const QString& words) {
    note(QStringLiteral("robot: ") + words);
    resting_.reset();
    if (const Result<QString> done = robot_.inject(words); !done) {
        fail(QStringLiteral("the simulated robot refuses \"%1\": %2").arg(words, done.error().toString()));
    }
}

void RandomUser::cureAll() {
    for (const QString& cure : std::exchange(cures_, {})) {
        inject(cure);
    }
    linkTouched_ = true;
    sinceLinkTouched_.start();
}

void RandomUser::faultOrCure() {
    if (!cures_.isEmpty() && chance(45)) {
        cureAll();
        return;
    }
    int sum = 0;
    for (const Fault& fault : kFaults) {
        sum += fault.weight;
    }
    int drawn = below(sum);
    for (const Fault& fault : kFaults) {
        if (drawn >= fault.weight) {
            drawn -= fault.weight;
            continue;
        }
        if (fault.link) {
            linkTouched_ = true;
            sinceLinkTouched_.start();
        }
        inject(QString::fromLatin1(fault.words));
        const QString cure = QString::fromLatin1(fault.cure);
        if (!cure.isEmpty() && !cures_.contains(cure)) {
            cures_.append(cure);
        }
        return;
    }
}

/// Fixes the first problem found, at the robot or through the session, without clicks or keys.
void RandomUser::care() {
    RobotSession& session = window_.session();
    const SessionState& state = session.state();
    const simulator::SimulatedState truth = robot_.truth();
    if (!cures_.isEmpty()) {
        cureAll();
    } else if (state.link == LinkState::Disconnected || state.address != robot_.listenAddress()) {
        note(QStringLiteral("care: connects"));
        linkTouched_ = true;
        sinceLinkTouched_.start();
        window_.connectRobot({QStringLiteral("Random UR5e"), robot_.listenAddress(), 0, true});
    } else if (truth.safetyMode == SafetyMode::ProtectiveStop) {
        note(QStringLiteral("care: unlocks the protective stop at the pendant"));
        tellPendant("unlock protective stop\n");
    } else if (truth.safetyMode == SafetyMode::Violation || truth.safetyMode == SafetyMode::Fault) {
        note(QStringLiteral("care: restarts safety at the pendant"));
        tellPendant("restart safety\n");
    } else if (truth.robotMode == RobotMode::PowerOff) {
        note(QStringLiteral("care: power on"));
        session.services().perform(RobotCommand::PowerOn);
    } else if (truth.robotMode == RobotMode::Idle) {
        note(QStringLiteral("care: brakes"));
        session.services().perform(RobotCommand::ReleaseBrakes);
    } else if (truth.robotMode == RobotMode::Running && state.link == LinkState::Live &&
               (state.control == ControlState::None || state.control == ControlState::Refused)) {
        note(QStringLiteral("care: takes control"));
        session.takeControl(RobotSession::ForeignProgram::Stop);
    }
}

void RandomUser::tellPendant(const QByteArray& line) {
    auto* socket = new QTcpSocket(this);
    connect(socket, &QTcpSocket::connected, socket, [socket, line] {
        socket->write(line);
        socket->disconnectFromHost();
    });
    connect(socket, &QTcpSocket::disconnected, socket, &QObject::deleteLater);
    connect(socket, &QTcpSocket::errorOccurred, socket, &QObject::deleteLater);
    socket->connectToHost(robot_.listenAddress(), robot_.ports().dashboard);
}

// ---- dialogs ----------------------------------------------------------------------------------------------

void RandomUser::endOldDialogs() {
    const QWidget* modal = QApplication::activeModalWidget();
    QWidget* popup = QApplication::activePopupWidget();
    dialogAge_ = modal != nullptr || popup != nullptr ? dialogAge_ + 1 : 0;
    constexpr int kOldest = 18;
    if (dialogAge_ > kOldest) {
        dialogAge_ = 0;
        closeAllDialogs();
        return;
    }
    const QList<QWidget*> tops = QApplication::topLevelWidgets();
    const auto open = std::count_if(tops.begin(), tops.end(), [](const QWidget* top) {
        return top->isVisible() && qobject_cast<const QDialog*>(top) != nullptr;
    });
    if (open > 2 || (open > 0 && chance(2))) {
        closeAllDialogs();
    }
}

void RandomUser::closeAllDialogs() {
    places_.end();
    for (int guard = 0; guard < 20 && QApplication::activePopupWidget() != nullptr; ++guard) {
        QApplication::activePopupWidget()->close();
    }
    QList<QPointer<QDialog>> open;
    for (QWidget* top : QApplication::topLevelWidgets()) {
        if (auto* dialog = qobject_cast<QDialog*>(top); dialog != nullptr && dialog->isVisible()) {
            open.append(dialog);
        }
    }
    for (const QPointer<QDialog>& dialog : open) {
        if (dialog) {
            note(QStringLiteral("closes ") + nameOf(*dialog));
            dialog->reject();
        }
    }
}

/// Called by a timer. Does not call endNestedLoop() directly, because that function may open the next dialog
/// with its own event loop, and a timer does not fire again before its event has been handled.
void RandomUser::visit() {
    if (QThread::currentThread()->loopLevel() == 0) {
        stuck_ = 0;
        return;
    }
    QMetaObject::invokeMethod(this, &RandomUser::endNestedLoop, Qt::QueuedConnection);
}

/// Nested event loops (file dialog, some menus, dragging a row) block the step. This function runs inside
/// such a loop and ends it.
void RandomUser::endNestedLoop() {
    if (QThread::currentThread()->loopLevel() == 0) {
        return;  // the nested loop has ended in the meantime
    }
    places_.end();
    ++stuck_;
    constexpr int kStuckTicks = 3000;
    if (stuck_ > kStuckTicks) {
        qFatal("an event loop inside a step does not end\n%s", qPrintable(StepLog::text()));
    }
    QWidget* popup = QApplication::activePopupWidget();
    QWidget* modal = QApplication::activeModalWidget();
    if (popup != nullptr) {
        auto* menu = qobject_cast<QMenu*>(popup);
        if (menu != nullptr && !menu->actions().isEmpty() && stuck_ < 5 && chance(50)) {
            const QList<QAction*> all = menu->actions();
            QAction* action = all[below(all.size())];
            note(QStringLiteral("  menu: ") + action->text());
            hand_.click(*menu, menu->actionGeometry(action).center(), Qt::LeftButton);
        } else {
            note(QStringLiteral("  menu: closes"));
            popup->close();
        }
    } else if (qobject_cast<QFileDialog*>(modal) != nullptr) {
        endFileDialog();
    } else if (auto* dialog = qobject_cast<QDialog*>(modal)) {
        const bool accept = chance(50) && stuck_ < 5;
        note(QStringLiteral("  %1 %2").arg(accept ? QStringLiteral("accepts") : QStringLiteral("rejects"),
                                           nameOf(*dialog)));
        if (accept) {
            dialog->accept();
        } else {
            dialog->reject();
        }
    } else if (hand_.holdsButton()) {
        note(QStringLiteral("  drops what it drags"));
        hand_.letGo();
    } else {
        hand_.keyClick(Qt::Key_Escape);
    }
}

void RandomUser::endFileDialog() {
    auto* dialog = qobject_cast<QFileDialog*>(QApplication::activeModalWidget());
    if (chance(60) && stuck_ < 5) {
        const QString file = QStringLiteral("random-%1").arg(below(3));
        note(QStringLiteral("  file dialog: accepts ") + file);
        dialog->setDirectory(folder_.path());
        dialog->selectFile(folder_.filePath(file));
        static_cast<QDialog*>(dialog)->accept();
    } else {
        note(QStringLiteral("  file dialog: cancels"));
        dialog->reject();
    }
}

// ---- checks -----------------------------------------------------------------------------------------------

void RandomUser::judgePlaces() {
    if (!places_.isOn()) {
        return;
    }
    if (const QStringList moved = places_.moved(); !moved.isEmpty()) {
        fail(moved.join(QStringLiteral("; ")));
        places_.end();
    }
}

void RandomUser::watchOn(int ms) {
    QElapsedTimer since;
    since.start();
    while (since.elapsed() < ms && isFine()) {
        QTest::qWait(5);
        judgePlaces();
    }
}

void RandomUser::judgeRest() {
    if (!resting_) {
        return;
    }
    const double way = (robot_.truth().q.values - resting_->values).cwiseAbs().maxCoeff();
    if (way > kRestTolerance) {
        fail(QStringLiteral("the arm has moved by %1 rad since the release and the standstill").arg(way));
    }
}

bool RandomUser::comesToRest() {
    const QList<HoldToRunButton*> keys = window_.findChildren<HoldToRunButton*>();
    const bool stepRuns =
        std::any_of(keys.begin(), keys.end(), [](const HoldToRunButton* key) { return key->isHolding(); });
    const JogSelection selection = window_.jogColumn().selection();
    if ((stepRuns || window_.jogColumn().isHolding()) &&
        (stepRunsToEnd(selection, false) || stepRunsToEnd(selection, true))) {
        // A short step needs no held button. It runs to its end or until it is stopped.
        note(QStringLiteral("ends a short step by Esc"));
        hand_.keyClick(Qt::Key_Escape, {}, QStringLiteral("\x1b"));
    }
    WaitTime waited(robot_);
    constexpr int kReadings = 3;
    for (int still = 0; still < kReadings;) {
        if (waited.ms() > kStandstillMs || waited.isHopeless()) {
            return false;
        }
        waited.wait();
        still = stands(robot_.truth()) ? still + 1 : 0;
    }
    return true;
}

int RandomUser::graceOf(const Lie& lie) const {
    constexpr int kAfterLinkMs = 3000;
    const bool disturbed = linkTouched_ && sinceLinkTouched_.elapsed() < kAfterLinkMs;
    return lie.graceMs + (disturbed ? TruthCheck::kStaleMs + TruthCheck::kGraceMs : 0);
}

void RandomUser::judgeTruth() {
    WaitTime waited(robot_);
    while (isFine()) {
        const simulator::SimulatedState truth = robot_.truth();
        // A window that is connected to another robot is not checked.
        const SessionState& state = window_.session().state();
        if (state.link != LinkState::Disconnected && state.address != robot_.listenAddress()) {
            return;
        }
        const QList<Lie> lies = truth_.lies(truth, stands(truth));
        if (lies.isEmpty()) {
            return;
        }
        const bool hopeless = waited.isHopeless();
        for (const Lie& lie : lies) {
            if (hopeless || waited.ms() > graceOf(lie)) {
                fail(QStringLiteral("%1 ms after everything came to rest: %2")
                         .arg(waited.ms(), 0, 'f', 0)
                         .arg(lie.text));
            }
        }
        waited.wait();
    }
}

void RandomUser::quietMoment() {
    note(QStringLiteral("quiet moment"));
    places_.end();
    resting_.reset();
    hand_.letGo();
    if (!comesToRest()) {
        fail(QStringLiteral("nothing is held, and the arm does not come to a standstill"));
        return;
    }
    resting_ = robot_.truth().q;
    judgeTruth();
    judgeRest();
}

}  // namespace tiller::test
