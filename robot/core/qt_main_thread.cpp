// SPDX-License-Identifier: MIT
#include "robot/core/qt_main_thread.h"

#include <QThread>

namespace tiller {

namespace {

// Initialized in the thread that loads the library. Qt stores this thread as the main thread.
const QThread* const loadingThread = QThread::currentThread();

}  // namespace

// The initialization above does the work. A call to this function makes the linker keep this file.
void adoptMainThread() {
    static_cast<void>(loadingThread);
}

}  // namespace tiller
