// SPDX-License-Identifier: GPL-3.0-or-later
// What mouse, wheel and keyboard do in the plots. Space and Esc are left alone: they stop the robot.
#include <QApplication>
#include <QGraphicsScene>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>

#include "widgets/plots/plot_pane.h"
#include "widgets/plots/plot_view.h"

namespace tiller {

namespace {

constexpr double kGrab = 6;  // a cursor is taken hold of within this distance [px]
constexpr double kZoomPerNotch = 0.8;
constexpr int kCoarse = 10;  // arrow keys with Shift

}  // namespace

std::optional<PlotView::Cursor> PlotView::cursorNear(double x) const {
    std::optional<Cursor> found;
    double nearest = kGrab;
    for (const Cursor which : {Cursor::A, Cursor::B}) {
        const auto& time = cursors_[index(which)];
        if (time && std::abs(xAt(*time) - x) <= nearest) {
            nearest = std::abs(xAt(*time) - x);
            found = which;
        }
    }
    return found;
}

void PlotView::mousePressEvent(QMouseEvent* event) {
    event->accept();
    if (event->button() != Qt::LeftButton) {
        return;
    }
    // The entries of the legends are the only things in the scene that take a press.
    QGraphicsView::mousePressEvent(event);
    event->accept();
    if (scene()->mouseGrabberItem() != nullptr) {
        return;
    }
    pressAt_ = lastAt_ = event->position();
    drag_ = Drag::Undecided;
    if (const auto near = cursorNear(pressAt_.x())) {
        drag_ = Drag::Cursor;
        active_ = *near;
        placeCursors();
    }
}

void PlotView::mouseMoveEvent(QMouseEvent* event) {
    event->accept();
    const QPointF at = event->position();
    if (drag_ == Drag::Undecided && (at - pressAt_).manhattanLength() >= QApplication::startDragDistance()) {
        drag_ = Drag::Pan;
        lastAt_ = pressAt_;
    }
    if (drag_ == Drag::Cursor) {
        const QRectF& area = panes_[0]->area();
        setCursor(active_, timeAt(std::clamp(at.x(), area.left(), area.right())));
    } else if (drag_ == Drag::Pan) {
        const double seconds = timeAt(lastAt_.x()) - timeAt(at.x());
        lastAt_ = at;
        scrollBy(seconds);
    }
    const bool overCursor = drag_ == Drag::Cursor || (drag_ == Drag::None && cursorNear(at.x()));
    viewport()->setCursor(overCursor           ? Qt::SplitHCursor
                          : drag_ == Drag::Pan ? Qt::ClosedHandCursor
                                               : Qt::ArrowCursor);
}

void PlotView::mouseReleaseEvent(QMouseEvent* event) {
    event->accept();
    if (event->button() != Qt::LeftButton) {
        return;
    }
    QGraphicsView::mouseReleaseEvent(event);
    event->accept();
    if (drag_ == Drag::Undecided) {
        click(event->position());
    }
    drag_ = Drag::None;
    viewport()->setCursor(Qt::ArrowCursor);
}

void PlotView::mouseDoubleClickEvent(QMouseEvent* event) {
    // The second press of a quick pair is a press like any other.
    mousePressEvent(event);
}

void PlotView::click(const QPointF& point) {
    const QRectF area = panes_.front()->area().united(panes_.back()->area());
    if (!area.contains(point)) {
        return;
    }
    const double time = timeAt(point.x());
    // First A, then B, then whichever is nearer.
    Cursor which = Cursor::A;
    if (cursors_[0] && !cursors_[1]) {
        which = Cursor::B;
    } else if (cursors_[0] && cursors_[1]) {
        which = std::abs(*cursors_[1] - time) < std::abs(*cursors_[0] - time) ? Cursor::B : Cursor::A;
    }
    setCursor(which, time);
}

void PlotView::wheelEvent(QWheelEvent* event) {
    event->accept();
    const QPoint angle = event->angleDelta();
    const bool sideways = std::abs(angle.x()) > std::abs(angle.y());
    if (sideways || (event->modifiers() & Qt::ShiftModifier) != 0) {
        const int turned = sideways ? angle.x() : angle.y();
        scrollBy(-turned / 120.0 * window_.span() / 10);
        return;
    }
    window_.zoom(std::pow(kZoomPerNotch, angle.y() / 120.0), timeAt(event->position().x()));
    rewind();
}

bool PlotView::moveActiveCursor(int pixels) {
    const auto& time = cursors_[index(active_)];
    if (!time) {
        return false;
    }
    const double moved = *time + pixels * window_.span() / panes_[0]->area().width();
    setCursor(active_, std::clamp(moved, window_.start(), window_.end()));
    return true;
}

void PlotView::keyPressEvent(QKeyEvent* event) {
    const double middle = window_.end() - window_.span() / 2;
    const int pixels = (event->modifiers() & Qt::ShiftModifier) != 0 ? kCoarse : 1;
    switch (event->key()) {
        case Qt::Key_A:
            setCursor(Cursor::A, cursors_[0].value_or(middle));
            break;
        case Qt::Key_B:
            setCursor(Cursor::B, cursors_[1].value_or(middle));
            break;
        case Qt::Key_Delete:
        case Qt::Key_Backspace:
            setCursor(active_, std::nullopt);
            active_ = cursors_[0] ? Cursor::A : Cursor::B;
            placeCursors();
            break;
        case Qt::Key_Left:
        case Qt::Key_Right: {
            const int sign = event->key() == Qt::Key_Left ? -1 : 1;
            if (!moveActiveCursor(sign * pixels)) {
                scrollBy(sign * window_.span() / 20);
            }
            break;
        }
        case Qt::Key_Up:
            cycleReadout(-1);
            break;
        case Qt::Key_Down:
            cycleReadout(1);
            break;
        case Qt::Key_PageUp:
            scrollBy(-window_.span() / 2);
            break;
        case Qt::Key_PageDown:
            scrollBy(window_.span() / 2);
            break;
        case Qt::Key_Home:
            scrollBy(history_.firstTime() - window_.newest());
            break;
        case Qt::Key_End:
            follow();
            break;
        case Qt::Key_Plus:
        case Qt::Key_Equal:
            window_.zoom(kZoomPerNotch, middle);
            rewind();
            break;
        case Qt::Key_Minus:
            window_.zoom(1 / kZoomPerNotch, middle);
            rewind();
            break;
        default:
            event->ignore();
            return;
    }
    event->accept();
}

}  // namespace tiller
