// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/common/window_stacking.h"

#ifdef TILLER_HAS_XCB

#include <QGuiApplication>
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

bool isOnScreen(xcb_connection_t* link, xcb_window_t window) {
    const Owned<xcb_get_window_attributes_reply_t> attributes(
        xcb_get_window_attributes_reply(link, xcb_get_window_attributes(link, window), nullptr));
    return attributes != nullptr && attributes->map_state == XCB_MAP_STATE_VIEWABLE;
}

/// Returns the ancestor of a window that is a child of the root window: its frame, or the window itself. 0: none.
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

Stacking stackDirectlyAbove(const QList<QWindow*>& references, const QWindow& unmanaged) {
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
    xcb_window_t topmost = 0;
    xcb_window_t above = 0;  // the window directly above `topmost`
    for (const xcb_window_t each : order) {
        if (frames.contains(each)) {
            topmost = each;
            above = 0;
        } else if (above == 0) {
            above = each;
        }
    }
    if (topmost == 0) {
        return Stacking::NoneVisible;
    }
    if (above != window) {
        const std::uint32_t values[] = {topmost, XCB_STACK_MODE_ABOVE};
        xcb_configure_window(link, window, XCB_CONFIG_WINDOW_SIBLING | XCB_CONFIG_WINDOW_STACK_MODE, values);
        xcb_flush(link);
    }
    return Stacking::Done;
}

}  // namespace tiller

#else

namespace tiller {

Stacking stackDirectlyAbove(const QList<QWindow*>&, const QWindow&) {
    return Stacking::Unsupported;
}

}  // namespace tiller

#endif
