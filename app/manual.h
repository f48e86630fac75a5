// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The manual as the window shows it: where its pages lie, and which of them is about what.

#include <QString>
#include <QVector>

class QWidget;

namespace tiller::app {

/// A part of the window and what explains it.
struct ManualPlace {
    QString widget;  ///< its objectName
    QString page;    ///< as in "window/io.html#gripper", below manualFolder()
};

/// Every part that has a page of its own.
const QVector<ManualPlace>& manualPlaces();

/// The page about what has the focus: that of the innermost part of the window around it. The contents for all else.
QString manualPageOf(const QWidget* focus);

/// Where the pages are: beside the folder of this program, or where the system keeps what programs share. Empty where
/// nobody has built them.
QString manualFolder();

}  // namespace tiller::app
