// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/plots/plot_signals.h"

#include <QCoreApplication>

#include "robot/core/joints.h"
#include "widgets/common/joint_name.h"
#include "widgets/common/theme.h"

namespace tiller::plot_signals {

namespace {

constexpr int kFirstCurrent = static_cast<int>(PlotSignal::CurrentBase);

int indexOf(PlotSignal signal) {
    return static_cast<int>(signal);
}

}  // namespace

QString label(PlotSignal signal) {
    static constexpr const char* kCartesian[] = {"Fx", "Fy", "Fz", "Tx", "Ty", "Tz"};
    const int i = indexOf(signal);
    return i < kFirstCurrent ? QString::fromLatin1(kCartesian[i]) : jointName(i - kFirstCurrent);
}

QString unit(PlotSignal signal) {
    const int i = indexOf(signal);
    return i < 3 ? QStringLiteral("N") : i < kFirstCurrent ? QStringLiteral("Nm") : QStringLiteral("A");
}

int digits(PlotSignal signal) {
    const int i = indexOf(signal);
    return i < 3 ? 1 : i < kFirstCurrent ? 2 : 3;
}

const char* column(PlotSignal signal) {
    static constexpr const char* kColumns[] = {
        "actual_TCP_force_0", "actual_TCP_force_1", "actual_TCP_force_2", "actual_TCP_force_3",
        "actual_TCP_force_4", "actual_TCP_force_5", "actual_current_0",   "actual_current_1",
        "actual_current_2",   "actual_current_3",   "actual_current_4",   "actual_current_5"};
    return kColumns[indexOf(signal)];
}

QColor color(PlotSignal signal, const Theme& theme) {
    const int i = indexOf(signal);
    return i < kFirstCurrent ? theme.axis(i % 3) : theme.curves[static_cast<std::size_t>(i - kFirstCurrent)];
}

QPen pen(PlotSignal signal, const Theme& theme) {
    QPen pen(color(signal, theme), 1.6);
    pen.setCosmetic(true);
    pen.setJoinStyle(Qt::BevelJoin);
    const int curve = indexOf(signal) - kFirstCurrent;
    if (curve == 4) {
        pen.setDashPattern({6, 3});
    } else if (curve == 5) {
        pen.setDashPattern({6, 2.5, 1.5, 2.5});
    }
    return pen;
}

std::span<const PlotSignal> tcpForce() {
    static constexpr std::array kSignals = {PlotSignal::ForceX, PlotSignal::ForceY, PlotSignal::ForceZ};
    return kSignals;
}

std::span<const PlotSignal> tcpTorque() {
    static constexpr std::array kSignals = {PlotSignal::TorqueX, PlotSignal::TorqueY, PlotSignal::TorqueZ};
    return kSignals;
}

std::span<const PlotSignal> jointCurrent() {
    static constexpr std::array kSignals = {PlotSignal::CurrentBase,   PlotSignal::CurrentShoulder,
                                            PlotSignal::CurrentElbow,  PlotSignal::CurrentWrist1,
                                            PlotSignal::CurrentWrist2, PlotSignal::CurrentWrist3};
    return kSignals;
}

}  // namespace tiller::plot_signals
