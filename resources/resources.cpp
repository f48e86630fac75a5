// SPDX-License-Identifier: GPL-3.0-or-later
#include "resources/resources.h"

#include <QDir>

// Outside every namespace: the macro declares a function of the generated code.
static void initTillerResources() {
    Q_INIT_RESOURCE(tiller_resources);
}

namespace tiller {

void initResources() {
    initTillerResources();
}

}  // namespace tiller
