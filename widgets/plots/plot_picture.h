// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Exports the displayed range as an image, for reports.

#include <QString>

#include "robot/core/result.h"

namespace tiller {

class PlotView;
class SignalStore;
class StateLane;

struct PictureText {
    QString title;   ///< source of the data
    QString detail;  ///< date, and values at the cursors
};

/// Draws a white page that does not depend on the theme. The page contains title, date, legend, axes, curves,
/// cursors and lane, without controls. The file extension selects the format: .png (twice the screen
/// resolution), or .svg and .pdf (vector graphics).
/// view, store, lane  the displayed range and its data
/// Errors             InvalidArgument (another extension), FileNotWritable, DiskFull; an error leaves an
/// existing file unchanged
/// Threads            GUI
Result<void> exportPicture(const PlotView& view, SignalStore& store, const StateLane& lane,
                           const PictureText& text, const QString& path);

}  // namespace tiller
