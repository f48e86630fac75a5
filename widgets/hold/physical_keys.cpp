// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/hold/physical_keys.h"

#include <QKeyEvent>

namespace tiller {

namespace {

#ifdef Q_OS_WIN
constexpr quint32 kFirstCode = 0;
#else
constexpr quint32 kFirstCode = 8;  // offset of the key codes of X11 and Wayland
#endif

/// True for letters of non-Latin scripts, e.g. Cyrillic, Greek, Hebrew. Punctuation and digits do not count.
bool writesLetterOfAnotherScript(const QKeyEvent& event) {
#ifdef Q_OS_MACOS
    return event.key() < 0;  // on this platform, Qt maps shortcuts to Latin letters
#else
    const int key = event.key();
    if (key < 0x100 || key > static_cast<int>(QChar::LastValidCodePoint)) {
        return false;
    }
    const QChar::Script script = QChar::script(static_cast<char32_t>(key));
    return script != QChar::Script_Latin && script != QChar::Script_Common;
#endif
}

/// Returns the letter at this key position on a US keyboard; 0 if there is no letter.
int letterAt(quint32 scanCode) {
    struct Row {
        quint32 first;
        QLatin1String letters;
    };
    static const Row rows[] = {{kFirstCode + 16, QLatin1String("QWERTYUIOP")},
                               {kFirstCode + 30, QLatin1String("ASDFGHJKL")},
                               {kFirstCode + 44, QLatin1String("ZXCVBNM")}};
    for (const Row& row : rows) {
        if (scanCode >= row.first && scanCode - row.first < static_cast<quint32>(row.letters.size())) {
            return row.letters.at(static_cast<qsizetype>(scanCode - row.first)).unicode();
        }
    }
    return 0;
}

}  // namespace

KeyCode PhysicalKeys::codeOf(const QKeyEvent& event) {
    KeyCode code = event.nativeScanCode();
#ifdef Q_OS_MACOS
    // The virtual key identifies the position on macOS, and 0 is a valid value.
    code = event.nativeVirtualKey() + 1;
#endif
    return code != 0 && hasNumber(code) ? code : kNoNumber | static_cast<KeyCode>(event.key());
}

int PhysicalKeys::keyOf(const QKeyEvent& event) {
    const int letter = writesLetterOfAnotherScript(event) ? letterAt(event.nativeScanCode()) : 0;
    return letter != 0 ? letter : event.key();
}

PhysicalKeys::Change PhysicalKeys::take(const QKeyEvent& event, int meaning) {
    const KeyCode code = codeOf(event);
    const bool known = down_.contains(code);
    if (event.isAutoRepeat()) {
        return Change::Repeat;  // rule: auto-repeat
    }
    if (event.type() == QEvent::KeyRelease) {
        releasedCode_ = code;
        releasedAt_ = event.timestamp();
        return down_.remove(code) > 0 ? Change::Up : Change::Unknown;
    }
    const bool pair = event.timestamp() != 0 && code == releasedCode_ && event.timestamp() == releasedAt_;
    down_.insert(code, meaning);
    if (pair) {
        return Change::Repeat;  // rule: a keyboard that sends a release and a press for each repetition
    }
    return known ? Change::DownAgain : Change::Down;
}

bool PhysicalKeys::means(int meaning) const {
    for (const int each : down_) {
        if (each == meaning) {
            return true;
        }
    }
    return false;
}

void PhysicalKeys::clear() {
    down_.clear();
    releasedCode_ = 0;
    releasedAt_ = 0;
}

}  // namespace tiller
