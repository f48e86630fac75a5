// SPDX-License-Identifier: GPL-3.0-or-later
#include <QApplication>
#include <QMenu>
#include <QMouseEvent>
#include <QPushButton>
#include <QSignalSpy>
#include <QTest>
#include <QTranslator>
#include <QWheelEvent>

#include "tests/support/pictures.h"
#include "widgets/common/state_chip.h"
#include "widgets/common/theme.h"
#include "widgets/status/header_bar.h"
#include "widgets/status/simulation_chip.h"
#include "widgets/status/speed_chip.h"
#include "widgets/status/status_line.h"
#include "widgets/status/stop_button.h"

// Outside all namespaces, because the macro declares a function of generated code.
static void initTranslations() {
    Q_INIT_RESOURCE(tiller_translations);
}

using namespace tiller;
using namespace tiller::test;
using control::StopCause;

namespace {

struct FakeSession {
    QStringList asked;
    QList<StopCause> stops;
    QList<double> speeds;
    bool asks = false;

    HeaderPort port() {
        return {.perform = [this](RobotCommand command) { asked << commandText(command).toLower(); },
                .takeControl = [this] { asked << QStringLiteral("take control"); },
                .setSpeedSlider = [this](double fraction) { speeds << fraction; },
                .asksBeforeSlider = [this] { return asks; },
                .stop = [this](StopCause cause) { stops << cause; }};
    }
};

SessionState movingState() {
    SessionState state;
    state.link = LinkState::Live;
    state.robotName = QStringLiteral("Lab UR5e");
    state.address = QStringLiteral("192.168.0.10");
    state.simulated = true;
    state.robotMode = RobotMode::Running;
    state.safetyMode = SafetyMode::Normal;
    state.remoteControl = true;
    state.control = ControlState::InControl;
    state.moving = true;
    state.jogActive = true;
    state.speedFraction = 0.35;
    state.quality.rateHz = 500;
    state.quality.roundTripMs = 4.0;
    state.lastStop = {StopCause::Released, 62, 3.1, 1};
    state.sequence = 1;
    return state;
}

SessionState longestState() {
    SessionState state = movingState();
    state.moving = false;
    state.jogActive = false;
    state.control = ControlState::None;
    state.quality.recent = {5000, 12345, 678};
    state.quality.roundTripMs = 104.2;
    state.lastStop = {StopCause::Released, 1062, 103.1, 1};
    state.robotName = QStringLiteral("UR10e at the far end of hall 12");
    return state;
}

QString placesOf(const HeaderBar& header) {
    QStringList places;
    for (const QWidget* child : header.findChildren<QWidget*>(QString(), Qt::FindDirectChildrenOnly)) {
        if (child->isVisible()) {
            places << QStringLiteral("%1 %2+%3").arg(child->objectName()).arg(child->x()).arg(child->width());
        }
    }
    return places.join(QStringLiteral(", "));
}

}  // namespace

