// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Finds the manual, and its page for each part of the window.

#include <QString>
#include <QVector>

class QWidget;

namespace tiller::app {

/// A part of the window and its page in the manual.
struct ManualPlace {
    QString widget;  ///< objectName of the part
    QString page;    ///< relative to manualFolder(), e.g. "window/io.html#gripper"
};

/// All parts that have a page in the manual.
const QVector<ManualPlace>& manualPlaces();

/// Returns the page for the innermost part that contains the focus widget, otherwise the table of contents.
QString manualPageOf(const QWidget* focus);

/// Returns the folder of the manual, next to the application folder or in the system's data folders. Empty if
/// the manual is not installed.
QString manualFolder();

}  // namespace tiller::app
