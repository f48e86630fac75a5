// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/common/window_stacking.h"

#ifdef TILLER_HAS_XCB

#include <QGuiApplication>
#include <QSocketNotifier>
#include <algorithm>
#include <cstdlib>
#include <iterator>
#include <memory>
#include <span>

// Included last, because these headers define common words as macros.
#include <qguiapplication_platform.h>
#include <xcb/xcb.h>

namespace tiller {

namespace {

struct FreeReply {
    void operator()(void* reply) const { std::free(reply); }  // NOLINT: malloc()ed by the library
};
template <class Reply>
using Owned = std::unique_ptr<Reply, FreeReply>;
using Tree = Owned<xcb_query_tree_reply_t>;

Tree treeOf(xcb_connection_t* link, xcb_window_t window) {
    return Tree(xcb_query_tree_reply(link, xcb_query_tree(link, window), nullptr));
}

/// True if the window is on the screen. Windows without content, e.g. for input only, do not count.
bool isOnScreen(xcb_connection_t* link, xcb_window_t window) {
    const Owned<xcb_get_window_attributes_reply_t> attributes(
        xcb_get_window_attributes_reply(link, xcb_get_window_attributes(link, window), nullptr));
    return attributes != nullptr && attributes->map_state == XCB_MAP_STATE_VIEWABLE &&
           attributes->_class == XCB_WINDOW_CLASS_INPUT_OUTPUT;
}

xcb_atom_t stateAtom(xcb_connection_t* link) {
    static constexpr char kName[] = "WM_STATE";
    const Owned<xcb_intern_atom_reply_t> reply(xcb_intern_atom_reply(
        link, xcb_intern_atom(link, 1, sizeof kName - 1, static_cast<const char*>(kName)), nullptr));
    return reply != nullptr ? reply->atom : xcb_atom_t{XCB_ATOM_NONE};
}

/// True for a window that the window manager manages, and for the frame around such a window. Other windows,
/// e.g. the one in which a compositor draws the whole screen, do not cover anything.
/// depth  maximum number of frames around the managed window
bool isManaged(xcb_connection_t* link, xcb_window_t window, xcb_atom_t state, int depth = 2) {
    const Owned<xcb_get_property_reply_t> property(xcb_get_property_reply(
        link, xcb_get_property(link, 0, window, state, XCB_GET_PROPERTY_TYPE_ANY, 0, 1), nullptr));
    // A window may still have the state 0 (Withdrawn) from the last time it was hidden, even if it is on the
    // screen again without the window manager, e.g. the STOP button of another Tiller.
    constexpr std::uint32_t kNormal = 1;
    if (property != nullptr && property->format == 32 && xcb_get_property_value_length(property.get()) >= 4 &&
        *static_cast<const std::uint32_t*>(xcb_get_property_value(property.get())) == kNormal) {
        return true;
    }
    const Tree tree = depth > 0 ? treeOf(link, window) : nullptr;
    if (!tree) {
        return false;
    }
    const std::span<const xcb_window_t> children(
        xcb_query_tree_children(tree.get()),
        static_cast<std::size_t>(xcb_query_tree_children_length(tree.get())));
    return std::any_of(children.begin(), children.end(),
                       [&](xcb_window_t child) { return isManaged(link, child, state, depth - 1); });
}

/// Area of a top-level X window in display coordinates [px].
QRect areaOf(xcb_connection_t* link, xcb_window_t window) {
    const Owned<xcb_get_geometry_reply_t> area(
        xcb_get_geometry_reply(link, xcb_get_geometry(link, window), nullptr));
    return area != nullptr ? QRect(area->x, area->y, area->width + 2 * area->border_width,
                                   area->height + 2 * area->border_width)
                           : QRect();
}

/// Returns the ancestor of a window that is a child of the root window: its frame, or the window itself.
/// Returns 0 if there is none.
xcb_window_t frameOf(xcb_connection_t* link, xcb_window_t window) {
    for (Tree tree = treeOf(link, window); tree; tree = treeOf(link, window)) {
        if (tree->parent == tree->root) {
            return window;
        }
        window = tree->parent;
    }
    return 0;
}

}  // namespace

Stacking keepAbove(const QList<QWindow*>& references, const QWindow& unmanaged, QRegion& covered) {
    covered = {};
    const auto* x11 = qGuiApp->nativeInterface<QNativeInterface::QX11Application>();
    xcb_connection_t* link = x11 != nullptr ? x11->connection() : nullptr;
    if (link == nullptr) {
        return Stacking::Unsupported;
    }
    QList<xcb_window_t> frames;
    for (const QWindow* reference : references) {
        const xcb_window_t frame = frameOf(link, static_cast<xcb_window_t>(reference->winId()));
        if (frame != 0 && isOnScreen(link, frame)) {
            frames.append(frame);
        }
    }
    const auto window = static_cast<xcb_window_t>(unmanaged.winId());
    const Tree own = treeOf(link, window);
    const Tree root = own ? treeOf(link, own->root) : nullptr;
    if (!root) {
        return Stacking::Unsupported;
    }
    // The server lists the windows from the lowest to the topmost.
    const std::span<const xcb_window_t> order(
        xcb_query_tree_children(root.get()),
        static_cast<std::size_t>(xcb_query_tree_children_length(root.get())));
    const auto topmost = std::find_if(order.rbegin(), order.rend(), [&](xcb_window_t each) {
                             return frames.contains(each);
                         }).base();
    if (topmost == order.begin()) {
        return Stacking::NoneVisible;
    }
    if (std::find(topmost, order.end(), window) == order.end()) {
        const std::uint32_t values[] = {*std::prev(topmost), XCB_STACK_MODE_ABOVE};
        xcb_configure_window(link, window, XCB_CONFIG_WINDOW_SIBLING | XCB_CONFIG_WINDOW_STACK_MODE, values);
        xcb_flush(link);
    }
    // A window of another program may be between two windows of this program, e.g. below a dialog.
    const xcb_atom_t state = stateAtom(link);
    const QRect area = areaOf(link, window);
    QRegion others;
    for (auto each =
             std::find_if(order.begin(), topmost, [&](xcb_window_t one) { return frames.contains(one); });
         each != order.end(); ++each) {
        const QRect part = *each == window ? QRect() : areaOf(link, *each).intersected(area);
        if (part.isEmpty()) {
            continue;
        }
        if (frames.contains(*each)) {
            others -= part;
        } else if (isOnScreen(link, *each) && isManaged(link, *each, state)) {
            others += part;
        }
    }
    const double scale = unmanaged.devicePixelRatio();
    for (const QRect& part : others.translated(-area.topLeft())) {
        covered += QRectF(part.x() / scale, part.y() / scale, part.width() / scale, part.height() / scale)
                       .toAlignedRect();
    }
    return Stacking::Done;
}

struct StackingWatch::Link {
    Link() : connection(xcb_connect(nullptr, nullptr)) {
        const std::uint32_t values[] = {XCB_EVENT_MASK_SUBSTRUCTURE_NOTIFY};
        for (auto screen = xcb_setup_roots_iterator(xcb_get_setup(connection)); screen.rem > 0;
             xcb_screen_next(&screen)) {
            xcb_change_window_attributes(connection, screen.data->root, XCB_CW_EVENT_MASK, values);
        }
        xcb_flush(connection);
    }
    ~Link() { xcb_disconnect(connection); }
    Link(const Link&) = delete;
    Link& operator=(const Link&) = delete;

