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
    // The first four curves are solid. Further curves alternate between two dash patterns, with a different
    // dash length for each round of colours.
    if (curve < 4) {
        return {};
    }
    const qreal length = curve < 6 ? 6 : curve < 12 ? 3 : 12;
    return curve % 2 == 0 ? QList<qreal>{length, length / 2} : QList<qreal>{length, 2.5, 1.5, 2.5};
}

/// True if no solid curve has this colour.
bool isFreeFor(const std::vector<QPen>& pens, const QColor& color) {
    return std::none_of(pens.begin(), pens.end(), [&](const QPen& pen) {
        return pen.style() == Qt::SolidLine && pen.color() == color;
    });
}

}  // namespace

std::vector<QPen> curvePens(const SignalStore& store, const std::vector<int>& shown, const Theme& theme) {
    std::vector<QPen> pens;
    QList<QRgb> axesUsed;
    std::size_t next = 0;  // next index in the curve colours
    for (const int signal : shown) {
        const int axis = store.info(signal).axis;
        QPen pen(Qt::black, 1.6);
        if (axis >= 0 && !axesUsed.contains(theme.axis(axis).rgb()) && isFreeFor(pens, theme.axis(axis))) {
            pen.setColor(theme.axis(axis));
            axesUsed.append(theme.axis(axis).rgb());
        } else {
            const auto colorOf = [&](std::size_t curve) { return theme.curves[curve % theme.curves.size()]; };
            // The curve colours include the axis colours. For solid curves, skip the axis colours in use.
            while (dashesOf(next).isEmpty() && axesUsed.contains(colorOf(next).rgb())) {
                ++next;
            }
            pen.setColor(colorOf(next));
            if (const QList<qreal> dashes = dashesOf(next); !dashes.isEmpty()) {
                pen.setDashPattern(dashes);
            }
            ++next;
        }
        pen.setCosmetic(true);
        pen.setJoinStyle(Qt::BevelJoin);
        pens.push_back(pen);
    }
    return pens;
}

QString curveSource(const SignalStore& store, const std::vector<int>& shown, int signal) {
    const QString source = store.recordingOf(signal);
    const bool isShared = std::any_of(shown.begin(), shown.end(),
                                      [&](int other) { return store.recordingOf(other) != source; });
    return isShared ? source : QString();
}

QString curveLabel(const SignalStore& store, const std::vector<int>& shown, int signal) {
    const SignalInfo& info = store.info(signal);
    const QString name = isOneFamily(store, shown) ? info.label : info.longLabel;
    const QString source = curveSource(store, shown, signal);
    return source.isEmpty() ? name : QStringLiteral("%1 · %2").arg(name, source);
}

}  // namespace tiller
