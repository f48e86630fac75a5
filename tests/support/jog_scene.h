// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The jog column with real mouse events and with ports that only record the calls.

#include <QTest>
#include <numbers>

#include "widgets/common/segmented_control.h"
#include "widgets/hold/hold_to_run_button.h"
#include "widgets/jog/jog_column.h"

namespace tiller::test {

/// The ports of a session. They only record the calls.
struct FakeSession {
    std::uint64_t next = 0;
    std::uint64_t running = 0;
    QList<control::JogTarget> jogs;
    QList<MoveRequest> moves;
    QList<control::Freedrive> freedrives;
    QList<control::StopCause> ends;

    MotionPort port() {
        return {.beginJog = [this](const control::JogTarget& target) -> Result<RobotSession::MotionId> {
                    jogs.append(target);
                    return running = ++next;
                },
                .beginMove = [this](const MoveRequest& request) -> Result<RobotSession::MotionId> {
                    moves.append(request);
                    return running = ++next;
                },
                .hold = [this](RobotSession::MotionId id) { return id == running; },
                .endMotion =
                    [this](RobotSession::MotionId id, control::StopCause cause) {
                        if (id == running) {
                            running = 0;
                        }
                        ends.append(cause);
                    },
                .limits = [] { return control::MotionLimits(); },
                .beginFreedrive = [this](const control::Freedrive& f) -> Result<RobotSession::MotionId> {
                    freedrives.append(f);
                    return running = ++next;
                },
                .holdWith = [this](RobotSession::MotionId id,
                                   const control::JogTarget&) { return id == running; }};
    }
};

inline SessionState readyState() {
    constexpr double kDeg = std::numbers::pi / 180.0;
    SessionState state;
    state.link = LinkState::Live;
    state.robotMode = RobotMode::Running;
    state.safetyMode = SafetyMode::Normal;
    state.control = ControlState::InControl;
    state.sequence = 1;
    state.q = JointPositions(-88.24 * kDeg, -104.91 * kDeg, -147.60 * kDeg, -33.80 * kDeg, 91.67 * kDeg,
                             1.32 * kDeg);
    state.tcpPose = Pose(-0.1435, -0.43501, 0.2, 0, 0, 0);
    state.tcpPose.rotation = rotationVectorFromRpy({179.94 * kDeg, 0.02 * kDeg, 2.29 * kDeg});
    return state;
}

/// A jog column in an active window with its own clock.
struct JogScene {
    FakeSession session;
    VirtualClock clock;
    HoldPolicy policy;
    JogColumn column{session.port(), policy};
    SessionState state = readyState();

    explicit JogScene(QSize size = {390, 948}) {
        for (HoldToRunButton* key : column.holdKeys()) {
            key->guard().setClock(clock);
        }
        column.resize(size);
        column.show();
        column.activateWindow();
        if (!QTest::qWaitForWindowActive(&column)) {
            qFatal("the window did not become active");
        }
        column.applyState(state);
    }
    HoldToRunButton* key(const char* name) { return column.findChild<HoldToRunButton*>(QLatin1String(name)); }
    void press(const char* name, Qt::KeyboardModifiers modifiers = {}) {
        QTest::mousePress(key(name), Qt::LeftButton, modifiers);
    }
    void release(const char* name) { QTest::mouseRelease(key(name), Qt::LeftButton); }
    void choose(const char* control, int index) {
        auto* segments = column.findChild<SegmentedControl*>(QLatin1String(control));
        QTest::mouseClick(segments->segment(index), Qt::LeftButton);
    }
};

}  // namespace tiller::test
