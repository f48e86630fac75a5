// SPDX-License-Identifier: GPL-3.0-or-later
#include "resources/resources.h"

#include <QDir>

// The macro must be outside all namespaces, because it declares a function of generated code.
static void initTillerResources() {
    Q_INIT_RESOURCE(tiller_resources);
}

namespace tiller {

void initResources() {
    initTillerResources();
}

}  // namespace tiller
