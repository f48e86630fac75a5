// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Shows a widget as an overlay at the bottom of another one, so that the rows do not move when it appears or
// disappears.

#include <QList>
#include <QObject>

class QWidget;

namespace tiller {

class LowerEdge : public QObject {
    Q_OBJECT

public:
    /// shown  becomes a child of `page`
    /// areas  of this page; the first visible one is used
    LowerEdge(QWidget& shown, QWidget& page, const QList<QWidget*>& areas);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void place();

    QWidget& shown_;
    QWidget& page_;
    QList<QWidget*> areas_;
    bool placing_ = false;
};

}  // namespace tiller
