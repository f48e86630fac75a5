// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The shown range as a picture for a report.

#include <QString>

#include "robot/core/result.h"

namespace tiller {

class PlotView;
class SignalStore;
class StateLane;

struct PictureText {
    QString title;   ///< whose data these are
    QString detail;  ///< date, and what the cursors read
};

/// On a white page, whatever the application's colours: title, date, legend, axes, curves, cursors and lane, and
/// no controls. The ending of the path decides: .png (twice as fine as the screen), .svg and .pdf (lines, not
/// pixels).
/// view, store, lane  what the view shows, and shows it from
/// Errors   InvalidArgument (another ending), FileNotWritable, DiskFull; the file that was there before stays
/// Threads  GUI
Result<void> exportPicture(const PlotView& view, SignalStore& store, const StateLane& lane,
                           const PictureText& text, const QString& path);

}  // namespace tiller
