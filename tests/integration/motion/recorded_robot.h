// SPDX-License-Identifier: MIT
#pragma once

// A controller in virtual time with an RTDE client that reads every period, and a script client. All clients
// use sockets. For tests of motion.

#include <array>
#include <cmath>
#include <vector>

#include "tests/support/raw_client.h"

namespace tiller::test {

using Six = std::array<double, 6>;

inline Eigen::Vector3d positionOf(const Six& pose) {
    return {pose[0], pose[1], pose[2]};
}

/// One RTDE package.
struct MotionSample {
    double time = 0;
    Six targetQ{};
    Six targetQd{};
    Six targetPose{};
    Six actualPose{};
    Six force{};
    Six moment{};
    double scaling = 0;
    quint32 runtime = 0;
    quint32 safetyBits = 0;
    qint32 mark = 0;                ///< output_int_register_0
    std::array<double, 2> value{};  ///< output_double_register_0, 1

    Eigen::Vector3d target() const { return positionOf(targetPose); }
    Eigen::Vector3d actual() const { return positionOf(actualPose); }
    double speed() const {
        double worst = 0;
        for (const double v : targetQd) {
            worst = std::max(worst, std::abs(v));
        }
        return worst;
    }
};

class RecordedRobot {
public:
    explicit RecordedRobot(const simulator::SimulatorOptions& options = VirtualRobot::options())
        : robot(options)
        , rtde(robot.rtde())
        , script(robot.primary())
        , ready(robot.started && rtde.useVersion() &&
                !rtde.setupOutputs(1 / robot.controller.stepTime(),
                                   "timestamp,target_q,target_qd,target_TCP_pose,actual_TCP_pose,"
                                   "actual_TCP_force,target_moment,speed_scaling,runtime_state,"
                                   "safety_status_bits,output_int_register_0,output_double_register_0,"
                                   "output_double_register_1")
                     .contains("NOT_FOUND") &&
                rtde.start()) {}

    double dt() const { return robot.controller.stepTime(); }
    const MotionSample& now() const { return samples.back(); }

    /// Advances time and reads all data sent in the meantime.
    void step(int ticks = 1) {
        // Advance in chunks that fit in the socket buffers.
        for (int left = ticks; left > 0; left -= 20) {
            const int now = std::min(left, 20);
            robot.controller.step(now);
            for (int i = 0; i < now; ++i) {
                samples.push_back(decode(rtde.next().payload));
            }
        }
    }
    void run(double seconds) { step(static_cast<int>(std::lround(seconds / dt()))); }

    void send(const QByteArray& program) {
        script.send(program);
        robot.controller.drainSockets();
    }
    /// Sends a program and runs it to its end. Returns false if it does not end within `seconds`.
    bool execute(const QByteArray& program, double seconds = 60) {
        send(program);
        return until([&] { return now().runtime == 2; }, 1) &&
               until([&] { return now().runtime == 1; }, seconds);
    }
    template <class Condition>
    bool until(Condition condition, double seconds) {
        for (int n = static_cast<int>(seconds / dt()); n > 0; --n) {
            step();
            if (condition()) {
                return true;
            }
        }
        return false;
    }
    /// The samples in which the mark of the script had this value.
    std::vector<MotionSample> marked(int mark) const {
        std::vector<MotionSample> found;
        for (const MotionSample& s : samples) {
            if (s.mark == mark) {
                found.push_back(s);
            }
        }
        return found;
    }

    VirtualRobot robot;
    RawRtde rtde;
    RawPrimary script;
    bool ready = false;
    std::vector<MotionSample> samples;

private:
    static Six sixAt(const QByteArray& bytes, qsizetype& at) {
        Six six{};
        for (double& v : six) {
            v = doubleAt(bytes, at);
            at += 8;
        }
        return six;
    }
    static MotionSample decode(const QByteArray& p) {
        MotionSample s;
        if (p.size() < 1 + 8 + 6 * 48 + 8 + 12 + 16) {
            return s;
        }
        s.time = doubleAt(p, 1);
        qsizetype at = 9;
        for (Six* six : {&s.targetQ, &s.targetQd, &s.targetPose, &s.actualPose, &s.force, &s.moment}) {
            *six = sixAt(p, at);
        }
        s.scaling = doubleAt(p, at);
        s.runtime = wordAt(p, at + 8);
        s.safetyBits = wordAt(p, at + 12);
        s.mark = intAt(p, at + 16);
        s.value = {doubleAt(p, at + 20), doubleAt(p, at + 28)};
        return s;
    }
};

/// Formats as "[a,b,...]" with all digits.
template <class Numbers>
QByteArray listOf(const Numbers& numbers) {
    QByteArray text = "[";
    for (const double v : numbers) {
        text += QByteArray::number(v, 'g', 17) + ',';
    }
    text.back() = ']';
    return text;
}
inline QByteArray poseOf(const Six& pose) {
    return 'p' + listOf(pose);
}

}  // namespace tiller::test
