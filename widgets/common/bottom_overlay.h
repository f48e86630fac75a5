// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Shows a widget at the bottom of a page. While the widget is visible, the area above it is shortened, so
// that no row is moved or covered.

#include <QList>
#include <QObject>

class QWidget;

namespace tiller {

class BottomOverlay : public QObject {
    Q_OBJECT

public:
    /// shown  becomes a child of `page`
    /// areas  areas of the page; the first visible one is shortened
    BottomOverlay(QWidget& shown, QWidget& page, const QList<QWidget*>& areas);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void place();
    void reserve(QWidget* area, int height);

    QWidget& shown_;
    QWidget& page_;
    QList<QWidget*> areas_;
    QWidget* reservedIn_ = nullptr;  ///< the area that is shortened
    int reserved_ = 0;               ///< height of the shortened part [px]
    bool placing_ = false;
};

}  // namespace tiller
