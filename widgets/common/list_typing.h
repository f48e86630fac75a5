// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Keyboard search in lists: typed letters select the row whose text begins with them. During a search,
// letters such as the T in "waypoint 5" or the G in "magazine" do not trigger commands.

#include <QElapsedTimer>
#include <QObject>

class QAbstractItemView;
class QWidget;

namespace tiller {

class ListTyping : public QObject {
    Q_OBJECT

public:
    /// Handles the keyboard search of this list for the lifetime of the list.
    explicit ListTyping(QAbstractItemView& list);

    /// True if the widget is a list with an active keyboard search.
    static bool isAt(const QWidget* widget);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    bool isGoingOn() const;

    QElapsedTimer lastLetter_;
};

}  // namespace tiller