    bool isAlive() const { return xcb_connection_has_error(connection) == 0; }
    /// Returns  true if there were events
    bool drain() {
        bool any = false;
        while (const Owned<xcb_generic_event_t> event{xcb_poll_for_event(connection)}) {
            any = true;
        }
        return any;
    }

    xcb_connection_t* connection;
    std::unique_ptr<QSocketNotifier> notifier;
};

StackingWatch::StackingWatch(QObject* parent) : QObject(parent) {
    if (qGuiApp->nativeInterface<QNativeInterface::QX11Application>() == nullptr) {
        return;
    }
    link_ = std::make_unique<Link>();
    if (!link_->isAlive()) {
        return;
    }
    link_->notifier =
        std::make_unique<QSocketNotifier>(xcb_get_file_descriptor(link_->connection), QSocketNotifier::Read);
    connect(link_->notifier.get(), &QSocketNotifier::activated, this, [this] {
        if (link_->drain()) {
            Q_EMIT changed();
        }
        if (!link_->isAlive()) {
            link_->notifier->setEnabled(false);
        }
    });
}

bool StackingWatch::isActive() const {
    return link_ && link_->isAlive();
}

}  // namespace tiller

#else

namespace tiller {

struct StackingWatch::Link {};

Stacking keepAbove(const QList<QWindow*>&, const QWindow&, QRegion& covered) {
    covered = {};
    return Stacking::Unsupported;
}

StackingWatch::StackingWatch(QObject* parent) : QObject(parent) {}

bool StackingWatch::isActive() const {
    return false;
}

}  // namespace tiller

#endif

namespace tiller {

StackingWatch::~StackingWatch() = default;

}  // namespace tiller

#include "moc_window_stacking.cpp"
