// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Simulated keyboard and mouse of an X server. Keys are pressed by key code, as by hardware, so that layout,
// modifiers and lock keys have their usual effect. Also simulates other programs of a desktop: windows that
// take the focus, grabs, and requests to the window manager.

#include <QPoint>
#include <QString>
#include <memory>
#include <optional>

namespace tiller::test {

/// X key codes with the evdev rules (kernel code plus 8), by position on a PC keyboard.
enum PcKey : int {
    kEscape = 9,
    kLetterT = 28,
    kDigit1 = 10,  ///< up to kDigit1 + 5 for the six joints
    kBackspace = 22,
    kControl = 37,
    kLetterF = 41,
    kLetterJ = 44,
    kLetterG = 42,
    kLetterK = 45,
    kShift = 50,
    kAlt = 64,
    kSpace = 65,
    kCapsLock = 66,
    kNumLock = 77,
    kKeypad8 = 80,
    kKeypad9 = 81,
    kKeypadMinus = 82,
    kKeypad4 = 83,
    kKeypad6 = 85,
    kKeypadPlus = 86,
    kKeypad2 = 88,
    kKeypad3 = 89,
    kAltGr = 108,
    kHome = 110,
    kUp = 111,
    kPageUp = 112,
    kLeft = 113,
    kRight = 114,
    kEnd = 115,
    kDown = 116,
    kPageDown = 117,
    kReturn = 36,
};

/// The key that types a character with the current layout.
struct Typed {
    int code = 0;
    bool shift = false;
};

/// One connection to the display. Unless stated otherwise, every call reaches the server before it returns.
/// If the server exits, the test continues and later calls have no effect. Threads: one.
class XHand {
public:
    /// display  e.g. ":93"
    explicit XHand(const QString& display);
    ~XHand();
    XHand(const XHand&) = delete;
    XHand& operator=(const XHand&) = delete;

    bool isOpen() const;
    /// True if the server supports simulated input (the extensions XTEST and XKEYBOARD).
    bool canDrive() const;

    void key(int code, bool down);
    void press(int code) { key(code, true); }
    void release(int code) { key(code, false); }
    void tap(int code) { press(code), release(code); }
    void button(int number, bool down);
    void moveTo(const QPoint& place);
    /// True if the key is pressed according to the server.
    bool isDown(int code) const;
    /// The name of the symbol that the key produces with the current layout, modifiers and lock keys, e.g.
    /// "1", "exclam", "KP_Left".
    QString writes(int code) const;
    /// Releases all keys and buttons, and resets the lock keys and the group.
    void letGoOfAll();

    /// True if CapsLock or NumLock is on, according to the server.
    bool isLocked(int code) const;
    /// True if Shift, Ctrl or Alt is pressed in the current layout.
    bool hasModifier() const;
    /// Returns the key that types a character with the current layout; empty if it needs modifiers other than
    /// Shift. The keypad is not searched.
    std::optional<Typed> find(char character) const;
    /// Selects a layout of a map with several layouts.
    /// group  0, 1 ...
    void lockGroup(int group);

    using WindowId = unsigned long;
    /// Shows a window of another program. The window manager treats it like any new window.
    WindowId openWindow(const QPoint& place);
    /// Opens a window without a frame that the window manager has managed before, e.g. the STOP button of
    /// another Tiller.
    WindowId openUnmanaged(const QPoint& place);
    void closeWindow(WindowId window);
    /// Sets the focus without using the window manager.
    void setFocus(WindowId window);
    /// Requests the window manager to bring the window to the front, as a taskbar does.
    void activate(WindowId window);
    void iconify(WindowId window);
    void switchDesktop(int number);
    WindowId activeWindow() const;
    /// True if the topmost window at this place is not managed by the window manager, e.g. a tool tip.
    bool isUnmanaged(const QPoint& place) const;
    int desktop() const;
    int desktopCount() const;

    // Actions of other programs on the desktop that interfere with a hold.
    bool grabKeyboard();
    bool grabPointer();
    void ungrab();
    /// Sends a press or release event to a window. The server does not count the key as pressed.
    void sendKey(WindowId window, int code, bool down);
    void sendButton(WindowId window, const QPoint& place, bool down);
    /// Makes the server ignore all other clients until ungrabServer().
    void grabServer();
    void ungrabServer();

private:
    struct Connection;
    std::unique_ptr<Connection> d_;
};

}  // namespace tiller::test
