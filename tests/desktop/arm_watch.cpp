// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/desktop/arm_watch.h"

#include <QElapsedTimer>
#include <QTest>
#include <algorithm>
#include <cmath>

namespace tiller::test {
namespace {

// Commanded speeds have no noise. Measured speeds are noisy, but they show an arm that an external force
// moves in freedrive.
constexpr double kCommandedMoves = 5e-4;  // [rad/s]
constexpr double kMeasuredMoves = 0.012;  // [rad/s]
// If no data arrive for this time, the controller is considered to have stopped.
constexpr int kSilenceMs = 20'000;

double largest(std::span<const double> values) {
    double most = 0;
    for (const double value : values) {
        most = std::max(most, std::abs(value));
    }
    return most;
}

receive::ReceiverOptions optionsFor(const QString& host) {
    receive::ReceiverOptions options;
    options.host = host;
    options.fields = {"timestamp", "actual_q", "actual_qd", "target_qd", "actual_TCP_pose"};
    options.priority = 0;
    return options;
}

}  // namespace

ArmWatch::ArmWatch(const QString& host) : receiver_(optionsFor(host)), sample_(receiver_.layout()) {
    timestamp_ = receiver_.layout()->indexOfComponent("timestamp").value();
    receiver_.start().value();
}

bool ArmWatch::isConnected() {
    return follow([](const receive::Sample&) { return true; });
}

bool ArmWatch::isMoving(const receive::Sample& sample) const {
    return largest(sample.field("target_qd")) > kCommandedMoves ||
           largest(sample.field("actual_qd")) > kMeasuredMoves;
}

bool ArmWatch::follow(const std::function<bool(const receive::Sample&)>& done) {
    receive::Subscription packages = receiver_.subscribe();
    QElapsedTimer silence;
    silence.start();
    while (silence.elapsed() < kSilenceMs) {
        while (packages.next(sample_)) {
            silence.restart();
            if (done(sample_)) {
                return true;
            }
        }
        QTest::qWait(1);
    }
    return false;
}

bool ArmWatch::moves() {
    receiver_.latest(sample_);
    return isMoving(sample_);
}

bool ArmWatch::untilMoving(double seconds) {
    std::optional<double> from;
    double lastStood = 0;
    bool underWay = false;
    follow([&](const receive::Sample& sample) {
        const double now = timeOf(sample);
        if (!from) {
            from = lastStood = now;
        }
        if (!isMoving(sample)) {
            lastStood = now;
        }
        underWay = now - lastStood >= kConnectPending;
        return underWay || (now - *from > seconds && now - lastStood < 0.01);
    });
    return underWay;
}

bool ArmWatch::untilStanding(double seconds, double quiet) {
    std::optional<double> from;
    double lastMoved = 0;
    bool stood = false;
    follow([&](const receive::Sample& sample) {
        const double now = timeOf(sample);
        if (!from) {
            from = lastMoved = now;
        }
        if (isMoving(sample)) {
            lastMoved = now;
        }
        stood = now - lastMoved >= quiet;
        return stood || now - *from > seconds;
    });
    return stood;
}

Standstill ArmWatch::standstill(double contract, double quiet, const std::function<void()>& whileMoving) {
    Standstill result;
    std::optional<double> from;
    double lastMoved = 0;
    const bool seen = follow([&](const receive::Sample& sample) {
        const double now = timeOf(sample);
        if (!from) {
            from = lastMoved = now;
        }
        if (isMoving(sample)) {
            lastMoved = now;
            whileMoving();
        }
        return now - lastMoved >= quiet || now - *from >= kGoesOnAfter;
    });
    if (!seen) {
        return result;
    }
    result.seconds = lastMoved - *from;
    result.verdict = result.seconds <= contract              ? Standstill::Verdict::Stood
                     : result.seconds < kGoesOnAfter - quiet ? Standstill::Verdict::Late
                                                             : Standstill::Verdict::GoesOn;
    return result;
}

bool ArmWatch::stays(double seconds) {
    std::optional<double> from;
    bool moved = false;
    const bool seen = follow([&](const receive::Sample& sample) {
        from = from.value_or(timeOf(sample));
        moved = isMoving(sample);
        return moved || timeOf(sample) - *from >= seconds;
    });
    return seen && !moved;
}

Vector6 ArmWatch::six(const char* field) {
    receiver_.latest(sample_);
    const std::span<const double> values = sample_.field(field);
    Vector6 six = Vector6::Zero();
    for (std::size_t i = 0; i < std::min<std::size_t>(values.size(), 6); ++i) {
        six[Eigen::Index(i)] = values[i];
    }
    return six;
}

Vector6 ArmWatch::joints() {
    return six("actual_q");
}

Vector6 ArmWatch::tcpPose() {
    return six("actual_TCP_pose");
}

double ArmWatch::speed() {
    return six("target_qd").cwiseAbs().maxCoeff();
}

}  // namespace tiller::test
