// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/scene/scene_keys.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QToolButton>

#include "widgets/common/density.h"
#include "widgets/common/theme.h"

namespace tiller {

SceneKeys::SceneKeys(QWidget* parent) : QWidget(parent), row_(new QHBoxLayout(this)) {
    setObjectName(QStringLiteral("scene.keys"));
    row_->setContentsMargins(0, 0, 0, 0);
    row_->setSpacing(4);
    row_->setSizeConstraint(QLayout::SetFixedSize);
    const auto look = [this](StandardView from) { return [this, from] { Q_EMIT lookWanted(from); }; };
    addKey("scene.home", tr("3D"), tr("Default view (perspective)"), look(StandardView::Home));
    addKey("scene.front", tr("Front"), tr("Look from the front: base X to the right, Z up"),
           look(StandardView::Front));
    addKey("scene.side", tr("Side"), tr("Look from the side: base Y to the right, Z up"),
           look(StandardView::Side));
    addKey("scene.top", tr("Top"), tr("Look from above: base X to the right, Y up"), look(StandardView::Top));
    addKey("scene.fit", tr("Fit"), tr("Fit the arm, target and waypoints in the view"),
           [this] { Q_EMIT fitWanted(); });
    style();
}

template <class Pressed>
void SceneKeys::addKey(const char* name, const QString& text, const QString& says, Pressed pressed) {
    auto* key = new QToolButton(this);
    key->setObjectName(QLatin1String(name));
    key->setText(text);
    key->setToolTip(says);
    key->setAccessibleName(says);
    key->setFocusPolicy(Qt::TabFocus);
    connect(key, &QToolButton::clicked, this, pressed);
    row_->addWidget(key);
}

void SceneKeys::style() {
    const Theme& theme = Theme::current();
    // The buttons are inside the image and therefore less prominent than other buttons.
    const int height = currentDensity() == Density::Touch ? keyHeight(Density::Touch) : 24;
    const QString sheet =
        QStringLiteral(
            "QToolButton { color: %1; background: %2; border: 1px solid %3; border-radius: 4px; "
            "font-size: 13px; padding: 0 7px; min-height: %6px; }"
            "QToolButton:hover { background: %4; } QToolButton:focus { border-color: %5; }")
            .arg(theme.secondary.name(), theme.panel.name(), theme.border.name(), theme.hover.name(),
                 theme.moving.name(), QString::number(height));
    const QList<QToolButton*> keys = findChildren<QToolButton*>();
    for (QToolButton* key : keys) {
        if (key->styleSheet() != sheet) {
            key->setStyleSheet(sheet);
        }
    }
}

void SceneKeys::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::StyleChange) {
        style();
    }
}

}  // namespace tiller

#include "moc_scene_keys.cpp"
