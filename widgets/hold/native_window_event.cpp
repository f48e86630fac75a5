// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/hold/native_window_event.h"

#include <cstddef>
#include <cstring>

namespace tiller {

namespace {

// Event layout of the X protocol. It is declared here so that the XCB headers are not required.
struct XWindowEvent {
    quint8 type;
    quint8 detail;
    quint16 sequence;
    quint32 receiver;  ///< window for which the event is reported
    quint8 mode;       ///< valid for FocusIn and FocusOut
};
static_assert(offsetof(XWindowEvent, mode) == 8);

constexpr quint8 kFocusOut = 10;
constexpr quint8 kUnmapNotify = 18;
constexpr quint8 kNotifyGrab = 1;
constexpr quint8 kNotifyUngrab = 2;
constexpr quint8 kNotifyInferior = 2;  // a child window has the focus
constexpr quint8 kNotifyPointer = 5;   // the window had the pointer without the focus
constexpr quint8 kSentByClient = 0x80;

}  // namespace

NativeWindowEvent nativeWindowEvent(const QByteArray& type, const void* message) {
    if (type != "xcb_generic_event_t") {
        return {};
    }
    XWindowEvent event{};
    std::memcpy(&event, message, sizeof event);
    const quint8 kind = event.type & static_cast<quint8>(~kSentByClient);
    if (kind == kUnmapNotify) {
        return {NativeWindowEvent::Kind::Hidden, event.receiver};
    }
    const bool returns = event.mode == kNotifyGrab || event.mode == kNotifyUngrab;
    const bool ours = event.detail == kNotifyInferior || event.detail == kNotifyPointer;
    return kind == kFocusOut && !returns && !ours
               ? NativeWindowEvent{NativeWindowEvent::Kind::FocusLost, event.receiver}
               : NativeWindowEvent{};
}

}  // namespace tiller
