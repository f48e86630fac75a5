// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/common/fit_to_contents.h"

#include <QLayout>
#include <QWidget>
#include <algorithm>

namespace tiller {

void fitToContents(QWidget& window) {
    QLayout* layout = window.layout();
    layout->activate();
    const QSize least = layout->totalMinimumSize();
    const int width = std::max(window.width(), least.width());
    const int tall = layout->hasHeightForWidth() ? layout->totalHeightForWidth(width) : least.height();
    const int height = std::max(window.height(), tall);
    if (width > window.width() || height > window.height()) {
        window.resize(width, height);
    }
}

}  // namespace tiller