class TestHeaderBar : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() {
        initTranslations();
        applyTheme(*qApp, Theme::light());
    }

    void showsTheStateConfirmedByTheRobot() {
        FakeSession session;
        HeaderBar header(session.port());
        header.resize(1920, HeaderBar::kHeight);
        header.show();
        header.applyState(movingState());
        const auto text = [&header](const char* name) {
            return header.findChild<StateChip*>(QLatin1String(name))->text();
        };
        QCOMPARE(text("robotChip"), QStringLiteral("Lab UR5e"));
        QCOMPARE(text("robotModeChip"), QStringLiteral("MOVING"));
        QCOMPARE(text("safetyChip"), QStringLiteral("Normal"));
        QCOMPARE(text("controlChip"), QStringLiteral("Remote · Jog"));
        QCOMPARE(text("linkChip"), QStringLiteral("500 Hz · 4.0 ms"));
        QCOMPARE(text("lastStopChip"), QStringLiteral("62 ms · 3.1 mm"));
        QCOMPARE(header.findChild<SpeedChip*>()->value(), 35);
    }

    void unobservedStopHasNoValue() {
        FakeSession session;
        HeaderBar header(session.port());
        SessionState state = movingState();
        state.lastStopSeen = false;
        header.applyState(state);
        QCOMPARE(header.findChild<StateChip*>("lastStopChip")->text(), QStringLiteral("Not measured"));
        // A program was stopped on the robot.
        state.unmeasuredStop = {control::StopCause::None, control::UnmeasuredStop::Reason::OtherProgram, 1};
        header.applyState(state);
        QCOMPARE(header.findChild<StateChip*>("lastStopChip")->text(), QStringLiteral("Not measured"));
        QVERIFY(header.findChild<StateChip*>("lastStopChip")->toolTip().contains("stopped on the robot"));
        state.unmeasuredStop.reason = control::UnmeasuredStop::Reason::NotStopped;
        header.applyState(state);
        QCOMPARE(header.findChild<StateChip*>("lastStopChip")->text(), QStringLiteral("Not stopped"));
        state.lastStopSeen = true;
        header.applyState(state);
        QCOMPARE(header.findChild<StateChip*>("lastStopChip")->text(), QStringLiteral("62 ms · 3.1 mm"));
    }

    void everyModeIsShownInItsChip() {
        FakeSession session;
        HeaderBar header(session.port());
        SessionState state = movingState();
        state.moving = false;
        for (int mode = -1; mode <= 8; ++mode) {
            state.robotMode = static_cast<RobotMode>(mode);
            header.applyState(state);
            const auto* chip = header.findChild<StateChip*>(QStringLiteral("robotModeChip"));
            QCOMPARE(chip->text(), robotModeLook(state.robotMode, false).text);
            QCOMPARE(chip->shape(), robotModeLook(state.robotMode, false).shape);
        }
        for (const SafetyStatus status : safetyStatuses()) {
            state.safetyMode = status;
            header.applyState(state);
            const auto* chip = header.findChild<StateChip*>(QStringLiteral("safetyChip"));
            QCOMPARE(chip->text(), safetyModeLook(state.safetyMode).text);
            QCOMPARE(chip->emphasis(), safetyModeLook(state.safetyMode).emphasis);
        }
    }

    void withoutDataNoModeIsShown() {
        FakeSession session;
        HeaderBar header(session.port());
        SessionState state = movingState();
        state.link = LinkState::Lost;
        header.applyState(state);
        QCOMPARE(header.findChild<StateChip*>(QStringLiteral("robotModeChip"))->text(),
                 QStringLiteral("NO DATA"));
        QCOMPARE(header.findChild<StateChip*>(QStringLiteral("safetyChip"))->text(),
                 QStringLiteral("NO DATA"));
        QCOMPARE(header.findChild<StateChip*>(QStringLiteral("linkChip"))->emphasis(),
                 StateChip::Emphasis::Alarm);
    }

    void simulationSignIsShownOnlyWhenSimulated() {
        FakeSession session;
        HeaderBar header(session.port());
        header.show();
        SessionState state = movingState();
        header.applyState(state);
        QVERIFY(header.findChild<SimulationChip*>()->isVisible());
        state.link = LinkState::Lost;
        header.applyState(state);
        QVERIFY(header.findChild<SimulationChip*>()->isVisible());
        state.simulated = false;
        header.applyState(state);
        QVERIFY(!header.findChild<SimulationChip*>()->isVisible());
    }

    void oneButtonPerformsTheNextStep_data() {
        QTest::addColumn<RobotMode>("mode");
        QTest::addColumn<SafetyMode>("safety");
        QTest::addColumn<QString>("asked");
        QTest::newRow("power") << RobotMode::PowerOff << SafetyMode::Normal << QStringLiteral("power on");
        QTest::newRow("brakes") << RobotMode::Idle << SafetyMode::Normal << QStringLiteral("release brakes");
        QTest::newRow("control") << RobotMode::Running << SafetyMode::Normal
                                 << QStringLiteral("take control");
    }
    void oneButtonPerformsTheNextStep() {
        QFETCH(RobotMode, mode);
        QFETCH(SafetyMode, safety);
        QFETCH(QString, asked);
        FakeSession session;
        HeaderBar header(session.port());
        header.show();
        SessionState state = movingState();
        state.control = ControlState::None;
        state.robotMode = mode;
        state.safetyMode = safety;
        header.applyState(state);
        QVERIFY(session.asked.isEmpty());  // nothing is sent without an action by the operator
        auto* button = header.findChild<QPushButton*>(QStringLiteral("nextStepButton"));
        QVERIFY(button->isVisible());
        QTest::mouseClick(button, Qt::LeftButton);
        QCOMPARE(session.asked, QStringList{asked});
    }

    // An operator who presses Space wants to stop the arm.
    void spaceNeverPerformsTheNextStep() {
        FakeSession session;
        HeaderBar header(session.port());
        header.show();
        SessionState state = movingState();
        state.control = ControlState::None;
        state.robotMode = RobotMode::PowerOff;
        header.applyState(state);
        auto* button = header.findChild<QPushButton*>(QStringLiteral("nextStepButton"));
        button->setFocus();
        QTest::keyClick(button, Qt::Key_Space);
        QVERIFY(session.asked.isEmpty());
        QTest::keyClick(button, Qt::Key_Return);
        QCOMPARE(session.asked, QStringList{QStringLiteral("power on")});
    }

    void anAutomaticStepChangeRemovesTheFocus() {
        FakeSession session;
        HeaderBar header(session.port());
        header.show();
        header.activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(&header));
        SessionState state = movingState();
        state.control = ControlState::None;
        header.applyState(state);
        auto* button = header.findChild<QPushButton*>(QStringLiteral("nextStepButton"));
        button->setFocus();
        QVERIFY(button->hasFocus());
        state.robotMode = RobotMode::PowerOff;
        header.applyState(state);
        QVERIFY(button->isVisible() && !button->hasFocus());
    }

    void stopActsOnTheFirstClickWhileAMenuIsOpen() {
        FakeSession session;
        HeaderBar header(session.port());
        header.show();
        header.applyState(movingState());
        auto* stop = header.findChild<StopButton*>();
        QMenu menu;
        for (int i = 0; i < 8; ++i) {
            menu.addAction(QStringLiteral("Record everything"));
        }
        // At this position, the menu would cover the lower half of STOP.
        menu.popup(stop->mapToGlobal(QPoint(stop->width() / 2, stop->height() / 2)));
        const QRect place(stop->mapToGlobal(QPoint(0, 0)), stop->size());
        QVERIFY2(!menu.geometry().intersects(place), "the menu covers STOP");
        const QPointF at(place.center());
        QMouseEvent press(QEvent::MouseButtonPress, menu.mapFromGlobal(at), at, Qt::LeftButton,
                          Qt::LeftButton, Qt::NoModifier);
        QCoreApplication::sendEvent(&menu, &press);
        QCOMPARE(session.stops, QList<StopCause>{StopCause::StopButton});
    }

    // A single key press must not make the arm fifty times faster.
    void theSpeedSliderIgnoresKeysWithLargeSteps() {
        FakeSession session;
        HeaderBar header(session.port());
        header.show();
        SessionState state = movingState();
        state.speedFraction = 0.02;
        header.applyState(state);
        auto* slider = header.findChild<SpeedChip*>();
        QVERIFY(!(slider->focusPolicy() & Qt::ClickFocus));
        for (const Qt::Key key : {Qt::Key_End, Qt::Key_PageUp, Qt::Key_Home, Qt::Key_PageDown}) {
            QTest::keyClick(slider, key);
        }
        QVERIFY(session.speeds.isEmpty());
        QTest::keyClick(slider, Qt::Key_Right);
        QCOMPARE(session.speeds.size(), 1);
    }

    void aStopOffersOnlyTheRecoveryPage() {
        FakeSession session;
        HeaderBar header(session.port());
        header.show();
        QSignalSpy recovery(&header, &HeaderBar::recoveryRequested);
        SessionState state = movingState();
        state.control = ControlState::None;
        for (const SafetyStatus status : safetyStatuses()) {
            if (allowsMotion(status)) {
                continue;
            }
            state.safetyMode = status;
            header.applyState(state);
            QTest::mouseClick(header.findChild<QPushButton*>(QStringLiteral("nextStepButton")),
                              Qt::LeftButton);
            QCOMPARE(recovery.size(), 1);
            QTest::mouseClick(header.findChild<StateChip*>(QStringLiteral("safetyChip")), Qt::LeftButton);
            QCOMPARE(recovery.size(), 2);
            recovery.clear();
        }
        QVERIFY(session.asked.isEmpty());
    }

    void controlIsNotOfferedInAGatedLocalMode() {
        FakeSession session;
        HeaderBar header(session.port());
        header.show();
        SessionState state = movingState();
        state.control = ControlState::None;
        state.remoteControl = false;
        header.applyState(state);
        auto* button = header.findChild<QPushButton*>(QStringLiteral("nextStepButton"));
        QVERIFY2(button->isEnabled(),
                 "the button is disabled, although remote control may be disabled on the robot and Local "
                 "then accepts commands");
        state.remoteNeeded = true;
        header.applyState(state);
        QVERIFY(button->isVisible() && !button->isEnabled());
        QVERIFY2(button->toolTip().contains(QStringLiteral("Switch the robot to Remote")),
                 qPrintable(button->toolTip()));
        QTest::mouseClick(button, Qt::LeftButton);
        QVERIFY(session.asked.isEmpty());
        state.remoteNeeded = false;
        state.remoteControl = true;
        header.applyState(state);
        QTRY_VERIFY_WITH_TIMEOUT(button->isVisible() && button->isEnabled(), 60'000);
    }

    void noStepButtonIsShownInControl() {
        FakeSession session;
        HeaderBar header(session.port());
        header.show();
        header.applyState(movingState());
        QVERIFY(!header.findChild<QPushButton*>(QStringLiteral("nextStepButton"))->isVisible());
    }

    void stopActsOnThePress() {
        FakeSession session;
        HeaderBar header(session.port());
        header.show();
        auto* stop = header.findChild<StopButton*>();
        QTest::mousePress(stop, Qt::LeftButton);
        QCOMPARE(session.stops, QList<StopCause>{StopCause::StopButton});
        QTest::mouseRelease(stop, Qt::LeftButton);
        QCOMPARE(session.stops.size(), 1);
        QTest::mousePress(stop, Qt::RightButton);
        QCOMPARE(session.stops.size(), 2);
        QVERIFY(stop->toolTip().startsWith(
            QStringLiteral("Software stop. Not an emergency stop. Power stays on.\n")));
    }

    void stopRespondsToTouch() {
        FakeSession session;
        HeaderBar header(session.port());
        header.resize(1920, HeaderBar::kHeight);
        header.show();
        const std::unique_ptr<QPointingDevice> screen(QTest::createTouchDevice());
        auto* stop = header.findChild<StopButton*>();
        QTest::touchEvent(&header, screen.get()).press(0, QPoint(20, 20), stop);
        QCOMPARE(session.stops, QList<StopCause>{StopCause::StopButton});
        QTest::touchEvent(&header, screen.get()).release(0, QPoint(20, 20), stop);
        QCOMPARE(session.stops.size(), 1);
    }

    /// Presses at x, drags by the given number of pixels and releases.
    static void draw(QWidget* slider, int x, int by) {
        QTest::mousePress(slider, Qt::LeftButton, {}, QPoint(x, 30));
        QTest::mouseMove(slider, QPoint(x + by, 30));
        QTest::mouseRelease(slider, Qt::LeftButton, {}, QPoint(x + by, 30));
    }
    void sliderStaysAboveTwoPercentAndIgnoresTheWheel() {
        FakeSession session;
        HeaderBar header(session.port());
        header.resize(1920, HeaderBar::kHeight);
        header.show();
        header.applyState(movingState());
        auto* slider = header.findChild<SpeedChip*>();
        QVERIFY(session.speeds.isEmpty());  // reported values are not sent back
        draw(slider, 100, -slider->width());
        QCOMPARE(session.speeds, QList<double>{0.02});
        draw(slider, 10, slider->width());
        QCOMPARE(session.speeds.last(), 1.0);
        QWheelEvent wheel(QPointF(40, 30), slider->mapToGlobal(QPointF(40, 30)), QPoint(), QPoint(0, -120),
                          Qt::NoButton, Qt::NoModifier, Qt::NoScrollPhase, false);
        QApplication::sendEvent(slider, &wheel);
        QCOMPARE(session.speeds.size(), 2);
    }

    // The operator confirms one value, not each position of the slider.
    void theSliderIsSentOnceWhenTheOperatorMustConfirm() {
        FakeSession session;
        session.asks = true;
        HeaderBar header(session.port());
        header.resize(1920, HeaderBar::kHeight);
        header.show();
        header.applyState(movingState());
        auto* slider = header.findChild<SpeedChip*>();
        QTest::mousePress(slider, Qt::LeftButton, {}, QPoint(60, 30));
        QTest::mouseMove(slider, QPoint(70, 30));
        QTest::mouseMove(slider, QPoint(60 + slider->width(), 30));
        QVERIFY(session.speeds.isEmpty());
        QTest::mouseRelease(slider, Qt::LeftButton, {}, QPoint(60 + slider->width(), 30));
        QCOMPARE(session.speeds, QList<double>{1.0});
    }

    // A misplaced click must not change the speed of the robot.
    void aClickAloneDoesNotMoveTheSlider() {
        FakeSession session;
        HeaderBar header(session.port());
        header.resize(1920, HeaderBar::kHeight);
        header.show();
        header.applyState(movingState());
        auto* slider = header.findChild<SpeedChip*>();
        for (const int x : {3, slider->width() / 2, slider->width() - 3}) {
            QTest::mouseClick(slider, Qt::LeftButton, {}, QPoint(x, 30));
            QTest::mouseDClick(slider, Qt::LeftButton, {}, QPoint(x, 30));
        }
        QVERIFY(session.speeds.isEmpty());
        QCOMPARE(slider->value(), 35);
        QVERIFY(slider->hasFocus() || !slider->isActiveWindow());
        QTest::keyClick(slider, Qt::Key_Up);
        QCOMPARE(session.speeds, QList<double>{0.36});
    }

    // Power on, Release brakes, Take control: the second click is at the position of the first click.
    void secondClickHitsTheSameButton_data() {
        QTest::addColumn<int>("width");
        for (const int width : {1264, 1280, 1366, 1600, 1850, 1920}) {
            QTest::newRow(QByteArray::number(width).constData()) << width;
        }
    }
    void secondClickHitsTheSameButton() {
        QFETCH(int, width);
        FakeSession session;
        HeaderBar header(session.port());
        header.resize(width, HeaderBar::kHeight);
        header.show();
        SessionState state = movingState();
        state.moving = state.jogActive = false;
        state.control = ControlState::None;
        state.robotMode = RobotMode::PowerOff;
        header.applyState(state);
        QCoreApplication::processEvents();
        auto* button = header.findChild<QPushButton*>(QStringLiteral("nextStepButton"));
        const auto places = [&header] {
            QList<QRect> rects;
            for (QWidget* child : header.findChildren<QWidget*>(QString(), Qt::FindDirectChildrenOnly)) {
                rects << child->geometry();
            }
            return rects;
        };
        const QList<QRect> before = places();
        const QPoint hand = button->geometry().center();
        QTest::mouseClick(button, Qt::LeftButton);
        QCOMPARE(session.asked, QStringList{QStringLiteral("power on")});
        // The robot follows immediately, the captions become longer, and the next step is shown.
        for (const RobotMode mode : {RobotMode::Booting, RobotMode::Idle, RobotMode::Running}) {
            state.robotMode = mode;
            state.control = mode == RobotMode::Running ? ControlState::InControl : ControlState::None;
            header.applyState(state);
            QCoreApplication::processEvents();
            QCOMPARE(places(), before);
            QWidget* under = header.childAt(hand);
            QVERIFY(under == button);
            QTest::mouseClick(under, Qt::LeftButton);
        }
        QCOMPARE(session.asked.size(), 1);
        QVERIFY(session.speeds.isEmpty());
        // Half a second later, all widgets are in their final state.
        QTRY_VERIFY_WITH_TIMEOUT(!button->isVisible(), 60'000);
        state.control = ControlState::None;
        header.applyState(state);
        QTRY_VERIFY_WITH_TIMEOUT(button->isVisible() && button->isEnabled(), 60'000);
        QCOMPARE(button->text(), nextStepText(NextStep::TakeControl));
    }

    // Each button keeps its position permanently, even long after a click.
    void buttonsKeepTheirPositionsForAllTexts_data() { secondClickHitsTheSameButton_data(); }
    void buttonsKeepTheirPositionsForAllTexts() {
        QFETCH(int, width);
        FakeSession session;
        HeaderBar header(session.port());
        header.resize(width, HeaderBar::kHeight);
        header.show();
        QHash<QString, QRect> places;
        const auto compare = [&](const SessionState& state) {
            header.applyState(state);
            QCoreApplication::processEvents();
            for (const char* name : {"robotChip", "robotModeChip", "safetyChip", "controlChip",
                                     "nextStepButton", "speedSlider", "stopButton"}) {
                const auto* key = header.findChild<QWidget*>(QLatin1String(name));
                QVERIFY2(key != nullptr, name);
                if (!places.contains(QLatin1String(name))) {
                    places.insert(QLatin1String(name), key->geometry());
                }
                QVERIFY2(places.value(QLatin1String(name)) == key->geometry(), name);
            }
        };
        SessionState state = movingState();
        compare(state);
        for (const RobotMode mode :
             {RobotMode::PowerOff, RobotMode::Booting, RobotMode::Idle, RobotMode::Running}) {
            for (const ControlState control :
                 {ControlState::None, ControlState::Taking, ControlState::InControl}) {
                state.moving = state.jogActive = false;
                state.robotMode = mode;
                state.control = control;
                compare(state);
            }
        }
        state = longestState();
        state.simulated = true;
        compare(state);
        state.safetyMode = SafetyMode::ProtectiveStop;
        state.quality.recent = {5000, 1200, 12};
        compare(state);
    }

    // A disabled button normally passes its focus on, in this case to the speed slider.
    void theFocusDoesNotMoveFromTheButtonToTheSlider() {
        FakeSession session;
        HeaderBar header(session.port());
        header.resize(1280, HeaderBar::kHeight);
        header.show();
        header.activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(&header));
        SessionState state = movingState();
        state.moving = state.jogActive = false;
        state.control = ControlState::None;
        state.robotMode = RobotMode::PowerOff;
        header.applyState(state);
        auto* button = header.findChild<QPushButton*>(QStringLiteral("nextStepButton"));
        button->setFocus();
        QVERIFY(button->hasFocus());
        QTest::keyClick(button, Qt::Key_Return);
        QCOMPARE(session.asked.size(), 1);
        QVERIFY(header.focusWidget() == nullptr || header.focusWidget() == button);
        state.robotMode = RobotMode::Running;
        state.control = ControlState::InControl;
        header.applyState(state);
        QTRY_VERIFY_WITH_TIMEOUT(!button->isVisible(), 60'000);
        QVERIFY(header.focusWidget() == nullptr);
        state.control = ControlState::None;
        header.applyState(state);
        QTRY_VERIFY2_WITH_TIMEOUT(button->hasFocus(), "the focus was not restored", 60'000);
    }

    void draggingTakesPrecedenceOverReceivedValues() {
        SpeedChip slider;
        slider.resize(230, 47);
        slider.setReported(0.35, true);
        QTest::mousePress(&slider, Qt::LeftButton, {}, QPoint(80, 30));
        QTest::mouseMove(&slider, QPoint(111, 30));
        QCOMPARE(slider.value(), 50);
        slider.setReported(0.35, true);
        QCOMPARE(slider.value(), 50);
        QTest::mouseRelease(&slider, Qt::LeftButton, {}, QPoint(111, 30));
        slider.setReported(0.50, true);  // the robot has followed
        slider.setReported(0.20, true);  // changed on the teach pendant
        QCOMPARE(slider.value(), 20);
    }

    void robotChipOpensTheConnection() {
        FakeSession session;
        HeaderBar header(session.port());
        header.show();
        QSignalSpy asked(&header, &HeaderBar::menuRequested);
        QTest::mouseClick(header.menuChip(HeaderBar::Menu::Robot), Qt::LeftButton);
        QCOMPARE(asked.count(), 1);
    }

    void everythingFitsAtEveryWidth_data() {
        QTest::addColumn<int>("width");
        for (const int width : {1264, 1280, 1366, 1440, 1600, 1700, 1850, 1920, 2560}) {
            QTest::newRow(QByteArray::number(width).constData()) << width;
        }
    }
    void everythingFitsAtEveryWidth() {
        QFETCH(int, width);
        FakeSession session;
        HeaderBar header(session.port());
        header.resize(width, HeaderBar::kHeight);
        header.show();
        for (const SafetyMode safety :
             {SafetyMode::Normal, SafetyMode::SystemThreePositionEnablingStop, SafetyMode::ProtectiveStop}) {
            SessionState state = longestState();
            state.safetyMode = safety;
            header.applyState(state);
            QCoreApplication::processEvents();
            QCOMPARE(header.width(), width);
            QRect before;
            for (QWidget* child : header.findChildren<QWidget*>(QString(), Qt::FindDirectChildrenOnly)) {
                if (!child->isVisible()) {
                    continue;
                }
                QVERIFY2(header.rect().contains(child->geometry()), qPrintable(child->objectName()));
                QVERIFY2(child->width() >= child->minimumSizeHint().width(),
                         qPrintable(QStringLiteral("%1: %2 of %3 px")
                                        .arg(child->objectName())
                                        .arg(child->width())
                                        .arg(child->minimumSizeHint().width())));
                QVERIFY2(!before.intersects(child->geometry()), qPrintable(child->objectName()));
                before = child->geometry();
            }
        }
    }

    void commonTextsAreCompleteInTheSmallestWindow() {
        FakeSession session;
        HeaderBar header(session.port());
        header.resize(1264, HeaderBar::kHeight);
        header.show();
        for (const bool moving : {false, true}) {
            SessionState state = movingState();
            state.robotName = QStringLiteral("Virtual UR10e");
            state.moving = state.jogActive = moving;
            header.applyState(state);
            QCoreApplication::processEvents();
            for (const StateChip* chip : header.findChildren<StateChip*>()) {
                QVERIFY2(!chip->isVisible() || chip->isWhole(),
                         qPrintable(QStringLiteral("%1: %2").arg(chip->objectName(), chip->text())));
            }
        }
    }

    // The texts do not overlap in any language.
    void everyModeIsShownInFull_data() {
        QTest::addColumn<QString>("language");
        QTest::addColumn<int>("width");
        for (const char* language : {"en", "de", "es", "fr", "ja", "zh_CN"}) {
            for (const int width : {1264, 1280, 1366, 1440, 1600, 1920}) {
                QTest::addRow("%s, %d", language, width) << QString::fromLatin1(language) << width;
            }
        }
    }
    void everyModeIsShownInFull() {
        QFETCH(QString, language);
        QFETCH(int, width);
        QTranslator texts;
        QVERIFY(texts.load(QStringLiteral(":/i18n/tiller_") + language));
        QCoreApplication::installTranslator(&texts);
        FakeSession session;
        HeaderBar header(session.port());
        header.resize(width, HeaderBar::kHeight);
        header.show();
        QStringList elided;
        const auto look = [&](const SessionState& state) {
            header.applyState(state);
            QCoreApplication::processEvents();
            QCOMPARE(header.width(), width);
            QRect before;
            for (QWidget* child : header.findChildren<QWidget*>(QString(), Qt::FindDirectChildrenOnly)) {
                if (child->isVisible()) {
                    QVERIFY2(
                        header.rect().contains(child->geometry()) && !before.intersects(child->geometry()),
                        qPrintable(placesOf(header)));
                    before = child->geometry();
                }
            }
            for (const char* name : {"robotModeChip", "safetyChip", "controlChip"}) {
                const auto* chip = header.findChild<StateChip*>(QLatin1String(name));
                if (!chip->isWhole() || chip->shownCaption() != chip->caption()) {
                    elided << chip->caption() + QStringLiteral(": ") + chip->text();
                }
            }
        };
        SessionState state = longestState();
        state.simulated = true;
        for (int mode = -1; mode <= 8; ++mode) {
            state.robotMode = static_cast<RobotMode>(mode);
            look(state);
        }
        state.robotMode = RobotMode::Running;
        for (const SafetyStatus status : safetyStatuses()) {
            state.safetyMode = status;
            look(state);
        }
        state.safetyMode = SafetyMode::Normal;
        for (const bool remote : {false, true}) {
            for (const char* operational : {"", "MANUAL", "AUTOMATIC"}) {
                state.remoteControl = remote;
                state.operationalMode = QLatin1String(operational);
                for (const ControlState control : {ControlState::None, ControlState::Taking,
                                                   ControlState::Refused, ControlState::InControl}) {
                    state.control = control;
                    for (const RuntimeState runtime : runtimeStates()) {
                        state.runtimeState = runtime;
                        look(state);
                    }
                }
                state.moving = true;
                look(state);
                state.jogActive = true;
                look(state);
                state.freedriveActive = true;
                look(state);
                state.moving = state.jogActive = state.freedriveActive = false;
            }
        }
        state.control = ControlState::None;
        state.monitorOnly = true;
        look(state);
        state.link = LinkState::Stale;
        look(state);
        state.link = LinkState::Lost;
        look(state);
        state.link = LinkState::Disconnected;
        look(state);
        QCoreApplication::removeTranslator(&texts);
        elided.removeDuplicates();
        QVERIFY2(elided.isEmpty(), qPrintable(elided.join(QLatin1String("; "))));
        keepPicture(header, QStringLiteral("header-%1-%2").arg(language).arg(width));
    }

    void theStopButtonShowsItsWholeHint_data() {
        QTest::addColumn<QString>("language");
        for (const char* language : {"de", "en", "es", "fr", "ja", "zh_CN"}) {
            QTest::newRow(language) << QString::fromLatin1(language);
        }
    }
    void theStopButtonShowsItsWholeHint() {
        QFETCH(QString, language);
        QTranslator texts;
        QVERIFY(texts.load(QStringLiteral(":/i18n/tiller_") + language));
        QCoreApplication::installTranslator(&texts);
        FakeSession session;
        HeaderBar header(session.port());
        header.resize(1920, HeaderBar::kHeight);
        header.show();
        SessionState state = movingState();
        header.applyState(state);
        auto& stop = *header.findChild<StopButton*>();
        QVERIFY(stop.width() >= 200);
        const QImage image = stop.grab().toImage();
        QCoreApplication::removeTranslator(&texts);
        // A cut text ends at the right edge of its box.
        const QRgb ground = image.pixel(stop.width() / 2, 3);
        for (int y = 10; y < stop.height() - 10; ++y) {
            QVERIFY2(image.pixel(stop.width() - 3, y) == ground, qPrintable(QString::number(y)));
        }
    }

    void linkDescriptionIsNotTruncated_data() { everythingFitsAtEveryWidth_data(); }
    void linkDescriptionIsNotTruncated() {
        QFETCH(int, width);
        FakeSession session;
        HeaderBar header(session.port());
        header.resize(width, HeaderBar::kHeight);
        header.show();
        SessionState state = longestState();
        state.link = LinkState::Live;
        state.quality.recent = {5000, 1200, 12};
        header.applyState(state);
        QTRY_VERIFY_WITH_TIMEOUT(header.findChild<StateChip*>("linkChip")->caption().contains("JOG MAY STOP"),
                                 60'000);
        QCoreApplication::processEvents();
        const QString shown = header.findChild<StateChip*>("linkChip")->shownCaption();
        QVERIFY2(shown.endsWith("JOG MAY STOP"), qPrintable(shown));
        QVERIFY2(header.rect().contains(header.findChild<QWidget*>("stopButton")->geometry()),
                 "STOP is clipped");
    }

    void showsTheStateOfASession() {
        RobotSession session;
        HeaderBar header(session);
        QCOMPARE(header.shownStep(), NextStep::Connect);
        Q_EMIT session.stateChanged(movingState());
        QCOMPARE(header.shownStep(), NextStep::None);
        QCOMPARE(header.findChild<StateChip*>(QStringLiteral("robotModeChip"))->text(),
                 QStringLiteral("MOVING"));
    }

    void looksAsDesigned() {
        for (const Theme* theme : {&Theme::light(), &Theme::dark()}) {
            applyTheme(*qApp, *theme);
            const QString scheme = theme->isDark() ? QStringLiteral("dark") : QStringLiteral("light");
            FakeSession session;
            HeaderBar header(session.port());
            StatusLine line;
            header.show();
            line.show();
            line.setProjectText(QStringLiteral("cell-7.tiller — saved"));
            SessionState state = movingState();
            state.recording.active = true;
            state.recording.path = QStringLiteral("/home/x/pick-and-place.csv");
            state.recording.rows = 96000;
            state.recording.seconds = 192;
            state.recording.freeBytes = 80'000'000'000;
            line.applyState(state);
            line.showMessage(Severity::Info, QStringLiteral("Jog stopped: released (62 ms, 3.1 mm)"));
            for (const int width : {1920, 1280}) {
                header.resize(width, HeaderBar::kHeight);
                line.resize(width, StatusLine::kHeight);
                const QString tail = QStringLiteral("-%1-%2").arg(scheme).arg(width);
                header.applyState(state);
                QCoreApplication::processEvents();
                QVERIFY(!header.grab().isNull());
                keepPicture(header, QStringLiteral("header") + tail);
                keepPicture(line, QStringLiteral("line") + tail);
                SessionState next = longestState();
                next.robotMode = RobotMode::Idle;
                header.applyState(next);
                QCoreApplication::processEvents();
                keepPicture(header, QStringLiteral("header-next") + tail);
                next.safetyMode = SafetyMode::ProtectiveStop;
                header.applyState(next);
                QCoreApplication::processEvents();
                keepPicture(header, QStringLiteral("header-stop") + tail);
            }
        }
        applyTheme(*qApp, Theme::light());
    }
};

QTEST_MAIN(TestHeaderBar)
#include "tst_header_bar.moc"
