// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Keeps a widget at the lower edge of another, which ends above it as long as it is shown: no row moves, and none is
// covered.

#include <QList>
#include <QObject>

class QWidget;

namespace tiller {

class LowerEdge : public QObject {
    Q_OBJECT

public:
    /// shown  becomes a child of `page`
    /// areas  of that page; the first that is visible counts
    LowerEdge(QWidget& shown, QWidget& page, const QList<QWidget*>& areas);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void place();
    void reserve(QWidget* area, int height);

    QWidget& shown_;
    QWidget& page_;
    QList<QWidget*> areas_;
    QWidget* reservedIn_ = nullptr;  ///< of the areas; it ends above the widget
    int reserved_ = 0;               ///< [px]
    bool placing_ = false;
};

}  // namespace tiller
