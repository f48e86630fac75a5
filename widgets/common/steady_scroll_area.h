// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// A scroll area that scrolls only for somebody. Qt's own brings the next widget into sight whenever the focus
// moves, also when it moves because the one that had it was hidden or disabled: a click then slides everything
// away under the pointer.

#include <QScrollArea>

namespace tiller {

class SteadyScrollArea : public QScrollArea {
public:
    using QScrollArea::QScrollArea;

protected:
    bool focusNextPrevChild(bool next) override;
};

}  // namespace tiller
