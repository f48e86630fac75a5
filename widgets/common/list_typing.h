// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Keyboard search in lists: letters select the row that begins with them. During a search, letters do not trigger
// commands, such as the T in "waypoint 5" or the G in "magazine".

#include <QElapsedTimer>
#include <QObject>

class QAbstractItemView;
class QWidget;

namespace tiller {

class ListTyping : public QObject {
    Q_OBJECT

public:
    /// Follows this list for its lifetime.
    explicit ListTyping(QAbstractItemView& list);

    /// True for a followed list during a keyboard search.
    static bool isAt(const QWidget* widget);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    bool isGoingOn() const;

    QElapsedTimer lastLetter_;
};

}  // namespace tiller
