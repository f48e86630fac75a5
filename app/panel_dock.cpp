// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panel_dock.h"

#include <QApplication>
#include <QCloseEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QMenu>
#include <QMouseEvent>
#include <QToolButton>

#include "widgets/common/elided_label.h"
#include "widgets/common/panel.h"
#include "widgets/common/theme.h"

namespace tiller::app {

using control::StopCause;

namespace {

QToolButton* quietKey(const QString& text, const QString& name) {
    auto* key = new QToolButton;
    key->setObjectName(name);
    key->setText(text);
    key->setAccessibleName(text);
    key->setProperty("quiet", true);
    key->setFocusPolicy(Qt::TabFocus);
    return key;
}

}  // namespace

/// The bar of the dock: one pixel high when docked, and a title bar when floating.
class PanelDock::Bar : public QWidget {
public:
    explicit Bar(PanelDock& dock) : QWidget(&dock), layout_(new QHBoxLayout(this)) {
        // The robot comes first and in full, because floating panels of two windows look alike.
        robot_->setFont(textFont(16, QFont::Bold));
        auto* name = new ElidedLabel;
        name->setFullText(dock.windowTitle());
        name->setFont(textFont(14));
        auto* back = quietKey(PanelDock::tr("Dock"), "dock.back." + dock.objectName());
        back->setToolTip(PanelDock::tr("Moves this panel back to the main window."));
        auto* close = quietKey(PanelDock::tr("Close"), "dock.close." + dock.objectName());
        close->setToolTip(PanelDock::tr("Closes this panel. Use the View menu to show it again."));
        // Use a queued connection, because both slots may destroy the window to which Qt is still delivering
        // key events.
        connect(
            back, &QToolButton::clicked, &dock, [&dock] { dock.setFloating(false); }, Qt::QueuedConnection);
        connect(
            close, &QToolButton::clicked, &dock, [&dock] { dock.close(); }, Qt::QueuedConnection);
        robot_->setObjectName("dock.robot." + dock.objectName());
        parts_ = {robot_, name, back, close};
        layout_->setSpacing(12);
        layout_->addWidget(robot_);
        layout_->addWidget(name, 1);
        layout_->addWidget(back);
        layout_->addWidget(close);
        setFloating(false);
        connect(&dock, &QDockWidget::topLevelChanged, this, &Bar::setFloating);
    }
    void setRobot(const QString& robot) { robot_->setText(robot); }

private:
    void setFloating(bool floating) {
        for (QWidget* part : std::as_const(parts_)) {
            part->setVisible(floating);
        }
        layout_->setContentsMargins(floating ? QMargins(12, 4, 6, 4) : QMargins(0, 0, 0, kDockedBar));
        updateGeometry();
    }

