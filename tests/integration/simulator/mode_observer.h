// SPDX-License-Identifier: MIT
#pragma once

// Observes a controller on all interfaces at once and reports contradictions. RTDE, the realtime record and
// the primary state have time stamps, and equal times require equal values. The dashboard is queried between
// two control periods, so its replies must match the last period. Safety messages must report each change of
// the safety mode exactly once and in order.

#include <QStringList>
#include <map>

#include "robot/core/modes.h"
#include "tests/support/raw_client.h"

namespace tiller::test {

class ModeObserver {
public:
    /// RTDE data of one control period.
    struct Sample {
        int robotMode = 0, safetyMode = 0, safetyStatus = 0, runtimeState = 0, jointMode = 0;
        quint32 robotBits = 0, safetyBits = 0;
        double slider = 0;
    };

    explicit ModeObserver(VirtualRobot& robot)
        : robot_(robot)
        , rtde_(robot.rtde())
        , primary_(robot.primary())
        , realtime_(robot.host(), robot.controller.ports().realtime)
        , dashboard_(robot.dashboard()) {
        rtde_.useVersion();
        rtde_.setupOutputs(500,
                           "timestamp,robot_mode,safety_mode,safety_status,runtime_state,robot_status_bits,"
                           "safety_status_bits,joint_mode,target_speed_fraction");
        rtde_.start();
        robot_.controller.drainSockets();
        step(1);
        changes_.clear();
    }

    /// Contradictions of the interfaces found so far; empty if there are none.
    const QStringList& complaints() const { return complaints_; }
    const Sample& last() const { return last_; }
    /// Robot modes since forget(), without repetitions.
    QList<int> robotModes() const { return robotModes_; }
    QList<int> runtimeStates() const { return runtimeStates_; }
    void forget() {
        robotModes_ = {last_.robotMode};
        runtimeStates_ = {last_.runtimeState};
    }
    RawDashboard& dashboard() { return dashboard_; }
    RawPrimary& primary() { return primary_; }

    void step(int ticks) {
        for (int i = 0; i < ticks; ++i) {
            robot_.controller.step();
            readRtde();
            readRealtime();
            if (++tick_ % 25 == 0) {
                askDashboard();
            }
            if (tick_ % 500 == 0) {
                readPrimary();
            }
        }
    }
    void settle() {
        step(60);  // more than a tenth of a second, so that a primary state has arrived
        readPrimary();
        askDashboard();
        if (changes_ != told_) {
            complain(
                QStringLiteral("safety modes were %1, messages said %2").arg(text(changes_), text(told_)));
        }
    }

private:
    static QString text(const QList<int>& numbers) {
        QStringList words;
        for (const int number : numbers) {
            words << QString::number(number);
        }
        return words.join(' ');
    }
    void complain(const QString& what) {
        if (complaints_.size() < 10) {
            complaints_ << QStringLiteral("at %1 s: ").arg(time_, 0, 'f', 3) + what;
        }
    }
    void expect(const char* what, int found, int wanted) {
        if (found != wanted) {
            complain(
                QStringLiteral("%1 is %2, RTDE says %3").arg(QLatin1String(what)).arg(found).arg(wanted));
        }
    }

    void readRtde() {
        const QByteArray data = rtde_.next().payload;
        if (data.size() < 1 + 8 + 6 * 4 + 24 + 8) {
            complain(QStringLiteral("no RTDE package"));
            return;
        }
        Sample now;
        time_ = doubleAt(data, 1);
        now.robotMode = intAt(data, 9);
        now.safetyMode = intAt(data, 13);
        now.safetyStatus = intAt(data, 17);
        now.runtimeState = intAt(data, 21);
        now.robotBits = wordAt(data, 25);
        now.safetyBits = wordAt(data, 29);
        now.jointMode = intAt(data, 33);
        now.slider = doubleAt(data, 57);
        checkWithin(now);
        if (!history_.empty() && now.safetyMode != last_.safetyMode) {
            changes_ << now.safetyMode;
        }
        if (robotModes_.isEmpty() || robotModes_.back() != now.robotMode) {
            robotModes_ << now.robotMode;
        }
        if (runtimeStates_.isEmpty() || runtimeStates_.back() != now.runtimeState) {
            runtimeStates_ << now.runtimeState;
        }
        last_ = now;
        history_[key(time_)] = now;
        if (history_.size() > 2000) {
            history_.erase(history_.begin());
        }
    }

