// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/common/no_focus_scroll_area.h"

namespace tiller {

bool NoFocusScrollArea::focusNextPrevChild(bool next) {
    const QWidget* before = focusWidget();
    const bool byKey = before == nullptr || (before->isVisible() && before->isEnabled());
    return byKey ? QScrollArea::focusNextPrevChild(next) : QAbstractScrollArea::focusNextPrevChild(next);
}

}  // namespace tiller
