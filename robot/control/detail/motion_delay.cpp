// SPDX-License-Identifier: MIT
#include "robot/control/detail/motion_delay.h"

#include "robot/core/clock.h"

namespace tiller::control {

namespace {

QString inWholeMs(std::int64_t ns) {
    return QString::number((ns + kNsPerMs / 2) / kNsPerMs);
}

}  // namespace

QString MotionDelay::text() const {
    const QString measured = inWholeMs(measuredNs);
    const QString limit = inWholeMs(limitNs);
    const QString timeout = QStringLiteral("a longer heartbeat timeout for moves to a target (at most 4 s)");
    const QString busy =
        QStringLiteral("Use real-time priority, reduce the load on this computer, or use %1").arg(timeout);
    const QString network = QStringLiteral("Check the network, or use %1").arg(timeout);
    switch (kind) {
        case Kind::None:
            break;
        case Kind::Data:
            if (2 * stalledNs >= measuredNs) {
                return QStringLiteral(
                           "no data from the robot for %1 ms (limit %2 ms): this computer was busy, and its "
                           "control thread did not run for %3 ms. %4")
                    .arg(measured, limit, inWholeMs(stalledNs), busy);
            }
            return QStringLiteral(
                       "no data from the robot for %1 ms (limit %2 ms): the control thread was waiting for "
                       "data. %3")
                .arg(measured, limit, network);
        case Kind::Answer:
            return QStringLiteral("the control program on the robot did not respond for %1 ms (limit %2 ms)")
                .arg(measured, limit);
        case Kind::RoundTrip:
            return QStringLiteral("the robot responded to a command after %1 ms (limit %2 ms). %3")
                .arg(measured, limit, network);
        case Kind::Heartbeat:
            return QStringLiteral(
                       "the robot received no heartbeat for more than %1 ms. This computer sent at least one "
                       "every %2 ms. %3")
                .arg(limit, measured, measuredNs > limitNs / 2 ? busy : network);
    }
    return {};
}

}  // namespace tiller::control