    QHBoxLayout* layout_;
    QLabel* robot_ = new QLabel;
    QList<QWidget*> parts_;
};

/// The button in the title bar of the panel. A click opens the menu, and a drag moves the panel.
class PanelDock::Key : public QToolButton {
public:
    explicit Key(PanelDock& dock) : dock_(dock) {
        setObjectName("dock.menu." + dock.objectName());
        setProperty("quiet", true);
        setFocusPolicy(Qt::TabFocus);
        setText(QStringLiteral("···"));
        setAccessibleName(PanelDock::tr("Move, float or close %1").arg(dock.windowTitle()));
        setToolTip(PanelDock::tr("Click to move, float or close this panel. Drag to move it."));
        connect(this, &QToolButton::clicked, this,
                [this] { dock_.menu_->popup(mapToGlobal(QPoint(0, height()))); });
    }

protected:
    void mousePressEvent(QMouseEvent* event) override {
        pressedAt_ = event->globalPosition();
        QToolButton::mousePressEvent(event);
    }
    void mouseMoveEvent(QMouseEvent* event) override {
        const bool far =
            (event->globalPosition() - pressedAt_).manhattanLength() > QApplication::startDragDistance();
        if (isDown() && far && !dock_.isFloating()) {
            setDown(false);
            dock_.beginDrag(pressedAt_, *event);
            return;
        }
        QToolButton::mouseMoveEvent(event);
    }

private:
    PanelDock& dock_;
    QPointF pressedAt_;
};

PanelDock::PanelDock(Panel& panel, const QString& name, const QString& title, QWidget* parent)
    : QDockWidget(title, parent), panel_(panel), menu_(new QMenu(this)) {
    setObjectName(name);
    setFeatures(DockWidgetFloatable | DockWidgetMovable | DockWidgetClosable);
    menu_->setObjectName("menu." + name);
    menu_->setToolTipsVisible(true);
    bar_ = new Bar(*this);
    setTitleBarWidget(bar_);
    setWidget(&panel);
    panel.addHeaderWidget(new Key(*this));
    connect(this, &QDockWidget::topLevelChanged, this, &PanelDock::rearranged);
    connect(this, &QDockWidget::dockLocationChanged, this, &PanelDock::rearranged);
    connect(toggleViewAction(), &QAction::triggered, this, &PanelDock::rearranged);
}

void PanelDock::floatFree() {
    show();
    setFloating(true);
    place_ = pos();
}

void PanelDock::setRobot(const QString& robot) {
    bar_->setRobot(robot);
}

// If Qt asks for the position of a new window before the window manager has placed it, Qt reads the upper
// left corner of the screen and keeps this position. The window would then cover the jog buttons.
void PanelDock::keepInPlace() {
    if (place_ && pos().isNull() && pos() != *place_) {
        QMetaObject::invokeMethod(
            this, [this, place = *place_] { move(place); }, Qt::QueuedConnection);
        place_.reset();
    }
}

bool PanelDock::event(QEvent* event) {
    switch (event->type()) {
        case QEvent::MouseButtonPress:
        case QEvent::MouseMove:
        case QEvent::MouseButtonRelease:
            place_.reset();  // from now on, the user moves the window
            if (!isFloating()) {
                return barEvent(*static_cast<QMouseEvent*>(event));
            }
            break;
        case QEvent::Move:
            keepInPlace();
            break;
        case QEvent::WindowDeactivate:
            if (isWindow()) {
                Q_EMIT attentionLost(StopCause::WindowDeactivated);
            }
            break;
        case QEvent::WindowStateChange:
            if (isWindow() && isMinimized()) {
                Q_EMIT attentionLost(StopCause::WindowDeactivated);
            }
            break;
        default:
            break;
    }
    return QDockWidget::event(event);
}

void PanelDock::closeEvent(QCloseEvent* event) {
    Q_EMIT attentionLost(StopCause::WindowClosed);
    QDockWidget::closeEvent(event);
    Q_EMIT rearranged();
}

// Forwards a press on the title bar of the panel to the bar of the dock above it, because Qt starts a drag
// only there.
bool PanelDock::barEvent(QMouseEvent& event) {
    if (event.type() == QEvent::MouseButtonPress) {
        const QRect bar(panel_.mapTo(this, QPoint(0, 0)), QSize(panel_.width(), Panel::kHeaderHeight));
        const bool onBar = bar.contains(event.position().toPoint());
        pressedY_ = onBar ? std::optional(event.position().y()) : std::nullopt;
    }
    if (!pressedY_) {
        return QDockWidget::event(&event);
    }
    QMouseEvent onBar(event.type(), event.position() - QPointF(0, *pressedY_), event.globalPosition(),
                      event.button(), event.buttons(), event.modifiers());
    const bool taken = QDockWidget::event(&onBar);
    event.setAccepted(onBar.isAccepted());
    return taken;
}

void PanelDock::beginDrag(const QPointF& pressedAt, const QMouseEvent& now) {
    const QPointF local(mapFromGlobal(pressedAt).x(), 0);
    QMouseEvent press(QEvent::MouseButtonPress, local, pressedAt, Qt::LeftButton, Qt::LeftButton,
                      Qt::NoModifier);
    QDockWidget::event(&press);
    QMouseEvent move(QEvent::MouseMove, local + now.globalPosition() - pressedAt, now.globalPosition(),
                     Qt::NoButton, Qt::LeftButton, Qt::NoModifier);
    QDockWidget::event(&move);
}

}  // namespace tiller::app

#include "moc_panel_dock.cpp"
