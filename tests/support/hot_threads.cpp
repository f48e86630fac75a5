// SPDX-License-Identifier: MIT
#include "tests/support/hot_threads.h"

#include <dlfcn.h>
#include <pthread.h>
#include <sys/prctl.h>

#include <atomic>
#include <cstdlib>
#include <cstring>
#include <new>

namespace {

std::atomic<bool> counting{false};
std::atomic<std::uint64_t> allocations{0};
std::atomic<std::uint64_t> locks{0};
std::atomic<int> threads{0};
thread_local bool hot = false;

void* allocate(std::size_t size) {
    if (hot && counting.load(std::memory_order_relaxed)) {
        allocations.fetch_add(1, std::memory_order_relaxed);
    }
    void* memory = std::malloc(size == 0 ? 1 : size);
    if (memory == nullptr) {
        throw std::bad_alloc();
    }
    return memory;
}

}  // namespace

void* operator new(std::size_t size) {
    return allocate(size);
}
void* operator new[](std::size_t size) {
    return allocate(size);
}
void operator delete(void* memory) noexcept {
    std::free(memory);
}
void operator delete[](void* memory) noexcept {
    std::free(memory);
}
void operator delete(void* memory, std::size_t) noexcept {
    std::free(memory);
}
void operator delete[](void* memory, std::size_t) noexcept {
    std::free(memory);
}

// Each thread first calls realtime::nameThread() for itself.
extern "C" int pthread_setname_np(pthread_t, const char* name) noexcept {
    hot = std::strcmp(name, "control") == 0 || std::strcmp(name, "tiller-receive") == 0;
    threads += hot ? 1 : 0;
    return prctl(PR_SET_NAME, name, 0, 0, 0);
}

extern "C" int pthread_mutex_lock(pthread_mutex_t* mutex) noexcept {
    using Lock = int (*)(pthread_mutex_t*);
    static std::atomic<void*> real{nullptr};
    void* found = real.load(std::memory_order_acquire);
    if (found == nullptr) {
        found = dlsym(RTLD_NEXT, "pthread_mutex_lock");
        real.store(found, std::memory_order_release);
    }
    if (hot && counting.load(std::memory_order_relaxed)) {
        locks.fetch_add(1, std::memory_order_relaxed);
    }
    Lock lock = nullptr;
    std::memcpy(&lock, &found, sizeof lock);
    return lock(mutex);
}

namespace tiller::test {

void countHotThreads(bool on) {
    counting = on;
}

void watchThisThread() {
    hot = true;
}

HotCounts hotCounts() {
    return {allocations.load(), locks.load()};
}

int hotThreads() {
    return threads;
}

}  // namespace tiller::test
