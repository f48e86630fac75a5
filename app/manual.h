// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Location of the manual, and the page for each part of the window.

#include <QString>
#include <QVector>

class QWidget;

namespace tiller::app {

/// A part of the window and its page.
struct ManualPlace {
    QString widget;  ///< objectName of the part
    QString page;    ///< relative to manualFolder(), e.g. "window/io.html#gripper"
};

/// All parts that have a page.
const QVector<ManualPlace>& manualPlaces();

/// The page for the focus widget: the page of the innermost part that contains it, otherwise the table of
/// contents.
QString manualPageOf(const QWidget* focus);

/// Folder of the manual: next to the folder of this program, or in the system's data folders. Empty if not
/// installed.
QString manualFolder();

}  // namespace tiller::app
