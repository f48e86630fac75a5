// SPDX-License-Identifier: MIT
#pragma once

namespace tiller {

/// Makes Qt treat the thread that loaded this library as the main thread, as in a Qt program. Otherwise Qt
/// uses the first thread that creates a QObject as the main thread and accesses its data until the process
/// exits. This memory would be freed if the thread ended earlier. Call this before a library thread creates a
/// QObject.
/// Threads  any
void adoptMainThread();

}  // namespace tiller
