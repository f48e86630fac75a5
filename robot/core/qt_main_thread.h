// SPDX-License-Identifier: MIT
#pragma once

namespace tiller {

/// Makes Qt treat the thread that loaded this library as the main thread, as in a Qt program. Otherwise Qt uses the
/// first thread that creates a QObject, and accesses the data of that thread until the process exits, which would
/// be freed memory if the thread has ended. Call this before a library thread creates a QObject.
/// Threads  any
void adoptMainThread();

}  // namespace tiller
