// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Keeps a widget at the lower edge of another, over it and not beside it: what comes and goes while a hand is on
// its way to a row pushes no row away.

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

    QWidget& shown_;
    QWidget& page_;
    QList<QWidget*> areas_;
    bool placing_ = false;
};

}  // namespace tiller
