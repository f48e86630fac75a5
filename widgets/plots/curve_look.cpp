// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/plots/curve_look.h"

#include <algorithm>

#include "robot/station/history/signal_store.h"
#include "widgets/common/theme.h"

namespace tiller {

namespace {

bool isOneFamily(const SignalStore& store, const std::vector<int>& shown) {
    return std::all_of(shown.begin(), shown.end(), [&](int signal) {
        return store.info(signal).family == store.info(shown.front()).family;
    });
}

QList<qreal> dashesOf(std::size_t curve) {
    // The first four are solid; then two dash patterns alternate, which become finer with every round of
    // colours.
    if (curve < 4) {
        return {};
    }
    const qreal length = curve < 6 ? 6 : curve < 12 ? 3 : 12;
    return curve % 2 == 0 ? QList<qreal>{length, length / 2} : QList<qreal>{length, 2.5, 1.5, 2.5};
}

}  // namespace

std::vector<QPen> curvePens(const SignalStore& store, const std::vector<int>& shown, const Theme& theme) {
    const bool axes = !shown.empty() && isOneFamily(store, shown) && store.info(shown.front()).axis >= 0;
    std::vector<QPen> pens;
    for (std::size_t i = 0; i < shown.size(); ++i) {
        QPen pen(axes ? theme.axis(store.info(shown[i]).axis) : theme.curves[i % theme.curves.size()], 1.6);
        pen.setCosmetic(true);
        pen.setJoinStyle(Qt::BevelJoin);
        if (const QList<qreal> dashes = axes ? QList<qreal>() : dashesOf(i); !dashes.isEmpty()) {
            pen.setDashPattern(dashes);
        }
        pens.push_back(pen);
    }
    return pens;
}

QString curveLabel(const SignalStore& store, const std::vector<int>& shown, int signal) {
    const SignalInfo& info = store.info(signal);
    return isOneFamily(store, shown) ? info.label : info.longLabel;
}

}  // namespace tiller
