// SPDX-License-Identifier: GPL-3.0-or-later
// Stops that also apply to programs of other clients.
#include <QTest>
#include <algorithm>

#include "robot/station/link/detail/external_program_stopper.h"

using namespace tiller;
using control::StopCause;

namespace {

SessionState live(RuntimeState runtime, ControlState control = ControlState::None) {
    SessionState state;
    state.link = LinkState::Live;
    state.sequence = 7;
    state.runtimeState = runtime;
    state.control = control;
    return state;
}

constexpr StopCause kByKey[] = {StopCause::Escape, StopCause::Space};

bool meansIt(const SessionState& state) {
    return std::all_of(std::begin(kByKey), std::end(kByKey),
                       [&](StopCause cause) { return ExternalProgramStopper::isMeant(cause, state); }) &&
           ExternalProgramStopper::isMeant(StopCause::StopButton, state);
}
bool meansNothing(const SessionState& state) {
    return std::none_of(std::begin(kByKey), std::end(kByKey),
                        [&](StopCause cause) { return ExternalProgramStopper::isMeant(cause, state); }) &&
           !ExternalProgramStopper::isMeant(StopCause::StopButton, state);
}

}  // namespace

class TestExternalProgramStopper : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void anyProgramThatMayMoveIsStopped() {
        for (const RuntimeState state :
             {RuntimeState::Playing, RuntimeState::Pausing, RuntimeState::Resuming, RuntimeState::Stopping}) {
            QVERIFY(meansIt(live(state)));
            QVERIFY(meansIt(live(state, ControlState::Refused)));
        }
    }
    void nothingIsSentWhenNothingRuns() {
        QVERIFY(meansNothing(live(RuntimeState::Stopped)));
        QVERIFY(meansNothing(live(RuntimeState::Stopped, ControlState::Refused)));
    }
    void ourOwnProgramIsNotAnExternalProgram() {
        QVERIFY(meansNothing(live(RuntimeState::Playing, ControlState::InControl)));
    }
    void aStopIsSentWhileControlIsBeingTaken() {
        QVERIFY(meansIt(live(RuntimeState::Playing, ControlState::Taking)));
        QVERIFY(meansIt(live(RuntimeState::Stopped, ControlState::Taking)));
    }
    void onlyStopEndsAPausedProgram() {
        const SessionState paused = live(RuntimeState::Paused);
        QVERIFY(ExternalProgramStopper::isMeant(StopCause::StopButton, paused));
        QVERIFY(!ExternalProgramStopper::isMeant(StopCause::Escape, paused));
        QVERIFY(!ExternalProgramStopper::isMeant(StopCause::Space, paused));
    }
    void aStopIsSentWhenTheStateIsUnknown() {
        SessionState never = live(RuntimeState::Stopped);
        never.link = LinkState::Lost;
        never.sequence = 0;
        QVERIFY(meansIt(never));
        SessionState played = live(RuntimeState::Playing);
        played.link = LinkState::Lost;
        QVERIFY(meansIt(played));
    }
    // A program may have started since the last data. Esc and Space may have another function in the window,
    // but STOP always stops.
    void oldDataConfirmNoStandstill() {
        for (const LinkState link : {LinkState::Live, LinkState::Stale, LinkState::Lost}) {
            SessionState stopped = live(RuntimeState::Stopped);
            stopped.link = link;
            stopped.quality.ageMs = 101;
            QVERIFY(ExternalProgramStopper::isMeant(StopCause::StopButton, stopped));
            SessionState played = live(RuntimeState::Playing);
            played.link = link;
            played.quality.ageMs = 101;
            QVERIFY(meansIt(played));
        }
    }
    // While it is uncertain who has control, the window shows Space and Esc as stop keys.
    void everyStopKeyIsSentWhileControlIsInDoubt() {
        for (const LinkState link : {LinkState::Live, LinkState::Stale, LinkState::Lost}) {
            SessionState stopped = live(RuntimeState::Stopped);
            stopped.link = link;
            stopped.quality.ageMs = 101;
            stopped.controlInDoubt = true;
            QVERIFY(stopped.keysStop());
            QVERIFY(meansIt(stopped));
        }
    }
    void anArmThatMovesWithoutAProgramIsStopped() {
        SessionState moving = live(RuntimeState::Stopped);
        moving.moving = true;
        QVERIFY(meansIt(moving));
    }
    // Only Esc, Space and STOP also stop programs of other clients.
    void onlyOperatorStopsAreSent() {
        for (int cause = 0; cause <= static_cast<int>(StopCause::TargetTooFar); ++cause) {
            const auto which = static_cast<StopCause>(cause);
            const bool byOperator =
                which == StopCause::Escape || which == StopCause::Space || which == StopCause::StopButton;
            QCOMPARE(ExternalProgramStopper::isMeant(which, live(RuntimeState::Playing)), byOperator);
        }
    }
};

QTEST_GUILESS_MAIN(TestExternalProgramStopper)
#include "tst_external_program_stopper.moc"
