// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Keeps a widget at the bottom of another one. While it is shown, the area above ends earlier: no row is
// moved or covered.

#include <QList>
#include <QObject>

class QWidget;

namespace tiller {

class BottomOverlay : public QObject {
    Q_OBJECT

public:
    /// shown  becomes a child of `page`
    /// areas  of this page; the first visible one is used
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