    /// Checks that the fields of one package are consistent.
    void checkWithin(const Sample& s) {
        const auto bit = [](quint32 word, int n) { return int((word >> n) & 1U); };
        const bool powered = s.robotMode >= 4 || (s.robotMode == 2 && s.jointMode != 239);
        expect("robot_status_bits power on", bit(s.robotBits, 0), powered);
        expect("robot_status_bits program running", bit(s.robotBits, 1),
               s.runtimeState != 1 && s.runtimeState != 4);
        static const std::map<int, int> kJointModes{{7, 253}, {5, 255}, {6, 238}, {3, 239},
                                                    {4, 247}, {0, 239}, {1, 239}};
        if (const auto mode = kJointModes.find(s.robotMode); mode != kJointModes.end()) {
            expect("joint_mode", s.jointMode, mode->second);
        }
        expect("safety_status_bits normal", bit(s.safetyBits, 0), s.safetyMode == 1);
        static const std::map<int, int> kBits{{2, 1}, {3, 2}, {4, 3}, {5, 4}, {6, 5}, {7, 6}, {8, 8}, {9, 9}};
        if (const auto which = kBits.find(s.safetyMode); which != kBits.end()) {
            expect("safety_status_bits of the mode", bit(s.safetyBits, which->second), 1);
        }
        expect("safety_status_bits stopped", bit(s.safetyBits, 10), s.safetyMode == 3 || s.safetyMode >= 5);
        if (s.safetyMode == 6 || s.safetyMode == 7) {
            expect("safety_status_bits emergency", bit(s.safetyBits, 7), 1);
        }
        expect("safety_mode by safety_status", s.safetyMode,
               s.safetyStatus == 12 || s.safetyStatus == 13 ? 5 : s.safetyStatus);
    }

    void readRealtime() {
        const QByteArray record = realtime_.next();
        if (record.size() < 1220) {
            complain(QStringLiteral("no realtime record"));
            return;
        }
        expect("realtime robot mode", int(doubleAt(record, 756)), last_.robotMode);
        expect("realtime joint mode", int(doubleAt(record, 764)), last_.jointMode);
        expect("realtime safety mode", int(doubleAt(record, 812)), last_.safetyMode);
        expect("realtime program state", int(doubleAt(record, 1052)), last_.runtimeState);
        expect("realtime safety status", int(doubleAt(record, 1108)), last_.safetyStatus);
    }

    void askDashboard() {
        dashboard_.send("robotmode\nsafetymode\nsafetystatus\nrunning\n");
        const auto wanted = [](const char* label, const QString& name) { return label + name.toUtf8(); };
        const auto compare = [this](const QByteArray& found, const QByteArray& expected) {
            if (found != expected) {
                complain(QStringLiteral("dashboard says '%1', RTDE means '%2'")
                             .arg(QString::fromUtf8(found), QString::fromUtf8(expected)));
            }
        };
        compare(dashboard_.line().trimmed(),
                wanted("Robotmode: ", robotModeName(RobotMode(last_.robotMode))));
        compare(dashboard_.line().trimmed(),
                wanted("Safetymode: ", safetyModeName(SafetyMode(last_.safetyMode))));
        compare(dashboard_.line().trimmed(),
                wanted("Safetystatus: ", safetyModeName(SafetyMode(last_.safetyStatus))));
        compare(dashboard_.line().trimmed(), last_.runtimeState != 1 && last_.runtimeState != 4
                                                 ? "Program running: true"
                                                 : "Program running: false");
    }

    void readPrimary() {
        for (const QByteArray& package : primary_.packages()) {
            if (package[4] == 20 && package[14] == 5) {
                told_ << int(static_cast<unsigned char>(package[15 + 8]));
            }
            if (package[4] != 16) {
                continue;
            }
            const double time = static_cast<double>(qFromBigEndian<quint64>(package.constData() + 10)) * 1e-9;
            const auto found = history_.find(key(time));
            if (found == history_.end()) {
                continue;  // messages from before the start of the observation
            }
            const Sample& then = found->second;
            const auto flag = [&package](int at) { return int(package[5 + at]); };
            expect("primary power on", flag(15), int(then.robotBits & 1U));
            expect("primary emergency stopped", flag(16), int((then.safetyBits >> 7) & 1U));
            expect("primary protective stopped", flag(17), int((then.safetyBits >> 2) & 1U));
            expect("primary program running", flag(18), int((then.robotBits >> 1) & 1U));
            expect("primary program paused", flag(19), then.runtimeState == 4);
            expect("primary robot mode", flag(20), then.robotMode);
            if (std::abs(doubleAt(package, 5 + 22) - then.slider) > 1e-9) {
                complain(QStringLiteral("primary speed fraction differs"));
            }
            for (qsizetype at = 5; at + 5 <= package.size(); at += intAt(package, at)) {
                if (package[at + 4] == 3) {
                    expect("masterboard safety mode", package[at + 65], then.safetyMode);
                    expect("masterboard reduced", package[at + 66], int((then.safetyBits >> 1) & 1U));
                } else if (package[at + 4] == 1) {
                    expect("primary joint mode", static_cast<unsigned char>(package[at + 5 + 40]),
                           then.jointMode);
                }
            }
        }
    }

    static qint64 key(double time) { return qRound64(time * 1e4); }

    VirtualRobot& robot_;
    RawRtde rtde_;
    RawPrimary primary_;
    RawPrimary realtime_;
    RawDashboard dashboard_;
    std::map<qint64, Sample> history_;
    Sample last_;
    double time_ = 0;
    int tick_ = 0;
    QList<int> robotModes_, runtimeStates_, changes_, told_;
    QStringList complaints_;
};

}  // namespace tiller::test
