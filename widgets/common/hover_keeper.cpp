// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/common/hover_keeper.h"

#include <QApplication>
#include <QCursor>
#include <QHoverEvent>
#include <QMouseEvent>
#include <QPointer>
#include <QPointingDevice>
#include <QWidget>
#include <utility>

namespace tiller {

namespace {

void leave(QWidget& widget) {
    QEvent left(QEvent::Leave);
    QCoreApplication::sendEvent(&widget, &left);
    if (widget.testAttribute(Qt::WA_Hover)) {
        const QPointF outside(-1, -1);
        QHoverEvent hover(QEvent::HoverLeave, outside, widget.mapToGlobal(outside), outside);
        QCoreApplication::sendEvent(&widget, &hover);
    }
    widget.update();
}

}  // namespace

HoverKeeper::HoverKeeper(QObject* parent) : QObject(parent) {
    qApp->installEventFilter(this);
}

HoverKeeper::~HoverKeeper() {
    qApp->removeEventFilter(this);
}

bool HoverKeeper::eventFilter(QObject* watched, QEvent* event) {
    switch (event->type()) {
        case QEvent::Hide:
        case QEvent::WindowDeactivate:
            if (watched->isWidgetType() && static_cast<QWidget*>(watched)->isWindow()) {
                lookSoon();
            }
            break;
        case QEvent::TouchEnd:
        case QEvent::TouchCancel:
            byFinger_ = true;
            lookSoon();
            break;
        case QEvent::MouseButtonRelease: {
            const QPointingDevice* device = static_cast<QMouseEvent*>(event)->pointingDevice();
            if (device != nullptr && device->type() == QInputDevice::DeviceType::TouchScreen) {
                byFinger_ = true;
                lookSoon();
            }
            break;
        }
        default:
            break;
    }
    return false;
}

void HoverKeeper::lookSoon() {
    if (!pending_) {
        pending_ = true;
        // Call look() later, after Qt has processed the event.
        QMetaObject::invokeMethod(this, &HoverKeeper::look, Qt::QueuedConnection);
    }
}

void HoverKeeper::look() {
    pending_ = false;
    if (QGuiApplication::mouseButtons() != Qt::NoButton) {
        return;  // a pressed widget keeps its hover state
    }
    const QWidget* under = std::exchange(byFinger_, false) ? nullptr : QApplication::widgetAt(QCursor::pos());
    QList<QPointer<QWidget>> left;
    for (QWidget* widget : QApplication::allWidgets()) {
        if (widget->underMouse() && (under == nullptr || (widget != under && !widget->isAncestorOf(under)))) {
            left.append(widget);
        }
    }
    for (const QPointer<QWidget>& widget : left) {
        if (widget) {
            leave(*widget);
        }
    }
}

}  // namespace tiller

#include "moc_hover_keeper.cpp"
