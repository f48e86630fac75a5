// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/session/replay_moment.h"

#include <QCoreApplication>

#include "widgets/common/format.h"

namespace tiller {

namespace {

/// The texts of this file for the translators: lupdate finds them by this name.
struct ReplayText {
    Q_DECLARE_TR_FUNCTIONS(Replay)
};

}  // namespace

QString ReplayMoment::words() const {
    QStringList parts{source.isEmpty()
                          ? ReplayText::tr("REPLAY · history at %1 s").arg(format::number(time, 3))
                          : ReplayText::tr("REPLAY · %1 at %2 s").arg(source, format::number(seconds, 3))};
    if (wallTime.isValid()) {
        parts << wallTime.toString(QStringLiteral("HH:mm:ss.zzz"));
    }
    if (sample.isEmpty()) {
        parts << ReplayText::tr("no data");
    }
    return parts.join(QStringLiteral(" · "));
}

}  // namespace tiller
