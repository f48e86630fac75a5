// SPDX-License-Identifier: MIT
#include "robot/station/history/live_history.h"

#include <utility>

#include "robot/station/history/lane_text.h"
#include "robot/station/link/robot_session.h"

namespace tiller {

LiveHistory::LiveHistory(RobotSession& session, QObject* parent) : QObject(parent) {
    connect(&store_, &SignalStore::furtherFieldsChanged, &session, &RobotSession::followExtraFields);
    connect(&session, &RobotSession::linkBegan, this, [this, &session] {
        feed_.beginLink();
        const RobotAddress& address = session.address();
        robot_ = address.name.isEmpty() || address.name == address.host
                     ? address.host
                     : QStringLiteral("%1 (%2)").arg(address.name, address.host);
        store_.setRobot(QStringLiteral("%1 %2").arg(address.host).arg(address.portOffset), robot_);
    });
    connect(&session, &RobotSession::samplesReceived, this, &LiveHistory::take);
    connect(&session, &RobotSession::extraSamplesReceived, this,
            [this](const SampleBatch& batch) { feed_.takeExtra(batch); });
    connect(&session, &RobotSession::stateChanged, this, &LiveHistory::follow);
    follow(session.state());
}

void LiveHistory::take(const SampleBatch& batch) {
    feed_.take(batch);
    markRobotChange();
    const LaneEntry none = noDataEntry();
    for (const HistoryFeed::Silence& silence : feed_.takeDataGaps()) {
        lane_.add(silence.from, none.kind, none.label);
        lane_.add(silence.to, none.kind, none.label);
        backAt_ = silence.to;
    }
}

void LiveHistory::markRobotChange() {
    const auto change = store_.newestRobotChange();
    if (change && change != markedChange_) {
        markedChange_ = change;
        const HistoryRobot* robot = store_.robotAt(store_.live().time(*change));
        const bool hasModel = robot != nullptr && robot->model;
        Q_EMIT robotChanged(
            store_.live().time(*change),
            hasModel ? QStringLiteral("%1, %2").arg(robot_, QLatin1String(robotModel(*robot->model).name))
                     : robot_);
    }
}

void LiveHistory::follow(const SessionState& state) {
    if (state.modelKnown && state.link == LinkState::Live) {
        store_.setRobotModel(state.model);
        markRobotChange();
    }
    const double shown = feed_.plotTime(state.robotTime);
    if (state.hasData() && state.link != LinkState::Connecting) {
        const LaneEntry entry = laneEntry(state, jogLabel_, stepLabel_);
        lane_.add(std::exchange(backAt_, {}).value_or(shown), entry.kind, entry.label);
        lane_.add(shown, entry.kind, entry.label);
    } else if (state.link == LinkState::Lost && state.sequence != 0) {
        // The lane shows "no data" from the last sample to the current time.
        const LaneEntry none = noDataEntry();
        lane_.add(shown, none.kind, none.label);
        lane_.add(shown + state.quality.ageMs / 1e3, none.kind, none.label);
    }
    if (!store_.live().isEmpty()) {
        lane_.forgetBefore(store_.live().firstTime());
    }
}

}  // namespace tiller

#include "moc_live_history.cpp"
