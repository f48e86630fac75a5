// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Removes the hover state of widgets that the pointer has left without an event: after a touch release,
// because there is no pointer, and while a menu or dialog is open, because the widgets below it receive no
// move events.

#include <QObject>

namespace tiller {

/// One instance serves the whole application.
/// Threads  GUI
class HoverKeeper : public QObject {
    Q_OBJECT

public:
    explicit HoverKeeper(QObject* parent = nullptr);
    ~HoverKeeper() override;

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void lookSoon();
    void look();

    bool pending_ = false;
    bool byFinger_ = false;  ///< the last event was from a touch screen
};

}  // namespace tiller
