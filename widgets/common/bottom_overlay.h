// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Shows a widget at the bottom of a page. While the widget is visible, the area above it becomes shorter, so
// that rows are neither moved nor covered.

#include <QList>
#include <QObject>

class QWidget;

namespace tiller {

class BottomOverlay : public QObject {
    Q_OBJECT

public:
    /// shown  becomes a child of `page`
    /// areas  areas of the page; the first visible area becomes shorter
    BottomOverlay(QWidget& shown, QWidget& page, const QList<QWidget*>& areas);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void place();
    void reserve(QWidget* area, int height);

    QWidget& shown_;
    QWidget& page_;
    QList<QWidget*> areas_;
    QWidget* reservedIn_ = nullptr;  ///< area with the reserved margin
    int reserved_ = 0;               ///< height of the reserved margin [px]
    bool placing_ = false;
};

}  // namespace tiller
