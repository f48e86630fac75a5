// SPDX-License-Identifier: MIT
#include "robot/station/history/recorded_lane.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "robot/core/modes.h"
#include "robot/station/history/lane_text.h"
#include "robot/station/history/signal_store.h"
#include "robot/station/link/motion_evidence.h"

namespace tiller {

namespace {

struct LaneSignals {
    int robotMode = -1;
    int safetyMode = -1;
    std::vector<int> jointSpeeds;
    std::vector<int> tcpSpeeds;
};

LaneSignals laneSignalsOf(const SignalStore& store, const QString& recording) {
    const auto find = [&](const char* key) {
        return store.find(recording + QLatin1Char('/') + QLatin1String(key));
    };
    LaneSignals found;
    found.robotMode = find("robot_mode");
    found.safetyMode = find("safety_mode");
    if (found.safetyMode < 0) {
        found.safetyMode = find("safety_status");
    }
    for (const char* key :
         {"actual_qd_0", "actual_qd_1", "actual_qd_2", "actual_qd_3", "actual_qd_4", "actual_qd_5"}) {
        if (const int signal = find(key); signal >= 0) {
            found.jointSpeeds.push_back(signal);
        }
    }
    for (const char* key : {"actual_TCP_speed_0", "actual_TCP_speed_1", "actual_TCP_speed_2"}) {
        if (const int signal = find(key); signal >= 0) {
            found.tcpSpeeds.push_back(signal);
        }
    }
    return found;
}

class LaneReader {
public:
    LaneReader(const SignalStore& store, const LaneSignals& needed, const SeriesBuffer& history)
        : store_(store), needed_(needed), history_(history) {}

    LaneEntry entryIn(std::int64_t begin, std::int64_t end) const {
        const MinMax robot = extentOf(needed_.robotMode, begin, end);
        const MinMax safety = extentOf(needed_.safetyMode, begin, end);
        if (robot.isEmpty() || safety.isEmpty()) {
            return noDataEntry();
        }
        // If a mode changes within the pixel column, the value that does not permit motion is shown.
        const auto safetyMode = static_cast<SafetyMode>(std::lround(
            allowsMotion(static_cast<SafetyMode>(std::lround(safety.max))) ? safety.min : safety.max));
        constexpr auto kRunning = static_cast<double>(RobotMode::Running);
        const auto robotMode =
            static_cast<RobotMode>(std::lround(robot.min == kRunning ? robot.max : robot.min));
        if (const auto hindered = hinderedEntry(robotMode, safetyMode)) {
            return *hindered;
        }
        const auto jointSpeed = fastest(needed_.jointSpeeds, begin, end);
        const auto tcpSpeed = fastest(needed_.tcpSpeeds, begin, end);
        if (!jointSpeed && !tcpSpeed) {
            return {LaneKind::Idle, store_.info(needed_.robotMode).stateName(kRunning)};
        }
        return motionEntry(moves(jointSpeed.value_or(0), tcpSpeed.value_or(0)));
    }

private:
    MinMax extentOf(int signal, std::int64_t begin, std::int64_t end) const {
        const int column = store_.column(signal);
        return column < 0 ? MinMax() : history_.minMax(column, begin, end);
    }
    /// The largest absolute value of any of these signals in the samples begin ... end - 1; empty without
    /// values.
    std::optional<double> fastest(const std::vector<int>& speeds, std::int64_t begin,
                                  std::int64_t end) const {
        std::optional<double> speed;
        for (const int signal : speeds) {
            if (const MinMax extent = extentOf(signal, begin, end); !extent.isEmpty()) {
                const double here = std::max(std::abs(extent.min), std::abs(extent.max));
                speed = std::max(speed.value_or(0), here);
            }
        }
        return speed;
    }

    const SignalStore& store_;
    const LaneSignals& needed_;
    const SeriesBuffer& history_;
};

}  // namespace

std::vector<int> recordedLaneSignals(const SignalStore& store, const QString& recording) {
    const LaneSignals found = laneSignalsOf(store, recording);
    if (found.robotMode < 0 || found.safetyMode < 0) {
        return {};
    }
    std::vector<int> all{found.robotMode, found.safetyMode};
    all.insert(all.end(), found.jointSpeeds.begin(), found.jointSpeeds.end());
    all.insert(all.end(), found.tcpSpeeds.begin(), found.tcpSpeeds.end());
    return all;
}

std::vector<LaneSegment> recordedLane(const SignalStore& store, const QString& recording,
                                      const ColumnGrid& grid) {
    std::vector<LaneSegment> segments;
    const LaneSignals needed = laneSignalsOf(store, recording);
    const SeriesBuffer* history = store.timesOf(recording);
    if (history == nullptr || grid.edges.empty() || needed.robotMode < 0 || needed.safetyMode < 0 ||
        store.column(needed.robotMode) < 0 || store.column(needed.safetyMode) < 0) {
        return segments;
    }
    const LaneReader reader(store, needed, *history);
    std::int64_t known = -1;  // sample with the entry `held`
    LaneEntry held;
    bool continues = false;  // the last segment extends to this column
    for (int i = 0; i < grid.columns(); ++i) {
        const std::int64_t begin = grid.edges[static_cast<std::size_t>(i)];
        const std::int64_t end = grid.edges[static_cast<std::size_t>(i) + 1];
        if (begin == end && (begin <= history->first() || begin >= history->end())) {
            continues = false;
            continue;
        }
        if (begin < end) {
            held = reader.entryIn(begin, end);
            known = -1;
        } else if (begin != known) {
            // The last state holds between two samples, but not across a gap.
            held = history->gapBefore(begin) ? noDataEntry() : reader.entryIn(begin - 1, begin);
            known = begin;
        }
        const double start = grid.start + i * grid.width;
        if (continues && segments.back().kind == held.kind && segments.back().label == held.label) {
            segments.back().end = start + grid.width;
        } else {
            segments.push_back({start, start + grid.width, held.kind, held.label});
        }
        continues = true;
    }
    return segments;
}

}  // namespace tiller
