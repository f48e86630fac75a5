// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Shows the target of a button as a ghost while the pointer is on the button or the button is held.

#include <QHash>
#include <QObject>
#include <functional>
#include <optional>

#include "robot/station/link/robot_session.h"
#include "widgets/common/scene_marks.h"

namespace tiller {

class HoldToRunButton;

class KeyGhosts : public QObject {
    Q_OBJECT

public:
    using Target = std::function<std::optional<MoveRequest>()>;

    explicit KeyGhosts(QObject* parent = nullptr) : QObject(parent) {}

    /// target  returns the target of a press at the time of the call; empty if the button has no target
    void offer(HoldToRunButton& key, const QString& name, Target target);
    void setState(const SessionState& state);

Q_SIGNALS:
    void wanted(const tiller::Ghost& ghost);
    void gone();

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    struct Offer {
        QString name;
        Target target;
    };
    void show(const Offer& offer);
    void hide();

    SessionState state_;
    bool shown_ = false;
    QHash<QObject*, Offer> offers_;
};

}  // namespace tiller
