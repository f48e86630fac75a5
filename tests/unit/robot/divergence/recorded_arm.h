// SPDX-License-Identifier: MIT
#pragma once

// A simulated arm with noise, and the recording of its motion with one row per control period, as written by
// a receiver.

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "robot/core/robot_model.h"
#include "robot/recording/table_recording.h"
#include "robot/simulator/arm/arm.h"

namespace tiller::test {

/// A recording in memory that also contains the model of its arm.
class MadeRecording : public recording::TableRecording {
public:
    MadeRecording(recording::RecordedTable table, std::string model) : TableRecording(std::move(table)) {
        facts_["model"] = std::move(model);
    }
    const std::map<std::string, std::string>& facts() const override { return facts_; }

private:
    std::map<std::string, std::string> facts_;
};

class RecordedArm {
public:
    explicit RecordedArm(RobotModelId id = RobotModelId::UR5e)
        : arm(robotModel(id), simulator::arm::ArmOptions{.seed = 11}) {
        arm.setDriveState(simulator::arm::DriveState::Running);
    }

    /// Runs this number of control periods and records one row for each.
    void run(int periods) {
        for (int i = 0; i < periods; ++i) {
            arm.step();
            keep();
        }
    }
    void finish(const simulator::arm::MotionStart& start) {
        while (arm.motion().progress(start.id) == simulator::arm::MotionProgress::Running) {
            run(1);
        }
    }
    std::uint64_t rows() const { return rows_; }
    /// Returns a recording of every `every`-th row, without the rows in [from, to).
    MadeRecording recording(std::size_t every = 1, std::size_t from = 0, std::size_t to = 0) const {
        recording::RecordedTable table{QStringLiteral("made.csv"), QStringLiteral("CSV"), {}, {}, {}};
        for (const auto& [name, values] : columns) {
            table.columns.push_back({name, "", false});
            std::vector<double>& kept = table.values.emplace_back();
            for (std::size_t i = 0; i < values.size(); i += every) {
                if (i < from || i >= to) {
                    kept.push_back(values[i]);
                }
            }
        }
        return {std::move(table), model};
    }
    void drop(const std::string& field) {
        std::erase_if(columns, [&](const auto& column) {
            return column.first == field || column.first.starts_with(field + '_');
        });
    }

    simulator::arm::Arm arm;
    std::map<std::string, std::vector<double>> columns;
    std::string model = arm.model().name;
    double robotMode = 7;

private:
    void put(const std::string& name, double value) { columns[name].push_back(value); }
    template <class Values>
    void put(const std::string& field, const Values& values, int count) {
        for (int i = 0; i < count; ++i) {
            put(field + '_' + std::to_string(i), values[i]);
        }
    }
    void keep() {
        const simulator::arm::ArmState& state = arm.state();
        put("timestamp", 100 + static_cast<double>(rows_++) * arm.period());
        put("target_q", state.targetQ, 6);
        put("target_qd", state.targetQd, 6);
        put("target_moment", state.targetMoment, 6);
        put("actual_q", state.actualQ, 6);
        put("actual_current", state.actualCurrent, 6);
        put("target_TCP_pose", state.targetTcpPose, 6);
        put("actual_TCP_pose", state.actualTcpPose, 6);
        put("tcp_offset", arm.tcp(), 6);
        put("actual_TCP_force", state.tcpForce.vector(), 6);
        put("payload", arm.payload().mass);
        put("payload_cog", arm.payload().centreOfGravity, 3);
        put("payload_inertia", arm.payload().inertia, 6);
        put("robot_mode", robotMode);
        put("robot_status_bits", 1);
    }

    std::uint64_t rows_ = 0;
};

}  // namespace tiller::test
