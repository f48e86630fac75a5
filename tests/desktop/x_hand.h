// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// A hand at the keyboard and mouse of an X server: keys by their key code, as the hardware counts them, so
// that layout, modifiers and lock keys do to them what they do to a person's. And the other programs of a
// desktop: windows that take the focus, grabs, the window manager's requests.

#include <QPoint>
#include <QString>
#include <memory>
#include <optional>

namespace tiller::test {

/// Key codes of X with the evdev rules (the kernel's plus 8), by their place on a PC keyboard.
enum PcKey : int {
    kEscape = 9,
    kLetterT = 28,
    kDigit1 = 10,  ///< to kDigit1 + 5 for the six joints
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

/// How a character is typed on the present layout.
struct Typed {
    int code = 0;
    bool shift = false;
};

/// One connection to the display. Every call reaches the server before it returns, unless it says otherwise.
/// A server that dies takes nothing of the test with it: calls after that do nothing.
/// Threads  one
class XHand {
public:
    /// display  ":93"
    explicit XHand(const QString& display);
    ~XHand();
    XHand(const XHand&) = delete;
    XHand& operator=(const XHand&) = delete;

    bool isOpen() const;
    /// Whether the server can be driven at all (the extensions XTEST and XKEYBOARD).
    bool canDrive() const;

    void key(int code, bool down);
    void press(int code) { key(code, true); }
    void release(int code) { key(code, false); }
    void tap(int code) { press(code), release(code); }
    void button(int number, bool down);
    void moveTo(const QPoint& place);
    /// Whether the server counts this key as down.
    bool isDown(int code) const;
    /// What the key would write with the layout, modifiers and lock keys of now, by the name of the symbol:
    /// "1", "exclam", "KP_Left".
    QString writes(int code) const;
    /// Lets go of everything: keys, buttons, lock keys, the second group.
    void letGoOfAll();

    /// CapsLock and NumLock are lit, by the server.
    bool isLocked(int code) const;
    /// Shift, Ctrl or Alt is down, as the layout has it.
    bool hasModifier() const;
    /// Where a character is on the layout that holds now; nothing where it needs more than Shift. The keypad
    /// does not count.
    std::optional<Typed> find(char character) const;
    /// The layout of a map with several: 0, 1...
    void lockGroup(int group);

    using WindowId = unsigned long;
    /// A window of another program, shown; the window manager does what it does with new windows.
    WindowId openWindow(const QPoint& place);
    void closeWindow(WindowId window);
    /// Without asking the window manager.
    void setFocus(WindowId window);
    /// As a taskbar would: the window manager is asked to bring it to the front.
    void activate(WindowId window);
    void iconify(WindowId window);
    void switchDesktop(int number);
    WindowId activeWindow() const;
    int desktop() const;
    int desktopCount() const;

    // What other programs of a desktop do at bad moments.
    bool grabKeyboard();
    bool grabPointer();
    void ungrab();
    /// Tells a window of a press, or a release, that no hand made: the server does not count it as down.
    void sendKey(WindowId window, int code, bool down);
    void sendButton(WindowId window, const QPoint& place, bool down);
    /// No other client is served until it is undone.
    void grabServer();
    void ungrabServer();

private:
    struct Connection;
    std::unique_ptr<Connection> d_;
};

}  // namespace tiller::test
