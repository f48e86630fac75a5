// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The small buttons in the corner of the 3D view for the viewing directions and for fitting the view.

#include <QWidget>

#include "widgets/scene/camera.h"

class QHBoxLayout;

namespace tiller {

class SceneKeys : public QWidget {
    Q_OBJECT

public:
    explicit SceneKeys(QWidget* parent = nullptr);

Q_SIGNALS:
    void lookWanted(tiller::StandardView from);
    void fitWanted();

protected:
    void changeEvent(QEvent* event) override;

private:
    template <class Pressed>
    void addKey(const char* name, const QString& text, const QString& says, Pressed pressed);
    void style();

    QHBoxLayout* row_;
};

}  // namespace tiller
