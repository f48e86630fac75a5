// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/ui/places_watch.h"

#include <QAbstractButton>
#include <QAbstractScrollArea>
#include <QAbstractSlider>
#include <QAbstractSpinBox>
#include <QApplication>
#include <QComboBox>
#include <QLineEdit>
#include <QScrollBar>
#include <QTabBar>
#include <algorithm>
#include <cstdlib>

#include "widgets/common/state_chip.h"

namespace tiller::test {
namespace {

/// A control whose purpose is to change the layout around it. Contains the name of the control, or of the
/// control that contains it, and the name of the widget whose layout it changes.
struct ShapingKey {
    const char* key;
    const char* shapes;
};
constexpr ShapingKey kShapingKeys[] = {
    {"jogDetail", "jogColumn"},            // selects pose or joints in small windows
    {"settings.density", "settingsPage"},  // changes the size of all buttons and rows
    {"frame.fromTcp", "frames"},           // replaces the list by the guide
    {"frame.threePoints", "frames"},       //
    {"frame.touchUp", "frames"},           //
    {"frame.teacher.make", "frames"},      // shows the list again
    {"frame.teacher.cancel", "frames"},    //
};

const QWidget* ancestorNamed(const QWidget& widget, const char* name) {
    for (const QWidget* at = &widget; at != nullptr; at = at->parentWidget()) {
        if (at->objectName() == QLatin1String(name)) {
            return at;
        }
    }
    return nullptr;
}

QRect placeIn(const QWidget& window, const QWidget& control) {
    return {control.mapTo(&window, QPoint(0, 0)), control.size()};
}

QString reported(const QRect& rect) {
    return QStringLiteral("%1,%2 %3x%4").arg(rect.x()).arg(rect.y()).arg(rect.width()).arg(rect.height());
}

}  // namespace

QString nameOf(const QWidget& widget) {
    QString name = widget.objectName();
    if (name.isEmpty()) {
        name = widget.accessibleName();
    }
    if (name.isEmpty()) {
        if (const auto* button = qobject_cast<const QAbstractButton*>(&widget)) {
            name = button->text();
        }
    }
    if (name.isEmpty()) {
        for (const QWidget* at = widget.parentWidget(); at != nullptr && name.isEmpty();
             at = at->parentWidget()) {
            if (!at->objectName().isEmpty()) {
                name = QStringLiteral("something in ") + at->objectName();
            }
        }
    }
    return QStringLiteral("%1 (%2)").arg(name, QLatin1String(widget.metaObject()->className()));
}

namespace {

/// True for chips that open a menu or the recovery page. All other chips are read-only.
bool isPressed(const StateChip* chip) {
    return chip != nullptr &&
           (chip->focusPolicy() != Qt::NoFocus || chip->objectName() == QLatin1String("safetyChip"));
}

}  // namespace

bool PlacesWatch::isControl(const QWidget& widget) {
    // Internal parts of Qt's controls are not checked separately.
    if (widget.objectName().startsWith(QLatin1String("qt_")) ||
        qobject_cast<const QScrollBar*>(&widget) != nullptr) {
        return false;
    }
    return qobject_cast<const QAbstractButton*>(&widget) != nullptr ||
           qobject_cast<const QLineEdit*>(&widget) != nullptr ||
           qobject_cast<const QComboBox*>(&widget) != nullptr ||
           qobject_cast<const QAbstractSpinBox*>(&widget) != nullptr ||
           qobject_cast<const QAbstractSlider*>(&widget) != nullptr ||
           isPressed(qobject_cast<const StateChip*>(&widget));
}

const QWidget* PlacesWatch::containerOf(const QWidget& clicked) {
    for (const ShapingKey& shaping : kShapingKeys) {
        if (const QWidget* key = ancestorNamed(clicked, shaping.key)) {
            return ancestorNamed(*key, shaping.shapes);
        }
    }
    for (const QWidget* at = &clicked; at != nullptr && !at->isWindow(); at = at->parentWidget()) {
        if (qobject_cast<const QScrollBar*>(at) != nullptr) {
            // A scroll bar is inside a container within its scroll area.
            const QWidget* area = at->parentWidget();
            while (area != nullptr && qobject_cast<const QAbstractScrollArea*>(area) == nullptr) {
                area = area->parentWidget();
            }
            return area;
        }
        const QWidget* parent = at->parentWidget();
        if (qobject_cast<const QAbstractButton*>(at) != nullptr &&
            qobject_cast<const QLineEdit*>(parent) != nullptr) {
            return parent->parentWidget();  // the button that clears a search makes all rows appear again
        }
        if (qobject_cast<const QAbstractButton*>(at) != nullptr &&
            qobject_cast<const QTabBar*>(parent) != nullptr) {
            return ancestorNamed(*parent, "plots");  // closing the last but one page closes the row of tabs
        }
    }
    return nullptr;
}

bool PlacesWatch::isNear(const QRect& rect) const {
    return rect.adjusted(-kReach, -kReach, kReach, kReach).contains(at_);
}

void PlacesWatch::begin(const QWidget& window, QPoint at) {
    window_ = &window;
    at_ = at;
    modal_ = QApplication::activeModalWidget();
    popup_ = QApplication::activePopupWidget();
    hadModal_ = modal_ != nullptr;
    hadPopup_ = popup_ != nullptr;
    places_.clear();
    const QWidget* hit = window.childAt(at);
    const QWidget* excused = hit == nullptr ? nullptr : containerOf(*hit);
    const QList<QWidget*> widgets = window.findChildren<QWidget*>();
    for (const QWidget* widget : widgets) {
        if (!isControl(*widget) || !widget->isVisible() || !widget->isEnabled() ||
            widget->window() != &window || (excused != nullptr && excused->isAncestorOf(widget))) {
            continue;
        }
        const QRect rect = placeIn(window, *widget);
        places_.append({widget, rect, isNear(rect) && !widget->visibleRegion().isEmpty()});
    }
    size_ = window.size();
    sincePress_.start();
}

bool PlacesWatch::isOn() {
    if (places_.isEmpty()) {
        return false;
    }
    const bool sameDialog =
        QApplication::activeModalWidget() == modal_.data() && hadModal_ == (modal_ != nullptr);
    const bool sameMenu =
        QApplication::activePopupWidget() == popup_.data() && hadPopup_ == (popup_ != nullptr);
    if (!window_ || !window_->isVisible() || window_->size() != size_ || !sameDialog || !sameMenu ||
        sincePress_.elapsed() >= kKeepMs) {
        end();
    }
    return !places_.isEmpty();
}

QStringList PlacesWatch::moved() const {
    QStringList found;
    if (!window_ || window_->size() != size_) {
        return found;
    }
    for (const Place& place : places_) {
        if (!place.control || !place.control->isVisible() || place.control->window() != window_) {
            continue;
        }
        const QRect now = placeIn(*window_, *place.control);
        const auto apart = [](int a, int b) { return std::abs(a - b) > kUnnoticed; };
        if (!apart(now.left(), place.rect.left()) && !apart(now.top(), place.rect.top()) &&
            !apart(now.right(), place.rect.right()) && !apart(now.bottom(), place.rect.bottom())) {
            continue;
        }
        if (place.seen || (isNear(now) && !place.control->visibleRegion().isEmpty())) {
            found << QStringLiteral("%1 moved from %2 to %3, %4 ms after a click at %5,%6")
                         .arg(nameOf(*place.control), reported(place.rect), reported(now))
                         .arg(sincePress_.elapsed())
                         .arg(at_.x())
                         .arg(at_.y());
        }
    }
    return found;
}

int PlacesWatch::controlsAtPointer() const {
    return static_cast<int>(
        std::count_if(places_.begin(), places_.end(), [](const Place& place) { return place.seen; }));
}

}  // namespace tiller::test
