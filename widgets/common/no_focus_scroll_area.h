// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// A scroll area that does not scroll to the focus widget. QScrollArea scrolls even if the focus only changes
// because the focus widget was hidden or disabled, so that a click would move the content under the pointer.

#include <QScrollArea>

namespace tiller {

class NoFocusScrollArea : public QScrollArea {
public:
    using QScrollArea::QScrollArea;

protected:
    bool focusNextPrevChild(bool next) override;
};

}  // namespace tiller
