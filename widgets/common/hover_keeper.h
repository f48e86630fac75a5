// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Takes the look of a key under the pointer away where the pointer has gone without telling: a finger leaves no
// pointer behind, and while a menu or dialog is open the widgets below hear of no move.

#include <QObject>

namespace tiller {

/// One for the whole application.
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
    bool byFinger_ = false;  ///< what came last came from a touch screen
};

}  // namespace tiller
