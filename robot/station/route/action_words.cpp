// SPDX-License-Identifier: MIT
#include "robot/station/route/action_words.h"

#include "robot/station/link/io_commands.h"

namespace tiller {

QString ActionWords::terminal(const project::WaypointAction& action) {
    return ioTerminal(kindOf(action).pin != project::WaypointActionKind::Pin::Input,
                      project::channelOf(action.group, action.pin));
}

QString ActionWords::of(const project::WaypointAction& action) {
    using Time = project::WaypointActionKind::Time;
    const project::WaypointActionKind& kind = kindOf(action);
    const bool isUnlimited = kind.time == Time::Limit && !(action.seconds > 0);
    const bool isOff = action.usesPin() && !action.value;
    QString text = isUnlimited ? tr(isOff ? kind.unlimitedOffText : kind.unlimitedText)
                               : tr(isOff ? kind.offText : kind.text);
    if (action.usesPin()) {
        text = text.arg(terminal(action));
    }
    return action.usesTime() && !isUnlimited ? text.arg(QString::number(action.seconds, 'g', 6)) : text;
}

QStringList ActionWords::of(const project::WaypointActions& actions) {
    QStringList words;
    for (const project::WaypointAction& action : actions) {
        words << of(action);
    }
    return words;
}

QStringList ActionWords::kinds() {
    QStringList titles;
    for (const project::WaypointActionKind& kind : project::waypointActionKinds()) {
        titles << tr(kind.title);
    }
    return titles;
}

}  // namespace tiller
