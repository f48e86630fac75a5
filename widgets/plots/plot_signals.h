// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The signals the plots know: what they are called, what unit they have, how their curve looks.

#include <QPen>
#include <QString>
#include <cstdint>
#include <span>

namespace tiller {

struct Theme;

enum class PlotSignal : std::uint8_t {
    ForceX,
    ForceY,
    ForceZ,
    TorqueX,
    TorqueY,
    TorqueZ,
    CurrentBase,
    CurrentShoulder,
    CurrentElbow,
    CurrentWrist1,
    CurrentWrist2,
    CurrentWrist3,
};
inline constexpr int kPlotSignalCount = 12;

namespace plot_signals {

/// "Fz", "Wrist 1"
QString label(PlotSignal signal);
/// "N", "Nm", "A"
QString unit(PlotSignal signal);
/// Digits behind the point that are worth reading.
int digits(PlotSignal signal);
/// Name of the column in a CSV file, as in recordings: "actual_TCP_force_2".
const char* column(PlotSignal signal);
QColor color(PlotSignal signal, const Theme& theme);
/// Cosmetic pen of a curve; joints from the fifth are dashed, so that no curve is told by colour alone.
QPen pen(PlotSignal signal, const Theme& theme);

std::span<const PlotSignal> tcpForce();
std::span<const PlotSignal> tcpTorque();
std::span<const PlotSignal> jointCurrent();

}  // namespace plot_signals
}  // namespace tiller
