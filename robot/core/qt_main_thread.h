// SPDX-License-Identifier: MIT
#pragma once

namespace tiller {

/// Makes Qt treat the thread that loaded this library as the main thread, as in a Qt program. Otherwise, Qt
/// uses the first thread that creates a QObject and accesses its data until the process exits. If that thread
/// ended earlier, this memory would be freed. Call before a library thread creates a QObject.
/// Threads  any
void adoptMainThread();

}  // namespace tiller
