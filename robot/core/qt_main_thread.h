// SPDX-License-Identifier: MIT
#pragma once

namespace tiller {

/// Has Qt take the thread that loaded this library for the main thread, as it is in a program of Qt's. Qt itself takes the
/// first thread that makes an object of its classes, and uses the data of that thread until the process exits: a thread of
/// ours that had ended by then would leave freed memory behind.
/// To be called before a thread of the library makes such an object. Threads: any
void adoptMainThread();

}  // namespace tiller
