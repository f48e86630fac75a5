// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/common/physical_keys.h"

#include <QKeyEvent>

namespace tiller {

KeyCode PhysicalKeys::codeOf(const QKeyEvent& event) {
    KeyCode code = event.nativeScanCode();
#ifdef Q_OS_MACOS
    // There the virtual key is the place of the key, and 0 is one of them.
    code = event.nativeVirtualKey() + 1;
#endif
    return code != 0 && hasNumber(code) ? code : kNoNumber | static_cast<KeyCode>(event.key());
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
        return Change::Repeat;  // rule: a keyboard that repeats in pairs
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
