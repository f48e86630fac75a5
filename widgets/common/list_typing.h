// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Letters typed at a list look for the row that begins with them. Once a word has begun its letters are letters: the
// T of "waypoint 5" teaches nothing and the G of "magazine" moves nothing.

#include <QElapsedTimer>
#include <QObject>

class QAbstractItemView;
class QWidget;

namespace tiller {

class ListTyping : public QObject {
    Q_OBJECT

public:
    /// Follows this list for as long as it lives.
    explicit ListTyping(QAbstractItemView& list);

    /// True for a followed list at which a word is being typed.
    static bool isAt(const QWidget* widget);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    bool isGoingOn() const;

    QElapsedTimer lastLetter_;
};

}  // namespace tiller
