// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// SIMD operations on four numbers, for the four samples of a pixel. Compilers generate one instruction per
// operation.

#include <array>
#include <cstdint>
#include <cstring>

namespace tiller {

#if defined(__GNUC__)

using FourFloats = float __attribute__((vector_size(16)));
using FourBits = std::int32_t __attribute__((vector_size(16)));

inline FourBits atLeast(FourFloats a, FourFloats b) {
    return a >= b;
}
inline FourBits both(FourBits a, FourBits b) {
    return a & b;
}
inline bool any(FourBits mask) {
    std::array<std::uint64_t, 2> halves;
    std::memcpy(halves.data(), &mask, sizeof mask);
    return (halves[0] | halves[1]) != 0;
}
inline FourFloats choose(FourBits mask, FourFloats yes, FourFloats no) {
    return reinterpret_cast<FourFloats>((mask & reinterpret_cast<FourBits>(yes)) |
                                        (~mask & reinterpret_cast<FourBits>(no)));
}
inline FourBits choose(FourBits mask, FourBits yes, FourBits no) {
    return (mask & yes) | (~mask & no);
}
inline bool all(FourBits mask) {
    std::array<std::uint64_t, 2> halves;
    std::memcpy(halves.data(), &mask, sizeof mask);
    return (halves[0] & halves[1]) == ~std::uint64_t{0};
}
inline FourFloats smaller(FourFloats a, FourFloats b) {
    return a < b ? a : b;
}
inline FourFloats larger(FourFloats a, FourFloats b) {
    return a > b ? a : b;
}
/// Rounds towards zero.
inline FourBits truncated(FourFloats v) {
    return __builtin_convertvector(v, FourBits);
}
inline FourFloats four(float v) {
    return FourFloats{v, v, v, v};
}
inline FourBits four(std::int32_t v) {
    return FourBits{v, v, v, v};
}

#else

template <class T>
struct FourOf {
    T v[4];
    T& operator[](int i) { return v[i]; }
    T operator[](int i) const { return v[i]; }
};
using FourFloats = FourOf<float>;
using FourBits = FourOf<std::int32_t>;

inline FourFloats operator+(FourFloats a, FourFloats b) {
    return {{a[0] + b[0], a[1] + b[1], a[2] + b[2], a[3] + b[3]}};
}
inline FourBits atLeast(FourFloats a, FourFloats b) {
    FourBits r{};
    for (int i = 0; i < 4; ++i) {
        r[i] = a[i] >= b[i] ? -1 : 0;
    }
    return r;
}
inline FourBits both(FourBits a, FourBits b) {
    return {{a[0] & b[0], a[1] & b[1], a[2] & b[2], a[3] & b[3]}};
}
inline bool any(FourBits m) {
    return (m[0] | m[1] | m[2] | m[3]) != 0;
}
inline bool all(FourBits m) {
    return (m[0] & m[1] & m[2] & m[3]) == -1;
}
inline FourFloats smaller(FourFloats a, FourFloats b) {
    return {{a[0] < b[0] ? a[0] : b[0], a[1] < b[1] ? a[1] : b[1], a[2] < b[2] ? a[2] : b[2],
             a[3] < b[3] ? a[3] : b[3]}};
}
inline FourFloats larger(FourFloats a, FourFloats b) {
    return {{a[0] > b[0] ? a[0] : b[0], a[1] > b[1] ? a[1] : b[1], a[2] > b[2] ? a[2] : b[2],
             a[3] > b[3] ? a[3] : b[3]}};
}
inline FourBits truncated(FourFloats v) {
    return {{static_cast<std::int32_t>(v[0]), static_cast<std::int32_t>(v[1]),
             static_cast<std::int32_t>(v[2]), static_cast<std::int32_t>(v[3])}};
}
template <class T>
FourOf<T> choose(FourBits m, FourOf<T> yes, FourOf<T> no) {
    FourOf<T> r{};
    for (int i = 0; i < 4; ++i) {
        r[i] = m[i] != 0 ? yes[i] : no[i];
    }
    return r;
}
inline FourFloats four(float v) {
    return {{v, v, v, v}};
}
inline FourBits four(std::int32_t v) {
    return {{v, v, v, v}};
}

#endif

}  // namespace tiller
