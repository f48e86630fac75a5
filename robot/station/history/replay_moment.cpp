// SPDX-License-Identifier: MIT
#include "robot/station/history/replay_moment.h"

#include <QCoreApplication>

#include "robot/station/text/format.h"

namespace tiller {

namespace {

/// Translation context of this file for lupdate.
struct ReplayText {
    Q_DECLARE_TR_FUNCTIONS(Replay)
};

}  // namespace

QString ReplayMoment::words() const {
    // The file name is last, so that it is elided first.
    QStringList parts{ReplayText::tr("REPLAY")};
    if (!robot.isEmpty()) {
        parts << robot;
    }
    if (wallTime.isValid()) {
        parts << wallTime.toString(QStringLiteral("HH:mm:ss.zzz"));
    }
    if (sample.isEmpty()) {
        parts << ReplayText::tr("no data");
    }
    parts << (source.isEmpty() ? ReplayText::tr("history at %1 s").arg(format::number(time, 3))
                               : ReplayText::tr("at %1 s in %2").arg(format::number(seconds, 3), source));
    return parts.join(QStringLiteral(" · "));
}

}  // namespace tiller
