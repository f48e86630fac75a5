// SPDX-License-Identifier: GPL-3.0-or-later
#include <QSet>
#include <QTest>

#include "widgets/status/mode_look.h"

using namespace tiller;
using Emphasis = StateChip::Emphasis;
using Shape = StateChip::Shape;

class TestModeLook : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void everyRobotModeHasItsOwnTextAndShape() {
        QSet<QString> texts;
        QSet<int> shapes;
        for (const RobotMode mode : robotModes()) {
            const ModeLook look = robotModeLook(mode, false);
            const QString name = robotModeName(mode);
            QVERIFY2(!look.text.isEmpty() && look.text != name, qPrintable(name));
            QVERIFY2(!look.advice.isEmpty(), qPrintable(name));
            QVERIFY2(look.shape != Shape::None, qPrintable(name));
            texts.insert(look.text);
            shapes.insert(static_cast<int>(look.shape));
        }
        QCOMPARE(texts.size(), qsizetype(robotModes().size()));
        QCOMPARE(shapes.size(), qsizetype(robotModes().size()));
    }

    void onlyAConfirmedMotionIsBlue() {
        for (const RobotMode mode : robotModes()) {
            const ModeLook look = robotModeLook(mode, true);
            QCOMPARE(look.emphasis == Emphasis::Moving, mode == RobotMode::Running);
            QVERIFY(robotModeLook(mode, false).emphasis != Emphasis::Moving);
        }
        QCOMPARE(robotModeLook(RobotMode::Running, true).text, QStringLiteral("MOVING"));
        QCOMPARE(robotModeLook(RobotMode::Running, true).shape, Shape::Triangle);
    }

    void everySafetyModeHasItsOwnTextAndAdvice() {
        QSet<QString> texts;
        for (const SafetyMode mode : safetyStatuses()) {
            const ModeLook look = safetyModeLook(mode);
            const QString name = safetyModeName(mode);
            QVERIFY2(!look.text.isEmpty() && look.text != name, qPrintable(name));
            QVERIFY2(!look.advice.isEmpty(), qPrintable(name));
            QVERIFY2(look.shape != Shape::None, qPrintable(name));
            texts.insert(look.text);
        }
        QCOMPARE(texts.size(), qsizetype(safetyStatuses().size()));
    }

    void stopsAreOctagonsInAlarmAndNormalIsGrey() {
        for (const SafetyMode mode : safetyStatuses()) {
            const ModeLook look = safetyModeLook(mode);
            const QString name = safetyModeName(mode);
            const bool stop = name.contains(QStringLiteral("STOP")) || mode == SafetyMode::Violation ||
                              mode == SafetyMode::Fault;
            QVERIFY2((look.emphasis == Emphasis::Alarm) == stop, qPrintable(name));
            QVERIFY2((look.shape == Shape::Octagon) == stop, qPrintable(name));
        }
        QCOMPARE(safetyModeLook(SafetyMode::Normal).emphasis, Emphasis::Normal);
        QCOMPARE(safetyModeLook(SafetyMode::Reduced).emphasis, Emphasis::Normal);
    }

    void everyProgramStateHasItsOwnTextAndIcon() {
        QSet<QString> texts;
        QSet<QString> icons;
        for (const RuntimeState runtime : runtimeStates()) {
            const ModeLook look = runtimeLook(runtime);
            QVERIFY(!look.advice.isEmpty());
            texts.insert(look.text);
            icons.insert(QString::number(static_cast<int>(look.shape)) + look.mark);
        }
        QCOMPARE(texts.size(), qsizetype(runtimeStates().size()));
        QCOMPARE(icons.size(), qsizetype(runtimeStates().size()));
    }

    void safetyStatusCausesDifferAndTheSaferValueIsUsed() {
        SessionState state;
        state.safetyMode = SafetyMode::SafeguardStop;
        state.safetyStatus = SafetyMode::AutomaticModeSafeguardStop;
        QCOMPARE(state.safety(), SafetyMode::AutomaticModeSafeguardStop);
        state.safetyStatus = SafetyMode::Undefined;  // older software does not report this value
        QCOMPARE(state.safety(), SafetyMode::SafeguardStop);
        state.safetyStatus = SafetyMode::Normal;
        QCOMPARE(state.safety(), SafetyMode::SafeguardStop);
        state.safetyMode = SafetyMode::Normal;
        state.safetyStatus = SafetyMode::ProtectiveStop;
        QCOMPARE(state.safety(), SafetyMode::ProtectiveStop);
    }

    void aForeignProgramIsShown() {
        SessionState state;
        state.link = LinkState::Live;
        state.sequence = 1;
        state.remoteControl = true;
        state.operationalMode = QStringLiteral("AUTOMATIC");
        state.runtimeState = RuntimeState::Playing;
        state.runningProgram = QStringLiteral("pick.urp");
        QCOMPARE(controlLook(state).text, QStringLiteral("Remote · Automatic · Program running"));
        QVERIFY(controlLook(state).advice.contains(QStringLiteral("pick.urp")));
        state.programNode = QStringLiteral("Wait: 0.5");
        QVERIFY(controlLook(state).advice.contains(QStringLiteral("pick.urp › Wait: 0.5")));
    }

    void anUnknownModeNumberIsNeverShownAsNormal() {
        const ModeLook look = safetyModeLook(static_cast<SafetyMode>(77));
        QCOMPARE(look.emphasis, Emphasis::Alarm);
        QVERIFY(look.text.contains(QStringLiteral("77")));
        QVERIFY(robotModeLook(static_cast<RobotMode>(99), true).emphasis != Emphasis::Moving);
    }

    void nextStepLeadsFromDisconnectedToControl() {
        SessionState state;
        QCOMPARE(nextStep(state), NextStep::Connect);
        state.link = LinkState::Connecting;
        QCOMPARE(nextStep(state), NextStep::None);
        state.link = LinkState::Live;
        state.safetyMode = SafetyMode::Normal;
        state.robotMode = RobotMode::PowerOff;
        QCOMPARE(nextStep(state), NextStep::PowerOn);
        state.robotMode = RobotMode::Booting;
        QCOMPARE(nextStep(state), NextStep::None);
        state.robotMode = RobotMode::Idle;
        QCOMPARE(nextStep(state), NextStep::ReleaseBrakes);
        state.robotMode = RobotMode::Running;
        QCOMPARE(nextStep(state), NextStep::TakeControl);
        state.control = ControlState::Taking;
        QCOMPARE(nextStep(state), NextStep::None);
        state.control = ControlState::Refused;
        QCOMPARE(nextStep(state), NextStep::TakeControl);
        state.control = ControlState::InControl;
        QCOMPARE(nextStep(state), NextStep::None);
        for (const SafetyStatus status : safetyStatuses()) {
            state.safetyMode = status;
            QCOMPARE(nextStep(state) == NextStep::Recover, !allowsMotion(status));
        }
    }

    void everyStepHasTextAndAdvice() {
        for (const auto step : {NextStep::Connect, NextStep::PowerOn, NextStep::ReleaseBrakes,
                                NextStep::Recover, NextStep::TakeControl}) {
            QVERIFY(!nextStepText(step).isEmpty());
            QVERIFY(!nextStepAdvice(step).isEmpty());
        }
        QVERIFY(nextStepText(NextStep::None).isEmpty());
    }

    void linkShowsRateAndProblem() {
        SessionState state;
        state.link = LinkState::Live;
        state.quality.rateHz = 499.7;
        state.quality.roundTripMs = 4.0;
        QCOMPARE(linkLook(state).text, QStringLiteral("500 Hz · 4.0 ms"));
        QCOMPARE(linkLook(state).emphasis, Emphasis::Normal);
        QCOMPARE(linkCaption(state), QStringLiteral("LINK · GOOD"));
        state.quality.roundTripMs = 25;
        QCOMPARE(linkCaption(state), QStringLiteral("LINK · ARM LAGS"));
        state.quality.recent.lost = 3;
        QCOMPARE(linkCaption(state), QStringLiteral("LINK · JOG MAY STOP"));
        QVERIFY(linkLook(state).text.contains(QStringLiteral("3 lost")));
        state.link = LinkState::Stale;
        QCOMPARE(linkLook(state).emphasis, Emphasis::Warning);
        QCOMPARE(linkCaption(state), QStringLiteral("LINK"));
        state.control = ControlState::InControl;
        QCOMPARE(linkCaption(state), QStringLiteral("LINK · JOG STOPS"));
        state.link = LinkState::Lost;
        QCOMPARE(linkCaption(state), QStringLiteral("LINK"));
        QCOMPARE(linkLook(state).text, QStringLiteral("NO DATA"));
        QCOMPARE(linkLook(state).emphasis, Emphasis::Alarm);
    }

    // Packets that were late an hour ago do not matter for the current connection.
    void onlyRecentLatenessIsReported() {
        SessionState state;
        state.link = LinkState::Live;
        state.quality.rateHz = 500;
        state.quality.all = {90'000, 33'220, 40};
        state.quality.recent = {5000, 3, 0};
        QCOMPARE(linkLook(state).text, QStringLiteral("500 Hz"));
        QCOMPARE(linkCaption(state), QStringLiteral("LINK · GOOD"));
        for (const char* part : {"33220", "90000", "Last 10 s: 5000 packets, 3 late", "half a period"}) {
            QVERIFY2(linkLook(state).advice.contains(QLatin1String(part)), part);
        }
        state.quality.recent = {5000, 2500, 0};
        QCOMPARE(linkLook(state).text, QStringLiteral("500 Hz · 2500 late"));
        QCOMPARE(linkCaption(state), QStringLiteral("LINK · JOG MAY STOP"));
    }

    // Without data, it is unknown which program controls the robot and which program is running.
    void withoutDataControlIsNotReady() {
        for (const ControlState control :
             {ControlState::InControl, ControlState::None, ControlState::Taking, ControlState::Refused}) {
            SessionState state;
            state.sequence = 1;
            state.remoteControl = true;
            state.control = control;
            state.runtimeState = RuntimeState::Playing;
            state.link = LinkState::Lost;
            QCOMPARE(controlLook(state).text, QStringLiteral("NO DATA"));
            QCOMPARE(controlLook(state).emphasis, Emphasis::Muted);
        }
    }

    void controlChipNamesTheController() {
        SessionState state;
        state.link = LinkState::Live;
        state.remoteControl = true;
        state.control = ControlState::InControl;
        QCOMPARE(controlLook(state).text, QStringLiteral("Remote · Ready"));
        state.jogActive = true;
        QCOMPARE(controlLook(state).text, QStringLiteral("Remote · Jog"));
        state.jogActive = false;
        state.freedriveActive = state.moving = true;
        QCOMPARE(controlLook(state).text, QStringLiteral("Remote · Freedrive"));
        QCOMPARE(robotModeLook(RobotMode::Running, true, true).text, QStringLiteral("FREEDRIVE"));
        state.freedriveActive = state.moving = false;
        state.programRuns = true;
        state.sequence = 1;
        state.runtimeState = RuntimeState::Paused;
        QCOMPARE(controlLook(state).text, QStringLiteral("Remote · Program paused"));
        state.programRuns = false;
        state.sequence = 0;
        state.runtimeState = RuntimeState::Stopped;
        state.control = ControlState::None;
        QCOMPARE(controlLook(state).text, QStringLiteral("Not in control"));
        state.remoteControl = false;
        QVERIFY(controlLook(state).text.contains(QStringLiteral("Local")));
        state.controlPlaceKnown = false;
        QCOMPARE(controlLook(state).text, QStringLiteral("Monitoring"));
        state.control = ControlState::Refused;
        state.controlReason = QStringLiteral("Registers in use");
        QCOMPARE(controlLook(state).emphasis, Emphasis::OperatorNeeded);
        QCOMPARE(controlLook(state).advice, state.controlReason);
    }
};

QTEST_GUILESS_MAIN(TestModeLook)
#include "tst_mode_look.moc"
