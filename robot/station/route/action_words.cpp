// SPDX-License-Identifier: MIT
#include "robot/station/route/action_words.h"

#include "robot/station/link/io_commands.h"

namespace tiller {

QString ActionWords::terminal(const project::WaypointAction& action) {
    return ioTerminal(action.kind != project::WaypointAction::Kind::WaitForInput,
                      project::channelOf(action.group, action.pin));
}

QString ActionWords::of(const project::WaypointAction& action) {
    using Kind = project::WaypointAction::Kind;
    const QString pin = action.usesPin() ? terminal(action) : QString();
    const QString seconds = QString::number(action.seconds, 'g', 6);
    switch (action.kind) {
        case Kind::SetOutput:
            return action.value ? tr("%1 on").arg(pin) : tr("%1 off").arg(pin);
        case Kind::PulseOutput:
            return action.value ? tr("%1 on for %2 s").arg(pin, seconds)
                                : tr("%1 off for %2 s").arg(pin, seconds);
        case Kind::WaitForInput:
            if (action.seconds > 0) {
                return action.value ? tr("Wait until %1 is on (max. %2 s)").arg(pin, seconds)
                                    : tr("Wait until %1 is off (max. %2 s)").arg(pin, seconds);
            }
            return action.value ? tr("Wait until %1 is on").arg(pin) : tr("Wait until %1 is off").arg(pin);
        case Kind::WaitTime:
            return tr("Wait %1 s").arg(seconds);
        case Kind::OpenGripper:
            return tr("Open the gripper");
        case Kind::CloseGripper:
            break;
    }
    return tr("Close the gripper");
}

QStringList ActionWords::of(const project::WaypointActions& actions) {
    QStringList words;
    for (const project::WaypointAction& action : actions) {
        words << of(action);
    }
    return words;
}

QStringList ActionWords::kinds() {
    return {tr("Set an output"), tr("Pulse an output"),  tr("Wait for an input"),
            tr("Wait"),          tr("Open the gripper"), tr("Close the gripper")};
}

}  // namespace tiller
