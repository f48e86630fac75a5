// SPDX-License-Identifier: MIT
#include "robot/core/qt_main_thread.h"

#include <QThread>

namespace tiller {

namespace {

// Initialized while the library is loaded, in that thread. Asking for the thread is what makes Qt remember it.
const QThread* const loadingThread = QThread::currentThread();

}  // namespace

// The work is done by then: a call makes the linker keep this file.
void adoptMainThread() {
    static_cast<void>(loadingThread);
}

}  // namespace tiller
