// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/desktop/x_hand.h"

#include <QSet>

// Included last and only in this file, because these headers define None, Bool, KeyPress and others as
// macros.
#include <X11/XKBlib.h>
#include <X11/Xatom.h>
#include <X11/Xlib.h>
#include <X11/Xutil.h>
#include <X11/extensions/XTest.h>

namespace tiller::test {
namespace {

// Ignores errors for a window that has been closed in the meantime, so that they do not end the test.
int ignoreError(Display*, XErrorEvent*) {
    return 0;
}

}  // namespace

struct XHand::Connection {
    Display* display = nullptr;
    bool broken = false;
    QSet<int> keysDown;
    QSet<int> buttonsDown;

    bool usable() const { return display != nullptr && !broken; }
    Window root() const { return DefaultRootWindow(display); }
    void sync() {
        if (usable()) {
            XSync(display, False);
        }
    }
    unsigned long property(const char* name) const {
        Atom type = 0;
        int format = 0;
        unsigned long count = 0;
        unsigned long left = 0;
        unsigned char* data = nullptr;
        unsigned long value = 0;
        if (XGetWindowProperty(display, root(), XInternAtom(display, name, False), 0, 1, False,
                               AnyPropertyType, &type, &format, &count, &left, &data) == Success &&
            data != nullptr) {
            if (count > 0 && format == 32) {
                value = *reinterpret_cast<unsigned long*>(data);
            }
            XFree(data);
        }
        return value;
    }
    void request(Window window, const char* what, long first, long second = 0) {
        XEvent event{};
        event.xclient.type = ClientMessage;
        event.xclient.window = window;
        event.xclient.message_type = XInternAtom(display, what, False);
        event.xclient.format = 32;
        event.xclient.data.l[0] = first;
        event.xclient.data.l[1] = second;
        XSendEvent(display, root(), False, SubstructureRedirectMask | SubstructureNotifyMask, &event);
        sync();
    }
};

XHand::XHand(const QString& display) : d_(std::make_unique<Connection>()) {
    XSetErrorHandler(ignoreError);
    d_->display = XOpenDisplay(qPrintable(display));
    if (d_->display != nullptr) {
        // Without these handlers, Xlib exits the process when the server exits.
        XSetIOErrorHandler([](Display*) { return 0; });
        XSetIOErrorExitHandler(
            d_->display, [](Display*, void* broken) { *static_cast<bool*>(broken) = true; }, &d_->broken);
    }
}

XHand::~XHand() {
    if (d_->usable()) {
        XCloseDisplay(d_->display);
    }
}

bool XHand::isOpen() const {
    return d_->usable();
}

bool XHand::canDrive() const {
    int a = 0;
    int b = 0;
    int major = XkbMajorVersion;
    int minor = XkbMinorVersion;
    return d_->usable() && XTestQueryExtension(d_->display, &a, &b, &major, &minor) != 0 &&
           XkbQueryExtension(d_->display, nullptr, nullptr, nullptr, nullptr, nullptr) != 0;
}

void XHand::key(int code, bool down) {
    if (!d_->usable()) {
        return;
    }
    XTestFakeKeyEvent(d_->display, unsigned(code), down ? True : False, CurrentTime);
    d_->sync();
    if (down) {
        d_->keysDown.insert(code);
    } else {
        d_->keysDown.remove(code);
    }
}

void XHand::button(int number, bool down) {
    if (!d_->usable()) {
        return;
    }
    XTestFakeButtonEvent(d_->display, unsigned(number), down ? True : False, CurrentTime);
    d_->sync();
    if (down) {
        d_->buttonsDown.insert(number);
    } else {
        d_->buttonsDown.remove(number);
    }
}

void XHand::moveTo(const QPoint& place) {
    if (d_->usable()) {
        XTestFakeMotionEvent(d_->display, -1, place.x(), place.y(), CurrentTime);
        d_->sync();
    }
}

bool XHand::isDown(int code) const {
    char keys[32] = {};
    if (d_->usable()) {
        XQueryKeymap(d_->display, keys);
    }
    return ((keys[code / 8] >> (code % 8)) & 1) != 0;
}

void XHand::letGoOfAll() {
    const QSet<int> keys = d_->keysDown;
    for (const int code : keys) {
        release(code);
    }
    const QSet<int> buttons = d_->buttonsDown;
    for (const int number : buttons) {
        button(number, false);
    }
    for (const int lock : {kCapsLock, kNumLock}) {
        if (isLocked(lock)) {
            tap(lock);
        }
    }
    lockGroup(0);
}

bool XHand::isLocked(int code) const {
    XkbStateRec state{};
    if (!d_->usable() || XkbGetState(d_->display, XkbUseCoreKbd, &state) != Success) {
        return false;
    }
    // NumLock is Mod2 in every map of xkeyboard-config.
    return (state.locked_mods & (code == kCapsLock ? LockMask : Mod2Mask)) != 0;
}

bool XHand::hasModifier() const {
    XkbStateRec state{};
    return d_->usable() && XkbGetState(d_->display, XkbUseCoreKbd, &state) == Success &&
           (state.mods & (ShiftMask | ControlMask | Mod1Mask)) != 0;
}

QString XHand::writes(int code) const {
    if (!d_->usable()) {
        return {};
    }
    XkbDescPtr map = XkbGetMap(d_->display, XkbAllClientInfoMask, XkbUseCoreKbd);
    if (map == nullptr) {
        return {};
    }
    XkbStateRec state{};
    XkbGetState(d_->display, XkbUseCoreKbd, &state);
    KeySym symbol = NoSymbol;
    unsigned used = 0;
    XkbTranslateKeyCode(map, static_cast<unsigned char>(code), XkbBuildCoreState(state.mods, state.group),
                        &used, &symbol);
    XkbFreeClientMap(map, XkbAllClientInfoMask, True);
    return QString::fromLatin1(XKeysymToString(symbol));
}

std::optional<Typed> XHand::find(char character) const {
    if (!d_->usable()) {
        return std::nullopt;
    }
    // Read the map from the server, because the map cached by Xlib is outdated after a change of the layout.
    XkbDescPtr map = XkbGetMap(d_->display, XkbAllClientInfoMask, XkbUseCoreKbd);
    if (map == nullptr) {
        return std::nullopt;
    }
    XkbStateRec state{};
    XkbGetState(d_->display, XkbUseCoreKbd, &state);
    std::optional<Typed> found;
    for (int level = 0; level < 2 && !found; ++level) {
        // Up to key AB10, the end of the letter block.
        for (int code = map->min_key_code; code <= 61 && !found; ++code) {
            const int groups = XkbKeyNumGroups(map, code);
            const int group = groups == 0 ? 0 : std::min(int(state.group), groups - 1);
            if (groups > 0 && level < XkbKeyGroupWidth(map, code, group) &&
                XkbKeySymEntry(map, code, level, group) == KeySym(character)) {
                found = Typed{code, level == 1};
            }
        }
    }
    XkbFreeClientMap(map, XkbAllClientInfoMask, True);
    return found;
}

void XHand::lockGroup(int group) {
    if (d_->usable()) {
        XkbLockGroup(d_->display, XkbUseCoreKbd, unsigned(group));
        d_->sync();
    }
}

XHand::WindowId XHand::openWindow(const QPoint& place) {
    if (!d_->usable()) {
        return 0;
    }
    const Window window =
        XCreateSimpleWindow(d_->display, d_->root(), place.x(), place.y(), 240, 120, 0, 0, 0x808080);
    XSizeHints hints{};
    hints.flags = USPosition;
    XSetWMNormalHints(d_->display, window, &hints);
    XStoreName(d_->display, window, "another program");
    XMapRaised(d_->display, window);
    d_->sync();
    return window;
}

XHand::WindowId XHand::openUnmanaged(const QPoint& place) {
    if (!d_->usable()) {
        return 0;
    }
    const Window window =
        XCreateSimpleWindow(d_->display, d_->root(), place.x(), place.y(), 40, 20, 0, 0, 0x808080);
    XSetWindowAttributes attributes{};
    attributes.override_redirect = True;
    XChangeWindowAttributes(d_->display, window, CWOverrideRedirect, &attributes);
    const Atom state = XInternAtom(d_->display, "WM_STATE", False);
    const long values[] = {WithdrawnState, None};
    XChangeProperty(d_->display, window, state, state, 32, PropModeReplace,
                    reinterpret_cast<const unsigned char*>(values), 2);
    XMapRaised(d_->display, window);
    d_->sync();
    return window;
}

void XHand::closeWindow(WindowId window) {
    if (d_->usable()) {
        XDestroyWindow(d_->display, window);
        d_->sync();
    }
}

void XHand::setFocus(WindowId window) {
    if (d_->usable()) {
        XSetInputFocus(d_->display, window, RevertToPointerRoot, CurrentTime);
        d_->sync();
    }
}

void XHand::activate(WindowId window) {
    if (d_->usable()) {
        d_->request(window, "_NET_ACTIVE_WINDOW", 2, CurrentTime);
    }
}

void XHand::iconify(WindowId window) {
    if (d_->usable()) {
        XIconifyWindow(d_->display, window, DefaultScreen(d_->display));
        d_->sync();
    }
}

void XHand::switchDesktop(int number) {
    if (d_->usable()) {
        d_->request(d_->root(), "_NET_CURRENT_DESKTOP", number);
    }
}

XHand::WindowId XHand::activeWindow() const {
    return d_->usable() ? d_->property("_NET_ACTIVE_WINDOW") : 0;
}

bool XHand::isUnmanaged(const QPoint& place) const {
    int x = 0;
    int y = 0;
    Window topmost = 0;
    XWindowAttributes attributes{};
    return d_->usable() &&
           XTranslateCoordinates(d_->display, d_->root(), d_->root(), place.x(), place.y(), &x, &y,
                                 &topmost) != 0 &&
           topmost != 0 && XGetWindowAttributes(d_->display, topmost, &attributes) != 0 &&
           attributes.override_redirect != 0;
}

int XHand::desktop() const {
    return d_->usable() ? int(d_->property("_NET_CURRENT_DESKTOP")) : 0;
}

int XHand::desktopCount() const {
    return d_->usable() ? int(d_->property("_NET_NUMBER_OF_DESKTOPS")) : 0;
}

bool XHand::grabKeyboard() {
    return d_->usable() && XGrabKeyboard(d_->display, d_->root(), False, GrabModeAsync, GrabModeAsync,
                                         CurrentTime) == GrabSuccess;
}

bool XHand::grabPointer() {
    return d_->usable() && XGrabPointer(d_->display, d_->root(), False, ButtonPressMask | ButtonReleaseMask,
                                        GrabModeAsync, GrabModeAsync, 0, 0, CurrentTime) == GrabSuccess;
}

void XHand::ungrab() {
    if (d_->usable()) {
        XUngrabKeyboard(d_->display, CurrentTime);
        XUngrabPointer(d_->display, CurrentTime);
        d_->sync();
    }
}

void XHand::sendKey(WindowId window, int code, bool down) {
    if (d_->usable()) {
        XEvent event{};
        event.xkey.type = down ? KeyPress : KeyRelease;
        event.xkey.display = d_->display;
        event.xkey.window = window;
        event.xkey.root = d_->root();
        event.xkey.same_screen = True;
        event.xkey.keycode = unsigned(code);
        XSendEvent(d_->display, window, False, NoEventMask, &event);
        d_->sync();
    }
}

void XHand::sendButton(WindowId window, const QPoint& place, bool down) {
    if (d_->usable()) {
        XEvent event{};
        event.xbutton.type = down ? ButtonPress : ButtonRelease;
        event.xbutton.display = d_->display;
        event.xbutton.window = window;
        event.xbutton.root = d_->root();
        event.xbutton.same_screen = True;
        event.xbutton.button = Button1;
        event.xbutton.state = down ? 0 : Button1Mask;
        event.xbutton.x_root = place.x();
        event.xbutton.y_root = place.y();
        Window child = 0;
        XTranslateCoordinates(d_->display, d_->root(), window, place.x(), place.y(), &event.xbutton.x,
                              &event.xbutton.y, &child);
        XSendEvent(d_->display, window, False, NoEventMask, &event);
        d_->sync();
    }
}

void XHand::grabServer() {
    if (d_->usable()) {
        XGrabServer(d_->display);
        d_->sync();
    }
}

void XHand::ungrabServer() {
    if (d_->usable()) {
        XUngrabServer(d_->display);
        d_->sync();
    }
}

}  // namespace tiller::test
